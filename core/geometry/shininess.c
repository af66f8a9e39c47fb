/* SPDX-License-Identifier: MIT */
#include "illumination.h"

#include "qtri/q16_exp.h"
#include "qtri/error.h"

#define ONE_Q31 0x80000000u

/* a b, to nearest. */
static uint32_t mul_q31(uint32_t a, uint32_t b)
{
    return (uint32_t)((qtri_mul_u32(a, b) + ((uint32_t)1 << 30)) >> 31);
}

/*
 * x^shininess in Q15 for x <= 1. The whole part by squares: ten of them and ten products leave
 * 2^-25 of 1. The rest is an exponent below 1, which makes no error of x larger.
 */
static uint32_t power_q15(uint32_t x_q31, q16 shininess)
{
    uint32_t result = ONE_Q31;
    uint32_t square = x_q31;
    for (uint32_t whole = (uint32_t)shininess >> 16; whole != 0; whole >>= 1) {
        if ((whole & 1u) != 0) {
            result = mul_q31(result, square);
        }
        square = mul_q31(square, square);
    }
    const q16 rest = shininess & 0xFFFF;
    if (rest != 0) {
        const uint32_t x_q16 = (x_q31 + 0x4000u) >> 15;
        result = mul_q31(result, (uint32_t)q16_pow((q16)x_q16, rest) << 15);
    }
    return (result + 0x8000u) >> 16;
}

/*
 * Steps of t = 1 - n . h are a power of two, so that an index is a shift; the largest with which at
 * most 128 of them reach t = 6.93 / shininess, where the power is 2^-10. Between two values of a
 * convex function the line is above it, by an eighth of the second difference at most: half of that
 * is taken off everywhere.
 */
void qtri_shininess_init(qtri_shininess *table, q16 shininess)
{
    QTRI_ASSERT(table != NULL);
    enum { STEPS = 128, LEAST_LOG2 = 7, LEAST_Q15 = 32 };
    const q16 held = qtri_hold32(shininess, Q16_ONE, 1024 * Q16_ONE);
    uint32_t log2 = LEAST_LOG2;
    while ((uint32_t)held / 512 >= 7u << (log2 + 1)) { /* 2^16 / 2^9 = 128 */
        log2++;
    }
    const uint32_t step_q31 = ONE_Q31 >> log2;
    const uint32_t first = power_q15(ONE_Q31 - step_q31, held);
    const uint32_t second = power_q15(ONE_Q31 - 2 * step_q31, held);
    uint32_t at = ONE_Q31 >> 16;
    uint32_t before = 3 * (at - first) + second; /* so that it bends as at the next */
    uint32_t count = 0;
    for (; count < STEPS && at >= LEAST_Q15; count++) {
        const uint32_t after = power_q15(ONE_Q31 - (count + 1) * step_q31, held);
        const uint32_t bend = before + after + 1 - 2 * at; /* 0 or more: values are rounded */
        table->value_q15[count] = (uint16_t)(at - bend / 16);
        before = at;
        at = after;
    }
    table->value_q15[count] = (uint16_t)at;
    table->count = (uint8_t)count;
    const uint32_t least_q15 = (ONE_Q31 - count * step_q31) >> 16;
    table->least_q15 = (uint16_t)((least_q15 * least_q15) >> 15);
    table->shift = (uint8_t)(29 - log2);
}
