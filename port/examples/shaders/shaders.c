/* SPDX-License-Identifier: MIT */
/*
 * Pixel functions: an island of toon shading in animated water, on a colour display of up to
 * 320x240 pixels. A pipeline of the application's own has a function in place of what the library
 * does with a pixel's colour: the compiler puts it into the loop over pixels, in integers.
 */
#include <qtri.h>
#include <qtri/pipeline_make.h>

#include "qtri_port/screen.h"

#include "../example.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    ROWS = 16,
    FIELDS = 8, /* of the water, to a side */
    RINGS = 20, /* of the island */
    SIDES = 32,
    WATER_POINTS = (FIELDS + 1) * (FIELDS + 1),
    WATER_TRIANGLES = 2 * FIELDS * FIELDS,
    LAND_POINTS = (RINGS + 1) * (SIDES + 1),
    LAND_TRIANGLES = 2 * RINGS * SIDES,
    SINES = 64
};

const char example_name[] = "shaders";

static uint8_t band_memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, ROWS, QTRI_RGB565_BYTES)];
static qtri_vertex vertices[LAND_POINTS];

static qtri_vec3 water_positions[WATER_POINTS];
static qtri_vec2 water_uvs[WATER_POINTS];
static uint16_t water_triangles[WATER_TRIANGLES][3];

static qtri_vec3 land_positions[LAND_POINTS];
static qtri_normal land_normals[LAND_POINTS];
static uint16_t land_triangles[LAND_TRIANGLES][3];

static int8_t sine[SINES];        /* of 64 steps a turn, +-127 */
static uint32_t phase_0, phase_1; /* of the waves, 2^32 a turn */

static int32_t sine_at(uint32_t turns_q32)
{
    return sine[turns_q32 >> 26];
}

/*
 * Two waves that cross each other: 2^-32 of a repeat are 2^-32 of a turn, so that coordinates are
 * phases as they are. Crests glitter, and far away all of it is as dark as the sky's edge.
 */
static bool water(qtri_fragment *f)
{
    const int32_t wave = sine_at(f->u * 3 + f->v + phase_0) + sine_at(f->v * 5 - f->u + phase_1);
    const uint32_t height = (uint32_t)(wave + 256) >> 1; /* 1..255 */
    const uint32_t blue = 96 + (height >> 1);
    const uint32_t green = 48 + (height * height >> 9);
    const uint32_t red = height > 216 ? 160 : height >> 4;
    f->color = red << 16 | (height > 216 ? 230 : green) << 8 | (height > 216 ? 255 : blue);
    return true;
}

/* Light in three steps of the material's colour, and ink where it only grazes. */
static bool toon(qtri_fragment *f)
{
    static const uint32_t shades[] = {0x28201C, 0x5A7A30, 0x86AC48, 0xB4D878};
    f->color = shades[f->light_q8 < 64 ? 0 : f->light_q8 < 120 ? 1 : f->light_q8 < 190 ? 2 : 3];
    return true;
}

/* A texture of which only the coordinates are used. */
static const uint16_t one_texel[4] = {0, 0, 0, 0};

QTRI_PIPELINE(water_pipeline, .format = QTRI_RGB565_SWAPPED, .depth = QTRI_LINEAR16,
              .compare = QTRI_LESS, .texel = QTRI_TEXEL_RGB565, .fragment = water)
QTRI_PIPELINE(toon_pipeline, .format = QTRI_RGB565_SWAPPED, .depth = QTRI_LINEAR16,
              .compare = QTRI_LESS, .shade = QTRI_LIGHT, .fragment = toon)

static const qtri_pipeline *const pipelines[] = {&water_pipeline, &toon_pipeline, NULL};

static void make_grid(uint16_t (*triangles)[3], int32_t across, int32_t down)
{
    for (int32_t i = 0; i < across * down; i++) {
        const int32_t a = i / across * (across + 1) + i % across;
        const int32_t b = a + across + 1;
        const int32_t corners[6] = {a, b, b + 1, a, b + 1, a + 1};
        for (int32_t k = 0; k < 6; k++) {
            triangles[2 * i + k / 3][k % 3] = (uint16_t)corners[k];
        }
    }
}

