/* SPDX-License-Identifier: MIT */
#include "small_curves.h"

#include "../bits/bits.h"

enum { FINE = QTRI_SMALL_FINE };

void qtri_small_find_e(int32_t e_q18[2], const qtri_small_place *p, const qtri_small *t)
{
    const int32_t y = (int32_t)qtri_small_reciprocal(t->v[0]->inv_w >> 15);
    e_q18[0] = ((p->q1 >> 15) * y + ((int32_t)1 << 12)) >> 13;
    e_q18[1] = ((p->q2 >> 15) * y + ((int32_t)1 << 12)) >> 13;
}

/* e / (1 + e/2) = 2 h (1 - h (1 - h + h^2)), h = e/2: off by 2 h^5, 2^-9, at most. */
static int32_t bend_of(int32_t e_q18)
{
    const int32_t h = e_q18 >> 3; /* Q16, |h| <= 2^14 */
    const int32_t rest = 0x10000 - ((h * (0x10000 - h)) >> 16);
    return e_q18 - ((h * ((h * rest) >> 16)) >> 13);
}

bool qtri_small_set_curvature(qtri_curvature *c, const qtri_small_place *p, const qtri_small *t)
{
    int32_t *e = c->e_q18;
    const int wide = p->wide;
    qtri_small_ramp ramp;
    qtri_small_find_e(e, p, t);
    c->k_q18[0] = bend_of(e[0]);
    c->k_q18[1] = bend_of(e[1]);
    QTRI_SMALL_SETUP(ramp_set_at)
    (&ramp, p, p->x, p->y - 256 * p->first, 0, c->k_q18[0] >> (1 + wide), c->k_q18[1] >> (1 + wide),
     -p->up);
    /* Steps of Q25, of wide ones Q24, 2^up less: to 13 bits of the greater one. */
    const uint32_t greater =
        qtri_small_about((int32_t)ramp.dx) | qtri_small_about((int32_t)ramp.dy);
    const int32_t down = qtri_greatest32(19 - qtri_clz32(greater), 1);
    const int32_t round = (int32_t)1 << (down - 1);
    c->bits = 25 - wide - p->up - down;
    c->e = ((int32_t)ramp.at + round) >> down;
    c->ex = ((int32_t)ramp.dx + round) >> down;
    c->ey = ((int32_t)ramp.dy + round) >> down;
    const uint32_t range = qtri_small_range(e[0], e[1]) >> 8; /* Q10, 3/4 at most */
    const uint32_t q_mid = 1024u + (uint32_t)(qtri_small_min(e[0], e[1]) >> 8) + range / 2;
    c->ratio_q12 = (range * range >> 8) + 1;
    c->q_mid2_q10 = 35 * (q_mid * q_mid >> 10) >> 5;
    return c->bits >= 17;
}

/* F E / 2^14. */
static inline int32_t product(int32_t f, int32_t e)
{
    return qtri_small_product(f, e, 14);
}

/* x 2^up, rounded. */
static inline uint32_t to_units(int32_t x, int32_t up)
{
    return up >= 0 ? (uint32_t)x << up : (uint32_t)((x + ((int32_t)1 << (-up - 1))) >> -up);
}

void qtri_small_set_curve(qtri_small_curve *r, const qtri_small_place *p, const qtri_curvature *c,
                          const qtri_small_value *value)
{
    const int32_t x = p->x, y = p->y - 256 * p->first;
    const uint32_t rows = (uint32_t)p->first;
    const int32_t wide = p->wide;
    qtri_small_ramp f, g;
    const int32_t f1 = (value->f1 + wide) >> wide; /* scaled they have to be below 2^14.4 */
    const int32_t f2 = (value->f2 + wide) >> wide;
    int32_t up = value->up + wide;
    QTRI_SMALL_SETUP(ramp_set_at)(&f, p, x, y, 0, f1, f2, -p->up);
    QTRI_SMALL_SETUP(ramp_set_at)
    (&g, p, x, y, value->value, qtri_small_scaled(f1, c->k_q18[0]),
     qtri_small_scaled(f2, c->k_q18[1]), up);
    const int32_t at = (int32_t)f.at, fx = (int32_t)f.dx, fy = (int32_t)f.dy;
    up += p->up + 14 - c->bits; /* of what product() is of */
    r->xx = 0u - to_units(product(fx, c->ex), up);
    r->xy = 0u - to_units(product(fx, c->ey) + product(fy, c->ex), up);
    const uint32_t yy = 0u - to_units(product(fy, c->ey), up);
    const uint32_t dy = g.dy - to_units(product(at, c->ey) + product(fy, c->e), up);
    const uint32_t dx = g.dx - to_units(product(at, c->ex) + product(fx, c->e), up);
    r->at = g.at - to_units(product(at, c->e), up) + rows * (dy + rows * yy);
    r->dx = dx + rows * r->xy;
    r->dy = dy + (2 * rows + 1) * yy;
    r->yy = 2 * yy;
}

