/* SPDX-License-Identifier: MIT */
/*
 * What Frama-C's Eva proves of vectors, matrices and quaternions, as math_values.c does of scalars:
 * for all arguments nothing that C does not define.
 *
 * What a sum of products of unit vectors is at most is no interval. Contracts below say it, with
 * the reason; each function but those for which math_inputs.c stands is also proved itself, for all
 * that its contract lets in.
 */
#include <stdint.h>

#include "__fc_builtin.h"

#include "bits/bits.h"
#include "bits/wide.h"
#include "math/rotation.h"
#include "math/q16_trig.h"
#include "math/unit.h"
#include "qtri/quat.h"
#include "qtri/vec.h"

#include "products.h"

/* The unit of Q2.30, and what errors may add to it. */
#define ONE  1073741824
#define SOME 1024

/*@ requires x >= 0x80000000;
    assigns \result \from x;
    ensures 0x40000000 <= \result <= 0x4000000000000000 / x; */
uint32_t qtri_reciprocal_q62(uint32_t x);

/*@ assigns \result, *remainder \from x;
    ensures \initialized(remainder) && *remainder <= 2 * \result; */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder);

/*
 * A component is at most as long as the whole, and root_of_unit of math_inputs.c, which is tried
 * with every argument, holds what errors add to that in Q30: 3.
 */
/*@ requires 1 <= count <= 4 && 1 <= fraction_bits <= 30;
    assigns \result, out[0 .. count - 1] \from v[0 .. count - 1], count, fraction_bits;
    ensures \result == 0 || \result == 1;
    ensures \initialized(out + (0 .. count - 1));
    ensures -(1 << fraction_bits) - 4 <= out[0] <= (1 << fraction_bits) + 4;
    ensures count < 2 || -(1 << fraction_bits) - 4 <= out[1] <= (1 << fraction_bits) + 4;
    ensures count < 3 || -(1 << fraction_bits) - 4 <= out[2] <= (1 << fraction_bits) + 4;
    ensures count < 4 || -(1 << fraction_bits) - 4 <= out[3] <= (1 << fraction_bits) + 4; */
bool qtri_unit(int32_t *out, const int32_t *v, int32_t count, int32_t fraction_bits);

/*@ assigns *x \from m, e;
    ensures \initialized(&x->m) && \initialized(&x->e);
    ensures -4611686018427387904 < x->m < 4611686018427387904 && -2048 <= x->e <= 2048; */
void qtri_wide_set(qtri_wide *x, int64_t m, int32_t e);

/*@ requires -4611686018427387904 < a->m < 4611686018427387904 && -2048 <= a->e <= 2048;
    requires -4611686018427387904 < b->m < 4611686018427387904 && -2048 <= b->e <= 2048;
    assigns *a \from *a, *b;
    ensures \initialized(&a->m) && \initialized(&a->e);
    ensures -4611686018427387904 < a->m < 4611686018427387904 && -2048 <= a->e <= 2048; */
void qtri_wide_div_by(qtri_wide *a, const qtri_wide *b);

/* prove_sin shows it. */
/*@ assigns *sine, *cosine \from degrees;
    ensures \initialized(sine) && -65536 <= *sine <= 65536;
    ensures \initialized(cosine) && -65536 <= *cosine <= 65536; */
void q16_sincos_deg(q16 degrees, q16 *sine, q16 *cosine);

/* math_inputs.c tries all angles. */
/*@ assigns *sine_q30, *cosine_q30 \from degrees;
    ensures \initialized(sine_q30) && -ONE <= *sine_q30 <= ONE;
    ensures \initialized(cosine_q30) && -ONE <= *cosine_q30 <= ONE; */
void qtri_sincos_deg_q30(int32_t degrees, int32_t *sine_q30, int32_t *cosine_q30);

/* prove_atan2 shows that any sides have an angle. */
/*@ assigns \result \from y, x; */
q16 q16_atan2_deg(q16 y, q16 x);

