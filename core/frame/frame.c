/* SPDX-License-Identifier: MIT */
/* Frames: their bands one after another, rows kept between bands, and changed rectangles. */
#include "qtri/frame.h"

#include "depth_format.h"
#include "pixel.h"

static const qtri_rect nothing = {0, 0, 0, 0};

static bool is_side(int32_t x)
{
    return x >= 1 && x <= QTRI_SURFACE_MAX;
}

/* ---- Layout ---- */

/* Makes it a frame without bands; returns the error. */
static enum qtri_error refuse(qtri_frame *frame, enum qtri_error error)
{
    frame->width = 0;
    frame->height = 0;
    frame->changes = nothing;
    return error;
}

/* Bytes of pixels and depths of so many rows. */
static size_t bytes_of(const qtri_frame *frame, int32_t rows)
{
    return QTRI_FRAME_BYTES_DEPTH(frame->width, rows, frame->format->pixels->bytes,
                                  qtri_depth_bytes(frame->depth_format));
}

/* Divides the memory into buffers. */
static enum qtri_error lay_out(qtri_frame *frame)
{
    const int32_t rows = frame->rows + 2 * frame->overlap;
    frame->band_bytes = bytes_of(frame, rows);
    frame->other_pixels = NULL;
    if (frame->memory == NULL || frame->bytes < frame->band_bytes ||
        (frame->kept != NULL && frame->kept_bytes < bytes_of(frame, 2 * frame->overlap))) {
        return refuse(frame, QTRI_ERROR_MEMORY);
    }
    const size_t pixel_bytes =
        (size_t)frame->width * (size_t)rows * frame->format->pixels->bytes + 4; /* to align */
    if (frame->bytes - frame->band_bytes >= pixel_bytes) {
        uint8_t *end = frame->memory + frame->band_bytes;
        frame->other_pixels = end + (4 - ((uintptr_t)end & 3)) % 4;
    }
    return QTRI_OK;
}

enum qtri_error qtri_frame_init(qtri_frame *frame, const qtri_format *format, int32_t width,
                                int32_t height, int32_t rows, void *memory, size_t bytes)
{
    QTRI_ASSERT(frame != NULL);
    QTRI_CHECK(qtri_check_format(format));
    static const qtri_frame fresh = {.rows = 1, .is_first = true, .every = 1};
    *frame = fresh;
    if (!is_side(width) || !is_side(height) || !is_side(rows)) {
        return QTRI_ERROR_SIZE;
    }
    if (format == NULL) {
        return QTRI_ERROR_FORMAT;
    }
    frame->format = format;
    frame->memory = (uint8_t *)memory;
    frame->bytes = bytes;
    frame->width = width;
    frame->height = height;
    frame->rows = rows;
    qtri_frame_mark_all(frame);
    return lay_out(frame);
}

enum qtri_error qtri_frame_set_depth(qtri_frame *frame, const qtri_depth_format *format)
{
    QTRI_ASSERT(frame != NULL);
    QTRI_CHECK(qtri_check_depth_format(format));
    if (frame->height == 0) {
        return QTRI_ERROR_SIZE;
    }
    if (!qtri_depth_goes_with(format, frame->format)) {
        return refuse(frame, QTRI_ERROR_FORMAT);
    }
    frame->depth_format = format;
    return lay_out(frame);
}

enum qtri_error qtri_frame_set_overlap(qtri_frame *frame, int32_t rows, void *kept,
                                       size_t kept_bytes)
{
    QTRI_ASSERT(frame != NULL);
    const bool fits = rows >= 0 && rows <= QTRI_OVERLAP_MAX &&
                      frame->rows + 2 * rows <= QTRI_SURFACE_MAX &&
                      (kept == NULL || frame->rows >= 2 * rows);
    if (frame->height == 0 || !fits) {
        return refuse(frame, QTRI_ERROR_SIZE);
    }
    frame->overlap = rows;
    frame->kept = rows > 0 ? (uint8_t *)kept : NULL;
    frame->kept_bytes = kept_bytes;
    return lay_out(frame);
}

void qtri_frame_share(qtri_frame *frame, int32_t part, int32_t parts)
{
    QTRI_ASSERT(frame != NULL);
    frame->first_band = part > 0 ? part : 0;
    frame->every = parts > 1 ? parts : 1;
    frame->next_row = 0;
}

/* ---- Bands ---- */

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
    if (frame->kept != NULL) {
        return true;
    }
    /* Without a sign: small cores have a function for either kind of division. */
    const int32_t band = (int32_t)((uint32_t)row / (uint32_t)frame->rows) - frame->first_band;
    if (band < 0 || (uint32_t)band % (uint32_t)frame->every != 0) {
        return false;
    }
    return !frame->only_changes ||
           (row < frame->changes.y1 && row + frame->rows > frame->changes.y0);
}

/* A rectangle of the frame and `by` more on every side, inside of the frame. */
static qtri_rect widened(const qtri_frame *frame, const qtri_rect *rect, int32_t by)
{
    qtri_rect r = {rect->x0 > by ? rect->x0 - by : 0, rect->y0 > by ? rect->y0 - by : 0,
                   rect->x1 < frame->width - by ? rect->x1 + by : frame->width,
                   rect->y1 < frame->height - by ? rect->y1 + by : frame->height};
    return r;
}

