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

/*
 * Of a row's fragments, `count` <= 32 of them, the first stored at `at` and of depth z, 16.16 with
 * the half that rounds, those of the mask that pass: `orders` are bits for less, equal and greater.
 * `writes`: and their depths are stored.
 */
typedef uint32_t (*qtri_depth_row)(uint8_t *at, uint32_t z, uint32_t step, uint32_t mask,
                                   int32_t count, uint32_t orders, bool writes);

/*
 * The same of all of a row by LESS or, `equal`, LESS_EQUAL, which are written, onto pixels of 16
 * bits in one colour.
 */
typedef void (*qtri_depth_flat)(uint16_t *depth, uint16_t *pixel, uint32_t z, uint32_t step,
                                int32_t count, uint16_t color, bool equal);

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
    /* Fills a rectangle, which is not empty and inside of the surface, with a depth. */
    void (*fill)(const qtri_surface *surface, const qtri_rect *rect, uint32_t depth_16p16);
    /*
     * Turns all depths into linear16, in place: the first in memory is returned, and the others
     * follow in the order of the formerly stored ones. |depth_pitch| >= width.
     */
    uint16_t *(*flatten)(const qtri_surface *surface);
    qtri_depth_row row;   /* NULL: depths of a row are encoded one by one */
    qtri_depth_flat flat; /* NULL: rows are tested, then filled */
};

/* The functions of all of them, with the format's loop for rows. */
#define QTRI_DEPTH_TESTING(row_, flat_)                                                            \
    {                                                                                              \
        &qtri_depth_effects, qtri_depth_begin, qtri_depth_begin_lines, qtri_depth_test_chunk,      \
            qtri_depth_fill, qtri_depth_flatten, row_, flat_                                       \
    }
extern const struct qtri_effect_stages qtri_depth_effects;
void qtri_depth_begin(struct qtri_raster *raster);
void qtri_depth_begin_lines(struct qtri_line_job *job, qtri_compare compare);
uint32_t qtri_depth_test_chunk(const struct qtri_raster *raster, const struct qtri_fragments *at,
                               uint32_t mask, int32_t count);
void qtri_depth_fill(const qtri_surface *surface, const qtri_rect *rect, uint32_t depth_16p16);
uint16_t *qtri_depth_flatten(const qtri_surface *surface);

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
