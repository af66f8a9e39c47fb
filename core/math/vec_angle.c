/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"
#include "qtri/error.h"
#include "qtri/vec.h"

#include "unit.h"

/*
 * For unit vectors u, v at the angle A: |u - v| / 2 = sin(A/2) and |u + v| / 2 = cos(A/2), good for
 * every angle and any number of components (Kahan 2006, "How futile are mindless assessments of
 * roundoff", section 12). Then sin A = 2 sin cos and cos A = cos^2 - sin^2 of A/2.
 */
q16 qtri_vec_angle_deg(const q16 *a, const q16 *b, int32_t count)
{
    QTRI_ASSERT(a != NULL && b != NULL);
    int32_t u_q30[4];
    int32_t v_q30[4];
    if (!qtri_unit(u_q30, a, count, 30) || !qtri_unit(v_q30, b, count, 30)) {
        return 0;
    }
    uint64_t apart_q60 = 0;
    uint64_t along_q60 = 0;
    for (int32_t i = 0; i < count; i++) {
        int32_t difference = (u_q30[i] >> 1) - (v_q30[i] >> 1); /* halves: |.| <= 2^30 */
        int32_t sum = (u_q30[i] >> 1) + (v_q30[i] >> 1);
        apart_q60 += (uint64_t)qtri_mul_s32(difference, difference);
        along_q60 += (uint64_t)qtri_mul_s32(sum, sum);
    }
    uint32_t sine_q30 = (uint32_t)qtri_sqrt64_round(apart_q60);
    uint32_t cosine_q30 = (uint32_t)qtri_sqrt64_round(along_q60);
    int32_t y_q30 = (int32_t)(qtri_mul_u32(sine_q30, cosine_q30) >> 29);
    int32_t x_q30 = (int32_t)((int64_t)(along_q60 - apart_q60) >> 30); /* may be negative */
    return q16_atan2_deg(y_q30, x_q30); /* the ratio counts, not the unit */
}
