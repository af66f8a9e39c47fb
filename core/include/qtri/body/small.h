/* SPDX-License-Identifier: MIT */
/*
 * A small triangle of a mesh, from its vertices on the screen to its pixels. Internal, part of the
 * pipelines' body (pipeline_make.h).
 */
#ifndef QTRI_BODY_SMALL_H
#define QTRI_BODY_SMALL_H

#include "pixel.h"
#include "small_setup.h"

#ifdef __cplusplus
extern "C" {
#endif

/* In place where code need not be small. */
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && !defined(QTRI_PIPELINE_IS_ANY)
#define QTRI_SMALL_IN_PLACE    true
#define QTRI_SMALL_SETUP(name) qtri_setup_##name
#else
#define QTRI_SMALL_IN_PLACE    false
#define QTRI_SMALL_SETUP(name) qtri_small_##name
#endif

/* What rows begin with. */
typedef struct qtri_small_rows {
    qtri_small_ramp c, g, alpha, u, v;
} qtri_small_rows;

QTRI_BODY int32_t qtri_small_product(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a * (uint32_t)b);
}

/* 1 - 1 / (1 + e) = e - e^2 + e^3 - e^4, 16 bits, |e| <= 1/4 and what is left of a triangle. */
QTRI_BODY int32_t qtri_small_w(uint32_t e_q26)
{
    const int32_t e = (int32_t)e_q26 >> 10;
    const int32_t w = e - (qtri_small_product(e, e - (qtri_small_product(e, e) >> 16)) >> 16);
    return e - (qtri_small_product(e, w) >> 16);
}

/* l / (1 + e). */
QTRI_BODY uint32_t qtri_small_curved(uint32_t l, int32_t w)
{
    return l - (uint32_t)(qtri_small_product((int32_t)l >> 8, w) >> 8);
}

/* difference / n, n of 1 to 16. */
QTRI_BODY uint32_t qtri_small_share(uint32_t difference, uint32_t n)
{
    const int32_t d = (int32_t)difference;
    const int32_t part = qtri_small_part[n];
    return (uint32_t)(qtri_small_product(d >> 15, part) +
                      (qtri_small_product(d & 0x7FFF, part) >> 15));
}

/* Goes on by n pixels. */
QTRI_BODY void qtri_small_step(const qtri_options *o, qtri_pixel_walk *w, uint32_t n)
{
    if (qtri_needs_depth(o)) {
        w->z += n * w->z_step;
    }
    if (qtri_is_textured(o)) {
        w->u += n * w->u_step;
        w->v += n * w->v_step;
    }
    if (qtri_varies(o)) {
        w->c += n * w->c_step;
    }
    if (qtri_has_two_words(o)) {
        w->g += n * w->g_step;
    }
    if (o->vertex_alpha) {
        w->alpha += n * w->alpha_step;
    }
    if (o->fog) {
        w->fog += n * w->fog_step;
    }
    if (qtri_needs_place(o)) {
        w->x += (int32_t)n;
    }
}

/* The pixel that lies `apart` from its depth. */
QTRI_BODY uint8_t *qtri_small_pixel_of(const qtri_pixel_walk *w)
{
    return (uint8_t *)((uintptr_t)w->depth + w->apart); /* NOLINT(performance-no-int-to-ptr) */
}

/* A row's pixels from a walk at the first one on; `count` is not 0. Paired: one pointer, which also
   tells the end. */
QTRI_BODY void qtri_small_pixels(const qtri_options *o, qtri_pixel_walk *w, int32_t count)
{
    const bool paired = qtri_is_paired(o);
    const uint32_t bytes = qtri_pixel_bytes(o);
    const uint8_t *end = paired ? w->depth + (uint32_t)count * bytes : w->depth;
    do {
        qtri_pixel_at(o, w, false, paired ? qtri_small_pixel_of(w) : w->pixel, w->depth);
        if (paired) {
            w->depth += bytes;
            QTRI_BODY_BARRIER(w->depth);
        } else {
            qtri_walk_move(o, w, 1);
        }
    } while (paired ? w->depth != end : --count != 0);
}

/* Columns of a row that may be drawn: x..end - 1, or those of them within the bounds. */
typedef struct qtri_small_columns {
    uint32_t first, end;
} qtri_small_columns;

QTRI_BODY qtri_small_columns qtri_small_visible(const qtri_small_place *p, uint32_t x, uint32_t end)
{
    qtri_small_columns c;
    c.first = x;
    c.end = end;
    if (p->cut) {
        QTRI_RARELY();
        c.first = (uint32_t)qtri_small_clamp(p->left, (int32_t)x, (int32_t)end);
        c.end = (uint32_t)qtri_small_clamp(p->right, (int32_t)c.first, (int32_t)end);
    }
    return c;
}

