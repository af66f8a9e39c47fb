#include "qtri/quat.h"

#include "wide_q16.h"

qtri_quat qtri_quat_inverse(qtri_quat a)
{
    q16 inverse[4] = {a.w, a.x, a.y, a.z};
    qtri_wide square = qtri_wide_dot(inverse, inverse, 4);
    if (square.m == 0) {
        return qtri_quat_identity();
    }
    qtri_wide scale = qtri_wide_div(qtri_wide_make(1, 0), square);
    for (int i = 0; i < 4; i++) {
        inverse[i] = qtri_wide_to_q16(qtri_wide_mul(qtri_wide_q16(inverse[i]), scale));
        if (i == 0) {
            scale = qtri_wide_neg(scale);
        }
    }
    qtri_quat result = {inverse[0], inverse[1], inverse[2], inverse[3]};
    return result;
}
