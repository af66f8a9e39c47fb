/* SPDX-License-Identifier: MIT */
/*
 * Attributes of fragments anywhere in a small triangle. Internal.
 *
 * A fragment's place is row << 16 | column; ramps begin at place 0, all modulo 2^32.
 *
 * With perspective an attribute is u_0 + l / (1 + e), where e, what 1/w has more than at vertex 0
 * by its value there, and l are linear on the screen: l_i = (u_i - u_0) (1 + e_i) at vertex i.
 * Since |e| <= 1/12.8, l (1 - w) with w = e - e^2 + e^3 - e^4 is off by less than 1.1 l e^5, and of
 * the 51 pixels that anything may be away from vertex 0 by 1/6000 of one.
 */
#ifndef QTRI_RASTER_LIST_VALUES_H
#define QTRI_RASTER_LIST_VALUES_H

#include "../geometry/projector.h"
#include "list.h"
#include "place_ramp.h"

/* What the words of waiting fragments are. */
enum {
    QTRI_LIST_COLORS,      /* final colours */
    QTRI_LIST_TINT_SHARES, /* light, which the tint is multiplied by */
    QTRI_LIST_TEXELS,      /* texels that are not multiplied */
    QTRI_LIST_LIT_TEXELS,  /* shades are light */
    QTRI_LIST_RGB_TEXELS   /* shades are red green blue */
};

/* A texture coordinate. */
typedef struct qtri_list_axis {
    uint32_t at; /* at vertex 0, in the unit of its stage */
    qtri_ramp l; /* in 2^-up of it */
    int32_t up;
} qtri_list_axis;

/* A triangle on its way to the values of its fragments. */
struct qtri_list_values {
    const qtri_raster *raster;
    const qtri_list_triangle *t;
    qtri_inverse inverse;
    uint8_t second, third; /* vertices in the order of the place */
    bool has_e;            /* e is set */
    bool gentle;           /* uv are in their units, and |e| is small: see list_texel.c */
    bool blocks;           /* uv may be followed along rows, see qtri_list_piece */
    bool curved;           /* colours are base + l (1 - w), not linear */
    bool even;             /* such colours may be followed along rows */
    uint8_t channels;      /* that vary: 0, 1 or 3 */
    uint8_t half;          /* of a piece, 4..8 pixels */
    uint8_t cubic_q16;     /* 3/4 of the square of e_x times that: 48 at most */
    uint32_t left;         /* where they begin */
    int32_t e1_q18, e2_q18;
    qtri_ramp e_q26;
    uint32_t constant; /* without channels: the word */
    qtri_ramp channel[3];
    uint32_t base[3];
    qtri_list_axis uv[2];
    qtri_texel_axis axis[2]; /* where coordinates do not fill 32 bits, or are filtered */
};

/* What texels are multiplied by has 10 bits: of light that is 2^22, and of channels n.16. */
#define QTRI_LIGHT_SHIFT   12
#define QTRI_CHANNEL_SHIFT 14

/* Of a triangle, without any value yet. */
static inline void qtri_list_begin(qtri_list_values *v, const qtri_raster *raster,
                                   const qtri_list_triangle *t)
{
    v->raster = raster;
    v->t = t;
    v->second = t->place->back ? 2 : 1;
    v->third = t->place->back ? 1 : 2;
    v->has_e = false;
    qtri_inverse_init(&v->inverse, t->place->size);
}

/* Its depths, where the raster tests them. */
static inline void qtri_list_set_depth(qtri_ramp *depth, const qtri_list_values *v)
{
    if (v->raster->with_depth) {
        (void)qtri_place_depth(depth, v->t->place, &v->inverse, v->t->v[0], v->t->v[v->second],
                               v->t->v[v->third], false);
    }
}

/*
 * What qtri_list_draw does, in steps, for fragments of samples: all values of a triangle, for which
 * the batch may be drawn; then the words of `count` fragments whose places are in it after those
 * that it has, which returns the mask of those that are drawn.
 */
void qtri_list_set(qtri_list_values *v);
uint32_t qtri_list_append(const qtri_list_values *v, int32_t count);

/* The one colour of a triangle without texture; of one with and with colours of its own, as a
   shade. */
uint32_t qtri_list_flat_color(const qtri_raster *raster, const qtri_list_triangle *t);
uint32_t qtri_list_flat_shade(const qtri_raster *raster, const qtri_list_triangle *t);

