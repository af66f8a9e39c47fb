/* SPDX-License-Identifier: MIT */
/*
 * A wireframe icosahedron that turns above a grid, on an OLED of 128x64. Its faces that turn away
 * are left out, so that no hidden line shows; the grid lies behind it by the depth buffer.
 */
#include <qtri.h>
#include <qtri/pipeline_make.h>

#include "qtri_port/screen.h"

#include "../example.h"

enum { WIDTH = 128, HEIGHT = 64, ROWS = 16, VERTICES = 12, TRIANGLES = 20, LINES = 14 };

const char example_name[] = "wireframe";

static uint8_t band_memory[QTRI_FRAME_BYTES(WIDTH, ROWS, QTRI_GRAY8_BYTES)];
static qtri_vertex vertices[VERTICES];
static qtri_corner grid[2 * LINES];

/* On a sphere of radius 1: three golden rectangles. */
#define A Q16(.5257311)
#define B Q16(.8506508)
static const qtri_vec3 positions[VERTICES] = {{-A, B, 0}, {A, B, 0}, {-A, -B, 0}, {A, -B, 0},
                                              {0, -A, B}, {0, A, B}, {0, -A, -B}, {0, A, -B},
                                              {B, 0, -A}, {B, 0, A}, {-B, 0, -A}, {-B, 0, A}};
static const uint16_t triangles[TRIANGLES][3] = {
    {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};

static void make_grid(void)
{
    for (int32_t i = 0; i < LINES; i++) {
        q16 across = (i / 2 - LINES / 4) * Q16(1.2);
        qtri_corner from = {{across, Q16(-1.2), Q16(-6), Q16(1)}, {150, 150, 150}, {0, 0}};
        qtri_corner to = {{across, Q16(-1.2), Q16(2), Q16(1)}, {150, 150, 150}, {0, 0}};
        if (i % 2 != 0) { /* the other direction */
            from.position.x = Q16(-5);
            to.position.x = Q16(5);
            from.position.z = to.position.z = across - Q16(2);
        }
        grid[2 * i] = from;
        grid[2 * i + 1] = to;
    }
}

/* What draws the faces. */
QTRI_PIPELINE(faces_pipeline, .format = QTRI_GRAY8, .depth = QTRI_LINEAR16, .compare = QTRI_LESS)
static const qtri_pipeline *const pipelines[] = {&faces_pipeline, NULL};

enum qtri_error example_run(void)
{
    const qtri_vec3 eye = {0, Q16(.8), Q16(3.4)}, center = {0, Q16(-.1), 0}, up = {0, Q16(1), 0};
    const qtri_rgb black = {0, 0, 0};
    qtri_mesh icosahedron = {0};
    icosahedron.positions = positions;
    icosahedron.triangles = triangles;
    icosahedron.vertex_count = VERTICES;
    icosahedron.triangle_count = TRIANGLES;
    /* First its faces in black, which hide the grid, then its edges where they are as near. */
    qtri_material solid = qtri_material_default();
    solid.color = black;
    qtri_material edges = qtri_material_default();
    edges.fill = &qtri_wireframe;
    edges.depth_compare = QTRI_DEPTH_OFF;
    qtri_material plain = qtri_material_default();
    make_grid();

    qtri_screen screen;
    qtri_view view;
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_gray8, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    qtri_view_init_pipelines(&view, screen.frame.width, screen.frame.height, pipelines);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(45), Q16(.1), Q16(100));
    view.vertices = vertices;
    view.vertex_count = VERTICES;

    q16 angle = 0;
    do {
        qtri_transform pose, ground;
        qtri_surface band;
        qtri_transform_identity(&ground);
        qtri_transform_identity(&pose);
        qtri_transform_rotate_y(&pose, angle);
        qtri_transform_rotate_x(&pose, q16_mul(angle, Q16(.5)));
        while (qtri_screen_next(&screen, &band)) {
            qtri_draw_mesh(&band, &view, &pose, &icosahedron, &solid);
            qtri_draw_lines(&band, &view, &ground, grid, 2 * LINES, &plain);
            qtri_draw_mesh(&band, &view, &pose, &icosahedron, &edges);
        }
        angle = q16_mod(angle + Q16(5), Q16(720));
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
