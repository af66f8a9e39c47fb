/* SPDX-License-Identifier: MIT */
/*
 * Meshes prepared for a frame in bands: vertices are transformed and lit once per frame, and each
 * band looks only at the triangles that may touch it.
 *
 *     static uint8_t memory[QTRI_PREPARED_BYTES(500, 996, 240, 16)];
 *     qtri_prepared_init(&gear, memory, sizeof memory);
 *
 *     qtri_prepare_mesh(&gear, &frame, &view, &pose, &mesh, &material);
 *     while (qtri_frame_next_band(&frame, &band)) {
 *         qtri_surface_clear(&band, sky);
 *         qtri_draw_prepared(&band, &gear);
 *         ...
 *     }
 *
 * The pixels are those of qtri_draw_mesh, with whatever memory there is; less of it is slower. With
 * a vertex for every vertex of the mesh drawing only reads: two cores may draw bands of one frame
 * from the same prepared meshes at the same time, each into memory of its own.
 */
#ifndef QTRI_PREPARED_H
#define QTRI_PREPARED_H

#include <stddef.h>

#include "draw.h"
#include "frame.h"
#include "mesh.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A mesh that is transformed and sorted into the bands of a frame. */
typedef struct qtri_prepared {
    void *memory; /* the caller's, divided anew for each mesh; NULL: divided by hand, below */
    size_t bytes;
    qtri_vertex *vertices;
    uint32_t vertex_count; /* fewer than the mesh's: they are transformed again in every band */
    uint16_t *lists;
    uint32_t list_count; /* fewer than QTRI_PREPARED_LISTS: more triangles are looked at per band */
    /* Internal. */
    bool is_seen, is_solid, is_placed, is_anywhere, back_only;
    uint8_t group_log2;
    uint32_t listed; /* triangles; those that follow are not in lists */
    int32_t width, height, rows;
    int32_t overlap;                  /* rows beyond each band that its list reaches */
    int32_t edges_above, edges_below; /* and those that its list of edges reaches */
    uint32_t *front;                  /* an outline's, for this mesh; NULL: none */
    const qtri_mesh *front_of;
    qtri_rect extent_24p8, marked;
    const qtri_vertex_stage *stage;
    const qtri_view *view;
    const qtri_transform *pose;
    const qtri_mesh *mesh;
    const qtri_material *material;
} qtri_prepared;

/*
 * Memory for a mesh of so many vertices and triangles in bands of `rows` rows: a constant
 * expression; what `qtri mesh` writes has one by name, GEAR_BYTES(height, rows). In coloured lights
 * (light.h) count QTRI_LIT_VERTICES.
 *
 * Lists have room for every triangle by itself when half of them face away and the mesh is as high
 * as the frame: each is in the list of every band that it touches, and the heights of t triangles
 * that cover a square make up sqrt(t) of its sides. With less, groups of 2, 4, 8 ... triangles that
 * follow each other in the mesh are listed; a quarter is still quick when they lie close together.
 */
#define QTRI_PREPARED_BYTES(vertices, triangles, height, rows)                                     \
    ((size_t)(vertices) * sizeof(qtri_vertex) +                                                    \
     sizeof(uint16_t) * QTRI_PREPARED_LISTS(triangles, height, rows) + 3u)
#define QTRI_PREPARED_LISTS(t, height, rows)                                                       \
    (10u * QTRI_PREPARED_BANDS(height, rows) +                                                     \
     (QTRI_PREPARED_SPLIT(t, height, rows) > (t) ? QTRI_PREPARED_SPLIT(t, height, rows) : (t)))
#define QTRI_PREPARED_SPLIT(t, height, rows)                                                       \
    ((t) / 7u * 4u + QTRI_PREPARED_BANDS(height, rows) * QTRI_PREPARED_ROOT(t))
#define QTRI_PREPARED_BANDS(height, rows)                                                          \
    (((uint32_t)(height) + (uint32_t)(rows)-1u) / (uint32_t)(rows))
#define QTRI_PREPARED_ROOT(t) /* sqrt(t) or more */                                                \
    ((t) <= 64     ? 8u                                                                            \
     : (t) <= 256  ? 16u                                                                           \
     : (t) <= 512  ? 23u                                                                           \
     : (t) <= 1024 ? 32u                                                                           \
     : (t) <= 2048 ? 46u                                                                           \
     : (t) <= 4096 ? 64u                                                                           \
     : (t) <= 8192 ? 91u                                                                           \
                   : 256u)

/*
 * Vertices come first in the memory, the rest is lists; where there is not room for all vertices,
 * half of it is. NULL, with 0 bytes: everything is found anew in each band.
 */
void qtri_prepared_init(qtri_prepared *prepared, void *memory, size_t bytes);

/*
 * Prepares what qtri_draw_mesh would draw with these arguments, for the bands of this frame.
 * view->vertices are not used. All that is pointed to must stay as it is until the frame's last
 * band is drawn.
 */
void qtri_prepare_mesh(qtri_prepared *prepared, const qtri_frame *frame, const qtri_view *view,
                       const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material);

/*
 * Whether there was a vertex for each of the mesh's that was prepared last, and every triangle is
 * listed by itself, as QTRI_PREPARED_BYTES has it, down to bands of one row, for a mesh that is as
 * high as the frame. False: the same pixels, slower. Before the first mesh: false.
 */
bool qtri_prepared_fits(const qtri_prepared *prepared);

/* With a vertex stage of the application's own, see draw.h. */
void qtri_prepare_mesh_by(const qtri_vertex_stage *stage, qtri_prepared *prepared,
                          const qtri_frame *frame, const qtri_view *view,
                          const qtri_transform *pose, const qtri_mesh *mesh,
                          const qtri_material *material);

/*
 * Marks the mesh as changed, see frame.h: the pixels that it may touch, and those that it might
 * have when this was last called. After qtri_prepare_mesh; not called for a mesh that looks as in
 * the last frame. A mesh that crosses a plane of the frustum counts as the whole frame.
 */
void qtri_prepared_mark(qtri_prepared *prepared, qtri_frame *frame);

/*
 * Draws what falls into the surface: a band of the frame, or any other rows of it. Nothing before
 * qtri_prepare_mesh, or when the surface's frame has another size.
 */
void qtri_draw_prepared(const qtri_surface *surface, const qtri_prepared *prepared);

#ifdef __cplusplus
}
#endif

#endif
