/* SPDX-License-Identifier: MIT */
/*
 * A large triangle, row by row. Internal, part of the pipelines' body (pipeline_make.h).
 *
 * The loop over pixels knows only pieces of rows: a count, and for every attribute its start, step
 * and, for texture coordinates, the change of the step. What finds them is not inlined
 * (core/raster/large_*.c): it is called where options ask for it, and linked only then.
 */
#ifndef QTRI_BODY_LARGE_H
#define QTRI_BODY_LARGE_H

#include "arithmetic.h"
#include "dda.h"
#include "loop.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Knots of coordinates, which divide a piece. */
typedef struct qtri_large_knots {
    int32_t next, spacing; /* pixels to the next knot, and from one to the next */
    uint32_t bend_gain[2]; /* added to bends there */
    uint32_t gain_loss[2]; /* lost by that from knot to knot */
} qtri_large_knots;

/* A texture coordinate: at the first pixel, its step, and what that gains from pixel to pixel. */
typedef struct qtri_large_coordinate {
    uint32_t at, step, bend;
} qtri_large_coordinate;

typedef struct qtri_large_colors {
    uint32_t c, c_step, g, g_step;
    uint32_t c_other;
    uint32_t alpha, alpha_step;
} qtri_large_colors;

/* Pixels of a row along which attributes are polynomials. */
typedef struct qtri_large_piece {
    int32_t count; /* 0: there is nothing to draw */
    qtri_large_coordinate uv[2];
    union {
        qtri_large_knots knots; /* where coordinates alone vary */
        qtri_large_colors colors;
    } of;
    uint32_t level; /* of a texture that is mipmapped */
} qtri_large_piece;

/* How colours vary along rows: what is stepped of them, and how pieces have it. In large_colors.c;
   only those that pipelines name are linked. */
typedef struct qtri_large_packing {
    /* What is stepped of a colour, 8.16 of 255, n.16 each. NULL: light of the vertices. */
    void (*channels)(uint32_t out[3], const uint32_t color_8p16[3]);
    /* Colours of a piece of n pixels, from these and their steps. */
    void (*pack)(qtri_large_piece *piece, const uint32_t *c, const uint32_t *step, int32_t n);
    uint8_t count;    /* of what is stepped: 1 or 3 */
    uint8_t run_log2; /* of pixels along which it may be */
    bool rounds;      /* steps have short fractions, see qtri_pixel_next() */
} qtri_large_packing;

extern const qtri_large_packing qtri_packing_light, qtri_packing_gray;
extern const qtri_large_packing qtri_packing_565;     /* one word: see pixel.h */
extern const qtri_large_packing qtri_packing_888;     /* lanes of 8.8 */
extern const qtri_large_packing qtri_packing_fine;    /* as these: QTRI_IN_FINE_565 */
extern const qtri_large_packing qtri_packing_weights; /* of texels: lanes of 9.7, 256 is 1 */

/* What a draw call has of a triangle. */
typedef struct qtri_large_input {
    qtri_draw_state *state;
    const qtri_point *const *p;
    int64_t area;   /* twice that of these, signed, not 0 */
    uint32_t color; /* 0x00RRGGBB */
    const struct qtri_large_vertex *v;
    uint32_t depth_16p16[3]; /* of the vertices, as the material shifts it */
} qtri_large_input;

struct qtri_large;

/* Light by pixel: colours along rows, found by what a draw call with such lights brings. */
typedef struct qtri_light_walk {
    void (*begin)(struct qtri_large *triangle);
    /* Goes on along the row; returns for how many pixels `piece` is linear, `count` at most. */
    int32_t (*next)(struct qtri_large *triangle, int32_t count);
    qtri_large_piece piece; /* its colours */
    const qtri_large_packing *packing;
    uint32_t half; /* added to their starts, to round */
} qtri_light_walk;

enum { QTRI_LARGE_ATTRIBUTES = 6 /* u v, light or red green blue, alpha */ };

