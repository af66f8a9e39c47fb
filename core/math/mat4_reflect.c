#include "qtri/mat.h"

#include "bits.h"
#include "wide_q16.h"

/* I - 2 n n^T / n.n, and - 2 w n / n.n for the offset. */
qtri_mat4 qtri_mat4_reflect(qtri_vec4 plane)
{
    const q16 n[4] = {plane.x, plane.y, plane.z, plane.w};
    qtri_mat4 m = qtri_mat4_identity();
    qtri_wide square = qtri_wide_dot(n, n, 3);
    if (square.m == 0) {
        return m;
    }
    qtri_wide scale = qtri_wide_div(qtri_wide_make(2, 0), square);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            qtri_wide part = qtri_wide_mul(qtri_wide_make(qtri_mul_s32(n[i], n[j]), 32), scale);
            m.m[i][j] = qtri_wide_to_q16(qtri_wide_sub(qtri_wide_q16(m.m[i][j]), part));
        }
    }
    return m;
}
