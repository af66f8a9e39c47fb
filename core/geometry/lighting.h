/* SPDX-License-Identifier: MIT */
/*
 * The white directional light of a draw call: intensities of vertices and faces. Internal.
 */
#ifndef QTRI_GEOMETRY_LIGHTING_H
#define QTRI_GEOMETRY_LIGHTING_H

#include <stdbool.h>

#include "qtri/draw.h"
#include "qtri/mesh.h"
#include "qtri/view.h"

#include "row.h"

/* The view's light if it is one white directional light, and if it has sources; otherwise NULL. */
static inline const qtri_light *qtri_white_light(const qtri_view *view)
{
    return view->light != NULL && view->light->model == NULL ? view->light : NULL;
}

static inline const qtri_light *qtri_colored_light(const qtri_view *view)
{
    return view->light != NULL && view->light->model != NULL ? view->light : NULL;
}

/*
 * Where eye space is object space rotated, reflected or scaled evenly, the light is taken to object
 * space once and a vertex costs a dot product: with a row, if ambient and diffuse are 0 or more and
 * diffuse is 4 at most. Otherwise every normal goes through the inverse transpose and is
 * normalised.
 */
typedef struct qtri_lighting {
    bool even, plain;                /* even: as above; plain: even, and the row serves */
    const qtri_uneven_light *uneven; /* not plain: the functions that serve; NULL: none */
    uint32_t least_q15;              /* plain: intensity without the diffuse part */
    q16 ambient, diffuse;
    int32_t towards_q30[3]; /* unit, in object space when even, else in eye space */
    union {
        qtri_row16 row;           /* plain: from a normal to intensity times 2^25 */
        int32_t normal_q28[3][3]; /* not even: inverse transpose up to a positive factor */
    } by;
} qtri_lighting;

/*
 * is_bytes: vertices with normals of 8 bits will be lit, of length 127. Where only `uneven` would
 * serve, and that is NULL, light is 1 everywhere.
 */
void qtri_lighting_init(qtri_lighting *lighting, const qtri_light *light,
                        const qtri_transform *object_to_eye, bool is_bytes,
                        const qtri_uneven_light *uneven);

#define QTRI_INTENSITY_ONE 0x8000u /* intensities have 15 fraction bits */

/*
 * min(1, ambient + diffuse max(0, n . towards)) in 0..1 for the face a b c, counter-clockwise; a
 * face without area gets the ambient light.
 */
uint32_t qtri_lighting_face(const qtri_lighting *lighting, const qtri_vec3 *a, const qtri_vec3 *b,
                            const qtri_vec3 *c);
/*
 * The intensity of a face by its plane, which is not 0 0 0, alone: off by the plane's angle to the
 * face times the diffuse part, and 2^-11. For light that is plain.
 */
uint32_t qtri_lighting_face8(const qtri_lighting *lighting, const qtri_face8 *face);

/* The edge from a to b, divided by 2^3 where it is 2^30 or longer. */
void qtri_face_edge(int32_t edge[3], const qtri_vec3 *a, const qtri_vec3 *b);

/* The normal of a vertex of a mesh that has some, Q14: of 8 bits it is shorter by 1/128. */
static inline void qtri_lit_vertex_normal(int32_t n[3], const qtri_mesh *mesh, uint32_t index)
{
    if (mesh->normals8 != NULL) {
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

/* Positions of a triangle, in a scale that does not matter for its normal. */
static inline void qtri_mesh_positions(qtri_vec3 p[3], const qtri_mesh *mesh,
                                       const uint32_t index[3])
{
    for (int i = 0; i < 3; i++) {
        if (mesh->positions16 != NULL) {
            const qtri_position16 *from = &mesh->positions16[index[i]];
            p[i].x = from->x;
            p[i].y = from->y;
            p[i].z = from->z;
        } else {
            p[i] = mesh->positions[index[i]];
        }
    }
}

/* Lights a mesh's vertices: see qtri_vertex_stage. */
struct qtri_vertex_light {
    void (*init)(qtri_lighting *lighting, const qtri_light *light,
                 const qtri_transform *object_to_eye, bool is_bytes,
                 const qtri_uneven_light *uneven);
    /* min(1, ambient + diffuse max(0, n . towards)) in 0..1, Q15, n being the vertex's normal. */
    uint32_t (*vertex)(const qtri_lighting *lighting, const qtri_mesh *mesh, uint32_t index);
    /* The vertices whose indices are vertices[0..count-1].index, each in its slot. */
    void (*list)(const qtri_lighting *lighting, const qtri_mesh *mesh, uint32_t count,
                 qtri_vertex *vertices);
};

/* Lights a mesh's faces: `face` is the intensity, Q15, of triangle `number` with these indices. */
struct qtri_face_light {
    void (*init)(qtri_lighting *lighting, const qtri_light *light,
                 const qtri_transform *object_to_eye, bool is_bytes,
                 const qtri_uneven_light *uneven);
    uint32_t (*face)(const qtri_lighting *lighting, const qtri_mesh *mesh, uint32_t number,
                     const uint32_t index[3]);
};

/* Light that is not plain; `direction`: the intensity, Q15, for a normal of any length. */
struct qtri_uneven_light {
    void (*init)(qtri_lighting *lighting, const int32_t towards[3],
                 const qtri_transform *object_to_eye);
    uint32_t (*direction)(const qtri_lighting *lighting, const int32_t normal[3]);
};

#endif
