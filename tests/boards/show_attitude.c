/* SPDX-License-Identifier: MIT */
/*
 * An aircraft above a grid, seen from behind, on an OLED of 128x64 grays; its attitude follows the
 * recorded samples of a gyroscope and an accelerometer.
 */
#include "attitude.h"
#include "display_show.h"

enum { WIDTH = 128, HEIGHT = 64, VERTICES = 22, TRIANGLES = 24, GRID_LINES = 18 };

typedef struct attitude_memory {
    qtri_attitude_filter filter;
    qtri_transform pose;
    qtri_vertex vertices[VERTICES];
    qtri_corner grid[2 * GRID_LINES];
} attitude_memory;

/* Nose to -z. */
static const qtri_vec3 positions[VERTICES] = {
    {0, 0, Q16(-1.1)}, /* fuselage */
    {Q16(.16), 0, Q16(-.3)},
    {0, Q16(.17), Q16(-.3)},
    {Q16(-.16), 0, Q16(-.3)},
    {0, Q16(-.13), Q16(-.3)},
    {0, Q16(.05), Q16(1)},
    {Q16(.08), Q16(-.02), Q16(-.45)}, /* right wing: root, tip, ridge */
    {Q16(.08), Q16(-.02), Q16(.35)},
    {Q16(1.25), Q16(.08), Q16(.4)},
    {Q16(.12), Q16(.1), Q16(-.05)},
    {Q16(-.08), Q16(-.02), Q16(-.45)}, /* left wing */
    {Q16(-.08), Q16(-.02), Q16(.35)},
    {Q16(-1.25), Q16(.08), Q16(.4)},
    {Q16(-.12), Q16(.1), Q16(-.05)},
    {Q16(-.5), Q16(.06), Q16(1.05)}, /* tailplane */
    {Q16(.5), Q16(.06), Q16(1.05)},
    {0, Q16(.06), Q16(.55)},
    {0, Q16(.13), Q16(.9)},
    {0, Q16(.12), Q16(.4)}, /* fin */
    {Q16(.06), Q16(.05), Q16(.95)},
    {Q16(-.06), Q16(.05), Q16(.95)},
    {0, Q16(.62), Q16(1.1)},
};

static const uint16_t triangles[TRIANGLES][3] = {
    {0, 2, 1},    {0, 3, 2},    {0, 4, 3},    {0, 1, 4}, /* fuselage, front and rear */
    {5, 1, 2},    {5, 2, 3},    {5, 3, 4},    {5, 4, 1},    {6, 8, 7},
    {6, 7, 9},    {6, 9, 8},    {7, 8, 9},    {10, 11, 12}, {10, 13, 11},
    {10, 12, 13}, {11, 13, 12}, {14, 16, 15}, {14, 15, 17}, {14, 17, 16},
    {15, 16, 17}, {18, 19, 20}, {18, 21, 19}, {18, 20, 21}, {19, 21, 20},
};

static const qtri_mesh aircraft = {.positions = positions,
                                   .triangles = triangles,
                                   .vertex_count = VERTICES,
                                   .triangle_count = TRIANGLES};

static qtri_corner grid_corner(q16 x, q16 z)
{
    qtri_corner corner = {{x, Q16(-1.1), z, Q16_ONE}, {90, 90, 90}, {0, 0}};
    return corner;
}

static void prepare(void *memory)
{
    attitude_memory *m = memory;
    qtri_attitude_filter_init(&m->filter, Q16(1), Q16(.5));
    for (int32_t i = 0; i < GRID_LINES / 2; i++) {
        q16 across = (i - GRID_LINES / 4) * Q16(1.5);
        qtri_corner *line = &m->grid[4 * i];
        line[0] = grid_corner(across, Q16(-9));
        line[1] = grid_corner(across, Q16(3));
        line[2] = grid_corner(Q16(-6), across - Q16(3));
        line[3] = grid_corner(Q16(6), across - Q16(3));
    }
}

static const char *advance(void *memory, uint32_t frame)
{
    attitude_memory *m = memory;
    for (uint32_t i = 0; i < ATTITUDE_STRIDE; i++) {
        const attitude_sample *sample = &attitude_samples[frame * ATTITUDE_STRIDE + i];
        qtri_attitude_filter_step(&m->filter, attitude_rate(sample), attitude_force(sample),
                                  ((int32_t)1 << 30) / ATTITUDE_RATE_HZ);
    }
    qtri_transform_identity(&m->pose);
    qtri_transform_rotate_quat(&m->pose, qtri_attitude_quat(&m->filter.attitude));
    return "attitude";
}

static void draw(void *memory, const qtri_surface *surface)
{
    static const qtri_light light = {
        .towards = {Q16(-.5), Q16(1), Q16(.6)}, .ambient = Q16(.25), .diffuse = Q16(.75)};
    const qtri_vec3 eye = {0, Q16(1.1), Q16(3)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
    attitude_memory *m = memory;
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(40), Q16(2), Q16(.5), Q16(20));
    view.light = &light;
    view.vertices = m->vertices;
    view.vertex_count = VERTICES;

    qtri_transform world;
    qtri_transform_identity(&world);
    qtri_material material = qtri_material_default();
    qtri_draw_lines(surface, &view, &world, m->grid, 2 * GRID_LINES, &material);
    material.shading = QTRI_FLAT_LAST;
    qtri_draw_mesh(surface, &view, &m->pose, &aircraft, &material);
}

const display_show display_show_here = {
    .format = &qtri_gray8,
    .width = WIDTH,
    .height = HEIGHT,
    .band_rows = HEIGHT,
    .background = {0, 0, 0},
    .frames = ATTITUDE_TRUTHS,
    .bytes = sizeof(attitude_memory),
    .prepare = prepare,
    .advance = advance,
    .draw = draw,
};