enum { QTRI_LARGE_RUN_LOG2 = 6, QTRI_LARGE_RUN = 1 << QTRI_LARGE_RUN_LOG2 };

/* The edges of a triangle: the lower one takes its side over at row `turn`. */
typedef struct qtri_large_edges {
    qtri_dda left, right;
    int32_t row, turn, end;
    bool lower_is_left;
    qtri_dda lower;
} qtri_large_edges;

/*
 * A triangle of samples is walked once for each place where pixels may take their colours
 * (antialias.h), as the triangle that is moved so that this place lies where centres do: in a pass
 * only the pixels that take theirs there are drawn.
 */
typedef struct qtri_large_samples {
    qtri_samples_row row;
    int32_t place;          /* of the pass */
    uint32_t z_p, z_q;      /* what depth has more: see antialias.h */
    int32_t first_row, end; /* of all places */
    qtri_point moved[3];
    qtri_large_edges first[QTRI_PLACES], edges[QTRI_PLACES]; /* as they begin; as they are */
} qtri_large_samples;

/* 2^-32 of a unit: the upper word is what is whole. */
typedef struct qtri_large_plane {
    uint64_t row; /* at column 0 of the row */
    uint64_t dx, dy;
    uint64_t s, s_step; /* at the next point of the row */
} qtri_large_plane;

typedef struct qtri_large_attribute {
    qtri_large_plane plane;
    uint32_t f[3];         /* of the vertices */
    uint32_t range;        /* of colours: 8.16, f counts from the least */
    uint32_t start;        /* what is added where pieces start: the least, the half that rounds */
    int32_t point_quarter; /* a quarter of the attribute at the point that was found last */
    uint32_t at, step;     /* along a row where it is linear */
    int8_t piece_shift;    /* pieces have f 2^this */
    /* Shifts from quarters to pieces: left, else right. */
    uint8_t at_left, at_right, step_left, step_right, bend_left, bend_right;
} qtri_large_attribute;

/* How much vertices 1 and 2 weigh: steps of a pixel right and down, and at the centre of the pixel
   that has vertex 0, 2^-fraction. */
typedef struct qtri_large_weights {
    int64_t b[2][3]; /* |.| < 2^61, 2^62 */
    int32_t fraction;
    bool of_true_positions; /* of the vertices; false: of those that are snapped */
} qtri_large_weights;

/* An attribute by steps of whole units, exact to half of one each: at column 0 of row 0. */
typedef struct qtri_large_ramp {
    int64_t at, dx, dy;
} qtri_large_ramp;

/* A triangle on its way: its edges, its depth, and where it is along a row. */
typedef struct qtri_large {
    /* From row to row; first, since Armv6-M reaches 31 words, and 31 bytes. */
    qtri_draw_state *state;
    const qtri_large_input *in;
    bool is_new;             /* nothing of the row is found yet */
    bool clamps_depth;       /* depth may leave its range */
    bool has_true_positions; /* weights of attributes may be those of true positions */
    int32_t y;
    int32_t x0, x1;                     /* what is drawn of the row: columns x0..x1 - 1 */
    uint32_t row_z, row_z_step, z_step; /* depth of column 0; down, and right */
    uintptr_t row_pixel, row_depth;     /* addresses of column 0 */
    ptrdiff_t pitch, depth_pitch;
    int32_t row_left, row_right; /* of the triangle, inside of the frame */
    int32_t bounds_left, bounds_right;
    int32_t frame_width;
    qtri_large_edges edges;

    int32_t x; /* where the row's next pieces start; x1 - 1 while clamped ones are left */
    int32_t fog_x, fog_end; /* column that fog is asked for next; up to which it is linear */
    uint32_t fog, fog_step; /* there, 8.16 with a half; a pixel's step */

    qtri_large_samples *samples; /* with four samples a pixel */

    const qtri_options *options;
    int32_t corner_x[3], corner_y[3]; /* of the vertices, 24.8 */
    int64_t area;                     /* twice that of these, signed */
    qtri_large_weights weights;
    int32_t plane_y;        /* of planes' rows */
    qtri_large_ramp ramp_z; /* 16.16 with QTRI_DEPTH_HALF; it may be out of range */
    /* Of a row that is drawn in parts, as its depth leaves its range or its pixels have samples:
       what is not drawn yet. */
    int32_t next_left, next_right;
    int32_t x_least, y_least, width, height; /* of the triangle, 24.8 */
} qtri_large;

