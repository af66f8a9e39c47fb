/* SPDX-License-Identifier: MIT */
/*
 * What serves depths of another format than linear16, &qtri_depth_testing_stages: reached through a
 * surface's description alone. Internal; raster/depth_testing.c says how it works.
 */
#ifndef QTRI_FRAME_DEPTH_FORMAT_H
#define QTRI_FRAME_DEPTH_FORMAT_H

#include <stdbool.h>

#include "qtri/material.h"
#include "qtri/surface.h"

struct qtri_effect_stages;
struct qtri_fragments;
struct qtri_line_job;
struct qtri_raster;

struct qtri_depth_testing {
    const struct qtri_effect_stages *effects;
    /* Triangles: puts the test before the raster's effects, where it compares depths. */
    void (*begin)(struct qtri_raster *raster);
    /* Lines: the same of a job. */
    void (*begin_lines)(struct qtri_line_job *job, qtri_compare compare);
    /* Of the mask's fragments, `count` of them, those that pass by the raster's late_compare;
       late_write: and their depths are stored. */
    uint32_t (*test)(const struct qtri_raster *raster, const struct qtri_fragments *at,
                     uint32_t mask, int32_t count);
    /* One fragment at a place, of strokes: whether it passes. `write`: then its depth is stored. */
    bool (*passes)(const qtri_surface *surface, qtri_compare compare, uint32_t place,
                   uint32_t depth_16p16, bool write);
    /* Fills a rectangle, which is not empty and inside of the surface, with a depth. */
    void (*fill)(const qtri_surface *surface, const qtri_rect *rect, uint32_t depth_16p16);
    /*
     * Turns all depths into linear16, in place: the first in memory is returned, and the others
     * follow in the order of the formerly stored ones. |depth_pitch| >= width.
     */
    uint16_t *(*flatten)(const qtri_surface *surface);
};

/* NULL: the surface's depths are linear16. */
static inline const qtri_depth_testing *qtri_depth_testing_of(const qtri_surface *surface)
{
    return surface->depth_format != NULL ? surface->depth_format->testing : NULL;
}

/* Bytes of a stored depth; NULL: of linear16. */
static inline int32_t qtri_depth_bytes(const qtri_depth_format *format)
{
    return format != NULL ? format->bytes : QTRI_DEPTH_LINEAR16_BYTES;
}

#endif