/* Light ---------------------------------------------------------------------------------------- */

void qtri_small_find_light(qtri_small_value *light, const qtri_small *t, const qtri_options *o)
{
    const int32_t i0 = t->v[0]->intensity_q15;
    const uint32_t part = qtri_small_curve_part_of(o) - qtri_is_textured(o);
    light->value = (((uint32_t)i0 << 9) + qtri_light_half(o)) << FINE;
    light->f1 = t->v[1]->intensity_q15 - i0;
    light->f2 = t->v[2]->intensity_q15 - i0;
    light->up = 1 + FINE;
    light->unit_log2 = 8;  /* Q15 of full */
    light->by = 18 - part; /* half of 2^-part of full */
    light->bend = (uint32_t)1 << (25 + FINE - part);
}

void qtri_small_set_light_along(qtri_small_curves *curves, const qtri_curvature *c,
                                const qtri_small_place *p, const qtri_small_value *light)
{
    qtri_small_set_curve(&curves->c, p, c, light);
    curves->light_piece = (uint32_t)1 << qtri_small_chord_log2(&curves->c, 6, light->bend);
}

bool qtri_small_set_light_curve(qtri_small_curves *curves, const qtri_small_place *p,
                                const qtri_small *t, const qtri_options *o)
{
    qtri_curvature c;
    qtri_small_value light;
    curves->is_curved = true;
    qtri_small_find_light(&light, t, o);
    if (!qtri_small_set_curvature(&c, p, t) ||
        !qtri_small_is_near_curve(&c, qtri_small_range(light.f1, light.f2), light.by)) {
        return false;
    }
    qtri_small_set_light_along(curves, &c, p, &light);
    return true;
}

/* Colours -------------------------------------------------------------------------------------- */

/* Channels of the vertices, Q15 of full; of gray, luma in the place of green. */
static void find_channels(int32_t channel[3][3], const qtri_small_place *p, const qtri_small *t,
                          bool is_gray)
{
    qtri_small_colors f;
    qtri_small_colors_of(&f, p, t);
    const qtri_small_channels *const vertex[3] = {&f.at, &f.d1, &f.d2};
    for (int i = 0; i < 3; i++) {
        channel[0][i] = vertex[i]->r;
        channel[1][i] = is_gray ? qtri_small_luma(vertex[i]) : vertex[i]->g;
        channel[2][i] = vertex[i]->b;
    }
}

static bool set_color_curves(qtri_small_color_curves *k, const qtri_small_place *p,
                             const qtri_curvature *c, const qtri_small_value value[3],
                             bool is_packed)
{
    /* Rounded steps may add up to a quarter of a step of a channel; where a triangle is wide, to an
       eighth, as xx is rounded too. */
    int32_t log2 = !is_packed ? 5 : p->wide ? 3 : 4;
    for (int i = 0; i < 3; i++) {
        qtri_small_set_curve(&k->channel[i], p, c, &value[i]);
        log2 = qtri_small_chord_log2(&k->channel[i], log2, value[i].bend);
    }
    k->piece = (uint32_t)1 << log2;
    return true;
}

