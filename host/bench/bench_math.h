/* SPDX-License-Identifier: MIT */
/*
 * Counting the instructions of a call of each function of the mathematics, on an emulated core.
 */
#ifndef BENCH_MATH_H
#define BENCH_MATH_H

#include <stdint.h>

#include "qtri.h"

/*
 * What the arguments are like: absolute values from 2^-6 up, as many in every octave. Kinds with
 * two names are of the first, and the last argument of the second.
 */
enum bench_range {
    BENCH_SIGNED,   /* up to 2^8, both signs */
    BENCH_POSITIVE, /* up to 2^8 */
    BENCH_EXPONENT, /* up to 2^3, both signs: beyond 10 and 15, exp and exp2 only saturate */
    BENCH_SINE,     /* up to 1, both signs: what has an arc sine */
    BENCH_FRACTION, /* up to 1 */
    BENCH_SIGNED_FRACTION,
    BENCH_POSITIVE_EXPONENT,
    BENCH_QUATERNIONS,         /* of unit length */
    BENCH_QUATERNIONS_FRACTION /* the same */
};

/* One function. */
typedef struct bench_case {
    const char *name;
    void (*run)(const q16 *x, const q16 *end); /* calls it for every `words` arguments */
    uint8_t words;
    uint8_t range;
} bench_case;

extern const bench_case bench_cases[]; /* a null name ends it */

#endif
