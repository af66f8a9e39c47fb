/* SPDX-License-Identifier: MIT */
/*
 * Every argument of functions of one argument, and of what Newton's steps are in, built with the
 * sanitizer for undefined behaviour: it ends the program where there is any. What intervals cannot
 * prove (*_values.c) is proved by trying, and what is specified there of it is held here.
 *
 *     math_inputs NAME     one of the names below, in seconds or a minute; without: the names
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "bits/bits.h"
#include "math/q16_trig.h"
#include "qtri/q16.h"

/* Whose own functions no other file sees. */
#include "../../core/math/q16_trig.c" /* NOLINT(bugprone-suspicious-include) */
#include "../../core/math/unit.c"     /* NOLINT(bugprone-suspicious-include) */

#define TURN ((int64_t)360 * 65536)

static volatile uint32_t sink; /* so that no call is left out */

static void hold(bool kept)
{
    if (!kept) {
        __builtin_trap();
    }
}

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

/* 2^62 / x, rounded down. */
static q16 reciprocal(q16 x)
{
    const uint32_t divisor = (uint32_t)x;
    const uint32_t result = qtri_reciprocal_q62(divisor);
    hold(((uint64_t)1 << 62) - (uint64_t)divisor * result < divisor);
    return (q16)(result ^ (uint32_t)qtri_reciprocal_below(divisor) ^ qtri_reciprocal_near(divisor));
}

/* What specified.h says of seeds. */
static q16 seed(q16 x)
{
    const uint32_t result = qtri_reciprocal_seed_newton((uint32_t)x);
    hold(result >= 32767 && result <= 65536);
    return (q16)result;
}

static q16 seed_of_angle(q16 x)
{
    const uint32_t result = reciprocal_less_one_q16((uint32_t)x);
    hold(result <= 65535);
    return (q16)result;
}

/*
 * A root of 64 bits: its signed steps are of the upper half after the zeros before it are gone,
 * x, and of the lower half as far as what is left over after the first half of the root: the less
 * of it the more of those bits, which both ends enclose.
 */
static q16 root_of_64_bits(q16 x)
{
    const uint64_t least = (uint64_t)(uint32_t)x << 32;
    uint64_t rest;
    uint32_t root = qtri_sqrt64_floor(least, &rest);
    hold(rest <= 2 * (uint64_t)root && (uint64_t)root * root + rest == least);
    sink ^= root;
    root = qtri_sqrt64_floor(least + UINT32_MAX, &rest);
    hold(rest <= 2 * (uint64_t)root && (uint64_t)root * root + rest == least + UINT32_MAX);
    return (q16)root;
}

/*
 * What qtri_unit normalises by: r of the length in x. A component times r is r sqrt((x + 1) 2^32)
 * at most, which is held to 2^63 + 5 2^32; with 30 fraction bits, rounded, that is 2^30 + 3.
 */
static q16 root_of_unit(q16 x)
{
    const uint32_t r = reciprocal_root_q31((uint32_t)x);
    const uint64_t square = (uint64_t)r * r;
    const uint64_t more = (uint64_t)(uint32_t)x + 1;
    const uint64_t high = (square >> 32) * more + (((square & UINT32_MAX) * more) >> 32);
    hold(high < ((uint64_t)1 << 62) + ((uint64_t)5 << 32));
    return (q16)r;
}

/* The sine and cosine of rotations; the angle is first taken modulo a turn. */
static q16 rotation(q16 x)
{
    const int32_t one = (int32_t)1 << 30;
    int32_t sine;
    int32_t cosine;
    qtri_sincos_deg_q30(x, &sine, &cosine);
    hold(sine >= -one && sine <= one && cosine >= -one && cosine <= one);
    return sine ^ cosine;
}

/*
 * A number as text: its whole part and its fraction are written apart, so that all of one with few
 * of the other are all there is to try. In memory of every size.
 */
static q16 text_of(q16 x)
{
    const q16 numbers[6] = {x, -x, x + Q16(32767), x % 32768 * 65536, x % 32768 * -65536, Q16_MIN};
    char text[QTRI_Q16_TEXT_SIZE];
    q16 read = 0;
    for (int i = 0; i < 6; i++) {
        for (size_t size = 0; size <= sizeof text; size++) {
            const int32_t length = q16_to_string(numbers[i], text, size);
            hold(length < (int32_t)size);
        }
        hold(q16_from_string(text, &read) > 0 && read == numbers[i]);
    }
    return read;
}

static const struct {
    const char *name;
    q16 (*function)(q16);
    int64_t first, last;
} functions[] = {{"sqrt", q16_sqrt, INT32_MIN, INT32_MAX},
                 {"rsqrt", q16_rsqrt, INT32_MIN, INT32_MAX},
                 {"recip", q16_recip, INT32_MIN, INT32_MAX},
                 {"exp", q16_exp, INT32_MIN, INT32_MAX},
                 {"exp2", q16_exp2, INT32_MIN, INT32_MAX},
                 {"log", q16_log, INT32_MIN, INT32_MAX},
                 {"log2", q16_log2, INT32_MIN, INT32_MAX},
                 {"sin", q16_sin, INT32_MIN, INT32_MAX},
                 {"cos", q16_cos, INT32_MIN, INT32_MAX},
                 {"sin_deg", q16_sin_deg, INT32_MIN, INT32_MAX},
                 {"cos_deg", q16_cos_deg, INT32_MIN, INT32_MAX},
                 {"tan", q16_tan, INT32_MIN, INT32_MAX},
                 {"tan_deg", q16_tan_deg, INT32_MIN, INT32_MAX},
                 /* Beyond 1 they are what they are at 1. */
                 {"asin", q16_asin, -65537, 65537},
                 {"acos", q16_acos, -65537, 65537},
                 {"asin_deg", q16_asin_deg, -65537, 65537},
                 {"acos_deg", q16_acos_deg, -65537, 65537},
                 {"atan", q16_atan, INT32_MIN, INT32_MAX},
                 {"atan_deg", q16_atan_deg, INT32_MIN, INT32_MAX},
                 {"pow", base_of_pow, INT32_MIN, INT32_MAX},
                 {"atan2", longer_side, INT32_MIN, INT32_MAX},
                 {"floor", whole_parts, INT32_MIN, INT32_MAX},
                 {"reciprocal", reciprocal, (int64_t)1 << 31, UINT32_MAX},
                 {"root64", root_of_64_bits, (int64_t)1 << 30, UINT32_MAX},
                 {"seed", seed, 32768, 65536},
                 {"seed_of_angle", seed_of_angle, 32768, 65536},
                 {"root_of_unit", root_of_unit, (int64_t)1 << 30, UINT32_MAX},
                 {"to_string", text_of, 0, 65535},
                 {"rotation", rotation, -TURN, TURN}};

int main(int argc, char **argv)
{
    int tried = 0;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        if (argc < 2) {
            (void)puts(functions[i].name);
        } else if (strcmp(argv[1], functions[i].name) == 0) {
            for (int64_t x = functions[i].first; x <= functions[i].last; x++) {
                sink ^= (uint32_t)functions[i].function((q16)(uint32_t)(x & UINT32_MAX));
            }
            tried++;
        }
    }
    return argc > 1 && tried == 0;
}
