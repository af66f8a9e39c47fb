/* SPDX-License-Identifier: MIT */
/* Transforms built of translations, scales and rotations, their products, orthonormalization. */
#include "qtri/error.h"
#include "qtri/transform.h"

#include <stdbool.h>
#include <stddef.h>

#include "../bits/bits.h"
#include "../math/q16_trig.h"
#include "plain.h"
#include "row.h"

void qtri_transform_from_mat4(qtri_transform *out, const qtri_mat4 *m)
{
    QTRI_ASSERT(out != NULL && m != NULL);
    for (int i = 0; i < 4; i++) {
        qtri_wide element[4];
        for (int j = 0; j < 4; j++) {
            qtri_wide_set(&element[j], m->m[i][j], 16);
        }
        qtri_row_from_wide(&out->row[i], element);
    }
}

/* As qtri_transform_from_mat4() makes it. */
void qtri_transform_identity(qtri_transform *out)
{
    QTRI_ASSERT(out != NULL);
    for (int i = 0; i < 4; i++) {
        qtri_row *row = &out->row[i];
        row->m[0] = row->m[1] = row->m[2] = 0;
        row->t = 0;
        row->exponent = 29;
        if (i < 3) {
            row->m[i] = (int32_t)1 << 29;
        } else {
            row->t = (int64_t)1 << 59;
            row->exponent = 59 - 16;
        }
    }
}

/* m 2^-e in Q16.16, rounded and saturated. */
static q16 wide_to_q16(qtri_wide a)
{
    int32_t shift = a.e - 16;
    if (shift < 31) { /* 2^61 >> 30 does not fit */
        return a.m == 0 ? 0 : (a.m > 0 ? Q16_MAX : Q16_MIN);
    }
    return qtri_saturate32(qtri_shift_round(a.m, shift));
}

void qtri_transform_to_mat4(const qtri_transform *a, qtri_mat4 *out)
{
    QTRI_ASSERT(out != NULL && a != NULL);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            out->m[i][j] = wide_to_q16(qtri_row_element(&a->row[i], j));
        }
    }
}

/*
 * The linear part's image of the offset, which m . offset is in the translation's own scale: exact,
 * but where 61 bits have no room for it. Unsigned, for rows that nothing has built: those of a
 * builder stay below 2^63.
 */
static void move_row(qtri_row *row, const qtri_vec3 *offset)
{
    uint64_t sum = (uint64_t)row->t;
    sum += (uint64_t)qtri_mul_s32(row->m[0], offset->x);
    sum += (uint64_t)qtri_mul_s32(row->m[1], offset->y);
    sum += (uint64_t)qtri_mul_s32(row->m[2], offset->z);
    row->t = qtri_wrap64(sum);
    if (qtri_magnitude64(row->t) >> 61 != 0) {
        row->t >>= 3;
        row->exponent = qtri_greatest32(row->exponent, INT32_MIN + 3) - 3;
        for (int i = 0; i < 3; i++) {
            row->m[i] = (int32_t)qtri_shift_round(row->m[i], 3);
        }
    }
}

void qtri_transform_translate(qtri_transform *t, qtri_vec3 offset)
{
    QTRI_ASSERT(t != NULL);
    for (int i = 0; i < 4; i++) {
        move_row(&t->row[i], &offset);
    }
}

#ifdef QTRI_CHECKED
void qtri_transform_scale(qtri_transform *t, qtri_vec3 factor)
{
    QTRI_ASSERT(qtri_is_plain_1(factor) || qtri_is_scale(factor));
    qtri_transform_scale_any(t, factor);
}
#endif

void qtri_transform_scale_any(qtri_transform *t, qtri_vec3 factor)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(!qtri_is_plain_1(factor));
    const q16 x[3] = {factor.x, factor.y, factor.z};
    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        const qtri_wide wide = qtri_wide_make(x[i], 16);
        qtri_row_from_two(&builder.row[i], i, &wide, i, &wide);
    }
    qtri_transform_mul(t, t, &builder);
}

/*
 * The right-angled pair of axes (i, j) turned from i towards j. The larger of sine and cosine is
 * above 2^29, and so both are mantissas as they are; 2^30 would be 2^29 with another exponent.
 */
