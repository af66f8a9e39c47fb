/* SPDX-License-Identifier: MIT */
#include "bench_check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/scene.h"
#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "bench_program.h"

#define HALF "blend alpha .501961\n"
#define FOG  "fogdensity exp2 .1 100 .501961 .564706 .627451 .18\n"
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
#define FADING                                                                                     \
    "vertexalpha 1 .6 .2\ntri " QUAD_CORNER("-", "-", "1 0 0") QUAD_CORNER("", "-", "0 1 0")       \
        QUAD_CORNER("", "", "0 0 1") "\nvertexalpha 1 .2 .8\ntri " QUAD_CORNER("-", "-", "1 0 0")  \
            QUAD_CORNER("", "", "0 0 1") QUAD_CORNER("-", "", "1 1 0") "\n"
#define ORANGE "1 .5019607843 .2509803922"
#define FLOOR                                                                                      \
    "texture texture.ppm\ntexmode replace\n"                                                       \
    "trit -3 -1.2 2.0784610 1 1 1 1 0 1  3 -1.2 2.0784610 1 1 1 1 1 1  "                           \
    "3 1.2 -2.0784610 1 1 1 1 1 0\n"                                                               \
    "trit -3 -1.2 2.0784610 1 1 1 1 0 1  3 1.2 -2.0784610 1 1 1 1 1 0  "                           \
    "-3 1.2 -2.0784610 1 1 1 1 0 0\n"
#define PLAIN_FLOOR                                                                                \
    "tri -3 -1.2 2.0784610 1 1 1 1  3 -1.2 2.0784610 1 1 1 1  3 1.2 -2.0784610 1 1 1 1\n"          \
    "tri -3 -1.2 2.0784610 1 1 1 1  3 1.2 -2.0784610 1 1 1 1  -3 1.2 -2.0784610 1 1 1 1\n"
#define TURNED                                                                                     \
    "texture texture.ppm\ntexmode replace\n"                                                       \
    "trit -1.1 -1.5 1.9052559 1 1 1 1 0 2  1.1 -1.5 -1.9052559 1 1 1 1 2 2  "                      \
    "1.1 1.5 -1.9052559 1 1 1 1 2 0\n"                                                             \
    "trit -1.1 -1.5 1.9052559 1 1 1 1 0 2  1.1 1.5 -1.9052559 1 1 1 1 2 0  "                       \
    "-1.1 1.5 1.9052559 1 1 1 1 0 0\n"
#define MODULATED "texture texture.ppm\ntexformat rgb565\ntexmode modulate\n"
#define LIT       "light .4 .6 .69282032 .2 .8\ncull back\n"
/* In eye space. */
#define LIGHTS                                                                                     \
    "ambient .125 .125 .125\nmaterial specular 1 1 1 30\ncull back\n"                              \
    "light point 1.5 1 0 1 .9 .8 1 0 .05\n"
#define DULL             "ambient .125 .125 .125\nlight point 1.5 1 0 1 .9 .8 1 0 .05\n"
#define BY_PIXEL         "shade pixel\n"
#define LIGHT2           "light directional -1 .5 .3 .1 .2 .4\n"
#define LIGHT34          "light directional .4 .6 .69282032 .2 .2 .2\nlight directional .2 -.8 .5 .2 .1 .1\n"
#define MESH_COLOR       " color 1 .7058823529 .3529411765\n"
#define TURN_SPOT        "rotate 150 0 1 0\n"
#define TURN_KNOT        "rotate 30 0 1 0\n"
#define KNOT_UV          TURN_KNOT "mesh knot_uv.obj" MESH_COLOR
#define KNOT_UV_COMPACT  TURN_KNOT "mesh knot_uv-compact.obj" MESH_COLOR
#define SPOT             TURN_SPOT "mesh spot.obj" MESH_COLOR
#define TEAPOT           "rotate 30 0 1 0\nmesh teapot.obj" MESH_COLOR
#define KNOT             "rotate 30 0 1 0\nmesh knot.obj" MESH_COLOR
#define SPOT_COMPACT     TURN_SPOT "mesh spot-compact.obj" MESH_COLOR
#define TEAPOT_COMPACT   "rotate 30 0 1 0\nmesh teapot-compact.obj" MESH_COLOR
#define KNOT_COMPACT     "rotate 30 0 1 0\nmesh knot-compact.obj" MESH_COLOR
#define SPOT_UV          TURN_SPOT "mesh spot_uv.obj" MESH_COLOR
#define SPOT_UV_COMPACT  TURN_SPOT "mesh spot_uv-compact.obj" MESH_COLOR
#define WALL             "mesh wall.obj" MESH_COLOR
#define WALL_COMPACT     "mesh wall-compact.obj" MESH_COLOR
#define TORUS(triangles) "rotate 25 0 1 0\nmesh torus" triangles "-compact.obj" MESH_COLOR
#define COMPACT(mesh)    mesh##_COMPACT

