/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/scene.h"
#include "../reference/reference.h"
#include "../reference/reference_picture.h"
#include "bench_program.h"

/* ---- A scene of the benchmark once more, in the language of scene files ---- */

/* Meshes: the file without .obj, and the pixels that every renderer is to cover; 0: not known
 * beforehand. */
static const struct subject {
    const qtri_mesh *mesh;
    const char *file;
    uint32_t pixels;
} subjects[] = {
    {&bench_mesh_spot, "spot", 12414},
    {&bench_mesh_spot_compact, "spot-compact", 12414},
    {&bench_mesh_spot_uv_compact, "spot_uv-compact", 12414},
    {&bench_mesh_teapot, "teapot", 15296},
    {&bench_mesh_teapot_compact, "teapot-compact", 15296},
    {&bench_mesh_knot, "knot", 0},
    {&bench_mesh_knot_compact, "knot-compact", 0},
    {&bench_mesh_knot_uv_compact, "knot_uv-compact", 0},
    {&bench_mesh_wall_compact, "wall-compact", 0},
    {&bench_mesh_torus96_compact, "torus96-compact", 0},
    {&bench_mesh_torus216_compact, "torus216-compact", 0},
    {&bench_mesh_torus384_compact, "torus384-compact", 0},
    {&bench_mesh_torus864_compact, "torus864-compact", 0},
};

static const struct subject *subject_of(const qtri_mesh *mesh)
{
    for (size_t i = 0; i < sizeof subjects / sizeof subjects[0]; i++) {
        if (subjects[i].mesh == mesh) {
            return &subjects[i];
        }
    }
    return NULL;
}

/* Whether the reference is asked: of the others the tests look at the options that the scene has.
 */
static bool is_described(const bench_scene *scene)
{
    const bool is_mesh = scene->work == BENCH_MESH;
    return scene->work != BENCH_PAINT && scene->depth == NULL && scene->filter == NULL &&
           scene->format == NULL && !scene->thin && !scene->hidden && !scene->sprite &&
           (scene->mesh == NULL || subject_of(scene->mesh) != NULL) &&
           !(is_mesh && (scene->width != 0 || scene->shading == QTRI_PER_PIXEL)) &&
           !(scene->blend == &qtri_blend_vertex_alpha && scene->quad != &bench_screen) &&
           !(scene->smooth == BENCH_SAMPLES &&
             (scene->textured || scene->fog || scene->blend != NULL));
}

/* 0: not known beforehand. */
static uint32_t pixels_of(const bench_scene *scene)
{
    if (scene->wireframe || scene->smooth != BENCH_JAGGED) {
        return 0;
    }
    if (scene->mesh != NULL) {
        return subject_of(scene->mesh)->pixels;
    }
    const bool is_whole = scene->work == BENCH_CLEAR || scene->quad == &bench_screen;
    return is_whole ? BENCH_WIDTH * BENCH_HEIGHT : scene->quad == &bench_floor ? 53290 : 0;
}

static void write_lights(FILE *out, const bench_scene *scene)
{
    if (scene->lights == 0) {
        fputs(scene->work == BENCH_MESH && scene->colors == NULL ? "light .4 .6 .69282032 .2 .8\n"
                                                                 : "",
              out);
        return;
    }
    fputs("ambient .125 .125 .125\nlight point 1.5 1 0 1 .9 .8 1 0 .05\n", out); /* in eye space */
    fputs(scene->dull ? "" : "material specular 1 1 1 30\n", out);
    fputs(scene->lights > 1 ? "light directional -1 .5 .3 .1 .2 .4\n" : "", out);
    fputs(scene->lights > 2 ? "light directional .4 .6 .69282032 .2 .2 .2\n"
                              "light directional .2 -.8 .5 .2 .1 .1\n"
                            : "",
          out);
}

