#include "qtri/transform.h"

#include "../math/sincos.h"
#include "row.h"

static const qtri_wide zero = {0, 0};

static void row_set(qtri_row *row, qtri_wide x, qtri_wide y, qtri_wide z, qtri_wide t)
{
    qtri_wide element[4] = {x, y, z, t};
    qtri_row_from_wide(row, element);
}

/* side = forward x up, normalised; substitutes for an up that has no part across forward. */
static void side_axis(qtri_wide side[3], const qtri_wide forward[3], qtri_vec3 up)
{
    qtri_vec3 candidates[3] = {up, {0, Q16_ONE, 0}, {0, 0, Q16_ONE}};
    for (int i = 0; i < 3; i++) {
        qtri_wide candidate[3] = {qtri_wide_q16(candidates[i].x), qtri_wide_q16(candidates[i].y),
                                  qtri_wide_q16(candidates[i].z)};
        if (!qtri_wide_normalize(candidate)) {
            continue;
        }
        qtri_wide_cross(side, forward, candidate);
        for (int axis = 0; axis < 3; axis++) {
            if (side[axis].e > 112) { /* below 2^-50: the noise of parallel unit vectors */
                side[axis] = zero;
            }
        }
        if (qtri_wide_normalize(side)) {
            return;
        }
    }
}

void qtri_transform_look_at(qtri_transform *t, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up)
{
    qtri_wide position[3] = {qtri_wide_q16(eye.x), qtri_wide_q16(eye.y), qtri_wide_q16(eye.z)};
    qtri_wide target[3] = {qtri_wide_q16(center.x), qtri_wide_q16(center.y),
                           qtri_wide_q16(center.z)};
    qtri_wide axis[3][3]; /* side, up, forward */
    for (int i = 0; i < 3; i++) {
        axis[2][i] = qtri_wide_sub(target[i], position[i]);
    }
    if (!qtri_wide_normalize(axis[2])) {
        axis[2][2] = qtri_wide_make(-1, 0);
    }
    side_axis(axis[0], axis[2], up);
    qtri_wide_cross(axis[1], axis[0], axis[2]);
    for (int i = 0; i < 3; i++) {
        axis[2][i] = qtri_wide_neg(axis[2][i]);
    }

    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        /* The eye itself maps to 0. */
        qtri_row_about(&builder.row[i], axis[i], position, zero);
    }
    qtri_transform_mul(t, t, &builder);
}

/* cot(degrees / 2), from the form of the half-angle formula that does not cancel. */
static qtri_wide half_cotangent(q16 degrees)
{
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    int64_t one_q30 = (int64_t)1 << 30;
    qtri_wide sine = qtri_wide_make(sine_q30, 30);
    if (cosine_q30 >= 0) {
        return qtri_wide_div(qtri_wide_make(one_q30 + cosine_q30, 30), sine);
    }
    return qtri_wide_div(sine, qtri_wide_make(one_q30 - cosine_q30, 30));
}

static qtri_wide sum(q16 a, q16 b)
{
    return qtri_wide_make((int64_t)a + b, 16);
}

static qtri_wide difference(q16 a, q16 b)
{
    return qtri_wide_make((int64_t)a - b, 16);
}

/* 2 f n / (n - f) */
static qtri_wide depth_offset(q16 near_z, q16 far_z)
{
    qtri_wide product = qtri_wide_mul(qtri_wide_q16(far_z), qtri_wide_q16(near_z));
    return qtri_wide_div(qtri_wide_add(product, product), difference(near_z, far_z));
}

static void perspective(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z,
                        int64_t toward)
{
    qtri_wide g = half_cotangent(fovy);
    qtri_wide slope = qtri_wide_div(sum(far_z, near_z), difference(near_z, far_z));
    qtri_transform builder;
    row_set(&builder.row[0], qtri_wide_div(g, qtri_wide_q16(aspect)), zero, zero, zero);
    row_set(&builder.row[1], zero, g, zero, zero);
    row_set(&builder.row[2], zero, zero, toward < 0 ? slope : qtri_wide_neg(slope),
            depth_offset(near_z, far_z));
    row_set(&builder.row[3], zero, zero, qtri_wide_make(toward, 0), zero);
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_perspective(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z)
{
    perspective(t, fovy, aspect, near_z, far_z, -1);
}

/* z' = z f/(f-n) - fn/(f-n) in 0..w becomes 2 z' - w: the OpenGL row for a camera along +z. */
void qtri_transform_perspective_d3d(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z)
{
    perspective(t, fovy, aspect, near_z, far_z, 1);
}

void qtri_transform_frustum(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top, q16 near_z,
                            q16 far_z)
{
    qtri_wide twice_near = sum(near_z, near_z);
    qtri_transform builder;
    row_set(&builder.row[0], qtri_wide_div(twice_near, difference(right, left)), zero,
            qtri_wide_div(sum(right, left), difference(right, left)), zero);
    row_set(&builder.row[1], zero, qtri_wide_div(twice_near, difference(top, bottom)),
            qtri_wide_div(sum(top, bottom), difference(top, bottom)), zero);
    row_set(&builder.row[2], zero, zero,
            qtri_wide_div(sum(far_z, near_z), difference(near_z, far_z)),
            depth_offset(near_z, far_z));
    row_set(&builder.row[3], zero, zero, qtri_wide_make(-1, 0), zero);
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_ortho(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top, q16 near_z,
                          q16 far_z)
{
    qtri_wide two = qtri_wide_make(2, 0);
    qtri_transform builder;
    qtri_transform_identity(&builder);
    row_set(&builder.row[0], qtri_wide_div(two, difference(right, left)), zero, zero,
            qtri_wide_div(sum(right, left), difference(left, right)));
    row_set(&builder.row[1], zero, qtri_wide_div(two, difference(top, bottom)), zero,
            qtri_wide_div(sum(top, bottom), difference(bottom, top)));
    row_set(&builder.row[2], zero, zero, qtri_wide_div(two, difference(near_z, far_z)),
            qtri_wide_div(sum(far_z, near_z), difference(near_z, far_z)));
    qtri_transform_mul(t, t, &builder);
}