/* The scenes once more, in the language of scene files. Colours of a mesh's vertices are not in the
   language: the triangles of such a mesh are written behind the text. */
static const struct expectation {
    const char *name;
    const char *text; /* NULL: nothing is expected; the tests look at these */
    uint32_t pixels;  /* what every renderer is to cover; 0: not known beforehand */
} expectations[] = {
    {"S0", BEGIN, 76800},
    {"S1", BEGIN SCREEN(ORANGE, ORANGE, ORANGE, ORANGE), 76800},
    {"S2", BEGIN SCREEN("1 0 0", "0 1 0", "0 0 1", "1 1 0"), 76800},
    {"S3", BEGIN FLOOR, 53290},
    {"S3a", BEGIN "interpolate linear\n" FLOOR, 53290},
    {"S4", BEGIN LIT COMPACT(SPOT), 12414},
    {"S5", BEGIN LIT "shade flat\n" COMPACT(TEAPOT), 15296},
    {"S6", BEGIN LIT MODULATED COMPACT(SPOT_UV), 12414},
    {"S7", BEGIN LIT "polygon line\n" COMPACT(SPOT), 0},
    {"S8", BEGIN LIT MODULATED COMPACT(WALL), 0},
    {"S8w", BEGIN LIT MODULATED "mesh wall-compact.obj color 1 1 1", 0},
    {"S9", BEGIN "cull back\n" TURN_SPOT, 12414},
    {"S10", BEGIN LIT "depth off\npolygon line\n" COMPACT(SPOT), 0},
    {"S11", BEGIN TURNED, 0},
    {"S12", BEGIN LIT TORUS("96"), 0},
    {"S12b", BEGIN LIT TORUS("216"), 0},
    {"S12c", BEGIN LIT TORUS("384"), 0},
    {"S12d", BEGIN LIT TORUS("864"), 0},
    {"S13a", BEGIN LIT MODULATED TORUS("96"), 0},
    {"S13b", BEGIN LIT MODULATED TORUS("216"), 0},
    {"S13", BEGIN LIT MODULATED TORUS("384"), 0},
    {"S13d", BEGIN LIT MODULATED TORUS("864"), 0},
    {"S14", NULL, 0},
    {"SE", NULL, 0},
    {"ST", BEGIN "cull back\n" TURN_SPOT, 12414},
    {"S4k", BEGIN LIT COMPACT(KNOT), 0},
    {"S5k", BEGIN LIT "shade flat\n" COMPACT(KNOT), 0},
    {"S7k", BEGIN LIT "polygon line\n" COMPACT(KNOT), 0},
    {"S4w", BEGIN LIT SPOT, 12414},
    {"S5w", BEGIN LIT "shade flat\n" TEAPOT, 15296},
    {"S4b", BEGIN LIT COMPACT(SPOT), 12414},
    {"S4wb", BEGIN LIT SPOT, 12414},
    {"S5b", BEGIN LIT "shade flat\n" COMPACT(TEAPOT), 15296},
    {"S6b", BEGIN LIT MODULATED COMPACT(SPOT_UV), 12414},
    {"S7b", BEGIN LIT "polygon line\n" COMPACT(SPOT), 0},
    {"S4kb", BEGIN LIT COMPACT(KNOT), 0},
    {"L1", BEGIN LIGHTS SPOT_COMPACT, 12414},
    {"L2", BEGIN LIGHTS LIGHT2 SPOT_COMPACT, 12414},
    {"L3", BEGIN LIGHTS LIGHT2 LIGHT34 SPOT_COMPACT, 12414},
    {"L1f", BEGIN LIGHTS "shade flat\n" TEAPOT_COMPACT, 15296},
    {"L1b", BEGIN LIGHTS SPOT_COMPACT, 12414},
    {"LP", BEGIN LIGHTS BY_PIXEL SCREEN(ORANGE, ORANGE, ORANGE, ORANGE), 76800},
    {"LPd", BEGIN DULL BY_PIXEL SCREEN(ORANGE, ORANGE, ORANGE, ORANGE), 76800},
    {"LPf", BEGIN LIGHTS BY_PIXEL PLAIN_FLOOR, 53290},
    {"S4e", BEGIN LIT COMPACT(SPOT), 0},
    {"S4es", BEGIN LIT COMPACT(SPOT), 0},
    {"S4h", BEGIN LIT COMPACT(SPOT), 0},
    {"S4x", BEGIN LIT COMPACT(SPOT), 0},
    {"S6x", NULL, 0},
    {"S11x", NULL, 0},
    {"B4x", NULL, 0},
    {"F4x", NULL, 0},
    {"S4f", BEGIN LIT COMPACT(SPOT), 0},
    {"S4a", BEGIN LIT COMPACT(SPOT), 0},
    {"S4m", BEGIN LIT COMPACT(SPOT), 0},
    {"S4be", BEGIN LIT COMPACT(SPOT), 0},
    {"S4br", BEGIN LIT COMPACT(SPOT), 0},
    {"K1", BEGIN "linewidth 1\n", 0},
    {"K5", BEGIN "linewidth 5\n", 0},
    {"KP", BEGIN "pointsize 6\n", 0},
    {"KQ", BEGIN "pointsize 2\n", 0},
    {"KC", BEGIN "linewidth 3\n", 0},
    {"KW", NULL, 0},
    {"KS", NULL, 0},
    {"KH", NULL, 0},
    {"B1", BEGIN HALF SCREEN(ORANGE, ORANGE, ORANGE, ORANGE), 76800},
    {"B2", BEGIN HALF SCREEN("1 0 0", "0 1 0", "0 0 1", "1 1 0"), 76800},
    {"B3", BEGIN "blend add .501961\n" SCREEN("1 0 0", "0 1 0", "0 0 1", "1 1 0"), 76800},
    {"B4", BEGIN HALF LIT COMPACT(SPOT), 12414},
    {"B5", BEGIN "blend alpha\n" FADING, 76800},
    {"B6", NULL, 0},
    {"F2", BEGIN FOG SCREEN("1 0 0", "0 1 0", "0 0 1", "1 1 0"), 76800},
    {"F4", BEGIN FOG LIT COMPACT(SPOT), 12414},
    {"B7", BEGIN HALF LIT MODULATED COMPACT(SPOT_UV), 12414},
    {"F6", BEGIN FOG LIT MODULATED COMPACT(SPOT_UV), 12414},
    {"D1", NULL, 76800},
    {"D2", NULL, 76800},
    {"D3", NULL, 53290},
    {"D6", NULL, 12414},
    {"F5", BEGIN FOG "linewidth 5\n", 0},
    {"S3m", NULL, 53290},
    {"S6m", NULL, 12414},
    {"S8m", NULL, 0},
    {"S11m", NULL, 0},
    {"S6k", BEGIN LIT MODULATED COMPACT(KNOT_UV), 0},
    {"S9k", BEGIN "cull back\n" TURN_KNOT, 0},
    {"S10k", BEGIN LIT "depth off\npolygon line\n" COMPACT(KNOT), 0},
    {"STk", BEGIN "cull back\n" TURN_KNOT, 0},
    {"S4wk", BEGIN LIT KNOT, 0},
    {"S5wk", BEGIN LIT "shade flat\n" KNOT, 0},
    {"S4wbk", BEGIN LIT KNOT, 0},
    {"S5bk", BEGIN LIT "shade flat\n" COMPACT(KNOT), 0},
    {"S6bk", BEGIN LIT MODULATED COMPACT(KNOT_UV), 0},
    {"S7bk", BEGIN LIT "polygon line\n" COMPACT(KNOT), 0},
    {"L1k", BEGIN LIGHTS KNOT_COMPACT, 0},
    {"L2k", BEGIN LIGHTS LIGHT2 KNOT_COMPACT, 0},
    {"L3k", BEGIN LIGHTS LIGHT2 LIGHT34 KNOT_COMPACT, 0},
    {"L1fk", BEGIN LIGHTS "shade flat\n" KNOT_COMPACT, 0},
    {"L1bk", BEGIN LIGHTS KNOT_COMPACT, 0},
    {"LPk", NULL, 0},
    {"S4ek", BEGIN LIT COMPACT(KNOT), 0},
    {"S4esk", BEGIN LIT COMPACT(KNOT), 0},
    {"S4hk", BEGIN LIT COMPACT(KNOT), 0},
    {"S4xk", BEGIN LIT COMPACT(KNOT), 0},
    {"B4xk", NULL, 0},
    {"F4xk", NULL, 0},
    {"S6xk", NULL, 0},
    {"S4fk", BEGIN LIT COMPACT(KNOT), 0},
    {"S4ak", BEGIN LIT COMPACT(KNOT), 0},
    {"S4mk", BEGIN LIT COMPACT(KNOT), 0},
    {"S4bek", BEGIN LIT COMPACT(KNOT), 0},
    {"KWk", NULL, 0},
    {"KSk", NULL, 0},
    {"KHk", NULL, 0},
    {"B4k", BEGIN HALF LIT COMPACT(KNOT), 0},
    {"F4k", BEGIN FOG LIT COMPACT(KNOT), 0},
    {"B7k", BEGIN HALF LIT MODULATED COMPACT(KNOT_UV), 0},
    {"D6k", NULL, 0},
    {"F6k", BEGIN FOG LIT MODULATED COMPACT(KNOT_UV), 0},
    {"S6mk", NULL, 0},
    {"S7s", NULL, 0},
    {"S7g", NULL, 0},
    {"S7l", BEGIN LIT "depth lequal\npolygon line\n" COMPACT(SPOT), 0},
    {"KSs", NULL, 0},
    {"KSl", NULL, 0},
    {"KPg", NULL, 0},
    {"S1l", BEGIN "depth lequal\n" SCREEN(ORANGE, ORANGE, ORANGE, ORANGE), 76800},
    {"S2l", BEGIN "depth lequal\n" SCREEN("1 0 0", "0 1 0", "0 0 1", "1 1 0"), 76800},
    {"S3l", BEGIN "depth lequal\n" FLOOR, 53290},
    {"S4kl", BEGIN LIT "depth lequal\n" COMPACT(KNOT), 0},
    {"S6kl", BEGIN LIT "depth lequal\n" MODULATED COMPACT(KNOT_UV), 0},
    {"S4kg", NULL, 0},
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
        mismatch += bench_is_drawn(frame, x, y) != (image->id[i] != 0);
        other_color += color_steps(color, &picture->rgb[3 * (size_t)i]) > 1;
        depth_error = fmax(depth_error, fabs(depth - image->depth[i] * 65535.0));
    }
    uint32_t pixels = bench_pixels(frame);
    mismatch = frame->scene->work == BENCH_STROKE ? 0 : mismatch; /* shares of pixels: by colour */
    depth_error = frame->scene->work == BENCH_STROKE ? 0.0 : depth_error;
    /* A texel's border may pass within rounding of a pixel's centre, and the reference reads a
       compact mesh rounded to Q16.16; a wrong picture differs in hundreds. */
    bool compact = frame->scene->mesh != NULL && frame->scene->mesh->positions == NULL;
    if (frame->scene->smooth != BENCH_JAGGED) { /* edges differ, and depth is spent */
        bool smooth = other_color <= pixels / 8;
        printf("%-4s %6u pixels, %u with a colour off by more than a step: smoothed%s\n",
               frame->scene->name, (unsigned)pixels, (unsigned)other_color,
               smooth ? "" : ": WRONG");
        return smooth;
    }
    /* Small textured triangles may be off by 1/16 texel. */
    uint32_t most_colors = pixels / 300;
    bool ok = mismatch <= (compact ? pixels / 1000 : 0) && other_color <= most_colors &&
              (expected->pixels == 0 || pixels == expected->pixels);
    printf("%-4s %6u pixels%s, %u in one picture only, %u with a colour off by more than a step, "
           "depth off by %.2f at most%s\n",
           frame->scene->name, (unsigned)pixels, clears ? " cleared" : "", (unsigned)mismatch,
           (unsigned)other_color, depth_error, ok ? "" : ": WRONG");
    return ok;
}

