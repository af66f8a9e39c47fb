/* SPDX-License-Identifier: MIT */
/*
 * Triangles whose corners are no mesh's vertices, lit and unlit: each is drawn as a mesh of one
 * triangle. Internal.
 */
#ifndef QTRI_DRAW_CORNERS_H
#define QTRI_DRAW_CORNERS_H

#include "mesh_job.h"

/* What becomes of a triangle's corners. */
typedef enum qtri_corners_fate {
    QTRI_CORNERS_ELSEWHERE, /* not decided: one is outside, or not at w = 1 */
    QTRI_CORNERS_CULLED,
    QTRI_CORNERS_SEEN /* all of it */
} qtri_corners_fate;

/* The triangles of a draw call, one after the other. */
typedef struct qtri_corners {
    qtri_mesh_job job; /* of the mesh that the triangle is */
    qtri_mesh mesh;
    qtri_vec3 positions[3];
    qtri_vec2 uvs[3];
    qtri_rgb colors[3];
    /*
     * Vertices of the triangle and of the one before, with which it shares a third of its corners
     * or more where triangles are in the order that files have them in. `before` is NULL where none
     * was placed.
     */
    qtri_vertex vertex[2][3];
    const qtri_vertex *before;
    const uint8_t *alphas; /* the material's, of all corners */
} qtri_corners;

/* `shade`: see qtri_draw_state_init(). */
void qtri_corners_init(qtri_corners *c, const qtri_surface *surface, const qtri_view *view,
                       const qtri_transform *pose, const qtri_material *material, int shade);

/*
 * Three corners, of which `first` is the number in the call. The vertices of what is seen are
 * job.vertices then.
 */
qtri_corners_fate qtri_corners_place(qtri_corners *c, const qtri_corner *corners, uint32_t first);

/* Draws what is seen, with the colours and coordinates of `attributes`. */
void qtri_corners_draw(qtri_corners *c, const qtri_corner *attributes);

/* And what is elsewhere, transformed, which is lost: it may need clipping. */
void qtri_corners_draw_clipped(const qtri_corners *c, qtri_shape *shape,
                               const qtri_corner *attributes);

/* Transforms `count` corners of one primitive, which then share one scale. */
void qtri_corners_fetch(const qtri_primitive *primitive, const qtri_corner *corners, int count,
                        qtri_clip_vertex v[3]);

#endif
