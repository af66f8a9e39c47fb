/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"

#include "../bits/bits.h"
#include "sincos.h"

#define PI_Q30 3373259426u

/*
 * Half turns of 2^31 units at most, of half turns per Q16.16 unit in two words: high in Q48 + up,
 * low in Q80 + up.
 */
static inline uint64_t half_turns_q64(q16 x, uint32_t high, uint32_t low, int32_t up)
{
    uint32_t size = qtri_magnitude32(x);
    return (qtri_mul_u32(size, high) << (16 - up)) + (qtri_mul_u32(size, low) >> (16 + up));
}

/*
 * tan repeats after half a turn. Near a pole the distance to it counts: half turns per Q16.16
 * unit are kept in Q80, so that the argument's last bit and 2^31 units leave 2^-50 half turns.
 */
static q16 tangent(q16 x, uint64_t turn_q64)
{
    uint64_t shifted_q48 = ((turn_q64 + 0x8000u) >> 16) + ((uint64_t)1 << 46);
    bool pole = (shifted_q48 >> 47) & 1;
    int64_t rest_q48 = (int64_t)(shifted_q48 & (((uint64_t)1 << 47) - 1)) -
                       ((int64_t)1 << 46); /* from 0 or a pole */
    bool negative = (x < 0) != (rest_q48 < 0);
    uint64_t distance_q48 = qtri_magnitude64(rest_q48); /* <= 2^46: pi / 4 */
    int32_t zeros = qtri_clz64(distance_q48);           /* >= 17 */
    if (pole) {
        negative = rest_q48 == 0 ? x < 0 : (x < 0) == (rest_q48 < 0);
        if (zeros > 32) { /* within 2^-17 half turns: above 2^15 */
            QTRI_MATH_CHECK(false);
            return negative ? Q16_MIN : Q16_MAX;
        }
    }
    if (distance_q48 == 0) {
        return 0;
    }
    uint32_t radians_q31 = qtri_mul_high32((uint32_t)(distance_q48 >> 15), PI_Q30);
    uint32_t square_q31 = qtri_mul_q31(radians_q31, radians_q31);
    uint32_t cosine_q31 = qtri_cosine_q31(square_q31);
    /* The sine is m 2^-(14 + zeros), and m normalised. */
    uint32_t m = qtri_mul_high32((uint32_t)((distance_q48 << zeros) >> 32), PI_Q30);
    m = (uint32_t)(qtri_mul_u32(m, qtri_sine_ratio_q31(square_q31)) >> 31);
    if (m < 0x80000000u) {
        m <<= 1;
        zeros++;
    }
    uint64_t quotient;
    int32_t shift;
    if (pole) { /* 2^31 cos 2^62 / m */
        quotient = qtri_mul_u32(cosine_q31, qtri_reciprocal_q62(m));
        shift = 63 - zeros;
    } else { /* m 2^62 / (2^32 cos), where a cosine of 1 gives way to 1 - 2^-32 */
        uint32_t cosine_q32 = cosine_q31 < 0x80000000u ? cosine_q31 << 1 : UINT32_MAX;
        quotient = qtri_mul_u32(m, qtri_reciprocal_q62(cosine_q32));
        shift = 28 + zeros;
    }
    int64_t size_q16 = qtri_shift_round((int64_t)quotient, shift); /* quotient < 2^62.5 */
    return qtri_saturate32_checked(negative ? -size_q16 : size_q16);
}

q16 q16_tan(q16 radians)
{
    return tangent(radians, half_turns_q64(radians, 0x517CC1B7u, 0x27220A95u, 0)); /* 2^64 / pi */
}

/*
 * 2^71 / 180. In Q48 an exact result is a multiple of 1/45, at least 1/90 from a half, and what
 * 2^31 units lose here is 2^-9: angles half a turn apart are the same.
 */
q16 q16_tan_deg(q16 degrees)
{
    return tangent(degrees, half_turns_q64(degrees, 0xB60B60B6u, 0x0B60B60Bu, 7));
}
