/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"
#include "qtri/quat.h"

#include "quat_q30.h"
#include "unit.h"

/* v or -v, whichever is nearer to u. Returns u . v in Q60. */
static int64_t shortest_arc(const int32_t u_q30[4], int32_t v_q30[4])
{
    int64_t cosine_q60 = 0;
    for (int i = 0; i < 4; i++) {
        cosine_q60 += qtri_mul_s32(u_q30[i], v_q30[i]);
    }
    if (cosine_q60 < 0) {
        cosine_q60 = -cosine_q60;
        for (int i = 0; i < 4; i++) {
            v_q30[i] = -v_q30[i];
        }
    }
    return cosine_q60;
}

qtri_quat qtri_quat_nlerp(qtri_quat a, qtri_quat b, q16 t)
{
    int32_t u_q30[4];
    int32_t v_q30[4];
    qtri_quat_unit_q30(u_q30, a);
    qtri_quat_unit_q30(v_q30, b);
    (void)shortest_arc(u_q30, v_q30);
    t = q16_clamp(t, 0, Q16_ONE);
    for (int i = 0; i < 4; i++) { /* at least 1 / sqrt 2 long */
        int64_t sum_q46 = qtri_mul_s32(u_q30[i], Q16_ONE - t) + qtri_mul_s32(v_q30[i], t);
        u_q30[i] = (int32_t)((sum_q46 + 0x8000) >> 16);
    }
    (void)qtri_unit(u_q30, u_q30, 4, 30);
    return qtri_quat_from_q30(u_q30);
}

/* v - (u . v) u, which is no longer than v. Returns the square of its length in Q60. */
static int64_t make_perpendicular(int32_t v_q30[4], const int32_t u_q30[4], int32_t cosine_q30)
{
    int64_t square_q60 = 0;
    for (int i = 0; i < 4; i++) {
        v_q30[i] -= qtri_mul_q30(u_q30[i], cosine_q30);
        square_q60 += qtri_mul_s32(v_q30[i], v_q30[i]);
    }
    return square_q60;
}

/* u cos + v sin. Each component is at most cos + sin: 1.42. */
static void turn_towards(int32_t u_q30[4], const int32_t v_q30[4], int32_t sine_q30,
                         int32_t cosine_q30)
{
    for (int i = 0; i < 4; i++) {
        u_q30[i] = qtri_mul_q30(u_q30[i], cosine_q30) + qtri_mul_q30(v_q30[i], sine_q30);
    }
}

/*
 * u cos tA + p sin tA, with p the unit vector perpendicular to u towards v: no division by sin A,
 * and nearly parallel quaternions need no case of their own. A short v - (u . v) u has few bits,
 * but is then multiplied by as small a sine.
 */
qtri_quat qtri_quat_slerp(qtri_quat a, qtri_quat b, q16 t)
{
    int32_t u_q30[4];
    int32_t v_q30[4];
    qtri_quat_unit_q30(u_q30, a);
    qtri_quat_unit_q30(v_q30, b);
    int32_t cosine_q30 = (int32_t)((shortest_arc(u_q30, v_q30) + 0x20000000) >> 30);
    int64_t square_q60 = make_perpendicular(v_q30, u_q30, cosine_q30);
    int32_t sine_q30 = (int32_t)qtri_sqrt64_round((uint64_t)square_q60);
    q16 arc = q16_atan2_deg(sine_q30, cosine_q30); /* the ratio counts; 0..90 degrees */
    t = q16_clamp(t, 0, Q16_ONE);
    qtri_sincos_deg_q32(qtri_mul_s32(arc, t), &sine_q30, &cosine_q30);
    (void)qtri_unit(v_q30, v_q30, 4, 30);
    turn_towards(u_q30, v_q30, sine_q30, cosine_q30);
    return qtri_quat_from_q30(u_q30);
}
