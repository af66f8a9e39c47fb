/* SPDX-License-Identifier: MIT */
/*
 * Q16.16 matrices, m[row][column], acting on column vectors: M v; (A B) v = A (B v). For
 * application code and matrices that come from elsewhere: what reaches the screen goes through
 * qtri_transform (transform.h), which keeps the bits that a Q16.16 product loses.
 *
 * Every function is defined for every argument. An element is rounded once, to nearest, from 64
 * bits or more, and saturates; builders are within .51 ULP (2^-16), right angles are exact. Angles
 * are degrees, counter-clockwise seen against the axis (right-handed). Sources: COURSE formulae;
 * Foley, van Dam, "Computer Graphics", chapter 5.
 */
#ifndef QTRI_MAT_H
#define QTRI_MAT_H

#include <stdbool.h>

#include "vec.h"

#ifdef __cplusplus
extern "C" {
#endif

/* 2D homogeneous transforms, or linear maps of space. */
typedef struct qtri_mat3 {
    q16 m[3][3];
} qtri_mat3;

/* 3D homogeneous transforms. */
typedef struct qtri_mat4 {
    q16 m[4][4];
} qtri_mat4;

/* ---- 2D homogeneous transforms ---- */

/* Builders of transforms of the plane: p' = M p. */
qtri_mat3 qtri_mat3_identity(void);
qtri_mat3 qtri_mat3_translate(qtri_vec2 offset);
qtri_mat3 qtri_mat3_scale(qtri_vec2 factor); /* negative factors reflect */
qtri_mat3 qtri_mat3_shear(q16 x_by_y, q16 y_by_x);
qtri_mat3 qtri_mat3_rotate_deg(q16 degrees); /* about the origin, counter-clockwise */

/* About a point, which stays where it is to .5 ULP: the offset fits the rounded sine and cosine. */
qtri_mat3 qtri_mat3_rotate_about_deg(q16 degrees, qtri_vec2 point);

/* In the line through the origin at this angle to the x axis: 0 negates y, 90 negates x. */
qtri_mat3 qtri_mat3_reflect_deg(q16 degrees);

/* M (p, 1) and M (v, 0), for a transform whose last row is 0 0 1: points move, vectors do not. */
qtri_vec2 qtri_mat3_point(const qtri_mat3 *m, qtri_vec2 p);
qtri_vec2 qtri_mat3_vector(const qtri_mat3 *m, qtri_vec2 v);

/* ---- Both kinds ---- */

/* Product, transpose, and the product with a vector. */
qtri_mat3 qtri_mat3_mul(const qtri_mat3 *a, const qtri_mat3 *b); /* first b, then a */
qtri_mat3 qtri_mat3_transpose(const qtri_mat3 *a);
qtri_vec3 qtri_mat3_vec3(const qtri_mat3 *m, qtri_vec3 v);

/* Correctly rounded: the sum is exact before. */
q16 qtri_mat3_determinant(const qtri_mat3 *m);

/*
 * The inverse. Cofactors and determinant are exact, so that every element is within .5001 ULP of
 * that of the inverse of this Q16.16 matrix, however badly conditioned, and elements beyond the
 * range saturate. A singular matrix, and only that, gives false and the identity. out may be m.
 */
bool qtri_mat3_inverse(qtri_mat3 *out, const qtri_mat3 *m);

/* ---- 3D transforms ---- */

/* Builders of transforms of space: p' = M p. */
qtri_mat4 qtri_mat4_identity(void);
qtri_mat4 qtri_mat4_translate(qtri_vec3 offset);
qtri_mat4 qtri_mat4_scale(qtri_vec3 factor); /* negative factors reflect */

/* x' = x + x_by_y y + x_by_z z, and so on. */
qtri_mat4 qtri_mat4_shear(q16 x_by_y, q16 x_by_z, q16 y_by_x, q16 y_by_z, q16 z_by_x, q16 z_by_y);

/*
 * In the plane x p.x + y p.y + z p.z + w = 0 for points p; (x, y, z) of any length (w is in the
 * same scale). A zero normal gives the identity.
 */
qtri_mat4 qtri_mat4_reflect(qtri_vec4 plane);

/* Turns about the axes of the coordinates. */
qtri_mat4 qtri_mat4_rotate_x_deg(q16 degrees);
qtri_mat4 qtri_mat4_rotate_y_deg(q16 degrees);
qtri_mat4 qtri_mat4_rotate_z_deg(q16 degrees);

/* About an axis of any length through the origin (Rodrigues). A zero axis gives the identity. */
qtri_mat4 qtri_mat4_rotate_axis_deg(qtri_vec3 axis, q16 degrees);

/* About an axis through a point, which stays where it is to .5 ULP. */
qtri_mat4 qtri_mat4_rotate_about_deg(qtri_vec3 axis, q16 degrees, qtri_vec3 point);

/*
 * Euler and Tait-Bryan angles. The order is that in which the turns about the fixed axes happen:
 * xyz turns about x first, then y, then z, and is Rz Ry Rx. (The same angles about axes that move
 * along happen in the reverse order: yaw about z, pitch about the new y, roll about the new x is
 * xyz.) degrees.x is the turn about x wherever x stands in the order.
 */
typedef enum qtri_euler {
    QTRI_EULER_XYZ = 0x210, /* the first axis in the lowest digit */
    QTRI_EULER_XZY = 0x120,
    QTRI_EULER_YXZ = 0x201,
    QTRI_EULER_YZX = 0x021,
    QTRI_EULER_ZXY = 0x102,
    QTRI_EULER_ZYX = 0x012
} qtri_euler;

/* The rotation by these angles. Other orders turn about the axes their digits name, modulo 3. */
qtri_mat4 qtri_mat4_rotate_euler_deg(qtri_vec3 degrees, qtri_euler order);

/* The linear part, and the transform that has it and moves nothing. */
qtri_mat3 qtri_mat4_linear(const qtri_mat4 *m);
qtri_mat4 qtri_mat4_from_linear(const qtri_mat3 *linear);

/* Product and transpose. */
qtri_mat4 qtri_mat4_mul(const qtri_mat4 *a, const qtri_mat4 *b); /* first b, then a */
qtri_mat4 qtri_mat4_transpose(const qtri_mat4 *a);

/* M v, v as a column; out is not v. */
void qtri_mat4_times(q16 out[4], const qtri_mat4 *m, const q16 v[4]);

/* M v, v as a column. */
static inline qtri_vec4 qtri_mat4_vec4(const qtri_mat4 *m, qtri_vec4 v)
{
    const q16 column[4] = {v.x, v.y, v.z, v.w};
    q16 image[4];
    qtri_mat4_times(image, m, column);
    qtri_vec4 result = {image[0], image[1], image[2], image[3]};
    return result;
}

/* M (p, 1) and M (v, 0), for a transform whose last row is 0 0 0 1. */
qtri_vec3 qtri_mat4_point(const qtri_mat4 *m, qtri_vec3 p);
qtri_vec3 qtri_mat4_vector(const qtri_mat4 *m, qtri_vec3 v);

/* As for mat3. The affine inverse takes the last row for 0 0 0 1, whatever it is. */
q16 qtri_mat4_determinant(const qtri_mat4 *m);
bool qtri_mat4_inverse(qtri_mat4 *out, const qtri_mat4 *m);
bool qtri_mat4_inverse_affine(qtri_mat4 *out, const qtri_mat4 *m);

/*
 * The inverse transpose of the linear part: takes normals along, under scale and shear too, up to
 * their length. As accurate as the inverse. Singular: false and the identity.
 */
bool qtri_mat4_normal_matrix(qtri_mat3 *out, const qtri_mat4 *m);

#ifdef __cplusplus
}
#endif

#endif
