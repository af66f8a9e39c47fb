/*
 * Everything about a triangle that does not change from row to row. Internal.
 */
#ifndef QTRI_RASTER_SETUP_H
#define QTRI_RASTER_SETUP_H

#include "triangle.h"

/* Returns the function that fills the job's rows. */
qtri_fill_rows qtri_job_init(qtri_job *job, const qtri_raster *raster,
                             const qtri_triangle *triangle, const qtri_attributes v[3]);

/* Whether it takes colours that are shares of a tint for linear on the screen. */
bool qtri_tint_is_linear(const qtri_vertex *a, const qtri_vertex *b, const qtri_vertex *c);

#endif
