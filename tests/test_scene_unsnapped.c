/* SPDX-License-Identifier: MIT */
/*
 * Attributes go through the places where vertices truly are, not through those that coverage snaps
 * them to: measured against the double-precision reference without any snapping. QTRI_FLOORS: how
 * many floors of each kind.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "reference/reference.h"
#include "support/accuracy.h"
#include "tools/scene_draw.h"

enum { TEXT_MAX = 4096 };

typedef struct floors {
    int texels, fields; /* a side; a field of the checkerboard is not a texel */
    double repeats;
    double far;  /* distances: the farthest, in those of the nearest */
    double roll; /* degrees */
    double most; /* wrong pixels of 100,000 */
} floors;

static double random_between(uint32_t *state, double low, double high)
{
    *state = *state * 1664525u + 1013904223u; /* Numerical Recipes */
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

static void measure(struct accuracy *sum, const char *text)
{
    struct scene scene;
    struct picture picture;
    struct reference_image image;
    struct text_error error;
    if (!scene_parse("floor", text, strlen(text), &scene, &error)) {
        fail_msg("%s", error.message);
    }
    assert_true(scene_render(&scene, &qtri_xrgb8888, 0, true, &picture));
    assert_true(reference_render(&scene, 0, &image));
    accuracy_add(sum, &picture, &image, true);
    reference_free(&image);
    picture_free(&picture);
    scene_free(&scene);
}

/* A floor below an eye that is turned; some are cut at the near plane. */
static void write_floor(char text[TEXT_MAX], const floors *f, uint32_t *state)
{
    const double turn = random_between(state, -30, 30);
    const double near = random_between(state, 1.2, 1.6);
    const double half = random_between(state, 12, 16);
    static const int corner[6] = {0, 1, 2, 0, 2, 3};
    int length = snprintf(text, TEXT_MAX,
                          "viewport 320 240\nclear 0 0 0\ndepth less\n"
                          "texture %d %d %d  255 255 255  0 0 0\n"
                          "mode projection\nperspective 60 1.33333333 .1 400\nmode modelview\n"
                          "rotate %.4f 0 0 1\nrotate %.4f 0 1 0\ntranslate 0 -1 0\n",
                          f->texels, f->texels, f->fields, f->roll, turn);
    for (int i = 0; i < 6; i++) {
        const bool right = corner[i] == 1 || corner[i] == 2;
        const bool far = corner[i] >= 2;
        length += snprintf(text + length, (size_t)(TEXT_MAX - length),
                           "%s %.4f 0 %.4f 1 1 1 1 %.4f %.4f%s", i % 3 == 0 ? "trit" : "",
                           right ? half : -half, far ? -near * f->far : -near,
                           right ? f->repeats : 0, far ? f->repeats : 0, i % 3 == 2 ? "\n" : "");
    }
}

TEST(checkered_floors)
{
    static const floors kinds[] = {
        {64, 8, 16, 10, 0, 3},        {64, 8, 16, 60, 0, 5},          {64, 8, 16, 60, 10, 10},
        {64, 64, 16, 60, 0, 15},      {64, 64, 16, 60, 10, 60},       {256, 32, 64, 10, 0, 5},
        {256, 32, 64, 60, 0, 10},     {256, 32, 64, 60, 10, 40},      {256, 256, 64, 60, 0, 80},
        {1024, 128, 400, 60, 0, 150}, {1024, 1024, 400, 60, 0, 1200},
    };
    const char *more = getenv("QTRI_FLOORS");
    const int count = more != NULL ? atoi(more) : 4;
    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        const floors *f = &kinds[k];
        struct accuracy sum = {0};
        uint32_t random = 5;
        for (int i = 0; i < count; i++) {
            char text[TEXT_MAX];
            write_floor(text, f, &random);
            measure(&sum, text);
        }
        const double wrong = accuracy_per_100k(sum.color_above_1, sum.covered);
        print_message("%d texels in %d fields, %.0f repeats, to %.0f, rolled %.0f: %.2f of 100k, "
                      "depth within %.2f\n",
                      f->texels, f->fields, f->repeats, f->far, f->roll, wrong, sum.max_depth);
        assert_true(sum.covered > 50000);
        assert_true(wrong <= f->most);
        assert_true(sum.max_depth <= 1);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
