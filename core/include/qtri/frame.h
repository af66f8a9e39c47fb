/* SPDX-License-Identifier: MIT */
/*
 * Frames in bands: the rows of a picture a few at a time, so that 320x240 pixels with depth need 20
 * KB and not 300. qtri_port/screen.h does the loop below for a panel.
 *
 *     static uint8_t memory[QTRI_FRAME_BYTES(320, 16, QTRI_RGB565_BYTES)];
 *     qtri_frame_init(&frame, &qtri_rgb565, 320, 240, 16, memory, sizeof memory);
 *     for (;;) {
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
 * Overlap. What looks at a pixel's neighbours, as anti-aliasing does, gives the pixels of the whole
 * frame if each band has some rows more above and below than it shows. They are drawn again with
 * each of the two bands that share them, or kept from one for the next, as they are before a filter
 * changes them, in `kept`, which takes a tenth of the instructions with the edge pass:
 *
 *     static uint8_t memory[QTRI_FRAME_BYTES(320, 16 + 2 * 1, QTRI_RGB565_BYTES)];
 *     static uint8_t kept[QTRI_FRAME_KEPT_BYTES(320, 1, QTRI_RGB565_BYTES)];
 *     qtri_frame_init(&frame, &qtri_rgb565, 320, 240, 16, memory, sizeof memory);
 *     qtri_frame_set_overlap(&frame, 1, kept, sizeof kept); // NULL, 0: drawn again
 *     while (qtri_frame_next_band(&frame, &band)) {
 *         ... clear and draw `band` ...
 *         qtri_frame_join(&frame, &band);
 *         ... smooth it ...
 *         qtri_frame_shown(&frame, &band, &shown);
 *         qtri_panel_write(&panel, &shown);
 *     }
 *
 * Where rows are kept, what is shown lies `overlap` rows behind what is drawn: of 16 rows and an
 * overlap of 1 the first band shows 15, and the last one more. No band can be left out then, or
 * drawn by another core.
 *
 * Changes. A display keeps its picture: only what differs from the last frame must be sent. Whoever
 * draws something that has moved, appeared, gone or changed its looks marks the rectangles where it
 * was and where it is (qtri_prepared_mark for prepared meshes), before the first band. Pixels are
 * not compared: what is marked counts as changed, and what is not marked must be drawn as in the
 * last frame.
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

#define QTRI_OVERLAP_MAX 8 /* rows */

/* In the caller's memory; to be read only. */
typedef struct qtri_frame {
    const qtri_format *format;
    const qtri_depth_format *depth_format; /* NULL: linear16 */
    int32_t width, height;                 /* pixels */
    int32_t rows;                          /* of a band; the last one may have fewer */
    int32_t overlap;                       /* rows above and below */
    uint8_t *memory;
    size_t bytes, band_bytes; /* of the memory, and of one buffer */
    uint8_t *other_pixels;    /* of the second buffer; NULL: there is none */
    uint8_t *kept;            /* pixels of 2 overlap rows, then their depth; NULL: drawn again */
    size_t kept_bytes;
    bool use_other;
    bool only_changes;
    bool is_first; /* no band was taken yet */
    int32_t next_row;
    int32_t first_band, every; /* the bands of this frame's turn */
    qtri_rect changes;         /* empty: all 0 */
} qtri_frame;

/*
 * Memory for one buffer, and for two, whose bands share their depth: constant expressions. Of bands
 * with overlap `rows` are those that are shown and twice the overlap.
 */
#define QTRI_FRAME_BYTES(width, rows, pixel_bytes) QTRI_BAND_BYTES(width, rows, pixel_bytes)
#define QTRI_FRAME_BYTES_DOUBLE(width, rows, pixel_bytes)                                          \
    QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, rows, pixel_bytes, QTRI_DEPTH_LINEAR16_BYTES)

/* With depth of another format: QTRI_DEPTH_FLOAT16_BYTES and the like. */
#define QTRI_FRAME_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes)                              \
    QTRI_BAND_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes)
#define QTRI_FRAME_BYTES_DOUBLE_DEPTH(width, rows, pixel_bytes, depth_bytes)                       \
    (QTRI_BAND_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes) +                                \
     (size_t)(width) * (size_t)(rows) * (size_t)(pixel_bytes) + 4u)