/* Draws what is visible of the next `count` pixels, from column x on; returns the column after the
   last pixel that the walk has passed. Not to be called with x beyond visible->end. */
QTRI_BODY uint32_t qtri_small_pixels_within(const qtri_options *o, qtri_pixel_walk *w,
                                            const qtri_small_columns *visible, uint32_t x,
                                            uint32_t count)
{
    if (x < visible->first) {
        const uint32_t hidden = visible->first - x < count ? visible->first - x : count;
        QTRI_RARELY();
        qtri_small_step(o, w, hidden);
        qtri_walk_move(o, w, hidden);
        x += hidden;
        count -= hidden;
    }
    count = visible->end - x < count ? visible->end - x : count;
    if (count != 0) {
        qtri_small_pixels(o, w, (int32_t)count);
    }
    return x + count;
}

/* The walk goes on from the end of a row to the start of the next, so that it alone is stepped. */
QTRI_BODY void qtri_small_fill(const qtri_options *o, qtri_pixel_walk *w, const qtri_small_place *p,
                               const qtri_small_rows *rows)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t bytes = qtri_pixel_bytes(o), depth_bytes = qtri_depth_size(o, surface);
    const bool tests = qtri_tests_depth(o), paired = qtri_is_paired(o);
    const bool textured = qtri_is_textured(o), varies = qtri_varies(o);
    const bool two_words = qtri_has_two_words(o);
    const ptrdiff_t row = p->row - surface->first_row;
    const ptrdiff_t pitch = surface->pitch, depth_pitch = w->state->depth_pitch;
    const uintptr_t skew = (uintptr_t)pitch - (uintptr_t)depth_pitch;
    const uint8_t *span = p->span;
    uint32_t at = 0; /* the column */
    w->pixel = surface->pixels + row * pitch + (ptrdiff_t)bytes * p->column;
    w->depth =
        tests ? (uint8_t *)surface->depth + row * depth_pitch + (ptrdiff_t)depth_bytes * p->column
              : (uint8_t *)0;
    w->apart = (uintptr_t)w->pixel - (uintptr_t)w->depth;
    w->x = p->column;
    w->y = p->row;
    w->z = p->z.at + QTRI_DEPTH_HALF;
    w->z_step = p->z.dx;
    /* NOLINTBEGIN(clang-analyzer-core.uninitialized.Assign): what options ask for is set */
    w->c = varies ? rows->c.at : 0;
    w->c_step = varies ? rows->c.dx : 0;
    w->g = two_words ? rows->g.at : 0;
    w->g_step = two_words ? rows->g.dx : 0;
    w->u = textured ? rows->u.at : 0;
    w->u_step = textured ? rows->u.dx : 0;
    w->v = textured ? rows->v.at : 0;
    w->v_step = textured ? rows->v.dx : 0;
    w->alpha = o->vertex_alpha ? rows->alpha.at : 0;
    w->alpha_step = o->vertex_alpha ? rows->alpha.dx : 0;
    /* NOLINTEND(clang-analyzer-core.uninitialized.Assign) */
    w->fog = 0;
    w->fog_step = 0;
    for (;;) {
        const uint32_t x = span[0], end = span[1];
        span += 2;
        if (x < end) {
            const uint32_t gap = x - at;
            qtri_small_step(o, w, gap);
            if (!paired) {
                w->pixel += (ptrdiff_t)(int32_t)gap * (ptrdiff_t)bytes;
            }
            if (tests) {
                w->depth += (ptrdiff_t)(int32_t)gap * (ptrdiff_t)depth_bytes;
            }
            if (o->fog) {
                const uint32_t last = w->z + (end - x - 1) * w->z_step;
                const uint32_t z = w->z;
                w->fog = qtri_fog_share(w->state->fog, z);
                w->fog_step = qtri_small_fog_step(w->fog, qtri_fog_share(w->state->fog, last),
                                                  (int32_t)(end - x));
                w->fog += 0x8000u;
                const qtri_small_columns visible = qtri_small_visible(p, x, end);
                at = qtri_small_pixels_within(o, w, &visible, x, end - x);
            } else {
                at = end;
                qtri_small_pixels(o, w, (int32_t)(end - x));
            }
        } else if (x == QTRI_SMALL_STOP) {
            return;
        }
        w->z += p->z.dy;
        if (varies) {
            w->c += rows->c.dy;
        }
        if (two_words) {
            w->g += rows->g.dy;
        }
        if (textured) {
            w->u += rows->u.dy;
            w->v += rows->v.dy;
        }
        if (o->vertex_alpha) {
            w->alpha += rows->alpha.dy;
        }
        if (paired) {
            w->apart += skew;
        } else {
            w->pixel += pitch;
        }
        if (tests) {
            w->depth += depth_pitch;
        }
        w->y++;
    }
}

