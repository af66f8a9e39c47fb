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

#ifdef __cplusplus
}
#endif

#endif
