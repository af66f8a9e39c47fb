/* SPDX-License-Identifier: MIT */
/*
 * Meshes with planes of faces, in every form, and views of them.
 */
#ifndef QTRI_TESTS_SUPPORT_FACES_H
#define QTRI_TESTS_SUPPORT_FACES_H

#include "core.h"

#include "tools/mesh_faces.h"

enum {
    FACES_RINGS = 14,
    FACES_SIDES = 15,
    FACES_VERTICES = FACES_RINGS * FACES_SIDES,
    FACES_TRIANGLES = 2 * FACES_VERTICES
};

/* A closed mesh in both forms: the same points, or as near as 16 bits are. */
typedef struct faces_mesh {
    qtri_vec3 position[FACES_VERTICES];
    qtri_normal normal[FACES_VERTICES];
    uint16_t triangle[FACES_TRIANGLES][3];
    qtri_face8 plane[FACES_TRIANGLES];
    qtri_position16 position16[FACES_VERTICES];
    qtri_normal8 normal8[FACES_VERTICES];
    uint8_t triangle8[FACES_TRIANGLES][3];
    qtri_face8 plane16[FACES_TRIANGLES];
    qtri_mesh wide, compact;
} faces_mesh;

static inline double faces_random(uint64_t *seed, double low, double high)
{
    return low + (high - low) * (random_in(seed, 0, 1 << 30) / (double)(1 << 30));
}

/*
 * A torus, fat or thin, whose vertices are moved by `noise` of its size: from smooth to a tangle of
 * needles. With `size` in q16 its outer radius, away from the origin.
 */
static inline void faces_mesh_make(faces_mesh *m, uint64_t *seed, double noise)
{
    const double pi = 3.14159265358979323846;
    const double size = 65536.0 * faces_random(seed, .2, 3.0);
    const double fat = faces_random(seed, .1, .5);
    const double flat = random_flag(seed) ? 1.0 : faces_random(seed, .02, 1.0);
    const double center[3] = {random_in(seed, -90000, 90000), random_in(seed, -90000, 90000), 333};
    double most = 0.0;
    for (int i = 0; i < FACES_VERTICES; i++) {
        const double ring = 2 * pi * (i / FACES_SIDES) / FACES_RINGS;
        const double side = 2 * pi * (i % FACES_SIDES) / FACES_SIDES;
        const double reach = 1 - fat + fat * cos(side);
        const double n[3] = {cos(side) * cos(ring), cos(side) * sin(ring), sin(side)};
        const double p[3] = {reach * cos(ring), reach * sin(ring), fat * flat * sin(side)};
        int32_t at[3];
        for (int k = 0; k < 3; k++) {
            const double moved = (p[k] + faces_random(seed, -noise, noise)) * size;
            most = fmax(most, fabs(moved));
            at[k] = (int32_t)lrint(moved);
        }
        const qtri_vec3 position = {at[0], at[1], at[2]}; /* the centre is added below */
        const qtri_normal normal = {(int16_t)lrint(n[0] * 16384), (int16_t)lrint(n[1] * 16384),
                                    (int16_t)lrint(n[2] * 16384)};
        const qtri_normal8 normal8 = {(int8_t)lrint(n[0] * 127), (int8_t)lrint(n[1] * 127),
                                      (int8_t)lrint(n[2] * 127)};
        m->position[i] = position;
        m->normal[i] = normal;
        m->normal8[i] = normal8;
        const int up = i % FACES_SIDES == FACES_SIDES - 1 ? i - FACES_SIDES + 1 : i + 1;
        const int next = (i + FACES_SIDES) % FACES_VERTICES;
        const int next_up = (up + FACES_SIDES) % FACES_VERTICES;
        const int quad[6] = {i, next, next_up, i, next_up, up};
        for (int k = 0; k < 6; k++) {
            m->triangle[2 * i + k / 3][k % 3] = (uint16_t)quad[k];
            m->triangle8[2 * i + k / 3][k % 3] = (uint8_t)quad[k];
        }
    }
    const qtri_vec3 origin = {(q16)center[0], (q16)center[1], (q16)center[2]};
    const q16 extent = (q16)most + 1;
    for (int i = 0; i < FACES_VERTICES; i++) {
        qtri_vec3 *p = &m->position[i];
        m->position16[i].x = (int16_t)lrint(fmax(-32767, fmin(32767, p->x * 32768.0 / extent)));
        m->position16[i].y = (int16_t)lrint(fmax(-32767, fmin(32767, p->y * 32768.0 / extent)));
        m->position16[i].z = (int16_t)lrint(fmax(-32767, fmin(32767, p->z * 32768.0 / extent)));
        p->x += origin.x;
        p->y += origin.y;
        p->z += origin.z;
    }
    const qtri_mesh wide = {.positions = m->position,
                            .normals = m->normal,
                            .triangles = (const uint16_t(*)[3])m->triangle,
                            .vertex_count = FACES_VERTICES,
                            .triangle_count = FACES_TRIANGLES};
    const qtri_mesh compact = {.positions16 = m->position16,
                               .normals8 = m->normal8,
                               .origin = origin,
                               .extent = extent,
                               .triangles = (const uint16_t(*)[3])m->triangle,
                               .vertex_count = FACES_VERTICES,
                               .triangle_count = FACES_TRIANGLES};
    m->wide = wide;
    m->compact = compact;
    (void)mesh_faces_fill(&m->wide, m->plane);
    (void)mesh_faces_fill(&m->compact, m->plane16);
}

