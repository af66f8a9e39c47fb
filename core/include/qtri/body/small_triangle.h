/* SPDX-License-Identifier: MIT */
/*
 * Structs and functions of the small-triangle path: input, set-up, curves. Internal, part of the
 * pipelines' body (pipeline_make.h).
 *
 * Small is a triangle less than 120 pixels high, whose vertices 1 and 2 are within 120 pixels of
 * vertex 0 in x, with 1/w from 3/4 to 3/2 of that of vertex 0 and depths within 2^10 steps of
 * linear16, and that is no needle. That is asked of the vertices alone, and whether what varies
 * bends little enough of vertices and material; never of a scissor, a band or a pipeline. All that
 * follows fits 32 bits.
 *
 * Rows are found exactly, by the top-left rule, as spans of bytes. What varies is linear on the
 * screen, set by products with 1/area; texture coordinates, light and colours are polynomials of
 * second order where perspective could be seen, see small_curves.h; what bends too much for that is
 * divided at points along rows, see small_division.c.
 */
#ifndef QTRI_BODY_SMALL_TRIANGLE_H
#define QTRI_BODY_SMALL_TRIANGLE_H

#include "../mesh.h"
#include "../view.h"
#include "state.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    QTRI_SMALL_REACH = 120,
    QTRI_SMALL_MIDDLE = 60, /* reach of samples, packed colours that are linear, light by pixel */
    QTRI_SMALL_SPANS = 2 * (QTRI_SMALL_REACH + 1),
    QTRI_SMALL_STOP = 255, /* begins the row after the last */
    QTRI_SMALL_FINE = 3    /* bits that curves of light and colours have more than ramps */
};

/* A triangle of a draw call, inside all planes; front faces are culled by the caller. */
typedef struct qtri_small {
    qtri_draw_state *state;
    const qtri_mesh *mesh;
    qtri_vertex *v[3];
    uint32_t index[3];   /* of the vertices in the mesh */
    const void *indices; /* the triangle's in the mesh, for `light` */
    uint32_t light_q15;  /* of the triangle; more than 2^15: that of its vertices */
    /* Called once the triangle touches a pixel: gives the vertices their light, or returns that of
       the triangle. NULL: all have theirs. */
    uint32_t (*light)(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                      qtri_vertex *c);
    const void *from;
} qtri_small;

/* What is linear on the screen: at the base column of the first row, and its steps. */
typedef struct qtri_small_ramp {
    uint32_t at, dx, dy;
} qtri_small_ramp;

/* Triangle set-up. The base: vertex 0's column, first row; spans count from REACH left of it. */
typedef struct qtri_small_place {
    bool turned; /* a back face: vertices 1 and 2 have changed places */
    bool cut;    /* rows may reach past the bounds */
    bool wide;   /* more than 32 pixels: differences of attributes are below 2^15, not 2^16 */
    int32_t dx1, dy1, dx2, dy2; /* vertices 1 and 2 from vertex 0, 24.8 */
    int32_t x, y;               /* from vertex 0 to the centre of the base in the first row, 24.8 */
    int32_t first;              /* the first row less vertex 0's */
    int32_t column, row;        /* of the base, in the frame */
    int32_t inverse, down, up;  /* 1 / area: see qtri_small_ramp_set() */
    int32_t q1, q2;             /* 1/w at vertices 1 and 2 less that at vertex 0, in its scale */
    uint32_t q_abs;             /* their magnitudes, or-ed */
    uint8_t *span;              /* of each row the first pixel and the one after the last */
    int32_t left, right;        /* of the bounds, as spans count */
    qtri_small_ramp z;          /* 16.16 */
} qtri_small_place;

/* What follows perspective: at + dx x + xx x^2 in a row, x columns from vertex 0's; in the next row
   `at` is dy more, dx xy and dy yy. Light and colours have QTRI_SMALL_FINE bits more than ramps,
   as 120 pixels away xx that is rounded is off by 7200 of its units. */
typedef struct qtri_small_curve {
    uint32_t at, dx, dy, xx, xy, yy;
} qtri_small_curve;

