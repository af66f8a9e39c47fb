/* SPDX-License-Identifier: MIT */
#include "descriptions.h"

#include "qtri/body/small_triangle.h"

#include "../bits/bits.h"
#include "triangle.h"

/* |f1 d2 - f2 d1|: f below 2^32, d at most 2^24, so below 2^57. */
static uint64_t determinant(int64_t f1, int64_t f2, int32_t d1, int32_t d2)
{
    return qtri_magnitude64(f1 * d2 - f2 * d1);
}

/* What depth changes by a pixel to the right or down, whichever is more: 16.16, held to 2^47. */
static uint64_t slope_of(const qtri_point *const p[3], int64_t area, const uint32_t depth[3])
{
    const int64_t f1 = (int64_t)depth[1] - depth[0];
    const int64_t f2 = (int64_t)depth[2] - depth[0];
    const uint64_t along_x =
        determinant(f1, f2, p[1]->y_24p8 - p[0]->y_24p8, p[2]->y_24p8 - p[0]->y_24p8);
    const uint64_t along_y =
        determinant(f1, f2, p[1]->x_24p8 - p[0]->x_24p8, p[2]->x_24p8 - p[0]->x_24p8);
    const uint64_t most = (uint64_t)1 << 47;
    bool half;
    const uint64_t slope =
        qtri_divide64(along_x > along_y ? along_x : along_y, qtri_magnitude64(area), 8, &half);
    return slope < most ? slope : most;
}

/* What is added to the depths of all three vertices, modulo 2^32. */
static uint32_t shift_of(const qtri_material *material, const qtri_point *const p[3], int64_t area,
                         const uint32_t depth[3])
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    uint32_t least, greatest;
    qtri_find_range(&least, &greatest, depth);
    const uint64_t slope = slope_of(p, area, depth);
    const q16 factor = material->depth_slope;
    const uint32_t size = qtri_magnitude32(factor);
    const bool nearer = factor < 0;
    const uint32_t room = nearer ? least : farthest - greatest;
    const uint64_t by = slope >> 32 != 0 ? qtri_mul_u32((uint32_t)(slope >> 16), size)
                                         : qtri_mul_u32((uint32_t)slope, size) >> 16;
    const uint32_t less = by < room ? (uint32_t)by : room;
    return nearer ? 0 - less : less;
}

/* The vertices' copies have other depths; the light that they are given is given back. A vertex's
   depth has 8 bits of fraction, so the shift loses 2^-8 of a step of 16 bits. */
static bool draw_small(qtri_small *t)
{
    qtri_vertex *const vertex[3] = {t->v[0], t->v[1], t->v[2]};
    const qtri_point *const p[3] = {&vertex[0]->at, &vertex[1]->at, &vertex[2]->at};
    const int64_t area = qtri_triangle_area(p[0], p[1], p[2]);
    qtri_vertex moved[3];
    uint32_t depth[3];
    if (area == 0) {
        return true;
    }
    for (int i = 0; i < 3; i++) {
        depth[i] = vertex[i]->depth_16p8 & ~0xFFu;
    }
    const uint32_t by = shift_of(t->state->material, p, area, depth) & ~0xFFu;
    for (int i = 0; i < 3; i++) {
        moved[i] = *vertex[i];
        moved[i].depth_16p8 += by;
        t->v[i] = &moved[i];
    }
    const bool is_drawn = t->state->pipeline->small(t);
    for (int i = 0; i < 3; i++) {
        t->v[i] = vertex[i];
        if (moved[i].intensity_q15 != vertex[i]->intensity_q15) {
            vertex[i]->intensity_q15 = moved[i].intensity_q15;
        }
    }
    return is_drawn;
}

const qtri_depth_shift qtri_slope_bias = {draw_small, shift_of};
