/* SPDX-License-Identifier: MIT */
/*
 * What point and spot lights share. Internal.
 */
#ifndef QTRI_GEOMETRY_LIGHT_POINT_H
#define QTRI_GEOMETRY_LIGHT_POINT_H

#include "illumination.h"

#include "../bits/seed.h"

/* The way from a vertex to a source. */
typedef struct qtri_light_way {
    int32_t direction_q14[3];
    int32_t cosine_q28;  /* between the normal and the direction, > 0 */
    uint32_t distance16; /* below 2^16; times 2^exponent, in local units */
    int32_t exponent;
} qtri_light_way;

bool qtri_light_point_prepare(qtri_shine *out, const qtri_light_source *source,
                              const qtri_light_space *space);

/* point->place from source->at in one scale, where they have two: the finer one gives way. The
   exponent of the difference is returned. */
int32_t qtri_light_subtract_scaled(int32_t d[3], const qtri_shine *source,
                                   const qtri_lit_point *point);

/* fade, as a mantissa of up to 2^16 and a shift. */
typedef struct qtri_light_fade {
    uint32_t mantissa;
    int32_t shift; /* fade = mantissa 2^-(shift - 3), 15..28 */
} qtri_light_fade;

/*
 * False: the source is behind the surface or at the vertex itself.
 *
 * |d| <= 2^30; its largest part gets 15 bits, so q = d . d is in [2^28, 3 2^30]. With v = q 4^even
 * / 2^32 in [1/4, 1) and y = v^-1/2 in Q15, within 2^-13: |d| = 2^16 v y 2^-even / 2^15, and
 * d / |d| = d y 2^even / 2^31.
 */
QTRI_IN_PLACE bool qtri_light_way_find(qtri_light_way *way, const qtri_shine *source,
                                       const qtri_lit_point *point)
{
    int32_t d[3];
    int32_t exponent = point->exponent;
    if (source->of.far.exponent == exponent) {
        d[0] = source->at[0] - point->place[0];
        d[1] = source->at[1] - point->place[1];
        d[2] = source->at[2] - point->place[2];
    } else {
        exponent = qtri_light_subtract_scaled(d, source, point);
    }
    const uint32_t all =
        (uint32_t)((d[0] ^ (d[0] >> 31)) | (d[1] ^ (d[1] >> 31)) | (d[2] ^ (d[2] >> 31)));
    const int32_t zeros = qtri_clz32(all | 1u); /* >= 1 */
    d[0] = (int32_t)((uint32_t)d[0] << (zeros - 1)) >> 16;
    d[1] = (int32_t)((uint32_t)d[1] << (zeros - 1)) >> 16;
    d[2] = (int32_t)((uint32_t)d[2] << (zeros - 1)) >> 16;
    uint32_t square = (uint32_t)(d[0] * d[0]) + (uint32_t)(d[1] * d[1]) + (uint32_t)(d[2] * d[2]);
    if (square == 0) {
        return false;
    }
    int32_t even = 0;
    if (square >> 30 == 0) {
        square <<= 2;
        even = 1;
    }
    const uint32_t y_q15 = qtri_rsqrt_seed_in_place(square >> 16);
    const int32_t y_q14 = (int32_t)(y_q15 >> 1);
    const int32_t down = 16 - even;
    way->direction_q14[0] = (d[0] * y_q14) >> down;
    way->direction_q14[1] = (d[1] * y_q14) >> down;
    way->direction_q14[2] = (d[2] * y_q14) >> down;
    way->cosine_q28 = qtri_dot_q28(point->normal_q14, way->direction_q14);
    if (way->cosine_q28 <= 0) {
        return false;
    }
    way->distance16 = ((square >> 16) * y_q15) >> 15; /* <= 0xFFFD, of all v */
    way->exponent = exponent + 17 - zeros - even;
    return true;
}

/* x 2^shift, for shift < -1; 0 for x = 0, whose shift is NEVER. */
static inline uint32_t qtri_light_scaled(uint32_t x, int32_t shift)
{
    return shift <= -32 ? 0 : x >> -shift;
}

