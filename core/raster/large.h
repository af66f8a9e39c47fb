/* SPDX-License-Identifier: MIT */
/*
 * Large triangles, and those of which perspective or depth must be exact, drawn by a draw call's
 * pipeline. Internal.
 */
#ifndef QTRI_RASTER_LARGE_H
#define QTRI_RASTER_LARGE_H

#include "qtri/body/state.h"
#include "qtri/view.h"

/* A vertex but for its place on the screen; what options do not ask for need not be set. */
typedef struct qtri_large_vertex {
    uint32_t depth_16p16; /* <= 65535.0 */
    uint32_t inv_w_q31;   /* 2^30..2^31 */
    int32_t inv_w_exponent;
    uint32_t light_q15;    /* with QTRI_LIGHT */
    int32_t color_8p16[3]; /* with QTRI_COLORS */
    int64_t u_q32, v_q32;  /* 2^32 is a repeat */
    int16_t rest[2];       /* of x and y: the true place less the snapped one, 2^-24 pixel */
    uint32_t alpha_q16;    /* with vertex_alpha */
} qtri_large_vertex;

/*
 * `area`: qtri_triangle_area() of the points; 0 draws nothing. color_rgb: 0x00RRGGBB, with
 * QTRI_FLAT and QTRI_TINT. state->pipeline is not NULL.
 */
void qtri_large_triangle(qtri_draw_state *state, const qtri_point *const p[3], int64_t area,
                         uint32_t color_rgb, const qtri_large_vertex v[3]);

/* The least and the greatest of the three vertices' values. */
static inline void qtri_find_range(uint32_t *least, uint32_t *greatest, const uint32_t f[3])
{
    *least = f[0];
    *greatest = f[0];
    for (int i = 1; i < 3; i++) {
        *least = f[i] < *least ? f[i] : *least;
        *greatest = f[i] > *greatest ? f[i] : *greatest;
    }
}

#endif