/* Numbers of a vertex as all its renderers read them, and its normal, of any length. */
static void vertex_of(const qtri_mesh *mesh, uint32_t i, double position[3], double normal[3])
{
    if (mesh->positions == NULL) {
        const int16_t p[3] = {mesh->positions16[i].x, mesh->positions16[i].y,
                              mesh->positions16[i].z};
        const int8_t n[3] = {mesh->normals8[i].x, mesh->normals8[i].y, mesh->normals8[i].z};
        for (int axis = 0; axis < 3; axis++) {
            position[axis] = p[axis] * (double)mesh->extent / 32768.0 / 65536.0;
            normal[axis] = n[axis];
        }
        return;
    }
    const q16 p[3] = {mesh->positions[i].x, mesh->positions[i].y, mesh->positions[i].z};
    const int16_t n[3] = {mesh->normals[i].x, mesh->normals[i].y, mesh->normals[i].z};
    for (int axis = 0; axis < 3; axis++) {
        position[axis] = p[axis] / 65536.0;
        normal[axis] = n[axis];
    }
}

/* The light of SCENES on a mesh that is turned about y. */
static double intensity_of(const double normal[3], q16 turn)
{
    double angle = turn / 65536.0 * acos(-1.0) / 180.0;
    double x = normal[0] * cos(angle) + normal[2] * sin(angle);
    double z = normal[2] * cos(angle) - normal[0] * sin(angle);
    double along = .4 * x + .6 * normal[1] + .69282032 * z;
    double length = sqrt(x * x + normal[1] * normal[1] + z * z);
    return .2 + .8 * fmax(0.0, along / length);
}