/*
 * What the footprint of a triangle with perspective is made of, see mipmap.c: along each
 * axis the steps right and down, times q^2, in 2^-exponent of 2^(1/2) texels; |.| < 2^28 where the
 * triangle is in the frame.
 */
typedef struct qtri_footprint_plane {
    uint32_t right[2], right_dy[2]; /* in row 0, for one row down */
    uint32_t down[2], down_dx[2];   /* in column 0, for one column right */
    int32_t before;  /* the shift of a length that is compared with q's square, see is_left() */
    uint32_t length; /* of the row's step right */
} qtri_footprint_plane;

/* Bits of q's square, and the shift by which a length of level 0 is compared with it. */
typedef struct qtri_footprint_measure {
    uint32_t square;
    int32_t before;
} qtri_footprint_measure;

typedef struct qtri_large_levels {
    bool are_found;   /* along rows; false: `only` is that of the triangle */
    uint8_t only;     /* that, or the last one of a row along which w does not change */
    uint8_t run_log2; /* of pixels along such a row that have one */
    qtri_footprint_measure measure; /* in such a row */
    qtri_footprint_plane footprint;
} qtri_large_levels;

/* Coordinates that need no clamping: see large_clamp.c. */
typedef struct qtri_large_zone {
    uint32_t least, size;            /* least..least + size */
    uint32_t start;                  /* what `least` is for the walk, before it is shifted */
    uint8_t shift_left, shift_right; /* to the walk's units */
} qtri_large_zone;

/* Units of a coordinate. One that needs to be clamped has units of its own in planes and pieces,
   until it is. */
typedef struct qtri_large_axis {
    uint8_t texel_shift;  /* a texel, of level 0, is 2^this */
    int8_t walk_shift;    /* to the walk's units */
    bool needs_clamp;     /* it leaves the texture */
    uint32_t texel_zero;  /* where the first texel begins */
    qtri_large_zone zone; /* of the piece's level, if it needs to be clamped */
} qtri_large_axis;

/* What varies along rows beside depth. */
typedef struct qtri_large_job {
    qtri_large t;              /* first: qtri_large_job_of() converts its address */
    qtri_large_attribute *a;   /* as many as vary: u v, light or red green blue, alpha */
    qtri_large_piece piece[3]; /* two at most; clamped: [2] is the rest of the first */
    qtri_large_axis axis[2];
    bool needs_clamp;  /* one of the axes does */
    bool second_waits; /* clamped: piece[1] is drawn after piece[2] */
    int32_t resume_x;  /* where the row's next pieces start after these */

    /* Not curved: packed colours begin anew every QTRI_LARGE_RUN pixels, red, green and blue n.16
       with half of what rounding of packed steps sums up to. */
    uint32_t run_at[3], run_down[3], run_step[3]; /* column 0 of row 0; from row to row; of a run */
    uint32_t run_even, run_odd;

    uint8_t first_color, alpha, count; /* attributes: u v if textured, colours, alpha */
    const qtri_large_packing *packing; /* of colours; NULL: there are none */
    bool rounds;                       /* packing->rounds */
    uint8_t run_log2;                  /* of the most pixels that colours are stepped */
    uint8_t q_headroom;                /* planes are times 2^this, vertex_q is not */
    uint32_t vertex_q[3];
    qtri_large_plane q;

    bool is_curved;          /* planes are times q */
    bool has_knots;          /* coordinates alone vary, without levels */
    bool rows_may_be_linear; /* q hardly changes along them: by `steep` */
    bool row_is_linear;      /* attributes are, along this row */
    uint32_t steep;          /* 2^-16 a pixel */
    uint8_t linear_log2;     /* of pixels that steps of a linear row span */
    int8_t span_log2;        /* of pixels between points */
    int32_t span_log2_max;
    int32_t fixed_span_log2; /* where one length serves all rows; else -1 */
    /* What lengths are found by: logarithms in 1/256, see large_curves.c. */
    int16_t q_slope_log2, chord_log2, texel_log2, repeat_log2;
    qtri_large_levels *levels; /* of a texture that is mipmapped */

    int32_t chunk_end;
    bool has_second; /* piece[1] is drawn next, up to second_end */
    int32_t second_end;
    int32_t q_zeros;         /* leading zeros of q at the last point */
    uint32_t q_rise;         /* from a point to the next, whole; 0: spans are single pixels */
    int32_t relative_q_rise; /* (q1 - q0) / 2 q at the last point, Q16 */
} qtri_large_job;

