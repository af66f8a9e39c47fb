/* SPDX-License-Identifier: MIT */
/*
 * What triangles whose attributes vary add to those of one colour: reached through smooth shading
 * and through textures, so that an application with neither does not link it. Internal.
 */
#ifndef QTRI_RASTER_SHADING_H
#define QTRI_RASTER_SHADING_H

#include "list_values.h"
#include "setup.h"

struct qtri_varying {
    qtri_fill_rows fill; /* any job, by stages */
    /* The rest of qtri_job_init: returns what fills the rows. */
    qtri_fill_rows (*set_job)(qtri_job *job, const qtri_triangle *triangle,
                              const qtri_attributes v[3], const qtri_gradient *gradient,
                              const qtri_unsnapped *unsnapped);
    /* Of small triangles: see list_values.h. */
    void (*set_light)(qtri_list_values *v, uint32_t shift);
    void (*set_channels)(qtri_list_values *v, uint32_t shift);
    void (*words)(const qtri_list_values *v, uint32_t *out, const uint32_t *place, int32_t count,
                  uint32_t shift, uint32_t red, uint32_t green);
};

extern const qtri_varying qtri_varying_stages;

typedef struct qtri_by_pixel qtri_by_pixel; /* see ../draw/per_pixel.h */

struct qtri_shading {
    uint8_t provoking;             /* the vertex whose colour all have, 0 or 2 */
    const qtri_varying *varying;   /* NULL: flat */
    const qtri_by_pixel *by_pixel; /* how draw calls light triangles; NULL: by vertex, by face */
};

#endif
