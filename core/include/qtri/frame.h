/* SPDX-License-Identifier: MIT */
/*
 * Frames in bands: the rows of a picture a few at a time, so that 320x240 pixels with depth need
 * 20 KB and not 300.
 *
 *     static uint8_t memory[QTRI_FRAME_BYTES(320, 16, QTRI_RGB565_BYTES)];
 *     qtri_frame_init(&frame, &qtri_rgb565, 320, 240, 16, memory, sizeof memory);
 *     for (;;) {
 *         qtri_frame_begin(&frame);
 *         while (qtri_frame_next_band(&frame, &band)) {
 *             qtri_surface_clear(&band, sky);
 *             qtri_draw_mesh(&band, &view, &pose, &mesh, &material);
 *             qtri_panel_write(&panel, &band);
 *         }
 *     }
 *
 * The pixels are those of the whole frame, whatever the height of the bands. qtri_draw_mesh
 * transforms a mesh once per band; prepared.h does so once per frame.
 *
 * With memory for two buffers, bands alternate between them: a band may be on its way to the
 * display by DMA while the next is drawn. It must have arrived before the band after that begins.
 *
 * Changes. A display keeps its picture: only what differs from the last frame must be sent. Whoever
 * draws something that has moved, appeared, gone or changed its looks marks the rectangles where it
 * was and where it is (qtri_prepared_mark does so for prepared meshes), before the first band.
 * qtri_frame_changes is the smallest rectangle that holds all marks. Pixels are not compared: what
 * is marked counts as changed, and what is not marked must be drawn as in the last frame.
 */
#ifndef QTRI_FRAME_H
#define QTRI_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "error.h"
#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* In the caller's memory; to be read only. */
typedef struct qtri_frame {
    const qtri_format *format;
    const qtri_depth_format *depth_format; /* NULL: linear16 */
    int32_t width, height;                 /* pixels */
    int32_t rows;                          /* of a band; the last one may have fewer */
    uint8_t *memory;
    size_t band_bytes;
    uint8_t *other_pixels; /* of the second buffer; NULL: there is none */
    bool use_other;
    bool only_changes;
    bool is_first; /* no band was taken yet */
    int32_t next_row;
    int32_t first_band, every; /* the bands of this frame's turn */
    qtri_rect changes;         /* empty: all 0 */
} qtri_frame;

/* Memory for one buffer, and for two, whose bands share their depth: constant expressions. */
#define QTRI_FRAME_BYTES(width, rows, pixel_bytes) QTRI_BAND_BYTES(width, rows, pixel_bytes)
#define QTRI_FRAME_BYTES_DOUBLE(width, rows, pixel_bytes)                                          \
    QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, rows, pixel_bytes, QTRI_DEPTH_LINEAR16_BYTES)

/* The same with depth of another format: QTRI_DEPTH_FLOAT16_BYTES and the like. */
#define QTRI_FRAME_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes)                              \
    QTRI_BAND_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes)
#define QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, rows, pixel_bytes, depth_bytes)                       \
    (QTRI_BAND_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes) +                                \
     (size_t)(width) * (size_t)(rows) * (size_t)(pixel_bytes) + 4u)

/*
 * Bands of `rows` rows in `memory`: two buffers when bytes >= QTRI_FRAME_BYTES_DOUBLE, else one.
 * The frame begins, all of it changed.
 *
 * QTRI_ERROR_SIZE: a side or rows outside 1..QTRI_SURFACE_MAX.
 * QTRI_ERROR_FORMAT: format is NULL.
 * QTRI_ERROR_MEMORY: memory is NULL, or bytes < QTRI_FRAME_BYTES(width, rows,
 * format->pixels->bytes).
 * After an error the frame has no bands.
 */
enum qtri_error qtri_frame_init(qtri_frame *frame, const qtri_format *format, int32_t width,
                                int32_t height, int32_t rows, void *memory, size_t bytes);

/*
 * The same with a format of depth, of depth.h; NULL: linear16. Bytes are then
 * QTRI_FRAME_BYTES_DEPTH or QTRI_FRAME_BYTES_DOUBLE_DEPTH.
 * QTRI_ERROR_FORMAT also: as qtri_surface_init_depth.
 */
enum qtri_error qtri_frame_init_depth(qtri_frame *frame, const qtri_format *format,
                                      const qtri_depth_format *depth_format, int32_t width,
                                      int32_t height, int32_t rows, void *memory, size_t bytes);

/*
 * Several cores, each with a frame of its own: this one gets every `parts`-th band, from band
 * `part` on. part < 0 counts as 0, parts < 1 as 1. At first: all, 0 of 1.
 */
void qtri_frame_share(qtri_frame *frame, int32_t part, int32_t parts);

/* Back to the first band. Bands are whole again, and nothing is marked, or all in the first frame.
 */
void qtri_frame_begin(qtri_frame *frame);

/*
 * The next band as a surface: draw calls land in its rows only. It holds what its memory held
 * before: clear it first. False: there was none left, *band is as it was.
 */
bool qtri_frame_next_band(qtri_frame *frame, qtri_surface *band);

/* Marks a rectangle, or the part of it that lies in the frame. Everything: qtri_frame_mark_all. */
void qtri_frame_mark(qtri_frame *frame, const qtri_rect *rect);
void qtri_frame_mark_all(qtri_frame *frame);

/* The smallest rectangle that holds all marks of this frame; 0, 0, 0, 0 when there are none. */
qtri_rect qtri_frame_changes(const qtri_frame *frame);

/*
 * From now on, until the next begin, only bands that hold changes, and their scissor is
 * qtri_frame_changes: what lies outside is neither cleared nor drawn, and must not be sent.
 */
void qtri_frame_only_changes(qtri_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
