/* SPDX-License-Identifier: MIT */
/*
 * Small triangles, see place.h: where rows are short by fragments of list.c, where they are long
 * row by row as large ones, along curves that take no division. Internal.
 *
 * Which of the two depends on the vertices alone, and depths are the same by both.
 */
#ifndef QTRI_RASTER_SMALL_H
#define QTRI_RASTER_SMALL_H

#include "list.h"

void qtri_small_draw(const qtri_raster *raster, const qtri_list_triangle *t);

/* One that is not tinted. */
void qtri_small_attributes(const qtri_raster *raster, qtri_place *place,
                           const qtri_vertex *const v[3], const qtri_attributes attributes[3]);

#endif