/* A product of quaternions is as long as both together: within an error of 1. */
/*@ requires -ONE - SOME <= a_q30[0] <= ONE + SOME && -ONE - SOME <= a_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= a_q30[2] <= ONE + SOME && -ONE - SOME <= a_q30[3] <= ONE + SOME;
    requires -ONE - SOME <= b_q30[0] <= ONE + SOME && -ONE - SOME <= b_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= b_q30[2] <= ONE + SOME && -ONE - SOME <= b_q30[3] <= ONE + SOME;
    assigns out_q30[0 .. 3] \from a_q30[0 .. 3], b_q30[0 .. 3];
    admit ensures \initialized(out_q30 + 0) && -ONE - SOME <= out_q30[0] <= ONE + SOME;
    admit ensures \initialized(out_q30 + 1) && -ONE - SOME <= out_q30[1] <= ONE + SOME;
    admit ensures \initialized(out_q30 + 2) && -ONE - SOME <= out_q30[2] <= ONE + SOME;
    admit ensures \initialized(out_q30 + 3) && -ONE - SOME <= out_q30[3] <= ONE + SOME; */
void qtri_rotation_mul(int32_t out_q30[4], const int32_t a_q30[4], const int32_t b_q30[4]);

/* |2 (a b +- c d)| <= a^2 + b^2 + c^2 + d^2, which is 1; in the diagonal likewise. */
/*@ requires -ONE - SOME <= q_q30[0] <= ONE + SOME && -ONE - SOME <= q_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= q_q30[2] <= ONE + SOME && -ONE - SOME <= q_q30[3] <= ONE + SOME;
    assigns out_q30[0 .. 2][0 .. 2] \from q_q30[0 .. 3];
    admit ensures \initialized(&out_q30[0][0]) && -ONE - 2 * SOME <= out_q30[0][0] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[0][1]) && -ONE - 2 * SOME <= out_q30[0][1] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[0][2]) && -ONE - 2 * SOME <= out_q30[0][2] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[1][0]) && -ONE - 2 * SOME <= out_q30[1][0] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[1][1]) && -ONE - 2 * SOME <= out_q30[1][1] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[1][2]) && -ONE - 2 * SOME <= out_q30[1][2] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[2][0]) && -ONE - 2 * SOME <= out_q30[2][0] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[2][1]) && -ONE - 2 * SOME <= out_q30[2][1] <= ONE + 2 *
   SOME; admit ensures \initialized(&out_q30[2][2]) && -ONE - 2 * SOME <= out_q30[2][2] <= ONE + 2 *
   SOME; */
void qtri_rotation_matrix(int32_t out_q30[3][3], const int32_t q_q30[4]);

/*
 * |u . v| <= |u| |v|, and each is within 2^-28 of 1; what is changed of v is its signs.
 */
/*@ requires -ONE - SOME <= u_q30[0] <= ONE + SOME && -ONE - SOME <= u_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= u_q30[2] <= ONE + SOME && -ONE - SOME <= u_q30[3] <= ONE + SOME;
    requires -ONE - SOME <= v_q30[0] <= ONE + SOME && -ONE - SOME <= v_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= v_q30[2] <= ONE + SOME && -ONE - SOME <= v_q30[3] <= ONE + SOME;
    assigns \result, v_q30[0 .. 3] \from u_q30[0 .. 3], v_q30[0 .. 3];
    admit ensures 0 <= \result <= ONE * (ONE + SOME);
    admit ensures \initialized(v_q30 + 0) && -ONE - SOME <= v_q30[0] <= ONE + SOME;
    admit ensures \initialized(v_q30 + 1) && -ONE - SOME <= v_q30[1] <= ONE + SOME;
    admit ensures \initialized(v_q30 + 2) && -ONE - SOME <= v_q30[2] <= ONE + SOME;
    admit ensures \initialized(v_q30 + 3) && -ONE - SOME <= v_q30[3] <= ONE + SOME; */
static int64_t shortest_arc(const int32_t u_q30[4], int32_t v_q30[4]);