/* For rows that are kept: 2,568 bytes for 320 columns of RGB565 and an overlap of 1. */
#define QTRI_FRAME_KEPT_BYTES(width, overlap, pixel_bytes)                                         \
    QTRI_BAND_BYTES(width, 2 * (overlap), pixel_bytes)

/*
 * Bands of `rows` rows in `memory`: two buffers when bytes >= QTRI_FRAME_BYTES_DOUBLE, else one.
 * The frame begins, all of it changed.
 *
 * QTRI_ERROR_SIZE: a side or rows outside 1..QTRI_SURFACE_MAX.
 * QTRI_ERROR_FORMAT: format is NULL.
 * QTRI_ERROR_MEMORY: memory is NULL, or of fewer bytes than QTRI_FRAME_BYTES.
 * After an error the frame has no bands.
 */
enum qtri_error qtri_frame_init(qtri_frame *frame, const qtri_format *format, int32_t width,
                                int32_t height, int32_t rows, void *memory, size_t bytes);

/*
 * What a frame may have besides; before its first band, in any order. After an error it has no
 * bands. QTRI_ERROR_MEMORY: the frame's memory, or what is kept, has too few bytes for it;
 * QTRI_ERROR_SIZE: the frame has no bands.
 *
 * Depth of another format, of format.h; NULL: linear16. Bytes are those of QTRI_FRAME_BYTES_DEPTH
 * or QTRI_FRAME_BYTES_DOUBLE_DEPTH. QTRI_ERROR_FORMAT: as qtri_surface_set_depth.
 *
 * Overlap: `rows` rows more above and below, kept in `kept` or, where that is NULL, drawn again.
 * QTRI_ERROR_SIZE: rows outside 0..QTRI_OVERLAP_MAX, or bands with more than QTRI_SURFACE_MAX rows;
 * bands with fewer than 2 `rows` rows of their own where rows are kept.
 */
enum qtri_error qtri_frame_set_depth(qtri_frame *frame, const qtri_depth_format *format);
enum qtri_error qtri_frame_set_overlap(qtri_frame *frame, int32_t rows, void *kept,
                                       size_t kept_bytes);

/*
 * Several cores, each with a frame of its own: this one gets every `parts`-th band, from band
 * `part` on. part < 0 counts as 0, parts < 1 as 1. At first: all, 0 of 1.
 */
void qtri_frame_share(qtri_frame *frame, int32_t part, int32_t parts);

/*
 * Back to the first band, of a frame that is left before its last one. Bands are whole again, and
 * nothing is marked, or all in the first frame.
 */
void qtri_frame_begin(qtri_frame *frame);

/*
 * The next band as a surface: draw calls land in its rows only. It holds what its memory held
 * before: clear it first. With overlap it has these rows too, where the frame goes on there, unless
 * they are kept. False: there was none left, *band is as it was, and the next frame begins.
 */
bool qtri_frame_next_band(qtri_frame *frame, qtri_surface *band);

/*
 * Once a band is drawn, before a filter: puts the rows that are kept above it, and keeps what the
 * next one needs. Without such rows nothing happens. What is kept of a row may be without depth:
 * the first row of a band has none of its own then. A band without depth has depth = NULL by now.
 */
void qtri_frame_join(const qtri_frame *frame, qtri_surface *band);

/*
 * The rows of the last band that are shown; their depth is not to be used. `band` may be what
 * became of it: joined, or resolved (antialias.h). The two may be the same.
 */
void qtri_frame_shown(const qtri_frame *frame, const qtri_surface *band, qtri_surface *shown);

/* Marks a rectangle, or the part of it that lies in the frame. Everything: qtri_frame_mark_all. */
void qtri_frame_mark(qtri_frame *frame, const qtri_rect *rect);
void qtri_frame_mark_all(qtri_frame *frame);

/* The smallest rectangle that holds all marks of this frame; 0, 0, 0, 0 when there are none. */
qtri_rect qtri_frame_changes(const qtri_frame *frame);

/*
 * From now on, to the end of the frame, only bands that hold changes, and their scissor is
 * qtri_frame_changes: what lies outside is neither cleared nor drawn, and must not be sent. With
 * overlap a filter makes more of changes: they are widened by it on every side, and what is drawn
 * reaches as far beyond them once more. Where rows are kept, nothing is left out.
 */
void qtri_frame_only_changes(qtri_frame *frame);

#ifdef __cplusplus
}
#endif

#endif
