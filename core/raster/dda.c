/* SPDX-License-Identifier: MIT */
#include "dda.h"

#include "qtri/config.h"

#include "../bits/bits.h"

/*
 * Quotient towards minus infinity, remainder in 0..divisor-1. Unsigned, floor(x / d) being
 * -1 - floor((-1 - x) / d): without an instruction that divides, so is the call for it.
 */
static int32_t divide_floor32(int32_t x, uint32_t divisor, uint32_t *remainder)
{
    uint32_t sign = x < 0 ? UINT32_MAX : 0;
    uint32_t magnitude = (uint32_t)x ^ sign;
    uint32_t quotient = magnitude / divisor;
    uint32_t rest = magnitude - quotient * divisor;
    *remainder = sign != 0 ? divisor - 1 - rest : rest;
    return (int32_t)(quotient ^ sign);
}

uint32_t qtri_divide_long(uint64_t x, uint32_t divisor, uint32_t *remainder)
{
    uint32_t rest = (uint32_t)(x >> 24);
    uint32_t quotient = rest / divisor;
    rest -= quotient * divisor;
    for (int shift = 16; shift >= 0; shift -= 8) {
        uint32_t next = rest << 8 | ((uint32_t)(x >> shift) & 0xFFu); /* < 2^31 */
        uint32_t digit = next / divisor;
        rest = next - digit * divisor;
        quotient = quotient << 8 | digit;
    }
    *remainder = rest;
    return quotient;
}

/* The same of x and 256 length: the low eight bits of x stay where they are. */
static int32_t divide_floor64(int64_t x, uint32_t length, uint32_t *remainder)
{
    uint32_t sign = x < 0 ? UINT32_MAX : 0;
    uint64_t magnitude = (uint64_t)(x < 0 ? ~x : x); /* < 2^47 */
    uint32_t rest;
    uint32_t quotient = qtri_divide_long(magnitude >> 8, length, &rest);
    rest = rest << 8 | (uint32_t)(magnitude & 0xFFu);
    *remainder = sign != 0 ? (length << 8) - 1 - rest : rest;
    return (int32_t)(quotient ^ sign);
}

void qtri_dda_init(qtri_dda *dda, int32_t start, int32_t delta, int32_t length, int32_t along,
                   int32_t bias)
{
    uint32_t rest = 0;
    int32_t fraction = start & 255;
    dda->denominator = (uint32_t)length << 8;
    dda->step = divide_floor32(delta, (uint32_t)length, &rest);
    dda->remainder_step = rest << 8;
    dda->value = start >> 8;
    const int32_t small = (int32_t)1 << 15;
    if (length < small && delta > -small && delta < small) {
        /* |256 2^15 + 2^30 + 2^22| < 2^31: the common, small triangle needs 32 bits only */
        dda->value += divide_floor32(fraction * length + along * delta + bias, dda->denominator,
                                     &dda->remainder);
    } else {
        int64_t numerator = qtri_mul_s32(along, delta) + qtri_mul_s32(fraction, length) + bias;
        dda->value += divide_floor64(numerator, (uint32_t)length, &dda->remainder);
    }
}