/* A projection of v: no longer than that. */
/*@ requires -ONE - SOME <= v_q30[0] <= ONE + SOME && -ONE - SOME <= v_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= v_q30[2] <= ONE + SOME && -ONE - SOME <= v_q30[3] <= ONE + SOME;
    assigns \result, v_q30[0 .. 3] \from v_q30[0 .. 3], u_q30[0 .. 3], cosine_q30;
    ensures 0 <= \result <= ONE * (ONE + SOME);
    ensures \initialized(v_q30 + (0 .. 3));
    ensures -ONE - SOME <= v_q30[0] <= ONE + SOME && -ONE - SOME <= v_q30[1] <= ONE + SOME;
    ensures -ONE - SOME <= v_q30[2] <= ONE + SOME && -ONE - SOME <= v_q30[3] <= ONE + SOME; */
static int64_t make_perpendicular(int32_t v_q30[4], const int32_t u_q30[4], int32_t cosine_q30);

/* Sine and cosine of one angle are together 1.4143 at most. */
/*@ requires -ONE - SOME <= u_q30[0] <= ONE + SOME && -ONE - SOME <= u_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= u_q30[2] <= ONE + SOME && -ONE - SOME <= u_q30[3] <= ONE + SOME;
    requires -ONE - SOME <= v_q30[0] <= ONE + SOME && -ONE - SOME <= v_q30[1] <= ONE + SOME;
    requires -ONE - SOME <= v_q30[2] <= ONE + SOME && -ONE - SOME <= v_q30[3] <= ONE + SOME;
    requires -ONE - SOME <= sine_q30 <= ONE + SOME && -ONE - SOME <= cosine_q30 <= ONE + SOME;
    assigns u_q30[0 .. 3] \from u_q30[0 .. 3], v_q30[0 .. 3], sine_q30, cosine_q30;
    ensures \initialized(u_q30 + (0 .. 3));
    ensures -3 * ONE / 2 <= u_q30[0] <= 3 * ONE / 2 && -3 * ONE / 2 <= u_q30[1] <= 3 * ONE / 2;
    ensures -3 * ONE / 2 <= u_q30[2] <= 3 * ONE / 2 && -3 * ONE / 2 <= u_q30[3] <= 3 * ONE / 2; */
static void turn_towards(int32_t u_q30[4], const int32_t v_q30[4], int32_t sine_q30,
                         int32_t cosine_q30);

/* Whose own function no other file sees. */
#include "../../core/math/quat.c"

static q16 any(void)
{
    return (int32_t)Frama_C_long_interval(INT32_MIN, INT32_MAX);
}

static int32_t about_one(void)
{
    return (int32_t)Frama_C_long_interval(-ONE - SOME, ONE + SOME);
}

static qtri_vec2 vec2(void)
{
    qtri_vec2 v = {any(), any()};
    return v;
}

static qtri_vec3 vec3(void)
{
    qtri_vec3 v = {any(), any(), any()};
    return v;
}

static qtri_vec4 vec4(void)
{
    qtri_vec4 v = {any(), any(), any(), any()};
    return v;
}

static qtri_quat quat(void)
{
    qtri_quat q = {any(), any(), any(), any()};
    return q;
}

static qtri_mat3 mat3(void)
{
    qtri_mat3 m = {{{any(), any(), any()}, {any(), any(), any()}, {any(), any(), any()}}};
    return m;
}

static qtri_mat4 mat4(void)
{
    qtri_mat4 m = {{{any(), any(), any(), any()},
                    {any(), any(), any(), any()},
                    {any(), any(), any(), any()},
                    {any(), any(), any(), any()}}};
    return m;
}

static qtri_wide wide(void)
{
    const int64_t most = ((int64_t)1 << 62) - 1;
    qtri_wide x;
    x.m = Frama_C_long_long_interval(-most, most);
    x.e = (int32_t)Frama_C_long_interval(-QTRI_WIDE_EXPONENT_MAX, QTRI_WIDE_EXPONENT_MAX);
    return x;
}

