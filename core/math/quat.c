/* SPDX-License-Identifier: MIT */
/*
 * Quaternions.
 */
#include "qtri/error.h"
#include "qtri/q16.h"
#include "qtri/quat.h"

#include "rotation.h"
#include "unit.h"
#include "dot.h"
#include "../bits/bits.h"

qtri_quat qtri_quat_identity(void)
{
    qtri_quat identity = {Q16_ONE, 0, 0, 0};
    return identity;
}

/* Zero stands for the identity. */
static void unit_or_identity(int32_t out_q30[4], const int32_t q[4])
{
    if (!qtri_unit(out_q30, q, 4, 30)) {
        out_q30[0] = (int32_t)1 << 30;
    }
}

void qtri_quat_unit_q30(int32_t out_q30[4], qtri_quat a)
{
    const q16 q[4] = {a.w, a.x, a.y, a.z};
    unit_or_identity(out_q30, q);
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

/*
 * What qtri_quat_mul does when 64 bits or 32 are not enough; high and low as in qtri_dot. Term k of
 * component i is a[k] b[i ^ k], negative where bit k of digit i of the mask is set.
 */
static qtri_quat exact_product(qtri_quat a, qtri_quat b)
{
    const q16 u[4] = {a.w, a.x, a.y, a.z};
    const q16 v[4] = {b.w, b.x, b.y, b.z};
    q16 product[4];
    uint32_t negative = 0x428E;
    for (int i = 0; i < 4; i++) {
        int64_t high = 0;
        uint32_t low = 0x8000u;
        for (int k = 0; k < 4; k++) {
            int64_t term = qtri_mul_s32(u[k], v[i ^ k]);
            term = (negative & 1u) != 0 ? -term : term;
            high += term >> 16;
            low += (uint32_t)term & 0xFFFFu;
            negative >>= 1;
        }
        product[i] = qtri_saturate32_checked(high + (int64_t)(low >> 16));
    }
    qtri_quat result = {product[0], product[1], product[2], product[3]};
    return result;
}

/* A macro, because GCC for small cores would call a function and copy what it takes. */
#define COMPONENT(b0, b1, b2, b3)                                                                  \
    do {                                                                                           \
        qtri_sum sum = qtri_sum_start();                                                           \
        qtri_sum_product(&sum, a.w, b0, &flags);                                                   \
        qtri_sum_product(&sum, a.x, b1, &flags);                                                   \
        qtri_sum_product(&sum, a.y, b2, &flags);                                                   \
        qtri_sum_product(&sum, a.z, b3, &flags);                                                   \
        result = qtri_sum_q16(&sum, &flags);                                                       \
    } while (0)

qtri_quat qtri_quat_mul(qtri_quat a, qtri_quat b)
{
    uint32_t flags = 0;
    q16 result;
    qtri_quat product;
    const qtri_right w = qtri_right_of(b.w, &flags);
    const qtri_right x = qtri_right_of(b.x, &flags);
    const qtri_right y = qtri_right_of(b.y, &flags);
    const qtri_right z = qtri_right_of(b.z, &flags);
    const qtri_right minus_x = qtri_right_opposite(b.x);
    const qtri_right minus_y = qtri_right_opposite(b.y);
    const qtri_right minus_z = qtri_right_opposite(b.z);
    COMPONENT(w, minus_x, minus_y, minus_z);
    product.w = result;
    COMPONENT(x, w, z, minus_y);
    product.x = result;
    COMPONENT(y, minus_z, w, x);
    product.y = result;
    COMPONENT(z, y, minus_x, w);
    product.z = result;
    return qtri_sum_good(flags) ? product : exact_product(a, b);
}

qtri_quat qtri_quat_inverse(qtri_quat a)
{
    q16 inverse[4] = {a.w, a.x, a.y, a.z};
    qtri_wide scale;
    qtri_wide_dot(&scale, inverse, inverse, 4);
    if (scale.m == 0) {
        return qtri_quat_identity();
    }
    qtri_wide_invert(&scale, -1);
    for (int i = 0; i < 4; i++) {
        qtri_wide component;
        qtri_wide_set(&component, inverse[i], 16);
        inverse[i] = qtri_wide_less(0, &component, &scale);
        scale.m = i == 0 ? -scale.m : scale.m;
    }
    qtri_quat result = {inverse[0], inverse[1], inverse[2], inverse[3]};
    return result;
}

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

/* ---- Interpolation ---- */

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
    int64_t square_q60 = 0;
    for (int i = 0; i < 4; i++) { /* v - (u . v) u, which is no longer than v */
        v_q30[i] -= qtri_mul_q30(u_q30[i], cosine_q30);
        square_q60 += qtri_mul_s32(v_q30[i], v_q30[i]);
    }
    int32_t sine_q30 = (int32_t)qtri_sqrt64_round((uint64_t)square_q60);
    q16 arc = q16_atan2_deg(sine_q30, cosine_q30); /* the ratio counts; 0..90 degrees */
    t = q16_clamp(t, 0, Q16_ONE);
    qtri_sincos_deg_q32(qtri_mul_s32(arc, t), &sine_q30, &cosine_q30);
    (void)qtri_unit(v_q30, v_q30, 4, 30);
    for (int i = 0; i < 4; i++) { /* each component is at most cos + sin: 1.42 */
        u_q30[i] = qtri_mul_q30(u_q30[i], cosine_q30) + qtri_mul_q30(v_q30[i], sine_q30);
    }
    return qtri_quat_from_q30(u_q30);
}

