/* SPDX-License-Identifier: MIT */
#include "gradient.h"

#define SMALL ((int32_t)1 << 15) /* 128 pixels */

static uint32_t from_small(int32_t x)
{
    return (uint32_t)x + (uint32_t)SMALL;
}

void qtri_gradient_init(qtri_gradient *g, int32_t extent)
{
    g->inverse = 0;
    g->left = 0;
    g->reciprocal = 0;
    if ((from_small(g->dx1) | from_small(g->dy1) | from_small(g->dx2) | from_small(g->dy2)) >=
        2u * SMALL) {
        return;
    }
    uint32_t size = qtri_magnitude32((int32_t)g->area); /* < 2^31, not 0 */
    g->zeros = qtri_clz32(size);
    // NOLINTNEXTLINE(clang-analyzer-core.*): the area is not 0, nor is what fits 31 bits of it
    g->reciprocal = qtri_reciprocal_below(size << g->zeros) >> 1;
    if (!qtri_gradient_is_sliver(size, extent)) {
        qtri_gradient_set_inverse(g, g->reciprocal, g->zeros);
    }
}

/* numerator 2^16 / area, rounded, modulo 2^64. |numerator| < 2^57, |area| <= 2^47. */
QTRI_NOINLINE static uint64_t divide(int64_t numerator, int64_t area)
{
    bool half;
    uint64_t quotient =
        qtri_divide64(qtri_magnitude64(numerator), qtri_magnitude64(area), 16, &half);
    quotient += half;
    return (numerator < 0) == (area < 0) ? quotient : 0 - quotient;
}

/*
 * The same within 2 + 2^8 / |area| units for a small triangle, where |numerator| < 2^50: n r / 2^s,
 * s = 45 - zeros, from two products, for n of 30 and 20 bits. Its relative error, below 2^-28,
 * leaves a remainder of less than 2^(66 - 28), whose quotient is added but for its lowest 8 bits.
 */
QTRI_NOINLINE static uint64_t multiply(const qtri_gradient *g, int64_t numerator)
{
    int32_t r = g->reciprocal;
    int32_t s = 45 - g->zeros;
    uint32_t size = qtri_magnitude32((int32_t)g->area);
    int64_t high = qtri_mul_s32((int32_t)(numerator >> 20), r);
    uint64_t low = qtri_mul_u32((uint32_t)numerator & 0xFFFFF, (uint32_t)r); /* < 2^50 */
    uint64_t quotient = s >= 20 ? (uint64_t)((high + (int64_t)(low >> 20)) >> (s - 20))
                                : ((uint64_t)high << (20 - s)) + (low >> s);
    int64_t rest = qtri_wrap64(((uint64_t)numerator << 16) - quotient * size);
    int64_t more = qtri_mul_s32((int32_t)(rest >> 8), r) >> (53 - g->zeros);
    quotient += (uint64_t)more;
    return g->area < 0 ? 0 - quotient : quotient;
}

/* f's slope along one axis; d1 and d2: how far the vertices are apart along the other. */
QTRI_NOINLINE static uint64_t slope(const qtri_gradient *g, const uint32_t f[3], int32_t d1,
                                    int32_t d2)
{
    int64_t numerator = ((int64_t)f[1] - f[0]) * d2 - ((int64_t)f[2] - f[0]) * d1;
    return g->reciprocal != 0 ? multiply(g, numerator) : divide(numerator, g->area);
}

/* The plane through (vertex i, f[i]); its origin is (dx, dy) from vertex 0. */
static void plane_about(qtri_plane *plane, const qtri_gradient *g, const uint32_t f[3], int32_t dx,
                        int32_t dy)
{
    uint64_t per_x = slope(g, f, g->dy1, g->dy2);
    uint64_t per_y = slope(g, f, -g->dx1, -g->dx2);
    plane->origin =
        ((uint64_t)f[0] << 16) + per_x * (uint64_t)(int64_t)dx + per_y * (uint64_t)(int64_t)dy;
    plane->dx = per_x << 8;
    plane->dy = per_y << 8;
}

void qtri_plane_init(qtri_plane *plane, const qtri_gradient *g, const uint32_t f[3])
{
    plane_about(plane, g, f, 128 - g->x_24p8, 128 - g->y_24p8);
}

static uint32_t round_to_ramp(uint64_t value)
{
    return (uint32_t)(value >> 16) + ((uint32_t)value >> 15 & 1);
}

void qtri_ramp_divide(qtri_ramp *ramp, const qtri_gradient *g, const uint32_t f[3])
{
    qtri_plane plane;
    plane_about(&plane, g, f, g->anchor_dx, g->anchor_dy);
    ramp->origin = round_to_ramp(plane.origin) + 0x8000u;
    ramp->dx = round_to_ramp(plane.dx);
    ramp->dy = round_to_ramp(plane.dy);
}
