/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"
#include "qtri/error.h"

#include "../bits/bits.h"
#include "eighths.h"
#include "../bits/multiply.h"

#define EIGHTH_TURN 0x20000000u

/*
 * Turns are in Q32 and wrap.
 *
 * 2^15 / pi for a radian: at 2^31 units the rounding of its fraction is a quarter of the last
 * place, and what is cut off is one, 2^-29.3 radians: .0001 ULP.
 */
static inline uint32_t turns_of_radians(q16 radians)
{
    uint32_t size = qtri_magnitude32(radians);
    return size * 10430u + qtri_mul_high31(size, 1625002897u);
}

/*
 * 2^16 / 360 = 182 + 2/45 for a degree. The exact result to nearest, so that angles a whole turn
 * apart are the same, negative ones too: an exact fraction is a multiple of 1/45, at least 1/90
 * from a half, and 2/45 in Q35 is less than 2^-5 of its last place too small: 2^-9 for 2^31 units.
 */
static inline uint32_t turns_of_degrees(q16 degrees)
{
    uint32_t size = qtri_magnitude32(degrees);
    return size * 182u + ((qtri_mul_high31(size, 1527099483u) + 4) >> 3);
}

static inline q16 rounded_q30(uint32_t size_q30, uint32_t negative)
{
    q16 result = (q16)((size_q30 + 0x2000u) >> 14);
    return negative ? -result : result;
}

/* A quarter of a turn begins an eighth before its right angle. */
static inline uint32_t eighths_q31(uint32_t shifted, uint32_t *negative)
{
    uint32_t rest = shifted & (2 * EIGHTH_TURN - 1);
    *negative = rest < EIGHTH_TURN;
    return (*negative ? EIGHTH_TURN - rest : rest - EIGHTH_TURN) << 2;
}

static q16 sine_of_turns(uint32_t turn, uint32_t negative)
{
    uint32_t shifted = turn + EIGHTH_TURN;
    uint32_t before;
    uint32_t w_q31 = eighths_q31(shifted, &before);
    negative ^= shifted >> 31;
    if ((shifted & 0x40000000u) != 0) {
        return rounded_q30(qtri_cosine_of_eighths_q30(w_q31), negative);
    }
    return rounded_q30(qtri_sine_of_eighths_q30(w_q31), negative ^ before);
}

static void sincos_of_turns(uint32_t turn, uint32_t negative, q16 *sine, q16 *cosine)
{
    uint32_t shifted = turn + EIGHTH_TURN;
    uint32_t before;
    uint32_t w_q31 = eighths_q31(shifted, &before);
    uint32_t quarter = shifted >> 30;
    uint32_t half = quarter >> 1;
    q16 s = rounded_q30(qtri_sine_of_eighths_q30(w_q31), before);
    q16 c = rounded_q30(qtri_cosine_of_eighths_q30(w_q31), 0);
    if ((quarter & 1) != 0) {
        q16 swap = s;
        s = c;
        c = -swap;
    }
    *sine = half != negative ? -s : s;
    *cosine = half ? -c : c;
}

q16 q16_sin(q16 radians)
{
    return sine_of_turns(turns_of_radians(radians), radians < 0);
}

q16 q16_cos(q16 radians)
{
    return sine_of_turns(turns_of_radians(radians) + 2 * EIGHTH_TURN, 0);
}

void q16_sincos(q16 radians, q16 *sine, q16 *cosine)
{
    QTRI_ASSERT(sine != NULL && cosine != NULL);
    sincos_of_turns(turns_of_radians(radians), radians < 0, sine, cosine);
}

q16 q16_sin_deg(q16 degrees)
{
    return sine_of_turns(turns_of_degrees(degrees), degrees < 0);
}

q16 q16_cos_deg(q16 degrees)
{
    return sine_of_turns(turns_of_degrees(degrees) + 2 * EIGHTH_TURN, 0);
}

void q16_sincos_deg(q16 degrees, q16 *sine, q16 *cosine)
{
    QTRI_ASSERT(sine != NULL && cosine != NULL);
    sincos_of_turns(turns_of_degrees(degrees), degrees < 0, sine, cosine);
}