static void make_water(void)
{
    for (int32_t i = 0; i < WATER_POINTS; i++) {
        const q16 u = Q16(1) / FIELDS * (i % (FIELDS + 1));
        const q16 v = Q16(1) / FIELDS * (i / (FIELDS + 1));
        const qtri_vec3 p = {24 * u - Q16(12), 0, 24 * v - Q16(16)};
        water_positions[i] = p;
        water_uvs[i].x = 8 * u;
        water_uvs[i].y = 8 * v;
    }
    make_grid(water_triangles, FIELDS, FIELDS);
}

/* A hill turned about its axis, with a dent, and normals to both sides of it. */
static void make_land(void)
{
    for (int32_t i = 0; i < LAND_POINTS; i++) {
        const q16 down = Q16(90) / RINGS * (i / (SIDES + 1));
        const q16 turn = Q16(360) / SIDES * (i % (SIDES + 1));
        const q16 bump = Q16(1) + q16_sin_deg(3 * turn) / 8;
        const q16 reach = q16_mul(q16_sin_deg(down), bump);
        const qtri_vec3 p = {2 * q16_mul(reach, q16_cos_deg(turn)), q16_cos_deg(down) * 3 / 2,
                             2 * q16_mul(reach, q16_sin_deg(turn))};
        const qtri_vec3 n = qtri_vec3_normalize(p);
        const qtri_normal normal = {(int16_t)(n.x / 4), (int16_t)(n.y / 4), (int16_t)(n.z / 4)};
        land_positions[i] = p;
        land_normals[i] = normal;
    }
    make_grid(land_triangles, SIDES, RINGS);
}

enum qtri_error example_run(void)
{
    const qtri_vec3 eye = {0, Q16(2.6), Q16(6)}, center = {0, Q16(.4), 0}, up = {0, Q16(1), 0};
    const qtri_light light = {
        .towards = {Q16(.5), Q16(.7), Q16(.4)}, .ambient = Q16(.15), .diffuse = Q16(.85)};
    const qtri_rgb sky = {120, 170, 220};
    const qtri_mesh sea = {.positions = water_positions,
                           .uvs = water_uvs,
                           .triangles = (const uint16_t(*)[3])water_triangles,
                           .vertex_count = WATER_POINTS,
                           .triangle_count = WATER_TRIANGLES};
    const qtri_mesh land = {.positions = land_positions,
                            .normals = land_normals,
                            .triangles = (const uint16_t(*)[3])land_triangles,
                            .vertex_count = LAND_POINTS,
                            .triangle_count = LAND_TRIANGLES};
    const qtri_texture coordinates = {
        .texels = one_texel, .format = &qtri_texel_rgb565, .width_log2 = 1, .height_log2 = 1};
    qtri_screen screen;
    enum qtri_error error = example_display(&screen.panel);
    if (error != QTRI_OK) {
        return error;
    }
    for (int32_t i = 0; i < SINES; i++) {
        sine[i] = (int8_t)q16_to_int_round(127 * q16_sin_deg(Q16(360) / SINES * i));
    }
    make_water();
    make_land();

    if (error == QTRI_OK) {
        error =
            qtri_screen_begin(&screen, &qtri_rgb565_swapped, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    screen.background = sky;
    qtri_view view;
    qtri_view_init_pipelines(&view, screen.frame.width, screen.frame.height, pipelines);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(50), Q16(.2), Q16(60));
    view.light = &light;
    view.vertices = vertices;
    view.vertex_count = LAND_POINTS;

    qtri_material wet = qtri_material_default();
    wet.texture = &coordinates;
    wet.texture_mode = QTRI_REPLACE;
    wet.cull = QTRI_CULL_NONE;
    wet.fragment = water;
    qtri_material drawn = qtri_material_default();
    drawn.cull = QTRI_CULL_NONE;
    drawn.fragment = toon;

    q16 angle = 0;
    do {
        qtri_transform still, turned;
        qtri_surface band;
        qtri_transform_identity(&still);
        qtri_transform_identity(&turned);
        qtri_transform_rotate_y(&turned, angle);
        phase_0 += 0x0A000000u;
        phase_1 += 0x07000000u;
        while (qtri_screen_next(&screen, &band)) {
            qtri_draw_mesh(&band, &view, &turned, &land, &drawn);
            qtri_draw_mesh(&band, &view, &still, &sea, &wet);
        }
        angle = q16_mod(angle + Q16(3), Q16(360));
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
