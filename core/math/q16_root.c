/* SPDX-License-Identifier: MIT */
/*
 * Roots of Q16.16.
 *
 * x is normalised by an even number of zeros to m in [2^30, 2^32), v = m / 2^32. The seed y is
 * 1 / sqrt(v) to 13 bits; one step of Newton's makes 24 of them, and the exact remainder decides.
 */
#include "qtri/q16.h"

#include "../bits/bits.h"
#include "../bits/seed.h"

/*
 * sqrt(x 2^16) = r 2^(8 - zeros/2), r = sqrt(m). s = v y 2^16 is r less e, |e| < 9; the step
 * m - s^2 = e (2 r - e), times y / 2^17, adds e. With e^2 / 2 r, e times y's error and what is cut
 * off, s_24 - 256 r is in (-1.5, .2): the root, rounded, is off by 1 at most.
 */
q16 q16_sqrt(q16 x)
{
    if (x <= 0) {
        QTRI_MATH_CHECK(x == 0);
        return 0;
    }
    int32_t zeros = qtri_clz32((uint32_t)x) & ~1;
    uint32_t m = (uint32_t)x << zeros;
    uint32_t y_q15 = qtri_rsqrt_seed(m >> 16);
    uint32_t s = ((m >> 16) * y_q15) >> 15;
    int32_t step = ((int32_t)(m - s * s) >> 5) * (int32_t)y_q15; /* < 2^(20 - 5 + 16) */
    uint32_t s_24 = (s << 8) + (uint32_t)(step >> 19);
    uint32_t root = (s_24 + (((uint32_t)1 << (zeros >> 1)) >> 1)) >> (zeros >> 1);

    /* (r + 1/2)^2 = r^2 + r + 1/4. The remainder is exact: modulo 2^32, and less than 2^26. */
    int32_t remainder = (int32_t)(((uint32_t)x << 16) - root * root);
    if (remainder > (int32_t)root) {
        root++;
    } else if (remainder <= -(int32_t)root) {
        root--;
    }
    return (q16)root;
}

/*
 * 2^24 / sqrt(x) = y 2^(8 + zeros/2), and with y in Q30 y_q30 / 2^(22 - zeros/2). With a seed of
 * error d < 2^-13.6, Newton's step y + y (1 - v y^2) / 2 is too small by 3/2 d^2, at most 19 units
 * of Q30, what is cut off takes 8 more: -28 < y_q30 - y <= 1. If both ends round alike that is the
 * result; else the greater one, r, is too large if (2 r - 1)^2 x > 2^50, which it never equals.
 */
q16 q16_rsqrt(q16 x)
{
    if (x <= 0) {
        QTRI_MATH_CHECK(false);
        return Q16_MAX;
    }
    int32_t zeros = qtri_clz32((uint32_t)x) & ~1;
    uint32_t m = (uint32_t)x << zeros;
    uint32_t y_q15 = qtri_rsqrt_seed(m >> 16);
    int32_t error_q30 = (int32_t)(0x40000000u - qtri_mul_high32(m, y_q15 * y_q15)); /* < 2^18 */
    uint32_t y_q30 = (y_q15 << 15) + (uint32_t)(((error_q30 >> 3) * (int32_t)y_q15) >> 13);

    int32_t shift = 22 - (zeros >> 1); /* 7..22 */
    uint32_t half = ((uint32_t)1 << shift) >> 1;
    uint32_t least = (y_q30 + half - 1) >> shift;
    uint32_t most = (y_q30 + half + 28) >> shift;
    if (least != most) {
        uint64_t square = qtri_mul_u32(2 * most - 1, 2 * most - 1); /* <= 2^50 */
        uint32_t high = qtri_mul_high32((uint32_t)(square & UINT32_MAX), (uint32_t)x) +
                        (uint32_t)(square >> 32) * (uint32_t)x; /* of a product below 2^51 */
        return (q16)(high >> 18 != 0 ? least : most);
    }
    return (q16)least;
}

/* a^2 + b^2 <= 2^63, in units of (1/65536)^2: its root is in ULP. */
q16 q16_hypot(q16 a, q16 b)
{
    uint64_t root = qtri_sqrt64_round((uint64_t)qtri_mul_s32(a, a) + (uint64_t)qtri_mul_s32(b, b));
    QTRI_MATH_CHECK(root <= (uint64_t)Q16_MAX);
    return root > (uint64_t)Q16_MAX ? Q16_MAX : (q16)root;
}
