/* SPDX-License-Identifier: MIT */
/*
 * A textured, lit mesh that turns, on a colour display of up to 320x240 pixels: two bands of 16
 * rows in turn, so that one is sent while the next is drawn. By itself it is a ring; a model of
 * yours takes its place with QTRI_EXAMPLE_MODEL:
 *
 *   qtri mesh duck.glb -o model.h --name model --compact --center --fit 2 --plain
 *   qtri texture duck.png -o skin.h --name skin --size 128x128
 */
#include <qtri.h>

#include "qtri_port/screen.h"

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
static uint8_t mesh_memory[MODEL_BYTES(HEIGHT, ROWS)];

enum qtri_error example_run(void)
{
    static const qtri_light light = {
        .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.25), .diffuse = Q16(.75)};
    const qtri_vec3 eye = {0, 0, Q16(3.6)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    const qtri_rgb sky = {16, 24, 40};
    make_model();
    qtri_material material = qtri_material_default();
#ifndef MODEL_HAS_NO_SKIN
    material.texture = &skin;
#endif

    qtri_screen screen;
    qtri_prepared prepared;
    qtri_view view;
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_rgb565, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    qtri_prepared_init(&prepared, mesh_memory, sizeof mesh_memory);
    screen.background = sky;
    qtri_view_init(&view, screen.frame.width, screen.frame.height);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(50), Q16(.1), Q16(100));
    view.light = &light;

    q16 angle = Q16(30);
    do {
        qtri_transform pose;
        qtri_surface band;
        set_pose(&pose, angle);
        qtri_prepare_mesh(&prepared, &screen.frame, &view, &pose, &model, &material);
        while (qtri_screen_next(&screen, &band)) {
            qtri_draw_prepared(&band, &prepared);
        }
        angle = q16_mod(angle + Q16(3), Q16(1080));
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