static qtri_euler euler(void)
{
    static const qtri_euler orders[6] = {QTRI_EULER_XYZ, QTRI_EULER_XZY, QTRI_EULER_YXZ,
                                         QTRI_EULER_YZX, QTRI_EULER_ZXY, QTRI_EULER_ZYX};
    return orders[Frama_C_interval(0, 5)];
}

// specified: qtri_sqrt64_floor
void prove_vec_sums(void)
{
    qtri_vec2 a2 = vec2(), b2 = vec2();
    qtri_vec3 a3 = vec3(), b3 = vec3();
    qtri_vec4 a4 = vec4(), b4 = vec4();
    q16 t = any();
    qtri_vec2_add(a2, b2), qtri_vec2_sub(a2, b2), qtri_vec2_neg(a2);
    qtri_vec3_add(a3, b3), qtri_vec3_sub(a3, b3), qtri_vec3_neg(a3);
    qtri_vec4_add(a4, b4), qtri_vec4_sub(a4, b4), qtri_vec4_neg(a4);
    qtri_vec2_scale(a2, t), qtri_vec2_lerp(a2, b2, t);
    qtri_vec3_scale(a3, t), qtri_vec3_lerp(a3, b3, t);
    qtri_vec4_scale(a4, t), qtri_vec4_lerp(a4, b4, t);
    qtri_vec2_dot(a2, b2), qtri_vec3_dot(a3, b3), qtri_vec4_dot(a4, b4);
    qtri_vec2_cross(a2, b2), qtri_vec3_cross(a3, b3);
    qtri_vec2_length(a2), qtri_vec3_length(a3), qtri_vec4_length(a4);
    qtri_vec2_distance(a2, b2), qtri_vec3_distance(a3, b3), qtri_vec4_distance(a4, b4);
}

// specified: zeros,qtri_sqrt64_floor,qtri_unit,q16_atan2_deg,qtri_wide_set,qtri_wide_div_by
void prove_vec_directions(void)
{
    qtri_vec2 a2 = vec2(), b2 = vec2();
    qtri_vec3 a3 = vec3(), b3 = vec3();
    qtri_vec4 a4 = vec4(), b4 = vec4();
    qtri_vec2_normalize(a2), qtri_vec3_normalize(a3), qtri_vec4_normalize(a4);
    qtri_vec2_angle_deg(a2, b2), qtri_vec3_angle_deg(a3, b3), qtri_vec4_angle_deg(a4, b4);
    qtri_vec2_project(a2, b2), qtri_vec3_project(a3, b3), qtri_vec4_project(a4, b4);
    qtri_vec2_reject(a2, b2), qtri_vec3_reject(a3, b3), qtri_vec4_reject(a4, b4);
    qtri_vec2_reflect(a2, b2), qtri_vec3_reflect(a3, b3), qtri_vec4_reflect(a4, b4);
}

/* Wide numbers of any mantissa and exponent, by the bits of the first. */
// specified: qtri_sqrt64_floor
void prove_wide_set(void)
{
    qtri_wide x;
    int32_t e = any();
    qtri_wide_set(&x, 0, e);
    qtri_wide_set(&x, INT64_MIN, e);
    /*@ assert -4611686018427387904 < x.m < 4611686018427387904 && -2048 <= x.e <= 2048; */
    //@ loop unroll 63;
    for (int bits = 0; bits < 63; bits++) {
        int64_t one = (int64_t)1 << bits;
        int64_t size = Frama_C_long_long_interval(one, one + (one - 1));
        qtri_wide_set(&x, size, e);
        /*@ assert -4611686018427387904 < x.m < 4611686018427387904 && -2048 <= x.e <= 2048; */
        qtri_wide_set(&x, -size, e);
        /*@ assert -4611686018427387904 < x.m < 4611686018427387904 && -2048 <= x.e <= 2048; */
    }
}

