/* SPDX-License-Identifier: MIT */
/*
 * Lists of triangles by band. In the caller's memory, one after another:
 *
 *   for every band: the place of its first entry, 0 for none; the place after its last
 *   blocks of eight: seven entries and the place of the list's next block
 *
 * Places count elements from the start. An entry is the number of a group of 2^group_log2 triangles
 * that follow each other in the mesh; it is in the list of every band that one of them may touch.
 * Lists are in the order of the mesh, as drawing is: where depths are equal, it decides.
 *
 * prepared.c makes them, prepared_draw.c reads them. Internal.
 */
#ifndef QTRI_DRAW_PREPARED_LISTS_H
#define QTRI_DRAW_PREPARED_LISTS_H

#include "qtri/prepared.h"

#include "mesh_job.h"

enum { QTRI_LIST_BLOCK = 8, QTRI_LIST_FULL = QTRI_LIST_BLOCK - 1 };

static inline bool qtri_rect_is_empty(const qtri_rect *rect)
{
    return rect->x0 >= rect->x1 || rect->y0 >= rect->y1;
}

/* A vertex for every vertex of the mesh. */
static inline bool qtri_prepared_is_complete(const qtri_prepared *prepared)
{
    return prepared->vertex_count >= prepared->mesh->vertex_count;
}

/* The triangle's indices in the mesh. */
static inline const uint8_t *qtri_prepared_triangle(const qtri_mesh *mesh, uint32_t number)
{
    return qtri_mesh_has_bytes(mesh) ? mesh->triangles8[number]
                                     : (const uint8_t *)mesh->triangles[number];
}

/*
 * What is added to the least and the greatest coordinate before they are rounded down to the first
 * pixel and the one after the last: centres in between, or what a line may touch when it rounds.
 */
static inline int32_t qtri_prepared_before_24p8(bool is_solid)
{
    return is_solid ? 127 : -256;
}

static inline int32_t qtri_prepared_after_24p8(bool is_solid)
{
    return is_solid ? 127 : 512;
}

static inline void qtri_prepared_widen(qtri_rect *extent_24p8, const qtri_vertex *vertex)
{
    extent_24p8->x0 = qtri_least32(extent_24p8->x0, vertex->at.x_24p8);
    extent_24p8->y0 = qtri_least32(extent_24p8->y0, vertex->at.y_24p8);
    extent_24p8->x1 = qtri_greatest32(extent_24p8->x1, vertex->at.x_24p8);
    extent_24p8->y1 = qtri_greatest32(extent_24p8->y1, vertex->at.y_24p8);
}

/* The group at a place of a list, which moves on. */
static inline uint32_t qtri_list_next(const uint16_t *lists, uint32_t *place)
{
    if (*place % QTRI_LIST_BLOCK == QTRI_LIST_FULL) {
        *place = lists[*place];
    }
    return lists[(*place)++];
}

/* In mesh_solid.c: fills a band's list of a mesh whose back faces were culled, all vertices inside,
   from the list's place to its end. */
void qtri_mesh_draw_band(const qtri_mesh_job *draw, const uint16_t *lists, uint32_t place,
                         uint32_t end);

/* The job for a surface, as prepared; with `place` its transforms too. False: nothing is seen. */
bool qtri_prepared_begin(qtri_mesh_job *job, const qtri_prepared *prepared,
                         const qtri_surface *surface, bool place);

#endif
