/* SPDX-License-Identifier: MIT */
/*
 * Small triangles, see place.h: by fragments of list.c, but those of one colour row by row as large
 * ones where rows are long. Internal.
 *
 * Which of the two depends on the vertices and the material alone, and depths are the same by both.
 * Without rows the matrix's wall in one colour takes 19 to 75 % more on a Cortex-M3, 29 to 61 % on
 * an M0+. Colours that vary and textures gain nothing by them.
 */
#ifndef QTRI_RASTER_SMALL_H
#define QTRI_RASTER_SMALL_H

#include "list.h"

void qtri_small_draw(const qtri_raster *raster, const qtri_list_triangle *t);

/* Colours and texture coordinates of one that is not tinted. */
typedef struct qtri_small_values {
    int32_t color[3][3];
    qtri_coordinates uv[2];
} qtri_small_values;

void qtri_small_set_values(qtri_small_values *values, const qtri_raster *raster,
                           const qtri_attributes attributes[3]);
void qtri_small_draw_values(const qtri_raster *raster, qtri_place *place,
                            const qtri_vertex *const v[3], const qtri_small_values *values);

#endif