/* Whether the vertices differ in colour or, where they have none, in light. */
bool qtri_list_is_one_color(const qtri_list_triangle *t);

static inline bool qtri_list_varies(const qtri_list_triangle *t)
{
    return t->color != NULL ? !qtri_list_is_one_color(t) : t->light_q15 == QTRI_VERTEX_UNLIT;
}

/* Finds e, unless it has been found. */
void qtri_list_find_e(qtri_list_values *v);

/* |f| <= 2^16, |e| < 2^14.4: below 2^31. */
static inline int32_t qtri_list_scaled(int32_t f, int32_t e_q18)
{
    return f + ((f * e_q18 + ((int32_t)1 << 17)) >> 18);
}

static inline uint32_t qtri_list_at(const qtri_ramp *ramp, uint32_t x, uint32_t y)
{
    uint32_t at = ramp->origin + x * ramp->dx;
    QTRI_TOGETHER(at)
    return at + y * ramp->dy;
}

/* w, 16 bits of fraction. */
static inline int32_t qtri_list_w(const qtri_ramp *e_q26, uint32_t x, uint32_t y)
{
    const int32_t one = (int32_t)1 << 16;
    const int32_t e = (int32_t)qtri_list_at(e_q26, x, y) >> 10; /* |e| < 2^13 */
    const int32_t second = (e * (one - e)) >> 16;
    return (e * (one - ((e * (one - second)) >> 16))) >> 16;
}

/* l (1 - w), |l| < 2^24 + 2^21. */
static inline int32_t qtri_list_divided(int32_t l, int32_t w)
{
    return l - (((l >> 6) * w) >> 10);
}

/*
 * Along rows. From a pixel in the middle, with s = l / (1 + e), y = 1 / (1 + e) and E = e_x y, an
 * attribute is d pixels farther right
 *
 *     s + b d / (1 + E d) = s + b (d - E d^2 + E^2 d^3 - ...), b = (l_x - s e_x) y
 *
 * For |d| <= h the cubic term is 3/4 E^2 h^2 d within E^2 h^3 / 4: h = 8 and |e_x| < 1/256 make
 * that 1/500 of a pixel. The sixteen are counted from the leftmost vertex of the triangle, so that
 * a pixel's value does not depend on which of them are drawn. The middle may be outside of the
 * triangle, so |l_x| has a limit too: l, below 2^23.12 in the triangle, is then below 2^23.97, and
 * |e| < 1/12.8 + 1/32, so that the products of qtri_list_divided are below 2^31.
 */
typedef struct qtri_list_piece {
    uint32_t at; /* at the first of them */
    uint32_t step, bend;
} qtri_list_piece;

enum { QTRI_PIECE = 16, QTRI_PIECE_L = 7 << 17, QTRI_PIECE_E_Q26 = 1 << 18 };

/* Whether l has that limit; |l| is below 2^23.12 anyway. */
static inline bool qtri_list_is_even(const qtri_ramp *l)
{
    return l->dx + QTRI_PIECE_L < 2 * (uint32_t)QTRI_PIECE_L;
}

/*
 * Whether rows are followed: where e has its limit, and they have three pixels in the mean. Then
 * the longest has six, so that no attribute changes by more than a sixth of its range in one.
 */
bool qtri_list_follow(qtri_list_values *v);

/* Where the piece begins that has this place; after the last place there is one far from it. */
static inline uint32_t qtri_list_piece_first(const qtri_list_values *v, uint32_t place)
{
    return place - (((place & 0xFFFF) - v->left) & (QTRI_PIECE - 1));
}

/*
 * Of the pixels around (x, y), where it is w, from v->half to the left of it on: the attribute is
 * base + s 2^up.
 */
static inline void qtri_list_piece_set(qtri_list_piece *piece, const qtri_list_values *v,
                                       const qtri_ramp *l, uint32_t x, uint32_t y, int32_t w,
                                       uint32_t base, int32_t up)
{
    const int32_t h = v->half;
    const int32_t inverse = ((int32_t)1 << 16) - w; /* < 2^16.17 */
    const int32_t e_q23 = (int32_t)v->e_q26.dx >> 3;
    const int32_t s = qtri_list_divided((int32_t)qtri_list_at(l, x, y), w);          /* < 2^24.2 */
    const int32_t slope = (int32_t)l->dx - (((s >> 10) * e_q23) >> 13);              /* < 2^20 */
    const int32_t b = (((slope + 16) >> 5) * ((inverse + v->cubic_q16) >> 1)) >> 10; /* < 2^20.2 */
    const int32_t bend = ((b >> 6) * ((e_q23 * (inverse >> 2)) >> 14)) >> 17;        /* < 2^12.4 */
    piece->at = base + ((uint32_t)(s - h * (b + h * bend)) << up);
    piece->step = (uint32_t)(b + 2 * h * bend) << up;
    piece->bend = (0u - (uint32_t)bend) << up;
}

