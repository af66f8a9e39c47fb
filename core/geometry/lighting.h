/* SPDX-License-Identifier: MIT */
/*
 * One directional light for one draw call. Internal.
 */
#ifndef QTRI_GEOMETRY_LIGHTING_H
#define QTRI_GEOMETRY_LIGHTING_H

#include <stdbool.h>

#include "qtri/mesh.h"
#include "qtri/view.h"

#include "row16.h"

/*
 * Where eye space is object space rotated, reflected or scaled evenly, the light is taken to object
 * space once and a vertex costs a dot product: of a row, where the light is no stranger than most.
 * Otherwise every normal goes through the inverse transpose and is normalised.
 */
typedef struct qtri_lighting {
    bool even, plain;   /* plain: even, and the row serves */
    uint32_t least_q15; /* plain: intensity without the diffuse part */
    q16 ambient, diffuse;
    int32_t towards_q30[3]; /* unit, in object space when even, else in eye space */
    union {
        qtri_row16 row;           /* plain: from a normal to intensity times 2^25 */
        int32_t normal_q28[3][3]; /* not even: inverse transpose up to a positive factor */
    } by;
} qtri_lighting;

/*
 * unit: what 1 is in the normals of vertices that will be lit. Without QTRI_WITH_UNEVEN_LIGHT what
 * is not plain is not to be lit at all.
 */
void qtri_lighting_init(qtri_lighting *lighting, const qtri_light *light,
                        const qtri_transform *object_to_eye, int32_t unit);

#define QTRI_INTENSITY_ONE 0x8000u /* intensities have 15 fraction bits */

/* min(1, ambient + diffuse max(0, n . towards)) in 0..1, for a unit normal. */
uint32_t qtri_lighting_vertex(const qtri_lighting *lighting, const qtri_normal *normal);
uint32_t qtri_lighting_vertex8(const qtri_lighting *lighting, const qtri_normal8 *normal);

/* The same for the vertices whose numbers are vertices[0..count-1].index, each in its slot. */
void qtri_lighting_list(const qtri_lighting *lighting, const qtri_normal *normals, uint32_t count,
                        qtri_vertex *vertices);
void qtri_lighting_list8(const qtri_lighting *lighting, const qtri_normal8 *normals, uint32_t count,
                         qtri_vertex *vertices);

/* The same for the face a b c, counter-clockwise; a face without area gets the ambient light. */
uint32_t qtri_lighting_face(const qtri_lighting *lighting, const qtri_vec3 *a, const qtri_vec3 *b,
                            const qtri_vec3 *c);
/*
 * The same for a face whose plane is not 0 0 0, by the plane alone: off by the plane's angle to
 * the face times the diffuse part, and 2^-11. For light that is plain.
 */
uint32_t qtri_lighting_face8(const qtri_lighting *lighting, const qtri_face8 *face);

uint32_t qtri_lighting_face16(const qtri_lighting *lighting, const qtri_position16 *a,
                              const qtri_position16 *b, const qtri_position16 *c);

#endif
