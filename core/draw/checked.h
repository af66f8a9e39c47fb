/* SPDX-License-Identifier: MIT */
/*
 * Checks of what draw calls are given, for checked builds. Internal.
 */
#ifndef QTRI_DRAW_CHECKED_H
#define QTRI_DRAW_CHECKED_H

#include "qtri/light.h"
#include "qtri/mesh.h"
#include "qtri/prepared.h"
#include "qtri/view.h"

#include "../raster/checked_material.h"

#ifdef QTRI_CHECKED
/* Its transforms and its viewport are initialised, its vertices have memory; so is the pose. */
void qtri_check_view(const qtri_view *view, const qtri_transform *pose);

/* It has what its counts say, and every index is below the count of vertices. */
void qtri_check_mesh(const qtri_mesh *mesh);

/* There are as many as `count` says, and none has a plain 1 or plain degrees. */
void qtri_check_lights(const qtri_light_source *sources, uint32_t count,
                       const qtri_light_color *ambient);

/* It was initialised: no field has what none is ever given. */
void qtri_check_prepared(const qtri_prepared *prepared);

/* Corners of primitives of `each`. */
void qtri_check_corners(const void *corners, uint32_t count, uint32_t each);
#endif

#endif