/* Of what is linear on the screen, from x on. */
static inline void qtri_list_piece_linear(qtri_list_piece *piece, const qtri_ramp *ramp, uint32_t x,
                                          uint32_t y)
{
    piece->at = qtri_list_at(ramp, x, y);
    piece->step = ramp->dx;
    piece->bend = 0;
}

static inline uint32_t qtri_list_piece_at(const qtri_list_piece *piece, uint32_t d)
{
    return piece->at + d * (piece->step + d * piece->bend);
}

/*
 * Whether a colour that differs from vertex 0's by d1 and d2, n.9, is linear on the screen: it
 * strays by range (q_greatest - q_least) / (4 q_least), q being 1/w, see nearly_linear() in
 * setup.c, which is to be below 2^-part of 2^16: 3 is 1/8 of a step.
 */
static inline bool qtri_list_is_linear(uint32_t q0, int32_t q1, int32_t q2, int32_t d1, int32_t d2,
                                       uint32_t part)
{
    const int32_t q_least = qtri_least_from_0(q1, q2);
    const uint32_t q_range = (uint32_t)(qtri_greatest_from_0(q1, q2) - q_least); /* < 2^29 */
    const uint32_t range = (uint32_t)(qtri_greatest_from_0(d1, d2) - qtri_least_from_0(d1, d2));
    return range * ((q_range >> 15) + 1) <= (q0 + (uint32_t)q_least) >> (4 + part);
}

/* Enough for it, and true of most: q_least >= 2^30, and no range is more than two differences. */
static inline bool qtri_list_is_plain(const qtri_vertex *a, const qtri_vertex *b,
                                      const qtri_vertex *c, int32_t d1, int32_t d2, uint32_t part)
{
    const uint32_t range = qtri_about(d1) + qtri_about(d2) + 2;
    const uint32_t q_range =
        qtri_about((int32_t)(b->inv_w - a->inv_w)) + qtri_about((int32_t)(c->inv_w - a->inv_w)) + 2;
    return qtri_place_is_level(a, b, c) && range * ((q_range >> 16) + 1) < (uint32_t)1
                                                                               << (25 - part);
}

/*
 * Whether light, Q15, that differs from vertex 0's by i1 and i2 is linear on the screen where it
 * makes shares of the tint: asked where white would not be, which needs no look at the tint and is
 * true of most. q0, q1, q2 as qtri_list_is_linear() has them.
 */
bool qtri_list_tint_is_linear(const qtri_raster *raster, uint32_t q0, int32_t q1, int32_t q2,
                              int32_t i1, int32_t i2);

/* Of a triangle that is not plain: whether it is small, and its light linear for this tint. */
bool qtri_list_tint_is_simple(const qtri_raster *raster, const qtri_vertex *a, const qtri_vertex *b,
                              const qtri_vertex *c, int32_t i1, int32_t i2);

/*
 * Colours of the triangle: light, 2^22 being 1, or channels n.16. The words of its fragments are
 * made of channels >> shift, to nearest; of three, red and green are further left. Where channels
 * do not vary the word is v->constant, which set_light sets.
 */
void qtri_list_set_light(qtri_list_values *v, uint32_t shift);
void qtri_list_set_channels(qtri_list_values *v, uint32_t shift);
void qtri_list_words(const qtri_list_values *v, uint32_t *out, const uint32_t *place, int32_t count,
                     uint32_t shift, uint32_t red, uint32_t green);

/* Texture coordinates; then numbers of texels, or colours where they are filtered: the mask of
   those that are drawn. */
void qtri_list_set_texels(qtri_list_values *v);
uint32_t qtri_list_texels(const qtri_list_values *v, uint32_t *color, uint32_t *shade,
                          const uint32_t *place, int32_t count);

/*
 * The texel stages of `count` waiting fragments. mask: of those that are drawn, where texels were
 * filtered. Returns it without those of the key's colour.
 */
uint32_t qtri_list_finish_texels(const qtri_raster *raster, int32_t count, uint32_t mask);

#endif