static inline qtri_large_job *qtri_large_job_of(qtri_large *t)
{
    return (qtri_large_job *)(void *)t;
}

/* In large.c, without samples: the first row that is drawn; false: there is none. */
bool qtri_large_begin_rows(qtri_large *t);

/* In large_samples.c: passes, one place after the other from QTRI_CENTER down. False: there is
   nothing to draw in it. Then rows, or parts of them. */
bool qtri_large_begin_samples(qtri_large *t, int32_t place);
bool qtri_large_next_samples(qtri_large *t);

/* Before the first row: nothing varies yet; what varies; then planes of all of it. */
void qtri_large_reset_attributes(qtri_large *t);
void qtri_large_set_texture(qtri_large *t);
void qtri_large_set_colors(qtri_large *t, const qtri_large_packing *packing, uint32_t half);
void qtri_large_set_alpha(qtri_large *t);
void qtri_large_set_planes(qtri_large *t);

/* Goes on to the next row, which may have no pixels to draw; false: there is none. */
bool qtri_large_next_row(qtri_large *t);

/* Finds what the row has next, from t->x < x1 on: a piece of texture coordinates alone, which may
   have knots; pieces of any attributes: returns how many. */
void qtri_large_next_uv(qtri_large *t);
int32_t qtri_large_next_any(qtri_large *t);

/* In mipmap.c: of a texture that is mipmapped. Set once planes are; then pieces of levels, with or
   without perspective. */
void qtri_large_set_levels(qtri_large *t);
int32_t qtri_large_next_levels(qtri_large *t);

/* Of packed colours, after planes: runs where they are linear. */
void qtri_large_set_runs(qtri_large *t);

/* Where they are: colours at the start of the first run that is drawn of the row; returns how many
   of its pixels are not. */
uint32_t qtri_large_begin_runs(const qtri_large *t, uint32_t start[3]);

/* Fog from t->fog_x on; returns for how many pixels it is linear, `count` at most. */
int32_t qtri_large_next_fog(qtri_large *t, int32_t count);

/* Light or colours are attributes of the vertices. */
QTRI_BODY bool qtri_large_varies(const qtri_options *o)
{
    return qtri_varies(o) && !o->per_pixel;
}

/* Something varies along rows beside depth and light by pixel. */
QTRI_BODY bool qtri_large_has_pieces(const qtri_options *o)
{
    return qtri_is_textured(o) || qtri_large_varies(o) || o->vertex_alpha;
}

QTRI_BODY const qtri_large_packing *qtri_large_packing_of(const qtri_options *o)
{
    return qtri_is_lit(o)                    ? &qtri_packing_light
           : qtri_is_textured(o)             ? &qtri_packing_weights
           : qtri_kind_of(o) == QTRI_IN_565  ? &qtri_packing_565
           : qtri_kind_of(o) == QTRI_IN_GRAY ? &qtri_packing_gray
           : qtri_kind_of(o) == QTRI_IN_888  ? &qtri_packing_888
                                             : &qtri_packing_fine;
}

