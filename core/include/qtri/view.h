/*
 * How the world is seen: camera, projection, the rectangle of the frame it lands in, light, and the
 * memory that a draw call may use.
 */
#ifndef QTRI_VIEW_H
#define QTRI_VIEW_H

#include <stdint.h>

#include "transform.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Where clip space -1..1 lands. Pixels of the frame, y of the top edge; any position within
 * +-QTRI_VIEWPORT_MAX. Depth: window z of the near and far plane, 0..1, either order.
 */
#define QTRI_VIEWPORT_MAX 8192

typedef struct qtri_viewport {
    int32_t x, y, width, height;
    q16 depth_near, depth_far;
} qtri_viewport;

/* Direct3D's form: y counts down from the top of the frame. Depth 0..1. */
qtri_viewport qtri_viewport_top(int32_t x, int32_t y, int32_t width, int32_t height);

/* OpenGL's form: y counts up from the bottom of a frame of `frame_height` rows. Depth 0..1. */
qtri_viewport qtri_viewport_bottom(int32_t x, int32_t y, int32_t width, int32_t height,
                                   int32_t frame_height);

/* One directional light: intensity = min(1, ambient + diffuse max(0, n . towards)). */
typedef struct qtri_light {
    qtri_vec3 towards; /* to the light, in eye space, any length; zero: ambient only */
    q16 ambient, diffuse;
} qtri_light;

/*
 * A vertex after the vertex stage. Draw calls keep them in the caller's memory, so that a vertex
 * that many triangles share is transformed and lit once. Fields are internal.
 */
typedef struct qtri_vertex {
    uint32_t tag; /* 1 + index of the mesh vertex in this slot, 0: empty */
    int32_t x_24p8, y_24p8;
    uint32_t depth_16p16;
    uint32_t inv_w_q31;
    int32_t intensity; /* of the light, Q16.16; negative: not lit yet */
    int16_t inv_w_exponent;
    uint8_t outcode;
} qtri_vertex;

/* Vertices to keep for a mesh of `count`: static qtri_vertex memory[QTRI_MESH_VERTICES(500)]; */
#define QTRI_MESH_VERTICES(count) (count)

typedef struct qtri_view {
    qtri_transform camera;     /* world to eye */
    qtri_transform projection; /* eye to clip space */
    qtri_viewport viewport;
    const qtri_light *light; /* NULL: meshes show their plain colours */
    qtri_vertex *vertices;   /* scratch for mesh draws, overwritten by each; NULL with count 0 */
    uint32_t vertex_count;   /* fewer than a mesh's vertices is slower, never wrong */
} qtri_view;

/* Identity camera and projection, the whole frame, no light, no scratch. */
void qtri_view_init(qtri_view *view, int32_t frame_width, int32_t frame_height);

#ifdef __cplusplus
}
#endif

#endif
