/* SPDX-License-Identifier: MIT */
/*
 * A lit mesh of 500 vertices and 1000 triangles, 320x240 RGB565 with depth, in bands of 16 rows:
 * everything in 24 KB of RAM. Vertices are kept for a few triangles only, and lists hold groups of
 * triangles, not each by itself.
 */
#include "app.h"

#define RINGS     25
#define SIDES     20
#define VERTICES  (RINGS * SIDES)
#define TRIANGLES (2 * VERTICES)

#ifndef APP_PREPARED_BYTES
#define APP_PREPARED_BYTES 1440
#endif

/* A torus: the ring's cosine and sine, then those of the angle around the tube. */
#define VERTEX(c, s, d, t)                                                                         \
    {                                                                                              \
        (int16_t)(22000 * (1 + .4 * (d)) * (c)), (int16_t)(22000 * (1 + .4 * (d)) * (s)),          \
            (int16_t)(22000 * .4 * (t))                                                            \
    }
#define NORMAL(c, s, d, t)                                                                         \
    {                                                                                              \
        (int8_t)(127 * (d) * (c)), (int8_t)(127 * (d) * (s)), (int8_t)(127 * (t))                  \
    }
#define TUBE(f, c, s)                                                                              \
    f(c, s, 1, 0), f(c, s, .951, .309), f(c, s, .809, .588), f(c, s, .588, .809),                  \
        f(c, s, .309, .951), f(c, s, 0, 1), f(c, s, -.309, .951), f(c, s, -.588, .809),            \
        f(c, s, -.809, .588), f(c, s, -.951, .309), f(c, s, -1, 0), f(c, s, -.951, -.309),         \
        f(c, s, -.809, -.588), f(c, s, -.588, -.809), f(c, s, -.309, -.951), f(c, s, 0, -1),       \
        f(c, s, .309, -.951), f(c, s, .588, -.809), f(c, s, .809, -.588), f(c, s, .951, -.309)
#define TORUS(f)                                                                                   \
    TUBE(f, 1, 0), TUBE(f, .969, .249), TUBE(f, .876, .482), TUBE(f, .729, .685),                  \
        TUBE(f, .536, .844), TUBE(f, .309, .951), TUBE(f, .063, .998), TUBE(f, -.187, .982),       \
        TUBE(f, -.426, .905), TUBE(f, -.637, .771), TUBE(f, -.809, .588), TUBE(f, -.930, .368),    \
        TUBE(f, -.992, .125), TUBE(f, -.992, -.125), TUBE(f, -.930, -.368), TUBE(f, -.809, -.588), \
        TUBE(f, -.637, -.771), TUBE(f, -.426, -.905), TUBE(f, -.187, -.982), TUBE(f, .063, -.998), \
        TUBE(f, .309, -.951), TUBE(f, .536, -.844), TUBE(f, .729, -.685), TUBE(f, .876, -.482),    \
        TUBE(f, .969, -.249)

static const qtri_position16 positions[VERTICES] = {TORUS(VERTEX)};
static const qtri_normal8 normals[VERTICES] = {TORUS(NORMAL)};

/* Corner k of ring r; the two triangles from there to the next ring. */
#define AT(r, k) ((r) % RINGS * SIDES + (k) % SIDES)
#define QUAD(r, k)                                                                                 \
    {AT(r, k), AT((r) + 1, k), AT((r) + 1, (k) + 1)},                                              \
    {                                                                                              \
        AT(r, k), AT((r) + 1, (k) + 1), AT(r, (k) + 1)                                             \
    }
#define FIVE(r, k)                                                                                 \
    QUAD(r, k), QUAD(r, (k) + 1), QUAD(r, (k) + 2), QUAD(r, (k) + 3), QUAD(r, (k) + 4)
#define RING(r)       FIVE(r, 0), FIVE(r, 5), FIVE(r, 10), FIVE(r, 15)
#define FIVE_RINGS(r) RING(r), RING((r) + 1), RING((r) + 2), RING((r) + 3), RING((r) + 4)
static const uint16_t triangles[TRIANGLES][3] = {FIVE_RINGS(0), FIVE_RINGS(5), FIVE_RINGS(10),
                                                 FIVE_RINGS(15), FIVE_RINGS(20)};

static const qtri_mesh torus = {
    .positions16 = positions,
    .extent = Q16(1),
    .normals8 = normals,
    .triangles = triangles,
    .vertex_count = VERTICES,
    .triangle_count = TRIANGLES,
};

static const qtri_light sun = {
    .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
static const qtri_material material = {.color = {255, 180, 90},
                                       .shading = QTRI_SMOOTH,
                                       .cull = QTRI_CULL_BACK,
                                       .depth_compare = QTRI_LESS};

static uint32_t band_memory[(QTRI_FRAME_BYTES(APP_WIDTH, APP_BAND_ROWS, QTRI_RGB565_BYTES) + 3) /
                            sizeof(uint32_t)];
static uint32_t prepared_memory[APP_PREPARED_BYTES / sizeof(uint32_t)];
static qtri_frame frame;
static qtri_prepared prepared;
static qtri_view view;
static qtri_transform pose;
static qtri_surface band;

static const qtri_vertex_stage stage = {.positions16 = &qtri_positions_compact,
                                        .vertex_light = &qtri_light_by_vertex};
static const qtri_pipeline *const pipelines[] = {&qtri_pipeline_lit, NULL};

void app_setup(void)
{
    const qtri_vec3 back = {0, 0, Q16(-2.2)};
    qtri_view_init_pipelines(&view, APP_WIDTH, APP_HEIGHT, pipelines);
    qtri_transform_translate(&view.camera, back);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(4.0 / 3.0), Q16(.5), Q16(20));
    view.light = &sun;
    qtri_prepared_init(&prepared, prepared_memory, sizeof prepared_memory);
    (void)qtri_frame_init(&frame, &qtri_rgb565, APP_WIDTH, APP_HEIGHT, APP_BAND_ROWS, band_memory,
                          sizeof band_memory);
}

void app_frame(int32_t number)
{
    const qtri_rgb sky = {24, 32, 48};
    qtri_transform_identity(&pose);
    qtri_transform_rotate_y(&pose, Q16(15) * number);
    qtri_transform_rotate_x(&pose, Q16(10) * number);
    qtri_prepare_mesh_by(&stage, &prepared, &frame, &view, &pose, &torus, &material);
    while (qtri_frame_next_band(&frame, &band)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, &prepared);
        display_write(&band);
    }
}
