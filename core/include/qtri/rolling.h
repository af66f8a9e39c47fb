/* SPDX-License-Identifier: MIT */
/*
 * Bands that overlap, as those of halo.h, each row of which is drawn only once: a band keeps the
 * rows that it shares with the next, as they are before a filter changes them. For the edge pass
 * this takes a tenth of what drawing the halo again takes.
 *
 *     static uint8_t memory[QTRI_ROLLING_BYTES(320, 16, 1, QTRI_RGB565_BYTES)];
 *     static uint8_t kept[QTRI_ROLLING_KEPT_BYTES(320, 1, QTRI_RGB565_BYTES)];
 *     qtri_rolling_init(&frame, &qtri_rgb565, 320, 240, 16, 1, memory, sizeof memory, kept,
 *                       sizeof kept);
 *     for (;;) {
 *         qtri_rolling_begin(&frame);
 *         while (qtri_rolling_next_band(&frame, &drawn, &band, &shown)) {
 *             ... clear and draw `drawn` ...
 *             qtri_rolling_keep(&frame, &band);
 *             ... smooth `band` ...
 *             qtri_panel_write(&panel, &shown);
 *         }
 *     }
 *
 * What is shown lies `halo` rows behind what is drawn: of 16 rows and a halo of 1 the first band
 * shows 15, and the last one more. Bands follow each other: unlike those of halo.h they cannot be
 * left out, or shared between cores.
 */
#ifndef QTRI_ROLLING_H
#define QTRI_ROLLING_H

#include "halo.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct qtri_rolling {
    qtri_frame frame; /* of bands as they are drawn: for qtri_prepare_mesh */
    int32_t halo;
    uint8_t *kept; /* the caller's: pixels of 2 halo rows, then their depth */
    int32_t rows;  /* that are kept now */
} qtri_rolling;

/* Memory for one buffer, and for two, whose bands share their depth: constant expressions. */
#define QTRI_ROLLING_BYTES(width, rows, halo, pixel_bytes)                                         \
    QTRI_HALO_BYTES(width, rows, halo, pixel_bytes)
#define QTRI_ROLLING_BYTES_DOUBLE(width, rows, halo, pixel_bytes)                                  \
    QTRI_HALO_BYTES_DOUBLE(width, rows, halo, pixel_bytes)

/* And for the rows that are kept: 2,568 bytes for 320 columns of RGB565 and a halo of 1. */
#define QTRI_ROLLING_KEPT_BYTES(width, halo, pixel_bytes)                                          \
    QTRI_BAND_BYTES(width, 2 * (halo), pixel_bytes)

/*
 * As qtri_halo_init. A halo of 0 keeps nothing.
 * QTRI_ERROR_SIZE also: rows < 2 halo. QTRI_ERROR_MEMORY also: kept_bytes are too few, or kept is
 * NULL and halo is not 0. After an error the frame has no bands.
 */
enum qtri_error qtri_rolling_init(qtri_rolling *rolling, const qtri_format *format, int32_t width,
                                  int32_t height, int32_t rows, int32_t halo, void *memory,
                                  size_t bytes, void *kept, size_t kept_bytes);

/* qtri_frame_begin of the frame. */
void qtri_rolling_begin(qtri_rolling *rolling);

/*
 * The next band: *drawn, the rows to clear and to draw on; *band, these and the rows above that
 * were kept, for a filter; *shown, the rows of *band that are as those of the whole frame then,
 * whose depth is not to be used. The first row that was kept has no depth of its own. False: there
 * was none left.
 */
bool qtri_rolling_next_band(qtri_rolling *rolling, qtri_surface *drawn, qtri_surface *band,
                            qtri_surface *shown);

/*
 * Keeps what the next band needs of this one, once it is drawn and before it is filtered. A band
 * without depth has depth = NULL by now.
 */
void qtri_rolling_keep(qtri_rolling *rolling, const qtri_surface *band);

#ifdef __cplusplus
}
#endif

#endif
