/* SPDX-License-Identifier: MIT */
/*
 * Anti-aliasing: five ways, each with the same pixels for every band and scissor. `make antialias`
 * prints how good each is, what it costs and what memory it takes.
 *
 *   qtri_edges_blend       the edge pass: outlines of meshes. What to use first: the best edges for
 *                          10 to 20 % more instructions and a bit a pixel.
 *   qtri_halve             2x2 samples: all edges and what is in them, for three times the work.
 *   qtri_fxaa              pictures whose geometry is not at hand.
 *   qtri_sum_add           sums of frames: what rests, as smooth as there is time for.
 *   qtri_samples_resolve   4 samples a pixel, shaded once: triangles that cut through each other.
 *
 * Wireframes have &qtri_smooth_wireframe (stroke.h). The edge pass and FXAA need bands that overlap
 * (frame.h).
 */
#ifndef QTRI_ANTIALIAS_H
#define QTRI_ANTIALIAS_H

#include <stdbool.h>
#include <stdint.h>

#include "error.h"
#include "mesh.h"
#include "prepared.h"
#include "surface.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Edge pass
 * ---------------------------------------------------------------------------------------------- */

/*
 * The frame is drawn as always; then each silhouette of a mesh is walked once more, and every pixel
 * that it passes through takes from the pixel across it the share that lies on that side (Sander,
 * Hoppe, Snyder, Gortler 2001; Persson 2011). Nothing is shaded again. At outlines it is better
 * than four samples a pixel.
 *
 *     static uint32_t outline_memory[QTRI_OUTLINE_WORDS(996)];
 *     static uint32_t edge_memory[QTRI_EDGES_WORDS(320, 240, QTRI_RGB565_BYTES)];
 *     qtri_outline_init(&outline, &gear, outline_memory, QTRI_OUTLINE_WORDS(996));
 *
 *     qtri_surface_clear(&surface, sky);
 *     qtri_draw_mesh_outlined(&surface, &view, &pose, &material, &outline);
 *     ... everything else that is in the picture, with the depth buffer as it is left ...
 *     qtri_edges_begin(&edges, &surface, edge_memory, sizeof edge_memory / sizeof edge_memory[0]);
 *     qtri_edges_note(&edges, &outline);           // each mesh that has an outline
 *     qtri_edges_blend(&edges);                    // the depth buffer is spent
 *
 * In bands that overlap by a row (frame.h) the pixels are those of the whole frame:
 *
 *     qtri_prepared_set_outline(&prepared, &outline);            // once, after qtri_prepared_init
 *
 *     qtri_prepare_mesh(&prepared, &frame, &view, &pose, &gear, &material);
 *     qtri_prepared_find_edges(&prepared, &outline);
 *     ... in each band, between qtri_frame_join and qtri_frame_shown: begin, note and blend ...
 *
 * Drawing the overlap again takes three tenths of all that smoothing takes in bands; keeping it
 * takes 2,568 bytes more in 320 columns.
 *
 * It does not smooth edges within textures (a filter does), of triangles that cut through each
 * other or that the near plane cuts, nor what is thinner than a pixel.
 */

/* ---- Outlines: which edges of a mesh are silhouettes ---- */

/*
 * Edges of a face that is front whose neighbour is not. They are found by mesh->neighbours,
 * constant data, or, where a mesh has none, by sums over its vertices, which take a word of RAM a
 * vertex and miss some edges where outlines meet in a vertex. Of a mesh that is not culled and has
 * holes the borders of back faces are found by neighbours only.
 */
typedef struct qtri_outline {
    const qtri_mesh *mesh;
    bool creases; /* also blend between faces of different light: for flat shading of meshes with
                     neighbours, false at first */
    /* Internal. */
    uint32_t *front; /* a bit a triangle, and one that stays 0 for no neighbour */
    uint32_t *sums;  /* NULL: by neighbours */
    uint32_t *list;  /* lists of edges by band: heads, then entries */
    uint32_t list_words;
    qtri_vertex *vertices; /* NULL: nothing is seen */
    const qtri_view *view;
    const qtri_transform *pose;
    const qtri_material *material;
    int32_t width, height;
    int32_t rows;         /* of the bands that have lists; 0: there are none */
    int32_t above, below; /* rows that lists reach beyond them */
} qtri_outline;

/*
 * Words of memory for an outline: a bit a triangle, and for a mesh without neighbours a word a
 * vertex. For bands, lists of the edges that each touches, enough for an edge of one in four
 * triangles; with fewer words edges are found again in every band: slower, the same pixels.
 */
