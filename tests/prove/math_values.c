/* SPDX-License-Identifier: MIT */
/*
 * What Frama-C's Eva proves of the mathematics: for all arguments, no signed overflow, no shift by
 * too much or of a negative number to the left, no division by zero, no index beyond an array, and
 * the bounds below. `make prove` runs it, once for each way of multiplying and dividing.
 *
 * Arguments are split where intervals alone forget too much: by sign, or by leading zeros. What
 * Newton's steps need to know about their own errors is not an interval: the functions specified
 * here are tried with every argument by math_inputs.c instead.
 */
#include <stdint.h>

#include "__fc_builtin.h"

#include "bits/bits.h"
#include "qtri/q16.h"

#include "products.h"

/*@ requires x >= 0x80000000;
    assigns \result \from x;
    ensures 0x40000000 <= \result <= 0x80000000; */
uint32_t qtri_reciprocal_q62(uint32_t x);

/*@ requires 1 <= x <= 0x80000000;
    assigns \result \from x;
    ensures -16 * 8796093022208 <= \result < 16 * 8796093022208; */
static int64_t precise_log2_q43(uint32_t x);

/* q16_pow and the logarithm in it, which no other file sees. */
#include "../../core/math/q16_exp.c"

static q16 any(void)
{
    return (int32_t)Frama_C_long_interval(INT32_MIN, INT32_MAX);
}

/*
 * Piece `i` of PIECES: zero, the numbers of 1 to 31 bits, and those less than zero likewise. Of a
 * piece the leading zeros are known.
 */
enum { PIECES = 1 + 31 + 32 };

static q16 piece(int i)
{
    if (i == 0) {
        return 0;
    }
    if (i <= 31) {
        return (int32_t)Frama_C_long_interval((int32_t)1 << (i - 1),
                                              (int32_t)(((uint32_t)1 << i) - 1));
    }
    i -= 31;
    return i == 32 ? INT32_MIN
                   : (int32_t)Frama_C_long_interval(-(int32_t)(((uint32_t)1 << i) - 1),
                                                    -((int32_t)1 << (i - 1)));
}