#define TRIANGLE_TEXT 512 /* bytes, at most */

/* Writes a triangle of the scene's mesh as a statement; returns its length. */
static size_t write_triangle(char *out, const bench_scene *scene, uint32_t triangle, bool lit)
{
    size_t length = (size_t)snprintf(out, TRIANGLE_TEXT, "tri");
    for (int corner = 0; corner < 3; corner++) {
        double p[3], n[3];
        uint32_t i = scene->mesh->triangles[triangle][corner];
        vertex_of(scene->mesh, i, p, n);
        double factor = (lit ? intensity_of(n, scene->turn) : 1.0) / 255.0;
        length += (size_t)snprintf(out + length, TRIANGLE_TEXT - length,
                                   " %.9f %.9f %.9f 1 %.9f %.9f %.9f", p[0], p[1], p[2],
                                   factor * scene->colors[i].r, factor * scene->colors[i].g,
                                   factor * scene->colors[i].b);
    }
    return length + (size_t)snprintf(out + length, TRIANGLE_TEXT - length, "\n");
}

/* Writes the scene's polyline or points; returns the length. */
static size_t write_strokes(char *out, const bench_scene *scene)
{
    static qtri_corner corners[BENCH_CORNERS_MAX];
    size_t length = 0;
    const uint32_t count = bench_set_strokes(corners, scene);
    if (!scene->points) {
        length += (size_t)snprintf(out, TRIANGLE_TEXT, "polyline open\n");
    }
    for (uint32_t i = 0; i < count; i++) {
        const qtri_corner *c = &corners[i];
        length += (size_t)snprintf(
            out + length, TRIANGLE_TEXT, "%s %.9f %.9f %.9f 1 %.9f %.9f %.9f\n",
            scene->points ? "point" : "vertex", c->position.x / 65536.0, c->position.y / 65536.0,
            c->position.z / 65536.0, c->color.r / 255.0, c->color.g / 255.0, c->color.b / 255.0);
    }
    return length;
}

