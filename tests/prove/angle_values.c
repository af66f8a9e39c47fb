/* SPDX-License-Identifier: MIT */
/*
 * What Frama-C's Eva proves of tangents and of angles, as math_values.c does of the rest: for all
 * arguments nothing that C does not define.
 *
 * An angle's quotient begins with Newton's steps of 32769 possible divisors, a tangent's is by a
 * reciprocal: math_inputs.c tries both, here they are as specified.
 */
#include <stdint.h>

#include "__fc_builtin.h"

#include "bits/bits.h"
#include "math/q16_trig.h"
#include "qtri/q16.h"

#include "products.h"

/*@ requires x >= 0x80000000;
    assigns \result \from x;
    ensures 0x40000000 <= \result <= 0x4000000000000000 / x; */
uint32_t qtri_reciprocal_q62(uint32_t x);

/*@ assigns \result, *remainder \from x;
    ensures \initialized(remainder) && *remainder <= 2 * \result; */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder);

/*@ requires 32768 <= d_q16 <= 65536;
    assigns \result \from d_q16;
    ensures 0 <= \result <= 65535; */
static uint32_t reciprocal_less_one_q16(uint32_t d_q16);

/*@ assigns \result \from y, x, mirrored; */
uint32_t qtri_angle_q31(uint32_t y, uint32_t x, bool mirrored);

/* Whose own functions no other file sees. */
#include "../../core/math/q16_trig.c"

static uint32_t upto(uint32_t low, uint32_t high)
{
    return (uint32_t)Frama_C_unsigned_long_interval(low, high);
}

static q16 any(void)
{
    return (int32_t)Frama_C_long_interval(INT32_MIN, INT32_MAX);
}

/* The angle between any sides, by the bits of the longer one. */
// specified: qtri_sqrt64_floor,reciprocal_less_one_q16
void prove_angle(void)
{
    qtri_angle_q31(0, 0, Frama_C_interval(0, 1));
    //@ loop unroll 32;
    for (int bits = 0; bits < 32; bits++) {
        uint32_t one = (uint32_t)1 << bits;
        uint32_t most = one + (one - 1);
        qtri_angle_q31(upto(one, most), upto(one, most), Frama_C_interval(0, 1));
        qtri_angle_q31(upto(0, one - 1), upto(one, most), Frama_C_interval(0, 1));
        qtri_angle_q31(upto(one, most), upto(0, one - 1), Frama_C_interval(0, 1));
    }
}

/* What is made of that angle, whatever it is. */
// specified: qtri_sqrt64_floor,qtri_angle_q31
void prove_atan2(void)
{
    q16 y = any(), x = any();
    q16_atan2(y, x);
    q16_atan2_deg(y, x);
    q16_atan(x);
    q16_atan_deg(x);
}

// specified: qtri_sqrt64_floor,qtri_angle_q31
void prove_asin(void)
{
    q16 x = any();
    q16_asin(x);
    q16_acos(x);
    q16_asin_deg(x);
    q16_acos_deg(x);
}

/* Turns whose distance to a zero or a pole, rounded to Q48, is low..high. */
static void tangents(uint64_t low, uint64_t high)
{
    //@ loop unroll 8;
    for (int i = 0; i < 8; i++) {
        uint64_t size = Frama_C_unsigned_long_long_interval(low, high) << 16;
        uint64_t near = (uint64_t)((i + 1) / 2 % 2) << 63; /* 0, 1/2, 1/2, 1 half turns */
        uint64_t turn = (i & 1) == 0 ? near + size : near - size;
        if (i < 4) { /* what is rounded down to that, and what is rounded up */
            turn += Frama_C_unsigned_long_interval(0, 0x7FFF);
        } else {
            turn -= Frama_C_unsigned_long_interval(1, 0x8000);
        }
        tangent(1, turn);
        tangent(-1, turn);
    }
}

/* By the bits of that distance, which is an eighth of a turn at most. */
// specified: qtri_sqrt64_floor,qtri_reciprocal_q62
void prove_tan(void)
{
    tangents(0, 0);
    //@ loop unroll 46;
    for (int bits = 0; bits < 46; bits++) {
        uint64_t one = (uint64_t)1 << bits;
        tangents(one, one + (one - 1));
    }
    tangents((uint64_t)1 << 46, (uint64_t)1 << 46);
}

/* The turns themselves: of any angle some turn, of which tangents() has all. */
// specified: qtri_sqrt64_floor
void prove_tan_turns(void)
{
    q16 x = any();
    half_turns_q64(x, 0x517CC1B7u, 0x27220A95u, 0);
    half_turns_q64(x, 0xB60B60B6u, 0x0B60B60Bu, 7);
}
