/* SPDX-License-Identifier: MIT */
/*
 * A floor whose texture has levels: the core against the reference, each with its own choice of
 * levels, and both against many samples a pixel while the camera moves.
 */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/mipmap.h"
#include "reference/reference.h"
#include "tools/scene_draw.h"

enum { WIDTH = 128, HEIGHT = 96, SIDE = 8, HORIZON = 39, FAR_ROWS = 14 };

/* The eye, the filter, and more of the texture. */
static const char text[] =
    "viewport 128 96\nclear .1 .12 .2\ndepth less\ntexmode replace\n"
    "texture 64 64 8  240 240 230  60 90 140\ntexfilter %s\n%s"
    "mode projection\ntranslate 0 0 0\nperspective 60 1.33333333 .1 100\nmode modelview\n"
    "lookat %.3f 1 %.3f  0 .6 -3  0 1 0\n"
    "trit -20 0 20 1 1 1 1 -10 10  20 0 20 1 1 1 1 10 10  20 0 -40 1 1 1 1 10 -20\n"
    "trit -20 0 20 1 1 1 1 -10 10  20 0 -40 1 1 1 1 10 -20  -20 0 -40 1 1 1 1 -10 -20\n";

static struct scene parse(const char *filter, const char *more, double x, double z)
{
    char filled[2048];
    struct scene scene;
    struct text_error error;
    snprintf(filled, sizeof filled, text, filter, more, x, z);
    assert_true(scene_parse("test.scene", filled, strlen(filled), &scene, &error));
    return scene;
}

/* ---- Against the reference ---- */

/* As if the whole texture were a level of it. */
static struct reference_image render_level(const struct scene *scene, int level)
{
    struct reference_image image;
    struct scene other = *scene;
    if (level > 0) {
        other.texture.rgb = scene->texture.level[level - 1];
        other.texture.width = mipmap_side(scene->texture.width, level);
        other.texture.height = mipmap_side(scene->texture.height, level);
    }
    other.texture_mipmapped = false;
    assert_true(reference_render(&other, 0, &image));
    return image;
}

/* Whether the level may be that of a block with pixel x in it: of a footprint nearby in its row. */
static bool may_be(const struct reference_image *image, int i, int level, int last)
{
    for (int x = -64; x <= 64; x++) {
        if (i % WIDTH + x < 0 || i % WIDTH + x >= WIDTH || image->id[i + x] != image->id[i]) {
            continue;
        }
        const double log2_of = log2(image->footprint[i + x]);
        if ((level == 0 || log2_of > level - 0.53) && (level == last || log2_of < level + 0.53)) {
            return true;
        }
    }
    return false;
}

static double distance(const uint8_t *rgb, const double *color)
{
    double most = 0;
    for (int c = 0; c < 3; c++) {
        most = fmax(most, fabs(rgb[c] - color[c]));
    }
    return most;
}

/* Pixels of the core that are of no level that they may be of. */
static int count_wrong(const struct scene *scene, int *pixels, int *others)
{
    struct reference_image exact, level[SCENE_MAX_LEVELS + 1];
    struct picture picture;
    const int last = scene->texture.level_count;
    int wrong = 0;
    assert_true(reference_render(scene, 0, &exact));
    assert_true(scene_render(scene, &qtri_xrgb8888, 0, false, &picture));
    for (int k = 0; k <= last; k++) {
        level[k] = render_level(scene, k);
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double least = HUGE_VAL;
        for (int k = 0; k <= last && exact.id[i] != 0; k++) {
            if (may_be(&exact, i, k, last)) {
                least = fmin(least, distance(&picture.rgb[3 * i], &level[k].color[3 * i]));
            }
        }
        *pixels += exact.id[i] != 0;
        *others += exact.id[i] != 0 && distance(&picture.rgb[3 * i], &exact.color[3 * i]) > 1.5;
        wrong += exact.id[i] != 0 && least > 2;
    }
    for (int k = 0; k <= last; k++) {
        reference_free(&level[k]);
    }
    reference_free(&exact);
    picture_free(&picture);
    return wrong;
}

