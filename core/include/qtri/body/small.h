/* SPDX-License-Identifier: MIT */
/*
 * Draws a small triangle: set-up (small_setup.h), then its rows. Internal, part of the pipelines'
 * body (pipeline_make.h).
 */
#ifndef QTRI_BODY_SMALL_H
#define QTRI_BODY_SMALL_H

#include "loop.h"
#include "small_setup.h"

/* The ramps that rows begin with, and step by. */
typedef struct qtri_small_rows {
    qtri_small_ramp c, g, alpha, u, v;
} qtri_small_rows;

/* The generic pipeline's rows step z and c in any case, and ask once about what few have, as a
   question is as long as a step. A macro: an enum would be that of all files in the single one. */
#ifdef QTRI_PIPELINE_IS_ANY_LOOP
#define QTRI_SMALL_ANY true
#else
#define QTRI_SMALL_ANY false
#endif

/* Whether rows may have more than z, c, u and v. */
QTRI_BODY bool qtri_small_has_more(const qtri_options *o)
{
    return !QTRI_SMALL_ANY || qtri_has_two_words(o) || o->vertex_alpha || o->fog ||
           qtri_needs_place(o);
}

/* Steps the values of the walk by n pixels, but not its pointers. */
QTRI_BODY void qtri_small_step(const qtri_options *o, qtri_pixel_walk *w, uint32_t n, bool with_uv,
                               bool more)
{
    if (QTRI_SMALL_ANY || qtri_needs_depth(o)) {
        w->z += n * w->z_step;
    }
    if (with_uv && (QTRI_SMALL_ANY || qtri_is_textured(o))) {
        w->u += n * w->u_step;
        w->v += n * w->v_step;
    }
    if (QTRI_SMALL_ANY || qtri_varies(o)) {
        w->c += n * w->c_step;
    }
    if (!more) {
        return;
    }
    if (QTRI_SMALL_ANY || qtri_has_two_words(o)) {
        w->g += n * w->g_step;
    }
    if (QTRI_SMALL_ANY || o->vertex_alpha) {
        w->alpha += n * w->alpha_step;
    }
    if (QTRI_SMALL_ANY || o->fog) {
        w->fog += n * w->fog_step;
    }
    if (QTRI_SMALL_ANY || qtri_needs_place(o)) {
        w->x += (int32_t)n;
    }
}

/* The pixel that belongs to w->depth, w->apart bytes from it. */
QTRI_BODY uint8_t *qtri_small_pixel_of(const qtri_pixel_walk *w)
{
    return (uint8_t *)((uintptr_t)w->depth + w->apart); /* NOLINT(performance-no-int-to-ptr) */
}

/* Draws `count` pixels of a row, 1 or more, from the walk's on. Paired: depth's pointer serves
   both, and tells the end. Bent: texture coordinates follow curves. */
QTRI_BODY void qtri_small_pixels(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                                 bool bent, int32_t count)
{
    if (QTRI_SMALL_ANY) {
        w->state->loop(w, bent, count);
        return;
    }
    const bool paired = qtri_is_paired(o);
    const uint32_t bytes = qtri_pixel_bytes(o);
    /* By fours, or unrolled: flat quads of 40 pixels take 14 % less on a Cortex-M3, of 100 pixels
       31 %, 64 cubes (S14) 1.5 %. */
    if (QTRI_SMALL_IN_PLACE && qtri_has_constant_color(o) && count >= 16) {
        w->pixel = paired ? qtri_small_pixel_of(w) : w->pixel;
        qtri_pixels_draw(o, pixel, w, bent, count);
        return;
    }
    const uint8_t *end = paired ? w->depth + (uint32_t)count * bytes : w->depth;
    do {
        pixel(w, bent, paired ? qtri_small_pixel_of(w) : w->pixel, w->depth);
        if (paired) {
            w->depth += bytes;
            QTRI_BODY_BARRIER(w->depth);
        } else {
            qtri_walk_move(o, w, 1);
        }
    } while (paired ? w->depth != end : --count != 0);
}

