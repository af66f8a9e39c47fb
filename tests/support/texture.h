/* SPDX-License-Identifier: MIT */
/*
 * What the tests of textures share: triangles with texture coordinates, the coordinates at a pixel
 * in double precision, and a quad that shows a texture once.
 */
#ifndef QTRI_TESTS_SUPPORT_TEXTURE_H
#define QTRI_TESTS_SUPPORT_TEXTURE_H

#include <math.h>

#include "core.h"
#include "shares.h"

enum { WIDTH = 40, HEIGHT = 36 };

static inline void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, int32_t reach,
                                   int32_t uv_reach)
{
    for (int i = 0; i < 3; i++) {
        const int32_t y = random_in(seed, HEIGHT * 128 - reach, HEIGHT * 128 + reach);
        const int32_t x = random_in(seed, WIDTH * 128 - reach, WIDTH * 128 + reach);
        v[i] = screen_at(x, y);
        v[i].u_q32 = (int64_t)random_in(seed, -uv_reach, uv_reach) * 65536;
        v[i].v_q32 = (int64_t)random_in(seed, -uv_reach, uv_reach) * 65536;
        v[i].inv_w_q31 = 0x80000000u >> random_in(seed, 0, 3);
    }
}

/* u, or with `second` v, at the centre of a pixel. */
static inline double perspective_sum(const qtri_screen_vertex v[3], int32_t x, int32_t y,
                                     bool perspective, bool second)
{
    double b[3], sum = 0;
    shares_at(b, v, x, y, perspective);
    for (int i = 0; i < 3; i++) {
        sum += b[i] * ldexp((double)(second ? v[i].v_q32 : v[i].u_q32), -32);
    }
    return sum;
}

/*
 * What a coordinate of a texture of `side` texels may be off by at a pixel, in texels: 1/256, or,
 * of t > 1 texels a pixel, t / 256, as vertices lie on a grid of 1/256 pixel themselves.
 */
static inline double coordinate_unit(const qtri_screen_vertex v[3], int32_t x, int32_t y,
                                     bool perspective, bool second, int side)
{
    const double here = perspective_sum(v, x, y, perspective, second);
    const double right = perspective_sum(v, x + 1, y, perspective, second);
    const double below = perspective_sum(v, x, y + 1, perspective, second);
    const double t = (fabs(right - here) + fabs(below - here)) * side;
    return fmax(1, t) / 256;
}

/* The whole canvas, u and v from 0 to 1, in one colour. */
static inline void draw_quad(const canvas *c, const qtri_material *m, const int level[3])
{
    qtri_screen_vertex q[4] = {screen_at(0, 0), screen_at(WIDTH * 256, 0),
                               screen_at(WIDTH * 256, HEIGHT * 256), screen_at(0, HEIGHT * 256)};
    for (int i = 0; i < 4; i++) {
        q[i].u_q32 = i == 1 || i == 2 ? (int64_t)1 << 32 : 0;
        q[i].v_q32 = i >= 2 ? (int64_t)1 << 32 : 0;
        for (int channel = 0; channel < 3; channel++) {
            q[i].color_8p16[channel] = level[channel] << 16;
        }
    }
    qtri_screen_vertex second[3] = {q[0], q[2], q[3]};
    qtri_raster_triangle(&c->surface, qtri_pipelines_default, m, q);
    qtri_raster_triangle(&c->surface, qtri_pipelines_default, m, second);
}

#endif
