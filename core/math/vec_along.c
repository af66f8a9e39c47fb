/* SPDX-License-Identifier: MIT */
#include "qtri/vec.h"
#include "qtri/error.h"

#include "wide_q16.h"

void qtri_vec_along(q16 *out, const q16 *a, const q16 *b, int32_t count, int32_t keep,
                    int32_t times)
{
    QTRI_ASSERT(out != NULL && a != NULL && b != NULL);
    qtri_wide ratio;
    qtri_wide square;
    qtri_wide_dot(&ratio, a, b, count);
    qtri_wide_dot(&square, b, b, count);
    if (square.m != 0) {
        qtri_wide_div_by(&ratio, &square);
        qtri_wide_set(&square, times, 0);
        qtri_wide_mul_by(&ratio, &square);
    }
    for (int32_t i = 0; i < count; i++) {
        qtri_wide component;
        qtri_wide_set(&component, b[i], 16);
        out[i] = qtri_wide_less((int64_t)keep * a[i], &ratio, &component);
    }
}
