/* SPDX-License-Identifier: MIT */
/*
 * How good anti-aliasing is: antialias FOLDER MODELS [POSES]
 *
 * Draws subjects in RGB565 with every technique and prints the PSNR over their edge pixels, in dB,
 * mean over POSES poses (3). The truth is the double-precision reference, 8 x 8 times, moved by
 * eighths of a pixel; edge pixels are those whose 64 samples span more than 16 of 255 in luma.
 * FOLDER is where bench_meshes wrote the meshes. Then the memory that each takes.
 */
#define _XOPEN_SOURCE 700 /* realpath */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/mipmap.h"
#include "../io/scene.h"
#include "../reference/reference.h"
#include "bench_world.h"

enum { SIDE = 8, SAMPLES = SIDE * SIDE, PIXELS_MAX = 320 * 256, POSES = 3, TECHNIQUES = 11 };

#define MESH_STAGE                                                                                 \
    "viewport 320 240\nclear .0941176471 .1254901961 .1882352941\ndepth less\ncull back\n"         \
    "light .4 .6 .69282032 .2 .8\nmode projection\ntranslate 0 0 0\n"                              \
    "perspective 60 1.33333333 .1 100\nmode modelview\nlookat 0 0 3  0 0 0  0 1 0\n"               \
    "rotate 0 0 1 0\n"
#define MESH_COLOR " color 1 .7058823529 .3529411765\n"

static const char *const techniques[TECHNIQUES] = {"none",     "edges",     "by sums",  "creases",
                                                   "FXAA",     "edges+F",   "2x2",      "4 frames",
                                                   "8 frames", "16 frames", "4 samples"};

static struct subject {
    const char *name;
    const char *text; /* the scene, with a translation and a rotation to be set */
    const qtri_mesh *mesh;
    double turn, step; /* degrees */
    double fov, aspect, far, eye;
    int poses; /* 0: as many as asked for */
    bool flat, wireframe, textured;
} subjects[] = {
    {"spot", MESH_STAGE "mesh spot-compact.obj" MESH_COLOR, &bench_mesh_spot_compact, 150, 29.7, 60,
     4. / 3, 100, 3, 0, false, false, false},
    {"knot", MESH_STAGE "mesh knot-compact.obj" MESH_COLOR, &bench_mesh_knot_compact, 150, 29.7, 60,
     4. / 3, 100, 3, 0, false, false, false},
    {"teapot", MESH_STAGE "shade flat\nmesh teapot-compact.obj" MESH_COLOR,
     &bench_mesh_teapot_compact, 150, 29.7, 60, 4. / 3, 100, 3, 0, true, false, false},
    {"two triangles",
     "viewport 240 240\nclear 0 0 0\ndepth less\nmode projection\ntranslate 0 0 0\n"
     "perspective 45 1 .1 50\nmode modelview\nlookat 0 0 5  0 0 0  0 1 0\nrotate 0 0 1 0\n"
     "tri 2 0 -2 1 .8509804 .9333333 .7254902 0 2 -2 1 .8509804 .9333333 .7254902 "
     "-2 0 -2 1 .8509804 .9333333 .7254902\n"
     "tri 3.5 -1 -5 1 .7254902 .8509804 .9333333 2.5 1.5 -5 1 .7254902 .8509804 .9333333 "
     "-1 .5 -5 1 .7254902 .8509804 .9333333\n",
     NULL, -18, 3.1, 45, 1, 50, 5, 0, true, false, false},
    {"wireframe", MESH_STAGE "polygon line\nmesh spot-compact.obj" MESH_COLOR,
     &bench_mesh_spot_compact, 150, 0, 60, 4. / 3, 100, 3, 1, false, true, false},
    {"crossing",
     "viewport 256 256\nclear 0 0 0\ndepth less\nmode projection\ntranslate 0 0 0\n"
     "perspective 60 1 .1 10\nmode modelview\nlookat 0 0 3  0 0 0  0 1 0\nrotate 0 0 1 0\n"
     "tri -1 -.8 .6 1 1 .5019608 .1019608 1 -.8 -.6 1 1 .5019608 .1019608 "
     "0 1 0 1 1 .5019608 .1019608\n"
     "tri -1 -.8 -.6 1 .1019608 .4 1 1 -.8 .6 1 .1019608 .4 1 0 1 .1 1 .1019608 .4 1\n",
     NULL, 0, 0, 60, 1, 10, 3, 1, true, false, false},
    {"textured spot", MESH_STAGE "mesh spot_uv-compact.obj color 1 1 1\n",
     &bench_mesh_spot_uv_compact, 150, 0, 60, 4. / 3, 100, 3, 1, false, false, true},
};

