/* SPDX-License-Identifier: MIT */
#include "sincos.h"

#include "../bits/bits.h"

/*
 * Taylor series on [0, pi/4] of the square, in Q31. The first terms left out are x^13 / 13! < 2^-37
 * and x^12 / 12! < 2^-33: below a rounding, so no minimax fit is needed.
 */
#define TERMS 5

static const uint32_t terms_q31[2][TERMS] = {{54u, 5918u, 426088u, 17895697u, 357913941u},
                                             {592u, 53261u, 2982616u, 89478485u, 0x40000000u}};

uint32_t qtri_mul_q31(uint32_t a, uint32_t b)
{
    return (uint32_t)((qtri_mul_u32(a, b) + 0x40000000u) >> 31);
}

/* c4 - square (c3 - square (...)) */
uint32_t qtri_series_q31(bool cosine, uint32_t square_q31)
{
    const uint32_t *c = terms_q31[cosine];
    uint32_t sum = c[0];
    for (int i = 1; i < TERMS; i++) {
        sum = c[i] - qtri_mul_q31(square_q31, sum);
    }
    return sum;
}
