/* SPDX-License-Identifier: MIT */
/*
 * What encloses a mesh, and whether it can be seen.
 *
 *     qtri_box box = qtri_mesh_box(&mesh);
 *     if (qtri_view_sees_box(&view, &pose, &box)) { ... }
 *
 * Draw calls skip a mesh that cannot be seen by themselves when mesh->bounds is set; asking is for
 * groups of meshes, and for what is worth preparing at all.
 */
#ifndef QTRI_BOUNDS_H
#define QTRI_BOUNDS_H

#include <stdbool.h>

#include "mesh.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The points within `radius` of `center`. */
typedef struct qtri_ball {
    qtri_vec3 center;
    q16 radius;
} qtri_ball;

/*
 * Holds all positions, wide or 16-bit, in object space; no larger than it must be by more than one
 * step on each side, two with 16-bit positions. All 0 without positions. Sides saturate.
 */
qtri_box qtri_mesh_box(const qtri_mesh *mesh);

/* Around the centre of the box: the largest distance of a position, rounded up; saturates. */
qtri_ball qtri_mesh_ball(const qtri_mesh *mesh);

/*
 * Whether something inside could be seen in the view's viewport, posed as `pose` says. False means
 * that nothing can; true may be said of what just misses the frustum.
 */
bool qtri_view_sees_box(const qtri_view *view, const qtri_transform *pose, const qtri_box *box);
bool qtri_view_sees_ball(const qtri_view *view, const qtri_transform *pose, const qtri_ball *ball);

#ifdef __cplusplus
}
#endif

#endif
