/* SPDX-License-Identifier: MIT */
#include "qtri/frame.h"

#include "fill.h"

static const qtri_rect nothing = {0, 0, 0, 0};

static bool is_side(int32_t x)
{
    return x >= 1 && x <= QTRI_SURFACE_MAX;
}

enum qtri_error qtri_frame_init(qtri_frame *frame, const qtri_format *format, int32_t width,
                                int32_t height, int32_t rows, void *memory, size_t bytes)
{
    return qtri_frame_init_depth(frame, format, NULL, width, height, rows, memory, bytes);
}

enum qtri_error qtri_frame_init_depth(qtri_frame *frame, const qtri_format *format,
                                      const qtri_depth_format *depth_format, int32_t width,
                                      int32_t height, int32_t rows, void *memory, size_t bytes)
{
    QTRI_ASSERT(frame != NULL);
    frame->format = format;
    frame->depth_format = depth_format;
    frame->width = 0;
    frame->height = 0;
    frame->rows = 1;
    frame->memory = (uint8_t *)memory;
    frame->other_pixels = NULL;
    frame->use_other = false;
    frame->is_first = true;
    frame->band_bytes = 0;
    qtri_frame_share(frame, 0, 1);
    qtri_frame_begin(frame);
    if (!is_side(width) || !is_side(height) || !is_side(rows)) {
        return QTRI_ERROR_SIZE;
    }
    qtri_surface first; /* says what else is wrong */
    const enum qtri_error error = qtri_surface_init_depth(&first, format, depth_format, width,
                                                          height, 0, rows, memory, bytes);
    if (error != QTRI_OK) {
        return error;
    }
    const uint32_t pixel_bytes = format->pixels->bytes;
    const uint32_t depth_bytes = qtri_depth_bytes(depth_format);
    frame->band_bytes = QTRI_FRAME_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes);
    if (bytes >= QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, rows, pixel_bytes, depth_bytes)) {
        uint8_t *end = frame->memory + frame->band_bytes;
        frame->other_pixels = end + (4 - ((uintptr_t)end & 3)) % 4;
    }
    frame->width = width;
    frame->height = height;
    frame->rows = rows;
    qtri_frame_mark_all(frame);
    return QTRI_OK;
}

void qtri_frame_share(qtri_frame *frame, int32_t part, int32_t parts)
{
    frame->first_band = part > 0 ? part : 0;
    frame->every = parts > 1 ? parts : 1;
    frame->next_row = 0;
}

void qtri_frame_begin(qtri_frame *frame)
{
    QTRI_ASSERT(frame != NULL);
    frame->next_row = 0;
    frame->only_changes = false;
    frame->changes = nothing;
    if (frame->is_first) {
        qtri_frame_mark_all(frame);
    }
}

/* Whether the band from `row` on is to be drawn. */
static bool is_wanted(const qtri_frame *frame, int32_t row)
{
    int32_t band = row / frame->rows - frame->first_band;
    if (band < 0 || band % frame->every != 0) {
        return false;
    }
    return !frame->only_changes ||
           (row < frame->changes.y1 && row + frame->rows > frame->changes.y0);
}

bool qtri_frame_next_band(qtri_frame *frame, qtri_surface *band)
{
    QTRI_ASSERT(frame != NULL && band != NULL);
    int32_t row = frame->next_row;
    while (row < frame->height && !is_wanted(frame, row)) {
        row += frame->rows;
    }
    frame->next_row = row;
    if (row >= frame->height) {
        return false;
    }
    frame->next_row += frame->rows;
    frame->is_first = false;
    (void)qtri_surface_init_depth(band, frame->format, frame->depth_format, frame->width,
                                  frame->height, row, frame->rows, frame->memory,
                                  frame->band_bytes);
    if (frame->only_changes) {
        band->scissor = frame->changes;
    }
    if (frame->other_pixels != NULL) {
        if (frame->use_other) {
            band->pixels = frame->other_pixels;
        }
        frame->use_other = !frame->use_other;
    }
    return true;
}

static bool is_empty(const qtri_rect *r)
{
    return r->x0 >= r->x1 || r->y0 >= r->y1;
}

void qtri_frame_mark(qtri_frame *frame, const qtri_rect *rect)
{
    QTRI_ASSERT(frame != NULL && rect != NULL);
    qtri_rect r = {rect->x0 > 0 ? rect->x0 : 0, rect->y0 > 0 ? rect->y0 : 0,
                   rect->x1 < frame->width ? rect->x1 : frame->width,
                   rect->y1 < frame->height ? rect->y1 : frame->height};
    if (is_empty(&r)) {
        return;
    }
    const qtri_rect *old = &frame->changes;
    if (!is_empty(old)) {
        r.x0 = r.x0 < old->x0 ? r.x0 : old->x0;
        r.y0 = r.y0 < old->y0 ? r.y0 : old->y0;
        r.x1 = r.x1 > old->x1 ? r.x1 : old->x1;
        r.y1 = r.y1 > old->y1 ? r.y1 : old->y1;
    }
    frame->changes = r;
}

void qtri_frame_mark_all(qtri_frame *frame)
{
    qtri_rect all = {0, 0, frame->width, frame->height};
    frame->changes = all;
}

qtri_rect qtri_frame_changes(const qtri_frame *frame)
{
    return frame->changes;
}

void qtri_frame_only_changes(qtri_frame *frame)
{
    frame->only_changes = true;
}
