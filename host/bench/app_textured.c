/* SPDX-License-Identifier: MIT */
/*
 * A lit and textured crate on an RGB565 display, in bands, with depth.
 */
#include "app.h"

#define VERTICES 24

#define A 0xFFFF
#define B 0xA2C4
static const uint16_t texels[8 * 8] = {
    B, B, B, B, B, B, B, B, /**/ B, A, A, A, A, A, A, B, /**/
    B, A, B, A, A, B, A, B, /**/ B, A, A, B, B, A, A, B, /**/
    B, A, A, B, B, A, A, B, /**/ B, A, B, A, A, B, A, B, /**/
    B, A, A, A, A, A, A, B, /**/ B, B, B, B, B, B, B, B, /**/
};
#undef A
#undef B

#define P Q16(.8)
#define M Q16(-.8)
static const qtri_vec3 positions[VERTICES] = {
    {M, M, P}, {P, M, P}, {P, P, P}, {M, P, P}, {P, M, M}, {M, M, M}, {M, P, M}, {P, P, M},
    {P, M, P}, {P, M, M}, {P, P, M}, {P, P, P}, {M, M, M}, {M, M, P}, {M, P, P}, {M, P, M},
    {M, P, P}, {P, P, P}, {P, P, M}, {M, P, M}, {M, M, M}, {P, M, M}, {P, M, P}, {M, M, P},
};
#undef P
#undef M

#define N 16384
static const qtri_normal normals[VERTICES] = {
    {0, 0, N}, {0, 0, N}, {0, 0, N}, {0, 0, N}, {0, 0, -N}, {0, 0, -N}, {0, 0, -N}, {0, 0, -N},
    {N, 0, 0}, {N, 0, 0}, {N, 0, 0}, {N, 0, 0}, {-N, 0, 0}, {-N, 0, 0}, {-N, 0, 0}, {-N, 0, 0},
    {0, N, 0}, {0, N, 0}, {0, N, 0}, {0, N, 0}, {0, -N, 0}, {0, -N, 0}, {0, -N, 0}, {0, -N, 0},
};
#undef N

#define SIDE                                                                                       \
    {0, Q16_ONE}, {Q16_ONE, Q16_ONE}, {Q16_ONE, 0},                                                \
    {                                                                                              \
        0, 0                                                                                       \
    }
static const qtri_vec2 uvs[VERTICES] = {SIDE, SIDE, SIDE, SIDE, SIDE, SIDE};
#undef SIDE

static const uint16_t triangles[12][3] = {
    {0, 1, 2},    {0, 2, 3},    {4, 5, 6},    {4, 6, 7},    {8, 9, 10},   {8, 10, 11},
    {12, 13, 14}, {12, 14, 15}, {16, 17, 18}, {16, 18, 19}, {20, 21, 22}, {20, 22, 23},
};

static const qtri_mesh crate = {
    .positions = positions,
    .normals = normals,
    .uvs = uvs,
    .triangles = triangles,
    .vertex_count = VERTICES,
    .triangle_count = 12,
};

static const qtri_texture wood = {
    .texels = texels, .format = &qtri_texel_rgb565, .width_log2 = 3, .height_log2 = 3};

static const qtri_light sun = {
    .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.2), .diffuse = Q16(.8)};

static uint32_t band_memory[QTRI_BAND_BYTES(APP_WIDTH, APP_BAND_ROWS, QTRI_RGB565_BYTES) / 4];
static qtri_vertex vertex_memory[VERTICES];
static qtri_view view;
static qtri_transform pose;
static qtri_material material;
static qtri_surface band;

#ifndef APP_DEFAULT
static const qtri_vertex_stage stage = {.positions = &qtri_positions_wide,
                                        .vertex_light = &qtri_light_by_vertex};
static const qtri_pipeline *const pipelines[] = {&qtri_pipeline_texture_white, NULL};
#endif

void app_setup(void)
{
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
#ifdef APP_DEFAULT
    qtri_view_init(&view, APP_WIDTH, APP_HEIGHT);
#else
    qtri_view_init_pipelines(&view, APP_WIDTH, APP_HEIGHT, pipelines);
#endif
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(4.0 / 3.0), Q16(.5), Q16(20));
    view.light = &sun;
    view.vertices = vertex_memory;
    view.vertex_count = VERTICES;
    material = qtri_material_default();
    material.texture = &wood;
}

void app_frame(int32_t number)
{
    const qtri_rgb sky = {24, 32, 48};
    const qtri_vec3 nearer = {0, 0, Q16(.25) * number};
    qtri_transform_identity(&pose);
    qtri_transform_translate(&pose, nearer);
    qtri_transform_rotate_y(&pose, Q16(15) * number);
    qtri_transform_rotate_x(&pose, Q16(10) * number);
    for (int32_t row = 0; row < APP_HEIGHT; row += APP_BAND_ROWS) {
        qtri_surface_init(&band, &qtri_rgb565, APP_WIDTH, APP_HEIGHT, row, APP_BAND_ROWS,
                          band_memory, sizeof band_memory);
        qtri_surface_clear(&band, sky);
#ifdef APP_DEFAULT
        qtri_draw_mesh(&band, &view, &pose, &crate, &material);
#else
        qtri_draw_mesh_by(&stage, &band, &view, &pose, &crate, &material);
#endif
        display_write(&band);
    }
}