/* A curve x columns from vertex 0's, and its step over the n pixels from there on. */
QTRI_BODY uint32_t qtri_small_curve_at(const qtri_small_curve *c, uint32_t x)
{
    return c->at + x * (c->dx + x * c->xx);
}

QTRI_BODY uint32_t qtri_small_curve_step(const qtri_small_curve *c, uint32_t x, uint32_t n)
{
    return c->dx + (2 * x + n) * c->xx;
}

/* Along a chord of a curve: a value, and a pixel's step. */
typedef struct qtri_small_chord {
    uint32_t at, step;
} qtri_small_chord;

/* The chord over n pixels, a power of two, from a multiple of n on, that has column x from vertex
   0's: in units of 2^down of a ramp's, for packing. Where a chord begins the value may be out of
   range, so of `at`, which is 0 or more, the lowest 29 - down bits are right. */
QTRI_BODY qtri_small_chord qtri_small_chord_of(const qtri_small_curve *c, uint32_t x, uint32_t n,
                                               uint32_t down)
{
    const uint32_t passed = x & (n - 1), first = x - passed, bits = down + QTRI_SMALL_FINE;
    const uint32_t half = (uint32_t)1 << down >> 1 << QTRI_SMALL_FINE;
    qtri_small_chord chord;
    chord.step = (uint32_t)((int32_t)(qtri_small_curve_step(c, first, n) + half) >> bits);
    chord.at = (qtri_small_curve_at(c, first) >> bits) + passed * chord.step;
    return chord;
}

/* The chord in a ramp's units, all bits of `at` right. */
QTRI_BODY qtri_small_chord qtri_small_whole_chord_of(const qtri_small_curve *c, uint32_t x,
                                                     uint32_t n)
{
    qtri_small_chord chord = qtri_small_chord_of(c, x, n, 0);
    chord.at &= UINT32_MAX >> QTRI_SMALL_FINE;
    return chord;
}

QTRI_BODY void qtri_small_curve_next_row(qtri_small_curve *c)
{
    c->at += c->dy;
    c->dy += c->yy;
    c->dx += c->xy;
}

/* A value that bends more than a curve: exact at points a power of two columns apart, by a
   division, and parabolas between them. See small_division.c. */
typedef struct qtri_small_divided {
    uint8_t at_left, at_right, step_left, step_right, bend_left, bend_right; /* shifts */
    int8_t up;               /* of s to units of the value */
    qtri_small_curve *curve; /* up to the next point */
    qtri_small_ramp s;       /* what it has more than at vertex 0, times 1 + q */
    uint32_t value;          /* at vertex 0 */
    int32_t point;           /* what it has more at the last point */
    uint32_t bend;           /* of light and colours: the most along a chord of a pixel; else 0 */
} qtri_small_divided;

/* Division of a triangle's values. What each row reads is a word: one load on Armv6-M. */
typedef struct qtri_small_division {
    uint32_t log2;        /* of columns from point to point; 0: nothing is divided */
    uint32_t goes_on;     /* not 0: along the row, from the last point on */
    const uint8_t *spans; /* of the first row */
    int32_t left;         /* column of a point, from vertex 0's, no more than any pixel's */
    int32_t reciprocal;   /* 1 / (1 + q) at the last point, Q16 */
    qtri_small_ramp q;    /* 1/w by that of vertex 0, less 1: Q24 */
    uint32_t *piece;      /* pixels of a chord of light and colours, set with each stretch */
    int32_t count;        /* of values */
    qtri_small_divided a[3];
} qtri_small_division;

/* Texture coordinates, and light where it follows perspective. Not curved: coordinates only, and
   linear. */
typedef struct qtri_small_curves {
    qtri_small_curve u, v, c;
    qtri_small_ramp linear[2];
    bool is_curved;
    uint32_t light_piece; /* pixels over which light is near a chord, a power of two; 0: linear */
} qtri_small_curves;

/* Colours that follow perspective. */
typedef struct qtri_small_color_curves {
    qtri_small_curve channel[3]; /* red, green, blue; of gray, luma in the place of green */
    uint32_t piece;              /* as light_piece */
} qtri_small_color_curves;

