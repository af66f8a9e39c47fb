/* SPDX-License-Identifier: MIT */
#include "qtri/quat.h"

#include "quat_q30.h"
#include "unit.h"

qtri_quat qtri_quat_identity(void)
{
    qtri_quat identity = {Q16_ONE, 0, 0, 0};
    return identity;
}

void qtri_quat_unit_q30(int32_t out_q30[4], qtri_quat a)
{
    const q16 q[4] = {a.w, a.x, a.y, a.z};
    if (!qtri_unit(out_q30, q, 4, 30)) {
        out_q30[0] = (int32_t)1 << 30;
    }
}

qtri_quat qtri_quat_from_q30(const int32_t q_q30[4])
{
    qtri_quat result = {qtri_q30_to_q16(q_q30[0]), qtri_q30_to_q16(q_q30[1]),
                        qtri_q30_to_q16(q_q30[2]), qtri_q30_to_q16(q_q30[3])};
    return result;
}

qtri_quat qtri_quat_conjugate(qtri_quat a)
{
    qtri_quat result = {a.w, q16_neg(a.x), q16_neg(a.y), q16_neg(a.z)};
    return result;
}

q16 qtri_quat_dot(qtri_quat a, qtri_quat b)
{
    qtri_vec4 u = {a.w, a.x, a.y, a.z};
    qtri_vec4 v = {b.w, b.x, b.y, b.z};
    return qtri_vec4_dot(u, v);
}

qtri_quat qtri_quat_normalize(qtri_quat a)
{
    int32_t q_q30[4];
    qtri_quat_unit_q30(q_q30, a);
    return qtri_quat_from_q30(q_q30);
}