/* Sets texture coordinates of the walk, and steps, x columns from vertex 0's. */
QTRI_BODY void qtri_small_curves_begin(qtri_pixel_walk *w, const qtri_small_curves *curves,
                                       uint32_t x)
{
    w->u = qtri_small_curve_at(&curves->u, x);
    w->v = qtri_small_curve_at(&curves->v, x);
    w->u_step = qtri_small_curve_step(&curves->u, x, 1);
    w->v_step = qtri_small_curve_step(&curves->v, x, 1);
}

/* Sets light by the chord of its curve that has column x, as chords begin at multiples of their
   length; returns how many pixels are left of it, `count` at most. */
QTRI_BODY uint32_t qtri_small_curves_set_light(qtri_pixel_walk *w, const qtri_small_curves *curves,
                                               uint32_t x, uint32_t count)
{
    const uint32_t left = curves->light_piece - (x & (curves->light_piece - 1));
    const qtri_small_chord c = qtri_small_whole_chord_of(&curves->c, x, curves->light_piece);
    w->c_step = c.step;
    w->c = c.at;
    return left < count ? left : count;
}

/* Sets colours, packed, as qtri_small_curves_set_light() does light. */
QTRI_BODY uint32_t qtri_small_curves_set_colors(const qtri_options *o, qtri_pixel_walk *w,
                                                const qtri_small_color_curves *k, uint32_t x,
                                                uint32_t count)
{
    const uint32_t left = k->piece - (x & (k->piece - 1));
    qtri_small_chord c, g;
    qtri_small_set_color_chord(&c, &g, k, &w->state->options, x);
    w->c_step = c.step;
    w->c_other = c.step;
    w->c = c.at;
    if (qtri_has_two_words(o)) {
        w->g_step = g.step;
        w->g = g.at;
    }
    return left < count ? left : count;
}

QTRI_BODY void qtri_small_curves_next_row(const qtri_options *o, qtri_small_curves *curves)
{
    if (qtri_is_textured(o)) {
        qtri_small_curve_next_row(&curves->u);
        qtri_small_curve_next_row(&curves->v);
    }
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): light sets it
    if (qtri_is_lit(o) && curves->light_piece != 0) {
        qtri_small_curve_next_row(&curves->c);
    }
}

/* The first depth. Only the generic pipeline may have one in place of all; read from the state by
   others, too, it costs S6 .8 % on a Cortex-M3. */
QTRI_BODY uint8_t *qtri_small_depths(const qtri_draw_state *state)
{
    return (uint8_t *)(QTRI_SMALL_ANY ? state->depth : state->surface->depth);
}

/* Curved or not: what rows and pieces begin with is read from memory, so that pixels have the
   registers. Texels take more of them than that leaves. */
QTRI_BODY bool qtri_small_shares_loop(const qtri_options *o)
{
    return !QTRI_SMALL_IN_PLACE && !qtri_is_textured(o) && qtri_is_lit(o) && !QTRI_SMALL_ANY;
}

/* Whether rows may be divided: light alone is not, and its loop has no call. */
QTRI_BODY bool qtri_small_divides(const qtri_options *o)
{
    return qtri_is_textured(o) || o->shade == QTRI_COLORS;
}

