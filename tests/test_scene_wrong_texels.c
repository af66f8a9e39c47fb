/* SPDX-License-Identifier: MIT */
/*
 * Wrong texels of floors and of meshes of small triangles, by size of texture and repeats, against
 * the double-precision reference without any snapping: the tables of host/bench/README.md. The
 * textures are the busiest there are, every texel unlike its neighbours, so that none that is wrong
 * goes unseen. Scenes go in and pictures come out: nothing here knows how the core draws.
 */
#include <stdarg.h>
#include <stdio.h>

#include "support/core.h"

#include "reference/reference.h"
#include "support/accuracy.h"
#include "tools/scene_draw.h"

enum { EVERY = IS_SANITIZED ? 6 : 1 }; /* of the views, as the others take too long */
enum { FLOOR_VIEWS = 24, MESH_VIEWS = 6, CELLS_X = 30, CELLS_Y = 22, TEXT_MAX = 400000 };

/* Wrong pixels of 100,000, as they are today: of all views, and of the worst. */
typedef struct row {
    int texels;     /* a side */
    double repeats; /* of a floor's side, or of a cell's */
    double mean, worst;
} row;

typedef struct text {
    char *at;
    size_t length;
} text;

static void append(text *t, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    t->length += (size_t)vsnprintf(t->at + t->length, TEXT_MAX - t->length, format, arguments);
    va_end(arguments);
    assert_true(t->length < TEXT_MAX);
}

static void measure(struct accuracy *sum, const text *t)
{
    struct scene scene;
    struct picture picture;
    struct reference_image image;
    struct text_error error;
    if (!scene_parse("textured", t->at, t->length, &scene, &error)) {
        fail_msg("%s", error.message);
    }
    assert_true(scene_render(&scene, &qtri_xrgb8888, 0, true, &picture));
    assert_true(reference_render(&scene, 0, &image));
    accuracy_add(sum, &picture, &image, true);
    reference_free(&image);
    picture_free(&picture);
    scene_free(&scene);
}

static void begin_scene(text *t, int texels)
{
    t->length = 0;
    append(t,
           "viewport 320 240\nclear 0 0 0\ndepth less\ntexture %d %d %d  255 255 255  0 0 0\n"
           "mode projection\nperspective 60 1.33333333 .1 400\nmode modelview\n",
           texels, texels, texels);
}

static void append_corner(text *t, int number, double x, double y, double z, double u, double v)
{
    append(t, "%s %.5f %.5f %.5f 1 1 1 1 %.6f %.6f%s", number == 0 ? "trit" : "", x, y, z, u, v,
           number == 2 ? "\n" : "");
}

/* A floor below an eye at one of three heights, which is turned and rolled; cut at the near plane
   in some views. */
static void write_floor(text *t, const row *r, int view)
{
    static const double heights[3] = {1, .3, 4};
    static const double rolls[4] = {0, 10, 45, 90};
    static const double turns[5] = {-23.7, 8.3, 31.9, -4.1, 17.3};
    static const int corner[6] = {0, 1, 2, 0, 2, 3};
    const double half = 13.1 + .13 * view;
    const double near_z = view % 5 == 0 ? .05 : 1.21 + .017 * view;
    begin_scene(t, r->texels);
    append(t, "rotate %.1f 0 0 1\nrotate %.1f 0 1 0\ntranslate 0 %.1f 0\n", rolls[view / 3 % 4],
           turns[view % 5], -heights[view % 3]);
    for (int i = 0; i < 6; i++) {
        const bool right = corner[i] == 1 || corner[i] == 2;
        const bool far = corner[i] >= 2;
        append_corner(t, i % 3, right ? half : -half, 0, far ? -83.3 : -near_z,
                      right ? r->repeats : 0, far ? r->repeats : 0);
    }
}

