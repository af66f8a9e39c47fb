/* SPDX-License-Identifier: MIT */
#include "qtri/mat.h"
#include "qtri/q16_trig.h"

#include "dot.h"
#include "rotation.h"

qtri_mat4 qtri_rotation_plane(q16 degrees, int i, int j)
{
    qtri_mat4 m = qtri_mat4_identity();
    q16_sincos_deg(degrees, &m.m[j][i], &m.m[i][i]);
    m.m[i][j] = -m.m[j][i];
    m.m[j][j] = m.m[i][i];
    return m;
}

qtri_mat4 qtri_mat4_rotate_axis_deg(qtri_vec3 axis, q16 degrees)
{
    int32_t q_q30[4];
    qtri_rotation_axis(q_q30, axis, degrees);
    qtri_mat3 linear = qtri_rotation_mat3(q_q30);
    return qtri_mat4_from_linear(&linear);
}

/* p - R p with the rounded R: with the exact one, R p + offset would miss a far p. */
qtri_mat4 qtri_mat4_rotate_about_deg(qtri_vec3 axis, q16 degrees, qtri_vec3 point)
{
    qtri_mat4 m = qtri_mat4_rotate_axis_deg(axis, degrees);
    const q16 p[3] = {point.x, point.y, point.z};
    for (int i = 0; i < 3; i++) {
        q16 row[3] = {-m.m[i][0], -m.m[i][1], -m.m[i][2]};
        row[i] += Q16_ONE;
        m.m[i][3] = qtri_dot(row, p, 3);
    }
    return m;
}

qtri_mat4 qtri_mat4_rotate_euler_deg(qtri_vec3 degrees, qtri_euler order)
{
    int32_t q_q30[4];
    qtri_rotation_euler(q_q30, degrees, order);
    qtri_mat3 linear = qtri_rotation_mat3(q_q30);
    return qtri_mat4_from_linear(&linear);
}
