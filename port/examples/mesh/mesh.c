/* SPDX-License-Identifier: MIT */
/*
 * A textured, lit mesh that turns, on a colour display of up to 320x240 pixels: two bands of 16
 * rows in turn, in the byte order of displays on SPI, so that one is sent as it is while the next
 * is drawn. By itself it is a ring; a model of yours takes its place with QTRI_EXAMPLE_MODEL:
 *
 *   qtri mesh duck.glb -o model.h --name model --compact --center --fit 2 --plain
 *   qtri texture duck.png -o skin.h --name skin --size 128x128
 */
#include <qtri.h>

#include "../example.h"

#ifdef QTRI_EXAMPLE_MODEL
#include "model.h"
#include "skin.h" /* empty, where there is none: MODEL_HAS_NO_SKIN */

static void make_model(void)
{
}

static void set_pose(qtri_transform *pose, q16 angle)
{
    qtri_transform_identity(pose);
    qtri_transform_rotate_x(pose, Q16(15));
    qtri_transform_rotate_y(pose, angle);
}
#else
#include "ring.h"
#endif

enum { WIDTH = 320, HEIGHT = 240, ROWS = 16 };

const char example_name[] = "mesh";

static uint8_t band_memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, ROWS, QTRI_RGB565_BYTES)];
static qtri_vertex vertices[QTRI_MESH_VERTICES(MODEL_VERTICES)];
static uint16_t lists[QTRI_PREPARED_LISTS(MODEL_TRIANGLES, HEIGHT, ROWS)];

enum qtri_error example_run(void)
{
    static const qtri_light light = {{Q16(.4), Q16(.6), Q16(.7)}, Q16(.25), Q16(.75)};
    const qtri_vec3 eye = {0, 0, Q16(3.6)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    const qtri_rgb sky = {16, 24, 40};
    make_model();
    qtri_material material = qtri_material_default();
#ifndef MODEL_HAS_NO_SKIN
    material.texture = &skin;
#endif

    qtri_panel panel;
    qtri_frame frame;
    qtri_prepared prepared;
    qtri_view view;
    enum qtri_error error = example_display(&panel);
    int32_t width = qtri_panel_width(&panel);
    int32_t height = qtri_panel_height(&panel);
    if (error == QTRI_OK) {
        error = qtri_frame_init(&frame, &qtri_rgb565_swapped, width, height, ROWS, band_memory,
                                sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    qtri_prepared_init(&prepared, vertices, MODEL_VERTICES, lists, sizeof lists / sizeof lists[0]);
    qtri_view_init_pipelines(&view, width, height, qtri_pipelines_swapped);
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(50), q16_from_ratio(width, height), Q16(.1),
                               Q16(100));
    view.light = &light;

    q16 angle = Q16(30);
    do {
        qtri_transform pose;
        qtri_surface band;
        set_pose(&pose, angle);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &model, &material);
        while (qtri_frame_next_band(&frame, &band) && error == QTRI_OK) {
            qtri_surface_clear(&band, sky);
            qtri_draw_prepared(&band, &prepared);
            error = qtri_panel_write(&panel, &band);
        }
        angle = q16_mod(angle + Q16(3), Q16(1080));
    } while (error == QTRI_OK && example_next_frame(&panel));
    return error;
}
