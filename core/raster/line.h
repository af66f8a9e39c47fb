/*
 * Lines of one draw call: what they share is prepared once, and so is an end that several share.
 * Internal. qtri_raster_line makes a job and two ends for its one line.
 */
#ifndef QTRI_RASTER_LINE_H
#define QTRI_RASTER_LINE_H

#include <stdbool.h>

#include "qtri/raster.h"

typedef struct qtri_line_job {
    const qtri_surface *surface;
    qtri_rect bounds;     /* 0, 0, 0, 0 when empty */
    qtri_compare compare; /* QTRI_DEPTH_OFF: depth neither read nor written */
    bool depth_write;
    int32_t fast_24p8; /* shorter lines that lie inside take the fast path */
} qtri_line_job;

typedef struct qtri_line_end {
    int32_t x_24p8, y_24p8; /* held to the guard band */
    int32_t outside;        /* negative: its pixel lies outside of the bounds */
    int32_t depth_16p15;    /* 0..65535.0: differences fit 32 bits */
    int32_t color[3];       /* red green blue in units of the format, or gray and nothing more;
                               n.16, and half a unit that rounds */
    uint32_t pixel;         /* of that colour */
} qtri_line_end;

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material);

/* Position, colour and depth of v, for lines of this job. */
void qtri_line_end_init(qtri_line_end *end, const qtri_line_job *job, const qtri_screen_vertex *v);

void qtri_line_draw(const qtri_line_job *job, const qtri_line_end *a, const qtri_line_end *b);

/* The three edges of a triangle; quick about one that lies in another band. */
void qtri_line_triangle(const qtri_line_job *job, const qtri_screen_vertex v[3]);

#endif
