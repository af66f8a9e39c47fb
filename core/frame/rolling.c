/* SPDX-License-Identifier: MIT */
#include "qtri/rolling.h"
#include "qtri/error.h"

#include <string.h>

/* Words that are copied at once, by instructions that load and store several registers. */
typedef struct words {
    uint32_t word[12];
}
#ifdef __GNUC__
__attribute__((__may_alias__))
#endif
words;

enum qtri_error qtri_rolling_init(qtri_rolling *rolling, const qtri_format *format, int32_t width,
                                  int32_t height, int32_t rows, int32_t halo, void *memory,
                                  size_t bytes, void *kept, size_t kept_bytes)
{
    QTRI_ASSERT(rolling != NULL);
    qtri_halo frame;
    enum qtri_error error =
        qtri_halo_init(&frame, format, width, height, rows, halo, memory, bytes);
    if (error == QTRI_OK && rows < 2 * halo) {
        error = QTRI_ERROR_SIZE;
    }
    if (error == QTRI_OK && halo > 0 &&
        (kept == NULL ||
         kept_bytes < QTRI_ROLLING_KEPT_BYTES(width, halo, format->pixels->bytes))) {
        error = QTRI_ERROR_MEMORY;
    }
    if (error != QTRI_OK) {
        (void)qtri_frame_init(&frame.frame, format, 0, 0, 0, memory, bytes); /* without bands */
    }
    rolling->frame = frame.frame;
    rolling->halo = error == QTRI_OK ? halo : 0;
    rolling->kept = kept;
    rolling->rows = 0;
    return error;
}

void qtri_rolling_begin(qtri_rolling *rolling)
{
    QTRI_ASSERT(rolling != NULL);
    qtri_frame_begin(&rolling->frame);
    rolling->rows = 0;
}

/* `bytes` bytes, which do not overlap; in words where both sides are at words. */
static void copy(uint8_t *to, const uint8_t *from, size_t bytes)
{
    if ((((uintptr_t)to | (uintptr_t)from) & 3) == 0) {
        for (; bytes >= 2 * sizeof(words); bytes -= 2 * sizeof(words)) {
            words *out = (words *)(void *)to;
            const words *in = (const words *)(const void *)from;
            out[0] = in[0];
            out[1] = in[1];
            to += 2 * sizeof(words);
            from += 2 * sizeof(words);
        }
    }
    memcpy(to, from, bytes);
}

/* Bytes of the pixels and of the depth of rows of a band, whose rows have no gaps. */
static size_t pixel_bytes(const qtri_surface *band, int32_t rows)
{
    return (size_t)rows * (size_t)band->pitch;
}

static size_t depth_bytes(const qtri_surface *band, int32_t rows)
{
    return (size_t)rows * (size_t)band->depth_pitch * sizeof *band->depth;
}

/*
 * Where the depth of the kept rows begins, but the first: at a word if they do. No pixel that is
 * shown depends on the depth of the outermost row, which notes on that row alone ask.
 */
static uint8_t *kept_depth(const qtri_rolling *rolling, const qtri_surface *band)
{
    const size_t pixels = pixel_bytes(band, 2 * rolling->halo);
    return rolling->kept + (pixels + 3) / 4 * 4;
}

/* The rows of a band from `first` of the frame on. */
static void take_rows(qtri_surface *out, const qtri_surface *band, int32_t first, int32_t end)
{
    const int32_t above = first - band->first_row;
    *out = *band;
    out->pixels += above * band->pitch;
    out->depth += above * band->depth_pitch;
    out->first_row = first;
    out->rows = end - first;
}

bool qtri_rolling_next_band(qtri_rolling *rolling, qtri_surface *drawn, qtri_surface *band,
                            qtri_surface *shown)
{
    QTRI_ASSERT(rolling != NULL);
    QTRI_ASSERT(drawn != NULL && band != NULL && shown != NULL);
    qtri_frame *frame = &rolling->frame;
    qtri_surface inner;
    if (!qtri_frame_next_band(frame, &inner)) {
        return false;
    }
    const int32_t above = rolling->rows;
    const int32_t first = inner.first_row;
    (void)qtri_surface_init(band, frame->format, frame->width, frame->height, first - above,
                            above + frame->rows, frame->memory, frame->band_bytes);
    if (frame->other_pixels != NULL) {
        band->pixels = inner.pixels; /* of the buffer whose turn it is */
    }
    if (above > 0) {
        copy(band->pixels, rolling->kept, pixel_bytes(band, above));
        copy((uint8_t *)(void *)(band->depth + band->depth_pitch), kept_depth(rolling, band),
             depth_bytes(band, above - 1));
    }
    const int32_t end = band->first_row + band->rows;
    take_rows(drawn, band, first, end);
    take_rows(shown, band, above > 0 ? first - rolling->halo : first,
              end == frame->height ? end : end - rolling->halo);
    return true;
}

void qtri_rolling_keep(qtri_rolling *rolling, const qtri_surface *band)
{
    QTRI_ASSERT(rolling != NULL);
    QTRI_ASSERT(band != NULL);
    const int32_t rows = 2 * rolling->halo;
    rolling->rows = rows;
    if (rows == 0 || band->first_row + band->rows == band->height) {
        return; /* no band follows */
    }
    const int32_t before = band->rows - rows;
    copy(rolling->kept, band->pixels + before * band->pitch, pixel_bytes(band, rows));
    if (band->depth != NULL) {
        copy(kept_depth(rolling, band),
             (const uint8_t *)(const void *)(band->depth + (before + 1) * band->depth_pitch),
             depth_bytes(band, rows - 1));
    }
}