// specified: zeros,qtri_sqrt64_floor,qtri_wide_set,qtri_wide_div_by
void prove_wide(void)
{
    qtri_wide a = wide(), b = wide(), sum = wide();
    qtri_wide v[3] = {wide(), wide(), wide()}, w[3] = {wide(), wide(), wide()}, product[3];
    qtri_wide_add_to(&sum, &b);
    sum = wide();
    qtri_wide_mul_by(&sum, &b);
    sum = wide();
    qtri_wide_div_by(&sum, &b);
    sum = wide();
    qtri_wide_sqrt(a);
    qtri_wide_least(v, 3);
    qtri_wide_add_product(&sum, &a, &b);
    sum = wide();
    qtri_wide_sub_product(&sum, &a, &b);
    qtri_wide_cross(product, v, w);
    qtri_wide_inner(v, w);
    qtri_wide_normalize(v);
}

/* Divisors by their sign, so that it is known that they are not 0. */
// specified: zeros,qtri_sqrt64_floor,qtri_wide_set
void prove_wide_div(void)
{
    const int64_t most = ((int64_t)1 << 62) - 1;
    qtri_wide a = wide(), b = wide();
    b.m = 0;
    qtri_wide_div_by(&a, &b);
    a = wide();
    b.m = Frama_C_long_long_interval(1, most);
    qtri_wide_div_by(&a, &b);
    a = wide();
    b.m = Frama_C_long_long_interval(-most, -1);
    qtri_wide_div_by(&a, &b);
}

// specified: qtri_sqrt64_floor
void prove_mat3(void)
{
    qtri_mat3 a = mat3(), b = mat3();
    qtri_vec2 p = vec2();
    q16 x = any(), y = any();
    qtri_mat3_identity(), qtri_mat3_translate(p), qtri_mat3_scale(p), qtri_mat3_shear(x, y);
    qtri_mat3_mul(&a, &b), qtri_mat3_transpose(&a);
    qtri_mat3_vec3(&a, vec3()), qtri_mat3_point(&a, p), qtri_mat3_vector(&a, p);
}

// specified: qtri_sqrt64_floor,q16_sincos_deg
void prove_mat3_rotate(void)
{
    q16 degrees = any();
    qtri_mat3_rotate_deg(degrees), qtri_mat3_rotate_about_deg(degrees, vec2());
    qtri_mat3_reflect_deg(degrees);
}

// specified: qtri_sqrt64_floor
void prove_mat4(void)
{
    qtri_mat4 a = mat4(), b = mat4();
    qtri_mat3 linear = mat3();
    qtri_vec3 p = vec3();
    qtri_mat4_identity(), qtri_mat4_translate(p), qtri_mat4_scale(p);
    qtri_mat4_shear(any(), any(), any(), any(), any(), any());
    qtri_mat4_linear(&a), qtri_mat4_from_linear(&linear), qtri_mat4_transpose(&a);
    qtri_mat4_mul(&a, &b);
    qtri_mat4_vec4(&a, vec4()), qtri_mat4_point(&a, p), qtri_mat4_vector(&a, p);
}

/* Exact cofactors of any matrix. */
// specified: zeros,qtri_sqrt64_floor,qtri_wide_set,qtri_wide_div_by
void prove_mat_inverse(void)
{
    qtri_mat3 m3 = mat3(), i3;
    qtri_mat4 m4 = mat4(), i4;
    qtri_mat3_determinant(&m3), qtri_mat4_determinant(&m4);
    qtri_mat3_inverse(&i3, &m3), qtri_mat4_inverse(&i4, &m4);
    qtri_mat4_inverse_affine(&i4, &m4);
    qtri_mat4_normal_matrix(&i3, &m4);
    qtri_mat4_reflect(vec4());
}