/* Moves the walk to the triangle's first row, QTRI_SMALL_REACH columns after its first column. */
QTRI_BODY void qtri_small_begin_rows(const qtri_options *o, qtri_pixel_walk *w,
                                     const qtri_small_place *p, const qtri_small_rows *rows,
                                     const qtri_small_curves *curves, bool curved)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t bytes = qtri_pixel_bytes(o), depth_bytes = qtri_depth_size(o, surface);
    const bool textured = qtri_is_textured(o), varies = qtri_varies(o);
    const bool two_words = qtri_has_two_words(o);
    const ptrdiff_t row = p->row - surface->first_row;
    w->pixel = surface->pixels + row * surface->pitch + (ptrdiff_t)bytes * p->column;
    w->depth = qtri_tests_depth(o)
                   ? qtri_small_depths(w->state) + row * (ptrdiff_t)w->state->depth_pitch +
                         (ptrdiff_t)depth_bytes * p->column
                   : (uint8_t *)0;
    w->apart = (uintptr_t)w->pixel - (uintptr_t)w->depth;
    w->x = p->column;
    w->y = p->row;
    w->z = p->z.at + QTRI_DEPTH_HALF;
    w->z_step = p->z.dx;
    /* NOLINTBEGIN(clang-analyzer-core.uninitialized.Assign): what options ask for is set */
    w->c = varies ? rows->c.at : 0;
    w->c_step = varies ? rows->c.dx : 0;
    w->c_other = w->c_step;
    w->g = two_words ? rows->g.at : 0;
    w->g_step = two_words ? rows->g.dx : 0;
    w->u = textured && !curved ? rows->u.at : 0;
    w->u_step = textured && !curved ? rows->u.dx : 0;
    w->v = textured && !curved ? rows->v.at : 0;
    w->v_step = textured && !curved ? rows->v.dx : 0;
    w->u_bend = textured && curved ? 2 * curves->u.xx : 0;
    w->v_bend = textured && curved ? 2 * curves->v.xx : 0;
    w->alpha = o->vertex_alpha ? rows->alpha.at : 0;
    w->alpha_step = o->vertex_alpha ? rows->alpha.dx : 0;
    /* NOLINTEND(clang-analyzer-core.uninitialized.Assign) */
}

/* Draws the row's pixels from column x to `end`, piece by piece where light or colours bend. */
QTRI_BODY void qtri_small_draw_pieces(const qtri_options *o, qtri_pixel_body *pixel,
                                      qtri_pixel_walk *w, const qtri_small_curves *curves,
                                      const qtri_small_color_curves *colors, bool has_pieces,
                                      bool curved, uint32_t x, uint32_t end)
{
    while (!o->fog || x != end) {
        uint32_t count = end - x;
        if (has_pieces) {
            if (qtri_small_shares_loop(o)) {
                QTRI_BODY_READ_AGAIN();
            }
            const uint32_t from = x - QTRI_SMALL_REACH;
            count = qtri_is_lit(o) ? qtri_small_curves_set_light(w, curves, from, count)
                                   : qtri_small_curves_set_colors(o, w, colors, from, count);
        }
        if (curved && qtri_is_textured(o)) {
            qtri_small_pixels(o, pixel, w, true, (int32_t)count);
        } else {
            qtri_small_pixels(o, pixel, w, false, (int32_t)count);
        }
        x += count;
        if (!has_pieces || x == end) {
            break;
        }
    }
}

/* Sets fog along columns *x..*end-1, whatever is visible of them, unless the row `goes_on` behind
   others, and leaves of them those that are visible. */
QTRI_BODY void qtri_small_fog_row(const qtri_options *o, qtri_pixel_walk *w,
                                  const qtri_small_place *p, bool curved, bool goes_on, uint32_t *x,
                                  uint32_t *end)
{
    if (!goes_on) {
        uint32_t step;
        w->fog = qtri_fog_along(&step, w->state->fog, w->z, w->z_step, *end - *x);
        w->fog_step = step;
    }
    if (p->cut) {
        const uint32_t first = (uint32_t)qtri_small_clamp(p->left, (int32_t)*x, (int32_t)*end);
        QTRI_RARELY();
        *end = (uint32_t)qtri_small_clamp(p->right, (int32_t)first, (int32_t)*end);
        qtri_small_step(o, w, first - *x, !curved, true);
        qtri_walk_move(o, w, first - *x);
        *x = first;
    }
}

