/* SPDX-License-Identifier: MIT */
#include "qtri/quat.h"

#include "../bits/bits.h"
#include "quat_q30.h"

qtri_quat qtri_quat_from_axis_deg(qtri_vec3 axis, q16 degrees)
{
    int32_t q_q30[4];
    qtri_rotation_axis(q_q30, axis, degrees);
    return qtri_quat_from_q30(q_q30);
}

qtri_quat qtri_quat_from_euler_deg(qtri_vec3 degrees, qtri_euler order)
{
    int32_t q_q30[4];
    qtri_rotation_euler(q_q30, degrees, order);
    return qtri_quat_from_q30(q_q30);
}

qtri_mat3 qtri_quat_to_mat3(qtri_quat a)
{
    int32_t q_q30[4];
    qtri_quat_unit_q30(q_q30, a);
    return qtri_rotation_mat3(q_q30);
}

qtri_mat4 qtri_quat_to_mat4(qtri_quat a)
{
    qtri_mat3 linear = qtri_quat_to_mat3(a);
    return qtri_mat4_from_linear(&linear);
}

qtri_vec3 qtri_quat_rotate(qtri_quat a, qtri_vec3 v)
{
    int32_t q_q30[4];
    int32_t m_q30[3][3];
    q16 image[3];
    qtri_quat_unit_q30(q_q30, a);
    qtri_rotation_matrix(m_q30, q_q30);
    for (int i = 0; i < 3; i++) {
        int64_t sum_q46 = qtri_mul_s32(m_q30[i][0], v.x) + qtri_mul_s32(m_q30[i][1], v.y) +
                          qtri_mul_s32(m_q30[i][2], v.z); /* three of up to 2^61 */
        image[i] = qtri_saturate32_checked((sum_q46 + 0x20000000) >> 30);
    }
    qtri_vec3 turned = {image[0], image[1], image[2]};
    return turned;
}
