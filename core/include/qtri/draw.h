/* SPDX-License-Identifier: MIT */
/*
 * Draw calls: from object space to pixels. Each composes stages that can be called alone:
 * transform (transform.h), vertex stage, clipping (view.h), rasterizer (below).
 */
#ifndef QTRI_DRAW_H
#define QTRI_DRAW_H

#include <stdbool.h>

#include "material.h"
#include "mesh.h"
#include "pipeline.h"
#include "q16.h"
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
 * Coloured lights are those of light.h.
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

/* The parts of a vertex stage that the library has. */
extern const qtri_position_ops qtri_positions_wide, qtri_positions_compact;
extern const qtri_vertex_light qtri_light_by_vertex;
extern const qtri_face_light qtri_light_by_face;
extern const qtri_uneven_light qtri_light_uneven;

/* What a draw call may do with vertices: NULL leaves the part out. */
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

/* qtri_draw_mesh with the stage given. */
void qtri_draw_mesh_by(const qtri_vertex_stage *stage, const qtri_surface *surface,
                       const qtri_view *view, const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material);

/*
 * Whether something inside could be seen in the view's viewport, posed as `pose` says. False means
 * that nothing can; true may be said of what just misses the frustum.
 *
 *     qtri_box box = qtri_mesh_box(&mesh);
 *     if (qtri_view_sees_box(&view, &pose, &box)) { ... }
 *
 * Draw calls skip a mesh that cannot be seen by themselves when mesh->bounds is set; asking is for
 * groups of meshes, and for what is worth preparing at all.
 */
bool qtri_view_sees_box(const qtri_view *view, const qtri_transform *pose, const qtri_box *box);
bool qtri_view_sees_ball(const qtri_view *view, const qtri_transform *pose, const qtri_ball *ball);

/* The rasterizer alone
 * ---------------------------------------------------------------------------------------------- */

/*
 * For those who bring their own geometry.
 *
 * Fill rule. Vertices lie on a grid of 1/256 pixel. A pixel belongs to a triangle when its centre
 * lies inside, or on a left edge, or on a horizontal top edge (the top-left rule in image
 * coordinates). Consequences: triangles that share an edge cover each pixel along it exactly once,
 * whatever their order and winding; a triangle without area covers nothing; the pixel at a vertex
 * belongs to at most one of the triangles of a fan around it. Edge arithmetic is exact integers.
 *
 * Lines cover, for every column (or row, when steeper than 45 degrees) whose centre lies in the
 * half-open range between the ends, the pixel that the line passes through at that centre.
 * Both directions give the same pixels; chained lines cover each joint once. Colours are within .51
 * of a step of what is exact, those of a wireframe of one colour within 3/4.
 */

#define QTRI_SCREEN_MAX_24P8 ((int32_t)1 << 22) /* guard band: 16384 pixels */

/* A vertex on the screen, as clipping and projection leave it. */
typedef struct qtri_screen_vertex {
    int32_t x_24p8, y_24p8; /* frame coordinates in 1/256 pixel, held to +-QTRI_SCREEN_MAX_24P8 */
    uint32_t depth_16p16;   /* window z times 65535, 0..65535.0; more is taken as 65535.0 */
    uint32_t inv_w_q31;     /* 1/w = inv_w_q31 2^(inv_w_exponent - 31): any common scale serves, */
    int32_t inv_w_exponent; /*   only the ratios of the three count; 0 is taken as 2^-31 */
    int32_t color_8p16[3];  /* red green blue, 0..255.0; values outside are clamped */
    int64_t u_q32, v_q32;   /* texture coordinates: a Q16.16 times 65536, below 2^48. Clipping cuts
                               large triangles at points between the steps of a Q16.16 */
} qtri_screen_vertex;

/*
 * Draws the inside of v[0] v[1] v[2] as material says, by the first of the pipelines that fits, see
 * pipeline.h; flat shading takes its provoking vertex's colour. material->alphas are those of v.
 * material->fill is for draw calls (draw.h): a wireframe is three lines.
 */
void qtri_raster_triangle(const qtri_surface *surface, const qtri_pipeline *const *pipelines,
                          const qtri_material *material, const qtri_screen_vertex v[3]);

/*
 * Draws the line v[0] v[1]; colour and depth are linear on the screen. Texture, shading,
 * interpolation, culling and inv_w do not apply.
 */
void qtri_raster_line(const qtri_surface *surface, const qtri_material *material,
                      const qtri_screen_vertex v[2]);

#ifdef __cplusplus
}
#endif

#endif