/*
 * False: less than 2^-10.
 *
 * The sum is color / fade in Q19: 2^15, for 16, to 2^29, for 2^-10. Factors have 16 bits, so a
 * product that is not 0 is 2^30 at least: without two bits to be cut off it is 2^29 or more.
 */
QTRI_IN_PLACE bool qtri_light_fade_find(qtri_light_fade *fade, const qtri_shine *source,
                                        const qtri_light_way *way)
{
    const uint32_t m = way->distance16;
    const int32_t linear_shift = source->of.far.linear_up + way->exponent;
    const int32_t quadratic_shift = source->of.far.quadratic_up + 2 * way->exponent;
    if (linear_shift >= -1 || quadratic_shift >= -1) {
        return false;
    }
    uint32_t sum_q19 = source->of.far.constant_q19;
    sum_q19 += qtri_light_scaled(source->of.far.linear * m, linear_shift);
    sum_q19 += qtri_light_scaled(source->of.far.quadratic * ((m * m) >> 16), quadratic_shift);
    if (sum_q19 >> 29 != 0) {
        return false;
    }
    sum_q19 = sum_q19 >> 15 == 0 ? (uint32_t)1 << 15 : sum_q19;
    const int32_t zeros = qtri_clz32(sum_q19); /* 3..16 */
    fade->mantissa = qtri_reciprocal_seed_newton((sum_q19 << zeros) >> 16);
    fade->shift = 31 - zeros;
    return true;
}

/*
 * h is the direction of l + v, |l + v| <= 2^15. Where its square is below 2^16 the source is
 * behind what is looked at, in line with the eye: no direction is good enough, and there is no
 * highlight. 4^up squares are in [2^28, 2^30].
 */
QTRI_IN_PLACE uint32_t qtri_light_highlight_q15(const qtri_lit_point *point,
                                                const int32_t direction_q14[3])
{
    int32_t h[3];
    h[0] = direction_q14[0] + point->by->view_q14[0];
    h[1] = direction_q14[1] + point->by->view_q14[1];
    h[2] = direction_q14[2] + point->by->view_q14[2];
    uint32_t square = (uint32_t)(h[0] * h[0]) + (uint32_t)(h[1] * h[1]) + (uint32_t)(h[2] * h[2]);
    if (square >> 16 == 0) {
        return 0;
    }
    /* Most points are outside of a highlight: (n . h)^2 tells, while it is precise. */
    const int32_t along_q15 = qtri_dot_q28(point->normal_q14, h) >> 14; /* <= |l + v| */
    if (along_q15 <= 0 ||
        (square >> 28 != 0 &&
         (uint32_t)(along_q15 * along_q15) < (square >> 15) * point->by->shininess->least_q15)) {
        return 0;
    }
    int32_t down = 16;
    for (; square >> 28 == 0; square <<= 2) {
        down--;
    }
    const uint32_t v_q16 = square >> 14;
    const int32_t y_q15 = (int32_t)qtri_rsqrt_seed_in_place(v_q16 > 0xFFFFu ? 0xFFFFu : v_q16);
    h[0] = (h[0] * y_q15) >> down;
    h[1] = (h[1] * y_q15) >> down;
    h[2] = (h[2] * y_q15) >> down;
    return qtri_shininess_at(point->by->shininess, qtri_apart_q29(point->normal_q14, h));
}

/* Adds what is reflected of it. */
QTRI_IN_PLACE void qtri_light_fade_add(qtri_lit_point *point, const qtri_shine *source,
                                       const qtri_light_way *way, const qtri_light_fade *fade)
{
    const uint32_t cosine_q15 = (uint32_t)way->cosine_q28 >> 13; /* <= 2^15 (1 + 2^-12) */
    qtri_light_add(point->diffuse_q24, source->color_q12,
                   (fade->mantissa * cosine_q15) >> fade->shift);
    if (point->by->shininess != NULL) {
        const uint32_t power_q15 = qtri_light_highlight_q15(point, way->direction_q14);
        if (power_q15 != 0) {
            qtri_light_add(point->specular_q24, source->color_q12,
                           (fade->mantissa * power_q15) >> fade->shift);
        }
    }
}

#endif
