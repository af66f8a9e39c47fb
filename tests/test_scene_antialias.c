/* SPDX-License-Identifier: MIT */
/*
 * Anti-aliased scenes: the same pixels in bands, and nearer to many samples than without.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "reference/reference.h"
#include "tools/scene_draw.h"

enum { WIDTH = 120, HEIGHT = 90, SIDE = 8, MODES = 5 };

static const char *const modes[MODES] = {"off", "edges", "ssaa", "fxaa", "temporal"};

static const char text[] =
    "viewport 120 90\nclear .1 .1 .2\ndepth less\nshade flat\nantialias %s\nmode projection\n"
    "translate 0 0 0\nperspective 60 1.33333333 .1 50\nmode modelview\n"
    "lookat 0 0 3  0 0 0  0 1 0\n"
    "tri -1.9 -1.2 0 1 1 .6 .2  .6 -1.4 0 1 1 .6 .2  -.7 1.4 0 1 1 .6 .2\n"
    "push\nrotate 10 0 0 1\n"
    "tri -.4 -.9 -.3 1 .3 .7 1  1.9 -.7 -.3 1 .3 .7 1  1.2 1.3 -.3 1 .3 .7 1\n"
    "tri -.4 -.9 -.3 1 .3 .7 1  1.2 1.3 -.3 1 .3 .7 1  -1.5 .9 -.3 1 .3 .7 1\n"
    "tri 0 0 -.5 2 1 1 1  1 0 -.5 2 1 1 1  0 1 -.5 2 1 1 1\npop\n";

static struct scene parse(const char *mode)
{
    char filled[2048];
    struct scene scene;
    struct text_error error;
    snprintf(filled, sizeof filled, text, mode);
    assert_true(scene_parse("test.scene", filled, strlen(filled), &scene, &error));
    return scene;
}

static void bands(void **state)
{
    (void)state;
    const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    for (int mode = 0; mode < MODES; mode++) {
        struct scene scene = parse(modes[mode]);
        for (int f = 0; f < 3; f++) {
            struct picture whole, banded;
            assert_true(scene_render(&scene, formats[f], 0, false, &whole));
            for (int32_t rows = 1; rows < 100; rows += 9) {
                assert_true(scene_render(&scene, formats[f], rows, false, &banded));
                assert_memory_equal(whole.rgb, banded.rgb, (size_t)3 * WIDTH * HEIGHT);
                picture_free(&banded);
            }
            picture_free(&whole);
        }
        scene_free(&scene);
    }
}

static double truth[WIDTH * HEIGHT * 3];

static void find_truth(void)
{
    struct scene scene = parse("off");
    size_t move = 0;
    while (scene.ops[move].kind != SCENE_TRANSLATE) {
        move++;
    }
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct reference_image image;
        int32_t *to = scene.ops[move].u.number;
        to[0] = (int32_t)lrint(2 * ((i % SIDE + .5) / SIDE - .5) / WIDTH * 65536);
        to[1] = (int32_t)lrint(2 * ((i / SIDE + .5) / SIDE - .5) / HEIGHT * 65536);
        assert_true(reference_render(&scene, 0, &image));
        for (int k = 0; k < WIDTH * HEIGHT * 3; k++) {
            truth[k] += image.color[k] / (SIDE * SIDE);
        }
        reference_free(&image);
    }
    scene_free(&scene);
}

static double psnr_of(const char *mode)
{
    struct scene scene = parse(mode);
    struct picture picture;
    double sum = 0;
    assert_true(scene_render(&scene, &qtri_xrgb8888, 0, false, &picture));
    for (int k = 0; k < WIDTH * HEIGHT * 3; k++) {
        sum += (picture.rgb[k] - truth[k]) * (picture.rgb[k] - truth[k]);
    }
    picture_free(&picture);
    scene_free(&scene);
    return 10 * log10(255. * 255. / (sum / (WIDTH * HEIGHT * 3)));
}

static void quality(void **state)
{
    (void)state;
    find_truth();
    const double off = psnr_of("off");
    assert_true(psnr_of("edges") > off + 11);
    assert_true(psnr_of("ssaa") > off + 7);
    assert_true(psnr_of("fxaa") > off + 3);
    assert_true(psnr_of("temporal") > off + 13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bands),
        cmocka_unit_test(quality),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
