/* SPDX-License-Identifier: MIT */
/*
 * Random scenes that mix lights, fog, blends, textures, lines, points and flat shapes, through the
 * fixed-point pipeline and the reference: colours within 1 of 255, and within 3/4 of a step of
 * RGB565, for each time that a pixel is stored.
 *
 * QTRI_SCENES=200 is the whole measure; QTRI_VERBOSE tells each scene.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "reference/reference.h"
#include "support/scene_random.h"
#include "support/accuracy.h"
#include "tools/scene_draw.h"

static unsigned number_of(const char *name, unsigned otherwise)
{
    const char *value = getenv(name);
    return value != NULL ? (unsigned)strtoul(value, NULL, 10) : otherwise;
}

static void read_scene(uint32_t seed, struct scene *scene)
{
    size_t length = 0;
    struct text_error error;
    char *text = scene_random_mixed(seed, &length);
    if (!scene_parse("random", text, length, scene, &error)) {
        fail_msg("seed %u: %s", seed, error.message);
    }
    free(text);
}

/* Pixels that add_mixed looked at, and of them. */
struct mixed {
    uint64_t pixels;
    uint64_t above;  /* those that are off by more than their roundings and edges allow */
    uint64_t either; /* those that may show either of two things: half a step and more */
    double most;     /* how many times that at most */
};

/* What smooth edges mixed there: they may reach a pixel further in one picture. */
static double edge_near(const struct reference_image *reference, size_t i)
{
    const int width = reference->width;
    const int x = (int)(i % (size_t)width);
    const int y = (int)(i / (size_t)width);
    double most = 0;
    for (int row = y - 1; row <= y + 1; row++) {
        for (int column = x - 1; column <= x + 1; column++) {
            if (row >= 0 && row < reference->height && column >= 0 && column < width) {
                most = fmax(most, reference->edge[(size_t)row * (size_t)width + (size_t)column]);
            }
        }
    }
    return most;
}

/* What a channel is, for vertices on the grid and where they truly are: from least to greatest. */
static void color_range(double range[2], const struct reference_image *snapped,
                        const struct reference_image *unsnapped, size_t i, size_t c, int steps)
{
    const bool same = snapped->id[i] == unsnapped->id[i] && snapped->hits[i] == unsnapped->hits[i];
    const double first = snapped->color[3 * i + c] * steps / 255;
    const double second = same ? unsnapped->color[3 * i + c] * steps / 255 : first;
    range[0] = fmin(first, second);
    range[1] = fmax(first, second);
    for (int k = 0; k < 2 && steps == 255; k++) {
        range[k] = floor(range[k] + .5);
    }
}

/* How many times what its roundings, edges and decisions allow a pixel is off. */
static double mixed_error(const struct picture *picture, const struct reference_image *snapped,
                          const struct reference_image *unsnapped, size_t i, const int steps[3],
                          double step)
{
    const double moved = snapped->either[i] + edge_near(snapped, i) / 32;
    double worst = 0;
    for (size_t c = 0; c < 3; c++) {
        double range[2];
        color_range(range, snapped, unsnapped, i, c, steps[c]);
        const double got = floor(picture->rgb[3 * i + c] * steps[c] / 255.0 + .5);
        const double off = fmax(0, fmax(range[0] - got, got - range[1]));
        worst = fmax(worst, off / (step * snapped->rounding[i] + moved * steps[c] / 255));
    }
    return worst;
}

/*
 * Adds pixels of which both show the same triangle: a channel may be off by `step` of its steps,
 * `steps` of which are 255, for each rounding that adds up, by 1/32 of what smooth edges mixed, and
 * by all of what was decided where it may fall either way (reference.h). Off what the reference has
 * for vertices on the core's grid, for true ones, or between: the core covers the former's pixels
 * with the latter's texels.
 */
