/* SPDX-License-Identifier: MIT */
/*
 * Checks of what the rasterizer is given, for checked builds. Internal.
 */
#ifndef QTRI_RASTER_CHECKED_MATERIAL_H
#define QTRI_RASTER_CHECKED_MATERIAL_H

#include "qtri/pipeline.h"
#include "qtri/stroke.h"
#include "qtri/surface.h"

#include "../frame/depth_format.h"

#ifdef QTRI_CHECKED
/* One that qtri_surface_init has made, or refused to. */
void qtri_check_surface(const qtri_surface *surface);

/* Its enums, and its texture. */
void qtri_check_material(const qtri_material *material);

/* The view's list has one for these options. */
void qtri_check_pipeline(const qtri_pipeline *found, const qtri_options *wanted);

/* There is one, and its width is no plain number. */
void qtri_check_stroke(const qtri_stroke *stroke);
#endif

#endif