/* The depth buffer `rows` rows further on; NULL: there is none. */
static uint16_t *depth_at(const qtri_surface *band, ptrdiff_t rows)
{
    const ptrdiff_t bytes = band->depth_pitch * qtri_depth_bytes(band->depth_format);
    return band->depth == NULL ? NULL : (uint16_t *)(void *)((uint8_t *)band->depth + rows * bytes);
}

/* *out is rows first .. end - 1 of the frame, which the band's memory holds. */
static void set_rows(qtri_surface *out, const qtri_surface *band, int32_t first, int32_t end)
{
    const int32_t above = first - band->first_row;
    uint16_t *depth = depth_at(band, above);
    *out = *band;
    out->pixels += above * band->pitch;
    out->depth = depth;
    out->first_row = first;
    out->rows = end - first;
}

bool qtri_frame_next_band(qtri_frame *frame, qtri_surface *band)
{
    QTRI_ASSERT(frame != NULL && band != NULL);
    int32_t row = frame->next_row;
    while (row < frame->height && !is_wanted(frame, row)) {
        row += frame->rows;
    }
    if (row >= frame->height) {
        qtri_frame_begin(frame);
        return false;
    }
    frame->next_row = row + frame->rows;
    frame->is_first = false;
    const bool keeps = frame->kept != NULL;
    const int32_t more = row < frame->overlap ? row : frame->overlap;
    const int32_t above = !keeps ? more : row > 0 ? 2 * frame->overlap : 0;
    const int32_t below = keeps ? 0 : frame->overlap;
    (void)qtri_surface_init(band, frame->format, frame->width, frame->height, row - above,
                            above + frame->rows + below, frame->memory, frame->band_bytes);
    band->depth_format = frame->depth_format; /* behind the pixels as any: of more bytes */
    if (frame->only_changes && !keeps) {
        band->scissor = widened(frame, &frame->changes, frame->overlap);
    }
    if (frame->other_pixels != NULL) {
        if (frame->use_other) {
            band->pixels = frame->other_pixels;
        }
        frame->use_other = !frame->use_other;
    }
    if (keeps) {
        set_rows(band, band, row, band->first_row + band->rows);
    }
    return true;
}

void qtri_frame_shown(const qtri_frame *frame, const qtri_surface *band, qtri_surface *shown)
{
    QTRI_ASSERT(frame != NULL && band != NULL && shown != NULL);
    if (frame->next_row < frame->rows) { /* no band was taken */
        *shown = *band;
        return;
    }
    const int32_t behind = frame->kept != NULL ? frame->overlap : 0;
    const int32_t first = frame->next_row - frame->rows;
    const bool is_last = frame->next_row >= frame->height;
    set_rows(shown, band, first > 0 ? first - behind : 0,
             is_last ? frame->height : frame->next_row - behind);
    if (frame->only_changes && frame->kept == NULL) {
        shown->scissor = frame->changes;
    }
}

/* ---- Rows that are kept ---- */

/*
 * Depth of the first row is not kept: no pixel that is shown depends on it, since only edges on
 * that row itself would ask for it. The rest begins at a word where the pixels do.
 */
void qtri_frame_join(const qtri_frame *frame, qtri_surface *band)
{
    QTRI_ASSERT(frame != NULL && band != NULL);
    const int32_t rows = 2 * frame->overlap;
    const int32_t first = frame->next_row - frame->rows;
    if (frame->kept == NULL || band->first_row != first) {
        return;
    }
    const size_t pixel_bytes = (size_t)rows * (size_t)band->pitch;
    const size_t depth_bytes = (size_t)(rows - 1) * (size_t)band->depth_pitch *
                               (size_t)qtri_depth_bytes(band->depth_format);
    uint8_t *kept_depth = frame->kept + (pixel_bytes + 3) / 4 * 4;
    if (first > 0) {
        set_rows(band, band, first - rows, first + band->rows);
        qtri_copy(band->pixels, frame->kept, pixel_bytes);
        if (band->depth != NULL) {
            qtri_copy((uint8_t *)depth_at(band, 1), kept_depth, depth_bytes);
        }
    }
    if (frame->next_row < frame->height) {
        const int32_t before = band->rows - rows;
        qtri_copy(frame->kept, band->pixels + before * band->pitch, pixel_bytes);
        if (band->depth != NULL) {
            qtri_copy(kept_depth, (const uint8_t *)depth_at(band, before + 1), depth_bytes);
        }
    }
}

/* ---- Changes ---- */

void qtri_frame_mark(qtri_frame *frame, const qtri_rect *rect)
{
    QTRI_ASSERT(frame != NULL && rect != NULL);
    qtri_rect r = widened(frame, rect, 0);
    if (qtri_rect_is_empty(&r)) {
        return;
    }
    const qtri_rect *old = &frame->changes;
    if (!qtri_rect_is_empty(old)) {
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
    if (!qtri_rect_is_empty(&frame->changes)) {
        frame->changes = widened(frame, &frame->changes, frame->overlap);
    }
    frame->only_changes = true;
}
