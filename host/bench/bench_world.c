/* SPDX-License-Identifier: MIT */
#include "bench_world.h"

const bench_quad bench_screen = {{{Q16(-2.3070917), Q16(-1.7303188), 0},
                                  {Q16(2.3070917), Q16(-1.7303188), 0},
                                  {Q16(2.3070917), Q16(1.7303188), 0},
                                  {Q16(-2.3070917), Q16(1.7303188), 0}},
                                 Q16_ONE};
const bench_quad bench_floor = {{{Q16(-3), Q16(-1.2), Q16(2.0784610)},
                                 {Q16(3), Q16(-1.2), Q16(2.0784610)},
                                 {Q16(3), Q16(1.2), Q16(-2.0784610)},
                                 {Q16(-3), Q16(1.2), Q16(-2.0784610)}},
                                Q16_ONE};
const bench_quad bench_turned = {{{Q16(-1.1), Q16(-1.5), Q16(1.9052559)},
                                  {Q16(1.1), Q16(-1.5), Q16(-1.9052559)},
                                  {Q16(1.1), Q16(1.5), Q16(-1.9052559)},
                                  {Q16(-1.1), Q16(1.5), Q16(1.9052559)}},
                                 2 * Q16_ONE};

const qtri_light bench_light = {
    .towards = {Q16(.4), Q16(.6), Q16(.69282032)}, .ambient = Q16(.2), .diffuse = Q16(.8)};
const qtri_rgb bench_background = {24, 32, 48};
const qtri_rgb bench_lit_color = {255, 180, 90};

#define CUBE_HALF Q16(.15)

static const qtri_position16 cube_positions[8] = {{-32767, -32767, -32767}, {32767, -32767, -32767},
                                                  {-32767, 32767, -32767},  {32767, 32767, -32767},
                                                  {-32767, -32767, 32767},  {32767, -32767, 32767},
                                                  {-32767, 32767, 32767},   {32767, 32767, 32767}};
static const uint16_t cube_triangles[12][3] = {{4, 5, 7}, {4, 7, 6}, {1, 0, 2}, {1, 2, 3},
                                               {5, 1, 3}, {5, 3, 7}, {0, 4, 6}, {0, 6, 2},
                                               {6, 7, 3}, {6, 3, 2}, {0, 1, 5}, {0, 5, 4}};

const qtri_mesh bench_cube = {.positions16 = cube_positions,
                              .triangles = cube_triangles,
                              .vertex_count = 8,
                              .triangle_count = 12,
                              .extent = CUBE_HALF,
                              .bounds = {{0, 0, 0}, {CUBE_HALF, CUBE_HALF, CUBE_HALF}}};
const qtri_mesh bench_turned_away = {.positions16 = cube_positions,
                                     .triangles = &cube_triangles[2],
                                     .vertex_count = 3,
                                     .triangle_count = 1,
                                     .extent = CUBE_HALF,
                                     .bounds = {{0, 0, 0}, {CUBE_HALF, CUBE_HALF, CUBE_HALF}}};

/* A corner is a vertex of three faces. */
#define BOX    Q16(.5)
#define NORMAL 18918 /* 1 / sqrt 3 */
static const qtri_vec3 box_positions[8] = {{-BOX, -BOX, -BOX}, {BOX, -BOX, -BOX}, {-BOX, BOX, -BOX},
                                           {BOX, BOX, -BOX},   {-BOX, -BOX, BOX}, {BOX, -BOX, BOX},
                                           {-BOX, BOX, BOX},   {BOX, BOX, BOX}};
static const qtri_normal box_normals[8] = {{-NORMAL, -NORMAL, -NORMAL}, {NORMAL, -NORMAL, -NORMAL},
                                           {-NORMAL, NORMAL, -NORMAL},  {NORMAL, NORMAL, -NORMAL},
                                           {-NORMAL, -NORMAL, NORMAL},  {NORMAL, -NORMAL, NORMAL},
                                           {-NORMAL, NORMAL, NORMAL},   {NORMAL, NORMAL, NORMAL}};
static const qtri_vec2 box_uvs[8] = {
    {0, 0},       {Q16_ONE, 0}, {0, Q16_ONE}, {Q16_ONE, Q16_ONE}, {Q16_ONE, Q16_ONE},
    {0, Q16_ONE}, {Q16_ONE, 0}, {0, 0}};

const qtri_rgb bench_box_colors[8] = {{255, 0, 0},   {0, 255, 0},   {0, 0, 255},     {255, 255, 0},
                                      {255, 0, 255}, {0, 255, 255}, {255, 255, 255}, {20, 30, 40}};
const qtri_mesh bench_box = {.positions = box_positions,
                             .normals = box_normals,
                             .uvs = box_uvs,
                             .triangles = cube_triangles,
                             .vertex_count = 8,
                             .triangle_count = 12};

qtri_rgb bench_texel(uint32_t u, uint32_t v)
{
    uint8_t across = (uint8_t)(4 * u), down = (uint8_t)(4 * v);
    const qtri_rgb odd = {255, across, down};
    const qtri_rgb even = {down, 64, (uint8_t)(255 - across)};
    return ((u >> 3 ^ v >> 3) & 1) != 0 ? odd : even;
}

uint16_t bench_rgb565(qtri_rgb color)
{
    return (uint16_t)((color.r * 31 + 127) / 255 << 11 | (color.g * 63 + 127) / 255 << 5 |
                      (color.b * 31 + 127) / 255);
}

void bench_set_quad(qtri_corner corners[6], const bench_quad *quad, const qtri_rgb colors[4])
{
    static const uint8_t order[6] = {0, 1, 2, 0, 2, 3};
    for (uint32_t i = 0; i < 6; i++) {
        uint32_t from = order[i];
        const qtri_vec3 *p = &quad->position[from];
        const qtri_corner corner = {
            {p->x, p->y, p->z, Q16_ONE},
            colors[from],
            {from == 1 || from == 2 ? quad->repeats : 0, from <= 1 ? quad->repeats : 0}};
        corners[i] = corner;
    }
}

void bench_set_view(qtri_view *view, int32_t width, int32_t height)
{
    const qtri_vec3 eye = {0, 0, Q16(3)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
    qtri_view_init(view, width, height);
    qtri_transform_look_at(&view->camera, eye, center, up);
    qtri_transform_perspective(&view->projection, Q16(60), Q16(4.0 / 3.0), Q16(.1), Q16(100));
}

static uint32_t hash_add(uint32_t hash, uint32_t value, uint32_t bytes)
{
    for (uint32_t i = 0; i < bytes; i++) {
        hash = (hash ^ (value & 255)) * 16777619u;
        value >>= 8;
    }
    return hash;
}

/* What is stored, as numbers: the same in either byte order, and the bytes as they lie in memory in
 * the usual one. */
uint32_t bench_hash(const qtri_surface *surface)
{
    const qtri_pixels *pixels = surface->format->pixels;
    uint32_t hash = 2166136261u;
    for (int32_t y = 0; y < surface->rows; y++) {
        const uint8_t *row = surface->pixels + y * surface->pitch;
        for (int32_t x = 0; x < surface->width; x++) {
            hash = hash_add(hash, pixels->load(row + x * pixels->bytes), pixels->bytes);
        }
    }
    for (int32_t y = 0; y < surface->rows; y++) {
        const uint16_t *row = surface->depth + y * surface->depth_pitch;
        for (int32_t x = 0; x < surface->width; x++) {
            hash = hash_add(hash, row[x], 2);
        }
    }
    return hash;
}
