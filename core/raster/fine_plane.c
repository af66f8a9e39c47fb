/* SPDX-License-Identifier: MIT */
#include "fine_plane.h"

bool qtri_divisor_init(qtri_divisor *a, const qtri_gradient *g, int32_t extent)
{
    const uint64_t size = qtri_magnitude64(g->area);
    if (size >> 6 <= (uint64_t)(uint32_t)extent) {
        return false;
    }
    a->negative = g->area < 0;
    a->zeros = qtri_clz64(size) - 1;
    a->size = size << a->zeros;
    a->reciprocal = qtri_reciprocal_below((uint32_t)(a->size >> 31) | 0x80000000u);
    a->wide = extent >> 22 != 0 ? 2 : 0;
    return true;
}

/*
 * numerator 2^30 / area, modulo 2^64: long division by digits of up to 26 bits. With R the
 * remainder, |R| < size, and w the upper 32 bits of size 2^1, r = 2^62 / w:
 *
 *     digit = R 2^s / size = (R 2^-32) r / 2^(61 - s)
 *
 * to nearest is within 1/2, and 2^-4 each for what is cut off R and r and 2^-5 for w: the next
 * remainder is at most .66 size, and a digit past the last one may be of either sign.
 */
static uint64_t divide(int64_t numerator, const qtri_divisor *a)
{
    int64_t rest = a->negative ? -numerator : numerator;
    uint64_t quotient = 0;
    int32_t bits = 30 + a->zeros + a->wide;
    while (bits > 0) {
        const int32_t s = bits < 26 ? bits : 26;
        const int32_t down = 61 - s;
        const int64_t product = qtri_mul_s32((int32_t)(rest >> 32), a->reciprocal);
        const int64_t digit = (product + ((int64_t)1 << (down - 1))) >> down;
        rest = qtri_wrap64(((uint64_t)rest << s) - (uint64_t)digit * a->size);
        quotient = (quotient << s) + (uint64_t)digit;
        bits -= s;
    }
    return quotient;
}

/* d pixels times 256 from a vertex: what the plane's step adds there. */
static uint64_t along(uint64_t step, int32_t d)
{
    const uint64_t part = (uint64_t)((qtri_wrap64(step) >> 8) * (d & 255));
    return step * (uint64_t)(int64_t)(d >> 8) + part;
}

/*
 * f1 and f2, the differences from vertex 0, are at most 2^39; the vertices' at most 2^22, or 2^23
 * where f has lost two bits: numerators are at most 2^62.
 */
void qtri_fine_plane_init(qtri_fine_plane *plane, const qtri_gradient *g, const qtri_divisor *a,
                          const int64_t f_q8[3])
{
    const int64_t f1 = (f_q8[1] - f_q8[0]) >> a->wide;
    const int64_t f2 = (f_q8[2] - f_q8[0]) >> a->wide;
    plane->dx = divide(f1 * g->dy2 - f2 * g->dy1, a);
    plane->dy = divide(f2 * g->dx1 - f1 * g->dx2, a);
    plane->origin = ((uint64_t)f_q8[0] << 22) + along(plane->dx, 128 - g->x_24p8) +
                    along(plane->dy, 128 - g->y_24p8);
}
