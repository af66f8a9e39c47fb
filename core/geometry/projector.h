/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage: object space to the screen, for one draw call. Internal.
 */
#ifndef QTRI_GEOMETRY_PROJECTOR_H
#define QTRI_GEOMETRY_PROJECTOR_H

#include "qtri/draw.h"
#include "qtri/mesh.h"
#include "qtri/view.h"

#include "../bits/bits.h"
#include "row.h"

/*
 * Rows from object space to pixels, with the viewport folded in, and their common scale: x y in
 * pixels times w, z and w of clip space.
 */
typedef struct qtri_projector {
    union {
        qtri_row wide[4];
        qtri_row16 compact[4]; /* after qtri_projector_compact() */
    } row;
    int32_t shift[4];      /* to the common scale: right and >= 2; of compact rows: left */
    uint32_t depth_center; /* depth_16p16 = depth_center + depth_reach z / w in steps of 2^-8; */
    int32_t depth_reach;   /*   half a step is in the center */
} qtri_projector;

/* Sets the depths of the viewport's near and far plane plus a bias, all clamped to 0..1. */
void qtri_projector_set_depth(qtri_projector *projector, const qtri_viewport *viewport, q16 bias);

/* Sets up wide rows, without a bias. object_to_clip = projection camera pose. */
void qtri_projector_init(qtri_projector *projector, const qtri_transform *object_to_clip,
                         const qtri_viewport *viewport);

/*
 * As qtri_projector_init() for a view and a pose, with a bias. Sets *object_to_eye, camera pose,
 * unless it is NULL.
 */
void qtri_projector_init_view(qtri_projector *projector, const qtri_view *view,
                              const qtri_transform *pose, q16 depth_bias,
                              qtri_transform *object_to_eye);

/*
 * Whether nothing inside the box can be seen in the pixels low..high - 1 of the frame, each within
 * +-16384. May be false for a box that just misses them. Before qtri_projector_compact().
 */
bool qtri_projector_misses(const qtri_projector *projector, const qtri_box *box,
                           const int32_t low[2], const int32_t high[2]);

/* From then on the projector takes 16-bit positions: origin + extent n / 32768. */
void qtri_projector_compact(qtri_projector *projector, const qtri_vec3 *origin, q16 extent);

/* Transforms (p, 1) to homogeneous screen coordinates; b1 and b2 are set to 0. */
void qtri_projector_point(const qtri_projector *projector, const qtri_vec3 *p,
                          qtri_clip_vertex *out);
void qtri_projector_point16(const qtri_projector *projector, const qtri_position16 *p,
                            qtri_clip_vertex *out);

/*
 * Transforms `count` (1..3) points of one triangle or line, with any w. They share one scale, that
 * of the largest |w| among them.
 */
void qtri_projector_points(const qtri_projector *projector, const qtri_vec4 *const p[], int count,
                           qtri_clip_vertex out[]);

/*
 * Divides by w, snaps x and y to 1/256 pixel (correctly rounded, halves up) and fills position,
 * depth and inv_w of *out. For vertices with outcode 0 or from the clipper; w > 0.
 */
void qtri_project(const qtri_projector *projector, const qtri_clip_vertex *v,
                  qtri_screen_vertex *out);

/*
 * The snap residual of a projected vertex: exact x and y less the snapped ones, in 2^-16 of 1/256
 * pixel; 0 for a coordinate that was clamped. `inv_w_q31`: as qtri_project() found it.
 */
void qtri_project_rest(int16_t rest[2], const qtri_clip_vertex *v, const qtri_point *at,
                       uint32_t inv_w_q31);

/* Special values of the low byte of qtri_vertex.depth_16p8, and of an intensity. */
#define QTRI_VERTEX_OUTSIDE 0x80u /* the low six bits are an outcode, not an exponent */
#define QTRI_VERTEX_OUTCODE 0x3Fu
#define QTRI_VERTEX_EMPTY   0x40u /* the whole word: a slot that holds no vertex */
#define QTRI_VERTEX_UNLIT   0xFFFFu

/* Whether all three vertices have an intensity. */
static inline bool qtri_vertices_are_lit(const qtri_vertex *a, const qtri_vertex *b,
                                         const qtri_vertex *c)
{
    const uint32_t unlit = QTRI_VERTEX_UNLIT + 1; /* others: <= 2^15 + 1 */
    return (((a->intensity_q15 + 1u) | (b->intensity_q15 + 1u) | (c->intensity_q15 + 1u)) &
            unlit) == 0;
}

/*
 * Transforms and projects positions: the bits of qtri_projector_point() and qtri_project(), in a
 * tenth of the instructions for those that are plainly inside. Position i becomes vertices[i];
 * `is_listed`: only the positions whose indices are vertices[0..count-1].index, each in its slot.
 * A vertex outside a plane gets QTRI_VERTEX_OUTSIDE and its outcode, and the result is false.
 */
bool qtri_projector_vertices(const qtri_projector *projector, const qtri_vec3 *p, uint32_t count,
                             qtri_vertex *vertices, bool is_listed);
bool qtri_projector_vertices16(const qtri_projector *projector, const qtri_position16 *p,
                               uint32_t count, qtri_vertex *vertices, bool is_listed);

/* Transforms one kind of a mesh's positions: see qtri_vertex_stage. */
struct qtri_position_ops {
    /* Sets the projector up for these positions; NULL: it is. */
    void (*begin)(qtri_projector *projector, const qtri_mesh *mesh);
    /* As qtri_projector_vertices(), for the positions from `first` on. */
    bool (*project)(const qtri_projector *projector, const qtri_mesh *mesh, uint32_t first,
                    uint32_t count, qtri_vertex *vertices, bool is_listed);
    /* One position in homogeneous screen coordinates. */
    void (*transform)(const qtri_projector *projector, const qtri_mesh *mesh, uint32_t index,
                      qtri_clip_vertex *out);
};

/* ---- What both kinds of positions share ---- */

/* floor(a b / 2^32). */
static inline int32_t qtri_mul_high_s32(int32_t a, int32_t b)
{
    return (int32_t)(qtri_mul_s32(a, b) >> 32);
}

/* Sets a vertex, outcode or projection, from 64-bit coordinates; its intensity is not lit yet. */
void qtri_vertex_exact(const qtri_projector *projector, const qtri_clip_vertex *clip,
                       qtri_vertex *out);

#endif
