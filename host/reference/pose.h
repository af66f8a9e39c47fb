/* SPDX-License-Identifier: MIT */
/*
 * Matrices of poses and cameras beyond those of matrix.h, in double precision.
 */
#ifndef QTRI_HOST_REFERENCE_POSE_H
#define QTRI_HOST_REFERENCE_POSE_H

#include <stdbool.h>
#include <stddef.h>

#include "../io/scene.h"
#include "matrix.h"

struct ref_matrix ref_matrix_rotate_about(double degrees, const double axis[3],
                                          const double point[3]);

/* Of points v[0..2], v[3..5], v[6..8]: about their normal through their mean; without: none. */
struct ref_matrix ref_matrix_rotate_triangle(double degrees, const double v[9]);

/* w x y z, of any length but 0. */
struct ref_matrix ref_matrix_quaternion(const double q[4]);

/* A camera at `distance` from center: azimuth to the right of +z, elevation above the horizon. */
struct ref_matrix ref_matrix_orbit(const double center[3], double distance, double azimuth,
                                   double elevation);

/*
 * Direct3D's: left-handed, the camera looks along +z, as its documentation writes them, with clip z
 * taken from 0..w to -w..w.
 */
struct ref_matrix ref_matrix_look_at_d3d(const double eye[3], const double center[3],
                                         const double up[3]);
struct ref_matrix ref_matrix_perspective_d3d(double fovy_degrees, double aspect, double near,
                                             double far);
struct ref_matrix ref_matrix_frustum_d3d(const double bounds[6]);
struct ref_matrix ref_matrix_ortho_d3d(const double bounds[6]);

/*
 * The first row of the linear part with length 1, the second what is across it in their plane, the
 * third across both, on the side where it was. As it is where there is no such plane or side.
 */
struct ref_matrix ref_matrix_orthonormalized(const struct ref_matrix *matrix);

/* Turns x, y and z to the directions that are right, up and towards the eye for `camera`; upright:
   y stays, and z turns to the eye as far as that lets it. */
struct ref_matrix ref_matrix_billboard(const struct ref_matrix *camera, bool upright);

/* Place, turn and size between the keys around a time; orientations on the shortest arc. */
struct ref_matrix ref_matrix_keys(const struct scene_key *keys, size_t count, int32_t time);

#endif
