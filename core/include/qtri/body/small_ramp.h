/* SPDX-License-Identifier: MIT */
/*
 * Linear values ("ramps") and edges of a small triangle. Internal, part of the pipelines' body
 * (pipeline_make.h).
 */
#ifndef QTRI_BODY_SMALL_RAMP_H
#define QTRI_BODY_SMALL_RAMP_H

#include "arithmetic.h"
#include "pixel.h"
#include "small_triangle.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    QTRI_SMALL_FAR = 256 * QTRI_SMALL_REACH,
    QTRI_SMALL_NEAR = 1 << 13,  /* 32 pixels: within it in all four needs one comparison */
    QTRI_SMALL_NEEDLE = 4,      /* steps go left by so many bits at most: 1/16 pixel */
    QTRI_SMALL_STEEP_LOG2 = 18, /* depths of vertices differ by less than 2^18, 16.8 */
    QTRI_SMALL_STEEP_DOWN = 3,  /* and by 2^16 or more lose so many bits */
    QTRI_SMALL_TEXEL_LOG2 = 4,  /* texture coordinates are off by 2^-4 texel at most */
    QTRI_SMALL_ONE = 1 << 15    /* full light */
};

/* Set-up is inlined where code need not be small. */
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && !defined(QTRI_PIPELINE_IS_ANY)
#define QTRI_SMALL_IN_PLACE    true
#define QTRI_SMALL_SETUP(name) qtri_setup_##name
#else
#define QTRI_SMALL_IN_PLACE    false
#define QTRI_SMALL_SETUP(name) qtri_small_##name
#endif

/* A ramp is inlined too where long products are instructions: it is no longer than its call. */
#if QTRI_LONG_MULTIPLY
#define QTRI_SMALL_RAMP qtri_setup_ramp_set_at
#else
#define QTRI_SMALL_RAMP QTRI_SMALL_SETUP(ramp_set_at)
#endif

/* What was stored before is read again after: GCC 12 would keep it in registers it has not. */
#if defined(__GNUC__)
#define QTRI_BODY_READ_AGAIN() __asm__ volatile("" ::: "memory")
#else
#define QTRI_BODY_READ_AGAIN() ((void)0)
#endif

/* Inlined as well; with -Os where the compiler decides so. */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_SMALL_PART static inline
#else
#define QTRI_SMALL_PART QTRI_BODY
#endif

/* -1 where x is negative, or 0. */
QTRI_BODY int32_t qtri_small_sign(int32_t x)
{
    return x >> 31; // cppcheck-suppress shiftTooManyBitsSigned
}

/* |x|; of a negative x one less. */
QTRI_BODY uint32_t qtri_small_abs(int32_t x)
{
    return (uint32_t)(x ^ qtri_small_sign(x));
}

/* The least, and the greatest, of 0, a and b. */
QTRI_BODY int32_t qtri_small_min0(int32_t a, int32_t b)
{
    a &= qtri_small_sign(a);
    return a < b ? a : b;
}

QTRI_BODY int32_t qtri_small_max0(int32_t a, int32_t b)
{
    a &= ~qtri_small_sign(a);
    return a > b ? a : b;
}

/* The greatest of 0, a and b less the least. */
QTRI_SMALL_PART uint32_t qtri_small_range(int32_t a, int32_t b)
{
    return (uint32_t)qtri_small_max0(a, b) - (uint32_t)qtri_small_min0(a, b);
}

QTRI_BODY int32_t qtri_small_clamp(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : (x > high ? high : x);
}

/* Ramps ---------------------------------------------------------------------------------------- */

/* n 2^16 / size by p->inverse, rounded down: see small_setup.h. |n| < 2^30.95. */
QTRI_BODY int32_t qtri_small_quotient(const qtri_small_place *p, int32_t n)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(((int64_t)n * p->inverse) >> 32) >> p->down;
#else
    const uint32_t low = qtri_low16((uint32_t)n) * (uint32_t)p->inverse;
    return ((n >> 16) * p->inverse + (int32_t)(low >> 16)) >> (p->down + 1);
#endif
}

/* floor((gx x + gy y) / 256), |x|, |y| < 2^16, modulo 2^32. */
QTRI_BODY uint32_t qtri_small_along(int32_t gx, int32_t x, int32_t gy, int32_t y)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((int64_t)gx * x + (int64_t)gy * y) >> 8);
#else
    const int32_t rest = (gx & 255) * x + (gy & 255) * y; /* < 2^24 */
    const uint32_t whole = (uint32_t)(gx >> 8) * (uint32_t)x + (uint32_t)(gy >> 8) * (uint32_t)y;
    return whole + (uint32_t)(rest >> 8);
#endif
}

/*
 * A ramp that begins at x and y from vertex 0, 24.8, is `value` at that vertex, and more by f1 and
 * f2 at vertices 1 and 2, in units of 2^(8 + up): |f| <= 2^16, of a wide triangle 2^15.
 */
