/* SPDX-License-Identifier: MIT */
/*
 * The elementary functions as a table: as the library has them, and as a core without a long
 * multiply compiles them.
 */
#ifndef QTRI_TESTS_SUPPORT_ELEMENTARY_H
#define QTRI_TESTS_SUPPORT_ELEMENTARY_H

#include <qtri/q16.h>

#define ELEMENTARY_SINGLE 16

typedef struct elementary_build {
    q16 (*single[ELEMENTARY_SINGLE])(q16 x);
    q16 (*pair[3])(q16 a, q16 b);
    void (*sincos[2])(q16 angle, q16 *sine, q16 *cosine);
} elementary_build;

/* Of the functions that have these names where it stands. */
#define ELEMENTARY_BUILD                                                                           \
    {                                                                                              \
        {q16_sin,  q16_cos,      q16_sin_deg, q16_cos_deg,  q16_tan,  q16_tan_deg,                 \
         q16_asin, q16_asin_deg, q16_acos,    q16_acos_deg, q16_atan, q16_atan_deg,                \
         q16_exp,  q16_exp2,     q16_log,     q16_log2},                                           \
            {q16_atan2, q16_atan2_deg, q16_pow},                                                   \
        {                                                                                          \
            q16_sincos, q16_sincos_deg                                                             \
        }                                                                                          \
    }

extern const elementary_build elementary_narrow_build;

#endif