static void rotate_plane(qtri_transform *t, q16 degrees, int i, int j)
{
    QTRI_ASSERT(t != NULL);
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    int32_t minus_q30 = -sine_q30;
    int32_t exponent = 30;
    if ((qtri_magnitude32(sine_q30) | qtri_magnitude32(cosine_q30)) >> 30 != 0) {
        exponent = 29;
        sine_q30 = (sine_q30 + 1) >> 1;
        minus_q30 = (minus_q30 + 1) >> 1;
        cosine_q30 = (cosine_q30 + 1) >> 1;
    }
    qtri_transform builder;
    qtri_transform_identity(&builder);
    builder.row[i].exponent = builder.row[j].exponent = exponent;
    builder.row[i].m[i] = builder.row[j].m[j] = cosine_q30;
    builder.row[i].m[j] = minus_q30;
    builder.row[j].m[i] = sine_q30;
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_rotate_x(qtri_transform *t, q16 degrees)
{
    rotate_plane(t, degrees, 1, 2);
}

void qtri_transform_rotate_y(qtri_transform *t, q16 degrees)
{
    rotate_plane(t, degrees, 2, 0);
}

void qtri_transform_rotate_z(qtri_transform *t, q16 degrees)
{
    rotate_plane(t, degrees, 0, 1);
}

/* The axis after i, cyclically: 0 1 2 0. */
static int next_axis(int i)
{
    return i < 2 ? i + 1 : 0;
}

/* The row of these elements, |element| <= 1, and no translation. */
static void set_row_q62(qtri_row *row, const int64_t element_q62[3])
{
    uint64_t size = 0;
    for (int i = 0; i < 3; i++) {
        size |= qtri_magnitude64(element_q62[i]);
    }
    const int32_t down = 34 - qtri_clz64(size | (uint64_t)1 << 32); /* leaves 30 bits */
    row->t = 0;
    row->exponent = 62 - down;
    for (int i = 0; i < 3; i++) {
        row->m[i] = (int32_t)qtri_shift_round(element_q62[i], down);
    }
}

/*
 * t = t T(point) R(axis) T(-point), Rodrigues: R = c I + (1 - c) n n^T + s [n]x. The translation
 * comes from the rounded rows of R, or it would not cancel for points near `point`. NULL: the
 * origin.
 */
static void rotate_about(qtri_transform *t, q16 degrees, const qtri_wide axis[3],
                         const qtri_wide *point)
{
    int64_t n_q62[3];
    int64_t along_q61[3];
    int64_t r_q62[3][3];
    int32_t sine_q30;
    int32_t cosine_q30;
    if (!qtri_wide_unit_q62(n_q62, axis)) {
        return;
    }
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    const int64_t sine_q62 = sine_q30 * ((int64_t)1 << 32);
    const int64_t half_rest_q62 = (((int64_t)1 << 30) - cosine_q30) * ((int64_t)1 << 31);
    for (int k = 0; k < 3; k++) {
        along_q61[k] = qtri_mul_q62(n_q62[k], half_rest_q62);
    }
    for (int k = 0; k < 3; k++) {
        const int i = next_axis(k);
        const int j = next_axis(i);
        const int64_t both = 2 * qtri_mul_q62(along_q61[i], n_q62[j]);
        const int64_t turn = qtri_mul_q62(sine_q62, n_q62[k]);
        r_q62[k][k] = 2 * qtri_mul_q62(along_q61[k], n_q62[k]) + cosine_q30 * ((int64_t)1 << 32);
        r_q62[i][j] = both - turn;
        r_q62[j][i] = both + turn;
    }
    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        set_row_q62(&builder.row[i], r_q62[i]);
        if (point != NULL) {
            qtri_wide element[3];
            for (int k = 0; k < 3; k++) {
                qtri_wide_set(&element[k], r_q62[i][k], 62);
            }
            qtri_row_about(&builder.row[i], element, point, &point[i]);
        }
    }
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_rotate_about(qtri_transform *t, q16 degrees, qtri_vec3 axis, qtri_vec3 point)
{
    QTRI_ASSERT(t != NULL);
    qtri_wide wide_axis[3];
    qtri_wide wide_point[3];
    qtri_wide_from_vec3(wide_axis, &axis);
    qtri_wide_from_vec3(wide_point, &point);
    rotate_about(t, degrees, wide_axis, wide_point);
}

void qtri_transform_rotate(qtri_transform *t, q16 degrees, qtri_vec3 axis)
{
    QTRI_ASSERT(t != NULL);
    qtri_wide wide_axis[3];
    qtri_wide_from_vec3(wide_axis, &axis);
    rotate_about(t, degrees, wide_axis, NULL);
}

void qtri_transform_rotate_triangle(qtri_transform *t, q16 degrees, const qtri_vec3 v[3])
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(v != NULL);
    const qtri_wide three = qtri_wide_make(3, 0);
    qtri_wide edge[2][3];
    qtri_wide centroid[3];
    qtri_wide normal[3];
    for (int axis = 0; axis < 3; axis++) {
        int64_t a = axis == 0 ? v[0].x : (axis == 1 ? v[0].y : v[0].z);
        int64_t b = axis == 0 ? v[1].x : (axis == 1 ? v[1].y : v[1].z);
        int64_t c = axis == 0 ? v[2].x : (axis == 1 ? v[2].y : v[2].z);
        qtri_wide_set(&edge[0][axis], b - a, 16);
        qtri_wide_set(&edge[1][axis], c - a, 16);
        qtri_wide_set(&centroid[axis], a + b + c, 16);
        qtri_wide_div_by(&centroid[axis], &three);
    }
    qtri_wide_cross(normal, edge[0], edge[1]);
    rotate_about(t, degrees, normal, centroid);
}

