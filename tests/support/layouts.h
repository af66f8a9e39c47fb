/* SPDX-License-Identifier: MIT */
/*
 * Surfaces and frames of the tests with all that they may have, in one call.
 */
#ifndef QTRI_TESTS_SUPPORT_LAYOUTS_H
#define QTRI_TESTS_SUPPORT_LAYOUTS_H

#include <qtri.h>

/* qtri_surface_init, with depth of a format. */
static inline enum qtri_error surface_with_depth(qtri_surface *surface, const qtri_format *format,
                                                 const qtri_depth_format *depth, int32_t width,
                                                 int32_t height, int32_t first_row, int32_t rows,
                                                 void *memory, size_t bytes)
{
    const enum qtri_error error =
        qtri_surface_init(surface, format, width, height, first_row, rows, memory, bytes);
    return error == QTRI_OK ? qtri_surface_set_depth(surface, depth, bytes) : error;
}

/* qtri_frame_init, with rows that overlap and are drawn again. */
static inline enum qtri_error frame_with_overlap(qtri_frame *frame, const qtri_format *format,
                                                 int32_t width, int32_t height, int32_t rows,
                                                 int32_t overlap, void *memory, size_t bytes)
{
    const enum qtri_error error =
        qtri_frame_init(frame, format, width, height, rows, memory, bytes);
    return error == QTRI_OK ? qtri_frame_set_overlap(frame, overlap, NULL, 0) : error;
}

/* qtri_frame_next_band, and what is shown of it where no rows are kept. */
static inline bool next_shown(qtri_frame *frame, qtri_surface *band, qtri_surface *shown)
{
    if (!qtri_frame_next_band(frame, band)) {
        return false;
    }
    qtri_frame_shown(frame, band, shown);
    return true;
}

/* A prepared mesh whose memory is divided by hand: more or less than it wants of each. */
static inline void prepared_init_with(qtri_prepared *prepared, qtri_vertex *vertices,
                                      uint32_t vertex_count, uint16_t *lists, uint32_t list_count)
{
    qtri_prepared_init(prepared, NULL, 0);
    prepared->vertices = vertices;
    prepared->vertex_count = vertex_count;
    prepared->lists = lists;
    prepared->list_count = list_count;
}

#endif
