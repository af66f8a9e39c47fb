/* SPDX-License-Identifier: MIT */
#include "rotation.h"

#include "q16_trig.h"
#include "unit.h"

#define ONE_Q30                ((int32_t)1 << 30)
#define RADIANS_PER_DEGREE_Q20 18302 /* pi / 180 */

/* sin(a + d) = sin a + d cos a for |d| <= 2^-17 degrees: d^2 / 2 < 2^-46. */
void qtri_sincos_deg_q32(int64_t degrees_q32, int32_t *sine_q30, int32_t *cosine_q30)
{
    int32_t nearest = (int32_t)((degrees_q32 + 0x8000) >> 16);
    int32_t rest_q32 = (int32_t)((uint32_t)(degrees_q32 + 0x8000) & 0xFFFFu) - 0x8000;
    int32_t s;
    int32_t c;
    qtri_sincos_deg_q30(nearest, &s, &c);
    int32_t d_q52 = rest_q32 * RADIANS_PER_DEGREE_Q20; /* <= 2^15 2^14.2 */
    *sine_q30 = s + (int32_t)((qtri_mul_s32(c, d_q52) + ((int64_t)1 << 51)) >> 52);
    *cosine_q30 = c - (int32_t)((qtri_mul_s32(s, d_q52) + ((int64_t)1 << 51)) >> 52);
}

void qtri_rotation_axis(int32_t out_q30[4], qtri_vec3 axis, q16 degrees)
{
    const q16 direction[3] = {axis.x, axis.y, axis.z};
    int32_t sine;
    out_q30[0] = ONE_Q30;
    if (!qtri_unit(out_q30 + 1, direction, 3, 30)) {
        return;
    }
    qtri_sincos_deg_q32((int64_t)degrees * 32768, &sine, &out_q30[0]);
    for (int i = 1; i < 4; i++) {
        out_q30[i] = qtri_mul_q30(out_q30[i], sine);
    }
}

void qtri_rotation_euler(int32_t out_q30[4], qtri_vec3 degrees, qtri_euler order)
{
    const q16 angle[3] = {degrees.x, degrees.y, degrees.z};
    uint32_t digits = (uint32_t)order;
    for (int step = 0; step < 3; step++) {
        int32_t axis = (int32_t)(digits & 15u) % 3;
        int32_t turn_q30[4] = {0, 0, 0, 0};
        qtri_sincos_deg_q32((int64_t)angle[axis] * 32768, &turn_q30[1 + axis], &turn_q30[0]);
        if (step == 0) {
            for (int i = 0; i < 4; i++) {
                out_q30[i] = turn_q30[i];
            }
        } else {
            qtri_rotation_mul(out_q30, turn_q30, out_q30);
        }
        digits >>= 4;
    }
}

/* Term k of component i is a[k] b[i ^ k], negative where bit k of digit i of the mask is set. */
void qtri_rotation_mul(int32_t out_q30[4], const int32_t a_q30[4], const int32_t b_q30[4])
{
    int32_t product[4];
    uint32_t negative = 0x428E;
    for (int i = 0; i < 4; i++) {
        int64_t sum = 0x20000000;
        for (int k = 0; k < 4; k++) {
            int64_t term = qtri_mul_s32(a_q30[k], b_q30[i ^ k]);
            sum += (negative & 1u) != 0 ? -term : term;
            negative >>= 1;
        }
        product[i] = (int32_t)(sum >> 30);
    }
    for (int i = 0; i < 4; i++) {
        out_q30[i] = product[i];
    }
}

void qtri_rotation_matrix(int32_t out_q30[3][3], const int32_t q_q30[4])
{
    const int32_t w = q_q30[0];
    const int32_t *u = q_q30 + 1;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        int64_t others_q60 = qtri_mul_s32(u[j], u[j]) + qtri_mul_s32(u[k], u[k]);
        int64_t across_q60 = qtri_mul_s32(u[i], u[j]);
        int64_t turn_q60 = qtri_mul_s32(w, u[k]);
        out_q30[i][i] = (int32_t)(ONE_Q30 - ((others_q60 + 0x10000000) >> 29));
        out_q30[i][j] = (int32_t)((across_q60 - turn_q60 + 0x10000000) >> 29);
        out_q30[j][i] = (int32_t)((across_q60 + turn_q60 + 0x10000000) >> 29);
    }
}

qtri_mat3 qtri_rotation_mat3(const int32_t q_q30[4])
{
    int32_t m_q30[3][3];
    qtri_mat3 m;
    qtri_rotation_matrix(m_q30, q_q30);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m.m[i][j] = qtri_q30_to_q16(m_q30[i][j]);
        }
    }
    return m;
}
