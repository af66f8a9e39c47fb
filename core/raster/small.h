/* SPDX-License-Identifier: MIT */
/*
 * Small triangles, see place.h: by fragments of list.c, but where rows are long and neither texture
 * nor light that varies is in the way, row by row as large ones. Internal.
 *
 * Which of the two depends on the vertices and the material alone, and depths are the same by both.
 * By the matrix's wall rows save an eighth of instructions; textured ones gain nothing by them.
 */
#ifndef QTRI_RASTER_SMALL_H
#define QTRI_RASTER_SMALL_H

#include "list.h"

void qtri_small_draw(const qtri_raster *raster, const qtri_list_triangle *t);

/*
 * What fills rows of a small triangle whose vertices have colours, without texture; NULL where they
 * would have to be curved: then they are the list's.
 */
qtri_fill_rows qtri_small_set_rows(qtri_job *job, qtri_list_values *v);

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
