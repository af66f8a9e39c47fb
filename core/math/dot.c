/* SPDX-License-Identifier: MIT */
#include "dot.h"

/* high 2^16 + low in Q32: four products of 2^62 and more would not fit 64 bits. */
int32_t qtri_dot(const int32_t *a, const int32_t *b, int32_t count)
{
    int64_t high = 0;
    uint32_t low = 0x8000u; /* below 5 2^16 */
    for (int32_t i = 0; i < count; i++) {
        int64_t product = qtri_mul_s32(a[i], b[i]);
        high += product >> 16;
        low += (uint32_t)product & 0xFFFFu;
    }
    return qtri_saturate32_checked(high + (int64_t)(low >> 16));
}

void qtri_dot_rows(int32_t *out, const int32_t *rows, const int32_t *column, int32_t n)
{
    for (int32_t i = 0; i < n; i++) {
        out[i] = qtri_dot(rows + i * n, column, n);
    }
}

/* 64 bits suffice: the extremes are 2^62 + 2^62 - 2^31 and its negative. */
int32_t qtri_dot_cross(int32_t a, int32_t b, int32_t c, int32_t d)
{
    int64_t sum = qtri_mul_s32(a, b) - qtri_mul_s32(c, d) + 0x8000;
    return qtri_saturate32_checked(sum >> 16);
}
