/* SPDX-License-Identifier: MIT */
/*
 * 4x4 matrices in double precision and the transforms of the scene language.
 *
 * Column vectors: a point p is transformed to M p, and `current = current * M` applies M first.
 * Every builder is total: arguments without meaning (a zero axis, an eye that is its own centre)
 * have the value its comment states; a division by zero gives infinities, which the rasterizers
 * refuse to draw.
 */
#ifndef QTRI_HOST_REFERENCE_MATRIX_H
#define QTRI_HOST_REFERENCE_MATRIX_H

#include <stdint.h>

struct ref_matrix {
    double m[4][4]; /* [row][column] */
};

struct ref_matrix ref_matrix_identity(void);
struct ref_matrix ref_matrix_multiply(const struct ref_matrix *a, const struct ref_matrix *b);

/* out = M v. out may be v. */
void ref_matrix_transform(const struct ref_matrix *matrix, const double v[4], double out[4]);

/* 16 numbers in Q16.16, column-major as in OpenGL. */
struct ref_matrix ref_matrix_load(const int32_t number[16]);

struct ref_matrix ref_matrix_translate(const double v[3]);
struct ref_matrix ref_matrix_scale(const double v[3]);

/* Counter-clockwise about an axis of any length (Rodrigues); a zero axis gives the identity. */
struct ref_matrix ref_matrix_rotate(double degrees, const double axis[3]);

/*
 * Camera at `eye` looking at `center`. `up` need not be perpendicular. Where it has no direction
 * of its own (zero, or parallel to the line of sight) it is replaced by +y, and if the line of
 * sight is along y, by +z. An eye equal to its centre looks down -z.
 */
struct ref_matrix ref_matrix_look_at(const double eye[3], const double center[3],
                                     const double up[3]);

/* OpenGL forms: right-handed eye space, clip z -w at `near`, +w at `far`. */
struct ref_matrix ref_matrix_perspective(double fovy_degrees, double aspect, double near,
                                         double far);
/* bounds: left, right, bottom, top, near, far */
struct ref_matrix ref_matrix_frustum(const double bounds[6]);
struct ref_matrix ref_matrix_ortho(const double bounds[6]);

/*
 * Inverse transpose of the upper left 3x3, up to a positive factor (normals are normalised
 * afterwards): the cofactors with the sign of the determinant. All zero for a singular matrix.
 */
void ref_matrix_normal(const struct ref_matrix *matrix, double out[3][3]);

/* Exact at multiples of 90 degrees, sine equal to cosine at 45. */
void ref_sincos_degrees(double degrees, double *sine, double *cosine);

/* Numbers in Q16.16; and one that is held to 0..1. */
void ref_from_q16(const int32_t *in, int count, double *out);
double ref_unit_from_q16(int32_t v);

double ref_dot3(const double a[3], const double b[3]);
void ref_cross3(const double a[3], const double b[3], double out[3]);
/* A zero vector stays zero. */
void ref_normalise3(double v[3]);

#endif