QTRI_BODY void qtri_large_begin(const qtri_options *o, qtri_large *t, qtri_pixel_walk *w)
{
    if (qtri_large_has_pieces(o)) {
        qtri_large_reset_attributes(t);
    }
    if (qtri_is_textured(o)) {
        qtri_large_set_texture(t);
    }
    if (qtri_large_varies(o)) {
        qtri_large_set_colors(t, qtri_large_packing_of(o), qtri_light_half(o));
    }
    if (o->per_pixel) {
        t->state->light_walk->packing = qtri_large_packing_of(o);
        t->state->light_walk->half = qtri_light_half(o);
        t->state->light_walk->begin(t);
    }
    if (o->vertex_alpha) {
        qtri_large_set_alpha(t);
    }
    if (qtri_large_has_pieces(o)) {
        qtri_large_set_planes(t);
    }
    if (qtri_is_packed_565(o) && !o->per_pixel) {
        qtri_large_set_runs(t);
    }
    if (o->mipmapped) {
        qtri_large_set_levels(t);
    }
    if (qtri_uses_table(o) && !t->state->has_table) {
        qtri_draw_state_set_table(t->state);
    }
    qtri_walk_begin(o, w, t->state);
    w->z_step = t->z_step;
    if (!qtri_varies(o)) {
        w->color = qtri_walk_color(o, t->state->surface, t->in->color);
    }
}

/* Texture coordinates alone vary, in pieces that may have knots. */
QTRI_BODY bool qtri_large_has_knots(const qtri_options *o)
{
    return qtri_is_textured(o) && !qtri_large_varies(o) && !o->vertex_alpha && !o->mipmapped;
}

QTRI_BODY int32_t qtri_large_next(const qtri_options *o, qtri_large *t)
{
    if (o->mipmapped) {
        return qtri_large_next_levels(t);
    }
    return qtri_large_next_any(t);
}

QTRI_BODY void qtri_large_load_colors(const qtri_options *o, qtri_pixel_walk *w,
                                      const qtri_large_piece *piece)
{
    w->c = piece->of.colors.c;
    w->c_step = piece->of.colors.c_step;
    if (qtri_is_packed_565(o)) {
        w->c_other = piece->of.colors.c_other;
    }
    if (qtri_has_two_words(o)) {
        w->g = piece->of.colors.g;
        w->g_step = piece->of.colors.g_step;
    }
}

QTRI_BODY void qtri_large_load(const qtri_options *o, qtri_large *t, qtri_pixel_walk *w,
                               const qtri_large_piece *piece)
{
    if (o->mipmapped && piece->level != t->state->level) {
        QTRI_RARELY();
        qtri_draw_state_set_level(t->state, piece->level);
        qtri_walk_set_texture(o, w);
    }
    if (qtri_is_textured(o)) {
        w->u = piece->uv[0].at;
        w->v = piece->uv[1].at;
        w->u_step = piece->uv[0].step;
        w->v_step = piece->uv[1].step;
        w->u_bend = piece->uv[0].bend;
        w->v_bend = piece->uv[1].bend;
    }
    if (qtri_large_varies(o)) {
        qtri_large_load_colors(o, w, piece);
    }
    if (o->vertex_alpha) {
        w->alpha = piece->of.colors.alpha;
        w->alpha_step = piece->of.colors.alpha_step;
    }
}

