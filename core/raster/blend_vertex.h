/* SPDX-License-Identifier: MIT */
/*
 * Alpha that varies between the vertices of a triangle. Internal.
 *
 * A blend by vertex gives its raster a route (raster.h): every triangle is drawn by the stages of
 * large ones, on a raster of its own whose colours have 8 bits a channel, and whose `planes` say
 * what alpha is at a pixel. What is interpolated, textured and fogged is what it is without; the
 * blend alone looks at the planes.
 */
#ifndef QTRI_RASTER_BLEND_VERTEX_H
#define QTRI_RASTER_BLEND_VERTEX_H

#include "effect.h"
#include "triangle.h"

/* Alphas are those of the material, of the vertices with these numbers. */
struct qtri_vertex_blend {
    /* Sets the route, and units and format for the stages that are chosen next. */
    void (*begin)(qtri_raster *raster);
    qtri_route draw;
    /* Of the vertices of a triangle that is not clipped. */
    void (*set)(qtri_attributes v[3], const qtri_raster *raster, const uint32_t index[3]);
    /* Of one that may be: are kept in the batch. Then alpha at a point of it, as clip.h has it. */
    void (*note)(const qtri_raster *raster, const uint32_t index[3]);
    uint32_t (*at)(const qtri_raster *raster, int32_t b1_q30, int32_t b2_q30);
};

/* That of a raster; NULL: alpha does not vary. */
static inline const qtri_vertex_blend *qtri_by_vertex(const qtri_raster *raster)
{
    return raster->blend != NULL ? raster->blend->by_vertex : NULL;
}

#endif
