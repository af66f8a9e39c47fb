/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage compiled for a core without long multiply and divide: the same results.
 */
#ifndef QTRI_TESTS_SUPPORT_VERTEX_NARROW_H
#define QTRI_TESTS_SUPPORT_VERTEX_NARROW_H

#include <qtri/mesh.h>
#include <qtri/view.h>

#include "geometry/cull.h"

/* A projector and the vertices it makes of p; origin is NULL for wide ones. */
void narrow_vertices(const qtri_transform *object_to_clip, const qtri_viewport *viewport,
                     const qtri_vec3 *p, uint32_t count, qtri_vertex *out);
void narrow_vertices16(const qtri_transform *object_to_clip, const qtri_viewport *viewport,
                       const qtri_vec3 *origin, q16 extent, const qtri_position16 *p,
                       uint32_t count, qtri_vertex *out);

/* Whether the eye is found of a mesh with planes, which then must be *expected. */
bool narrow_eye(const qtri_transform *object_to_clip, const qtri_viewport *viewport,
                const qtri_mesh *mesh, const qtri_eye *expected);

uint32_t narrow_light_vertex(const qtri_light *light, const qtri_transform *object_to_eye,
                             const qtri_normal *normal);
uint32_t narrow_light_face(const qtri_light *light, const qtri_transform *object_to_eye,
                           const qtri_vec3 corner[3]);
uint32_t narrow_light_plane(const qtri_light *light, const qtri_transform *object_to_eye,
                            const qtri_face8 *face);

#endif