/* ---- The truth ---- */

static double truth[PIXELS_MAX][3];
static float least_luma[PIXELS_MAX], most_luma[PIXELS_MAX];
static bool is_edge[PIXELS_MAX];

static struct scene_op *find_op(struct scene *scene, enum scene_op_kind kind)
{
    for (size_t i = 0; i < scene->op_count; i++) {
        if (scene->ops[i].kind == kind) {
            return &scene->ops[i];
        }
    }
    abort();
}

static void add_sample(const struct reference_image *image, bool first)
{
    for (int i = 0; i < image->width * image->height; i++) {
        const double *c = &image->color[3 * i];
        const float luma = (float)(.299 * c[0] + .587 * c[1] + .114 * c[2]);
        for (int k = 0; k < 3; k++) {
            truth[i][k] = (first ? 0 : truth[i][k]) + c[k] / SAMPLES;
        }
        if (first || luma < least_luma[i]) {
            least_luma[i] = luma;
        }
        if (first || luma > most_luma[i]) {
            most_luma[i] = luma;
        }
    }
}

/* Fills truth; with `mask` is_edge too. */
static bool find_truth(struct scene *scene, double turn, bool mask)
{
    struct scene_op *move = find_op(scene, SCENE_TRANSLATE);
    find_op(scene, SCENE_ROTATE)->u.number[0] = (int32_t)lrint(turn * 65536);
    for (int i = 0; i < SAMPLES; i++) {
        struct reference_image image;
        const int row = i / SIDE;
        const double x = (i % SIDE + .5) / SIDE - .5, y = (row + .5) / SIDE - .5;
        move->u.number[0] = (int32_t)lrint(2 * x / scene->width * 65536);
        move->u.number[1] = (int32_t)lrint(2 * y / scene->height * 65536);
        if (!reference_render(scene, 0, &image)) {
            return false;
        }
        add_sample(&image, i == 0);
        reference_free(&image);
    }
    for (int i = 0; mask && i < scene->width * scene->height; i++) {
        is_edge[i] = most_luma[i] - least_luma[i] > 16;
    }
    return true;
}

static double psnr(const qtri_surface *surface)
{
    double sum = 0;
    long count = 0;
    for (int i = 0; i < surface->width * surface->height; i++) {
        const qtri_rgb c = qtri_surface_pixel(surface, i % surface->width, i / surface->width);
        const double d[3] = {c.r - truth[i][0], c.g - truth[i][1], c.b - truth[i][2]};
        if (is_edge[i]) {
            sum += d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
            count += 3;
        }
    }
    return count == 0 ? 0.0 : 10 * log10(255.0 * 255.0 / (sum / (double)count));
}

/* ---- The core ---- */

static uint32_t memory[QTRI_BAND_BYTES(640, 512, 2) / 4]; /* of 4 samples a pixel no less */
static uint32_t outline_memory[20000], edge_memory[QTRI_EDGES_WORDS(320, 256, 2)];
static uint32_t rows[QTRI_FXAA_565_WORDS(320)], sums[QTRI_SUM_565_WORDS(320, 256)];
static qtri_vertex vertices[BENCH_VERTICES_MAX];
static uint16_t texels[1024 * 1024];
static qtri_texture texture;

#define WORDS(array) ((uint32_t)(sizeof(array) / sizeof((array)[0])))

/* The triangles of a scene as a mesh, each alone. */
static qtri_vec3 positions[6];
static qtri_rgb colors[6];