/* Products and shifts that everything else is made of. */
// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_products(void)
{
    q16 a = any(), b = any();
    uint32_t c = (uint32_t)Frama_C_unsigned_long_interval(0, UINT32_MAX);
    uint32_t d = (uint32_t)Frama_C_unsigned_long_interval(0, UINT32_MAX);
    qtri_mul_s32(a, b);
    qtri_mul_u32(c, d);
    qtri_mul_high16(c, (uint32_t)Frama_C_unsigned_long_interval(0, 65535));
    qtri_mul_high32(c, d);
    qtri_mul_high31(c >> 1, d >> 1);
    qtri_mul_high_s30(a / 2, (int32_t)(c >> 3));
    qtri_mul_high_s31(a / 2, (int32_t)(c >> 1));
    //@ loop unroll 64;
    for (int i = 0; i < PIECES; i++) {
        uint32_t x = (uint32_t)piece(i);
        int32_t zeros = qtri_clz32(x | 1);
        /*@ assert 0 <= zeros <= 31; */
        zeros = qtri_clz64((uint64_t)x << 32 | 1);
        /*@ assert 0 <= zeros <= 63; */
    }
    qtri_shift_round(Frama_C_long_long_interval(-((int64_t)1 << 62) + 1, ((int64_t)1 << 62) - 1),
                     a);
    qtri_magnitude32(a);
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_add_sub(void)
{
    q16 a = any(), b = any();
    q16_add(a, b);
    q16_sub(a, b);
    q16_neg(a);
    q16_abs(a);
    q16 f = q16_fract(a);
    /*@ assert 0 <= f < 65536; */
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_mul(void)
{
    q16 a = any(), b = any();
    q16_mul(a, b);
    q16_mul_floor(a, b);
    q16_mul_wrap(a, b);
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_lerp(void)
{
    q16_lerp(any(), any(), any());
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_div(void)
{
    //@ loop unroll 64;
    for (int i = 0; i < PIECES; i++) {
        q16_div(any(), piece(i));
    }
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_mod(void)
{
    //@ loop unroll 64;
    for (int i = 0; i < PIECES; i++) {
        q16 b = piece(i);
        q16_mod((int32_t)Frama_C_long_interval(INT32_MIN, -1), b);
        q16_mod((int32_t)Frama_C_long_interval(0, INT32_MAX), b);
    }
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_muldiv(void)
{
    //@ loop unroll 64;
    for (int i = 0; i < PIECES; i++) {
        q16_muldiv(any(), any(), piece(i));
    }
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_sin(void)
{
    q16 x = any();
    q16 s = q16_sin(x), c = q16_cos(x);
    q16 s_deg = q16_sin_deg(x), c_deg = q16_cos_deg(x);
    /*@ assert -65536 <= s <= 65536 && -65536 <= c <= 65536; */
    /*@ assert -65536 <= s_deg <= 65536 && -65536 <= c_deg <= 65536; */
    q16_sincos(x, &s, &c);
    q16_sincos_deg(x, &s_deg, &c_deg);
    /*@ assert -65536 <= s <= 65536 && -65536 <= c <= 65536; */
    /*@ assert -65536 <= s_deg <= 65536 && -65536 <= c_deg <= 65536; */
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_exp(void)
{
    q16 r = q16_exp(any());
    /*@ assert r >= 0; */
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_exp2(void)
{
    q16 r = q16_exp2(any());
    /*@ assert r >= 0; */
}

static void logs_between(uint32_t low, uint32_t high)
{
    q16 x = (int32_t)Frama_C_long_interval((int32_t)low, (int32_t)high);
    q16 r = q16_log2(x);
    /*@ assert -16 * 65536 <= r <= 15 * 65536 + 64; */
    r = q16_log(x);
    /*@ assert -12 * 65536 <= r <= 11 * 65536; */
}

// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_log(void)
{
    q16 below = q16_log2((int32_t)Frama_C_long_interval(INT32_MIN, 0));
    /*@ assert below == Q16_MIN; */
    //@ loop unroll 31;
    for (int bits = 0; bits < 31; bits++) {
        uint32_t one = (uint32_t)1 << bits;
        //@ loop unroll 16;
        for (uint32_t i = 0; i < 16; i++) { /* the table's ranges */
            uint32_t low = one + (uint32_t)(((uint64_t)one * i) >> 4);
            uint32_t high = one + (uint32_t)(((uint64_t)one * (i + 1)) >> 4) - 1;
            if (low > high) {
                continue;
            }
            if (high != 65535) {
                logs_between(low, high);
                continue;
            }
            //@ loop unroll 11;
            for (int k = 0; k < 11;
                 k++) { /* 63489..65535: to 1, whose logarithm changes its sign */
                uint32_t step = (uint32_t)1 << k;
                logs_between(65537 - 2 * step, 65536 - step);
            }
            logs_between(63488, 63488);
        }
    }
}

/* precise_log2_q43 as specified. */
// specified: qtri_reciprocal_q62,precise_log2_q43
void prove_pow(void)
{
    //@ loop unroll 64;
    for (int i = 0; i < PIECES; i++) {
        q16_pow(piece(i), any());
    }
}

static void log_between(uint32_t low, uint32_t high)
{
    int64_t log_q43 = precise_log2_q43((uint32_t)Frama_C_unsigned_long_interval(low, high));
    /*@ assert -16 * 8796093022208 <= log_q43 < 16 * 8796093022208; */
}

/* precise_log2_q43 itself: by how far, in bits, x is from the powers of two on either side. */
// specified: qtri_reciprocal_q62
void prove_pow_log(void)
{
    log_between(0x80000000u, 0x80000000u);
    //@ loop unroll 31;
    for (int bits = 0; bits < 31; bits++) {
        uint32_t one = (uint32_t)1 << bits;
        log_between(one, one);
        //@ loop unroll 31;
        for (int i = 0; i < bits - 1; i++) { /* from 1 up to 1.5, from 2 down to 1.5 */
            uint32_t step = (uint32_t)1 << i;
            log_between(one + step, one + 2 * step - 1);
            log_between(2 * one - 2 * step + 1, 2 * one - step);
        }
        if (bits > 0) {
            log_between(one + one / 2, one + one / 2);
        }
    }
}
