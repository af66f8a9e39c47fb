/* SPDX-License-Identifier: MIT */
/*
 * A small triangle of a mesh, four samples a pixel (antialias.h). Internal, part of the pipelines'
 * body (pipeline_make.h).
 *
 * Samples of a pixel are one below the other, a quarter of a pixel apart: edges are walked in
 * quarters of rows, and a row has the first and end columns of its four as bytes of two words. A
 * pixel's column in all four lanes with bit 7 set, less such a word, leaves bit 7 of the samples
 * whose column is at or before it: four comparisons in one subtraction.
 */
#ifndef QTRI_BODY_SMALL_SAMPLES_H
#define QTRI_BODY_SMALL_SAMPLES_H

#include "small.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { QTRI_SMALL_ROWS = 2 * QTRI_SMALL_MIDDLE + 1 };

#define QTRI_SMALL_LANES 0x01010101u

/* First and end columns of samples by rows, and depth at samples 3 and 1 less the centre's. */
typedef struct qtri_small_samples {
    uint32_t left[QTRI_SMALL_ROWS], right[QTRI_SMALL_ROWS]; /* sample k: bits 8 k.. */
    int32_t first, rows; /* index of the first row, and how many */
    uint32_t z_p, z_q;
} qtri_small_samples;

/* A ramp at centres, and its values at samples 3 and 1 less that at the centre. */
typedef struct qtri_small_sampled {
    qtri_small_ramp r;
    uint32_t p, q;
} qtri_small_sampled;

typedef struct qtri_small_sampled_values {
    qtri_small_sampled c, g, alpha, u, v;
} qtri_small_sampled_values;

/* In small_samples.c: as qtri_small_find(). */
qtri_small_found qtri_small_samples_find(qtri_small_place *p, qtri_small_samples *s, qtri_small *t);
/* Cuts rows to the bounds. */
void qtri_small_samples_cut(qtri_small_samples *s, int32_t left, int32_t right);
/* Whether the centre of a pixel is covered: column and row as those of the place. */
bool qtri_small_covers_center(const qtri_small_place *p, int32_t column, int32_t row);
/* As qtri_small_ramp_set(). */
void qtri_small_set_sampled(qtri_small_sampled *r, const qtri_small_place *p, uint32_t value,
                            int32_t f1, int32_t f2, int32_t up);

/* Moves the base to the centre (0), from there to sample 3 (1), and from there to sample 1 (2). */
QTRI_BODY void qtri_small_move_place(qtri_small_place *p, int to)
{
    p->x += to == 1 ? 32 : to == 2 ? 64 : 0;
    p->y += to == 1 ? 96 : to == 2 ? -128 : 0;
}

/* Sets one of three parts by a ramp at the centre (0), at sample 3 (1) or at sample 1 (2). */
QTRI_BODY void qtri_small_sampled_set(qtri_small_sampled *r, int at, const qtri_small_ramp *there)
{
    if (at == 0) {
        r->r = *there;
    } else if (at == 1) {
        r->p = there->at - r->r.at;
    } else {
        r->q = there->at - r->r.at;
    }
}

/* The least of four bytes. */
QTRI_BODY uint32_t qtri_samples_least(uint32_t word)
{
    uint32_t a = word & 255, b = word >> 8 & 255;
    const uint32_t c = word >> 16 & 255, d = word >> 24;
    a = a < b ? a : b;
    b = c < d ? c : d;
    return a < b ? a : b;
}

/* Whether colour varies inside a pixel. */
QTRI_BODY bool qtri_small_varies_in_pixel(const qtri_options *o)
{
    return qtri_is_textured(o) || qtri_varies(o) || o->vertex_alpha || o->fog ||
           o->fragment != NULL;
}

/* The place where a pixel takes its colour: the centre, as between two opposite samples, or the
   first sample that is covered. */
QTRI_BODY int32_t qtri_small_shading_place(const qtri_small_place *p, uint32_t samples,
                                           int32_t column, int32_t row)
{
    if ((samples >> 24 & samples & QTRI_SAMPLE_0) != 0 ||
        (samples >> 8 & samples & QTRI_SAMPLE_1) != 0 || samples == 0 ||
        qtri_small_covers_center(p, column, row)) {
        return QTRI_CENTER;
    }
    return (samples & QTRI_SAMPLE_0) != 0   ? 0
           : (samples & QTRI_SAMPLE_1) != 0 ? 1
           : (samples & QTRI_SAMPLE_2) != 0 ? 2
                                            : 3;
}

/* A value at a place less that at the centre. */
QTRI_BODY uint32_t qtri_small_sampled_offset(const qtri_small_sampled *r, int32_t place)
{
    return qtri_samples_more(place, r->p, r->q);
}