static bool divide_colors(qtri_small_color_curves *k, qtri_small_division *division,
                          const qtri_small_place *p, const qtri_curvature *c,
                          const qtri_small_value value[3])
{
    bool is_set = qtri_small_begin_division(division, &k->piece, c, p);
    for (int i = 0; i < 3 && is_set; i++) {
        is_set = qtri_small_add_divided(division, &k->channel[i], &value[i], c, p);
    }
    qtri_small_end_division(division);
    k->piece = 1; /* found with the curves */
    return is_set;
}

bool qtri_small_set_color_curves(qtri_small_color_curves *k, qtri_small_division *division,
                                 const qtri_small_place *p, const qtri_small *t)
{
    const qtri_options *o = &t->state->options;
    const qtri_color_kind kind = qtri_kind_of(o);
    const bool textured = qtri_is_textured(o);
    const bool is_packed = kind == QTRI_IN_565 && !textured;
    const uint32_t part = qtri_small_curve_part_of(o);
    const uint32_t half = textured ? qtri_light_half(o) : 0x8000u;
    int32_t channel[3][3];
    qtri_small_value value[3];
    qtri_curvature c;
    bool is_near = true;
    /* Packed ones without perspective go in longer runs where they are large: quads of 70 and 100
       pixels take 32 and 40 % less. */
    if ((is_packed && (t->state->is_linear || p->q_about == 0) && qtri_small_is_beyond_middle(p)) ||
        !qtri_small_set_curvature(&c, p, t)) {
        return false;
    }
    find_channels(channel, p, t, kind == QTRI_IN_GRAY && !textured);
    for (int i = 0; i < 3; i++) {
        const int32_t full = textured ? 256 : !is_packed ? 255 : i == 1 ? 63 : 31;
        qtri_small_value *v = &value[i];
        v->value = ((uint32_t)(channel[i][0] * full * 2) + half) << FINE;
        v->f1 = (channel[i][1] * full) >> 8;
        v->f2 = (channel[i][2] * full) >> 8;
        v->up = 1 + FINE;
        /* Q15 of full, or 31/32 and 63/64 of that: 2/35 has room for it. */
        v->unit_log2 = !is_packed ? 8 : i == 1 ? 6 : 5;
        v->by = 18 - part;
        v->bend = (uint32_t)full << (17 + FINE - part);
        is_near = is_near && qtri_small_is_near_curve(
                                 &c, qtri_small_range(channel[i][1], channel[i][2]), v->by);
    }
    qtri_small_divide_nothing(division);
    return is_near ? set_color_curves(k, p, &c, value, is_packed)
                   : !textured && divide_colors(k, division, p, &c, value);
}

/* Fields as state.h and pixel.h have them. */
void qtri_small_set_color_chord(qtri_small_chord *c, qtri_small_chord *g,
                                const qtri_small_color_curves *k, const qtri_options *o, uint32_t x)
{
    const qtri_small_curve *channel = k->channel;
    const uint32_t n = k->piece;
    if (!qtri_is_textured(o) && qtri_kind_of(o) == QTRI_IN_565) {
        const qtri_small_chord r = qtri_small_chord_of(&channel[0], x, n, 10);
        const qtri_small_chord b = qtri_small_chord_of(&channel[2], x, n, 11);
        const qtri_small_chord green = qtri_small_chord_of(&channel[1], x, n, 11);
        c->at = (r.at << 21) + ((b.at & 0x3FF) << 11) + (green.at & 0x7FF);
        c->step = (r.step << 21) + (b.step << 11) + green.step;
        return;
    }
    *g = qtri_small_whole_chord_of(&channel[1], x, n);
    if (!qtri_is_textured(o) && qtri_kind_of(o) == QTRI_IN_GRAY) {
        *c = *g;
        return;
    }
    const uint32_t down = qtri_is_textured(o) ? 9 : 8;
    const qtri_small_chord r = qtri_small_chord_of(&channel[0], x, n, down);
    const qtri_small_chord b = qtri_small_chord_of(&channel[2], x, n, down);
    c->at = (r.at << 16) + (b.at & 0xFFFF);
    c->step = (r.step << 16) + b.step;
}

void qtri_small_color_curves_next_row(qtri_small_color_curves *k)
{
    qtri_small_curve_next_row(&k->channel[0]);
    qtri_small_curve_next_row(&k->channel[1]);
    qtri_small_curve_next_row(&k->channel[2]);
}
