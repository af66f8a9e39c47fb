/* SPDX-License-Identifier: MIT */
/*
 * Transforms that keep their precision: poses, cameras, projections and the products they form.
 *
 * A Q16.16 matrix that has been rounded, multiplied and rounded again misplaces vertices by up to a
 * tenth of a pixel. A qtri_transform is a 4x4 matrix whose rows are block-normalised: three 31-bit
 * mantissas and one exponent for the linear part, and a 62-bit translation in the scale of the
 * products it is added to. Rotations keep 2^-30, and translations are never rounded to Q16.16.
 *
 * Builders multiply from the right, as OpenGL's matrix stack does: after translate then rotate, a
 * point is first rotated, then translated. Right-handed, column vectors, degrees. Every builder is
 * defined for every argument; a division by zero inside one saturates.
 */
#ifndef QTRI_TRANSFORM_H
#define QTRI_TRANSFORM_H

#include "mat.h"
#include "quat.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * One row: m . (x, y, z) 2^-exponent + t 2^-(exponent + 16) w, for real x, y, z, w.
 * |m| <= 2^30 and |t| < 2^61, so that m . p + t stays below 2^63 for every Q16.16 point p.
 */
typedef struct qtri_row {
    int64_t t;
    int32_t m[3];
    int32_t exponent;
} qtri_row;

/* A homogeneous transform, at more precision than a matrix of Q16.16. */
typedef struct qtri_transform {
    qtri_row row[4];
} qtri_transform;

/* The transform that moves nothing. */
void qtri_transform_identity(qtri_transform *out);

/* The user's own matrix; loses nothing below 2^14 and at most 2^-30 of a row's largest element. */
void qtri_transform_from_mat4(qtri_transform *out, const qtri_mat4 *m);

/* The nearest Q16.16 matrix, saturated: for display and tests. */
void qtri_transform_to_mat4(const qtri_transform *a, qtri_mat4 *out);

/* out = a b. out may be a or b. */
void qtri_transform_mul(qtri_transform *out, const qtri_transform *a, const qtri_transform *b);

/* t = t * a translation, a scale or a rotation: points are moved by the latter first. */
void qtri_transform_translate(qtri_transform *t, qtri_vec3 offset);
void qtri_transform_scale(qtri_transform *t, qtri_vec3 factor);
void qtri_transform_rotate_x(qtri_transform *t, q16 degrees);
void qtri_transform_rotate_y(qtri_transform *t, q16 degrees);
void qtri_transform_rotate_z(qtri_transform *t, q16 degrees);

/* About an axis of any length through the origin (Rodrigues); a zero axis does nothing. */
void qtri_transform_rotate(qtri_transform *t, q16 degrees, qtri_vec3 axis);

/* About an axis through a point. */
void qtri_transform_rotate_about(qtri_transform *t, q16 degrees, qtri_vec3 axis, qtri_vec3 point);

/*
 * Turns a triangle in its own plane: about its normal (v1 - v0) x (v2 - v0) through its centroid,
 * both unrounded. A triangle without area does nothing.
 */
void qtri_transform_rotate_triangle(qtri_transform *t, q16 degrees, const qtri_vec3 v[3]);

/* An orientation; q need not have unit length, zero does nothing. */
void qtri_transform_rotate_quat(qtri_transform *t, qtri_quat q);

/*
 * Camera: world to eye, looking from eye to center. up need not be perpendicular; when it is zero
 * or along the view direction, +y takes its place, or +z when that is parallel too.
 * eye = center looks down -z.
 */
void qtri_transform_look_at(qtri_transform *t, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up);

/*
 * A camera that looks at `center` from a distance: azimuth degrees around it to the right of +z,
 * elevation degrees above its horizon, past the poles as well. All 0: from +z, as look_at with +y.
 */
void qtri_transform_orbit(qtri_transform *t, qtri_vec3 center, q16 distance, q16 azimuth,
                          q16 elevation);

/*
 * Billboards: turns what follows so that its x and y axes are those of the picture of `camera`, a
 * product of turns, translations and even scales. With an upright one, y stays up and only z turns
 * to the camera, as trees and people want it. A camera without directions does nothing.
 */
void qtri_transform_billboard(qtri_transform *t, const qtri_transform *camera);
void qtri_transform_billboard_upright(qtri_transform *t, const qtri_transform *camera);

/*
 * Makes the linear part a rotation again, or one with a reflection, after so many products that
 * roundings have stretched it: x keeps its direction, y the plane of the two, z follows. To 2^-28;
 * ten thousand products of rotations are off by about 2^-17 without it. Translation and the row of
 * w stay. Where x and y have no directions of their own, or z lies in their plane, nothing changes.
 */
void qtri_transform_orthonormalize(qtri_transform *t);

/*
 * Projections to OpenGL clip space (-w..w). fovy: vertical field of view in (0, 180) degrees;
 * aspect: width / height; near and far: distances > 0. Elements are within 2^-27 of themselves, for
 * the narrowest fovy, 1/65536 degree, too. Source: COURSE formulae, glFrustum.
 *
 * Outside of that range: a negative fovy turns the picture by half a turn, a negative aspect
 * mirrors it left to right, left > right and bottom > top mirror it along their axis; what is
 * mirrored once has its front faces clockwise. near_z > far_z keeps what is seen and reverses
 * depth, near_z's plane being 0 still: then QTRI_GREATER, and depth that is cleared to 0, draw what
 * LESS does otherwise.
 */
void qtri_transform_perspective(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z);
void qtri_transform_frustum(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top, q16 near_z,
                            q16 far_z);
void qtri_transform_ortho(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top, q16 near_z,
                          q16 far_z);

/*
 * Direct3D's left-handed forms: the camera looks along +z, clip z is in 0..w. Converted here: what
 * follows sees OpenGL clip space with the same picture and the same window depth, and
 * counter-clockwise in the picture is front all the same; Direct3D's own default is
 * QTRI_CULL_FRONT. The viewport that goes with them is qtri_viewport_top. Arguments without a
 * direction or outside of their range do what they do in the forms above.
 */
void qtri_transform_look_at_d3d(qtri_transform *t, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up);
void qtri_transform_frustum_d3d(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top,
                                q16 near_z, q16 far_z);
void qtri_transform_ortho_d3d(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top,
                              q16 near_z, q16 far_z);
void qtri_transform_perspective_d3d(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z);

#ifdef __cplusplus
}
#endif

#endif