/* Moves linear values of the walk from the centre to a place, or back by the opposite one. */
QTRI_BODY void qtri_small_move_walk(const qtri_options *o, qtri_pixel_walk *w,
                                    const qtri_small_sampled_values *v, int32_t place, bool with_uv,
                                    bool with_c)
{
    w->z_place = qtri_samples_more(place, w->z_p, w->z_q);
    if (with_uv) {
        w->u += qtri_small_sampled_offset(&v->u, place);
        w->v += qtri_small_sampled_offset(&v->v, place);
    }
    if (with_c) {
        w->c += qtri_small_sampled_offset(&v->c, place);
    }
    if (qtri_has_two_words(o)) {
        w->g += qtri_small_sampled_offset(&v->g, place);
    }
    if (o->vertex_alpha) {
        w->alpha += qtri_small_sampled_offset(&v->alpha, place);
    }
}

/* The sample on the other side of the centre, where a linear value differs by as much less. */
QTRI_BODY int32_t qtri_small_opposite(int32_t place)
{
    return 3 - place;
}

/* Fog at a pixel's place. */
QTRI_BODY void qtri_small_set_fog(const qtri_options *o, qtri_pixel_walk *w)
{
    if (o->fog && w->samples != 0) {
        w->fog = qtri_fog_share(w->state->fog, w->z + w->z_place) + 0x8000u;
    }
}

/* Draws the walk's pixel with its colour at a place, and moves to the next. */
QTRI_BODY void qtri_small_samples_pixel(const qtri_options *o, qtri_pixel_body *pixel,
                                        qtri_pixel_walk *w, const qtri_small_sampled_values *v,
                                        int32_t place, bool with_uv, bool with_c)
{
    const bool away = qtri_small_varies_in_pixel(o) && place != QTRI_CENTER;
    if (away) {
        qtri_small_move_walk(o, w, v, place, with_uv, with_c);
    }
    qtri_small_set_fog(o, w);
    pixel(w, false, w->pixel, w->depth);
    qtri_walk_move(o, w, 1);
    if (away) {
        qtri_small_move_walk(o, w, v, qtri_small_opposite(place), with_uv, with_c);
        w->z_place = 0;
    }
}

/* Sets pointers and position of the walk, at the base of the first row. */
QTRI_BODY void qtri_small_samples_begin(const qtri_options *o, qtri_pixel_walk *w,
                                        const qtri_small_place *p, const qtri_small_samples *s)
{
    const qtri_surface *surface = w->state->surface;
    const ptrdiff_t row = p->row - surface->first_row;
    w->pixel = surface->pixels + row * surface->pitch +
               (ptrdiff_t)qtri_pixel_step(o) * (ptrdiff_t)p->column;
    w->depth = qtri_tests_depth(o) ? (uint8_t *)surface->depth + row * w->state->depth_pitch +
                                         2 * (ptrdiff_t)p->column
                                   : (uint8_t *)0;
    w->x = p->column;
    w->y = p->row;
    w->z_p = s->z_p;
    w->z_q = s->z_q;
}

/* Moves the walk by columns, also back. */
QTRI_BODY void qtri_small_samples_skip(const qtri_options *o, qtri_pixel_walk *w, int32_t columns)
{
    qtri_small_step(o, w, (uint32_t)columns, true, true);
    w->pixel += (ptrdiff_t)columns * (ptrdiff_t)qtri_pixel_step(o);
    if (qtri_tests_depth(o)) {
        w->depth += (ptrdiff_t)columns * 2;
    }
}

/* A curve's value at a place of the pixel x columns from vertex 0's, by its slopes there. */
QTRI_BODY uint32_t qtri_small_curve_at_place(const qtri_small_curve *c, uint32_t x, int32_t place)
{
    const int32_t dx = (int32_t)(c->dx + 2 * x * c->xx) >> 1;
    const int32_t dy = (int32_t)(c->dy + x * c->xy) >> 1;
    const int32_t a = dx >> 2, b = dy >> 2; /* |dx|, |dy| <= 2^30: three times a quarter fits */
    const int32_t r = dx & 3, s = dy & 3;
    return qtri_small_curve_at(c, x) +
           qtri_samples_more(place, (uint32_t)(a + 3 * b + ((r + 3 * s) >> 2)),
                             (uint32_t)(3 * a - b + ((3 * r - s) >> 2)));
}

/* Draws all rows. Curved: texture coordinates, or light, follow curves, which are evaluated for
   each pixel: that is little of the work of four samples. */
