/* SPDX-License-Identifier: MIT */
/*
 * Light by pixel (&qtri_per_pixel): against the double-precision renderer, which lights every
 * pixel.
 */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "reference/reference.h"
#include "tools/scene_draw.h"

enum { WIDTH = 160, HEIGHT = 120 };

#define BEGIN                                                                                      \
    "viewport 160 120\nclear .1 .1 .2\ndepth less\nshade %s\nmode projection\n"                    \
    "perspective 60 1.33333333 .1 50\nmode modelview\nlookat 0 .6 2.6  0 -.3 -1  0 1 0\n"
#define SHINING "ambient .1 .1 .15\nmaterial specular .6 .6 .6 40\n"
#define DULL    "ambient .1 .1 .15\n"
#define POINT   "light point .7 -.8 -2.5  1 .9 .7  .4 0 1.5\n"
#define SPOT    "light spot -.8 .3 .6  .05 -.02 -1  8 30  .4 .6 1.4\n"
#define SUN     "light directional .4 .6 .7 .5 .5 .4\n"
#define FLOOR                                                                                      \
    "tri -2 -1 1 1 .8 .8 .8   2 -1 1 1 .8 .8 .8   2 -1 -2 1 .8 .8 .8\n"                            \
    "tri -2 -1 1 1 .8 .8 .8   2 -1 -2 1 .8 .8 .8  -2 -1 -2 1 .8 .8 .8\n"
#define WALL                                                                                       \
    "tri -2 -1 -2 1 .4 .6 1   2 -1 -2 1 .4 .6 1   2 1.2 -2 1 1 .6 .4\n"                            \
    "tri -2 -1 -2 1 .4 .6 1   2 1.2 -2 1 1 .6 .4  -2 1.2 -2 1 1 .6 .4\n"
/* From behind the eye on: clipped. */
#define ENDLESS                                                                                    \
    "tri -9 -1 9 1 .8 .7 .6   9 -1 9 1 .8 .7 .6   9 -1 -30 1 .8 .7 .6\n"                           \
    "tri -9 -1 9 1 .8 .7 .6   9 -1 -30 1 .8 .7 .6  -9 -1 -30 1 .8 .7 .6\n"
#define ROUND                                                                                      \
    "trin -.9 -1 -1.2 1 1 .8 .3 -.8 -.4 .4   .6 -1 -1.2 1 1 .8 .3 .8 -.4 .4  "                     \
    " 0 .6 -1.4 1 1 .8 .3 0 1 .3\n"
#define TEXTURED                                                                                   \
    "texture 8 8 4  255 255 255  90 160 255\n"                                                     \
    "tritn -2 -1 1 1 1 1 1 0 0 0 1 .2   2 -1 1 1 1 1 1 3 0 .3 1 0   2 -1 -2 1 1 1 1 3 3 0 1 0\n"

/* Floors seen from below, by their other side. */
#define ABOVE     "twosided on\nlight point 0 .2 -2 1 1 1 1 0 .3\nlookat 0 -3 0  0 0 -1  0 1 0\n"
#define STRETCHED "material emission .1 0 .1\nscale 1.5 .7 1\n"

/* Of triangles of some ten pixels: what is narrower than 6 at their outlines is lit by vertex. */
#define MESHES                                                                                     \
    "cull back\ntranslate -.6 .1 0\nshape sphere .7 12 8 color 1 .8 .6\ntranslate 1.3 0 0\n"       \
    "rotate 40 1 0 0\nshape torus .5 .25 11 7 color .5 .8 1\n"

static const char *const trials[] = {
    BEGIN DULL POINT FLOOR,
    BEGIN SHINING POINT FLOOR WALL,
    BEGIN SHINING POINT SPOT SUN FLOOR WALL ROUND,
    BEGIN SHINING POINT SPOT ENDLESS,
    BEGIN "interpolate linear\n" SHINING POINT SPOT WALL ROUND,
    BEGIN SHINING POINT TEXTURED,
    BEGIN SHINING POINT "texfilter bilinear\n" TEXTURED,
    BEGIN SHINING ABOVE FLOOR ROUND,
    BEGIN SHINING POINT STRETCHED FLOOR ROUND,
    BEGIN DULL POINT SPOT SUN MESHES,
    BEGIN SHINING POINT SUN MESHES,
    BEGIN "twosided on\nlight point 1 1 2  1 1 .9  .5 0 .2\n" SHINING POINT STRETCHED MESHES,
};

enum { TRIALS = sizeof trials / sizeof trials[0], FIRST_MESHES = TRIALS - 3 };

/* With a statement more, before the projection. */
static struct scene parse(const char *text, const char *shade, const char *more)
{
    char filled[2048], shaded[2048];
    struct scene scene;
    struct text_error error;
    snprintf(shaded, sizeof shaded, text, shade);
    const char *rest = strstr(shaded, "mode projection");
    snprintf(filled, sizeof filled, "%.*s%s%s", (int)(rest - shaded), shaded, more, rest);
    assert_true(scene_parse("test.scene", filled, strlen(filled), &scene, &error));
    return scene;
}

/* Pixels off by more than 2, and the most that one is off by. */
static int count_off(const struct scene *scene, const struct reference_image *image, double *most)
{
    struct picture picture;
    int off = 0;
    *most = 0;
    assert_true(scene_render(scene, &qtri_xrgb8888, 0, false, &picture));
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double worst = 0;
        for (int c = 0; c < 3; c++) {
            worst = fmax(worst, fabs(picture.rgb[3 * i + c] - image->color[3 * i + c]));
        }
        off += worst > 2.5;
        *most = fmax(*most, worst);
    }
    picture_free(&picture);
    return off;
}

TEST(exactness)
{
    for (size_t t = 0; t < 2 * TRIALS; t++) {
        const char *text = trials[t % TRIALS];
        const char *mode = t < TRIALS ? "" : "antialias msaa\n";
        struct reference_image image;
        double most, by_vertex;
        struct scene scene = parse(text, "pixel", mode);
        struct scene smooth = parse(text, "smooth", mode);
        assert_true(reference_render(&scene, 8, &image));
        const int off = count_off(&scene, &image, &most);
        const int worse = count_off(&smooth, &image, &by_vertex);
        print_message("%d: %d pixels off by more than 2, one by %.1f; by vertex %d, %.1f\n", (int)t,
                      off, most, worse, by_vertex);
        const bool has_meshes = t % TRIALS >= FIRST_MESHES;
        assert_true(off <= WIDTH * HEIGHT * (has_meshes ? 8 : 4) / 10000);
        assert_true(most < (has_meshes ? 18 : 6));
        assert_true(worse > 100 * (off + 1));
        reference_free(&image);
        scene_free(&scene);
        scene_free(&smooth);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
