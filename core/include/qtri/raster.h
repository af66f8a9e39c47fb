/* SPDX-License-Identifier: MIT */
/*
 * Triangles and lines on the screen: the rasterizer alone, for those who bring their own geometry.
 *
 * Fill rule. Vertices lie on a grid of 1/256 pixel. A pixel belongs to a triangle when its centre
 * lies inside, or on a left edge, or on a horizontal top edge (the top-left rule in image
 * coordinates). Consequences: triangles that share an edge cover each pixel along it exactly once,
 * whatever their order and winding; a triangle without area covers nothing; the pixel at a vertex
 * belongs to at most one of the triangles of a fan around it. Edge arithmetic is exact integers.
 *
 * Lines cover, for every column (or row, when steeper than 45 degrees) whose centre lies in the
 * half-open range between the ends, the pixel that the line passes through at that centre.
 * Both directions give the same pixels; chained lines cover each joint once. Colours are within .51
 * of a step of what is exact, those of a wireframe of one colour within 3/4.
 */
#ifndef QTRI_RASTER_H
#define QTRI_RASTER_H

#include "material.h"
#include "pipeline.h"
#include "q16.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_SCREEN_MAX_24P8 ((int32_t)1 << 22) /* guard band: 16384 pixels */

typedef struct qtri_screen_vertex {
    int32_t x_24p8, y_24p8; /* frame coordinates in 1/256 pixel, held to +-QTRI_SCREEN_MAX_24P8 */
    uint32_t depth_16p16;   /* window z times 65535, 0..65535.0; more is taken as 65535.0 */
    uint32_t inv_w_q31;     /* 1/w = inv_w_q31 2^(inv_w_exponent - 31): any common scale serves, */
    int32_t inv_w_exponent; /*   only the ratios of the three count; 0 is taken as 2^-31 */
    int32_t color_8p16[3];  /* red green blue, 0..255.0; values outside are clamped */
    int64_t u_q32, v_q32;   /* texture coordinates: a Q16.16 times 65536, below 2^48. Clipping cuts
                               large triangles at points between the steps of a Q16.16 */
} qtri_screen_vertex;

/*
 * Draws the inside of v[0] v[1] v[2] as material says, by the first of the pipelines that fits, see
 * pipeline.h; flat shading takes its provoking vertex's colour. material->alphas are those of v.
 * material->fill is for draw calls (draw.h): a wireframe is three lines.
 */
void qtri_raster_triangle(const qtri_surface *surface, const qtri_pipeline *const *pipelines,
                          const qtri_material *material, const qtri_screen_vertex v[3]);

/*
 * Draws the line v[0] v[1]; colour and depth are linear on the screen. Texture, shading,
 * interpolation, culling and inv_w do not apply.
 */
void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2]);

#ifdef __cplusplus
}
#endif

#endif
