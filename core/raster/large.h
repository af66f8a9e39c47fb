/* SPDX-License-Identifier: MIT */
/*
 * Large triangles, and those of which perspective or depth must be exact, drawn by a draw call's
 * pipeline. Internal.
 */
#ifndef QTRI_RASTER_LARGE_H
#define QTRI_RASTER_LARGE_H

#include "qtri/body/state.h"
#include "qtri/view.h"

/*
 * `area`: qtri_triangle_area() of the points; 0 draws nothing. color_rgb: 0x00RRGGBB, with
 * QTRI_FLAT and QTRI_TINT. state->pipeline is not NULL.
 */
void qtri_large_triangle(qtri_draw_state *state, const qtri_point *const p[3], int64_t area,
                         uint32_t color_rgb, const qtri_large_vertex v[3]);

#endif
