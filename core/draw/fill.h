/* SPDX-License-Identifier: MIT */
/*
 * What draw calls make of triangles: material->fill. Internal.
 *
 * NULL fills them: mesh_solid.c for meshes, primitive.c for what is clipped. Everything else is a
 * description, whose functions nothing else names: what no material names is not linked.
 */
#ifndef QTRI_DRAW_FILL_H
#define QTRI_DRAW_FILL_H

#include "mesh_job.h"

struct qtri_fill {
    /* Sets primitive->to for its surface and its material. */
    void (*begin)(qtri_primitive *primitive);
    /* A triangle that may need clipping by `planes`, and culling; see qtri_primitive_triangle. */
    void (*clipped)(const qtri_primitive *primitive, const qtri_clip_vertex v[3], unsigned planes,
                    qtri_attribute_source source, const void *from);
    /* A triangle of a mesh that is seen, all of it inside. */
    void (*triangle)(const qtri_mesh_job *draw, const void *indices, qtri_vertex *const vertex[3]);
    /* A mesh with a slot for every vertex, to be transformed yet. */
    void (*mesh)(qtri_mesh_job *draw);
    /* Before bands draw a mesh whose vertices all are in their slots, or were left out with all
       their faces; and before one band does. */
    void (*prepare)(const qtri_mesh_job *draw, bool back_only);
    void (*band)(qtri_mesh_job *draw);
};

#endif
