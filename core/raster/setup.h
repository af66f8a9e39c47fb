/*
 * Everything about a triangle that does not change from row to row. Internal.
 */
#ifndef QTRI_RASTER_SETUP_H
#define QTRI_RASTER_SETUP_H

#include "triangle.h"

/* Returns the function that fills the job's rows. */
qtri_fill_rows qtri_job_init(qtri_job *job, const qtri_raster *raster,
                             const qtri_triangle *triangle, const qtri_attributes v[3]);

#endif
