/* SPDX-License-Identifier: MIT */
/*
 * Lines of any width, and points of any size: hard or with smooth edges, joints round,
 * depth-tested, in colours that run along them.
 *
 * A stroke is the set of all points within half its width of its line: each pixel is drawn once,
 * whatever parts of it overlap there. Lines one pixel wide without smooth edges are drawn by
 * qtri_draw_lines and &qtri_wireframe, in a fraction of the time.
 *
 * Hard edges: a pixel is drawn when its centre lies inside; the left and the upper side count as
 * inside, the right and the lower one not. With `edges` = &qtri_stroke_smooth a pixel takes the
 * share of the colour that the stroke covers of its area, within 1/32, in any format.
 *
 * Colour and depth are linear on the screen along each part; where parts overlap, those of the one
 * are taken whose line is nearest to the pixel's centre. Depth is compared at each pixel's centre,
 * and written where half of a pixel or more is covered. Bands and scissors do not change pixels.
 *
 * A call takes 4.3 KB of stack, a wide wireframe 6.5, with a view's lights 7.5. Instructions: the
 * rows K1, K5, KP and KW of `make bench`.
 *
 * Of a material count depth_compare, depth_read_only, depth_bias, fog and what a blend asks for;
 * for meshes also what tells their colour. A pixel in fog and blended is mixed with what is stored
 * by what is covered of it, times the stroke's alpha: within a step of what is exact of that. A
 * blend that turns pixels away leaves their depths. Where parts of other strokes overlap it blends
 * again.
 */
#ifndef QTRI_STROKE_H
#define QTRI_STROKE_H

#include "draw.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_STROKE_WIDTH_MAX 512 /* pixels */

/* How a line begins and ends; joints are round. A point is round, or square for the other two. */
typedef enum qtri_cap {
    QTRI_CAP_ROUND,  /* a half circle around the end */
    QTRI_CAP_BUTT,   /* flat, at the end */
    QTRI_CAP_SQUARE, /* flat, half a width beyond it */
} qtri_cap;

/* Edges that are not hard. */
typedef struct qtri_stroke_edges qtri_stroke_edges;
extern const qtri_stroke_edges qtri_stroke_smooth;

/* How lines and points are drawn. */
typedef struct qtri_stroke {
    q16 width; /* pixels, the diameter of a point; rounded to 1/128. Below 1/256: nothing is drawn;
                  more than QTRI_STROKE_WIDTH_MAX is taken as that */
    qtri_cap cap;                   /* anything else is QTRI_CAP_ROUND */
    const qtri_stroke_edges *edges; /* NULL: hard; &qtri_stroke_smooth */
    uint8_t alpha;                  /* 255: opaque, 0: nothing is drawn */
    bool closed;                    /* a polyline: the last point is joined to the first */
    bool in_space;                  /* points: width is in units of object space, seen in
                                       perspective: splats */
} qtri_stroke;

/* One pixel wide, smooth, round, opaque, open. It names &qtri_stroke_smooth. */
qtri_stroke qtri_stroke_default(void);

/*
 * The line v[0] v[1] .. v[count-1] on the screen. One point, or points that are all the same: what
 * the caps are around it, nothing for BUTT. None: nothing.
 */
void qtri_raster_polyline(const qtri_surface *surface, const qtri_material *material,
                          const qtri_stroke *stroke, const qtri_screen_vertex *v, uint32_t count);

/* One point on the screen: a circle or a square around v. */
void qtri_raster_point(const qtri_surface *surface, const qtri_material *material,
                       const qtri_stroke *stroke, const qtri_screen_vertex *v);

/*
 * The same with corners in object space, transformed by view->projection view->camera pose and
 * clipped. view->vertices keeps transformed points while a polyline is drawn: fewer than
 * corner_count is slower, never wrong. Each part is compared with those near it: for polylines of
 * up to some hundred.
 */
void qtri_draw_polyline(const qtri_surface *surface, const qtri_view *view,
                        const qtri_transform *pose, const qtri_corner *corners,
                        uint32_t corner_count, const qtri_stroke *stroke,
                        const qtri_material *material);

/* corner_count / 2 lines, each by itself. */
void qtri_draw_wide_lines(const qtri_surface *surface, const qtri_view *view,
                          const qtri_transform *pose, const qtri_corner *corners,
                          uint32_t corner_count, const qtri_stroke *stroke,
                          const qtri_material *material);

/*
 * Points, each by itself and in their order. One is drawn when its centre lies inside the frustum's
 * near and far plane and within the guard band of 16384 pixels.
 */
void qtri_draw_points(const qtri_surface *surface, const qtri_view *view,
                      const qtri_transform *pose, const qtri_corner *corners, uint32_t corner_count,
                      const qtri_stroke *stroke, const qtri_material *material);

/*
 * material.fill = &qtri_smooth_wireframe: the edges of triangles as smooth lines one pixel wide,
 * wherever &qtri_wireframe serves, at five to seven times its instructions (KS of `make bench`). An
 * edge is the rectangle of all points within half a pixel of it, flat at its ends, as smooth lines
 * of OpenGL are. Coverage is exact to 1/64; colour, depth and blending are those of strokes. An
 * edge that neighbours share is drawn once where view->vertices has room for the mesh: all but one
 * in a thousand, of vertices with three and more edges whose second triangle is yet to come.
 */
extern const qtri_fill qtri_smooth_wireframe;

/*
 * The edges of a mesh's triangles, culled as the material says, lit and coloured as those of
 * &qtri_wireframe; material->fill does not count. Each edge is a line by itself, drawn once where
 * neighbours share it and view->vertices has room for the mesh. Smooth edges of up to two pixels
 * with flat ends, QTRI_CAP_BUTT or SQUARE, take a third of the time of all others.
 */
void qtri_draw_wide_wireframe(const qtri_surface *surface, const qtri_view *view,
                              const qtri_transform *pose, const qtri_mesh *mesh,
                              const qtri_stroke *stroke, const qtri_material *material);

/*
 * A wireframe without hidden lines: first the mesh's triangles into depth alone (&qtri_depth_only),
 * then its edges over them. The edges' depth is drawn nearer by `bias` of the range 0..1, held to
 * that: somewhat more than depth changes by within half a line's width on the steepest faces, or
 * those hide their own edges; with much more, edges shine through that lie little behind a face.
 * Q16(.002) serves for lines of a pixel and a near plane at a tenth of the distance. stroke NULL:
 * lines of one pixel with hard edges, those of &qtri_wireframe. Depth compares with
 * material->depth_compare, and where that is QTRI_DEPTH_OFF nothing is hidden.
 */
void qtri_draw_hidden_lines(const qtri_surface *surface, const qtri_view *view,
                            const qtri_transform *pose, const qtri_mesh *mesh,
                            const qtri_stroke *stroke, const qtri_material *material, q16 bias);

#ifdef __cplusplus
}
#endif

#endif