/* ---- From angular velocities ---- */

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
    int32_t q_q30[4];
    unit_or_identity(q_q30, attitude->q_q30);
    return qtri_quat_from_q30(q_q30);
}

/*
 * a exp(arc / 2) for a unit a and an arc about the body's axes, at most 2^62 each: the exponential
 * of a pure quaternion of length h along n is cos h + n sin h.
 */
static void attitude_turn(qtri_attitude *attitude, const int64_t arc_q32[3])
{
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
    qtri_rotation_mul(attitude->q_q30, attitude->q_q30, turn_q30);
    (void)qtri_unit(attitude->q_q30, attitude->q_q30, 4, 30);
}

void qtri_attitude_integrate_deg(qtri_attitude *attitude, qtri_vec3 rate, q16 dt)
{
    QTRI_ASSERT(attitude != NULL);
    const int64_t arc_q32[3] = {qtri_mul_s32(rate.x, dt), qtri_mul_s32(rate.y, dt),
                                qtri_mul_s32(rate.z, dt)};
    unit_or_identity(attitude->q_q30, attitude->q_q30); /* the memory may hold anything */
    attitude_turn(attitude, arc_q32);
}

qtri_quat qtri_quat_integrate_deg(qtri_quat a, qtri_vec3 rate, q16 dt)
{
    qtri_attitude attitude = qtri_attitude_from_quat(a);
    qtri_attitude_integrate_deg(&attitude, rate, dt);
    return qtri_quat_from_q30(attitude.q_q30);
}

/* ---- From gyroscope and accelerometer ---- */

#define DEGREES_A_RADIAN Q16(57.29577951)

void qtri_attitude_filter_init(qtri_attitude_filter *filter, q16 gain, q16 offset_gain)
{
    QTRI_ASSERT(filter != NULL);
    filter->attitude = qtri_attitude_from_quat(qtri_quat_identity());
    for (int i = 0; i < 3; i++) {
        filter->offset_q24[i] = 0;
    }
    filter->gain = gain;
    filter->offset_gain = offset_gain;
    filter->tolerance = Q16(.15);
}

/*
 * The axis that turns the attitude's up to the force, times the sine of the angle between them;
 * 0 where the force is not gravity. Sums of products of unit vectors are within 2^60.
 */
static void tilt_error(int32_t error_q30[3], const qtri_attitude_filter *filter, qtri_vec3 force)
{
    const q16 f[3] = {force.x, force.y, force.z};
    int32_t force_q30[3];
    int32_t body_to_world_q30[3][3];
    int64_t sine_q60[3];
    int64_t excess = (int64_t)qtri_vec3_length(force) - Q16_ONE;
    bool is_gravity = qtri_unit(force_q30, f, 3, 30) &&
                      (excess < 0 ? -excess : excess) <= (int64_t)filter->tolerance;
    qtri_rotation_matrix(body_to_world_q30, filter->attitude.q_q30);
    qtri_cross64(sine_q60, force_q30, body_to_world_q30[1]); /* by the body's up */
    for (int i = 0; i < 3; i++) {
        error_q30[i] = is_gravity ? (int32_t)((sine_q60[i] + 0x20000000) >> 30) : 0;
    }
}

/* gain * sine in degrees a second, in 2^-24: a product of 2^31 and 2^30 in 2^-46. */
static int32_t feedback_q24(q16 gain, int32_t sine_q30)
{
    const q16 degrees = qtri_saturate32((qtri_mul_s32(gain, DEGREES_A_RADIAN) + 0x8000) >> 16);
    return qtri_saturate32((qtri_mul_s32(degrees, sine_q30) + 0x200000) >> 22);
}

void qtri_attitude_filter_step(qtri_attitude_filter *filter, qtri_vec3 rate, qtri_vec3 force,
                               int32_t dt_q30)
{
    QTRI_ASSERT(filter != NULL);
    const q16 measured[3] = {rate.x, rate.y, rate.z};
    int32_t error_q30[3];
    int64_t arc_q32[3];
    unit_or_identity(filter->attitude.q_q30, filter->attitude.q_q30);
    tilt_error(error_q30, filter, force);
    for (int i = 0; i < 3; i++) {
        int64_t learned_q54 = qtri_mul_s32(feedback_q24(filter->offset_gain, error_q30[i]), dt_q30);
        int32_t offset_q24 =
            qtri_saturate32(filter->offset_q24[i] + ((learned_q54 + 0x20000000) >> 30));
        int32_t correction_q24 =
            qtri_saturate32((int64_t)offset_q24 + feedback_q24(filter->gain, error_q30[i]));
        filter->offset_q24[i] = offset_q24;
        /* 2^-46 and 2^-54, dt within 2 s: at most 2^48 and 2^40. */
        arc_q32[i] = ((qtri_mul_s32(measured[i], dt_q30) + 0x2000) >> 14) +
                     ((qtri_mul_s32(correction_q24, dt_q30) + 0x200000) >> 22);
    }
    attitude_turn(&filter->attitude, arc_q32);
}
