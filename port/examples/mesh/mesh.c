/* SPDX-License-Identifier: MIT */
/*
 * A textured, lit ring that turns, on a colour display of up to 320x240 pixels: two bands of 16
 * rows in turn, in the byte order of displays on SPI, so that one is sent as it is while the next
 * is drawn. The mesh and its texture are computed here; one of your own is constant data.
 */
#include <qtri.h>

#include "../example.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    ROWS = 16,
    AROUND = 24, /* steps about the ring's axis, */
    ACROSS = 12, /* and about its tube */
    VERTICES = (AROUND + 1) * (ACROSS + 1),
    TRIANGLES = 2 * AROUND * ACROSS,
    SIDE_LOG2 = 5
};

const char example_name[] = "mesh";

static uint8_t band_memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, ROWS, QTRI_RGB565_BYTES)];
static qtri_vertex vertices[QTRI_MESH_VERTICES(VERTICES)];
static uint16_t lists[QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, ROWS)];

static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static qtri_vec2 uvs[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static uint16_t texels[1 << (2 * SIDE_LOG2)];

/* Vertices of the seams are there twice: their texture coordinates differ. */
static void make_ring(void)
{
    for (int32_t i = 0; i < VERTICES; i++) {
        int32_t u = i / (ACROSS + 1), v = i % (ACROSS + 1);
        q16 around = q16_from_ratio(360 * u, AROUND);
        q16 across = q16_from_ratio(360 * v, ACROSS);
        q16 out = q16_cos_deg(across);
        q16 radius = Q16(1) + q16_mul(Q16(.45), out);
        qtri_vec3 p = {q16_mul(radius, q16_cos_deg(around)), q16_mul(radius, q16_sin_deg(around)),
                       q16_mul(Q16(.45), q16_sin_deg(across))};
        /* Q2.14 of the normal, whose parts are at most 1. */
        qtri_normal n = {(int16_t)(q16_mul(out, q16_cos_deg(around)) / 4),
                         (int16_t)(q16_mul(out, q16_sin_deg(around)) / 4),
                         (int16_t)(q16_sin_deg(across) / 4)};
        qtri_vec2 uv = {q16_from_ratio(6 * u, AROUND), q16_from_ratio(2 * v, ACROSS)};
        positions[i] = p;
        normals[i] = n;
        uvs[i] = uv;
    }
    for (int32_t i = 0; i < TRIANGLES; i++) {
        int32_t quad = i / 2;
        int32_t a = quad / ACROSS * (ACROSS + 1) + quad % ACROSS; /* this step, and the next: */
        int32_t b = a + ACROSS + 1;
        triangles[i][0] = (uint16_t)a;
        triangles[i][1] = (uint16_t)(i % 2 == 0 ? b : b + 1);
        triangles[i][2] = (uint16_t)(i % 2 == 0 ? b + 1 : a + 1);
    }
}

/* Bricks: RGB565, a darker joint at the top and on the left, every other row shifted. */
static void make_texture(void)
{
    const int32_t side = 1 << SIDE_LOG2;
    for (int32_t i = 0; i < side * side; i++) {
        int32_t x = i % side, y = i / side;
        int32_t shifted = (x + (y / 8 % 2) * 8) % 16;
        bool joint = y % 8 == 0 || shifted == 0;
        int32_t red = joint ? 18 : 24 + (x * 7 + y * 3) % 6;
        int32_t green = joint ? 34 : 22 + (x * 5 + y * 11) % 8;
        int32_t blue = joint ? 16 : 8;
        texels[i] = (uint16_t)(red << 11 | green << 5 | blue);
    }
}

enum qtri_error example_run(void)
{
    static const qtri_light light = {{Q16(.4), Q16(.6), Q16(.7)}, Q16(.25), Q16(.75)};
    const qtri_vec3 eye = {0, 0, Q16(3.6)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    const qtri_rgb sky = {16, 24, 40};
    make_ring();
    make_texture();
    qtri_mesh ring = {0};
    ring.positions = positions;
    ring.normals = normals;
    ring.uvs = uvs;
    ring.triangles = (const uint16_t(*)[3])triangles;
    ring.vertex_count = VERTICES;
    ring.triangle_count = TRIANGLES;
    qtri_texture texture = {0};
    texture.texels = texels;
    texture.format = &qtri_texel_rgb565;
    texture.width_log2 = SIDE_LOG2;
    texture.height_log2 = SIDE_LOG2;
    qtri_material material = qtri_material_default();
    material.texture = &texture;

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
    qtri_prepared_init(&prepared, vertices, VERTICES, lists, sizeof lists / sizeof lists[0]);
    qtri_view_init(&view, width, height);
    qtri_transform_look_at(&view.camera, eye, center, up);
    qtri_transform_perspective(&view.projection, Q16(50), q16_from_ratio(width, height), Q16(.1),
                               Q16(100));
    view.light = &light;

    q16 angle = Q16(30);
    do {
        qtri_transform pose;
        qtri_surface band;
        qtri_transform_identity(&pose);
        qtri_transform_rotate_x(&pose, Q16(-55));
        qtri_transform_rotate_y(&pose, angle / 3);
        qtri_transform_rotate_z(&pose, angle);
        qtri_frame_begin(&frame);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &ring, &material);
        while (qtri_frame_next_band(&frame, &band) && error == QTRI_OK) {
            qtri_surface_clear(&band, sky, UINT16_MAX);
            qtri_draw_prepared(&band, &prepared);
            error = qtri_panel_write(&panel, &band);
        }
        angle = q16_mod(angle + Q16(3), Q16(1080));
    } while (error == QTRI_OK && example_next_frame(&panel));
    return error;
}
