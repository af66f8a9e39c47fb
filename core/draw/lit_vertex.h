/* SPDX-License-Identifier: MIT */
/*
 * What light needs to know of a mesh's vertices and faces: where they are, and their normals, from
 * whichever arrays the mesh has. Internal.
 */
#ifndef QTRI_DRAW_LIT_VERTEX_H
#define QTRI_DRAW_LIT_VERTEX_H

#include "../geometry/lit_point.h"
#include "mesh_job.h"

/* The place of a vertex, where the job's illumination counts from. */
QTRI_IN_PLACE void qtri_lit_vertex_place(qtri_lit_point *point, const qtri_mesh_job *draw,
                                         uint32_t index)
{
    const qtri_mesh *mesh = draw->mesh;
    if (qtri_mesh_has_compact(mesh->positions16)) {
        qtri_illuminated_place16(point, draw->illumination, &mesh->positions16[index]);
    } else {
        qtri_illuminated_place(point, draw->illumination, &mesh->positions[index]);
    }
}

/* The normal of a vertex of a mesh that has some, Q14: of 8 bits it is shorter by 1/128. */
static inline void qtri_lit_vertex_normal(int32_t n[3], const qtri_mesh *mesh, uint32_t index)
{
    if (qtri_mesh_has_compact(mesh->normals8)) {
        const qtri_normal8 *normal = &mesh->normals8[index];
        n[0] = normal->x * 128;
        n[1] = normal->y * 128;
        n[2] = normal->z * 128;
    } else {
        const qtri_normal *normal = &mesh->normals[index];
        n[0] = normal->x;
        n[1] = normal->y;
        n[2] = normal->z;
    }
}

/* A triangle's corners, in a scale that does not matter for its normal. */
static inline void qtri_lit_face_positions(qtri_vec3 p[3], const qtri_mesh *mesh,
                                           const uint32_t index[3])
{
    for (int i = 0; i < 3; i++) {
        if (qtri_mesh_has_compact(mesh->positions16)) {
            const qtri_position16 *from = &mesh->positions16[index[i]];
            p[i].x = from->x;
            p[i].y = from->y;
            p[i].z = from->z;
        } else {
            p[i] = mesh->positions[index[i]];
        }
    }
}

#endif
