/* SPDX-License-Identifier: MIT */
#include "quat_q30.h"

#include "qtri/error.h"
#include "unit.h"

#define HALF_ARC_MAX_Q32 (((int64_t)1 << 47) - 65536) /* what qtri_sincos_deg_q32 takes */

qtri_attitude qtri_attitude_from_quat(qtri_quat a)
{
    qtri_attitude attitude = {{0, 0, 0, 0}};
    qtri_quat_unit_q30(attitude.q_q30, a);
    return attitude;
}

qtri_quat qtri_attitude_quat(const qtri_attitude *attitude)
{
    QTRI_ASSERT(attitude != NULL);
    qtri_attitude unit = *attitude;
    if (!qtri_unit(unit.q_q30, unit.q_q30, 4, 30)) {
        return qtri_quat_identity();
    }
    return qtri_quat_from_q30(unit.q_q30);
}

/* The exponential of a pure quaternion of length h along n: cos h + n sin h. */
void qtri_attitude_integrate_deg(qtri_attitude *attitude, qtri_vec3 rate, q16 dt)
{
    QTRI_ASSERT(attitude != NULL);
    const int64_t arc_q32[3] = {qtri_mul_s32(rate.x, dt), qtri_mul_s32(rate.y, dt),
                                qtri_mul_s32(rate.z, dt)};
    int32_t arc[3];
    int32_t turn_q30[4];
    int32_t shift = qtri_fit32(arc, arc_q32, 3); /* 0..32 */
    uint64_t square = 0;
    for (int i = 0; i < 3; i++) {
        square += (uint64_t)qtri_mul_s32(arc[i], arc[i]);
    }
    int64_t half_q32 = (int64_t)((qtri_sqrt64_round(square) << shift) / 2); /* < 2^63.8 / 2 */
    int32_t sine_q30;
    half_q32 = half_q32 > HALF_ARC_MAX_Q32 ? HALF_ARC_MAX_Q32 : half_q32;
    qtri_sincos_deg_q32(half_q32, &sine_q30, &turn_q30[0]);
    (void)qtri_unit(turn_q30 + 1, arc, 3, 30);
    for (int i = 1; i < 4; i++) {
        turn_q30[i] = qtri_mul_q30(turn_q30[i], sine_q30);
    }
    if (!qtri_unit(attitude->q_q30, attitude->q_q30, 4, 30)) { /* the memory may hold anything */
        attitude->q_q30[0] = (int32_t)1 << 30;
    }
    qtri_rotation_mul(attitude->q_q30, attitude->q_q30, turn_q30);
    (void)qtri_unit(attitude->q_q30, attitude->q_q30, 4, 30);
}

qtri_quat qtri_quat_integrate_deg(qtri_quat a, qtri_vec3 rate, q16 dt)
{
    qtri_attitude attitude = qtri_attitude_from_quat(a);
    qtri_attitude_integrate_deg(&attitude, rate, dt);
    return qtri_quat_from_q30(attitude.q_q30);
}
