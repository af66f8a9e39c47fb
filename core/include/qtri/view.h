/* SPDX-License-Identifier: MIT */
/*
 * How the world is seen: camera, projection, the rectangle of the frame it lands in, light, and the
 * memory that a draw call may use.
 */
#ifndef QTRI_VIEW_H
#define QTRI_VIEW_H

#include <stdint.h>

#include "surface.h"
#include "transform.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The largest position and size of a viewport, pixels. */
#define QTRI_VIEWPORT_MAX 8192

/*
 * Where clip space -1..1 lands. Pixels of the frame, y of the top edge; any position within
 * +-QTRI_VIEWPORT_MAX. Depth: window z of the near and far plane, 0..1, either order.
 */
typedef struct qtri_viewport {
    int32_t x, y, width, height;
    q16 depth_near, depth_far;
} qtri_viewport;

/* Direct3D's form: y counts down from the top of the frame. Depth 0..1. */
qtri_viewport qtri_viewport_top(int32_t x, int32_t y, int32_t width, int32_t height);

/* OpenGL's form: y counts up from the bottom of a frame of `frame_height` rows. Depth 0..1. */
qtri_viewport qtri_viewport_bottom(int32_t x, int32_t y, int32_t width, int32_t height,
                                   int32_t frame_height);

/* Several coloured lights: see light.h. */
typedef struct qtri_light_source qtri_light_source;
typedef struct qtri_light_model qtri_light_model; /* what draw calls do with them. Internal. */

/* 0..16 a channel, 1: all that a surface reflects is shown as it is. Held to that range. */
typedef struct qtri_light_color {
    q16 r, g, b;
} qtri_light_color;

/*
 * The light of a view. One white directional light is written down, the rest left out (zero):
 * intensity = min(1, ambient + diffuse max(0, n . towards)). Several coloured sources are set by
 * qtri_light_init.
 */
typedef struct qtri_light {
    qtri_vec3 towards; /* to the light, in eye space, any length; zero: ambient only */
    q16 ambient, diffuse;

    const qtri_light_model *model; /* NULL: the white light above; else: */
    const qtri_light_source *sources;
    uint32_t count;
    qtri_light_color color; /* ambient */
} qtri_light;

/* What draws the pixels: see pipeline.h. */
typedef struct qtri_pipeline qtri_pipeline;

/*
 * A vertex after the vertex stage. Draw calls keep them in the caller's memory, so that a vertex
 * that many triangles share is transformed and lit once. Fields are internal.
 */
typedef struct qtri_vertex {
    qtri_point at;
    uint32_t depth_16p8;    /* times 256, and in the low byte the planes the vertex is outside of */
    uint32_t inv_w;         /* mantissa of 1/w; of wireframes: edges, see mesh_lines.c */
    uint16_t index;         /* of the mesh's vertex in this slot; of wireframes: notes */
    uint16_t intensity_q15; /* of the light, 0..2^15; more: not lit yet */
} qtri_vertex;

/* What a camera sees, in which light, and where on the frame it lands. */
typedef struct qtri_view {
    qtri_transform camera;     /* world to eye */
    qtri_transform projection; /* eye to clip space */
    qtri_viewport viewport;
    const qtri_light *light; /* NULL: meshes show their plain colours */
    qtri_vertex *vertices;   /* scratch for mesh draws, overwritten by each; NULL with count 0 */
    uint32_t vertex_count;   /* fewer than a mesh's vertices is slower, never wrong */
    const qtri_pipeline *const *pipelines; /* what draws triangles: see pipeline.h */
} qtri_view;

/* Identity camera and projection, the whole frame, no lights, no scratch; qtri_pipelines_default.
 */
void qtri_view_init(qtri_view *view, int32_t frame_width, int32_t frame_height);

/* With a list of pipelines, which NULL ends: what neither it nor a format names is not linked. */
void qtri_view_init_pipelines(qtri_view *view, int32_t frame_width, int32_t frame_height,
                              const qtri_pipeline *const *pipelines);

/*
 * Camera and projection set anew: from `eye` to `center`, and with a vertical field of view of
 * `fovy` degrees in the aspect of the viewport, which is set before. As qtri_transform_look_at and
 * qtri_transform_perspective; a viewport without height has aspect 1.
 */
void qtri_view_look_at(qtri_view *view, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up);
void qtri_view_perspective(qtri_view *view, q16 fovy, q16 near_z, q16 far_z);

/* ---- Clipping ---- */

/*
 * Clipping in homogeneous coordinates (Blinn and Newell 1978; Sutherland and Hodgman 1974), at the
 * near and far plane and at a guard band in x and y, 16384 pixels either side of the frame's
 * origin; the scissor does the rest. Inside of the guard band every screen coordinate fits 23 bits.
 */

#define QTRI_GUARD_LOG2 14 /* guard band at 2^14 pixels */

/*
 * Homogeneous: x / w and y / w are frame coordinates in pixels, z / w is -1 at the near and 1 at
 * the far plane. All four share one scale; |x|, |y|, |z|, |w| < 2^61.
 */
typedef struct qtri_clip_vertex {
    int64_t x, y, z, w;
    int32_t b1_q30, b2_q30; /* barycentric weights of the original triangle's vertices 1 and 2 */
} qtri_clip_vertex;

enum {
    QTRI_OUT_NEAR = 1,   /* z < -w */
    QTRI_OUT_FAR = 2,    /* z > w */
    QTRI_OUT_LEFT = 4,   /* x < -2^14 w */
    QTRI_OUT_RIGHT = 8,  /* x > 2^14 w */
    QTRI_OUT_TOP = 16,   /* y < -2^14 w */
    QTRI_OUT_BOTTOM = 32 /* y > 2^14 w */
};

#define QTRI_CLIP_MAX 9 /* a triangle cut by six planes */

/* Which planes the point lies outside of: 0 for a point that can be projected as it is. */
unsigned qtri_clip_outcode(const qtri_clip_vertex *v);

/*
 * Cuts the convex polygon in v[0 .. count-1] (count <= 3) by the planes in `planes`, the union of
 * the vertices' outcodes. v must hold QTRI_CLIP_MAX vertices. Returns the new count: 0, or 3 and
 * more. An edge that two triangles share is cut at the same point in both, whichever way round
 * it is given. Vertices left with w <= 0 (the apex of the view cone) are dropped.
 */
int qtri_clip_polygon(qtri_clip_vertex v[QTRI_CLIP_MAX], int count, unsigned planes);

/* The same for a line from v[0] to v[1]: 1 when some of it is left, else 0. */
int qtri_clip_line(qtri_clip_vertex v[2], unsigned planes);

#ifdef __cplusplus
}
#endif

#endif
