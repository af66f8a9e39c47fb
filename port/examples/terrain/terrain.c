/* SPDX-License-Identifier: MIT */
/*
 * A flight over land without an end, on a colour display of up to 320x240 pixels. Heights are
 * computed from their place: nothing is stored but the mesh about the eye, which moves on by whole
 * fields, so that the land stands still. Fog hides where it ends. A map of your own takes the place
 * of height_at().
 */
#include <qtri.h>
#include <qtri/pipeline_make.h>

#include "qtri_port/screen.h"

#include "../example.h"

enum {
    WIDTH = 320,
    HEIGHT = 240,
    ROWS = 16,
    ACROSS = 32, /* fields to both sides together, */
    AHEAD = 28,  /* and along the way */
    VERTICES = (ACROSS + 1) * (AHEAD + 1),
    TRIANGLES = 2 * ACROSS * AHEAD
};

const char example_name[] = "terrain";

static uint8_t band_memory[QTRI_FRAME_BYTES_DOUBLE(WIDTH, ROWS, QTRI_RGB565_BYTES)];
static uint8_t mesh_memory[QTRI_PREPARED_BYTES(VERTICES, TRIANGLES, HEIGHT, ROWS)];

static qtri_vec3 positions[VERTICES];
static qtri_rgb colors[VERTICES];
static uint16_t triangles[TRIANGLES][3];

static const qtri_rgb sky = {150, 180, 215};

/* Land. Heights are of whole points, x to the right and z ahead: a field is 1 wide. */

/* 0..1, in no order that one could see: the finalizer of Murmur3. */
static q16 noise_of(int32_t x, int32_t z)
{
    uint32_t h = (uint32_t)x * 0x9E3779B1u ^ (uint32_t)z * 0x85EBCA77u;
    h ^= h >> 16;
    h *= 0x85EBCA6Bu;
    h ^= h >> 13;
    h *= 0xC2B2AE35u;
    return (q16)((h ^ h >> 16) & 0xFFFF);
}

/* Rounded down: 1 << log2 points lie between two of the noise. */
static int32_t floor_of(int32_t value, int32_t log2)
{
    int32_t one = (int32_t)1 << log2;
    int32_t rest = value % one;
    return (value - (rest < 0 ? rest + one : rest)) / one;
}

static q16 mix(q16 a, q16 b, q16 share)
{
    return a + q16_mul(b - a, share);
}

/* Noise at every 1 << log2 points, and between them along curves that are level at both ends. */
static q16 smooth_noise(int32_t x, int32_t z, int32_t log2)
{
    int32_t column = floor_of(x, log2), row = floor_of(z, log2);
    int32_t one = (int32_t)1 << log2;
    q16 u = (x - column * one) * (Q16(1) / one), v = (z - row * one) * (Q16(1) / one);
    u = q16_mul(q16_mul(u, u), Q16(3) - 2 * u);
    v = q16_mul(q16_mul(v, v), Q16(3) - 2 * v);
    return mix(mix(noise_of(column, row), noise_of(column + 1, row), u),
               mix(noise_of(column, row + 1), noise_of(column + 1, row + 1), u), v);
}

/* Hills on mountains; 0 is the sea's level. */
static q16 height_at(int32_t x, int32_t z)
{
    q16 height = 7 * smooth_noise(x, z, 4) + 3 * smooth_noise(x, z, 2) + noise_of(x, z);
    return height - Q16(4.9);
}

static qtri_rgb color_at(q16 height, q16 slope)
{
    static const qtri_rgb sea = {40, 84, 130}, sand = {196, 178, 128}, grass = {70, 120, 50},
                          rock = {112, 104, 96}, snow = {236, 240, 245};
    qtri_rgb color = height <= 0          ? sea
                     : height < Q16(.35)  ? sand
                     : height > Q16(3.4)  ? snow
                     : slope > Q16(.85)   ? rock
                     : slope < Q16(-1.05) ? rock
                                          : grass;
    /* Light from the left: what rises to the right is bright. */
    q16 light = height <= 0 ? Q16(1) : q16_clamp(Q16(.85) + slope / 2, Q16(.35), Q16(1.2));
    color.r = (uint8_t)q16_to_int_round(q16_clamp(q16_mul(color.r * Q16(1), light), 0, Q16(255)));
    color.g = (uint8_t)q16_to_int_round(q16_clamp(q16_mul(color.g * Q16(1), light), 0, Q16(255)));
    color.b = (uint8_t)q16_to_int_round(q16_clamp(q16_mul(color.b * Q16(1), light), 0, Q16(255)));
    return color;
}