// specified: qtri_sqrt64_floor,qtri_unit,q16_sincos_deg,qtri_sincos_deg_q30,qtri_rotation_mul
// specified: qtri_rotation_matrix
void prove_mat4_rotate(void)
{
    q16 degrees = any();
    qtri_vec3 v = vec3();
    qtri_mat4_rotate_x_deg(degrees), qtri_mat4_rotate_y_deg(degrees);
    qtri_mat4_rotate_z_deg(degrees), qtri_mat4_rotate_axis_deg(v, degrees);
    qtri_mat4_rotate_about_deg(v, degrees, vec3());
    qtri_mat4_rotate_euler_deg(v, euler());
    qtri_mat4_rotate_euler_deg(v, (qtri_euler)any());
}

/* What is specified of rotations above, for all that it lets in, but for the bounds it gives. */
// specified: qtri_sqrt64_floor
void prove_rotation(void)
{
    int32_t a[4] = {about_one(), about_one(), about_one(), about_one()};
    int32_t b[4] = {about_one(), about_one(), about_one(), about_one()};
    int32_t product[4], matrix[3][3];
    int64_t high = 0;
    //@ loop unroll 4;
    for (int i = 0; i < 4; i++) { /* as qtri_rotation_mul adds */
        high += qtri_mul_s32(a[i], b[i]);
    }
    qtri_rotation_mul(product, a, b);
    qtri_rotation_matrix(matrix, a);
}

// specified: zeros,qtri_sqrt64_floor,qtri_unit
void prove_quat(void)
{
    qtri_quat a = quat(), b = quat();
    qtri_mat3 m3 = mat3();
    qtri_mat4 m4 = mat4();
    qtri_quat_identity(), qtri_quat_conjugate(a), qtri_quat_normalize(a);
    qtri_quat_dot(a, b), qtri_quat_mul(a, b);
    qtri_quat_from_mat3(&m3), qtri_quat_from_mat4(&m4);
}

// specified: zeros,qtri_sqrt64_floor,qtri_wide_set,qtri_wide_div_by
void prove_quat_inverse(void)
{
    qtri_quat_inverse(quat());
}

// specified: zeros,qtri_sqrt64_floor,qtri_unit,qtri_sincos_deg_q30,qtri_rotation_mul
// specified: qtri_rotation_matrix
void prove_quat_rotate(void)
{
    qtri_quat a = quat();
    qtri_attitude attitude = {{any(), any(), any(), any()}};
    q16 degrees = any();
    qtri_quat_from_axis_deg(vec3(), degrees), qtri_quat_from_euler_deg(vec3(), euler());
    qtri_quat_from_euler_deg(vec3(), (qtri_euler)any());
    qtri_quat_to_mat3(a), qtri_quat_to_mat4(a), qtri_quat_rotate(a, vec3());
    qtri_quat_integrate_deg(a, vec3(), degrees);
    qtri_attitude_from_quat(a), qtri_attitude_quat(&attitude);
    qtri_attitude_integrate_deg(&attitude, vec3(), degrees);
}

// specified: zeros,qtri_sqrt64_floor,qtri_unit,qtri_sincos_deg_q30,qtri_rotation_mul
// specified: qtri_rotation_matrix
void prove_attitude_filter(void)
{
    qtri_attitude_filter filter = {
        {{any(), any(), any(), any()}}, {any(), any(), any()}, any(), any(), any()};
    qtri_attitude_filter_step(&filter, vec3(), vec3(), any());
    qtri_attitude_filter_init(&filter, any(), any());
}

// specified: qtri_sqrt64_floor,qtri_unit,qtri_sincos_deg_q30,q16_atan2_deg,shortest_arc
// specified: make_perpendicular,turn_towards
void prove_quat_between(void)
{
    qtri_quat a = quat(), b = quat();
    q16 t = any();
    qtri_quat_nlerp(a, b, t), qtri_quat_slerp(a, b, t);
}

/* The sum of four products of components up to 1. */
// specified: qtri_sqrt64_floor
void prove_quat_arc(void)
{
    int32_t u[4], v[4];
    //@ loop unroll 4;
    for (int i = 0; i < 4; i++) {
        u[i] = about_one();
        v[i] = about_one();
    }
    shortest_arc(u, v);
}
