/*
 * What draw calls make of triangles, as material->fill says. Internal.
 *
 * NULL fills them: mesh_solid.c for meshes, primitive.c for what is clipped. Everything else is a
 * description, whose functions nothing else names: what no material names is not linked.
 */
#ifndef QTRI_DRAW_FILL_H
#define QTRI_DRAW_FILL_H

#include "mesh_job.h"

typedef struct qtri_fill_way {
    /* Calls draws(what) while primitive->to is there for the surface and the material. */
    void (*draw)(qtri_primitive *primitive, void (*draws)(void *what), void *what);
    /* A triangle that may need clipping by `planes`, and culling; see qtri_primitive_triangle. */
    void (*clipped)(const qtri_primitive *primitive, const qtri_clip_vertex v[3], unsigned planes,
                    qtri_attribute_source source, const void *from);
    /* A triangle of a mesh that is seen, all of it inside. */
    void (*triangle)(const qtri_mesh_job *draw, const void *indices, qtri_vertex *const vertex[3]);
    /* A mesh with a slot for every vertex. */
    void (*mesh)(qtri_mesh_job *draw);
    /* Before bands draw a mesh whose vertices all are in their slots, and before one does. */
    void (*prepare)(const qtri_mesh_job *draw, bool back_only);
    void (*band)(qtri_mesh_job *draw);
} qtri_fill_way;

extern const qtri_fill_way qtri_wireframe; /* mesh_lines.c */

static inline const qtri_fill_way *qtri_fill_of(const qtri_material *material)
{
    return material->fill == QTRI_SOLID ? NULL : &qtri_wireframe;
}

#endif
