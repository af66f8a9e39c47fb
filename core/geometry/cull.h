/* SPDX-License-Identifier: MIT */
/*
 * Culling by planes of faces: the eye in a mesh's coordinates, and its side of a plane. Internal.
 */
#ifndef QTRI_GEOMETRY_CULL_H
#define QTRI_GEOMETRY_CULL_H

#include "projector.h"

/*
 * The eye, homogeneous, in extents of the mesh about its origin, w negated; or all of it negated,
 * to cull front faces. |x|, |y|, |z| <= 2^21, |w| < 2^22, behind < 2^29: sums stay below
 * 2^31.
 */
typedef struct qtri_eye {
    int32_t x, y, z, w;
    int32_t behind; /* qtri_eye_side() of at least this: a face turns away; -this or less: not */
} qtri_eye;

/*
 * Finds the eye for a projector after qtri_projector_compact() by the mesh's origin and extent.
 * False where planes tell nothing: the mesh, within faces->radius_q14, is not all between the near
 * and the far plane and well inside the guard band, or so small on the screen that snapping may
 * turn any face.
 */
bool qtri_eye_find(qtri_eye *eye, const qtri_projector *projector, const qtri_faces *faces);

/* From then on faces that turn towards the eye are culled, not those that turn away. */
void qtri_eye_mirror(qtri_eye *eye);

/* How far behind a face's plane the eye is, in units of `behind`. */
static inline int32_t qtri_eye_side(const qtri_eye *eye, const qtri_face8 *face)
{
    int32_t sum = face->x * eye->x;
    QTRI_HOLD(sum); /* one product at a time: GCC 12 would interleave them, and spill */
    sum += face->y * eye->y;
    QTRI_HOLD(sum);
    sum += face->z * eye->z;
    QTRI_HOLD(sum);
    sum += face->d * eye->w;
    QTRI_HOLD(sum);
    return sum;
}

/*
 * Whether a triangle of this plane is sure to turn away: snapped to the screen, as the vertex stage
 * does, its area is above 0; below 0 after qtri_eye_mirror().
 */
static inline bool qtri_eye_is_behind(const qtri_eye *eye, const qtri_face8 *face)
{
    return qtri_eye_side(eye, face) >= eye->behind;
}

/* Whether it is sure not to turn away: the bound is the same for both signs. */
static inline bool qtri_eye_is_before(const qtri_eye *eye, const qtri_face8 *face)
{
    return qtri_eye_side(eye, face) <= -eye->behind;
}

#endif
