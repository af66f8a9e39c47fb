/* SPDX-License-Identifier: MIT */
#include "dda.h"

#include "qtri/config.h"

#include "../bits/bits.h"

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

/*
 * Quotient of x and 256 length towards minus infinity, remainder in 0 .. 256 length - 1. Unsigned,
 * floor(x / d) being -1 - floor((-1 - x) / d); the low eight bits of x stay where they are.
 */
static int32_t divide_floor(int64_t x, uint32_t length, uint32_t *remainder)
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
    const int64_t numerator = qtri_mul_s32(along, delta) + qtri_mul_s32(start & 255, length) + bias;
    const uint32_t size = (uint32_t)length;
    dda->denominator = size << 8;
    dda->step = divide_floor((int64_t)delta * 256, size, &dda->remainder_step);
    dda->value = (start >> 8) + divide_floor(numerator, size, &dda->remainder);
}