/* With |q|^2 = n: R = I - 2/n (y^2 + z^2 ...) and so on: no square root is needed. */
void qtri_transform_rotate_quat(qtri_transform *t, qtri_quat q)
{
    QTRI_ASSERT(t != NULL);
    qtri_wide u[3];
    const qtri_vec3 part = {q.x, q.y, q.z};
    const qtri_wide w = qtri_wide_make(q.w, 16);
    qtri_wide_from_vec3(u, &part);
    qtri_wide square = {0, 0};
    qtri_wide_add_product(&square, &w, &w);
    for (int i = 0; i < 3; i++) {
        qtri_wide_add_product(&square, &u[i], &u[i]);
    }
    if (square.m == 0) {
        return;
    }
    qtri_wide twice = qtri_wide_make(2, 0);
    qtri_wide_div_by(&twice, &square);
    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        int j = next_axis(i);
        int k = next_axis(j);
        qtri_wide element[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
        qtri_wide others = {0, 0};
        qtri_wide_add_product(&others, &u[j], &u[j]);
        qtri_wide_add_product(&others, &u[k], &u[k]);
        qtri_wide_set(&element[i], 1, 0);
        qtri_wide_sub_product(&element[i], &twice, &others);
        qtri_wide_add_product(&element[j], &u[i], &u[j]);
        qtri_wide_sub_product(&element[j], &w, &u[k]);
        qtri_wide_mul_by(&element[j], &twice);
        qtri_wide_add_product(&element[k], &u[i], &u[k]);
        qtri_wide_add_product(&element[k], &w, &u[j]);
        qtri_wide_mul_by(&element[k], &twice);
        qtri_row_from_wide(&builder.row[i], element);
    }
    qtri_transform_mul(t, t, &builder);
}

/* t in +-2^61 and an exponent that builders make: a user's row may hold any bits. */
static inline bool is_sound(const qtri_row *row)
{
    const uint32_t most = (uint32_t)1 << 29;
    return (uint32_t)(row->t >> 32) + most < 2 * most && (uint32_t)row->exponent + 4096u <= 8192u;
}

static bool is_linear_zero(const qtri_row *row)
{
    return (row->m[0] | row->m[1] | row->m[2]) == 0;
}

/* Whether the last row is 0 0 0 1, as in all but projections, and the others are sound. */
static bool is_affine(const qtri_transform *b)
{
    return is_linear_zero(&b->row[3]) && b->row[3].t == (int64_t)1 << 59 &&
           b->row[3].exponent == 59 - 16 && is_sound(&b->row[0]) && is_sound(&b->row[1]) &&
           is_sound(&b->row[2]);
}

/* out = a b, out not b. It may be a: a row of the product needs only that row of a. */
QTRI_NOINLINE static void mul_rows(qtri_transform *out, const qtri_transform *a,
                                   const qtri_transform *b)
{
    const qtri_row *const row[3] = {&b->row[0], &b->row[1], &b->row[2]};
    const bool affine = is_affine(b);
    for (int i = 0; i < 4; i++) {
        const qtri_row *left = &a->row[i];
        const bool quick = affine && is_sound(left);
        if (quick && is_linear_zero(left)) {
            out->row[i] = *left;
        } else if (!quick ||
                   !qtri_row_combine(&out->row[i], row, left->m, 3, left->exponent, left->t)) {
            qtri_row_mul(&out->row[i], left, b);
        }
    }
}

/* b = a b. */
QTRI_NOINLINE static void mul_onto(qtri_transform *b, const qtri_transform *a)
{
    const qtri_transform copy = *b;
    mul_rows(b, a, &copy);
}

void qtri_transform_mul(qtri_transform *out, const qtri_transform *a, const qtri_transform *b)
{
    QTRI_ASSERT(out != NULL && a != NULL && b != NULL);
    if (out == b) {
        mul_onto(out, a);
    } else {
        mul_rows(out, a, b);
    }
}

/* ---- Orthonormalization ---- */

/*
 * Gram and Schmidt, once over: what is taken from y along x is short, and wide scalars have 60
 * bits. A pair that is parallel to 2^-50 has no plane.
 */
void qtri_transform_orthonormalize(qtri_transform *t)
{
    QTRI_ASSERT(t != NULL);
    qtri_wide axis[3][4];
    qtri_wide z[3];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            axis[i][k] = qtri_row_element(&t->row[i], k);
        }
    }
    if (!qtri_wide_normalize(axis[0]) || !qtri_wide_normalize(axis[1])) {
        return;
    }
    const qtri_wide along = qtri_wide_inner(axis[0], axis[1]);
    for (int i = 0; i < 3; i++) {
        qtri_wide_sub_product(&axis[1][i], &along, &axis[0][i]);
        if (axis[1][i].e > 112) { /* the noise of unit vectors, as in camera.c */
            qtri_wide_set(&axis[1][i], 0, 0);
        }
    }
    if (!qtri_wide_normalize(axis[1])) {
        return;
    }
    qtri_wide_cross(z, axis[0], axis[1]);
    const qtri_wide side = qtri_wide_inner(z, axis[2]);
    if (side.m == 0) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        axis[2][i] = z[i];
        axis[2][i].m = side.m < 0 ? -z[i].m : z[i].m;
    }
    for (int i = 0; i < 3; i++) {
        qtri_row_from_wide(&t->row[i], axis[i]);
    }
}