typedef enum qtri_small_found {
    QTRI_SMALL_NOTHING,
    QTRI_SMALL_IS_LARGE,
    QTRI_SMALL_FOUND
} qtri_small_found;

/* In small_triangle.c: sets p and spans. Back faces that are drawn become front faces. */
qtri_small_found qtri_small_find(qtri_small_place *p, uint8_t spans[QTRI_SMALL_SPANS],
                                 qtri_small *t);

/* Cuts rows to the bounds. False when nothing is left. */
bool qtri_small_cut(uint8_t *span, int32_t left, int32_t right);

/* Turns a back face round. False: it is culled, or has no area. */
bool qtri_small_turn(qtri_small *t, int32_t size);

/* p->q1 and q2, where exponents differ or 1/w changes much. False: too much. */
bool qtri_small_find_uneven(int32_t q[2], const qtri_small *t);

/* state->color, or the mesh's of the provoking vertex, in the triangle's light. */
uint32_t qtri_small_color(const qtri_small *t);

/* In small_values.c: values linear on the screen. False: the lack of perspective would show. */
bool qtri_small_light_is_linear(const qtri_small_place *p, const qtri_small *t,
                                const qtri_options *o);
bool qtri_small_is_linear_by_range(uint32_t range, uint32_t q_range, uint32_t q_part);
void qtri_small_set_light(qtri_small_ramp *c, const qtri_small_place *p, const qtri_small *t,
                          uint32_t half);
bool qtri_small_set_alpha(qtri_small_ramp *alpha, const qtri_small_place *p, const qtri_small *t);
bool qtri_small_are_linear(const int32_t differences[6], uint32_t inv_w, int32_t q1, int32_t q2,
                           uint32_t part);
bool qtri_small_set_colors_565(qtri_small_ramp *c, const qtri_small_place *p, const qtri_small *t);
bool qtri_small_set_colors_888(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                               const qtri_small *t);
bool qtri_small_set_colors_gray(qtri_small_ramp *c, const qtri_small_place *p, const qtri_small *t);
bool qtri_small_set_weights(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                            const qtri_small *t, uint32_t half);

/* In draw_state.c: the level of a mipmapped texture by the footprint at vertex 0. False: 1/w
   varies too much for one; the triangle is large. */
bool qtri_small_set_level(const qtri_small_place *p, const qtri_small *t);

/* In small_texture.c: texture coordinates. False: they are not linear; nothing was set. */
bool qtri_small_set_linear_texture(qtri_small_ramp *u, qtri_small_ramp *v,
                                   const qtri_small_place *p, const qtri_small *t,
                                   const qtri_options *o);
/* Sets curves, or curves->linear. False: they bend too much; the triangle is large. Curved: light
   or colours are. Division: NULL with samples, which have no rows that begin anew. */
bool qtri_small_set_curves(qtri_small_curves *curves, qtri_small_division *division,
                           const qtri_small_place *p, const qtri_small *t, const qtri_options *o,
                           bool curved);

/* In small_division.c: curves, and of light and colours the pixels of a chord, from column x of a
   span's row on, as spans count; returns up to which: `end`, or a point, where the span begins
   then, and goes on. */
uint32_t qtri_small_divide(qtri_small_division *d, uint32_t x, uint32_t end, uint8_t *span);

/* In small_values.c: light without texture, and colours. False as above. */
bool qtri_small_set_light_curve(qtri_small_curves *curves, const qtri_small_place *p,
                                const qtri_small *t, const qtri_options *o);
bool qtri_small_set_color_curves(qtri_small_color_curves *k, qtri_small_division *division,
                                 const qtri_small_place *p, const qtri_small *t);
/* Packed colours along the chord that has the pixel x columns from vertex 0's, from there on. */
void qtri_small_set_color_chord(qtri_small_chord *c, qtri_small_chord *g,
                                const qtri_small_color_curves *k, const qtri_options *o,
                                uint32_t x);
void qtri_small_color_curves_next_row(qtri_small_color_curves *k);

#ifdef __cplusplus
}
#endif

#endif
