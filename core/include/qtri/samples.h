/* SPDX-License-Identifier: MIT */
/*
 * 4 samples a pixel (MSAA): surfaces whose pixels have four colours and four depths.
 *
 * Samples lie on a rotated grid, (-1/8, -3/8), (3/8, -1/8), (-3/8, 1/8) and (1/8, 3/8) of a pixel
 * from its centre. A triangle of any kind, lit, textured, clipped or of a mesh, covers a sample by
 * the top-left rule and is compared with the sample's own depth. It is shaded once a pixel: at the
 * centre, or where it does not cover that at the first sample it covers, so that colours and
 * texture coordinates stay in the range of the triangle. With a blend each sample is blended with
 * its own colour. Pixels do not depend on band or scissor.
 *
 *     static uint32_t memory[QTRI_FRAME_BYTES(320, 16, QTRI_RGB565_X4_BYTES) / 4]; // 80 KB
 *     qtri_frame_init(&frame, &qtri_rgb565_x4, 320, 240, 16, memory, sizeof memory);
 *     while (qtri_frame_next_band(&frame, &band)) {
 *         qtri_samples_clear(&band, sky);
 *         qtri_draw_prepared(&band, &prepared);      // or any other draw call
 *         qtri_samples_resolve(&band, &band);        // RGB565, in the band's memory
 *         ... lines, text, flat shapes ...
 *         qtri_panel_write(&panel, &band);
 *     }
 *
 * Lines, strokes and flat shapes have no samples: they are drawn after the resolve, or colour all
 * samples of a pixel, by the depth of the first. The surfaces may not be dithered or sent before.
 * Of mipmapped textures their first level is drawn.
 *
 * Triangles are drawn by pipelines (pipeline.h): those of a view's list whose options have
 * .samples = 4, and where it has but &qtri_pipeline_any, those that the format names: on RGB565
 * with "less" what is lit, textured, or both has its own, everything else a generic one.
 *
 * Memory: 16 bytes a pixel of RGB565 with its depths, 26 of XRGB8888; about 3 KB of stack.
 * It serves triangles that cut through each other, and large ones. Meshes of small ones take three
 * to four times the instructions: for these the edge pass (edges.h) is better for a twentieth of
 * that, and 2x2 samples (filters.h) as good for a third. A blend is made once for each colour that
 * a pixel's samples have.
 */
#ifndef QTRI_SAMPLES_H
#define QTRI_SAMPLES_H

#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const qtri_format qtri_rgb565_x4, qtri_rgb565_swapped_x4;
extern const qtri_format qtri_rgb888_x4, qtri_xrgb8888_x4, qtri_gray8_x4;

/* Bytes of a pixel beside the depth that every surface has. */
enum {
    QTRI_GRAY8_X4_BYTES = 10,
    QTRI_RGB565_X4_BYTES = 14,
    QTRI_RGB888_X4_BYTES = 18,
    QTRI_XRGB8888_X4_BYTES = 24
};

/*
 * qtri_surface_clear of all samples, then qtri_surface_clear_depth. On other surfaces they are
 * these; which, in turn, do not reach the depths of all samples.
 */
void qtri_samples_clear(const qtri_surface *surface, qtri_rgb color);
void qtri_samples_clear_depth(const qtri_surface *surface, q16 depth);

/*
 * Makes one pixel of four samples, their mean in the steps of the format, halves up: inside the
 * scissor, in the memory of `samples`. *out, which may be the same, describes them: the format
 * without samples, the same rows and scissor, no depth.
 * QTRI_ERROR_FORMAT: the surface has none of these formats. *out is as it was then.
 */
enum qtri_error qtri_samples_resolve(const qtri_surface *samples, qtri_surface *out);

#ifdef __cplusplus
}
#endif

#endif
