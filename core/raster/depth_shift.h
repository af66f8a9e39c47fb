/* SPDX-License-Identifier: MIT */
/*
 * Depths of a triangle that are moved as a whole: material.depth_shift. Internal.
 */
#ifndef QTRI_RASTER_DEPTH_SHIFT_H
#define QTRI_RASTER_DEPTH_SHIFT_H

#include "raster.h"

/* Its route: moves depths, and goes on as if there were none. */
struct qtri_depth_shift {
    qtri_route draw;
};

#endif
