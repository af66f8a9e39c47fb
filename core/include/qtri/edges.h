/* SPDX-License-Identifier: MIT */
/*
 * Edge anti-aliasing: what to use first. The frame is drawn as always; then each silhouette of a
 * mesh is walked once more, and every pixel that it passes through takes from the pixel across it
 * the share that lies on that side (Sander, Hoppe, Snyder, Gortler 2001; Persson 2011). The
 * pixel across has colour, light, texture and fog already: nothing is shaded again. It is better
 * than four samples a pixel at outlines, for 10 to 15 % of the frame's instructions.
 *
 * A whole frame:
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
 * In bands that overlap by a row (frame.h), so that the pixels are the whole frame's:
 *
 *     qtri_prepared_init(&prepared, memory, sizeof memory);
 *     qtri_prepared_set_outline(&prepared, &outline);            // once, after init
 *
 *     qtri_prepare_mesh(&prepared, &frame, &view, &pose, &gear, &material);
 *     qtri_prepared_find_edges(&prepared, &outline);
 *     while (qtri_frame_next_band(&frame, &band)) {
 *         qtri_surface_clear(&band, sky);
 *         qtri_draw_prepared(&band, &prepared);
 *         qtri_frame_join(&frame, &band);
 *         qtri_edges_begin(&edges, &band, edge_memory, ...);
 *         qtri_edges_note(&edges, &outline);
 *         qtri_edges_blend(&edges);
 *         qtri_frame_shown(&frame, &band, &shown);
 *         qtri_panel_write(&panel, &shown);
 *     }
 *
 * Drawing the overlap again takes three tenths of all that smoothing takes in bands; keeping it
 * takes 2,568 bytes more in 320 columns.
 *
 * What it is not for: edges within textures (a filter), triangles that cut through each other and
 * those that the near plane cuts (neither has an edge there), and what is thinner than a pixel.
 */
#ifndef QTRI_EDGES_H
#define QTRI_EDGES_H

#include <stdbool.h>
#include <stdint.h>

#include "mesh.h"
#include "prepared.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

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
 * Words of memory for an outline: constant expressions. A bit a triangle; for a mesh without
 * neighbours a word a vertex more. For bands, lists of the edges that each touches: enough for one
 * in four triangles to have an edge in the outline. With fewer words than the edges need they are
 * found again in every band: slower, the same pixels.
 */
#define QTRI_OUTLINE_WORDS(triangles) (((uint32_t)(triangles) + 32u) / 32u)
#define QTRI_OUTLINE_SUMS(vertices)   ((uint32_t)(vertices))
#define QTRI_OUTLINE_LISTS(triangles, height, rows)                                                \
    ((uint32_t)(triangles) / 4u +                                                                  \
     2u * (((uint32_t)(height) + (uint32_t)(rows)-1u) / (uint32_t)(rows)))

/*
 * For a mesh, whose data must stay as it is while the outline is in use. Words beyond those for
 * facing and sums are for lists.
 * QTRI_ERROR_SIZE: the mesh has more than 65535 triangles, or neighbours above their number.
 * QTRI_ERROR_MEMORY: too few words. After an error the outline has no edges.
 */
enum qtri_error qtri_outline_init(qtri_outline *outline, const qtri_mesh *mesh, uint32_t *memory,
                                  uint32_t words);

/*
 * qtri_draw_mesh of the outline's mesh, then finds which triangles face the eye. view->vertices
 * must have room for all vertices of the mesh, and stay as they are, as must all that is pointed
 * to, until the edges are noted. QTRI_ERROR_MEMORY: they have not. The mesh is drawn, and has no
 * outline. A wireframe has none either, without an error. Also QTRI_ERROR_MEMORY, and nothing is
 * drawn: qtri_outline_init failed.
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
 * formats of more than two bytes a row of colours. Notes are kept in the surface's depth; where it
 * has none, two bytes a pixel more. Depths of another format than linear16 become that as the pass
 * begins, so edges are compared in steps of 1/65535. Where depth_pitch is not the width,
 * |depth_pitch| counts as the width.
 */
#define QTRI_EDGES_WORDS(width, rows, pixel_bytes)                                                 \
    (((uint32_t)(width) * (uint32_t)(rows) + 31u) / 32u +                                          \
     ((pixel_bytes) > 2 ? (uint32_t)(width) : 0u))
#define QTRI_EDGES_WORDS_WITHOUT_DEPTH(width, rows, pixel_bytes)                                   \
    (QTRI_EDGES_WORDS(width, rows, pixel_bytes) + ((uint32_t)(width) * (uint32_t)(rows) + 1u) / 2u)

/*
 * Begins a pass over what is drawn on the surface, inside its scissor. Nothing may be drawn on it
 * until the blend. QTRI_ERROR_MEMORY: too few words. QTRI_ERROR_SIZE: |depth_pitch| is less than
 * the width or more than 65536. The pass has no pixels then, and what follows does nothing.
 *
 * Pixels of the outermost rows and columns inside the scissor may lack a share from outside of it:
 * a scissor, like a band, needs one pixel more. Inside of that the pixels do not depend on
 * band or scissor. On the frame's border nothing is missing.
 */
enum qtri_error qtri_edges_begin(qtri_edges *edges, const qtri_surface *surface, uint32_t *memory,
                                 uint32_t words);

/*
 * Notes the outline's edges where they are seen: where the stored depth is not nearer than the
 * edge's. Where pixels get several notes the greatest share wins. For several meshes pixels may
 * depend on the order, but not on band or scissor. An outline for frames of another size has no
 * edges here.
 */
void qtri_edges_note(qtri_edges *edges, const qtri_outline *outline);

/*
 * Gives the noted pixels their shares, of colours as they were before, rounded to the nearest step
 * of the format. The depth is spent: it holds notes and old colours.
 */
void qtri_edges_blend(qtri_edges *edges);

#ifdef __cplusplus
}
#endif

#endif
