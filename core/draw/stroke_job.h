/* SPDX-License-Identifier: MIT */
/*
 * Strokes from object space: parts between corners, clipped. Internal.
 */
#ifndef QTRI_DRAW_STROKE_JOB_H
#define QTRI_DRAW_STROKE_JOB_H

#include "qtri/stroke.h"

#include "../geometry/projector.h"
#include "../raster/stroke.h"
#include "checked.h"

/* Corners of one draw call on their way to the screen. */
typedef struct qtri_stroke_job {
    qtri_projector projector;
    const qtri_corner *corners;
    uint32_t count;
    const qtri_vertex *vertices; /* of the first `kept` corners */
    uint32_t kept;
    int32_t radius;
    uint8_t cap;
    bool closed;
} qtri_stroke_job;

/* projection camera pose, the material's depth bias, and what the stroke says; no vertices are
 * kept. */
void qtri_stroke_job_init(qtri_stroke_job *job, const qtri_view *view, const qtri_transform *pose,
                          const qtri_corner *corners, uint32_t count, const qtri_stroke *stroke,
                          const qtri_material *material);

/* A corner on the screen; outside of a plane it is marked as vertices of meshes are. */
void qtri_stroke_job_vertex(const qtri_stroke_job *job, uint32_t corner, qtri_vertex *out);

/* The corners' parts, one after the other, with the caps of a polyline. */
bool qtri_stroke_job_place(const void *from, uint32_t part, qtri_stroke_place *place);
void qtri_stroke_job_ends(const void *from, uint32_t part, qtri_stroke_end end[2]);

/* The colour of a corner. */
void qtri_stroke_job_color(qtri_stroke_end *end, const qtri_rgb *color);

#endif