/* Draws a row, or the part of it up to where it is divided: columns x..end-1, of `span`; returns
   the column where the walk is then. */
QTRI_BODY uint32_t qtri_small_draw_row(const qtri_options *o, qtri_pixel_body *pixel,
                                       qtri_pixel_walk *w, const qtri_small_place *p,
                                       const qtri_small_curves *curves,
                                       const qtri_small_color_curves *colors,
                                       qtri_small_division *division, bool has_pieces, bool curved,
                                       uint8_t *span, uint32_t x, uint32_t end)
{
    const bool textured = qtri_is_textured(o), divides = curved && qtri_small_divides(o);
    if (o->fog) {
        qtri_small_fog_row(o, w, p, curved, divides && division->goes_on != 0, &x, &end);
    }
    if (divides && division->log2 != 0) {
        QTRI_RARELY();
        end = qtri_small_divide(division, x, end, span);
        w->u_bend = textured ? 2 * curves->u.xx : 0;
        w->v_bend = textured ? 2 * curves->v.xx : 0;
    }
    if (curved && textured) {
        qtri_small_curves_begin(w, curves, x - QTRI_SMALL_REACH);
    }
    qtri_small_draw_pieces(o, pixel, w, curves, colors, has_pieces, curved, x, end);
    return end;
}

/*
 * Draws all rows. From the end of a row the walk moves to the start of the next, so that nothing
 * else is stepped. Curved: texture coordinates, light or colours follow curves.
 */
QTRI_BODY void qtri_small_fill(const qtri_options *o, qtri_pixel_body *pixel, qtri_pixel_walk *w,
                               const qtri_small_place *p, const qtri_small_rows *rows,
                               qtri_small_curves *curves, qtri_small_color_curves *colors,
                               qtri_small_division *division, bool curved)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t bytes = qtri_pixel_bytes(o), depth_bytes = qtri_depth_size(o, surface);
    const bool tests = qtri_tests_depth(o), paired = qtri_is_paired(o);
    const bool textured = qtri_is_textured(o), more = qtri_small_has_more(o);
    /* For the generic pipeline; a variable of others', too, would cost S8 4 % at -Os. */
    const bool linear = QTRI_SMALL_ANY && textured && !curved;
    const bool is_plain = QTRI_SMALL_ANY && !curved && !o->fog;
    const bool has_pieces =
        curved && (qtri_is_lit(o) ? curves->light_piece != 0
                                  : o->shade == QTRI_COLORS && (!textured || colors->piece != 0));
    const bool divides = curved && qtri_small_divides(o);
    const ptrdiff_t pitch = surface->pitch, depth_pitch = w->state->depth_pitch;
    const uintptr_t skew = (uintptr_t)pitch - (uintptr_t)depth_pitch;
    uint8_t *span = p->span;
    uint32_t at = QTRI_SMALL_REACH; /* where the walk is, as spans count */
    qtri_small_begin_rows(o, w, p, rows, curves, curved);
    for (;;) {
        uint32_t x = span[0], end = span[1];
        span += 2;
        if (qtri_small_shares_loop(o)) {
            QTRI_BODY_READ_AGAIN();
        }
        if (x < end) {
            qtri_small_step(o, w, x - at, QTRI_SMALL_ANY ? linear : !curved, more);
            if (!paired) {
                w->pixel += (ptrdiff_t)(int32_t)(x - at) * (ptrdiff_t)bytes;
            }
            if (tests) {
                w->depth += (ptrdiff_t)(int32_t)(x - at) * (ptrdiff_t)depth_bytes;
            }
            if (is_plain) {
                at = end;
                qtri_small_pixels(o, pixel, w, false, (int32_t)(end - x));
            } else {
                at = qtri_small_draw_row(o, pixel, w, p, curves, colors, division, has_pieces,
                                         curved, span - 2, x, end);
            }
        } else if (x == QTRI_SMALL_STOP) {
            return;
        }
        if (divides && division->goes_on != 0) {
            QTRI_RARELY();
            span -= 2;
            continue;
        }
        w->z += p->z.dy;
        if (QTRI_SMALL_ANY || qtri_varies(o)) {
            w->c += rows->c.dy;
        }
        if (QTRI_SMALL_ANY ? linear : textured && !curved) {
            w->u += rows->u.dy;
            w->v += rows->v.dy;
        }
        if (curved) {
            qtri_small_curves_next_row(o, curves);
            if (o->shade == QTRI_COLORS && has_pieces) {
                qtri_small_color_curves_next_row(colors);
            }
        }
        if (more) {
            if (qtri_has_two_words(o)) {
                w->g += rows->g.dy;
            }
            if (o->vertex_alpha) {
                w->alpha += rows->alpha.dy;
            }
        }
        if (paired) {
            w->apart += skew;
        } else {
            w->pixel += pitch;
        }
        if (tests) {
            w->depth += qtri_small_shares_loop(o) ? w->state->depth_pitch : depth_pitch;
        }
        w->y++;
    }
}

