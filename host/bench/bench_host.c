/*
 * The host as one more board of the benchmark:
 *
 *   bench_host                the lines that the boards must reproduce
 *   bench_host check FOLDER   compares every picture with the double-precision reference;
 *                             FOLDER is where bench_meshes wrote the meshes
 *   bench_host time           microseconds per draw call, a line `scene median least` for each
 * scene
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../port/boards/board.h"
#include "../io/scene.h"
#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "bench_program.h"

void board_write(const char *text)
{
    fputs(text, stdout);
}

uint32_t board_ticks(void)
{
    return 0;
}

uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    (void)from_ticks;
    (void)to_ticks;
    return 0; /* not counted here */
}

/* ---- Against the reference ---- */

#define BEGIN                                                                                      \
    "viewport 320 240\nclear .0941176471 .1254901961 .1882352941\ndepth less\n"                    \
    "mode projection\nperspective 60 1.33333333 .1 100\n"                                          \
    "mode modelview\nlookat 0 0 3  0 0 0  0 1 0\n"
#define QUAD_CORNER(sx, sy, color) sx "2.3070917 " sy "1.7303188 0 1 " color " "
#define SCREEN(c0, c1, c2, c3)                                                                     \
    "tri " QUAD_CORNER("-", "-", c0) QUAD_CORNER("", "-", c1)                                      \
        QUAD_CORNER("", "", c2) "\n"                                                               \
                                "tri " QUAD_CORNER("-", "-", c0) QUAD_CORNER("", "", c2)           \
                                    QUAD_CORNER("-", "", c3) "\n"
#define ORANGE "1 .5019607843 .2509803922"
#define FLOOR                                                                                      \
    "texture texture.ppm\ntexmode replace\n"                                                       \
    "trit -3 -1.2 2.0784610 1 1 1 1 0 1  3 -1.2 2.0784610 1 1 1 1 1 1  "                           \
    "3 1.2 -2.0784610 1 1 1 1 1 0\n"                                                               \
    "trit -3 -1.2 2.0784610 1 1 1 1 0 1  3 1.2 -2.0784610 1 1 1 1 1 0  "                           \
    "-3 1.2 -2.0784610 1 1 1 1 0 0\n"
#define LIT            "light .4 .6 .69282032 .2 .8\ncull back\n"
#define MESH_COLOR     " color 1 .7058823529 .3529411765\n"
#define SPOT           "rotate 150 0 1 0\nmesh spot.obj" MESH_COLOR
#define TEAPOT         "rotate 30 0 1 0\nmesh teapot.obj" MESH_COLOR
#define KNOT           "rotate 30 0 1 0\nmesh knot.obj" MESH_COLOR
#define SPOT_COMPACT   "rotate 150 0 1 0\nmesh spot-compact.obj" MESH_COLOR
#define TEAPOT_COMPACT "rotate 30 0 1 0\nmesh teapot-compact.obj" MESH_COLOR
#define KNOT_COMPACT   "rotate 30 0 1 0\nmesh knot-compact.obj" MESH_COLOR
#ifdef BENCH_PLAIN
#define COMPACT(mesh) mesh
#else
#define COMPACT(mesh) mesh##_COMPACT
#endif

/* The scenes once more, in the language of scene files. */
static const struct expectation {
    const char *name;
    const char *text;
    uint32_t pixels; /* what every renderer is to cover; 0: not known beforehand */
} expectations[] = {
    {"S0", BEGIN, 76800},
    {"S1", BEGIN SCREEN(ORANGE, ORANGE, ORANGE, ORANGE), 76800},
    {"S2", BEGIN SCREEN("1 0 0", "0 1 0", "0 0 1", "1 1 0"), 76800},
    {"S3", BEGIN FLOOR, 53290},
    {"S3a", BEGIN "interpolate linear\n" FLOOR, 53290},
    {"S4", BEGIN LIT COMPACT(SPOT), 12414},
    {"S5", BEGIN LIT "shade flat\n" COMPACT(TEAPOT), 15296},
    {"S7", BEGIN LIT "polygon line\n" COMPACT(SPOT), 0},
    {"S4k", BEGIN LIT COMPACT(KNOT), 0},
    {"S5k", BEGIN LIT "shade flat\n" COMPACT(KNOT), 0},
    {"S7k", BEGIN LIT "polygon line\n" COMPACT(KNOT), 0},
    {"S4w", BEGIN LIT SPOT, 12414},
    {"S5w", BEGIN LIT "shade flat\n" TEAPOT, 15296},
    {"S4b", BEGIN LIT COMPACT(SPOT), 12414},
    {"S4wb", BEGIN LIT SPOT, 12414},
    {"S5b", BEGIN LIT "shade flat\n" COMPACT(TEAPOT), 15296},
    {"S7b", BEGIN LIT "polygon line\n" COMPACT(SPOT), 0},
    {"S4kb", BEGIN LIT COMPACT(KNOT), 0},
};

static bool write_texture(const char *path)
{
    FILE *out = fopen(path, "wb");
    if (out == NULL) {
        perror(path);
        return false;
    }
    fprintf(out, "P6\n64 64\n255\n");
    for (int y = 0; y < 64; y++) {
        for (int x = 0; x < 64; x++) {
            bool odd = ((x >> 3 ^ y >> 3) & 1) != 0;
            const unsigned char rgb[3] = {(unsigned char)(odd ? 255 : 4 * y),
                                          (unsigned char)(odd ? 4 * x : 64),
                                          (unsigned char)(odd ? 4 * y : 255 - 4 * x)};
            fwrite(rgb, 1, 3, out);
        }
    }
    return fclose(out) == 0;
}

