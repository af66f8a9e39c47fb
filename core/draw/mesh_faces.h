/* SPDX-License-Identifier: MIT */
/*
 * Back-face culling of a mesh by the planes of its faces, see mesh.h. Internal.
 *
 * A plane tells by four products that its face turns away, before any of the face's vertices is
 * transformed. The triangles that are left of QTRI_FACES_AT_ONCE are listed; then their vertices
 * that no list before had are transformed and lit, one after another. The depth of a vertex that is
 * not visited yet is that of an empty slot. The indices of vertices to be transformed stand in the
 * vertices' field `index`, which nothing else uses where each has a slot.
 */
#ifndef QTRI_DRAW_MESH_FACES_H
#define QTRI_DRAW_MESH_FACES_H

#include "../geometry/cull.h"
#include "mesh_job.h"

enum {
    QTRI_FACES_AT_ONCE = 128,
    QTRI_FACES_STEP = 6 /* what list entries count a triangle: bytes of 16-bit indices */
};

typedef struct qtri_mesh_faces {
    qtri_eye eye;
    uint32_t next;            /* the first triangle that is not tested yet */
    bool inside;              /* no vertex visited so far is outside */
    const uint8_t *triangles; /* of the list: its first one's indices */
    const uint16_t *end;
    uint16_t list[QTRI_FACES_AT_ONCE + 2]; /* steps from `triangles`; room for an end of it */
} qtri_mesh_faces;

/* The indices of a triangle in the list: a step is six bytes, or three. */
static inline const uint8_t *qtri_mesh_faces_triangle(const uint8_t *triangles, uint32_t entry,
                                                      bool narrow)
{
    return &triangles[narrow ? entry / 2 : entry];
}

/* How many triangles it is from the list's first: 3 times the factor is 1 modulo 2^32. */
static inline uint32_t qtri_mesh_faces_number(uint32_t entry)
{
    uint32_t third = 0xAAAAAAABu;
    QTRI_HOLD(third); /* GCC 12 would make shifts and sums of the product */
    return (entry / 2) * third;
}

/* Draws a triangle with its vertices inside all planes of a mesh whose back faces are culled: the
   pipeline asks whether a small one turns away. */
QTRI_INLINE void qtri_mesh_draw_front(const qtri_mesh_job *draw, qtri_small *t, const void *indices,
                                      const uint32_t index[3], qtri_vertex *const vertex[3])
{
    if (!qtri_mesh_draw_small(t, indices, index, vertex) &&
        !qtri_triangle_is_back(&t->v[0]->at, &t->v[1]->at, &t->v[2]->at)) {
        qtri_mesh_draw_large(draw, indices, t->v[0], t->v[1], t->v[2]);
    }
}

/* qtri_faces.culling. */
struct qtri_face_culling {
    /*
     * For a job that is placed and has a slot for each vertex. False where planes tell nothing:
     * nothing is culled, or see qtri_eye_find(); nothing is changed then.
     */
    bool (*begin)(qtri_mesh_faces *faces, const qtri_mesh_job *draw);
    /*
     * Lists more triangles: of planes that may be seen, all indices valid, in the order of the
     * mesh; possibly none. Their vertices are transformed and lit. False after the last.
     */
    bool (*next)(qtri_mesh_faces *faces, const qtri_mesh_job *draw);
    /* Draws all triangles, filled; or none, and returns false. */
    bool (*draw)(qtri_mesh_job *draw);
};

#endif
