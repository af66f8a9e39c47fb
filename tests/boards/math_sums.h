/* SPDX-License-Identifier: MIT */
/*
 * Checksums of the mathematics over a sample of arguments: the same on every machine and compiler.
 */
#ifndef MATH_SUMS_H
#define MATH_SUMS_H

#include <stdint.h>

/* Not qtri.h: drawing is not for targets whose int has 16 bits. */
#include "qtri/mat.h"
#include "qtri/q16.h"
#include "qtri/quat.h"
#include "qtri/transform.h"
#include "qtri/vec.h"

/* One function under test; the board's console gets a line `name sum` for each. */
typedef struct math_case {
    const char *name;
    uint32_t (*add)(uint32_t sum, const q16 *arguments); /* the sum with one more result in it */
    uint8_t count;                                       /* of arguments, <= MATH_ARGUMENTS_MAX */
} math_case;

#define MATH_ARGUMENTS_MAX 32

/* A null name ends each list. */
extern const math_case math_function_cases[], math_transform_cases[];

/* FNV-1a by words, with the high bits folded back. */
static inline uint32_t math_mix(uint32_t sum, q16 value)
{
    sum = (sum ^ (uint32_t)value) * 16777619u;
    return sum ^ (sum >> 16);
}

/*
 * Writes the line of every function over more than `samples` samples, then `end <lines>`. With
 * more than four arguments a quarter of them serve, each being several results, and for transforms,
 * which take a hundred times as long, a sixteenth.
 */
#define MATH_WIDE_SHARE 4u
void math_sums_write(uint32_t samples);

#endif