#define QTRI_OUTLINE_WORDS(triangles) (((uint32_t)(triangles) + 32u) / 32u)
#define QTRI_OUTLINE_SUMS(vertices)   ((uint32_t)(vertices))
#define QTRI_OUTLINE_LISTS(triangles, height, rows)                                                \
    ((uint32_t)(triangles) / 4u +                                                                  \
     2u * (((uint32_t)(height) + (uint32_t)(rows)-1u) / (uint32_t)(rows)))

/*
 * Divides memory[0..words - 1] for the outline of a mesh, whose data must stay as it is while the
 * outline is in use. Words beyond QTRI_OUTLINE_WORDS and SUMS are for lists.
 * QTRI_ERROR_SIZE: the mesh has more than 65535 triangles, or neighbours above their number.
 * QTRI_ERROR_MEMORY: too few words. After an error the outline has no edges.
 */
enum qtri_error qtri_outline_init(qtri_outline *outline, const qtri_mesh *mesh, uint32_t *memory,
                                  uint32_t words);

/*
 * qtri_draw_mesh of the outline's mesh, then finds which triangles face the eye. All that is
 * pointed to, view->vertices too, must stay as it is until the edges are noted. A wireframe has no
 * outline. QTRI_ERROR_MEMORY: view->vertices has no room for all vertices of the mesh, which is
 * drawn, and has no outline; or qtri_outline_init failed, and nothing is drawn.
 */
enum qtri_error qtri_draw_mesh_outlined(const qtri_surface *surface, const qtri_view *view,
                                        const qtri_transform *pose, const qtri_material *material,
                                        qtri_outline *outline);

/* Finds the outline of a mesh that qtri_draw_mesh has drawn with these arguments. Transforms its
   vertices once more: meshes may share view->vertices, one after another until edges are noted. */
enum qtri_error qtri_find_outline(const qtri_surface *surface, const qtri_view *view,
                                  const qtri_transform *pose, const qtri_material *material,
                                  qtri_outline *outline);

/*
 * After qtri_prepared_init: the prepared mesh finds what faces the eye for the outline, which must
 * be of the mesh that will be prepared. NULL: it has no outline.
 */
void qtri_prepared_set_outline(qtri_prepared *prepared, const qtri_outline *outline);

/*
 * After qtri_prepare_mesh, once a frame: finds the edges and lists them by band.
 * QTRI_ERROR_MEMORY: the prepared mesh has fewer vertices than its mesh, or another outline was
 * set. The mesh has no outline then.
 */
enum qtri_error qtri_prepared_find_edges(const qtri_prepared *prepared, qtri_outline *outline);

/* ---- The pass over a frame or a band ---- */

typedef struct qtri_edges {
    qtri_surface surface;
    /* Internal. */
    qtri_rect bounds; /* pixels change only in here; empty: none */
    uint32_t *marks;  /* a bit a pixel that has a note */
    uint16_t *notes;  /* the first in memory: the depth of the pixels, or a plane in its place */
    int32_t pitch;    /* of notes and marks */
    int32_t origin;   /* of (0, first row), counted in notes */
    uint32_t *line;   /* of old colours, where a note has no room for one */
} qtri_edges;

/*
 * Words of memory for a surface of so many columns and rows, with overlap: a bit a pixel, and for
 * formats of more than two bytes a row of colours; without depth, where notes are kept, two bytes a
 * pixel more. Depths of another format become linear16 as the pass begins. |depth_pitch| counts as
 * the width.
 */
#define QTRI_EDGES_WORDS(width, rows, pixel_bytes)                                                 \
    (((uint32_t)(width) * (uint32_t)(rows) + 31u) / 32u +                                          \
     ((pixel_bytes) > 2 ? (uint32_t)(width) : 0u))
#define QTRI_EDGES_WORDS_WITHOUT_DEPTH(width, rows, pixel_bytes)                                   \
    (QTRI_EDGES_WORDS(width, rows, pixel_bytes) + ((uint32_t)(width) * (uint32_t)(rows) + 1u) / 2u)

/*
 * Begins a pass over what is drawn on the surface, inside its scissor. Nothing may be drawn on it
 * until the blend. QTRI_ERROR_MEMORY: too few words. QTRI_ERROR_SIZE: |depth_pitch| is less than
 * the width or more than 65536. The pass has no pixels then.
 *
 * Pixels of the outermost rows and columns inside the scissor may lack a share from outside of it,
 * but for the frame's border: a scissor, like a band, needs one pixel more.
 */