/* The set-up for a function of the library: a copy where the original may be in registers. */
QTRI_BODY const qtri_small_place *qtri_small_copy(qtri_small_place *copy, const qtri_small_place *p)
{
    if (!QTRI_SMALL_IN_PLACE) {
        return p;
    }
    *copy = *p;
    return copy;
}

/* Whether curves have a loop of their own: one for all would cost linear colours 6 %. */
QTRI_BODY bool qtri_small_has_two_loops(const qtri_options *o)
{
#ifdef QTRI_PIPELINE_IS_ANY
    (void)o;
    return false;
#else
    return QTRI_SMALL_IN_PLACE || (o->shade == QTRI_COLORS && !qtri_is_textured(o));
#endif
}

/* Sets colours, linear on the screen; false: the lack of perspective would show. */
QTRI_BODY bool qtri_small_set_rows_colors(const qtri_options *o, qtri_small_rows *rows,
                                          const qtri_small_place *p, qtri_small_place *copy,
                                          const qtri_small *t)
{
    qtri_small_ramp c = {0, 0, 0}, g = {0, 0, 0}; /* copies, so that others need not be in memory */
    bool is_set;
    if (qtri_is_textured(o)) {
        is_set = qtri_small_set_weights(&c, &g, qtri_small_copy(copy, p), t, qtri_light_half(o));
    } else if (qtri_kind_of(o) == QTRI_IN_565) {
        is_set = QTRI_SMALL_IN_PLACE && qtri_small_keeps_fields(p)
                     ? qtri_setup_set_colors_565(&c, p, t, o, true)
                     : qtri_small_set_colors_565(&c, qtri_small_copy(copy, p), t);
    } else if (qtri_kind_of(o) == QTRI_IN_GRAY) {
        is_set = qtri_small_set_colors_gray(&c, qtri_small_copy(copy, p), t);
    } else {
        is_set = qtri_small_set_colors_888(&c, &g, qtri_small_copy(copy, p), t);
    }
    rows->c = c;
    rows->g = g;
    return is_set;
}

