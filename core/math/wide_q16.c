#include "wide_q16.h"

#include "bits.h"

int32_t qtri_wide_to_q16(qtri_wide a)
{
    int32_t shift = a.e - 16;
    if (shift < 31) { /* 2^61 >> 30 does not fit */
        QTRI_MATH_CHECK(a.m == 0);
        return a.m == 0 ? 0 : qtri_extreme32((int32_t)(a.m >> 32));
    }
    return qtri_saturate32_checked(qtri_shift_round(a.m, shift));
}

/*
 * Sums up to 2^62 are exact. Beyond that, two bits at most are lost from one that may cancel
 * later, 2^-30 in real numbers; a factor is then 2^14 and more.
 */
qtri_wide qtri_wide_dot(const int32_t *a, const int32_t *b, int32_t count)
{
    qtri_wide sum = {0, 0};
    for (int32_t i = 0; i < count; i++) {
        sum = qtri_wide_add(sum, qtri_wide_make(qtri_mul_s32(a[i], b[i]), 32));
    }
    return sum;
}
