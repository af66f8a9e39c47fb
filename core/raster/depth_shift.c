/* SPDX-License-Identifier: MIT */
#include "depth_shift.h"

#include "effect.h"
#include "triangle.h"

/* |f1 d2 - f2 d1|: f below 2^32, d at most 2^24, so below 2^57. */
static uint64_t determinant(int64_t f1, int64_t f2, int32_t d1, int32_t d2)
{
    return qtri_magnitude64(f1 * d2 - f2 * d1);
}

/* What depth changes by a pixel to the right or down, whichever is more: 16.16, held to 2^47. */
static uint64_t slope_of(const qtri_triangle *t, const qtri_attributes v[3])
{
    const int64_t f1 = (int64_t)v[1].depth_16p16 - v[0].depth_16p16;
    const int64_t f2 = (int64_t)v[2].depth_16p16 - v[0].depth_16p16;
    const qtri_screen_point *const *p = t->p;
    const uint64_t along_x =
        determinant(f1, f2, p[1]->y_24p8 - p[0]->y_24p8, p[2]->y_24p8 - p[0]->y_24p8);
    const uint64_t along_y =
        determinant(f1, f2, p[1]->x_24p8 - p[0]->x_24p8, p[2]->x_24p8 - p[0]->x_24p8);
    const uint64_t most = (uint64_t)1 << 47;
    bool half;
    const uint64_t slope =
        qtri_divide64(along_x > along_y ? along_x : along_y, qtri_magnitude64(t->area), 8, &half);
    return slope < most ? slope : most;
}

static void draw_by_slope(const qtri_raster *raster, qtri_triangle *triangle,
                          const qtri_attributes v[3])
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    qtri_attributes moved[3] = {v[0], v[1], v[2]};
    uint32_t least = farthest;
    uint32_t greatest = 0;
    for (int i = 0; i < 3; i++) {
        least = v[i].depth_16p16 < least ? v[i].depth_16p16 : least;
        greatest = v[i].depth_16p16 > greatest ? v[i].depth_16p16 : greatest;
    }
    const uint64_t slope = slope_of(triangle, v);
    const q16 factor = raster->of.material->depth_slope;
    const uint32_t size = qtri_magnitude32(factor);
    const bool nearer = factor < 0;
    const uint32_t room = nearer ? least : farthest - greatest;
    const uint64_t by = slope >> 32 != 0 ? qtri_mul_u32((uint32_t)(slope >> 16), size)
                                         : qtri_mul_u32((uint32_t)slope, size) >> 16;
    const uint32_t less = by < room ? (uint32_t)by : room;
    for (int i = 0; i < 3; i++) {
        moved[i].depth_16p16 = nearer ? v[i].depth_16p16 - less : v[i].depth_16p16 + less;
    }
    if (qtri_by_vertex(raster) != NULL) {
        qtri_by_vertex(raster)->draw(raster, triangle, moved);
    } else {
        qtri_triangle_draw_plain(raster, triangle, moved);
    }
}

const qtri_depth_shift qtri_slope_bias = {draw_by_slope};
