/* SPDX-License-Identifier: MIT */
/*
 * Lines of any width and points, by exact coverage.
 */
#ifndef QTRI_HOST_REFERENCE_RASTER_STROKE_H
#define QTRI_HOST_REFERENCE_RASTER_STROKE_H

#include "matrix.h"
#include "target.h"

/* Draws a SCENE_STROKE. Without `linesmooth` by pixel centres. */
void ref_draw_stroke(struct ref_target *target, const struct scene_op *op,
                     const struct ref_matrix *projection, const struct ref_matrix *modelview);

/* Draws a line by itself, with the look of a stroke. */
void ref_draw_edge(struct ref_target *target, const struct ref_vertex *a,
                   const struct ref_vertex *b, const struct scene_stroke *look, uint32_t id);

#endif
