/* SPDX-License-Identifier: MIT */
/*
 * Random scenes that mix lights, fog, blends, textures, lines, points and flat shapes, through the
 * fixed-point pipeline and the reference: colours within 1 of 255, and within 3/4 of a step of
 * RGB565, for each time that a pixel is stored.
 *
 * QTRI_SCENES=200 is the whole measure; QTRI_VERBOSE tells each scene.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reference/reference.h"
#include "support/scene_random.h"
#include "tools/accuracy.h"
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

struct kind {
    const char *name;
    const qtri_format *format;
    int steps[3];
    double step;
    struct accuracy sum;
};

static void add(struct kind *kind, const struct scene *scene, const struct reference_image image[2],
                uint32_t seed)
{
    struct picture picture;
    const struct accuracy before = kind->sum;
    assert_true(scene_render(scene, kind->format, 0, true, &picture));
    accuracy_add(&kind->sum, &picture, &image[0], true);
    accuracy_add_mixed(&kind->sum, &picture, &image[0], &image[1], kind->steps, kind->step);
    if (getenv("QTRI_VERBOSE") != NULL) {
        print_message("seed %u, %s: coverage %llu, other %llu, mixed above %llu\n", seed,
                      kind->name, (unsigned long long)(kind->sum.coverage - before.coverage),
                      (unsigned long long)(kind->sum.other_triangle - before.other_triangle),
                      (unsigned long long)(kind->sum.mixed_above - before.mixed_above));
    }
    picture_free(&picture);
}

static void mixtures(void **state)
{
    (void)state;
    struct kind kinds[3] = {{"XRGB8888", &qtri_xrgb8888, {255, 255, 255}, 1, {0}},
                            {"RGB565", &qtri_rgb565, {31, 63, 31}, .75, {0}},
                            {"RGB565, exact", &qtri_rgb565_exact, {31, 63, 31}, .75, {0}}};
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
        print_message("%s: %llu pixels; per 100k: coverage %.2f, other triangle %.2f, either "
                      "of two %.2f, beyond what roundings allow %.2f; at most %.2f times that\n",
                      kinds[i].name, (unsigned long long)a->mixed,
                      accuracy_per_100k(a->coverage, a->covered),
                      accuracy_per_100k(a->other_triangle, a->covered),
                      accuracy_per_100k(a->mixed_either, a->mixed),
                      accuracy_per_100k(a->mixed_above, a->mixed), a->max_mixed);
        assert_true(a->mixed > 1000);
        assert_true(accuracy_per_100k(a->coverage, a->covered) <= 40);
        assert_true(accuracy_per_100k(a->other_triangle, a->covered) <= 20);
        assert_true(accuracy_per_100k(a->mixed_either, a->mixed) <= 500);
        assert_true(a->max_mixed <= 5); /* roundings of light or texels: nothing is wrong */
    }
    assert_true(accuracy_per_100k(kinds[0].sum.mixed_above, kinds[0].sum.mixed) <= 20);
    assert_true(accuracy_per_100k(kinds[1].sum.mixed_above, kinds[1].sum.mixed) <= 50);
    assert_true(accuracy_per_100k(kinds[2].sum.mixed_above, kinds[2].sum.mixed) <= 10);
}

/* The picture in bands, and one of any format, is that of the whole frame. */
static void bands(void **state)
{
    (void)state;
    static const qtri_format *const formats[4] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8,
                                                  &qtri_rgb565_swapped};
    for (unsigned i = 0; i < 16; i++) {
        struct scene scene;
        struct picture whole;
        struct picture banded;
        read_scene(900 + i, &scene);
        assert_true(scene_render(&scene, formats[i % 4], 0, false, &whole));
        assert_true(
            scene_render(&scene, formats[i % 4], 1 + (int32_t)(i * 7 % 30), false, &banded));
        assert_memory_equal(whole.rgb, banded.rgb, 3 * (size_t)whole.width * (size_t)whole.height);
        picture_free(&whole);
        picture_free(&banded);
        scene_free(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(mixtures), cmocka_unit_test(bands)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
