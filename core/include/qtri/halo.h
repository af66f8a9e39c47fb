/* SPDX-License-Identifier: MIT */
/*
 * Bands that overlap: each with some rows more above and below than it shows. What looks at a
 * pixel's neighbours, as anti-aliasing does, then gives the pixels of the whole frame.
 *
 *     static uint8_t memory[QTRI_HALO_BYTES(320, 16, 1, QTRI_RGB565_BYTES)];
 *     qtri_halo_init(&frame, &qtri_rgb565, 320, 240, 16, 1, memory, sizeof memory);
 *     for (;;) {
 *         qtri_halo_begin(&frame);
 *         while (qtri_halo_next_band(&frame, &band, &shown)) {
 *             ... clear and draw `band`, then smooth it ...
 *             qtri_panel_write(&panel, &shown);
 *         }
 *     }
 */
#ifndef QTRI_HALO_H
#define QTRI_HALO_H

#include "frame.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_HALO_MAX 8 /* rows */

typedef struct qtri_halo {
    qtri_frame frame; /* of bands without their halo: for qtri_prepare_mesh and marks */
    int32_t rows;     /* of halo, above and below */
} qtri_halo;

/* Memory for one buffer, and for two, whose bands share their depth: constant expressions. */
#define QTRI_HALO_BYTES(width, rows, halo, pixel_bytes)                                            \
    QTRI_FRAME_BYTES(width, (rows) + 2 * (halo), pixel_bytes)
#define QTRI_HALO_BYTES_DOUBLE(width, rows, halo, pixel_bytes)                                     \
    QTRI_FRAME_BYTES_DOUBLE(width, (rows) + 2 * (halo), pixel_bytes)

/* The same with depth of another format: QTRI_DEPTH_FLOAT16_BYTES and the like. */
#define QTRI_HALO_BYTES_DEPTH(width, rows, halo, pixel_bytes, depth_bytes)                         \
    QTRI_FRAME_BYTES_DEPTH(width, (rows) + 2 * (halo), pixel_bytes, depth_bytes)
#define QTRI_HALO_BYTES_DOUBLE_DEPTH(width, rows, halo, pixel_bytes, depth_bytes)                  \
    QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, (rows) + 2 * (halo), pixel_bytes, depth_bytes)

/*
 * As qtri_frame_init, with `halo` rows more above and below each band.
 * QTRI_ERROR_SIZE also: halo outside 0..QTRI_HALO_MAX, or rows + 2 halo > QTRI_SURFACE_MAX.
 */
enum qtri_error qtri_halo_init(qtri_halo *halo, const qtri_format *format, int32_t width,
                               int32_t height, int32_t rows, int32_t halo_rows, void *memory,
                               size_t bytes);

/* The same with a format of depth, as qtri_frame_init_depth. */
enum qtri_error qtri_halo_init_depth(qtri_halo *halo, const qtri_format *format,
                                     const qtri_depth_format *depth_format, int32_t width,
                                     int32_t height, int32_t rows, int32_t halo_rows, void *memory,
                                     size_t bytes);

/* qtri_frame_begin of the frame. */
void qtri_halo_begin(qtri_halo *halo);

/*
 * The next band: *band to draw on, with its halo where the frame goes on there, and *shown, the
 * rows without it, whose depth is not to be used. False: there was none left.
 */
bool qtri_halo_next_band(qtri_halo *halo, qtri_surface *band, qtri_surface *shown);

/*
 * As qtri_frame_only_changes: bands that hold changes or what a filter makes of them. The frame's
 * changes are widened by the halo on every side; the scissor of `shown` is that, and what is drawn
 * reaches a halo further.
 */
void qtri_halo_only_changes(qtri_halo *halo);

#ifdef __cplusplus
}
#endif

#endif
