#include "qtri/transform.h"

#include "../math/bits.h"
#include "../math/sincos.h"
#include "row.h"

/*
 * The smallest exponent wins: m keeps 30 bits of the largest linear element, t at most 60 bits.
 * |wide m| < 2^62, so a shift of 32 leaves |m| <= 2^30 after rounding, and 2 leave |t| <= 2^60.
 */
void qtri_row_from_wide(qtri_row *row, const qtri_wide element[4])
{
    int32_t exponent = INT32_MAX;
    for (int i = 0; i < 3; i++) {
        if (element[i].m != 0 && element[i].e - 32 < exponent) {
            exponent = element[i].e - 32;
        }
    }
    if (element[3].m != 0 && element[3].e - 18 < exponent) {
        exponent = element[3].e - 18;
    }
    if (exponent == INT32_MAX) {
        exponent = 0; /* a row of zeros */
    }
    for (int i = 0; i < 3; i++) {
        row->m[i] = (int32_t)qtri_shift_round(element[i].m, element[i].e - exponent);
    }
    row->t = qtri_shift_round(element[3].m, element[3].e - exponent - 16);
    row->exponent = exponent;
}

qtri_wide qtri_row_element(const qtri_row *row, int column)
{
    if (column < 3) {
        return qtri_wide_make(row->m[column], row->exponent);
    }
    /* A row of random bits must not overflow; qtri_wide_make makes 0 of such exponents. */
    return qtri_wide_make(row->t, row->exponent > INT32_MAX - 16 ? INT32_MAX : row->exponent + 16);
}

void qtri_row_about(qtri_row *row, const qtri_wide axis[3], const qtri_wide point[3],
                    qtri_wide image)
{
    qtri_wide element[4] = {axis[0], axis[1], axis[2], {0, 0}};
    /* A large translation costs the axis bits: the first pass finds the exponent, the second t. */
    for (int pass = 0; pass < 2; pass++) {
        element[3] = image;
        for (int column = 0; column < 3; column++) {
            element[3] = qtri_wide_sub(element[3], qtri_wide_mul(element[column], point[column]));
        }
        qtri_row_from_wide(row, element);
        for (int column = 0; column < 3; column++) {
            element[column] = qtri_row_element(row, column);
        }
    }
}

static void row_from_q16(qtri_row *row, q16 x, q16 y, q16 z, q16 t)
{
    qtri_wide element[4] = {qtri_wide_q16(x), qtri_wide_q16(y), qtri_wide_q16(z), qtri_wide_q16(t)};
    qtri_row_from_wide(row, element);
}

void qtri_transform_from_mat4(qtri_transform *out, const qtri_mat4 *m)
{
    for (int i = 0; i < 4; i++) {
        row_from_q16(&out->row[i], m->m[i][0], m->m[i][1], m->m[i][2], m->m[i][3]);
    }
}

void qtri_transform_identity(qtri_transform *out)
{
    qtri_mat4 identity = qtri_mat4_identity();
    qtri_transform_from_mat4(out, &identity);
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
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            out->m[i][j] = wide_to_q16(qtri_row_element(&a->row[i], j));
        }
    }
}

