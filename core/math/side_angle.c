/* SPDX-License-Identifier: MIT */
#include "atan.h"
#include "../bits/bits.h"

uint32_t qtri_side_angle_q31(q16 x, bool cosine)
{
    uint32_t size = qtri_magnitude32(x);
    QTRI_MATH_CHECK(size <= (uint32_t)Q16_ONE);
    size = size > (uint32_t)Q16_ONE ? (uint32_t)Q16_ONE : size;
    uint64_t square_q32 = ((uint64_t)1 << 32) - qtri_mul_u32(size, size);
    uint32_t root_q31 = (uint32_t)qtri_sqrt64_round(square_q32 << 30);
    size <<= 15;
    return cosine ? qtri_angle_q31(root_q31, size, x < 0) : qtri_angle_q31(size, root_q31, false);
}
