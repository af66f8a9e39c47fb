#include "qtri/vec.h"

#include "wide_q16.h"

void qtri_vec_along(q16 *out, const q16 *a, const q16 *b, int32_t count, int32_t keep,
                    int32_t times)
{
    qtri_wide square = qtri_wide_dot(b, b, count);
    qtri_wide ratio = {0, 0};
    if (square.m != 0) {
        ratio = qtri_wide_div(qtri_wide_dot(a, b, count), square);
        ratio = qtri_wide_mul(ratio, qtri_wide_make(times, 0));
    }
    for (int32_t i = 0; i < count; i++) {
        qtri_wide kept = qtri_wide_make((int64_t)keep * a[i], 16);
        qtri_wide along = qtri_wide_mul(ratio, qtri_wide_q16(b[i]));
        out[i] = qtri_wide_to_q16(qtri_wide_sub(kept, along));
    }
}
