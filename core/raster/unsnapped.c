/* SPDX-License-Identifier: MIT */
#include "unsnapped.h"

#include "../bits/bits.h"

bool qtri_unsnapped_matters(const qtri_raster *raster, const qtri_triangle *triangle,
                            const uint32_t depth_16p16[3])
{
    if (raster->samples != NULL) {
        return false; /* five jobs a triangle would pay for it */
    }
    if (raster->texture != NULL) {
        return true;
    }
    uint32_t least;
    uint32_t greatest;
    qtri_find_range(&least, &greatest, depth_16p16);
    const uint32_t depth = (greatest - least) >> 14; /* in quarters of a step */
    const uint32_t range = depth > 4 * 255 ? depth : 4 * 255;
    return qtri_mul_u32(range, (uint32_t)triangle->extent) > qtri_magnitude64(triangle->area);
}

bool qtri_attributes_matter(const qtri_raster *raster, const qtri_triangle *triangle,
                            const qtri_attributes v[3])
{
    const uint32_t depth[3] = {v[0].depth_16p16, v[1].depth_16p16, v[2].depth_16p16};
    return qtri_unsnapped_matters(raster, triangle, depth);
}

/* The true differences of vertex i from vertex 0, in 1/128 of 1/256 pixel: |.| <= 2^30 + 2^7. */
static void true_difference(int32_t d_q7[2], const qtri_triangle *t, const qtri_attributes v[3],
                            int i)
{
    d_q7[0] = (t->p[i]->x_24p8 - t->p[0]->x_24p8) * 128 + ((v[i].rest[0] - v[0].rest[0]) >> 9);
    d_q7[1] = (t->p[i]->y_24p8 - t->p[0]->y_24p8) * 128 + ((v[i].rest[1] - v[0].rest[1]) >> 9);
}

/* The triangle's area with the true places: |rest| <= 2^15, so four products of 2^23 2^16. */
static int64_t true_area(const qtri_triangle *t, const qtri_attributes v[3])
{
    const int32_t dx1 = t->p[1]->x_24p8 - t->p[0]->x_24p8;
    const int32_t dy1 = t->p[1]->y_24p8 - t->p[0]->y_24p8;
    const int32_t dx2 = t->p[2]->x_24p8 - t->p[0]->x_24p8;
    const int32_t dy2 = t->p[2]->y_24p8 - t->p[0]->y_24p8;
    const int32_t rx1 = v[1].rest[0] - v[0].rest[0];
    const int32_t ry1 = v[1].rest[1] - v[0].rest[1];
    const int32_t rx2 = v[2].rest[0] - v[0].rest[0];
    const int32_t ry2 = v[2].rest[1] - v[0].rest[1];
    const int64_t more = qtri_mul_s32(dx1, ry2) - qtri_mul_s32(dy1, rx2) + qtri_mul_s32(rx1, dy2) -
                         qtri_mul_s32(ry1, dx2);
    return t->area + (more >> 16);
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
 * times 2^36 is that numerator times r 2^-(62 + 16 + 7 + 32 - zeros - down - 36). What is cut off D
 * is 2^-15 of the greatest weight or less. That shift is 2 at least, of an area of 1 and the
 * longest sides, down = 16; and 53 at most: 2^(64 - zeros) is 4 d^2 or less, and d < 2^(15 + down -
 * 7).
 */
void qtri_unsnapped_init(qtri_unsnapped *u, const qtri_raster *raster, const qtri_triangle *t,
                         const qtri_attributes v[3])
{
    int32_t d[2][2];
    u->is_on = false;
    int32_t any = 0;
    for (int i = 0; i < 3; i++) {
        any |= v[i].rest[0] | v[i].rest[1];
    }
    if (any == 0 || !qtri_attributes_matter(raster, t, v)) {
        return;
    }
    const int64_t area = true_area(t, v);
    if (area == 0 || (area < 0) != (t->area < 0)) {
        return;
    }
    uint32_t all = 0;
    for (int i = 0; i < 2; i++) {
        true_difference(d[i], t, v, i + 1);
        all |= qtri_magnitude32(d[i][0]) | qtri_magnitude32(d[i][1]);
    }
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
        if (!set_weight(&u->b1[i], x * d[1][1] - y * d[1][0], r, shift) ||
            !set_weight(&u->b2[i], y * d[0][0] - x * d[0][1], r, shift)) {
            return;
        }
    }
    u->is_on = true;
}

int64_t qtri_unsnapped_less(const qtri_unsnapped *u, const uint32_t f[3], int i, int up)
{
    const int32_t f1 = (int32_t)(((int64_t)f[1] - f[0]) >> 2); /* |.| <= 2^30 */
    const int32_t f2 = (int32_t)(((int64_t)f[2] - f[0]) >> 2);
    const int64_t sum = qtri_mul_s32(f1, u->b1[i]) + qtri_mul_s32(f2, u->b2[i]); /* < 2^61 */
    const int32_t down = QTRI_UNSNAPPED_LOG2 - 2 - up;
    return (sum + ((int64_t)1 << (down - 1))) >> down;
}

bool qtri_unsnapped_move(uint32_t f[3], const qtri_unsnapped *u, uint32_t least, uint32_t greatest)
{
    if (!u->is_on) {
        return false;
    }
    uint32_t moved[3];
    bool any = false;
    for (int i = 0; i < 3; i++) {
        const int64_t value = (int64_t)f[i] - qtri_unsnapped_less(u, f, i, 0);
        const int64_t held = value < (int64_t)least ? (int64_t)least : value;
        moved[i] = (uint32_t)(held > (int64_t)greatest ? (int64_t)greatest : held);
        any |= value != (int64_t)moved[i];
    }
    for (int i = 0; i < 3; i++) {
        f[i] = moved[i];
    }
    return any;
}

void qtri_unsnapped_move_inside(uint32_t f[3], const qtri_unsnapped *u)
{
    uint32_t least;
    uint32_t greatest;
    qtri_find_range(&least, &greatest, f);
    (void)qtri_unsnapped_move(f, u, least, greatest);
}

void qtri_unsnapped_plane(qtri_plane *plane, const qtri_gradient *gradient, const qtri_unsnapped *u,
                          const uint32_t f[3])
{
    const uint32_t above = u->is_on ? (uint32_t)1 << 30 : 0;
    uint32_t moved[3] = {f[0] + above, f[1] + above, f[2] + above};
    (void)qtri_unsnapped_move(moved, u, 0, UINT32_MAX);
    qtri_plane_init(plane, gradient, moved);
    plane->origin -= (uint64_t)above << 16;
}
