/* SPDX-License-Identifier: MIT */
/*
 * What Frama-C's Eva proves of conversions and of what is inline in qtri/q16.h, as math_values.c
 * does of the arithmetic: for all arguments nothing that C does not define.
 */
#include <limits.h>
#include <stdint.h>

#include "__fc_builtin.h"

#include "bits/bits.h"
#include "qtri/q16.h"

#include "products.h"

/* root64 of math_inputs.c holds it. */
/*@ assigns \result, *remainder \from x;
    ensures \initialized(remainder) && *remainder <= 2 * \result; */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder);

static q16 any(void)
{
    return (int32_t)Frama_C_long_interval(INT32_MIN, INT32_MAX);
}

void prove_from_and_to(void)
{
    q16 x = any();
    int bits = Frama_C_interval(INT_MIN, INT_MAX);
    q16_from_int(x);
    q16_to_int_floor(x), q16_to_int_ceil(x), q16_to_int_round(x), q16_to_int_trunc(x);
    q16_from_fixed(x, bits), q16_to_fixed(x, bits);
    q16_from_q30(x), q16_to_q30(x), q16_from_q8(x), q16_to_q8(x);
}

void prove_choose(void)
{
    q16 a = any(), b = any(), c = any();
    q16_add_wrap(a, b), q16_sub_wrap(a, b), q16_neg_wrap(a);
    q16_min(a, b), q16_max(a, b), q16_clamp(a, b, c), q16_sign(a);
    q16_fract(a);
    q16_add_sat(a, b), q16_sub_sat(a, b), q16_mul_sat(a, b);
}

// specified: qtri_sqrt64_floor
void prove_hypot(void)
{
    q16_hypot(any(), any());
}