/* The same where u and v follow perspective. */
QTRI_BODY void qtri_small_fill_curved(const qtri_options *o, qtri_pixel_walk *w,
                                      const qtri_small_place *p, const qtri_small_rows *rows,
                                      const qtri_small_texture *uv)
{
    const qtri_surface *surface = w->state->surface;
    const uint32_t bytes = qtri_pixel_bytes(o), depth_bytes = qtri_depth_size(o, surface);
    const bool tests = qtri_tests_depth(o), varies = qtri_varies(o);
    const bool two_words = qtri_has_two_words(o);
    const uint32_t piece = uv->piece;
    const ptrdiff_t row = p->row - surface->first_row;
    uint8_t *pixels = surface->pixels + row * surface->pitch + (ptrdiff_t)bytes * p->column;
    uint8_t *depths = tests ? (uint8_t *)surface->depth + row * w->state->depth_pitch +
                                  (ptrdiff_t)depth_bytes * p->column
                            : (uint8_t *)0;
    const uint8_t *span = p->span;
    uint32_t y = 0;
    w->z_step = p->z.dx;
    w->c_step = varies ? rows->c.dx : 0;
    w->g_step = two_words ? rows->g.dx : 0;
    w->alpha_step = o->vertex_alpha ? rows->alpha.dx : 0;
    for (;; y++, span += 2) {
        QTRI_BODY_BARRIER(y); /* or GCC 12 steps all that y is multiplied by, in memory */
        uint32_t x = span[0];
        const uint32_t end = span[1];
        if (x >= end) {
            if (x == QTRI_SMALL_STOP) {
                return;
            }
            continue;
        }
        w->y = p->row + (int32_t)y;
        w->z = p->z.at + QTRI_DEPTH_HALF + x * w->z_step + y * p->z.dy;
        w->c = varies ? rows->c.at + x * rows->c.dx + y * rows->c.dy : 0;
        w->g = two_words ? rows->g.at + x * w->g_step + y * rows->g.dy : 0;
        w->alpha = o->vertex_alpha ? rows->alpha.at + x * w->alpha_step + y * rows->alpha.dy : 0;
        w->pixel = pixels + (ptrdiff_t)y * surface->pitch + x * bytes;
        if (tests) {
            w->depth = depths + (ptrdiff_t)y * w->state->depth_pitch + x * depth_bytes;
            w->apart = (uintptr_t)w->pixel - (uintptr_t)w->depth;
        }
        if (qtri_needs_place(o)) {
            w->x = p->column + (int32_t)x;
        }
        if (o->fog) {
            const uint32_t last = w->z + (end - x - 1) * w->z_step;
            const uint32_t z = w->z;
            w->fog = qtri_fog_share(w->state->fog, z);
            w->fog_step = qtri_small_fog_step(w->fog, qtri_fog_share(w->state->fog, last),
                                              (int32_t)(end - x));
            w->fog += 0x8000u;
        }
        uint32_t e = uv->e.at + x * uv->e.dx + y * uv->e.dy;
        uint32_t lu = uv->u.at + x * uv->u.dx + y * uv->u.dy;
        uint32_t lv = uv->v.at + x * uv->v.dx + y * uv->v.dy;
        const qtri_small_columns visible = qtri_small_visible(p, x, end);
        int32_t share = qtri_small_w(e);
        uint32_t u = qtri_small_curved(lu, share);
        uint32_t v = qtri_small_curved(lv, share);
        do {
            /* To a pixel of the row: outside of it a needle's e is anything. Steps are found before
               they go left: a piece may pass half a repeat and more. */
            const uint32_t left = end - x;
            const uint32_t count = left > piece ? piece : left;
            const uint32_t n = left > piece ? piece : left - 1;
            w->u = uv->u0 + (u << uv->u_up);
            w->v = uv->v0 + (v << uv->v_up);
            w->u_step = 0;
            w->v_step = 0;
            if (n != 0) {
                const uint32_t u_before = u, v_before = v;
                e += n * uv->e.dx;
                lu += n * uv->u.dx;
                lv += n * uv->v.dx;
                share = qtri_small_w(e);
                u = qtri_small_curved(lu, share);
                v = qtri_small_curved(lv, share);
                w->u_step = qtri_small_share(u - u_before, n) << uv->u_up;
                w->v_step = qtri_small_share(v - v_before, n) << uv->v_up;
            }
            x = qtri_small_pixels_within(o, w, &visible, x, count);
        } while (x != visible.end);
    }
}