TEST(test_reference)
{
    static const char *const more[] = {"", "texformat rgb565\n", "texformat gray8\n",
                                       "texformat palette\ntexkey 60 90 140\n",

                                       "texwrap clamp repeat\n"};
    for (size_t i = 0; i < sizeof more / sizeof more[0]; i++) {
        int pixels = 0, others = 0, wrong = 0;
        for (int k = 0; k < 2; k++) {
            struct scene scene =
                parse(k == 0 ? "nearest mipmaps" : "bilinear mipmaps", more[i], .1, .05);
            assert_int_equal(scene.texture.level_count, 5);
            wrong += count_wrong(&scene, &pixels, &others);
            scene_free(&scene);
        }
        print_message("%d pixels, %d of another level or texel, %d wrong\n", pixels, others, wrong);
        assert_true(wrong <= pixels / 1000);
        assert_true(others <= pixels / 20);
    }
}

/* ---- Against many samples, while the camera moves ---- */

static double to_linear(double value)
{
    value /= 255;
    return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

static double from_linear(double value)
{
    return 255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - 0.055);
}

static const int first_value = 3 * WIDTH * HORIZON, value_count = 3 * WIDTH * FAR_ROWS;

/* The mean of 64 samples in linear light, of the rows below the horizon. */
static void find_truth(double x, double z, double *truth)
{
    struct scene scene = parse("nearest", "", x, z);
    size_t move = 0;
    while (scene.ops[move].kind != SCENE_TRANSLATE) {
        move++;
    }
    memset(truth, 0, (size_t)value_count * sizeof *truth);
    for (int i = 0; i < SIDE * SIDE; i++) {
        struct reference_image image;
        int32_t *to = scene.ops[move].u.number;
        to[0] = (int32_t)lrint(2 * ((i % SIDE + .5) / SIDE - .5) / WIDTH * 65536);
        to[1] = (int32_t)lrint(2 * ((i / SIDE + .5) / SIDE - .5) / HEIGHT * 65536);
        assert_true(reference_render(&scene, 0, &image));
        for (int k = 0; k < value_count; k++) {
            truth[k] += to_linear(image.color[first_value + k]) / (SIDE * SIDE);
        }
        reference_free(&image);
    }
    for (int k = 0; k < value_count; k++) {
        truth[k] = from_linear(truth[k]);
    }
    scene_free(&scene);
}

static void far_rows(const char *filter, double x, double z, double *rows)
{
    struct scene scene = parse(filter, "", x, z);
    struct picture picture;
    assert_true(scene_render(&scene, &qtri_xrgb8888, 0, false, &picture));
    for (int k = 0; k < value_count; k++) {
        rows[k] = picture.rgb[first_value + k];
    }
    picture_free(&picture);
    scene_free(&scene);
}

static double psnr(const double *a, const double *b)
{
    double sum = 0;
    for (int k = 0; k < value_count; k++) {
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return 10 * log10(255 * 255 * value_count / sum);
}

/* What changes from one picture to the next that should not: less what the truth changes. */
static double crawl(const double *now, const double *then, const double *truth,
                    const double *truth_then)
{
    double sum = 0;
    for (int k = 0; k < value_count; k++) {
        sum += fabs((now[k] - then[k]) - (truth[k] - truth_then[k])) / value_count;
    }
    return sum;
}

TEST(test_moving)
{
    static const char *const filters[4] = {"nearest", "nearest mipmaps", "bilinear",
                                           "bilinear mipmaps"};
    static double truth[2][3 * WIDTH * FAR_ROWS], rows[4][2][3 * WIDTH * FAR_ROWS];
    double quality[4], moves[4];
    for (int k = 0; k < 2; k++) { /* three hundredths to the right, and one back */
        find_truth(.03 * k, .01 * k, truth[k]);
        for (int f = 0; f < 4; f++) {
            far_rows(filters[f], .03 * k, .01 * k, rows[f][k]);
        }
    }
    for (int f = 0; f < 4; f++) {
        quality[f] = fmin(psnr(rows[f][0], truth[0]), psnr(rows[f][1], truth[1]));
        moves[f] = crawl(rows[f][1], rows[f][0], truth[1], truth[0]);
        print_message("%s: %.2f dB, crawls by %.2f of 255\n", filters[f], quality[f], moves[f]);
    }
    for (int f = 0; f < 4; f += 2) {
        assert_true(quality[f + 1] > quality[f] + 6);
        assert_true(moves[f + 1] < moves[f] / 3);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
