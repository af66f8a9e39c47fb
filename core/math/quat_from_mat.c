/* SPDX-License-Identifier: MIT */
#include "qtri/quat.h"
#include "qtri/error.h"

#include "quat_q30.h"
#include "unit.h"

/*
 * The symmetric matrix 4 q q^T is made of sums and differences of m's elements; any row of it is q,
 * up to a factor. The row with the largest diagonal element has the most bits (Shepperd 1978). The
 * four diagonal elements add up to 4, so that one is at least 1.
 */
qtri_quat qtri_quat_from_mat3(const qtri_mat3 *m)
{
    QTRI_ASSERT(m != NULL);
    const int64_t d[3] = {m->m[0][0], m->m[1][1], m->m[2][2]};
    const int64_t diagonal[4] = {Q16_ONE + d[0] + d[1] + d[2], Q16_ONE + d[0] - d[1] - d[2],
                                 Q16_ONE - d[0] + d[1] - d[2], Q16_ONE - d[0] - d[1] + d[2]};
    int best = 0;
    for (int i = 1; i < 4; i++) {
        best = diagonal[i] > diagonal[best] ? i : best;
    }
    int64_t row[4];
    for (int i = 0; i < 4; i++) {
        if (i == best) {
            row[i] = diagonal[i];
        } else if (i == 0 || best == 0) { /* w times x, y or z */
            int axis = i + best;
            row[i] = (int64_t)m->m[(axis + 1) % 3][axis % 3] - m->m[axis % 3][(axis + 1) % 3];
        } else {
            row[i] = (int64_t)m->m[best - 1][i - 1] + m->m[i - 1][best - 1];
        }
    }
    int32_t q_q30[4];
    (void)qtri_fit32(q_q30, row, 4);
    (void)qtri_unit(q_q30, q_q30, 4, 30);
    if (q_q30[0] < 0) {
        for (int i = 0; i < 4; i++) {
            q_q30[i] = -q_q30[i];
        }
    }
    return qtri_quat_from_q30(q_q30);
}

qtri_quat qtri_quat_from_mat4(const qtri_mat4 *m)
{
    QTRI_ASSERT(m != NULL);
    qtri_mat3 linear = qtri_mat4_linear(m);
    return qtri_quat_from_mat3(&linear);
}