/* Of `count` > 0 pixels of the row, those whose depths are stored with one exponent. */
QTRI_BODY int32_t qtri_large_next_octave(qtri_pixel_walk *w, int32_t count)
{
    uint32_t last = w->z + (uint32_t)(count - 1) * w->z_step;
    if (w->z >= w->octave.size) {
        QTRI_RARELY();
        const uint32_t z = w->z + w->octave.zero;
        const qtri_octave found = qtri_depth_octave(z); /* or the walk would lie in memory */
        w->octave = found;
        w->z = z - w->octave.zero;
        last = w->z + (uint32_t)(count - 1) * w->z_step;
    }
    const bool falls = (int32_t)w->z_step < 0;
    if (last >= w->octave.size || (last < w->z) != falls) {
        QTRI_RARELY();
        const uint32_t left = falls ? w->z : w->octave.size - 1 - w->z;
        const uint32_t step = falls ? 0 - w->z_step : w->z_step;
        const uint32_t inside = left / step; /* > 0: w->z is inside, and `last` is not */
        count = inside < (uint32_t)count ? (int32_t)inside + 1 : count;
    }
    return count;
}

/* Pixels along which everything is a polynomial, but what is stored of their depths. */
QTRI_BODY void qtri_large_octaves(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                  bool bent, int32_t count)
{
    if (o->depth != QTRI_FLOAT16) {
        qtri_pixels_draw(o, pixel, w, bent, count);
        return;
    }
    while (count > 0) {
        const int32_t n = qtri_large_next_octave(w, count);
        QTRI_BODY_ASSUME(w->octave.down != 0);
        qtri_pixels_draw(o, pixel, w, bent, n);
        count -= n;
    }
}

/* Loops that few options repeat have one call of what they repeat: calls are inlined and looked at
   by the compiler, which is most of its time, before what options do not ask for is left out. */
QTRI_BODY void qtri_large_colored_pixels(const qtri_options *o, qtri_pixel_body *pixel,
                                         qtri_large *t, qtri_pixel_walk *w, bool bent,
                                         int32_t count)
{
    do {
        int32_t n = count;
        if (o->fog && count > 0) {
            n = qtri_large_next_fog(t, count);
            w->fog = t->fog;
            w->fog_step = t->fog_step;
        }
        qtri_large_octaves(o, pixel, w, bent, n);
        if (o->fog) {
            t->fog = w->fog;
        }
        count -= n;
    } while (o->fog && count > 0);
}

QTRI_BODY void qtri_large_pixels(const qtri_options *o, qtri_pixel_body *pixel, qtri_large *t,
                                 qtri_pixel_walk *w, bool bent, int32_t count)
{
    do {
        int32_t n = count;
        if (o->per_pixel && count > 0) {
            qtri_light_walk *light = t->state->light_walk;
            n = light->next(t, count);
            qtri_large_load_colors(o, w, &light->piece);
        }
        qtri_large_colored_pixels(o, pixel, t, w, bent, n);
        count -= n;
    } while (o->per_pixel && count > 0);
}

/* The row's next pieces. A second loop over pixels, where coordinates do not bend, saves two
   additions a pixel; there is one piece then. */
QTRI_BODY void qtri_large_pieces_draw(const qtri_options *o, qtri_pixel_body *pixel, qtri_large *t,
                                      qtri_pixel_walk *w)
{
    int32_t pieces = qtri_large_next(o, t);
    qtri_large_job *job = qtri_large_job_of(t);
    qtri_large_piece *piece = job->piece;
    if (qtri_is_textured(o) && qtri_is_short(o) && job->row_is_linear) {
        qtri_large_load(o, t, w, piece);
        qtri_large_pixels(o, pixel, t, w, false, piece->count);
        return;
    }
    do {
        qtri_large_load(o, t, w, piece);
        qtri_large_pixels(o, pixel, t, w, qtri_is_textured(o), piece->count);
        piece++;
    } while (--pieces != 0);
}

