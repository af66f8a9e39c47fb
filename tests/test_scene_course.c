/* SPDX-License-Identifier: MIT */
/*
 * The scenes of the course through the fixed-point core, and the facts they must show.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "support/test.h"
#include "reference/reference.h"
#include "support/accuracy.h"
#include "tools/scene_draw.h"

static void render_at(const char *name, double time, struct scene *scene, struct picture *picture)
{
    const struct scene_reading how = {.time = time};
    char path[256];
    struct text_error error;
    snprintf(path, sizeof path, "host/scenes/%s.scene", name);
    if (!scene_read_as(path, &how, scene, &error)) {
        fail_msg("%s", error.message);
    }
    assert_true(scene_render(scene, &qtri_xrgb8888, 0, true, picture));
}

static void render(const char *name, struct scene *scene, struct picture *picture)
{
    render_at(name, 0, scene, picture);
}

static void release(struct scene *scene, struct picture *picture)
{
    picture_free(picture);
    scene_free(scene);
}

static size_t at(const struct picture *picture, int x, int y)
{
    return (size_t)y * (size_t)picture->width + (size_t)x;
}

static size_t covered(const struct picture *picture)
{
    size_t count = 0;
    for (size_t i = 0; i < (size_t)picture->width * (size_t)picture->height; i++) {
        count += picture->id[i] != 0;
    }
    return count;
}

static void assert_row(const struct picture *picture, int y, int first, int last)
{
    for (int x = 0; x < picture->width; x++) {
        assert_int_equal(picture->id[at(picture, x, y)] != 0, x >= first && x <= last);
    }
}

static void assert_near(int value, int expected, int tolerance)
{
    assert_in_range(value, expected - tolerance, expected + tolerance);
}

/* Positions, depths: test_core_project. */
TEST(colour_triangle)
{
    static const struct {
        int x, y, perspective[3], linear[3];
        double depth;
    } samples[] = {
        {128, 60, {223, 15, 17}, {233, 10, 12}, .974972831},
        {128, 90, {104, 75, 76}, {129, 62, 63}, .968138666},
        {100, 100, {72, 128, 55}, {95, 112, 48}, .965860611},
        {150, 100, {72, 62, 121}, {95, 54, 106}, .965860611},
        {60, 120, {18, 199, 38}, {26, 192, 37}, .961304501},
        {200, 120, {18, 32, 205}, {26, 31, 198}, .961304501},
        {225, 126, {3, 13, 239}, {5, 13, 237}, .959937668},
        {110, 75, {158, 75, 22}, {181, 57, 17}, .971555749},
    };
    static const char *const names[2] = {"03-colour-triangle", "03-colour-triangle-linear"};
    for (int linear = 0; linear < 2; linear++) {
        struct scene scene;
        struct picture picture;
        render(names[linear], &scene, &picture);
        assert_int_equal(covered(&picture), 8214);
        assert_row(&picture, 54, 127, 128);
        assert_row(&picture, 90, 73, 182);
        assert_row(&picture, 127, 18, 237);
        for (size_t i = 0; i < sizeof samples / sizeof samples[0]; i++) {
            size_t pixel = at(&picture, samples[i].x, samples[i].y);
            const int *expected = linear ? samples[i].linear : samples[i].perspective;
            for (int channel = 0; channel < 3; channel++) {
                /* one sample is an exact tie: 127 or 128 */
                assert_near(picture.rgb[3 * pixel + (size_t)channel], expected[channel], 1);
            }
            double error = (picture.depth[pixel] - samples[i].depth) * 65535;
            assert_true(error > -2 && error < 2);
        }
        release(&scene, &picture);
    }
}

TEST(overlapping)
{
    struct scene scene;
    struct picture picture;
    render("05-overlapping", &scene, &picture);
    size_t pixel = at(&picture, 350, 200); /* inside both, at different depths */
    assert_int_equal(picture.id[pixel], 1);
    assert_int_equal(picture.rgb[3 * pixel], 217);
    assert_int_equal(picture.rgb[3 * pixel + 1], 238);
    assert_int_equal(picture.rgb[3 * pixel + 2], 185);
    release(&scene, &picture);
}

TEST(animation_ends_edge_on)
{
    struct scene scene;
    struct picture picture;
    render_at("06-animation", .75, &scene, &picture);
    assert_true(covered(&picture) > 1000);
    release(&scene, &picture);
    render_at("06-animation", 1, &scene, &picture);
    assert_int_equal(covered(&picture), 0);
    release(&scene, &picture);
}

/* Every scene: not a pixel differs from exact arithmetic on the same grid. */
TEST(equal_to_reference)
{
    static const struct {
        const char *name;
        double time;
    } scenes[] = {
        {"02-line-triangle", 0},
        {"02-line-triangle-about-z", 0},
        {"02-line-triangle-about-axis", 0},
        {"03-colour-triangle", 0},
        {"03-colour-triangle-linear", 0},
        {"04-own-normal-45", 0},
        {"04-own-normal-90", 0},
        {"04-own-normal-135", 0},
        {"04-own-normal-180", 0},
        {"05-crossing", 0},
        {"05-overlapping", 0},
        {"06-animation", 0},
        {"06-animation", .25},
        {"06-animation", .50},
        {"06-animation", .75},
        {"06-animation", 1},
        {"09-floor", 0},
        {"09-texture-affine", 0},
        {"09-texture-perspective", 0},
        {"10-texture-bilinear", 0},
        {"10-texture-clamp", 0},
        {"10-texture-key", 0},
        {"10-texture-nearest", 0},
    };
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        struct scene scene;
        struct picture picture;
        struct reference_image reference;
        struct accuracy sum = {0};
        render_at(scenes[i].name, scenes[i].time, &scene, &picture);
        assert_true(reference_render(&scene, 8, &reference));
        accuracy_add(&sum, &picture, &reference, scene.texture.width != 0);
        print_message("%s: %zu pixels, %llu off by more than 1, depth %.2f\n", scenes[i].name,
                      covered(&picture), (unsigned long long)sum.color_above_1, sum.max_depth);
        assert_int_equal(sum.coverage, 0);
        assert_int_equal(sum.other_triangle, 0);
        assert_int_equal(sum.color_range, 0);
        /*
         * Colours are right; what remains is texels. The floor is cut at the guard band, where the
         * reference has none: 1/512 pixel out there moves a few pixels at the horizon, where fields
         * are as small as pixels, to the next texel.
         */
        bool textured = scene.texture.width != 0;
        assert_true(accuracy_per_100k(sum.color_above_1, sum.same) <= (textured ? 60 : 0));
        assert_true(sum.max_depth <= 2);
        reference_free(&reference);
        release(&scene, &picture);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