void qtri_transform_translate(qtri_transform *t, qtri_vec3 offset)
{
    qtri_transform builder;
    qtri_transform_identity(&builder);
    row_from_q16(&builder.row[0], Q16_ONE, 0, 0, offset.x);
    row_from_q16(&builder.row[1], 0, Q16_ONE, 0, offset.y);
    row_from_q16(&builder.row[2], 0, 0, Q16_ONE, offset.z);
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_scale(qtri_transform *t, qtri_vec3 factor)
{
    qtri_transform builder;
    qtri_transform_identity(&builder);
    row_from_q16(&builder.row[0], factor.x, 0, 0, 0);
    row_from_q16(&builder.row[1], 0, factor.y, 0, 0);
    row_from_q16(&builder.row[2], 0, 0, factor.z, 0);
    qtri_transform_mul(t, t, &builder);
}

/* The right-angled pair of axes (i, j) turned from i towards j. */
static void rotate_plane(qtri_transform *t, q16 degrees, int i, int j)
{
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    qtri_wide row_i[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    qtri_wide row_j[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    row_i[i] = qtri_wide_make(cosine_q30, 30);
    row_i[j] = qtri_wide_make(-(int64_t)sine_q30, 30);
    row_j[i] = qtri_wide_make(sine_q30, 30);
    row_j[j] = row_i[i];

    qtri_transform builder;
    qtri_transform_identity(&builder);
    qtri_row_from_wide(&builder.row[i], row_i);
    qtri_row_from_wide(&builder.row[j], row_j);
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

/*
 * t = t T(point) R(axis) T(-point), Rodrigues: R = c I + (1 - c) n n^T + s [n]x. The translation
 * comes from the rounded rows of R, or it would not cancel for points near `point`.
 */
static void rotate_wide(qtri_transform *t, q16 degrees, qtri_wide axis[3], const qtri_wide point[3])
{
    if (!qtri_wide_normalize(axis)) {
        return;
    }
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    qtri_wide sine = qtri_wide_make(sine_q30, 30);
    qtri_wide cosine = qtri_wide_make(cosine_q30, 30);
    qtri_wide rest = qtri_wide_make(((int64_t)1 << 30) - cosine_q30, 30);

    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        qtri_wide along = qtri_wide_mul(axis[i], rest);
        qtri_wide element[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
        element[i] = qtri_wide_add(cosine, qtri_wide_mul(along, axis[i]));
        element[j] = qtri_wide_sub(qtri_wide_mul(along, axis[j]), qtri_wide_mul(axis[k], sine));
        element[k] = qtri_wide_add(qtri_wide_mul(along, axis[k]), qtri_wide_mul(axis[j], sine));
        qtri_row_about(&builder.row[i], element, point, point[i]);
    }
    qtri_transform_mul(t, t, &builder);
}

static void wide_from_vec3(qtri_wide out[3], qtri_vec3 v)
{
    out[0] = qtri_wide_q16(v.x);
    out[1] = qtri_wide_q16(v.y);
    out[2] = qtri_wide_q16(v.z);
}

void qtri_transform_rotate_about(qtri_transform *t, q16 degrees, qtri_vec3 axis, qtri_vec3 point)
{
    qtri_wide wide_axis[3];
    qtri_wide wide_point[3];
    wide_from_vec3(wide_axis, axis);
    wide_from_vec3(wide_point, point);
    rotate_wide(t, degrees, wide_axis, wide_point);
}

void qtri_transform_rotate(qtri_transform *t, q16 degrees, qtri_vec3 axis)
{
    qtri_vec3 origin = {0, 0, 0};
    qtri_transform_rotate_about(t, degrees, axis, origin);
}

void qtri_transform_rotate_triangle(qtri_transform *t, q16 degrees, const qtri_vec3 v[3])
{
    qtri_wide corner[3][3];
    qtri_wide edge[2][3];
    qtri_wide centroid[3];
    qtri_wide normal[3];
    for (int i = 0; i < 3; i++) {
        wide_from_vec3(corner[i], v[i]);
    }
    for (int axis = 0; axis < 3; axis++) {
        edge[0][axis] = qtri_wide_sub(corner[1][axis], corner[0][axis]);
        edge[1][axis] = qtri_wide_sub(corner[2][axis], corner[0][axis]);
        qtri_wide sum =
            qtri_wide_add(qtri_wide_add(corner[0][axis], corner[1][axis]), corner[2][axis]);
        centroid[axis] = qtri_wide_div(sum, qtri_wide_make(3, 0));
    }
    qtri_wide_cross(normal, edge[0], edge[1]);
    rotate_wide(t, degrees, normal, centroid);
}

/* With |q|^2 = n: R = I - 2/n (y^2 + z^2 ...) and so on: no square root is needed. */
void qtri_transform_rotate_quat(qtri_transform *t, qtri_quat q)
{
    qtri_wide u[3] = {qtri_wide_q16(q.x), qtri_wide_q16(q.y), qtri_wide_q16(q.z)};
    qtri_wide w = qtri_wide_q16(q.w);
    qtri_wide square = qtri_wide_mul(w, w);
    for (int i = 0; i < 3; i++) {
        square = qtri_wide_add(square, qtri_wide_mul(u[i], u[i]));
    }
    if (square.m == 0) {
        return;
    }
    qtri_wide twice = qtri_wide_div(qtri_wide_make(2, 0), square);
    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        qtri_wide others = qtri_wide_add(qtri_wide_mul(u[j], u[j]), qtri_wide_mul(u[k], u[k]));
        qtri_wide minus = qtri_wide_sub(qtri_wide_mul(u[i], u[j]), qtri_wide_mul(w, u[k]));
        qtri_wide plus = qtri_wide_add(qtri_wide_mul(u[i], u[k]), qtri_wide_mul(w, u[j]));
        qtri_wide element[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
        element[i] = qtri_wide_sub(qtri_wide_make(1, 0), qtri_wide_mul(twice, others));
        element[j] = qtri_wide_mul(twice, minus);
        element[k] = qtri_wide_mul(twice, plus);
        qtri_row_from_wide(&builder.row[i], element);
    }
    qtri_transform_mul(t, t, &builder);
}