static void write_state(FILE *out, const bench_scene *scene)
{
    fputs("viewport 320 240\nclear .0941176471 .1254901961 .1882352941\ndepth less\n"
          "mode projection\nperspective 60 1.33333333 .1 100\n"
          "mode modelview\nlookat 0 0 3  0 0 0  0 1 0\n",
          out);
    write_lights(out, scene);
    fputs(scene->mesh != NULL ? "cull back\n" : "", out);
    fputs(scene->shading == QTRI_FLAT_LAST ? "shade flat\n" : "", out);
    fputs(scene->shading == QTRI_PER_PIXEL ? "shade pixel\n" : "", out);
    fputs(scene->interpolation == QTRI_SCREEN_LINEAR ? "interpolate linear\n" : "", out);
    fputs(scene->compare == QTRI_LESS_EQUAL ? "depth lequal\n" : "", out);
    fputs(scene->without_depth ? "depth off\n" : "", out);
    fputs(scene->wireframe ? "polygon line\n" : "", out);
    fputs(scene->blend == &qtri_blend_alpha ? "blend alpha .501961\n" : "", out);
    fputs(scene->blend == &qtri_blend_add ? "blend add .501961\n" : "", out);
    fputs(scene->blend == &qtri_blend_vertex_alpha ? "blend alpha\n" : "", out);
    fputs(scene->fog ? "fogdensity exp2 .1 100 .501961 .564706 .627451 .18\n" : "", out);
    if (scene->textured) {
        fputs(scene->mesh != NULL ? "texture texture.ppm\ntexformat rgb565\ntexmode modulate\n"
                                  : "texture texture.ppm\ntexmode replace\n",
              out);
    }
    if (scene->width != 0) {
        fprintf(out, "%s %.9f\n", scene->points ? "pointsize" : "linewidth",
                scene->width / 65536.0);
    }
}

static void write_corner(FILE *out, const qtri_corner *c, double intensity, bool textured)
{
    const double factor = intensity / 255.0;
    fprintf(out, " %.9f %.9f %.9f 1 %.9f %.9f %.9f", c->position.x / 65536.0,
            c->position.y / 65536.0, c->position.z / 65536.0, factor * c->color.r,
            factor * c->color.g, factor * c->color.b);
    if (textured) {
        fprintf(out, " %.9f %.9f", c->uv.x / 65536.0, c->uv.y / 65536.0);
    }
}

static void write_quad(FILE *out, const bench_scene *scene)
{
    qtri_corner corners[6];
    bench_set_quad(corners, scene->quad, scene->colors);
    for (int i = 0; i < 6; i++) {
        if (i % 3 == 0 && scene->blend == &qtri_blend_vertex_alpha) {
            fputs(i == 0 ? "vertexalpha 1 .6 .2\n" : "vertexalpha 1 .2 .8\n", out);
        }
        fputs(i % 3 != 0 ? "" : scene->textured ? "trit" : "tri", out);
        write_corner(out, &corners[i], 1, scene->textured);
        fputs(i % 3 == 2 ? "\n" : "", out);
    }
}

