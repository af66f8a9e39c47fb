/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage compiled for a core without long multiply and divide.
 */
#define QTRI_LONG_MULTIPLY 0
#define QTRI_DIVIDE        0

#define qtri_eye_find             narrow_eye_find
#define qtri_eye_mirror           narrow_eye_mirror
#define qtri_face_edge            narrow_face_edge
#define qtri_light_by_face        narrow_light_by_face
#define qtri_light_by_vertex      narrow_light_by_vertex
#define qtri_light_uneven         narrow_light_uneven
#define qtri_lighting_face        narrow_lighting_face
#define qtri_lighting_face8       narrow_lighting_face8
#define qtri_lighting_init        narrow_lighting_init
#define qtri_mesh_ball            narrow_mesh_ball
#define qtri_mesh_box             narrow_mesh_box
#define qtri_positions_compact    narrow_positions_compact
#define qtri_positions_wide       narrow_positions_wide
#define qtri_project              narrow_project
#define qtri_project_rest         narrow_project_rest
#define qtri_projector_set_depth  narrow_projector_set_depth
#define qtri_projector_compact    narrow_projector_compact
#define qtri_projector_init       narrow_projector_init
#define qtri_projector_init_view  narrow_projector_init_view
#define qtri_projector_misses     narrow_projector_misses
#define qtri_projector_point      narrow_projector_point
#define qtri_projector_point16    narrow_projector_point16
#define qtri_projector_points     narrow_projector_points
#define qtri_projector_vertices   narrow_projector_vertices
#define qtri_projector_vertices16 narrow_projector_vertices16
#define qtri_row16_set            narrow_row16_set
#define qtri_view_sees_ball       narrow_view_sees_ball
#define qtri_view_sees_box        narrow_view_sees_box
#define qtri_vertex_exact         narrow_vertex_exact

#include "geometry/cull.c"
#include "geometry/lighting.c"
#include "geometry/projector.c"

#include "vertex_narrow.h"

void narrow_vertices(const qtri_transform *object_to_clip, const qtri_viewport *viewport,
                     const qtri_vec3 *p, uint32_t count, qtri_vertex *out)
{
    qtri_projector projector;
    qtri_projector_init(&projector, object_to_clip, viewport);
    (void)qtri_projector_vertices(&projector, p, count, out, false);
}

void narrow_vertices16(const qtri_transform *object_to_clip, const qtri_viewport *viewport,
                       const qtri_vec3 *origin, q16 extent, const qtri_position16 *p,
                       uint32_t count, qtri_vertex *out)
{
    qtri_projector projector;
    qtri_projector_init(&projector, object_to_clip, viewport);
    qtri_projector_compact(&projector, origin, extent);
    (void)qtri_projector_vertices16(&projector, p, count, out, false);
}

bool narrow_eye(const qtri_transform *object_to_clip, const qtri_viewport *viewport,
                const qtri_mesh *mesh, const qtri_eye *expected)
{
    qtri_projector projector;
    qtri_eye eye;
    qtri_projector_init(&projector, object_to_clip, viewport);
    qtri_projector_compact(&projector, &mesh->origin, mesh->extent);
    return qtri_eye_find(&eye, &projector, &mesh->faces) && eye.x == expected->x &&
           eye.y == expected->y && eye.z == expected->z && eye.w == expected->w &&
           eye.behind == expected->behind;
}

uint32_t narrow_light_vertex(const qtri_light *light, const qtri_transform *object_to_eye,
                             const qtri_normal *normal)
{
    qtri_lighting lighting;
    qtri_lighting_init(&lighting, light, object_to_eye, false, &qtri_light_uneven);
    const qtri_mesh mesh = {.normals = normal};
    return qtri_light_by_vertex.vertex(&lighting, &mesh, 0);
}

uint32_t narrow_light_face(const qtri_light *light, const qtri_transform *object_to_eye,
                           const qtri_vec3 corner[3])
{
    qtri_lighting lighting;
    qtri_lighting_init(&lighting, light, object_to_eye, false, &qtri_light_uneven);
    return qtri_lighting_face(&lighting, &corner[0], &corner[1], &corner[2]);
}

uint32_t narrow_light_plane(const qtri_light *light, const qtri_transform *object_to_eye,
                            const qtri_face8 *face)
{
    qtri_lighting lighting;
    qtri_lighting_init(&lighting, light, object_to_eye, false, &qtri_light_uneven);
    return qtri_lighting_face8(&lighting, face);
}
