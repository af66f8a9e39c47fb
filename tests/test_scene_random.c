/* SPDX-License-Identifier: MIT */
/*
 * Random scenes through the fixed-point pipeline and the reference: the error budget of the README.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "reference/reference.h"
#include "support/scene_random.h"
#include "support/accuracy.h"
#include "tools/scene_draw.h"

static unsigned scene_count(void)
{
    const char *count = getenv("QTRI_SCENES");
    return count != NULL ? (unsigned)strtoul(count, NULL, 10) : 200;
}

static unsigned first_seed(void)
{
    const char *seed = getenv("QTRI_SEED");
    return seed != NULL ? (unsigned)strtoul(seed, NULL, 10) : 1;
}

/*
 * Half of the checkerboards become noise of four colours, two of them the board's, and a quarter
 * gradients, where the format holds as many colours.
 */
static void repaint(uint32_t seed, struct scene *scene)
{
    const struct scene_texture *texture = &scene->texture;
    size_t width = (size_t)texture->width;
    size_t count = width * (size_t)texture->height;
    bool gradient = seed % 4 == 3 && !scene_texel_has_palette(scene->texel_format);
    if (count == 0 || seed % 2 == 0) {
        return;
    }
    uint8_t colors[4][3] = {{255, 255, 255}, {0, 40, 90}};
    memcpy(colors[2], &texture->rgb[0], 3);
    memcpy(colors[3], &texture->rgb[3 * (count - 1)], 3);
    uint32_t noise = seed;
    for (size_t i = 0; i < count; i++) {
        uint8_t *rgb = &texture->rgb[3 * i];
        noise = noise * 1664525u + 1013904223u; /* Numerical Recipes */
        if (gradient) {
            rgb[0] = (uint8_t)(i % width * 255 / width);
            rgb[1] = (uint8_t)(i * 255 / count);
            rgb[2] = (uint8_t)(255 - rgb[0]);
        } else {
            memcpy(rgb, colors[noise >> 30], 3);
        }
    }
}

static void read_scene(uint32_t seed, bool textured, struct scene *scene)
{
    size_t length = 0;
    struct text_error error;
    char *text = textured ? scene_random_textured(seed, &length) : scene_random(seed, &length);
    if (!scene_parse("random", text, length, scene, &error)) {
        fail_msg("seed %u: %s", seed, error.message);
    }
    free(text);
    if (textured) {
        repaint(seed, scene);
    }
}

static void compare(const struct scene *scene, const struct picture *picture, int subpixel_bits,
                    struct accuracy *sum)
{
    struct reference_image image;
    assert_true(reference_render(scene, subpixel_bits, &image));
    accuracy_add(sum, picture, &image, scene->texture.width != 0);
    reference_free(&image);
}

static void print(const char *name, const struct accuracy *a)
{
    print_message("%s: %llu covered; per 100k: coverage %.2f, other triangle %.2f, colour > 1 %.2f,"
                  " depth > 2 %.2f; out of range %llu, largest colour %d, depth %.2f\n",
                  name, (unsigned long long)a->covered, accuracy_per_100k(a->coverage, a->covered),
                  accuracy_per_100k(a->other_triangle, a->covered),
                  accuracy_per_100k(a->color_above_1, a->same),
                  accuracy_per_100k(a->depth_above_2, a->same), (unsigned long long)a->color_range,
                  a->max_color, a->max_depth);
}

static void measure(bool textured)
{
    struct accuracy snapped = {0};
    struct accuracy exact = {0};
    for (unsigned i = 0; i < scene_count(); i++) {
        struct scene scene;
        struct picture picture;
        struct accuracy before[2] = {snapped, exact};
        read_scene(first_seed() + i, textured, &scene);
        assert_true(scene_render(&scene, &qtri_xrgb8888, 0, true, &picture));
        compare(&scene, &picture, 8, &snapped);
        if (!scene.screen_linear) { /* means something else for triangles that are not cut */
            compare(&scene, &picture, 0, &exact);
        }
        if (getenv("QTRI_VERBOSE") != NULL) {
            print_message("seed %u: coverage %llu, other %llu, colour %llu, depth %llu; "
                          "unsnapped coverage %llu colour %llu\n",
                          first_seed() + i,
                          (unsigned long long)(snapped.coverage - before[0].coverage),
                          (unsigned long long)(snapped.other_triangle - before[0].other_triangle),
                          (unsigned long long)(snapped.color_above_1 - before[0].color_above_1),
                          (unsigned long long)(snapped.depth_above_2 - before[0].depth_above_2),
                          (unsigned long long)(exact.coverage - before[1].coverage),
                          (unsigned long long)(exact.color_above_1 - before[1].color_above_1));
        }
        picture_free(&picture);
        scene_free(&scene);
    }
    print("snapped to 8 bits", &snapped);
    print("infinite precision", &exact);

    assert_true(snapped.covered > 1000);
    /*
     * Coverage is that of snapped vertices, but where texels are holes: those are, as all
     * attributes, where the vertices truly are.
     */
    assert_true(accuracy_per_100k(snapped.coverage, snapped.covered) <= (textured ? 12.0 : 3.0));
    assert_true(accuracy_per_100k(snapped.other_triangle, snapped.covered) <= 5.0);
    assert_true(accuracy_per_100k(exact.coverage, exact.covered) <= 10.0);
    assert_true(accuracy_per_100k(exact.color_above_1, exact.same) <= (textured ? 20.0 : 3.0));
    assert_int_equal(snapped.color_range, 0);
    assert_true(snapped.max_depth <= 1000); /* what leaves the range does not come in again */
    assert_true(accuracy_per_100k(exact.depth_above_2, exact.same) <= 2.0);
}

TEST(error_budget)
{
    measure(false);
}

TEST(error_budget_of_textures)
{
    measure(true);
}

/*
 * Scenes of longer runs that once were wrong: triangles that reach behind the eye but only through
 * the far plane, vertices at infinity, texture coordinates cut at the guard band.
 */
TEST(found_before)
{
    static const uint32_t seeds[] = {1026, 2208, 2609, 2759, 3644, 3841, 3165};
    for (size_t i = 0; i < sizeof seeds / sizeof seeds[0]; i++) {
        struct scene scene;
        struct picture picture;
        struct accuracy sum = {0};
        read_scene(seeds[i], false, &scene);
        assert_true(scene_render(&scene, &qtri_xrgb8888, 0, true, &picture));
        compare(&scene, &picture, 8, &sum);
        assert_int_equal(sum.coverage, 0);
        assert_int_equal(sum.other_triangle, 0);
        assert_true(sum.color_above_1 <= 10); /* 3165 once had 34 */
        picture_free(&picture);
        scene_free(&scene);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
