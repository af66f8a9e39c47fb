/* SPDX-License-Identifier: MIT */
/*
 * Which edges of what faces the eye are its outline. Internal.
 *
 * outline.c takes them: into lists for bands, or to walk along them.
 */
#ifndef QTRI_DRAW_OUTLINE_FIND_H
#define QTRI_DRAW_OUTLINE_FIND_H

#include "edge_walk.h"
#include "outline.h"

typedef struct qtri_edge_finder qtri_edge_finder;
struct qtri_edge_finder {
    const qtri_outline *outline;
    const qtri_mesh_job *job; /* for light: NULL where no creases are asked for */
    /* Takes those of a triangle's edges that have a bit; false: it has no room for all of them. */
    bool (*take)(qtri_edge_finder *f, uint32_t triangle, uint32_t edges, bool weak);
    uint32_t from;           /* the first triangle that was not looked at or not taken */
    qtri_edge_walker walker; /* for walks */
    uint32_t bands, next, end, inverse, shift; /* for lists: entries, and 1 / rows */
    int32_t height;                            /* rows of the frame */
    int32_t above, below;                      /* rows that bands reach beyond their own */
};

static inline const void *qtri_outline_triangle(const qtri_mesh *mesh, uint32_t number)
{
    return qtri_mesh_triangle(mesh, number, qtri_mesh_has_bytes(mesh));
}

/*
 * The vertices of a triangle, if all are inside. One that is front, or has an edge in a list, has
 * indices of vertices: whoever found that has looked at them.
 */
static inline bool qtri_outline_vertices(const qtri_outline *outline, uint32_t number,
                                         qtri_vertex *vertex[3])
{
    const qtri_mesh *mesh = outline->mesh;
    uint32_t index[3];
    qtri_mesh_indices(index, qtri_outline_triangle(mesh, number), qtri_mesh_has_bytes(mesh));
    qtri_mesh_get(vertex, outline->vertices, index, qtri_vertex_size());
    return qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2]);
}

/* The sums of a mesh without neighbours, which the first pass looks at. */
void qtri_outline_add_sums(const qtri_outline *outline);

/*
 * Passes from this one of the three on, the first from a triangle on. Returns the one that was not
 * finished, and f->from says at which triangle; 3: all were.
 */
uint32_t qtri_outline_find(qtri_edge_finder *f, uint32_t pass, uint32_t from);

#endif
