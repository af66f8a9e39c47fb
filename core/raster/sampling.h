/* SPDX-License-Identifier: MIT */
/*
 * What draws on surfaces with several samples a pixel: reached through a format alone, so that it
 * is linked where one is named. Internal; samples.h has what stands behind it.
 */
#ifndef QTRI_RASTER_SAMPLING_H
#define QTRI_RASTER_SAMPLING_H

#include "list.h"
#include "triangle.h"

/* format->fused->samples. */
struct qtri_sampling {
    const qtri_format *format; /* of resolved pixels */
    /* A triangle of any size and area that is not culled; its p, area and tinted are set. */
    qtri_route draw;
    /* A small one; LARGE, too, where a fragment's depths are written once it is not turned away. */
    qtri_placed (*place)(qtri_place *p, uint8_t spans[QTRI_PLACE_SPANS], const qtri_raster *raster,
                         const qtri_vertex *a, const qtri_vertex *b, const qtri_vertex *c);
    void (*draw_small)(const qtri_raster *raster, const qtri_list_triangle *t);
    qtri_draw_masked put;
    /* Where a view's list has nothing but the generic pipeline that fits; the last one fits. */
    const qtri_pipeline *const *pipelines;
};

static inline const struct qtri_sampling *qtri_sampling_of(const qtri_format *format)
{
    return format != NULL && format->fused != NULL ? format->fused->samples : NULL;
}

/* Whether triangles may be drawn as small ones: a route but that of samples takes them all. */
static inline bool qtri_takes_small(const qtri_raster *raster)
{
    return raster->route == NULL ||
           (raster->samples != NULL && raster->route == raster->samples->draw);
}

#endif
