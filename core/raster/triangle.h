/* SPDX-License-Identifier: MIT */
/*
 * The rasterizer behind raster.h, in steps: for draw calls that light a triangle only after it is
 * known to touch a pixel. Internal.
 */
#ifndef QTRI_RASTER_TRIANGLE_H
#define QTRI_RASTER_TRIANGLE_H

#include "qtri/raster.h"
#include "qtri/view.h"

#include "job.h"

/* A triangle's place on the screen. */
typedef struct qtri_triangle {
    const qtri_screen_point *p[3]; /* |x|, |y| <= QTRI_SCREEN_MAX_24P8 */
    bool tinted;                   /* colours are shares of the raster's tint */
    int64_t area; /* 2^-15 square pixels; negative is counter-clockwise to the eye */
    /* The rest is qtri_triangle_begin's. */
    const qtri_screen_point *top, *middle, *bottom; /* p by y */
    bool long_is_left;                              /* the edge from top to bottom */
    int32_t x_least, x_greatest;                    /* 1/256 pixel */
    int32_t extent;                                 /* width and height, added */
    int32_t row, end;                               /* rows inside the bounds */
    bool cut;                                       /* spans may reach past the bounds */
    bool is_short;                                  /* `spans` holds all rows */
    qtri_span spans[QTRI_ROWS_AHEAD];
} qtri_triangle;

/* What else a vertex brings. */
typedef struct qtri_attributes {
    uint32_t depth_16p16; /* <= 65535.0 */
    uint32_t inv_w_q31;   /* 2^30..2^31 */
    int32_t inv_w_exponent;
    int32_t color[3]; /* n.16 in units of the target; with a tint, color[0] is Q22 of it, <= 1 */
    int64_t u_q32, v_q32;
    int16_t rest[2]; /* x and y of where it truly is, less where it was snapped to: 2^-24 pixel */
    uint32_t alpha_q16; /* of its vertex, 0..65536; where the route asks for it */
} qtri_attributes;

#if !QTRI_LONG_MULTIPLY
/* Whether differences fit 15 bits with their sign: their products then fit 30, one instruction. */
static inline bool qtri_differences_are_short(int32_t a, int32_t b, int32_t c, int32_t d)
{
    uint32_t half = (uint32_t)1 << 14;
    QTRI_HOLD(half); /* GCC 12 would make it anew for each */
    return (((uint32_t)a + half) | ((uint32_t)b + half) | ((uint32_t)c + half) |
            ((uint32_t)d + half)) < 2 * half;
}

/* qtri_triangle_area where products are long, which is rare: in one place. */
int64_t qtri_triangle_area_far(const qtri_screen_point *a, const qtri_screen_point *b,
                               const qtri_screen_point *c);
#endif

/* Twice the area in 1/256 pixel squared; y points down: negative is front. |x|, |y| <= 2^22. */
static inline int64_t qtri_triangle_area(const qtri_screen_point *a, const qtri_screen_point *b,
                                         const qtri_screen_point *c)
{
    int32_t dx1 = b->x_24p8 - a->x_24p8;
    int32_t dy1 = b->y_24p8 - a->y_24p8;
    int32_t dx2 = c->x_24p8 - a->x_24p8;
    int32_t dy2 = c->y_24p8 - a->y_24p8;
#if !QTRI_LONG_MULTIPLY
    if (QTRI_WITH_FAST_PATHS && qtri_differences_are_short(dx1, dy1, dx2, dy2)) {
        return dx1 * dy2 - dx2 * dy1;
    }
    return qtri_triangle_area_far(a, b, c);
#else
    return qtri_mul_s32(dx1, dy2) - qtri_mul_s32(dx2, dy1);
#endif
}

/* qtri_triangle_area(a, b, c) >= 0, most of a mesh's triangles: without 64 bits where it can be. */
static inline bool qtri_triangle_is_back(const qtri_screen_point *a, const qtri_screen_point *b,
                                         const qtri_screen_point *c)
{
#if !QTRI_LONG_MULTIPLY
    const uint32_t half = (uint32_t)1 << 14;
    int32_t dx1 = b->x_24p8 - a->x_24p8;
    uint32_t far = (uint32_t)dx1 + half;
    QTRI_HOLD(far);
    int32_t dx2 = c->x_24p8 - a->x_24p8;
    far |= (uint32_t)dx2 + half;
    QTRI_HOLD(far);
    int32_t dy1 = b->y_24p8 - a->y_24p8;
    far |= (uint32_t)dy1 + half;
    QTRI_HOLD(far);
    int32_t dy2 = c->y_24p8 - a->y_24p8;
    far |= (uint32_t)dy2 + half;
    if (QTRI_WITH_FAST_PATHS && far < 2 * half) {
        return dx1 * dy2 >= dx2 * dy1;
    }
    return qtri_triangle_area_far(a, b, c) >= 0;
#else
    return qtri_triangle_area(a, b, c) >= 0;
#endif
}

/* Whether triangles of one side are turned away; by a number that is no qtri_cull none are. */
static inline bool qtri_culls(qtri_cull cull)
{
    return cull == QTRI_CULL_BACK || cull == QTRI_CULL_FRONT;
}

/* Whether a triangle of this area is turned away; without area it is, from either side. */
static inline bool qtri_is_culled(qtri_cull cull, int64_t area)
{
    return (cull == QTRI_CULL_BACK && area >= 0) || (cull == QTRI_CULL_FRONT && area <= 0);
}

/* A vertex's depth, distance and light. */
static inline void qtri_vertex_attributes(qtri_attributes *out, const qtri_vertex *vertex,
                                          uint32_t intensity_q15)
{
    out->depth_16p16 = vertex->depth_16p8 & ~0xFFu;
    out->inv_w_q31 = vertex->inv_w;
    out->inv_w_exponent = (int32_t)(vertex->depth_16p8 & 0xFFu);
    out->color[0] = (int32_t)(intensity_q15 << 7); /* Q22 of the one colour */
    out->rest[0] = 0;
    out->rest[1] = 0;
}

/* Takes p and area, which are set, area not 0. False when no pixel is covered. */
bool qtri_triangle_begin(const qtri_raster *raster, qtri_triangle *triangle);

/* Draws it. Flat shading reads the provoking vertex's colour only. */
void qtri_triangle_draw(const qtri_raster *raster, qtri_triangle *triangle,
                        const qtri_attributes v[3]);

/* The same, whatever route the raster has, but samples: for those who are that. */
void qtri_triangle_draw_plain(const qtri_raster *raster, qtri_triangle *triangle,
                              const qtri_attributes v[3]);

/*
 * The second half of that: after qtri_job_init, which returns `fill`. For callers whose attributes
 * are to take no stack while rows are filled.
 */
void qtri_triangle_fill(qtri_job *job, qtri_triangle *triangle, qtri_fill_rows fill);

/* All of it, for a vertex as the public header has it. */
void qtri_raster_draw(const qtri_raster *raster, const qtri_screen_vertex v[3]);

#endif
