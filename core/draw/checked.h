/* SPDX-License-Identifier: MIT */
/*
 * Assertions on the arguments of draw calls, for checked builds. Internal.
 */
#ifndef QTRI_DRAW_CHECKED_H
#define QTRI_DRAW_CHECKED_H

#include "qtri/light.h"
#include "qtri/mesh.h"
#include "qtri/prepared.h"
#include "qtri/view.h"

#include "../raster/checked_material.h"

#ifdef QTRI_CHECKED
/* The view's transforms and viewport and the pose are initialised; its vertices have memory. */
void qtri_check_view(const qtri_view *view, const qtri_transform *pose);

/* The mesh has the arrays that its counts say; every index is below the count of vertices. */
void qtri_check_mesh(const qtri_mesh *mesh);

/* No colour has an integer 1, and no angle integer degrees, in place of a Q16.16. */
void qtri_check_lights(const qtri_light_source *sources, uint32_t count,
                       const qtri_light_color *ambient);

/* qtri_prepared_init() was called: no field has a value that none ever gets. */
void qtri_check_prepared(const qtri_prepared *prepared);

/* `count` is a multiple of `each`, the corners of a primitive. */
void qtri_check_corners(const void *corners, uint32_t count, uint32_t each);
#endif

#endif