static qtri_mesh mesh_of(const struct scene *scene)
{
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {3, 4, 5}},
                          neighbours[2][3] = {{2, 2, 2}, {2, 2, 2}};
    qtri_mesh mesh = {.positions = positions,
                      .colors = colors,
                      .triangles = triangles,
                      .neighbours = neighbours,
                      .vertex_count = 6,
                      .triangle_count = 2};
    int count = 0;
    for (size_t i = 0; i < scene->op_count; i++) {
        for (int k = 0; scene->ops[i].kind == SCENE_TRIANGLE && k < 3; k++, count++) {
            const struct scene_vertex *v = &scene->ops[i].u.triangle.vertex[k];
            const qtri_vec3 p = {v->position[0], v->position[1], v->position[2]};
            const qtri_rgb c = {(uint8_t)lrint(v->color[0] * 255. / 65536),
                                (uint8_t)lrint(v->color[1] * 255. / 65536),
                                (uint8_t)lrint(v->color[2] * 255. / 65536)};
            positions[count] = p;
            colors[count] = c;
        }
    }
    return mesh;
}

struct drawing {
    qtri_mesh mesh;
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
    qtri_rgb sky;
    qtri_surface surface;
};

static void begin(struct drawing *d, const struct subject *subject, const struct scene *scene,
                  double turn)
{
    const qtri_vec3 eye = {0, 0, (q16)lrint(subject->eye * 65536)}, center = {0, 0, 0},
                    up = {0, Q16_ONE, 0};
    d->mesh = subject->mesh != NULL ? *subject->mesh : mesh_of(scene);
    qtri_view_init(&d->view, scene->width, scene->height);
    qtri_transform_look_at(&d->view.camera, eye, center, up);
    qtri_transform_perspective(&d->view.projection, (q16)lrint(subject->fov * 65536),
                               (q16)lrint(subject->aspect * 65536), Q16(.1),
                               (q16)lrint(subject->far * 65536));
    d->view.vertices = vertices;
    d->view.vertex_count = BENCH_VERTICES_MAX;
    d->view.light = subject->mesh != NULL ? &bench_light : NULL;
    qtri_transform_identity(&d->pose);
    qtri_transform_rotate_y(&d->pose, (q16)lrint(turn * 65536));
    d->material = qtri_material_default();
    const qtri_rgb white = {255, 255, 255}, black = {0, 0, 0};
    d->material.color = subject->textured ? white : bench_lit_color;
    d->material.cull = subject->mesh != NULL ? QTRI_CULL_BACK : QTRI_CULL_NONE;
    d->material.shading = subject->flat ? QTRI_FLAT_LAST : QTRI_SMOOTH;
    d->material.fill = subject->wireframe ? &qtri_wireframe : NULL;
    d->material.texture = subject->textured ? &texture : NULL;
    d->sky = subject->mesh != NULL ? bench_background : black;
}

static void draw(struct drawing *d, int scale, int width, int height)
{
    if (qtri_surface_init(&d->surface, &qtri_rgb565, scale * width, scale * height, 0,
                          scale * height, memory, sizeof memory) != QTRI_OK) {
        abort();
    }
    qtri_surface_clear(&d->surface, d->sky);
    qtri_draw_mesh(&d->surface, &d->view, &d->pose, &d->mesh, &d->material);
}

static void smooth_edges(struct drawing *d, bool by_sums, bool creases)
{
    qtri_outline outline;
    qtri_edges edges;
    if (by_sums) {
        d->mesh.neighbours = NULL;
    }
    if (qtri_outline_init(&outline, &d->mesh, outline_memory, WORDS(outline_memory)) != QTRI_OK) {
        abort();
    }
    outline.creases = creases;
    (void)qtri_find_outline(&d->surface, &d->view, &d->pose, &d->material, &outline);
    (void)qtri_edges_begin(&edges, &d->surface, edge_memory, WORDS(edge_memory));
    qtri_edges_note(&edges, &outline);
    qtri_edges_blend(&edges);
}

static void draw_frames(struct drawing *d, int width, int height, int32_t log2)
{
    const qtri_view still = d->view;
    qtri_sum_clear(sums, WORDS(sums));
    for (uint32_t n = 0; n < 1u << log2; n++) {
        qtri_view_jitter(&d->view, &still, n, log2);
        draw(d, 1, width, height);
        (void)qtri_sum_add(sums, WORDS(sums), &d->surface);
    }
    (void)qtri_sum_store(&d->surface, sums, WORDS(sums), log2);
}

