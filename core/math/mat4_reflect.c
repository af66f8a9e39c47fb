/* SPDX-License-Identifier: MIT */
#include "qtri/mat.h"

#include "../bits/bits.h"
#include "wide_q16.h"

/* I - 2 n n^T / n.n, and - 2 w n / n.n for the offset. */
qtri_mat4 qtri_mat4_reflect(qtri_vec4 plane)
{
    const q16 n[4] = {plane.x, plane.y, plane.z, plane.w};
    qtri_mat4 m = qtri_mat4_identity();
    qtri_wide scale;
    qtri_wide_dot(&scale, n, n, 3);
    if (scale.m == 0) {
        return m;
    }
    qtri_wide_invert(&scale, 2);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            qtri_wide part;
            qtri_wide_set(&part, qtri_mul_s32(n[i], n[j]), 32);
            m.m[i][j] = qtri_wide_less(m.m[i][j], &part, &scale);
        }
    }
    return m;
}