/* The largest difference of two colours in steps of RGB565. */
static int color_steps(qtri_rgb a, const uint8_t b[3])
{
    int red = abs((a.r >> 3) - (b[0] >> 3));
    int green = abs((a.g >> 2) - (b[1] >> 2));
    int blue = abs((a.b >> 3) - (b[2] >> 3));
    int most = red > green ? red : green;
    return most > blue ? most : blue;
}

static bool compare(const bench_frame *frame, const struct expectation *expected,
                    const struct reference_image *image, const struct picture *picture)
{
    uint32_t mismatch = 0;
    uint32_t other_color = 0;
    double depth_error = 0.0;
    bool clears = frame->scene->work == BENCH_CLEAR;
    for (int32_t i = 0; i < BENCH_WIDTH * BENCH_HEIGHT; i++) {
        int32_t x = i % BENCH_WIDTH;
        int32_t y = i / BENCH_WIDTH;
        uint16_t depth = frame->surface.depth[y * frame->surface.depth_pitch + x];
        qtri_rgb color = qtri_surface_pixel(&frame->surface, x, y);
        mismatch += (depth != UINT16_MAX) != (image->id[i] != 0);
        other_color += color_steps(color, &picture->rgb[3 * (size_t)i]) > 1;
        depth_error = fmax(depth_error, fabs(depth - image->depth[i] * 65535.0));
    }
    uint32_t pixels = bench_pixels(frame);
    /* A texel's border may pass within rounding of a pixel's centre, and the reference reads a
       compact mesh rounded to Q16.16; a wrong picture differs in hundreds. */
    bool compact = frame->scene->mesh != NULL && frame->scene->mesh->positions == NULL;
    bool ok = mismatch <= (compact ? pixels / 1000 : 0) && other_color <= pixels / 1000 &&
              (expected->pixels == 0 || pixels == expected->pixels);
    printf("%-4s %6u pixels%s, %u in one picture only, %u with a colour off by more than a step, "
           "depth off by %.2f at most%s\n",
           frame->scene->name, (unsigned)pixels, clears ? " cleared" : "", (unsigned)mismatch,
           (unsigned)other_color, depth_error, ok ? "" : ": WRONG");
    return ok;
}

static bool check_scene(const bench_frame *frame, const struct expectation *expected,
                        const char *folder)
{
    char name[1024];
    struct scene scene;
    struct text_error error;
    snprintf(name, sizeof name, "%s/%s", folder, expected->name);
    if (!scene_parse(name, expected->text, strlen(expected->text), &scene, &error)) {
        fprintf(stderr, "bench_host: %s\n", error.message);
        return false;
    }
    struct reference_image image;
    struct picture picture;
    bool ok = reference_render(&scene, 8, &image);
    scene_free(&scene);
    if (!ok) {
        return false;
    }
    ok = reference_picture(&image, REFERENCE_RGB565, &picture);
    if (ok) {
        ok = compare(frame, expected, &image, &picture);
        picture_free(&picture);
    }
    reference_free(&image);
    return ok;
}

static int check(const char *folder)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/texture.ppm", folder);
    bool ok = write_texture(path);
    for (size_t i = 0; ok && i < sizeof expectations / sizeof expectations[0]; i++) {
        const struct expectation *expected = &expectations[i];
        const bench_scene *scene = &bench_scenes[i];
        if (scene->name == NULL || strcmp(scene->name, expected->name) != 0) {
            fprintf(stderr, "bench_host: scene %s is not where it is expected\n", expected->name);
            return 1;
        }
        if (!bench_prepare(&bench_memory, scene)) {
            printf("%-4s skipped: its model is not there\n", scene->name);
            continue;
        }
        bench_draw(&bench_memory);
        ok = check_scene(&bench_memory, expected, folder);
    }
    return ok ? 0 : 1;
}

/* ---- Time ---- */

#define BATCHES            25
#define BATCH_NANOSECONDS  4e6
#define CALIBRATION_CALLS  8
#define NANOSECONDS_SECOND 1e9

static double nanoseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now); /* not what other programs take meanwhile */
    return (double)now.tv_sec * NANOSECONDS_SECOND + (double)now.tv_nsec;
}

/* The time of `calls` draws; the clear before each is not counted. */
static double time_batch(const bench_scene *scene, int calls)
{
    double spent = 0.0;
    for (int i = 0; i < calls; i++) {
        bench_prepare(&bench_memory, scene);
        double start = nanoseconds();
        bench_draw(&bench_memory);
        spent += nanoseconds() - start;
    }
    return spent;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a;
    double y = *(const double *)b;
    return (x > y) - (x < y);
}

static int measure(void)
{
    for (const bench_scene *scene = bench_scenes; scene->name != NULL; scene++) {
        double batch[BATCHES];
        if (!bench_prepare(&bench_memory, scene)) {
            continue;
        }
        double call = time_batch(scene, CALIBRATION_CALLS) / CALIBRATION_CALLS;
        int calls = 1 + (int)(BATCH_NANOSECONDS / (call > 1.0 ? call : 1.0));
        for (int i = 0; i < BATCHES; i++) {
            batch[i] = time_batch(scene, calls) / calls;
        }
        qsort(batch, BATCHES, sizeof batch[0], by_value);
        printf("%s %.2f %.2f\n", scene->name, batch[BATCHES / 2] / 1e3, batch[0] / 1e3);
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 1) {
        return board_program(NULL, 0);
    }
    if (argc == 3 && strcmp(argv[1], "check") == 0) {
        return check(argv[2]);
    }
    if (argc == 2 && strcmp(argv[1], "time") == 0) {
        return measure();
    }
    fprintf(stderr, "usage: bench_host [check FOLDER | time]\n");
    return 2;
}