/* Wireframes have none: their lines are smooth. */
static void draw_samples(struct drawing *d, int width, int height)
{
    qtri_surface samples;
    if (qtri_surface_init(&samples, &qtri_rgb565_x4, width, height, 0, height, memory,
                          sizeof memory) != QTRI_OK) {
        abort();
    }
    qtri_samples_clear(&samples, d->sky);
    qtri_draw_mesh(&samples, &d->view, &d->pose, &d->mesh, &d->material);
    (void)qtri_samples_resolve(&samples, &d->surface);
}

/* False where a technique is nothing for a subject. */
static bool apply(struct drawing *d, const struct subject *subject, const struct scene *scene,
                  int technique)
{
    const int width = scene->width, height = scene->height;
    if (technique == 6) {
        d->view.viewport.width *= 2;
        d->view.viewport.height *= 2;
        draw(d, 2, width, height);
        (void)qtri_halve(&d->surface, &d->surface);
        return true;
    }
    if (technique == 10) {
        draw_samples(d, width, height);
        return !subject->wireframe;
    }
    if (technique == 1 && subject->wireframe) { /* what serves lines in its place */
        d->material.fill = &qtri_smooth_wireframe;
        draw(d, 1, width, height);
        return true;
    }
    if (technique >= 7) {
        draw_frames(d, width, height, technique - 5);
        return true;
    }
    draw(d, 1, width, height);
    const bool edges = technique == 1 || technique == 2 || technique == 3 || technique == 5;
    if (edges &&
        (subject->wireframe || (technique == 3 && (!subject->flat || subject->mesh == NULL)))) {
        return false;
    }
    if (edges) {
        smooth_edges(d, technique == 2, technique == 3);
    }
    if (technique == 4 || technique == 5) {
        (void)qtri_fxaa(&d->surface, rows, WORDS(rows));
    }
    return true;
}

/* ---- The table ---- */

/* The model's own texture, as scene and core read it. */
static bool read_texture(const char *folder, const char *models, const struct subject *subject,
                         struct scene *scene)
{
    char text[8192], name[1024];
    struct text_error error;
    char *absolute = realpath(models, NULL); /* others are relative to the meshes */
    snprintf(text, sizeof text, "%stexture %s/spot_texture.ppm\ntexformat rgb565\n", subject->text,
             absolute != NULL ? absolute : models);
    free(absolute);
    snprintf(name, sizeof name, "%s/textured", folder);
    if (!scene_parse(name, text, strlen(text), scene, &error)) {
        fprintf(stderr, "antialias: %s\n", error.message);
        return false;
    }
    texture.texels = texels;
    texture.format = &qtri_texel_rgb565;
    texture.width_log2 = mipmap_log2(scene->texture.width);
    texture.height_log2 = mipmap_log2(scene->texture.height);
    for (int i = 0; i < scene->texture.width * scene->texture.height; i++) {
        const uint8_t *c = &scene->texture.rgb[3 * i];
        const qtri_rgb rgb = {c[0], c[1], c[2]};
        texels[i] = bench_rgb565(rgb);
    }
    return true;
}

static bool measure(const struct subject *subject, const char *folder, const char *models,
                    int poses)
{
    char name[1024];
    struct scene scene, textured;
    struct text_error error;
    double mean[TECHNIQUES] = {0};
    bool has[TECHNIQUES] = {false};
    snprintf(name, sizeof name, "%s/%s", folder, subject->name);
    if (subject->mesh != NULL && subject->mesh->triangle_count == 0) {
        printf("%-14s skipped: its model is not there\n", subject->name);
        return true;
    }
    if (!scene_parse(name, subject->text, strlen(subject->text), &scene, &error)) {
        fprintf(stderr, "antialias: %s\n", error.message);
        return false;
    }
    if (subject->textured && !read_texture(folder, models, subject, &textured)) {
        printf("%-14s skipped: its texture is not there\n", subject->name);
        scene_free(&scene);
        return true;
    }
    const int count = subject->poses != 0 ? subject->poses : poses;
    bool ok = true;
    for (int pose = 0; ok && pose < count; pose++) {
        const double turn = subject->turn + pose * subject->step;
        ok = find_truth(&scene, turn, true) &&
             (!subject->textured || find_truth(&textured, turn, false));
        for (int i = 0; ok && i < TECHNIQUES; i++) {
            struct drawing drawing;
            begin(&drawing, subject, &scene, turn);
            has[i] = apply(&drawing, subject, &scene, i);
            mean[i] += has[i] ? psnr(&drawing.surface) / count : 0;
        }
    }
    printf("%-14s", subject->name);
    for (int i = 0; ok && i < TECHNIQUES; i++) {
        if (has[i]) {
            printf("%10.1f", mean[i]);
        } else {
            printf("%10s", "-");
        }
    }
    printf("\n");
    fflush(stdout);
    if (subject->textured) {
        scene_free(&textured);
    }
    scene_free(&scene);
    return ok;
}

