/* SPDX-License-Identifier: MIT */
#include "dot.h"

#include "../bits/bits.h"

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

/* ---- With wide scalars ---- */

int32_t qtri_wide_to_q16(qtri_wide a)
{
    int32_t shift = a.e - 16;
    if (shift < 31) { /* 2^61 >> 30 does not fit */
        QTRI_MATH_CHECK(a.m == 0);
        return a.m == 0 ? 0 : qtri_extreme32((int32_t)(a.m >> 32));
    }
    return qtri_saturate32_checked(qtri_shift_round(a.m, shift));
}

int32_t qtri_wide_less(int64_t m, const qtri_wide *a, const qtri_wide *b)
{
    qtri_wide product = *a;
    qtri_wide difference;
    qtri_wide_mul_by(&product, b);
    product.m = -product.m;
    qtri_wide_set(&difference, m, 16);
    qtri_wide_add_to(&difference, &product);
    return qtri_wide_to_q16(difference);
}

/*
 * Sums up to 2^62 are exact. Beyond that, two bits at most are lost from one that may cancel
 * later, 2^-30 in real numbers; a factor is then 2^14 and more.
 */
void qtri_wide_dot(qtri_wide *sum, const int32_t *a, const int32_t *b, int32_t count)
{
    qtri_wide_set(sum, 0, 0);
    for (int32_t i = 0; i < count; i++) {
        qtri_wide product;
        qtri_wide_set(&product, qtri_mul_s32(a[i], b[i]), 32);
        qtri_wide_add_to(sum, &product);
    }
}

void qtri_wide_invert(qtri_wide *x, int32_t numerator)
{
    qtri_wide quotient;
    qtri_wide_set(&quotient, numerator, 0);
    qtri_wide_div_by(&quotient, x);
    *x = quotient;
}