/* Draws a triangle. False: it is large, and nothing was drawn. */
QTRI_BODY bool qtri_small_triangle_draw(const qtri_options *o, qtri_pixel_body *pixel,
                                        qtri_small *t)
{
    uint8_t spans[QTRI_SMALL_SPANS];
    qtri_small_place p, copy;
    qtri_small_rows rows; /* set as options need them */
    qtri_small_curves curves;
    qtri_small_color_curves colors;
    qtri_small_division division;
#ifdef QTRI_PIPELINE_IS_ANY_LOOP
    /* The whole walk is not cleared: that is 165 instructions. */
    qtri_pixel_walk w;
    const qtri_octave none = QTRI_BODY_ZERO;
    const qtri_small_ramp flat = QTRI_BODY_ZERO;
    w.octave = none;
    w.fog = w.fog_step = 0; /* stepped with whatever few have */
    rows.c = flat;          /* stepped in any case */
#else
    qtri_pixel_walk w = QTRI_BODY_ZERO;
#endif
    qtri_draw_state *state = t->state;
    bool has_curve = false, is_curved = false; /* light or colours; anything */
    const qtri_small_found found = QTRI_SMALL_SETUP(find)(&p, spans, t);
    if (found != QTRI_SMALL_FOUND) {
        return found == QTRI_SMALL_NOTHING;
    }
    if (o->mipmapped && !qtri_small_set_level(qtri_small_copy(&copy, &p), t)) {
        return false;
    }
    qtri_walk_begin(o, &w, state);
    if (t->light != NULL && (o->shade != QTRI_FLAT || !qtri_is_textured(o))) {
        t->light_q15 =
            t->light(t->from, t->indices, t->v[0], t->v[1 + p.turned], t->v[2 - p.turned]);
    }
    if (o->per_pixel && !qtri_small_is_lit_by_vertex(&p, t)) {
        return false;
    }
    if (o->shade == QTRI_TINT || (o->shade == QTRI_FLAT && !qtri_is_textured(o))) {
        w.color = qtri_walk_color(o, state->surface, qtri_small_color(t));
    }
    if (qtri_is_lit(o)) {
        if (!QTRI_SMALL_SETUP(light_is_linear)(&p, t, o)) {
            QTRI_RARELY();
            has_curve = true;
        }
        QTRI_SMALL_SETUP(set_light)(&rows.c, &p, t, qtri_light_half(o));
        if (qtri_uses_table(o) && !state->has_table) {
            QTRI_RARELY();
            qtri_draw_state_set_table(state);
        }
    }
    if (o->shade == QTRI_COLORS) {
        if (!qtri_small_set_rows_colors(o, &rows, &p, &copy, t)) {
            QTRI_RARELY();
            if (o->per_pixel || /* large ones are lit more closely */
                !qtri_small_set_color_curves(&colors, &division, qtri_small_copy(&copy, &p), t)) {
                return false;
            }
            has_curve = true;
        }
        if (qtri_is_textured(o)) {
            colors.piece = has_curve ? colors.piece : 0;
        }
    }
    if (o->vertex_alpha) {
        qtri_small_ramp alpha;
        if (!qtri_small_set_alpha(&alpha, qtri_small_copy(&copy, &p), t)) {
            return false;
        }
        rows.alpha = alpha;
    }
    if (has_curve || (qtri_is_textured(o) &&
                      !QTRI_SMALL_SETUP(set_linear_texture)(&rows.u, &rows.v, &p, t, o))) {
        QTRI_RARELY();
        const qtri_small_place *kept = qtri_small_copy(&copy, &p);
        if (o->shade == QTRI_COLORS && !qtri_is_textured(o)) {
            is_curved = true;
        } else {
            if (!(qtri_is_textured(o)
                      ? qtri_small_set_curves(&curves, &division, kept, t, o, has_curve)
                      : qtri_small_set_light_curve(&curves, kept, t, o))) {
                return false;
            }
            is_curved = curves.is_curved;
            if (!is_curved) {
                rows.u = curves.linear[0];
                rows.v = curves.linear[1];
            }
        }
    }
    if (!o->fog && p.cut && !qtri_small_cut(p.span, p.left, p.right)) {
        return true;
    }
    if (qtri_small_has_two_loops(o) && is_curved) {
        qtri_small_fill(o, pixel, &w, QTRI_SMALL_IN_PLACE ? &copy : &p, &rows, &curves, &colors,
                        &division, true);
        return true;
    }
    qtri_small_fill(o, pixel, &w, &p, &rows, &curves, &colors, &division,
                    !qtri_small_has_two_loops(o) && (qtri_is_textured(o) || qtri_varies(o)) &&
                        is_curved);
    return true;
}

#endif
