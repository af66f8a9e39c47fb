/* SPDX-License-Identifier: MIT */
/*
 * Clipping in homogeneous coordinates (Blinn and Newell 1978; Sutherland and Hodgman 1974).
 *
 * Polygons are cut at the near and far plane and at a guard band in x and y, 16384 pixels either
 * side of the frame's origin; the scissor does the rest. The guard band is there for arithmetic,
 * not for looks: inside it every screen coordinate fits 23 bits, outside it is so rare that its
 * cost does not matter.
 */
#ifndef QTRI_CLIP_H
#define QTRI_CLIP_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

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
