/* SPDX-License-Identifier: MIT */
/*
 * Meshes prepared for a frame in bands: vertices are transformed and lit once per frame, and each
 * band looks only at the triangles that may touch it.
 *
 *     static qtri_vertex vertices[QTRI_MESH_VERTICES(500)];
 *     static uint16_t lists[QTRI_PREPARED_LISTS(996, 240, 16)];
 *     qtri_prepared_init(&gear, vertices, 500, lists, sizeof lists / sizeof lists[0]);
 *
 *     qtri_prepare_mesh(&gear, &frame, &view, &pose, &mesh, &material);
 *     while (qtri_frame_next_band(&frame, &band)) {
 *         qtri_surface_clear(&band, sky);
 *         qtri_draw_prepared(&band, &gear);
 *         ...
 *     }
 *
 * The pixels are those of qtri_draw_mesh, with whatever memory there is; less of it is slower.
 *
 * Two cores may draw bands of one frame from the same prepared meshes at the same time, each into
 * memory of its own, if there is a vertex for every vertex of the mesh: drawing then only reads.
 */
#ifndef QTRI_PREPARED_H
#define QTRI_PREPARED_H

#include "draw.h"
#include "frame.h"
#include "mesh.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct qtri_prepared {
    /* Memory, the caller's. */
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
 * Elements of `lists` for a mesh of so many triangles in bands of `rows` rows: a constant
 * expression. Enough to list every triangle by itself when half of them face away and those that do
 * not touch 1.5 bands on average. With less, groups of 2, 4, 8 ... triangles that follow each other
 * in the mesh are listed; a quarter is still quick when they lie close together.
 */
#define QTRI_PREPARED_LISTS(triangles, height, rows)                                               \
    ((uint32_t)(triangles) + 10u * (((uint32_t)(height) + (uint32_t)(rows)-1u) / (uint32_t)(rows)))

/* vertices and lists may be NULL with a count of 0. */
void qtri_prepared_init(qtri_prepared *prepared, qtri_vertex *vertices, uint32_t vertex_count,
                        uint16_t *lists, uint32_t list_count);

/*
 * Prepares what qtri_draw_mesh would draw with these arguments, for the bands of this frame.
 * view->vertices are not used. All that is pointed to must stay as it is until the frame's last
 * band is drawn.
 */
void qtri_prepare_mesh(qtri_prepared *prepared, const qtri_frame *frame, const qtri_view *view,
                       const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material);

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