/* The place for a function of the library: where the pipeline has it in registers, a copy, so that
   it need not be in memory elsewhere. */
QTRI_BODY const qtri_small_place *qtri_small_kept(qtri_small_place *copy, const qtri_small_place *p)
{
    if (!QTRI_SMALL_IN_PLACE) {
        return p;
    }
    *copy = *p;
    return copy;
}

/* False: it is large, and nothing was drawn. */
QTRI_BODY bool qtri_small_triangle_draw(const qtri_options *o, qtri_small *t)
{
    uint8_t spans[QTRI_SMALL_SPANS];
    qtri_small_place p, copy;
    qtri_small_rows rows; /* as options ask */
    qtri_small_texture uv;
    qtri_pixel_walk w = QTRI_BODY_ZERO;
    qtri_draw_state *state = t->state;
    const qtri_small_found found = QTRI_SMALL_SETUP(find)(&p, spans, t);
    if (found != QTRI_SMALL_FOUND) {
        return found == QTRI_SMALL_NOTHING;
    }
    if (o->mipmapped && !qtri_small_set_level(qtri_small_kept(&copy, &p), t)) {
        return false;
    }
    qtri_walk_begin(o, &w, state);
    if (t->light != NULL && (o->shade != QTRI_FLAT || !qtri_is_textured(o))) {
        t->light_q15 =
            t->light(t->from, t->indices, t->v[0], t->v[1 + p.turned], t->v[2 - p.turned]);
    }
    if (o->per_pixel && !qtri_small_is_lit_by_vertex(t)) {
        return false;
    }
    if (o->shade == QTRI_TINT || (o->shade == QTRI_FLAT && !qtri_is_textured(o))) {
        w.color = qtri_walk_color(o, state->surface, qtri_small_color(t));
    }
    if (qtri_is_lit(o)) {
        if (!QTRI_SMALL_SETUP(light_is_linear)(&p, t, o)) {
            return false;
        }
        QTRI_SMALL_SETUP(set_light)(&rows.c, &p, t, qtri_light_half(o));
        if (qtri_uses_table(o) && !state->has_table) {
            QTRI_RARELY();
            qtri_draw_state_set_table(state);
        }
    }
    if (o->shade == QTRI_COLORS && !qtri_is_textured(o) && qtri_kind_of(o) == QTRI_IN_565) {
        if (!QTRI_SMALL_SETUP(set_colors_565)(&rows.c, &p, t, o)) {
            return false;
        }
    } else if (o->shade == QTRI_COLORS) {
        qtri_small_ramp c, g = {0, 0, 0}; /* copies, so that the others need not be in memory */
        const qtri_small_place *kept = qtri_small_kept(&copy, &p);
        if (!(qtri_is_textured(o)
                  ? qtri_small_set_weights(
                        &c, &g, kept, t,
                        (qtri_kind_of(o) == QTRI_IN_565 ? (uint32_t)1 << 17 : 0x8000u))
              : qtri_kind_of(o) == QTRI_IN_GRAY ? qtri_small_set_colors_gray(&c, kept, t)
                                                : qtri_small_set_colors_888(&c, &g, kept, t))) {
            return false;
        }
        rows.c = c;
        rows.g = g;
    }
    if (o->vertex_alpha) {
        qtri_small_ramp alpha;
        if (!qtri_small_set_alpha(&alpha, qtri_small_kept(&copy, &p), t)) {
            return false;
        }
        rows.alpha = alpha;
    }
    if (qtri_is_textured(o) && !QTRI_SMALL_SETUP(set_linear_texture)(&rows.u, &rows.v, &p, t, o)) {
        QTRI_RARELY();
        qtri_small_set_texture(&uv, qtri_small_kept(&copy, &p), t, o);
        w.axis = uv.axis;
        if (uv.curved) {
            qtri_small_fill_curved(o, &w, &p, &rows, &uv);
            return true;
        }
        rows.u = uv.u;
        rows.v = uv.v;
    }
    if (!o->fog && p.cut && !qtri_small_cut(p.span, p.left, p.right)) {
        return true;
    }
    qtri_small_fill(o, &w, &p, &rows);
    return true;
}

#ifdef __cplusplus
}
#endif

#endif