enum qtri_error qtri_edges_begin(qtri_edges *edges, const qtri_surface *surface, uint32_t *memory,
                                 uint32_t words);

/*
 * Notes the outline's edges where the stored depth is not nearer than the edge's. Of several notes
 * of a pixel the greatest share wins; of several meshes it may depend on their order, but not on
 * band or scissor. An outline for frames of another size has no edges here.
 */
void qtri_edges_note(qtri_edges *edges, const qtri_outline *outline);

/*
 * Gives the noted pixels their shares, of colours as they were before, rounded to the nearest step
 * of the format. The depth is spent: it holds notes and old colours.
 */
void qtri_edges_blend(qtri_edges *edges);

/* 2x2 samples, FXAA and sums of frames
 * ---------------------------------------------------------------------------------------------- */

/*
 * Filters of finished pixels take every format; &qtri_rgb565, and others that are stored like it,
 * need less memory and a fraction of the time. Colours are mixed in the steps of their format and
 * rounded to nearest once.
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
 * FXAA (Lottes 2009): edges are guessed from the colours of neighbours. Before text is drawn, in
 * bands that overlap by QTRI_FXAA_OVERLAP rows.
 *
 *     static uint32_t rows[QTRI_FXAA_565_WORDS(240)];
 *     qtri_fxaa(&band, rows, sizeof rows / sizeof rows[0]);
 *
 * Temporal: what rests is drawn 4, 8 or 16 times, each time from a place a part of a pixel beside,
 * and averaged. Of the whole frame, or of each band, drawn as many times.
 *
 *     qtri_sum_clear(sums, sizeof sums / sizeof sums[0]);
 *     for (uint32_t n = 0; n < 16; n++) {
 *         qtri_view_jitter(&jittered, &view, n, 4);
 *         ... clear and draw with `jittered` ...
 *         qtri_sum_add(sums, QTRI_SUM_565_WORDS(240, 16), &band);
 *     }
 *     qtri_sum_store(&band, sums, QTRI_SUM_565_WORDS(240, 16), 4);
 */

/* ---- 2x2 samples ---- */

/*
 * Makes one pixel of each 2 x 2 of a band, in the band's own memory; *out describes them: a frame
 * of half the size, its rows, half the scissor, rounded outwards, and no depth. Pixels outside of
 * out->scissor are not made; those whose four samples lie inside of the band's scissor do not
 * depend on it. QTRI_ERROR_SIZE: width, height, first row or rows are odd. QTRI_ERROR_FORMAT: there
 * is no format. *out is as it was then.
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

/* Views between pixels
 * ---------------------------------------------------------------------------------------------- */

#define QTRI_JITTER_LOG2_MAX 5 /* 32 frames, as many as a sum holds */

/*
 * *out sees what *view sees, moved within half a pixel of its viewport by place n (modulo their
 * number) of 2^frames_log2 (held to 0..5): one in each column and each row of as many parts of a
 * pixel (Hammersley's set, every second one exchanged with the next: of four, a rotated grid).
 * Their mean is the middle of the pixel. To 1/65536 of half the viewport. The two may be the same;
 * to go on to the next place, start from the view that was not moved.
 */
void qtri_view_jitter(qtri_view *out, const qtri_view *view, uint32_t n, int32_t frames_log2);

/* 4 samples a pixel (MSAA)
 * ---------------------------------------------------------------------------------------------- */

/*
 * Pixels of the formats below have four colours and four depths. Samples lie at (-1/8, -3/8), (3/8,
 * -1/8), (-3/8, 1/8) and (1/8, 3/8) of a pixel from its centre. A triangle covers a sample by the
 * top-left rule and is compared with its depth. It is shaded once a pixel: at the centre, or where
 * it does not cover that at the first sample it covers, so that colours and texture coordinates
 * stay in the range of the triangle. A blend is made once for each colour that a pixel has. Pixels
 * do not depend on band or scissor.
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
 * Of mipmapped textures the first level is drawn.
 *
 * Triangles are drawn by the pipelines (pipeline.h) of a view's list with .samples = 4, and where
 * it has but &qtri_pipeline_any, by those that the format names: on RGB565 with "less" what is lit,
 * textured, or both has its own, everything else a generic one.
 *
 * Memory: 16 bytes a pixel of RGB565 with its depths, 26 of XRGB8888; about 3 KB of stack. Meshes
 * of small triangles take three to four times the instructions.
 */

/* Formats of four samples a pixel. */
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
