/* SPDX-License-Identifier: MIT */
#include "qtri/halo.h"
#include "qtri/error.h"

#include "depth_format.h"

enum qtri_error qtri_halo_init(qtri_halo *halo, const qtri_format *format, int32_t width,
                               int32_t height, int32_t rows, int32_t halo_rows, void *memory,
                               size_t bytes)
{
    QTRI_ASSERT(halo != NULL);
    halo->rows = 0;
    qtri_frame *frame = &halo->frame;
    const bool fits = halo_rows >= 0 && halo_rows <= QTRI_HALO_MAX && rows >= 1 &&
                      rows <= QTRI_SURFACE_MAX; /* with its halo: qtri_frame_init asks */
    if (!fits) {
        (void)qtri_frame_init(frame, format, 0, 0, 0, memory, bytes); /* a frame without bands */
        return QTRI_ERROR_SIZE;
    }
    /* Buffers of bands with their halo; then the frame goes on with bands without it. */
    const enum qtri_error error =
        qtri_frame_init(frame, format, width, height, rows + 2 * halo_rows, memory, bytes);
    if (error == QTRI_OK) {
        frame->rows = rows;
        halo->rows = halo_rows;
    }
    return error;
}

void qtri_halo_begin(qtri_halo *halo)
{
    QTRI_ASSERT(halo != NULL);
    qtri_frame_begin(&halo->frame);
}

/* The rectangle and `by` more on every side, inside of the frame. */
static qtri_rect widened(const qtri_rect *rect, int32_t by, int32_t width, int32_t height)
{
    qtri_rect r = {rect->x0 > by ? rect->x0 - by : 0, rect->y0 > by ? rect->y0 - by : 0,
                   rect->x1 < width - by ? rect->x1 + by : width,
                   rect->y1 < height - by ? rect->y1 + by : height};
    return r;
}

bool qtri_halo_next_band(qtri_halo *halo, qtri_surface *band, qtri_surface *shown)
{
    QTRI_ASSERT(halo != NULL);
    QTRI_ASSERT(band != NULL && shown != NULL);
    qtri_frame *frame = &halo->frame;
    qtri_surface inner;
    if (!qtri_frame_next_band(frame, &inner)) {
        return false;
    }
    const int32_t above = inner.first_row < halo->rows ? inner.first_row : halo->rows;
    const int32_t first = inner.first_row - above;
    const int32_t shown_rows = frame->rows < frame->height - inner.first_row
                                   ? frame->rows
                                   : frame->height - inner.first_row;
    (void)qtri_surface_init(band, frame->format, frame->width, frame->height, first,
                            above + frame->rows + halo->rows, frame->memory, frame->band_bytes);
    band->depth_format = frame->depth_format;
    if (frame->other_pixels != NULL) {
        band->pixels = inner.pixels; /* of the buffer whose turn it is */
    }
    if (frame->only_changes) {
        band->scissor = widened(&frame->changes, halo->rows, frame->width, frame->height);
    }
    *shown = *band;
    shown->pixels = band->pixels + above * band->pitch;
    shown->depth =
        (uint16_t *)(void *)((uint8_t *)band->depth +
                             qtri_depth_bytes(band->depth_format) * above * band->depth_pitch);
    shown->first_row = inner.first_row;
    shown->rows = shown_rows;
    shown->scissor = inner.scissor;
    return true;
}

void qtri_halo_only_changes(qtri_halo *halo)
{
    QTRI_ASSERT(halo != NULL);
    qtri_frame *frame = &halo->frame;
    const qtri_rect *changes = &frame->changes;
    if (changes->x0 < changes->x1 && changes->y0 < changes->y1) {
        frame->changes = widened(changes, halo->rows, frame->width, frame->height);
    }
    qtri_frame_only_changes(frame);
}
