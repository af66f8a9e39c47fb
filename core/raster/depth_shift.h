/* SPDX-License-Identifier: MIT */
/*
 * Depths of a triangle that are moved as a whole: material.depth_shift. Internal.
 */
#ifndef QTRI_RASTER_DEPTH_SHIFT_H
#define QTRI_RASTER_DEPTH_SHIFT_H

#include "large.h"
#include "raster.h"

struct qtri_depth_shift {
    qtri_route draw; /* a route: moves depths, and goes on as if there were none */
    /* For pipelines: a small triangle, which its state's pipeline draws then; and the vertices of a
       large one. */
    bool (*small)(struct qtri_small *triangle);
    void (*move)(qtri_large_vertex moved[3], const qtri_draw_state *state,
                 const qtri_screen_point *const p[3], int64_t area, const qtri_large_vertex v[3]);
};

#endif
