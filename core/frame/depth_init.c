/* SPDX-License-Identifier: MIT */
/*
 * Surfaces, frames and halos with depth of any format: those with linear16, whose depth begins at
 * the same byte, and has more or other bytes.
 */
#include "checked.h"
#include "depth_format.h"

#include "qtri/halo.h"

/* Pixels of more bytes are records of samples, which hold depths of linear16. */
static bool is_format(const qtri_format *format, const qtri_depth_format *depth)
{
    return depth == NULL || depth->ops == NULL ||
           (depth->bytes >= 2 && depth->bytes <= 4 && format->pixels->bytes <= 4);
}

enum qtri_error qtri_surface_init_depth(qtri_surface *surface, const qtri_format *format,
                                        const qtri_depth_format *depth_format, int32_t width,
                                        int32_t height, int32_t first_row, int32_t rows,
                                        void *memory, size_t bytes)
{
    QTRI_CHECK(qtri_check_depth_format(depth_format));
    static const qtri_surface nothing;
    enum qtri_error error =
        qtri_surface_init(surface, format, width, height, first_row, rows, memory, bytes);
    if (error == QTRI_OK && !is_format(format, depth_format)) {
        error = QTRI_ERROR_FORMAT;
    } else if (error == QTRI_OK && bytes < QTRI_BAND_BYTES_DEPTH(width, rows, format->pixels->bytes,
                                                                 qtri_depth_bytes(depth_format))) {
        error = QTRI_ERROR_MEMORY;
    }
    if (error != QTRI_OK) {
        *surface = nothing;
        return error;
    }
    surface->depth_format = depth_format;
    return QTRI_OK;
}

enum qtri_error qtri_frame_init_depth(qtri_frame *frame, const qtri_format *format,
                                      const qtri_depth_format *depth_format, int32_t width,
                                      int32_t height, int32_t rows, void *memory, size_t bytes)
{
    QTRI_ASSERT(frame != NULL);
    qtri_surface first; /* says what is wrong */
    const enum qtri_error error = qtri_surface_init_depth(&first, format, depth_format, width,
                                                          height, 0, rows, memory, bytes);
    if (error != QTRI_OK) {
        (void)qtri_frame_init(frame, format, 0, 0, 0, memory, bytes); /* a frame without bands */
        return error;
    }
    const int32_t pixel_bytes = format->pixels->bytes;
    const int32_t depth_bytes = qtri_depth_bytes(depth_format);
    (void)qtri_frame_init(frame, format, width, height, rows, memory, bytes);
    frame->depth_format = depth_format;
    frame->band_bytes = QTRI_FRAME_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes);
    frame->other_pixels = NULL;
    if (bytes >= QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, rows, pixel_bytes, depth_bytes)) {
        uint8_t *end = frame->memory + frame->band_bytes;
        frame->other_pixels = end + (4 - ((uintptr_t)end & 3)) % 4;
    }
    return QTRI_OK;
}

enum qtri_error qtri_halo_init_depth(qtri_halo *halo, const qtri_format *format,
                                     const qtri_depth_format *depth_format, int32_t width,
                                     int32_t height, int32_t rows, int32_t halo_rows, void *memory,
                                     size_t bytes)
{
    QTRI_CHECK(qtri_check_depth_format(depth_format));
    enum qtri_error error =
        qtri_halo_init(halo, format, width, height, rows, halo_rows, memory, bytes);
    if (error == QTRI_OK) {
        error = qtri_frame_init_depth(&halo->frame, format, depth_format, width, height,
                                      rows + 2 * halo_rows, memory, bytes);
    }
    if (error == QTRI_OK) { /* as qtri_halo_init: bands without their halo */
        halo->frame.rows = rows;
    }
    return error;
}
