/* SPDX-License-Identifier: MIT */
/*
 * Every argument of every function of one argument, and of what Newton's steps are in, built with
 * the sanitizer for undefined behaviour: it ends the program where there is any. What intervals
 * cannot prove (math_values.c) is proved by trying.
 *
 *     math_inputs NAME     one of the names below, in a minute or two; without: the names
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "bits/bits.h"
#include "bits/reciprocal.h"
#include "bits/seed.h"
#include "qtri/q16.h"
#include "qtri/q16_exp.h"
#include "qtri/q16_trig.h"

static volatile uint32_t sink; /* so that no call is left out */

/* q16_pow's logarithm has one argument, too, and the angle of atan2 divides by the longer side. */
static q16 base_of_pow(q16 x)
{
    return q16_pow(x, Q16_ONE);
}

static q16 longer_side(q16 x)
{
    return q16_atan2(1, x);
}

static q16 whole_parts(q16 x)
{
    return q16_floor(x) ^ q16_ceil(x) ^ q16_round(x);
}

/* The contract that math_values.c takes for granted. */
static q16 reciprocal(q16 x)
{
    const uint32_t divisor = (uint32_t)x | 0x80000000u;
    const uint32_t result = qtri_reciprocal_q62(divisor);
    if (result < 0x40000000u || result > 0x80000000u) {
        __builtin_trap();
    }
    return (q16)(result ^ (uint32_t)qtri_reciprocal_below(divisor) ^ qtri_reciprocal_near(divisor));
}

/* Likewise, what specified.h says of seeds: of 2^15..2^16. */
static q16 seed(q16 x)
{
    const uint32_t result = qtri_reciprocal_seed_newton(32768 + (uint32_t)x % 32769);
    if (result < 32767 || result > 65536) {
        __builtin_trap();
    }
    return (q16)result;
}

/* The upper half of 64 bits decides the seed of a root; the rest of it is unsigned. */
static q16 root_of_64_bits(q16 x)
{
    uint64_t rest;
    uint32_t root = qtri_sqrt64_floor((uint64_t)(uint32_t)x << 32, &rest);
    return (q16)(root ^ (uint32_t)rest);
}

static const struct {
    const char *name;
    q16 (*function)(q16);
} functions[] = {{"sqrt", q16_sqrt},
                 {"rsqrt", q16_rsqrt},
                 {"recip", q16_recip},
                 {"exp", q16_exp},
                 {"exp2", q16_exp2},
                 {"log", q16_log},
                 {"log2", q16_log2},
                 {"sin", q16_sin},
                 {"cos", q16_cos},
                 {"sin_deg", q16_sin_deg},
                 {"cos_deg", q16_cos_deg},
                 {"tan", q16_tan},
                 {"tan_deg", q16_tan_deg},
                 {"asin", q16_asin},
                 {"acos", q16_acos},
                 {"atan", q16_atan},
                 {"atan_deg", q16_atan_deg},
                 {"pow", base_of_pow},
                 {"atan2", longer_side},
                 {"floor", whole_parts},
                 {"reciprocal", reciprocal},
                 {"root64", root_of_64_bits},
                 {"seed", seed}};

int main(int argc, char **argv)
{
    int tried = 0;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        if (argc < 2) {
            (void)puts(functions[i].name);
        } else if (strcmp(argv[1], functions[i].name) == 0) {
            for (int64_t x = INT32_MIN; x <= INT32_MAX; x++) {
                sink ^= (uint32_t)functions[i].function((q16)x);
            }
            tried++;
        }
    }
    return argc > 1 && tried == 0;
}
