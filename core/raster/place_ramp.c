/* SPDX-License-Identifier: MIT */
#include "place_ramp.h"

#include "../bits/multiply.h"

/* Whether n can be shifted left and stays below 2^bits. */
static bool fits(int32_t nx, int32_t ny, int32_t left, int32_t bits)
{
    return (qtri_about(nx) | qtri_about(ny)) >> (bits - left) == 0;
}

/* By planes of 64 bits, of values from the least of the three on. */
static void divide(qtri_ramp *ramp, const qtri_place *p, uint32_t f0, int32_t f1, int32_t f2)
{
    qtri_gradient g;
    const uint32_t one = (uint32_t)1 << QTRI_PLACE_DOWN;
    const int32_t least = qtri_least_from_0(f1, f2);
    const uint32_t f[3] = {(uint32_t)-least * one, (uint32_t)(f1 - least) * one,
                           (uint32_t)(f2 - least) * one};
    const int32_t column = (128 - p->x) >> 8; /* the pixel at vertex 0: its steps are rounded */
    const int32_t row = (128 - p->y) >> 8;
    g.dx1 = p->dx1;
    g.dy1 = p->dy1;
    g.dx2 = p->dx2;
    g.dy2 = p->dy2;
    g.area = -(int64_t)p->size;
    g.anchor_dx = column * 256 + p->x;
    g.anchor_dy = row * 256 + p->y;
    g.reciprocal = 0;
    qtri_ramp_divide(ramp, &g, f);
    ramp->origin += f0 - f[0] - 0x8000u;
    ramp->origin -= (uint32_t)column * ramp->dx + (uint32_t)row * ramp->dy;
}

/*
 * n 2^16 / size of a steep attribute: in two parts of 2^9, each with the inverse of gradient.h,
 * which makes n 2^17 / size of n. The higher one's steps, below 2^25 with three bits more, are off
 * by half of 2^5, and 36 pixels right and 36 down by 2^10.2.
 */
static int32_t steep_step(int32_t high, int32_t low, int32_t inverse, int32_t left)
{
    const int32_t one = (int32_t)1 << left;
    return qtri_mul_high_s30(high * one * 8, inverse) * 32 +
           (qtri_mul_high_s30(low * one, inverse) >> 1) + 16;
}

QTRI_NOINLINE void qtri_place_ramp_any(qtri_ramp *ramp, const qtri_place *p, uint32_t f0,
                                       int32_t f1, int32_t f2)
{
    const int32_t zeros = qtri_clz32(p->size | 1u);
    if ((qtri_about(f1) | qtri_about(f2)) >> 16 == 0) { /* of inverses that go left: zeros > 14 */
        qtri_inverse by;
        const int32_t nx = qtri_place_nx(p, f1, f2);
        const int32_t ny = qtri_place_ny(p, f1, f2);
        const int32_t left = zeros - 14;
        if (fits(nx, ny, left, 30)) {
            const int32_t one = (int32_t)1 << left;
            qtri_inverse_init(&by, p->size);
            by.down += left;
            qtri_place_ramp_set(ramp, p, f0, qtri_inverse_step(&by, nx * one, by.down),
                                qtri_inverse_step(&by, ny * one, by.down));
            return;
        }
    } else {
        const int32_t part = 512;
        const int32_t nx = qtri_place_nx(p, f1 >> 9, f2 >> 9);
        const int32_t ny = qtri_place_ny(p, f1 >> 9, f2 >> 9);
        const int32_t mx = qtri_place_nx(p, f1 & (part - 1), f2 & (part - 1));
        const int32_t my = qtri_place_ny(p, f1 & (part - 1), f2 & (part - 1));
        int32_t left;
        const int32_t inverse =
            qtri_gradient_inverse(qtri_reciprocal_below(p->size << zeros) >> 1, zeros, &left);
        if (fits(nx, ny, left, 24) && fits(mx, my, left, 30)) {
            qtri_place_ramp_set(ramp, p, f0, steep_step(nx, mx, inverse, left),
                                steep_step(ny, my, inverse, left));
            return;
        }
    }
    divide(ramp, p, f0, f1, f2);
}