static void add_mixed(struct mixed *sum, const struct picture *picture,
                      const struct reference_image *snapped,
                      const struct reference_image *unsnapped, const int steps[3], double step)
{
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < pixels; i++) {
        if (picture->id[i] != snapped->id[i]) {
            continue;
        }
        const double error = mixed_error(picture, snapped, unsnapped, i, steps, step);
        sum->pixels++;
        sum->either += snapped->either[i] > step * 255 / steps[0] / 2;
        sum->above += error > 1;
        sum->most = fmax(sum->most, error);
    }
}

struct kind {
    const char *name;
    const qtri_format *format;
    int steps[3];
    double step;
    struct accuracy sum;
    struct mixed mixed;
};

static void add(struct kind *kind, const struct scene *scene, const struct reference_image image[2],
                uint32_t seed)
{
    struct picture picture;
    const struct accuracy before = kind->sum;
    const uint64_t above = kind->mixed.above;
    assert_true(scene_render(scene, kind->format, 0, true, &picture));
    accuracy_add(&kind->sum, &picture, &image[0], true);
    add_mixed(&kind->mixed, &picture, &image[0], &image[1], kind->steps, kind->step);
    if (getenv("QTRI_VERBOSE") != NULL) {
        print_message("seed %u, %s: coverage %llu, other %llu, mixed above %llu\n", seed,
                      kind->name, (unsigned long long)(kind->sum.coverage - before.coverage),
                      (unsigned long long)(kind->sum.other_triangle - before.other_triangle),
                      (unsigned long long)(kind->mixed.above - above));
    }
    picture_free(&picture);
}

TEST(mixtures)
{
    struct kind kinds[3] = {{"XRGB8888", &qtri_xrgb8888, {255, 255, 255}, 1, {0}, {0}},
                            {"RGB565", &qtri_rgb565, {31, 63, 31}, .75, {0}, {0}},
                            {"RGB565, exact", &qtri_rgb565_exact, {31, 63, 31}, .75, {0}, {0}}};
    const unsigned first = number_of("QTRI_SEED", 1);
    const unsigned count = number_of("QTRI_SCENES", 25);
    for (unsigned seed = first; seed < first + count; seed++) {
        struct scene scene;
        struct reference_image image[2]; /* vertices on the core's grid, and true ones */
        read_scene(seed, &scene);
        assert_true(reference_render(&scene, 8, &image[0]));
        assert_true(reference_render(&scene, 0, &image[1]));
        add(&kinds[0], &scene, image, seed);
        add(&kinds[1], &scene, image, seed);
        add(&kinds[2], &scene, image, seed);
        reference_free(&image[0]);
        reference_free(&image[1]);
        scene_free(&scene);
    }
    for (int i = 0; i < 3; i++) {
        const struct accuracy *a = &kinds[i].sum;
        const struct mixed *m = &kinds[i].mixed;
        print_message("%s: %llu pixels; per 100k: coverage %.2f, other triangle %.2f, either "
                      "of two %.2f, beyond what roundings allow %.2f; at most %.2f times that\n",
                      kinds[i].name, (unsigned long long)m->pixels,
                      accuracy_per_100k(a->coverage, a->covered),
                      accuracy_per_100k(a->other_triangle, a->covered),
                      accuracy_per_100k(m->either, m->pixels),
                      accuracy_per_100k(m->above, m->pixels), m->most);
        assert_true(m->pixels > 1000);
        assert_true(accuracy_per_100k(a->coverage, a->covered) <= 40);
        assert_true(accuracy_per_100k(a->other_triangle, a->covered) <= 20);
        assert_true(accuracy_per_100k(m->either, m->pixels) <= 500);
        assert_true(m->most <= 5); /* roundings of light or texels: nothing is wrong */
    }
    assert_true(accuracy_per_100k(kinds[0].mixed.above, kinds[0].mixed.pixels) <= 20);
    assert_true(accuracy_per_100k(kinds[1].mixed.above, kinds[1].mixed.pixels) <= 50);
    assert_true(accuracy_per_100k(kinds[2].mixed.above, kinds[2].mixed.pixels) <= 10);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
