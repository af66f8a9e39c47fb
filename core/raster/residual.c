/* SPDX-License-Identifier: MIT */
#include "residual.h"

static bool is_visible(const qtri_gradient *g, const qtri_large_vertex v[3], int32_t extent)
{
    const uint32_t depth[3] = {v[0].depth_16p16, v[1].depth_16p16, v[2].depth_16p16};
    uint32_t min, max;
    qtri_find_range(&min, &max, depth);
    const uint32_t quarters = (max - min) >> 14;
    const uint32_t range = quarters > 4 * 255 ? quarters : 4 * 255;
    return qtri_mul_u32(range, (uint32_t)extent) > qtri_magnitude64(g->area);
}

/* True differences of vertex i from vertex 0, in 1/128 of 1/256 pixel: |.| <= 2^30 + 2^7. */
static void true_difference(int32_t d_q7[2], int32_t dx, int32_t dy, const qtri_large_vertex v[3],
                            int i)
{
    d_q7[0] = dx * 128 + ((v[i].rest[0] - v[0].rest[0]) >> 9);
    d_q7[1] = dy * 128 + ((v[i].rest[1] - v[0].rest[1]) >> 9);
}

/* The area between the true places: |rest| <= 2^15, so four products of 2^23 2^16. */
static int64_t true_area(const qtri_gradient *g, const qtri_large_vertex v[3])
{
    const int32_t rx1 = v[1].rest[0] - v[0].rest[0];
    const int32_t ry1 = v[1].rest[1] - v[0].rest[1];
    const int32_t rx2 = v[2].rest[0] - v[0].rest[0];
    const int32_t ry2 = v[2].rest[1] - v[0].rest[1];
    const int64_t more = qtri_mul_s32(g->dx1, ry2) - qtri_mul_s32(g->dy1, rx2) +
                         qtri_mul_s32(rx1, g->dy2) - qtri_mul_s32(ry1, g->dx2);
    return g->area + (more >> 16);
}

/* For |weights| < 2^30. */
static bool set_weight(int32_t *b, int32_t numerator, int32_t r, int32_t shift)
{
    const int64_t value = qtri_mul_s32(numerator, r) >> shift;
    *b = (int32_t)value;
    return qtri_magnitude64(value) < (uint64_t)1 << 30;
}

/*
 * With r = 2^62 / a, the area being a 2^(32 - zeros), and D = d 2^(7 - down) in 15 bits:
 *
 *     b1 = (rest x Dy2 - rest y Dx2) 2^-16 2^(down - 7) / area
 *
 * times 2^36 is that numerator times r 2^-(62 + 16 + 7 + 32 - zeros - down - 36). What D loses is
 * 2^-15 of the greatest weight or less. The shift is 2 at least, of an area of 1 and the longest
 * sides, down = 16; and 53 at most: 2^(64 - zeros) is 4 d^2 or less, and d < 2^(15 + down - 7).
 */
void qtri_residual_init(qtri_residual *residual, const qtri_gradient *g,
                        const qtri_large_vertex v[3], bool textured, int32_t extent)
{
    int32_t d[2][2];
    int32_t any = 0;
    residual->is_on = false;
    for (int i = 0; i < 3; i++) {
        any |= v[i].rest[0] | v[i].rest[1];
    }
    if (any == 0 || !(textured || is_visible(g, v, extent))) {
        return;
    }
    const int64_t area = true_area(g, v);
    if (area == 0 || (area < 0) != (g->area < 0)) {
        return;
    }
    true_difference(d[0], g->dx1, g->dy1, v, 1);
    true_difference(d[1], g->dx2, g->dy2, v, 2);
    const uint32_t all = qtri_magnitude32(d[0][0]) | qtri_magnitude32(d[0][1]) |
                         qtri_magnitude32(d[1][0]) | qtri_magnitude32(d[1][1]);
    const int32_t down = 17 - qtri_clz32(all | 1);
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            d[i][k] = down >= 0 ? d[i][k] >> down : d[i][k] * ((int32_t)1 << -down);
        }
    }
    const uint64_t size = qtri_magnitude64(area);
    const int32_t zeros = qtri_clz64(size);
    const int32_t shift = 81 - zeros - down;
    int32_t r = qtri_reciprocal_below((uint32_t)(size << zeros >> 32) | 0x80000000u);
    r = area < 0 ? -r : r;
    for (int i = 0; i < 3; i++) { /* |rest| <= 2^15, |D| <= 2^15: |numerator| < 2^31 */
        const int32_t x = v[i].rest[0];
        const int32_t y = v[i].rest[1];
        if (!set_weight(&residual->b1[i], x * d[1][1] - y * d[1][0], r, shift) ||
            !set_weight(&residual->b2[i], y * d[0][0] - x * d[0][1], r, shift)) {
            return;
        }
    }
    residual->is_on = true;
}

int64_t qtri_residual_correction(const qtri_residual *residual, const uint32_t f[3], int i, int up)
{
    const int32_t f1 = (int32_t)(((int64_t)f[1] - f[0]) >> 2); /* |.| <= 2^30 */
    const int32_t f2 = (int32_t)(((int64_t)f[2] - f[0]) >> 2);
    const int64_t sum =
        qtri_mul_s32(f1, residual->b1[i]) + qtri_mul_s32(f2, residual->b2[i]); /* < 2^61 */
    const int32_t down = QTRI_RESIDUAL_LOG2 - 2 - up;
    return (sum + ((int64_t)1 << (down - 1))) >> down;
}

bool qtri_residual_apply(uint32_t f[3], const qtri_residual *residual, uint32_t min, uint32_t max)
{
    uint32_t moved[3];
    bool any = false;
    if (!residual->is_on) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        const int64_t value = (int64_t)f[i] - qtri_residual_correction(residual, f, i, 0);
        const int64_t low = value < (int64_t)min ? (int64_t)min : value;
        moved[i] = (uint32_t)(low > (int64_t)max ? (int64_t)max : low);
        any |= value != (int64_t)moved[i];
    }
    for (int i = 0; i < 3; i++) {
        f[i] = moved[i];
    }
    return any;
}