void qtri_small_ramp_set_at(qtri_small_ramp *r, const qtri_small_place *p, int32_t x, int32_t y,
                            uint32_t value, int32_t f1, int32_t f2, int32_t up);
QTRI_BODY void qtri_setup_ramp_set_at(qtri_small_ramp *r, const qtri_small_place *p, int32_t x,
                                      int32_t y, uint32_t value, int32_t f1, int32_t f2, int32_t up)
{
    const int32_t gx = qtri_small_quotient(p, f2 * p->dy1 - f1 * p->dy2);
    const int32_t gy = qtri_small_quotient(p, f1 * p->dx2 - f2 * p->dx1);
    const uint32_t at = qtri_small_along(gx, x, gy, y);
    up += p->up; /* last: a needle's steps may wrap, but not before they are divided */
    r->at = value + (at << up);
    r->dx = (uint32_t)gx << up;
    r->dy = (uint32_t)gy << up;
}

/* A ramp that begins at the base. */
QTRI_SMALL_PART void qtri_small_ramp_set(qtri_small_ramp *r, const qtri_small_place *p,
                                         uint32_t value, int32_t f1, int32_t f2, int32_t up)
{
    QTRI_SMALL_RAMP(r, p, p->x, p->y, value, f1, f2, up);
}

/* Rows ----------------------------------------------------------------------------------------- */

/*
 * Stores an edge's columns in rows up to `stop`; returns their sum. 32 bits of numerators are
 * right: they are a row's column, 2 REACH at most, times the denominator, REACH 256 256 at most,
 * and a part: below 2^30.9.
 */
QTRI_SMALL_PART int32_t qtri_small_walk_edge(uint8_t *side, const uint8_t *stop, uint32_t numerator,
                                             int32_t step, int32_t denominator)
{
    int32_t sum = 0;
#if QTRI_DIVIDE
    uint32_t rest = numerator;
#else
    int32_t rest = (int32_t)numerator, quotient = QTRI_SMALL_REACH;
#endif
    do {
#if QTRI_DIVIDE
        const int32_t quotient = (int32_t)(rest / (uint32_t)denominator);
        rest += (uint32_t)step;
#else
        /* A pixel or two a row: cheaper than a division. */
        while (rest < 0) {
            rest += denominator;
            quotient--;
        }
        while (rest >= denominator) {
            rest -= denominator;
            quotient++;
        }
        rest += step;
#endif
        sum += quotient;
        *side = (uint8_t)quotient;
        side += 2;
        QTRI_BODY_BARRIER(side);
    } while (side != stop);
    return sum;
}

/* x dy + y dx, in 32 bits. */
QTRI_BODY uint32_t qtri_small_cross(int32_t x, int32_t y, int32_t dx, int32_t dy)
{
    return (uint32_t)x * (uint32_t)dy + (uint32_t)y * (uint32_t)dx;
}

/*
 * Stores an edge's columns between rows `from` and `to`: on the left when it goes down. Returns
 * their sum, negative on the right. `cross`: with a division, counted from REACH left of vertex 0.
 */
QTRI_SMALL_PART int32_t qtri_small_edge(uint8_t *spans, int32_t dx, int32_t dy, uint32_t cross,
                                        int32_t from, int32_t to)
{
    const int32_t step = dx * 256;
    if (from < to) {
        return qtri_small_walk_edge(&spans[2 * from], &spans[2 * to],
                                    cross + (uint32_t)from * (uint32_t)step - 1, step, dy * 256);
    }
    if (from > to) {
        return -qtri_small_walk_edge(&spans[2 * to + 1], &spans[2 * from + 1],
                                     0u - cross - (uint32_t)to * (uint32_t)step - 1, -step,
                                     dy * -256);
    }
    return 0;
}

/* floor(2^31 / x) for x in [2^15, 2^16]. */
QTRI_BODY uint32_t qtri_small_reciprocal(uint32_t x)
{
#if QTRI_DIVIDE
    return 0x80000000u / x;
#else /* as core/bits/bits.h */
    const uint32_t r_q14 = 46260u - ((x * 30840u) >> 16);
    const uint32_t r_q15 = (r_q14 * (131192u - ((x * r_q14) >> 14))) >> 15;
    const int32_t error_q31 = (int32_t)(0x80000000u - x * r_q15);
    uint32_t y = r_q15 + (uint32_t)(((int32_t)r_q15 * (error_q31 >> 7)) >> 24);
    int32_t rest = (int32_t)(0x80000000u - x * y); /* 0..5/4 x */
    while (rest >= (int32_t)x) {
        rest -= (int32_t)x;
        y++;
    }
    return y;
#endif
}

#ifdef __cplusplus
}
#endif

#endif