/* A wall of cells of some ten pixels, two triangles each, that is turned and rolled. */
static void write_mesh(text *t, const row *r, int view)
{
    static const double turns[MESH_VIEWS] = {0.7, 21.3, -33.1, 47.9, -12.7, 38.3};
    static const double rolls[MESH_VIEWS] = {3.1, 0, 17.7, 41.3, 87.1, 66.7};
    static const int corner[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    const double size = .145 + .003 * view;
    begin_scene(t, r->texels);
    append(t, "translate 0 0 -3\nrotate %.1f 0 0 1\nrotate %.1f 0 1 0\n", rolls[view], turns[view]);
    for (int i = 0; i < CELLS_X * CELLS_Y * 6; i++) {
        const int *c = corner[i % 6];
        const int x = i / 6 % CELLS_X;
        const int y = i / 6 / CELLS_X;
        append_corner(t, i % 3, (x + c[0] - CELLS_X / 2) * size, (y + c[1] - CELLS_Y / 2) * size, 0,
                      c[0] * r->repeats, c[1] * r->repeats);
    }
}

/* Prints a row of the table, and compares it with what it was. A pixel more may be wrong than
   there, as what the reference rounds is the compiler's. */
static void judge(const row *r, void (*write)(text *, const row *, int), int views)
{
    text t = {malloc(TEXT_MAX), 0};
    struct accuracy sum = {0};
    double worst = 0;
    double pixel = 0; /* of the worst view */
    assert_non_null(t.at);
    for (int view = 0; view < views; view += EVERY) {
        struct accuracy one = {0};
        write(&t, r, view);
        measure(&one, &t);
        const double wrong = accuracy_per_100k(one.color_above_1, one.covered);
        assert_true(one.covered > 4000);
        pixel = wrong >= worst ? accuracy_per_100k(1, one.covered) : pixel;
        worst = wrong > worst ? wrong : worst;
        sum.covered += one.covered;
        sum.color_above_1 += one.color_above_1;
    }
    const double mean = accuracy_per_100k(sum.color_above_1, sum.covered);
    print_message("| %d | %g | %.1f | %.1f |\n", r->texels, r->repeats, mean, worst);
    free(t.at);
    assert_true(worst <= r->worst + pixel);
    assert_true(EVERY > 1 || mean <= r->mean + accuracy_per_100k(1, sum.covered));
}

TEST(floors)
{
    static const row rows[] = {
        {16, 1, 5.8, 32.3},        {16, 4, 5.2, 17.5},       {16, 8, 6.6, 35.3},
        {16, 16, 11.0, 70.6},      {16, 32, 8.3, 70.6},      {16, 64, 8.1, 66.4},
        {16, 128, 9.4, 59.4},      {16, 400, 13.1, 63.6},    {64, 1, 3.9, 17.5},
        {64, 4, 10.0, 70.6},       {64, 8, 7.7, 70.6},       {64, 16, 7.5, 62.9},
        {64, 32, 9.5, 62.9},       {64, 64, 11.1, 66.4},     {64, 128, 15.8, 66.7},
        {64, 400, 33.0, 90.9},     {256, 1, 9.1, 70.6},      {256, 4, 7.4, 60.0},
        {256, 8, 8.9, 59.4},       {256, 16, 10.6, 62.9},    {256, 32, 16.1, 66.7},
        {256, 64, 31.1, 84.8},     {256, 128, 56.2, 150.3},  {256, 400, 120.8, 215.5},
        {1024, 1, 7.7, 60.0},      {1024, 4, 10.8, 55.9},    {1024, 8, 15.6, 66.7},
        {1024, 16, 30.7, 84.8},    {1024, 32, 56.8, 157.3},  {1024, 64, 104.5, 243.7},
        {1024, 128, 199.1, 360.3}, {1024, 400, 468.5, 744.2}};
    print_message("texels, repeats, wrong of 100,000 in all views, in the worst\n");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        judge(&rows[i], write_floor, FLOOR_VIEWS);
    }
}

/* What counts is how many texels a cell has. */
TEST(small_triangles)
{
    static const row rows[] = {{16, 0.25, 1866.4, 3574.5}, {16, 1, 1056.7, 4517.6},
                               {16, 4, 997.3, 1216.4},     {64, 4, 3890.4, 4811.3},
                               {256, 4, 9375.7, 12835.1},  {1024, 4, 15521.8, 40188.2}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        judge(&rows[i], write_mesh, MESH_VIEWS);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
