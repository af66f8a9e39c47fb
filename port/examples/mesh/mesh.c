/* SPDX-License-Identifier: MIT */
/*
 * A textured, lit mesh that turns, on a colour display of up to 320x240 pixels: two bands of 16
 * rows in turn, so that one is sent while the next is drawn. By itself it is a ring; a model of
 * yours takes its place with QTRI_EXAMPLE_MODEL:
 *
 *   qtri model duck.glb -o model.h
 */
#include <qtri.h>

#include "qtri_port/screen.h"

#include "../example.h"

/* Degrees from frame to frame. */
#ifndef QTRI_EXAMPLE_STEP
#define QTRI_EXAMPLE_STEP 3
#endif
/* For vertices and lists: a model that wants more is drawn slower, with the same pixels. */
#ifndef QTRI_EXAMPLE_MESH_BYTES
#define QTRI_EXAMPLE_MESH_BYTES 131072
#endif

#ifdef QTRI_EXAMPLE_MODEL
#include "model.h"

static void make_model(void)
{
}

/* About its middle, seen from a little above. */
static void set_pose(qtri_transform *pose, q16 angle)
{
    const qtri_vec3 right = {Q16(1), 0, 0}, up = {0, Q16(1), 0}, center = MODEL_CENTER;
    qtri_transform_identity(pose);
    qtri_transform_rotate_about(pose, Q16(15), right, center);
    qtri_transform_rotate_about(pose, angle, up, center);
}
#else
#include "ring.h"
#endif

enum { WIDTH = 320, HEIGHT = 240, ROWS = 16 };

#define WANTED_BYTES MODEL_BYTES(HEIGHT, ROWS)
#define MESH_BYTES   (WANTED_BYTES < QTRI_EXAMPLE_MESH_BYTES ? WANTED_BYTES : QTRI_EXAMPLE_MESH_BYTES)

const char example_name[] = "mesh";

static uint8_t band_memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, ROWS, QTRI_RGB565_BYTES)];
static uint8_t mesh_memory[MESH_BYTES];
static qtri_prepared prepared[MODEL_PARTS];

/* Each part of the model has its share of the memory. */
static void share_memory(void)
{
    uint8_t *memory = mesh_memory;
    for (int32_t i = 0; i < MODEL_PARTS; i++) {
        const qtri_mesh *mesh = model[i].mesh;
        const size_t wanted =
            QTRI_PREPARED_BYTES(mesh->vertex_count, mesh->triangle_count, HEIGHT, ROWS);
        const size_t bytes = (size_t)((uint64_t)wanted * MESH_BYTES / WANTED_BYTES);
        qtri_prepared_init(&prepared[i], memory, bytes);
        memory += bytes;
    }
}

/* Node 0 is turned by the example, the others as the model's keys say. Drawing looks at the poses
   again: they stay. */
static void prepare(const qtri_frame *frame, const qtri_view *view, q16 angle, q16 time)
{
#ifdef MODEL_NODES
    static qtri_transform poses[MODEL_NODES];
    for (int32_t i = 1; i < MODEL_NODES; i++) {
        const int32_t first = model_first_keys[i];
        const qtri_key key =
            qtri_keys_at(&model_keys[first], model_first_keys[i + 1] - first, time);
        qtri_transform_identity(&poses[i]);
        qtri_transform_key(&poses[i], &key);
    }
    set_pose(&poses[0], angle);
    qtri_poses_compose(poses, poses, model_parents, MODEL_NODES);
#else
    static qtri_transform poses[1];
    (void)time;
    set_pose(&poses[0], angle);
#endif
    for (int32_t i = 0; i < MODEL_PARTS; i++) {
        qtri_prepare_mesh(&prepared[i], frame, view, &poses[model[i].node], model[i].mesh,
                          &model[i].material);
    }
}

/* From so far away that the sphere about the model fits. */
static void look(qtri_view *view, const qtri_frame *frame)
{
    const qtri_vec3 center = MODEL_CENTER, up = {0, Q16(1), 0};
    const qtri_vec3 eye = {center.x, center.y, center.z + q16_mul(MODEL_RADIUS, Q16(2.4))};
    qtri_view_init(view, frame->width, frame->height);
    qtri_view_look_at(view, eye, center, up);
    qtri_view_perspective(view, Q16(50), q16_mul(MODEL_RADIUS, Q16(.5)),
                          q16_mul(MODEL_RADIUS, Q16(5)));
}

enum qtri_error example_run(void)
{
    static const qtri_light light = {
        .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.25), .diffuse = Q16(.75)};
    const qtri_rgb sky = {16, 24, 40};
    qtri_screen screen;
    qtri_view view;
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error = qtri_screen_begin(&screen, &qtri_rgb565, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    make_model();
    share_memory();
    screen.background = sky;
    look(&view, &screen.frame);
    view.light = &light;

    q16 angle = Q16(30), time = 0;
    do {
        qtri_surface band;
        prepare(&screen.frame, &view, angle, time);
        while (qtri_screen_next(&screen, &band)) {
            for (int32_t i = 0; i < MODEL_PARTS; i++) {
                qtri_draw_prepared(&band, &prepared[i]);
            }
        }
        angle = q16_mod(angle + Q16(QTRI_EXAMPLE_STEP), Q16(1080));
        time += Q16(1) / 30;
#ifdef MODEL_NODES
        time = q16_mod(time, MODEL_SECONDS);
#endif
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
