/* SPDX-License-Identifier: MIT */
/*
 * Draw calls: from object space to pixels. Each composes stages that can be called alone:
 * transform (transform.h), vertex stage, clipping (clip.h), rasterizer (raster.h).
 */
#ifndef QTRI_DRAW_H
#define QTRI_DRAW_H

#include "clip.h"
#include "mesh.h"
#include "raster.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A vertex with everything it can bring. */
typedef struct qtri_corner {
    qtri_vec4 position; /* object space, homogeneous: any w */
    qtri_rgb color;
    qtri_vec2 uv;
} qtri_corner;

/*
 * Draws corner_count / 3 triangles (lines: corner_count / 2), transformed by
 * view->projection view->camera pose. Light does not apply: corners have no normals. What draws
 * triangles in a view's lights is qtri_draw_lit_triangles, see light.h.
 */
void qtri_draw_triangles(const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_corner *corners,
                         uint32_t corner_count, const qtri_material *material);
void qtri_draw_lines(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                     const qtri_corner *corners, uint32_t corner_count,
                     const qtri_material *material);

/*
 * Draws a mesh. Each vertex is transformed once when view->vertices has room for all of them.
 * With view->light the colours are scaled by its intensity: per vertex for smooth shading and a
 * mesh with normals, per face otherwise. Normals follow the inverse transpose of camera and pose.
 * view->lights take its place, see light.h.
 */
void qtri_draw_mesh(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                    const qtri_mesh *mesh, const qtri_material *material);

/*
 * What a draw call does with a mesh's vertices. qtri_draw_mesh and qtri_prepare_mesh link all of
 * it; an application that names a stage of its own links no more than that:
 *
 *     static const qtri_vertex_stage stage = {.positions = &qtri_positions_wide,
 *                                             .vertex_light = &qtri_light_by_vertex};
 *     qtri_draw_mesh_by(&stage, &surface, &view, &pose, &crate, &material);
 *
 * A mesh whose positions the stage does not serve draws nothing, and one whose light it does not
 * serve is not lit by view->light.
 */
typedef struct qtri_position_ops qtri_position_ops;
typedef struct qtri_vertex_light qtri_vertex_light;
typedef struct qtri_face_light qtri_face_light;
typedef struct qtri_uneven_light qtri_uneven_light;

extern const qtri_position_ops qtri_positions_wide, qtri_positions_compact;
extern const qtri_vertex_light qtri_light_by_vertex;
extern const qtri_face_light qtri_light_by_face;
extern const qtri_uneven_light qtri_light_uneven;

typedef struct qtri_vertex_stage {
    const qtri_position_ops *positions;    /* of meshes with mesh.positions */
    const qtri_position_ops *positions16;  /* of meshes with mesh.positions16 */
    const qtri_vertex_light *vertex_light; /* smooth shading of meshes with normals */
    const qtri_face_light *face_light;     /* flat shading, and meshes without normals */
    /* What camera and pose scale unevenly or shear, and light with a negative part or a diffuse one
       above 4. */
    const qtri_uneven_light *uneven_light;
} qtri_vertex_stage;

/* All of the above. */
extern const qtri_vertex_stage qtri_vertex_stage_any;

void qtri_draw_mesh_by(const qtri_vertex_stage *stage, const qtri_surface *surface,
                       const qtri_view *view, const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material);

#ifdef __cplusplus
}
#endif

#endif