/* The scene file of what is expected; free() it. */
static char *text_of(const struct expectation *expected, const bench_scene *scene)
{
    size_t length = strlen(expected->text);
    bool is_written = scene->mesh != NULL && scene->colors != NULL;
    uint32_t triangles = is_written ? scene->mesh->triangle_count : 0;
    bool is_stroke = scene->work == BENCH_STROKE;
    char *text = malloc(length + (size_t)(triangles + (is_stroke ? 300 : 0)) * TRIANGLE_TEXT + 1);
    if (text == NULL) {
        return NULL;
    }
    memcpy(text, expected->text, length + 1);
    if (is_stroke) {
        (void)write_strokes(text + length, scene);
    }
    for (uint32_t i = 0; i < triangles; i++) {
        length += write_triangle(text + length, scene, i, scene->work == BENCH_MESH);
    }
    return text;
}

static bool parse(const struct expectation *expected, const bench_frame *frame, const char *folder,
                  struct scene *scene)
{
    char name[1024];
    struct text_error error;
    snprintf(name, sizeof name, "%s/%s", folder, expected->name);
    char *text = text_of(expected, frame->scene);
    if (text == NULL) {
        return false;
    }
    bool ok = scene_parse(name, text, strlen(text), scene, &error);
    free(text);
    if (!ok) {
        fprintf(stderr, "bench_host: %s\n", error.message);
    }
    return ok;
}

static bool check_scene(const bench_frame *frame, const struct expectation *expected,
                        const char *folder)
{
    struct scene scene;
    if (!parse(expected, frame, folder, &scene)) {
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

int bench_check(const char *folder)
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
        if (expected->text == NULL) {
            continue;
        }
        bench_draw(&bench_memory);
        bench_finish(&bench_memory);
        ok = check_scene(&bench_memory, expected, folder);
    }
    return ok ? 0 : 1;
}