QTRI_BODY void qtri_small_samples_fill(const qtri_options *o, qtri_pixel_body *pixel,
                                       qtri_pixel_walk *w, const qtri_small_place *p,
                                       const qtri_small_samples *s,
                                       const qtri_small_sampled_values *values,
                                       qtri_small_curves *curves, bool curved)
{
    const bool textured = qtri_is_textured(o), varies = qtri_varies(o);
    const bool two_words = qtri_has_two_words(o);
    const bool has_light_curve = qtri_is_lit(o) && curved && curves->light_piece != 0;
    const ptrdiff_t pitch = w->state->surface->pitch, depth_pitch = w->state->depth_pitch;
    const uint32_t *left = &s->left[s->first], *right = &s->right[s->first];
    int32_t at = QTRI_SMALL_MIDDLE; /* where the walk is, as rows count */
    qtri_small_samples_begin(o, w, p, s);
    w->z = p->z.at + QTRI_DEPTH_HALF;
    w->z_step = p->z.dx;
    w->c = varies ? values->c.r.at : 0;
    w->c_step = varies ? values->c.r.dx : 0;
    w->g = two_words ? values->g.r.at : 0;
    w->g_step = two_words ? values->g.r.dx : 0;
    w->u = textured ? values->u.r.at : 0;
    w->u_step = textured ? values->u.r.dx : 0;
    w->v = textured ? values->v.r.at : 0;
    w->v_step = textured ? values->v.r.dx : 0;
    w->alpha = o->vertex_alpha ? values->alpha.r.at : 0;
    w->alpha_step = o->vertex_alpha ? values->alpha.r.dx : 0;
    for (int32_t y = 0; y < s->rows; y++) {
        const uint32_t l = *left++, r = *right++;
        if (l != r) {
            const uint32_t first = qtri_samples_least(l);
            uint32_t in = (first * QTRI_SMALL_LANES | QTRI_SAMPLES_ALL) - l;
            uint32_t out = (first * QTRI_SMALL_LANES | QTRI_SAMPLES_ALL) - r;
            qtri_small_samples_skip(o, w, (int32_t)first - at);
            at = (int32_t)first;
            while ((out & QTRI_SAMPLES_ALL) != QTRI_SAMPLES_ALL) {
                const uint32_t x = (uint32_t)(at - QTRI_SMALL_MIDDLE);
                w->samples = in & ~out & QTRI_SAMPLES_ALL;
                int32_t place = QTRI_CENTER;
                if (qtri_small_varies_in_pixel(o) && w->samples != QTRI_SAMPLES_ALL) {
                    place = qtri_small_shading_place(p, w->samples, (int32_t)x, y);
                }
                if (curved && textured) {
                    w->u = qtri_small_curve_at_place(&curves->u, x, place);
                    w->v = qtri_small_curve_at_place(&curves->v, x, place);
                }
                if (has_light_curve) {
                    w->c = qtri_small_curve_at_place(&curves->c, x, place) >> QTRI_SMALL_FINE;
                }
                qtri_small_samples_pixel(o, pixel, w, values, place, textured && !curved,
                                         varies && !has_light_curve);
                in += QTRI_SMALL_LANES;
                out += QTRI_SMALL_LANES;
                at++;
            }
        }
        w->z += p->z.dy;
        if (varies) {
            w->c += values->c.r.dy;
        }
        if (two_words) {
            w->g += values->g.r.dy;
        }
        if (textured) {
            w->u += values->u.r.dy;
            w->v += values->v.r.dy;
        }
        if (curved) {
            qtri_small_curves_next_row(o, curves);
        }
        if (o->vertex_alpha) {
            w->alpha += values->alpha.r.dy;
        }
        w->pixel += pitch;
        if (qtri_tests_depth(o)) {
            w->depth += depth_pitch;
        }
        w->y++;
    }
}

/* Sets colours, linear on the screen; false: the lack of perspective would show. */
QTRI_BODY bool qtri_small_samples_colors(const qtri_options *o, qtri_small_sampled_values *v,
                                         const qtri_small_place *p, const qtri_small *t)
{
    qtri_small_place at = *p;
    for (int i = 0; i < 3; i++) {
        qtri_small_ramp c, g = {0, 0, 0};
        qtri_small_move_place(&at, i);
        if (!(qtri_is_textured(o) ? qtri_small_set_weights(&c, &g, &at, t, qtri_light_half(o))
              : qtri_kind_of(o) == QTRI_IN_565  ? qtri_small_set_colors_565(&c, &at, t)
              : qtri_kind_of(o) == QTRI_IN_GRAY ? qtri_small_set_colors_gray(&c, &at, t)
                                                : qtri_small_set_colors_888(&c, &g, &at, t))) {
            return false;
        }
        qtri_small_sampled_set(&v->c, i, &c);
        qtri_small_sampled_set(&v->g, i, &g);
    }
    return true;
}

