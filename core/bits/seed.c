/* SPDX-License-Identifier: MIT */
#include "seed.h"

/*
 * A cubic with the least relative error on [1/4, 1], 2^-7.1, and Newton's step y (3 - v y^2) / 2
 * with a 3 that centres the error as qtri_reciprocal_seed does.
 */
uint32_t qtri_rsqrt_seed(uint32_t t)
{
    uint32_t p_q13 = 51036u - ((19976u * t) >> 16);
    p_q13 = 48422u - ((p_q13 * t) >> 16);
    uint32_t y_q14 = 50993u - ((p_q13 * t) >> 15);           /* < 2^15 (1 + 2^-7) */
    uint32_t unit_q30 = ((y_q14 * y_q14) >> 14) * t;         /* v y^2, close to 1 */
    return (y_q14 * ((3221310472u - unit_q30) >> 15)) >> 15; /* Q14 Q16, < 2^31.1 */
}
