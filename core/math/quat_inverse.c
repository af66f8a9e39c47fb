/* SPDX-License-Identifier: MIT */
#include "qtri/quat.h"

#include "wide_q16.h"

qtri_quat qtri_quat_inverse(qtri_quat a)
{
    q16 inverse[4] = {a.w, a.x, a.y, a.z};
    qtri_wide scale;
    qtri_wide_dot(&scale, inverse, inverse, 4);
    if (scale.m == 0) {
        return qtri_quat_identity();
    }
    qtri_wide_invert(&scale, -1);
    for (int i = 0; i < 4; i++) {
        qtri_wide component;
        qtri_wide_set(&component, inverse[i], 16);
        inverse[i] = qtri_wide_less(0, &component, &scale);
        scale.m = i == 0 ? -scale.m : scale.m;
    }
    qtri_quat result = {inverse[0], inverse[1], inverse[2], inverse[3]};
    return result;
}