/* Its polyline or points. */
static void write_strokes(FILE *out, const bench_scene *scene)
{
    static qtri_corner corners[BENCH_CORNERS_MAX];
    const uint32_t count = bench_set_strokes(corners, scene);
    fputs(scene->points ? "" : "polyline open\n", out);
    for (uint32_t i = 0; i < count; i++) {
        fputs(scene->points ? "point" : "vertex", out);
        write_corner(out, &corners[i], 1, false);
        fputc('\n', out);
    }
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

/* The light of a mesh that is turned about y. */
static double intensity_of(const double normal[3], q16 turn)
{
    double angle = turn / 65536.0 * acos(-1.0) / 180.0;
    double x = normal[0] * cos(angle) + normal[2] * sin(angle);
    double z = normal[2] * cos(angle) - normal[0] * sin(angle);
    double along = .4 * x + .6 * normal[1] + .69282032 * z;
    double length = sqrt(x * x + normal[1] * normal[1] + z * z);
    return .2 + .8 * fmax(0.0, along / length);
}

/* Colours of a mesh's vertices are not in the language: its triangles, lit here. */
static void write_triangles(FILE *out, const bench_scene *scene)
{
    for (uint32_t i = 0; i < 3 * scene->mesh->triangle_count; i++) {
        double p[3], n[3];
        const uint32_t vertex = scene->mesh->triangles[i / 3][i % 3];
        vertex_of(scene->mesh, vertex, p, n);
        const double factor =
            (scene->work == BENCH_MESH ? intensity_of(n, scene->turn) : 1.0) / 255.0;
        const qtri_rgb color = scene->colors[vertex];
        fprintf(out, "%s %.9f %.9f %.9f 1 %.9f %.9f %.9f%s", i % 3 == 0 ? "tri" : "", p[0], p[1],
                p[2], factor * color.r, factor * color.g, factor * color.b, i % 3 == 2 ? "\n" : "");
    }
}

/* The text of the scene; free() it. NULL: memory ran out. */
static char *describe(const bench_scene *scene)
{
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    if (out == NULL) {
        return NULL;
    }
    write_state(out, scene);
    if (scene->mesh != NULL) {
        fprintf(out, "rotate %.9f 0 1 0\n", scene->turn / 65536.0);
    }
    if (scene->mesh != NULL && scene->colors != NULL) {
        write_triangles(out, scene);
    } else if (scene->mesh != NULL) {
        fprintf(out, "mesh %s.obj color %s\n", subject_of(scene->mesh)->file,
                scene->white ? "1 1 1" : "1 .7058823529 .3529411765");
    } else if (scene->quad != NULL) {
        write_quad(out, scene);
    } else if (scene->work == BENCH_STROKE) {
        write_strokes(out, scene);
    }
    fclose(out);
    return text;
}

/* ---- The pictures ---- */

static bool write_texture(const char *path)
{
    FILE *out = fopen(path, "wb");
    if (out == NULL) {
        perror(path);
        return false;
    }
    fprintf(out, "P6\n%d %d\n255\n", BENCH_TEXTURE_SIDE, BENCH_TEXTURE_SIDE);
    for (uint32_t i = 0; i < BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE; i++) {
        const qtri_rgb color = bench_texel(i % BENCH_TEXTURE_SIDE, i / BENCH_TEXTURE_SIDE);
        const uint8_t rgb[3] = {color.r, color.g, color.b};
        fwrite(rgb, 1, 3, out);
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

static bool compare(const bench_frame *frame, const struct reference_image *image,
                    const struct picture *picture)
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
    const uint32_t most_colors = pixels / 300, expected = pixels_of(frame->scene);
    bool ok = mismatch <= (compact ? pixels / 1000 : 0) && other_color <= most_colors &&
              (expected == 0 || pixels == expected);
    printf("%-4s %6u pixels%s, %u in one picture only, %u with a colour off by more than a step, "
           "depth off by %.2f at most%s\n",
           frame->scene->name, (unsigned)pixels, clears ? " cleared" : "", (unsigned)mismatch,
           (unsigned)other_color, depth_error, ok ? "" : ": WRONG");
    return ok;
}

static bool check_scene(const bench_frame *frame, const char *folder)
{
    char name[1024];
    struct text_error error = {"out of memory"};
    struct scene scene;
    struct reference_image image;
    struct picture picture;
    snprintf(name, sizeof name, "%s/%s", folder, frame->scene->name);
    char *text = describe(frame->scene);
    bool ok = text != NULL && scene_parse(name, text, strlen(text), &scene, &error);
    free(text);
    if (!ok) {
        fprintf(stderr, "bench_host: %s\n", error.message);
        return false;
    }
    ok = reference_render(&scene, 8, &image);
    scene_free(&scene);
    if (!ok) {
        return false;
    }
    ok = reference_picture(&image, REFERENCE_RGB565, &picture);
    if (ok) {
        ok = compare(frame, &image, &picture);
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
    for (const bench_scene *scene = bench_scenes; ok && scene->name != NULL; scene++) {
        if (!bench_prepare(&bench_memory, scene)) {
            printf("%-4s skipped: its model is not there\n", scene->name);
        } else if (is_described(scene)) {
            bench_draw(&bench_memory);
            bench_finish(&bench_memory);
            ok = check_scene(&bench_memory, folder);
        }
    }
    return ok ? 0 : 1;
}