/* The land about field (x, z), where the eye is: a little behind it, most of it ahead. */
static void make_land(int32_t x, int32_t z)
{
    for (int32_t i = 0; i <= AHEAD; i++) {
        int32_t row = z - 2 + i;
        q16 height = height_at(x - ACROSS / 2, row);
        for (int32_t j = 0; j <= ACROSS; j++) {
            q16 next = height_at(x - ACROSS / 2 + j + 1, row);
            qtri_vec3 p = {(j - ACROSS / 2) * Q16(1), height > 0 ? height : 0, (2 - i) * Q16(1)};
            positions[i * (ACROSS + 1) + j] = p;
            colors[i * (ACROSS + 1) + j] = color_at(height, next - height);
            height = next;
        }
    }
}

/* The front of a triangle is counter-clockwise; near rows are first in the mesh. */
static void make_triangles(void)
{
    for (int32_t i = 0; i < TRIANGLES; i++) {
        int32_t field = i / 2;
        int32_t a = field / ACROSS * (ACROSS + 1) + field % ACROSS;
        int32_t b = a + ACROSS + 1; /* farther */
        triangles[i][0] = (uint16_t)a;
        triangles[i][1] = (uint16_t)(i % 2 == 0 ? a + 1 : b + 1);
        triangles[i][2] = (uint16_t)(i % 2 == 0 ? b + 1 : b);
    }
}

/* Where the flight is: it goes ahead, sways, and keeps above the land. */
typedef struct flight {
    int32_t row;      /* a whole field, as Q16.16 holds 32767 of them and a flight goes on; */
    q16 x, z, height; /* fields: z beyond that one, 0..1 */
    q16 phase;        /* degrees of the swaying */
} flight;

static void fly(flight *f)
{
    f->phase = q16_mod(f->phase + Q16(2.5), Q16(360));
    f->x += q16_sin_deg(f->phase) / 8;
    f->z += Q16(.3);
    f->row += q16_to_int_floor(f->z);
    f->z = q16_mod(f->z, Q16(1));
    int32_t column = q16_to_int_floor(f->x);
    q16 ground = 0;
    for (int32_t ahead = 0; ahead < 6; ahead++) {
        ground = q16_max(ground, height_at(column, f->row + ahead));
    }
    f->height += q16_mul(ground + Q16(2.6) - f->height, Q16(.08));
}

/* What draws land: colours of the vertices in fog. */
QTRI_PIPELINE(land_pipeline, .format = QTRI_RGB565_SWAPPED, .depth = QTRI_LINEAR16,
              .compare = QTRI_LESS, .shade = QTRI_COLORS, .fog = 1)
static const qtri_pipeline *const pipelines[] = {&land_pipeline, NULL};

enum qtri_error example_run(void)
{
    enum { FAR = AHEAD - 3 };
    static const qtri_fog_range range = {Q16(.2), Q16(40), false};
    qtri_fog haze;
    qtri_fog_linear(&haze, sky, range, Q16(8), Q16(FAR));
    qtri_mesh land = {0};
    land.positions = positions;
    land.colors = colors;
    land.triangles = (const uint16_t(*)[3])triangles;
    land.vertex_count = VERTICES;
    land.triangle_count = TRIANGLES;
    qtri_material material = qtri_material_default();
    material.fog = &haze;
    make_triangles();

    qtri_screen screen;
    qtri_prepared prepared;
    qtri_view view;
    enum qtri_error error = example_display(&screen.panel);
    if (error == QTRI_OK) {
        error =
            qtri_screen_begin(&screen, &qtri_rgb565_swapped, ROWS, band_memory, sizeof band_memory);
    }
    if (error != QTRI_OK) {
        return error;
    }
    screen.background = sky;
    qtri_prepared_init(&prepared, mesh_memory, sizeof mesh_memory);
    qtri_view_init_pipelines(&view, screen.frame.width, screen.frame.height, pipelines);
    qtri_view_perspective(&view, Q16(50), range.near_z, range.far_z);

    int32_t made_column = 0, made_row = 0; /* of the land that was made last: none yet */
    flight now = {60, Q16(4), 0, Q16(6), 0};
    do {
        qtri_transform still;
        qtri_surface band;
        fly(&now);
        int32_t column = q16_to_int_floor(now.x);
        qtri_vec3 eye = {now.x - column * Q16(1), now.height, -now.z};
        q16 bank = -8 * q16_cos_deg(now.phase); /* degrees: into the turn */
        qtri_vec3 center = {eye.x + q16_sin_deg(now.phase) / 4, eye.y - Q16(.3), eye.z - Q16(1)};
        qtri_vec3 up = {-q16_sin_deg(bank), q16_cos_deg(bank), 0};
        if (column != made_column || now.row != made_row) {
            make_land(column, now.row);
            made_column = column;
            made_row = now.row;
        }
        qtri_view_look_at(&view, eye, center, up);
        qtri_transform_identity(&still);
        qtri_prepare_mesh(&prepared, &screen.frame, &view, &still, &land, &material);
        while (qtri_screen_next(&screen, &band)) {
            qtri_draw_prepared(&band, &prepared);
        }
    } while (screen.error == QTRI_OK && example_next_frame(&screen.panel));
    return screen.error;
}