static void print_memory(void)
{
    printf(
        "\nBytes beside colour and depth, RGB565, for 320 columns   whole frame   bands of 16\n");
    printf("edge pass: marks                                       %10u    %10u\n",
           (unsigned)(4 * QTRI_EDGES_WORDS(320, 240, 2)),
           (unsigned)(4 * QTRI_EDGES_WORDS(320, 18, 2)));
    printf("  its overlap                                                   -    %10u\n",
           (unsigned)(QTRI_FRAME_BYTES(320, 16 + 2 * 1, 2) - QTRI_FRAME_BYTES(320, 16, 2)));
    printf("  a mesh of 5,856 triangles, and its lists             %10u    %10u\n",
           (unsigned)(4 * QTRI_OUTLINE_WORDS(5856)),
           (unsigned)(4 * (QTRI_OUTLINE_WORDS(5856) + QTRI_OUTLINE_LISTS(5856, 240, 16))));
    printf("  without neighbours, 2,930 vertices more              %10u    %10u\n",
           (unsigned)(4 * QTRI_OUTLINE_SUMS(2930)), (unsigned)(4 * QTRI_OUTLINE_SUMS(2930)));
    printf("2x2: colour and depth of twice the columns and rows    %10u    %10u\n",
           (unsigned)(QTRI_BAND_BYTES(640, 480, 2) - QTRI_BAND_BYTES(320, 240, 2)),
           (unsigned)(QTRI_BAND_BYTES(640, 32, 2) - QTRI_BAND_BYTES(320, 16, 2)));
    printf(
        "4 samples: their colours and depths                    %10u    %10u\n",
        (unsigned)(QTRI_BAND_BYTES(320, 240, QTRI_RGB565_X4_BYTES) - QTRI_BAND_BYTES(320, 240, 2)),
        (unsigned)(QTRI_BAND_BYTES(320, 16, QTRI_RGB565_X4_BYTES) - QTRI_BAND_BYTES(320, 16, 2)));
    printf("FXAA: old rows, and in bands its overlap               %10u    %10u\n",
           (unsigned)(4 * QTRI_FXAA_565_WORDS(320)),
           (unsigned)(4 * QTRI_FXAA_565_WORDS(320) +
                      QTRI_FRAME_BYTES(320, 16 + 2 * QTRI_FXAA_OVERLAP, 2) -
                      QTRI_FRAME_BYTES(320, 16, 2)));
    printf("sums of frames                                         %10u    %10u\n",
           (unsigned)(4 * QTRI_SUM_565_WORDS(320, 240)),
           (unsigned)(4 * QTRI_SUM_565_WORDS(320, 16)));
}

int main(int argc, char **argv)
{
    const int poses = argc == 4 ? atoi(argv[3]) : POSES;
    if (argc < 3 || argc > 4 || poses < 1) {
        fprintf(stderr, "usage: antialias FOLDER MODELS [POSES]\n");
        return 2;
    }
    printf("PSNR over edge pixels, dB, against 64 samples; RGB565; mean of %d poses\n%-14s", poses,
           "");
    for (int i = 0; i < TECHNIQUES; i++) {
        printf("%10s", techniques[i]);
    }
    printf("\n");
    bool ok = true;
    for (size_t i = 0; i < sizeof subjects / sizeof subjects[0]; i++) {
        ok = measure(&subjects[i], argv[1], argv[2], poses) && ok;
    }
    print_memory();
    return ok ? 0 : 1;
}
