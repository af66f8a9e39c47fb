/* SPDX-License-Identifier: MIT */
#include "qtri/frame.h"

#include "checked.h"

static const qtri_rect nothing = {0, 0, 0, 0};

static bool is_side(int32_t x)
{
    return x >= 1 && x <= QTRI_SURFACE_MAX;
}

enum qtri_error qtri_frame_init(qtri_frame *frame, const qtri_format *format, int32_t width,
                                int32_t height, int32_t rows, void *memory, size_t bytes)
{
    QTRI_ASSERT(frame != NULL);
    QTRI_CHECK(qtri_check_format(format));
    frame->format = format;
    frame->depth_format = NULL;
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
    if (format == NULL) {
        return QTRI_ERROR_FORMAT;
    }
    frame->band_bytes = QTRI_FRAME_BYTES(width, rows, format->pixels->bytes);
    if (memory == NULL || bytes < frame->band_bytes) {
        return QTRI_ERROR_MEMORY;
    }
    if (bytes >= QTRI_FRAME_BYTES_DOUBLE(width, rows, format->pixels->bytes)) {
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
    QTRI_ASSERT(frame != NULL);
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
    (void)qtri_surface_init(band, frame->format, frame->width, frame->height, row, frame->rows,
                            frame->memory, frame->band_bytes);
    band->depth_format = frame->depth_format; /* behind the pixels as any: of more bytes */
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
    QTRI_ASSERT(frame != NULL);
    qtri_rect all = {0, 0, frame->width, frame->height};
    frame->changes = all;
}

qtri_rect qtri_frame_changes(const qtri_frame *frame)
{
    QTRI_ASSERT(frame != NULL);
    return frame->changes;
}

void qtri_frame_only_changes(qtri_frame *frame)
{
    QTRI_ASSERT(frame != NULL);
    frame->only_changes = true;
}