/* Perspectives of all widths and parallel ones, near and far, for a frame of this size. */
static inline void faces_view(qtri_view *view, uint64_t *seed, int32_t width, int32_t height)
{
    const double aspect = (double)width / height;
    qtri_view_init(view, width, height);
    if (random_in(seed, 0, 5) == 0) {
        const double half = faces_random(seed, .5, 8.0);
        qtri_transform_ortho(&view->projection, fixed(-half * aspect), fixed(half * aspect),
                             fixed(-half), fixed(half), Q16(.1), Q16(400));
    } else {
        qtri_transform_perspective(&view->projection, fixed(faces_random(seed, 5, 140)),
                                   fixed(aspect), Q16(.1), Q16(400));
    }
}

/* Turned any way, uneven or mirrored now and then, at any distance but behind the eye. */
static inline void faces_pose(qtri_transform *pose, uint64_t *seed, const qtri_mesh *mesh)
{
    const double radius = real(mesh->extent);
    const double away =
        random_in(seed, 0, 9) == 0 ? faces_random(seed, 10, 100) : faces_random(seed, .9, 8);
    const double far = radius * away;
    const double beside = faces_random(seed, -.6, .6) * far;
    const qtri_vec3 place = vec3_of(beside, faces_random(seed, -.6, .6) * far, -far);
    const qtri_vec3 axis = {random_any(seed), random_any(seed), random_any(seed)};
    const qtri_vec3 back = {-mesh->origin.x, -mesh->origin.y, -mesh->origin.z};
    qtri_vec3 factor = {Q16_ONE, Q16_ONE, Q16_ONE};
    switch (random_in(seed, 0, 4)) {
    case 0:
        factor.x = fixed(faces_random(seed, .2, 2));
        factor.y = fixed(faces_random(seed, .2, 2));
        factor.z = fixed(faces_random(seed, .2, 2));
        break;
    case 1:
        factor.x = -factor.x;
        break;
    default:
        break;
    }
    qtri_transform_identity(pose);
    qtri_transform_translate(pose, place);
    qtri_transform_rotate(pose, random_in(seed, 0, 360 << 16), axis);
    qtri_transform_scale(pose, factor);
    qtri_transform_translate(pose, back);
}

#endif
