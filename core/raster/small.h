/*
 * Small triangles of a mesh of one colour, as most are, in RGB565 with depth "less" and written:
 * set up and filled in one go, with the general path's pixels to the bit. Internal.
 *
 * That is flat ones of which qtri_triangle_begin found all spans, and smooth ones that are tiny.
 * The triangle is one that it accepted, with the places of a, b, c. False when it is not that
 * simple: then nothing was drawn.
 */
#ifndef QTRI_RASTER_SMALL_H
#define QTRI_RASTER_SMALL_H

#include "../geometry/projector.h"
#include "triangle.h"

/* `face_q15`: intensity of the face; QTRI_VERTEX_UNLIT: smooth between those of the vertices. */
bool qtri_small_draw(const qtri_raster *raster, const qtri_triangle *triangle, const qtri_vertex *a,
                     const qtri_vertex *b, const qtri_vertex *c, uint32_t face_q15);

#endif