QTRI_BODY bool qtri_small_samples_alpha(qtri_small_sampled_values *v, const qtri_small_place *p,
                                        const qtri_small *t)
{
    qtri_small_place at = *p;
    for (int i = 0; i < 3; i++) {
        qtri_small_ramp alpha;
        qtri_small_move_place(&at, i);
        if (!qtri_small_set_alpha(&alpha, &at, t)) {
            return false;
        }
        qtri_small_sampled_set(&v->alpha, i, &alpha);
    }
    return true;
}

/* Sets curves, or texture coordinates that are linear. False: they bend too much. */
QTRI_BODY bool qtri_small_samples_curves(const qtri_options *o, qtri_small_sampled_values *v,
                                         qtri_small_curves *curves, const qtri_small_place *p,
                                         const qtri_small *t, bool has_light)
{
    qtri_small_place at = *p;
    for (int i = 0; i < 3; i++) {
        qtri_small_move_place(&at, i);
        if (!(qtri_is_textured(o)
                  ? qtri_small_set_curves(curves, (qtri_small_division *)0, &at, t, o, has_light)
                  : qtri_small_set_light_curve(curves, &at, t, o))) {
            return false;
        }
        if (curves->is_curved || !qtri_is_textured(o)) { /* light alone is, as compilers see so */
            return true;
        }
        qtri_small_sampled_set(&v->u, i, &curves->linear[0]);
        qtri_small_sampled_set(&v->v, i, &curves->linear[1]);
    }
    return true;
}

/* Draws a triangle. False: it is large, and nothing was drawn. */
QTRI_BODY bool qtri_small_samples_draw(const qtri_options *o, qtri_pixel_body *pixel, qtri_small *t)
{
    qtri_small_samples s;
    qtri_small_place p;
    qtri_small_sampled_values values = QTRI_BODY_ZERO;
    qtri_small_curves curves;
    qtri_small_uv f;
    bool has_curved_light = false, is_curved = false;
    qtri_pixel_walk w = QTRI_BODY_ZERO;
    qtri_draw_state *state = t->state;
    const qtri_small_found found = qtri_small_samples_find(&p, &s, t);
    if (found != QTRI_SMALL_FOUND) {
        return found == QTRI_SMALL_NOTHING;
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
        const int32_t i0 = t->v[0]->intensity_q15;
        has_curved_light = !qtri_small_light_is_linear(&p, t, o);
        qtri_small_set_sampled(&values.c, &p, ((uint32_t)i0 << 9) + qtri_light_half(o),
                               t->v[1]->intensity_q15 - i0, t->v[2]->intensity_q15 - i0, 1);
        if (qtri_uses_table(o) && !state->has_table) {
            qtri_draw_state_set_table(state);
        }
    }
    if ((o->shade == QTRI_COLORS && !qtri_small_samples_colors(o, &values, &p, t)) ||
        (o->vertex_alpha && !qtri_small_samples_alpha(&values, &p, t))) {
        return false;
    }
    if (qtri_is_textured(o) && !has_curved_light && qtri_small_find_linear_texture(&f, &p, t, o)) {
        const uint32_t width_log2 = state->width_log2, height_log2 = state->height_log2;
        qtri_small_set_sampled(&values.u, &p, qtri_small_linear_u(&f, width_log2), f.u[1], f.u[2],
                               8);
        qtri_small_set_sampled(&values.v, &p, qtri_small_linear_v(&f, width_log2, height_log2),
                               f.v[1], f.v[2], (int32_t)(width_log2 + height_log2) - 8);
    } else if (qtri_is_textured(o) || has_curved_light) {
        QTRI_RARELY();
        if (!qtri_small_samples_curves(o, &values, &curves, &p, t, has_curved_light)) {
            return false;
        }
        is_curved = curves.is_curved;
    }
    if (p.cut) {
        qtri_small_samples_cut(&s, p.left, p.right);
    }
    if (is_curved) { /* a loop of its own: the other one needs the registers */
        qtri_small_samples_fill(o, pixel, &w, &p, &s, &values, &curves, true);
    } else {
        qtri_small_samples_fill(o, pixel, &w, &p, &s, &values, &curves, false);
    }
    return true;
}

/* Draws a small triangle with or without samples, as qtri_pipeline.small. */
QTRI_BODY bool qtri_small_instance_draw(const qtri_options *o, qtri_pixel_body *pixel,
                                        qtri_small *t)
{
    return qtri_has_samples(o) ? qtri_small_samples_draw(o, pixel, t)
                               : qtri_small_triangle_draw(o, pixel, t);
}

#ifdef __cplusplus
}
#endif

#endif