/* At a knot of a piece, of whose coordinates these are the steps and bends. */
QTRI_BODY void qtri_large_pass_knot(qtri_large_piece *piece, uint32_t *u_step, uint32_t *u_bend,
                                    uint32_t *v_step, uint32_t *v_bend)
{
    *u_bend += piece->of.knots.bend_gain[0];
    *v_bend += piece->of.knots.bend_gain[1];
    *u_step += (uint32_t)((int32_t)piece->of.knots.bend_gain[0] >> 1);
    *v_step += (uint32_t)((int32_t)piece->of.knots.bend_gain[1] >> 1);
    piece->of.knots.bend_gain[0] -= piece->of.knots.gain_loss[0];
    piece->of.knots.bend_gain[1] -= piece->of.knots.gain_loss[1];
    piece->of.knots.next = piece->of.knots.spacing;
}

/* The row's next piece, which may have knots. */
QTRI_BODY void qtri_large_spline_draw(const qtri_options *o, qtri_pixel_body *pixel, qtri_large *t,
                                      qtri_pixel_walk *w)
{
    qtri_large_job *job = qtri_large_job_of(t);
    qtri_large_piece *piece = job->piece;
    qtri_large_next_uv(t);
    qtri_large_load(o, t, w, piece);
    if (qtri_is_short(o) && job->row_is_linear) {
        qtri_large_pixels(o, pixel, t, w, false, piece->count);
        return;
    }
    if (!QTRI_LONG_MULTIPLY) {
        QTRI_BODY_BARRIER(piece); /* or Armv6-M would find it anew for each access */
    }
    for (;;) {
        const int32_t n = piece->of.knots.next < piece->count ? piece->of.knots.next : piece->count;
        qtri_large_pixels(o, pixel, t, w, true, n);
        piece->count -= n;
        if (piece->count <= 0) {
            return;
        }
        qtri_large_pass_knot(piece, &w->u_step, &w->u_bend, &w->v_step, &w->v_bend);
    }
}

/* Red, green and blue n.16 in a word. */
QTRI_BODY uint32_t qtri_large_word(uint32_t r, uint32_t g, uint32_t b)
{
    return (r >> 10 << 21) + (b & ~(uint32_t)0x7FF) + (g >> 11);
}

/* A row along which packed colours are linear. */
QTRI_BODY void qtri_large_runs(const qtri_options *o, qtri_pixel_body *pixel, qtri_large *t,
                               qtri_pixel_walk *w)
{
    const qtri_large_job *job = qtri_large_job_of(t);
    uint32_t start[3];
    const uint32_t skipped = qtri_large_begin_runs(t, start);
    uint32_t r = start[0], g = start[1], b = start[2];
    int32_t left = t->x1 - t->x0;
    int32_t count = QTRI_LARGE_RUN - (int32_t)skipped;
    w->c = qtri_large_word(r, g, b);
    w->c_step = job->run_even;
    w->c_other = job->run_odd;
    if (skipped != 0) {
        w->c += w->c_step * ((skipped + 1) >> 1) + w->c_other * (skipped >> 1);
        if ((skipped & 1) != 0) {
            w->c_step = job->run_odd;
            w->c_other = job->run_even;
        }
    }
    for (;;) {
        qtri_large_octaves(o, pixel, w, false, left < count ? left : count);
        left -= count;
        if (left <= 0) {
            return;
        }
        count = QTRI_LARGE_RUN;
        r += job->run_step[0];
        g += job->run_step[1];
        b += job->run_step[2];
        w->c = qtri_large_word(r, g, b);
        w->c_step = job->run_even;
        w->c_other = job->run_odd;
    }
}

/* Goes on to the next row, or with samples to a part of one; false: there is none. */
QTRI_BODY bool qtri_large_next_part(const qtri_options *o, struct qtri_large *t)
{
    return qtri_has_samples(o) ? qtri_large_next_samples(t) : qtri_large_next_row(t);
}

