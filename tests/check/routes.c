/* SPDX-License-Identifier: MIT */
/*
 * For routes.sh: draws one thing, and prints the address of each function of the library that is
 * entered (E) or left (L).
 */
#include <stdio.h>
#include <string.h>

#include <qtri.h>

#define PLAIN __attribute__((no_instrument_function))

enum { SIDE = 64 };

static bool is_noted;

PLAIN void __cyg_profile_func_enter(void *function, void *from);
PLAIN void __cyg_profile_func_exit(void *function, void *from);

void __cyg_profile_func_enter(void *function, void *from)
{
    (void)from;
    if (is_noted) {
        printf("E %p\n", function);
    }
}

void __cyg_profile_func_exit(void *function, void *from)
{
    (void)from;
    if (is_noted) {
        printf("L %p\n", function);
    }
}

static const qtri_vec3 positions[3] = {
    {-Q16_ONE / 2, -Q16_ONE / 2, 0}, {Q16_ONE / 2, -Q16_ONE / 2, 0}, {0, Q16_ONE / 2, 0}};
static const qtri_normal normals[3] = {{0, 0, 16384}, {0, 11585, 11585}, {0, 11585, 11585}};
static const qtri_vec2 uvs[3] = {{0, 0}, {Q16_ONE, 0}, {0, Q16_ONE}};
static const uint16_t triangles[1][3] = {{0, 1, 2}};
static const uint16_t texels[4] = {1, 2, 3, 4};
static const qtri_light light = {.towards = {0, 0, Q16_ONE}, .ambient = 0, .diffuse = Q16_ONE};
static const qtri_pipeline *const lists[][2] = {{&qtri_pipeline_texture_white, NULL},
                                                {&qtri_pipeline_flat, NULL}};

static uint8_t memory[QTRI_FRAME_BYTES(SIDE, SIDE, QTRI_RGB565_BYTES)];
static qtri_surface surface;
static qtri_view view;
static qtri_transform pose;
static qtri_material material;
static qtri_vertex vertices[3];

PLAIN static void begin(void)
{
    static const qtri_vec3 eye = {0, 0, 2 * Q16_ONE}, center, up = {0, Q16_ONE, 0};
    (void)qtri_surface_init(&surface, &qtri_rgb565, SIDE, SIDE, 0, SIDE, memory, sizeof memory);
    qtri_surface_clear(&surface, (qtri_rgb){0, 0, 0});
    qtri_view_init_pipelines(&view, SIDE, SIDE, lists[0]);
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(60), Q16_ONE, Q16_ONE / 2, Q16(20));
    view.vertices = vertices;
    view.vertex_count = 3;
    qtri_transform_identity(&pose);
    material = qtri_material_default();
}

PLAIN static void draw(const char *what)
{
    static const qtri_texture texture = {
        .texels = texels, .format = &qtri_texel_rgb565, .width_log2 = 1, .height_log2 = 1};
    static const qtri_brush brush = {{255, 0, 0}, 255, NULL};
    static const qtri_area box = {QTRI_PX(8), QTRI_PX(8), QTRI_PX(40), QTRI_PX(30)};
    const qtri_mesh lit = {positions,         .normals = normals,
                           .uvs = uvs,        .triangles = triangles,
                           .vertex_count = 3, .triangle_count = 1};
    const qtri_mesh flat = {positions, .triangles = triangles, .vertex_count = 3,
                            .triangle_count = 1};
    const qtri_corner ends[2] = {{{-Q16_ONE / 2, 0, 0, Q16_ONE}, {255, 0, 0}, {0, 0}},
                                 {{Q16_ONE / 2, Q16_ONE / 3, 0, Q16_ONE}, {255, 0, 0}, {0, 0}}};
    const qtri_stroke wide = {.width = Q16(4), .alpha = 255};
    qtri_frame frame;
    qtri_prepared prepared;
    qtri_surface band;
    is_noted = true;
    if (strcmp(what, "lit-textured") == 0) {
        view.light = &light;
        material.texture = &texture;
        qtri_draw_mesh(&surface, &view, &pose, &lit, &material);
    } else if (strcmp(what, "flat") == 0) {
        view.pipelines = lists[1];
        qtri_draw_mesh(&surface, &view, &pose, &flat, &material);
    } else if (strcmp(what, "line") == 0) {
        qtri_draw_lines(&surface, &view, &pose, ends, 2, &material);
    } else if (strcmp(what, "wide-line") == 0) {
        qtri_draw_wide_lines(&surface, &view, &pose, ends, 2, &wide, &material);
    } else if (strcmp(what, "rectangle") == 0) {
        qtri_paint_rect(&surface, &box, &brush);
    } else {
        view.pipelines = lists[1];
        (void)qtri_frame_init(&frame, &qtri_rgb565, SIDE, SIDE, SIDE, memory, sizeof memory);
        qtri_prepared_init(&prepared, vertices, sizeof vertices);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &flat, &material);
        (void)qtri_frame_next_band(&frame, &band);
        qtri_draw_prepared(&band, &prepared);
    }
    is_noted = false;
}

PLAIN int main(int argc, char **argv)
{
    begin();
    draw(argc > 1 ? argv[1] : "flat");
    return 0;
}
