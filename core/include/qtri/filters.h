/* SPDX-License-Identifier: MIT */
/*
 * Anti-aliasing of finished pixels, whatever they were drawn from.
 *
 * Filters take every format; &qtri_rgb565, and others that are stored like it, need less memory and
 * a fraction of the time. Colours are mixed in the steps of their format and rounded to nearest
 * once.
 *
 * 2x2 samples a pixel: draw at twice the size, then halve.
 *
 *     qtri_frame_init(&frame, &qtri_rgb565, 2 * 240, 2 * 240, 2 * 8, memory, sizeof memory);
 *     qtri_view_init(&view, 2 * 240, 2 * 240);
 *     while (qtri_frame_next_band(&frame, &large)) {
 *         ... clear and draw on `large` ...
 *         qtri_halve(&large, &band);                 // 8 rows of 240 pixels, in its memory
 *         qtri_panel_write(&panel, &band);
 *     }
 *
 * FXAA (Lottes 2009): edges are guessed from the colours of neighbours. For pictures whose geometry
 * is not at hand, before text is drawn. In bands that overlap by QTRI_FXAA_OVERLAP rows.
 *
 *     static uint32_t rows[QTRI_FXAA_565_WORDS(240)];
 *     qtri_fxaa(&band, rows, sizeof rows / sizeof rows[0]);
 *
 * Temporal: what rests is drawn 4, 8 or 16 times, each time from a place a part of a pixel beside
 * (jitter.h), and averaged. Of the whole frame, or of each band, drawn as many times.
 *
 *     qtri_sum_clear(sums, sizeof sums / sizeof sums[0]);
 *     for (uint32_t n = 0; n < 16; n++) {
 *         qtri_view_jitter(&jittered, &view, n, 4);
 *         ... clear and draw with `jittered` ...
 *         qtri_sum_add(sums, QTRI_SUM_565_WORDS(240, 16), &band);
 *     }
 *     qtri_sum_store(&band, sums, QTRI_SUM_565_WORDS(240, 16), 4);
 */
#ifndef QTRI_FILTERS_H
#define QTRI_FILTERS_H

#include <stdint.h>

#include "error.h"
#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- 2x2 samples ---- */

/*
 * Makes one pixel of each 2 x 2 of a band, in the band's own memory; *out describes them: a frame
 * of half the size, its rows, half the scissor, rounded outwards, and no depth. Needs no other
 * memory: a band of 2 x 8 rows of 2 x 320 pixels takes 4 x 8 x 320 pixels of colour and depth,
 * 40 KB of RGB565. Pixels outside of out->scissor are not made; those whose four samples lie inside
 * of the band's scissor do not depend on it.
 * QTRI_ERROR_SIZE: width, height, first row or rows are odd. QTRI_ERROR_FORMAT: there is no format.
 * *out is as it was then.
 */
enum qtri_error qtri_halve(const qtri_surface *band, qtri_surface *out);

/* ---- FXAA ---- */

/* How far it looks for the ends of an edge: along a row, and across rows. */
#define QTRI_FXAA_REACH   12
#define QTRI_FXAA_OVERLAP 2

/* Words of memory for surfaces of this width: old colours of five rows; for those stored like
   rgb565 old colours of three rows, and three of lumas. */
#define QTRI_FXAA_WORDS(width)     (5u * (uint32_t)(width))
#define QTRI_FXAA_565_WORDS(width) (6u * (((uint32_t)(width) + 1u) / 2u))

/*
 * Smooths what lies inside the scissor, in place. Pixels do not depend on band and scissor where
 * these have QTRI_FXAA_OVERLAP rows and QTRI_FXAA_REACH columns more than what is shown.
 * QTRI_ERROR_MEMORY: too few words. The picture is as it was then.
 */
enum qtri_error qtri_fxaa(const qtri_surface *surface, uint32_t *memory, uint32_t words);

/* ---- Sums of frames ---- */

#define QTRI_SUM_FRAMES_LOG2_MAX 5 /* 32 frames */

/* Words of memory for a surface of so many rows: two a pixel; one where it is stored like rgb565.
 */
#define QTRI_SUM_WORDS(width, rows)     (2u * (uint32_t)(width) * (uint32_t)(rows))
#define QTRI_SUM_565_WORDS(width, rows) ((uint32_t)(width) * (uint32_t)(rows))

/* Sums of no frame. */
void qtri_sum_clear(uint32_t *sums, uint32_t words);

/*
 * Adds the surface's pixels inside its scissor. After 32 frames sums are full: of more, what is
 * stored is undefined colours. QTRI_ERROR_MEMORY: too few words. Nothing is added then.
 */
enum qtri_error qtri_sum_add(uint32_t *sums, uint32_t words, const qtri_surface *surface);

/*
 * Stores the mean of 2^frames_log2 frames (clamped to 0..5), rounded to nearest, halves up, inside
 * the surface's scissor. The surface's format must be the one of those that were added. Errors as
 * above. Sums stay as they are.
 */
enum qtri_error qtri_sum_store(const qtri_surface *surface, const uint32_t *sums, uint32_t words,
                               int32_t frames_log2);

#ifdef __cplusplus
}
#endif

#endif