QTRI_BODY void qtri_large_begin_row(const qtri_options *o, qtri_large *t, qtri_pixel_walk *w)
{
    const uint32_t x0 = (uint32_t)t->x0;
    /* NOLINTBEGIN(performance-no-int-to-ptr): column 0 may lie before the surface's first row */
    w->pixel = (uint8_t *)(t->row_pixel + x0 * qtri_pixel_step(o));
    if (qtri_tests_depth(o)) {
        w->depth = (uint8_t *)(t->row_depth + x0 * qtri_depth_size(o, w->state->surface));
    }
    /* NOLINTEND(performance-no-int-to-ptr) */
    if (qtri_needs_depth(o)) {
        w->z_step = t->z_step;
        w->z = t->row_z + x0 * w->z_step - (qtri_has_samples(o) ? w->z_place : w->octave.zero);
    }
    if (qtri_needs_place(o)) {
        w->x = t->x0;
        w->y = t->y;
    }
    if (o->fog) {
        t->fog_x = t->fog_end = t->x0;
    }
    if (qtri_large_has_pieces(o)) {
        t->x = t->x0;
        t->is_new = true;
    }
}

QTRI_BODY void qtri_large_rows_draw(const qtri_options *o, qtri_pixel_body *pixel, qtri_large *t,
                                    qtri_pixel_walk *w)
{
    qtri_large_begin(o, t, w);
    while (qtri_large_next_part(o, t)) {
        const int32_t count = t->x1 - t->x0;
        if (count <= 0) {
            continue;
        }
        qtri_large_begin_row(o, t, w);
        if (!qtri_large_has_pieces(o)) {
            qtri_large_pixels(o, pixel, t, w, false, count);
            continue;
        }
        if (qtri_is_packed_565(o) && !qtri_large_job_of(t)->is_curved) {
            qtri_large_runs(o, pixel, t, w);
            continue;
        }
        do {
            if (qtri_large_has_knots(o)) {
                qtri_large_spline_draw(o, pixel, t, w);
            } else {
                qtri_large_pieces_draw(o, pixel, t, w);
            }
        } while (t->x < t->x1);
    }
}

/* How many attributes options may ask for. */
QTRI_BODY int qtri_large_attributes(const qtri_options *o)
{
#if defined(QTRI_PIPELINE_IS_ANY) || defined(QTRI_AMALGAMATION)
    (void)o;
    return QTRI_LARGE_ATTRIBUTES;
#else
    return (qtri_is_textured(o) ? 2 : 0) +
           (!qtri_large_varies(o) ? 0
            : qtri_is_lit(o)      ? 1
                                  : 3) +
           (o->vertex_alpha ? 1 : 0);
#endif
}

QTRI_BODY void qtri_large_triangle_draw(const qtri_options *o, qtri_pixel_body *pixel,
                                        const qtri_large_input *in)
{
    qtri_pixel_walk w = QTRI_BODY_ZERO;
    /* On the stack of pipelines that need them. */
    qtri_large plain;
    qtri_large_job job;
    qtri_large_samples samples;
    qtri_large_levels levels;
    qtri_large_attribute one[1], few[3], many[QTRI_LARGE_ATTRIBUTES];
    const int count = qtri_large_attributes(o);
    qtri_large *t = count != 0 ? &job.t : &plain;
    int32_t place = 0; /* without samples: there is one pass */
    t->state = in->state;
    t->in = in;
    t->options = &in->state->options;
    if (count != 0) {
        job.a = count > 3 ? many : count > 1 ? few : one;
    }
    if (o->mipmapped) {
        job.levels = &levels;
    }
    if (qtri_has_samples(o)) {
        place = QTRI_CENTER;
        t->samples = &samples;
    } else if (!qtri_large_begin_rows(t)) {
        return;
    }
    do {
        if (qtri_has_samples(o)) {
            if (!qtri_large_begin_samples(t, place)) {
                continue;
            }
            w.sample_row = &samples.row;
            w.z_p = samples.z_p;
            w.z_q = samples.z_q;
            w.z_place = qtri_samples_more(place, w.z_p, w.z_q);
        }
        qtri_large_rows_draw(o, pixel, t, &w);
    } while (qtri_has_samples(o) && --place >= 0);
}

#ifdef __cplusplus
}
#endif

#endif
