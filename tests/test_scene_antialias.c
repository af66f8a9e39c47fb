/* SPDX-License-Identifier: MIT */
/*
 * Anti-aliased scenes: the same pixels in bands, and nearer to many samples than without.
 */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "reference/reference.h"
#include "support/bands.h"
#include "tools/scene_draw.h"

enum { WIDTH = 120, HEIGHT = 90, SIDE = 8, MODES = 6 };

static const char *const modes[MODES] = {"off", "edges", "ssaa", "fxaa", "temporal", "msaa"};

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

TEST(bands)
{
    const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    for (int mode = 0; mode < MODES; mode++) {
        struct scene scene = parse(modes[mode]);
        for (int f = 0; f < 3; f++) {
            assert_same_in_bands(&scene, formats[f], 9);
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

TEST(quality)
{
    find_truth();
    const double off = psnr_of("off");
    assert_true(psnr_of("edges") > off + 11);
    assert_true(psnr_of("ssaa") > off + 7);
    assert_true(psnr_of("fxaa") > off + 3);
    assert_true(psnr_of("temporal") > off + 13);
    assert_true(psnr_of("msaa") > off + 7);
}

/*
 * The reference looks at the same places. With its vertices on the core's grid the two differ by
 * roundings: of four samples and their mean, or of sixteen. Without, edges move by 1/256 pixel, and
 * now and then a sample is on their other side.
 */
TEST(places)
{
    static const struct {
        const char *mode;
        double least_snapped, least_exact; /* dB */
        int most_snapped;                  /* of 255 */
    } expected[] = {{"msaa", 55, 48, 1}, {"ssaa", 55, 48, 1}, {"temporal", 50, 50, 16}};
    for (int i = 0; i < 3; i++) {
        struct scene scene = parse(expected[i].mode);
        struct picture picture;
        assert_true(scene_render(&scene, &qtri_xrgb8888, 0, false, &picture));
        for (int bits = 0; bits <= 9; bits++) {
            /* Vertices of two by two samples lie on a grid of half the step. */
            const int own = strcmp(expected[i].mode, "ssaa") == 0 ? 9 : 8;
            struct reference_image image;
            double sum = 0;
            int most = 0;
            if (bits != 0 && bits != own) {
                continue;
            }
            assert_true(reference_render(&scene, bits, &image));
            for (int k = 0; k < WIDTH * HEIGHT * 3; k++) {
                const double error = fabs(picture.rgb[k] - image.color[k]);
                sum += error * error;
                most = (int)fmax(most, floor(error + .5));
            }
            const double psnr = 10 * log10(255. * 255. / (sum / (WIDTH * HEIGHT * 3)));
            print_message("%s, %d bits: %.1f dB, off by %d at most\n", expected[i].mode, bits, psnr,
                          most);
            assert_true(psnr >= (bits == 0 ? expected[i].least_exact : expected[i].least_snapped));
            assert_true(bits == 0 || most <= expected[i].most_snapped);
            reference_free(&image);
        }
        picture_free(&picture);
        scene_free(&scene);
    }
}

/* Depths and ids are those of pixel centres whatever becomes of colours. */
TEST(reference_dumps)
{
    struct scene off = parse("off");
    struct scene four = parse("msaa");
    struct reference_image a, b;
    assert_true(reference_render(&off, 8, &a));
    assert_true(reference_render(&four, 8, &b));
    assert_memory_equal(a.id, b.id, sizeof *a.id * WIDTH * HEIGHT);
    assert_memory_equal(a.depth, b.depth, sizeof *a.depth * WIDTH * HEIGHT);
    assert_memory_not_equal(a.color, b.color, sizeof *a.color * 3 * WIDTH * HEIGHT);
    reference_free(&a);
    reference_free(&b);
    scene_free(&off);
    scene_free(&four);
}

/* What is given in pixels has its size on a surface of 2x2 samples too. */
TEST(paint_has_its_size)
{
    static const char flat[] =
        "viewport 120 90\nantialias %s\nink .9 .5 .1\nrect 10 10 60 40\nink 0 .5 1 .5\n"
        "area 20 20 100 20 100 70 20 70\nfont host/fonts/small.bdf\ntext 12 80 Twice\nimage %s 70 "
        "5\nlinesmooth off\n"
        "linecap butt\nlinewidth 6\nline -.5 -.6 0 1 1 1 1  .5 -.6 0 1 1 1 1\n";
    static const char *const mode[] = {"off", "ssaa"};
    struct picture picture[2];
    char name[1024], filled[2048];
    struct text_error error;
    uint8_t rgb[8 * 6 * 3];
    struct picture image = {.width = 8, .height = 6, .rgb = rgb};
    for (int i = 0; i < (int)sizeof rgb; i++) {
        rgb[i] = (uint8_t)(i * 37);
    }
    const char *folder = getenv("QTRI_TMP");
    snprintf(name, sizeof name, "%s/paint-has-its-size.ppm", folder != NULL ? folder : ".");
    assert_true(picture_write_ppm(name, &image, &error));
    for (int i = 0; i < 2; i++) {
        struct scene scene;
        snprintf(filled, sizeof filled, flat, mode[i], name);
        assert_true(scene_parse("test.scene", filled, strlen(filled), &scene, &error));
        assert_true(scene_render(&scene, &qtri_xrgb8888, 0, false, &picture[i]));
        scene_free(&scene);
    }
    assert_memory_equal(picture[0].rgb, picture[1].rgb, (size_t)3 * WIDTH * HEIGHT);
    picture_free(&picture[0]);
    picture_free(&picture[1]);
    (void)remove(name);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
