/* SPDX-License-Identifier: MIT */
/*
 * Light, colours and alpha of small triangles: linear on the screen, or along curves.
 *
 * Channels are Q15 of full, times light, and a ramp has n.16: differences, at most 2^15, times its
 * full value. On the screen what differs by `range` strays from perspective by range (q_max -
 * q_min) / (4 q_min) at most, q being 1/w, by Gruess's bound of a covariance.
 */
#include "../geometry/lighting.h"
#include "small_curves.h"

bool qtri_small_is_linear_by_range(uint32_t range, uint32_t q_range, uint32_t q_part)
{
    return range * ((q_range >> 15) + 1) <= q_part;
}

bool qtri_small_are_linear(const int32_t differences[6], uint32_t inv_w, int32_t q1, int32_t q2,
                           uint32_t part)
{
    const uint32_t q_range = qtri_small_range(q1, q2);
    const uint32_t q_part = (inv_w + (uint32_t)qtri_small_min0(q1, q2)) >> (part - 2);
    for (int i = 0; i < 6; i += 2) {
        const uint32_t range = qtri_small_range(differences[i], differences[i + 1]);
        if (!qtri_small_is_linear_by_range(range, q_range, q_part)) {
            return false;
        }
    }
    return true;
}

bool qtri_small_light_is_linear(const qtri_small_place *p, const qtri_small *t,
                                const qtri_options *o)
{
    return qtri_setup_light_is_linear(p, t, o);
}

void qtri_small_set_light(qtri_small_ramp *c, const qtri_small_place *p, const qtri_small *t,
                          uint32_t half)
{
    qtri_setup_set_light(c, p, t, half);
}

bool qtri_small_set_alpha(qtri_small_ramp *alpha, const qtri_small_place *p, const qtri_small *t)
{
    const uint8_t *from = t->state->alphas;
    int32_t a[3];
    for (int i = 0; i < 3; i++) {
        const int32_t x = from[t->index[i]];
        a[i] = (x + (x >> 7)) << 7; /* Q15 */
    }
    if (!t->state->is_linear && !qtri_small_is_linear(p, t, a[1] - a[0], a[2] - a[0],
                                                      qtri_small_part_of(&t->state->options))) {
        return false;
    }
    qtri_small_ramp_set(alpha, p, ((uint32_t)a[0] << 9) + 0x8000u, a[1] - a[0], a[2] - a[0], 1);
    return true;
}

/* c / 255 in Q15. */
static int32_t full_q15(uint32_t c)
{
    return (int32_t)((c * 257u * QTRI_SMALL_ONE + 0x8000u) >> 16);
}

static void set_channels(qtri_small_channels *f, uint32_t rgb)
{
    f->r = full_q15(rgb >> 16 & 255);
    f->g = full_q15(rgb >> 8 & 255);
    f->b = full_q15(rgb & 255);
}

/* A back face has changed the places of vertices 1 and 2. */
void qtri_small_lit_channels(qtri_small_colors *f, const qtri_small *t, bool turned)
{
    const uint32_t *lit = t->state->lit;
    set_channels(&f->at, lit[0]);
    set_channels(&f->d1, lit[1 + turned]);
    set_channels(&f->d2, lit[2 - turned]);
}

/*
 * Steps that are rounded stray most at vertices 1 and 2, from the pixel of vertex 0 on. Half a step
 * of a channel is there before, of which the pixel may have 1/32 less, its centre lies up to half a
 * pixel each way from the vertex, and a ramp strays by 1/100: 7/16 are left.
 */
static bool keeps_field(const qtri_small_place *p, int32_t more_x, int32_t more_y)
{
    const uint32_t most = 0x7000u << 8; /* of 24.8 times n.16 */
    return qtri_small_abs(more_x * p->dx1 + more_y * p->dy1) < most &&
           qtri_small_abs(more_x * p->dx2 + more_y * p->dy2) < most;
}

/* Rounds steps to nearest, or else one or both to the other side. Not needed where all three
   vertices are 6/10 of a step of 31 or more from both ends: over 32 pixels each way steps stray by
   1, and half is there. */
bool qtri_small_round_steps(qtri_small_ramp *r, const qtri_small_place *p, int32_t f0, int32_t f1,
                            int32_t f2, int down)
{
    const int32_t least = f0 + qtri_small_min0(f1, f2) - 640;
    const int32_t most = f0 + qtri_small_max0(f1, f2) + 640;
    if (least >= 0 && most <= QTRI_SMALL_ONE) {
        return true;
    }
    const int32_t unit = (int32_t)1 << down, half = unit / 2;
    const int32_t x = half - (int32_t)((r->dx + (uint32_t)half) & (uint32_t)(unit - 1));
    const int32_t y = half - (int32_t)((r->dy + (uint32_t)half) & (uint32_t)(unit - 1));
    const int32_t more_x[2] = {x, x > 0 ? x - unit : x + unit};
    const int32_t more_y[2] = {y, y > 0 ? y - unit : y + unit};
    for (int i = 0; i < 4; i++) {
        if (keeps_field(p, more_x[i >> 1], more_y[i & 1])) {
            r->dx += (uint32_t)more_x[i >> 1];
            r->dy += (uint32_t)more_y[i & 1];
            return true;
        }
    }
    return false;
}

bool qtri_small_set_colors_565(qtri_small_ramp *c, const qtri_small_place *p, const qtri_small *t)
{
    /* Steps of a wide one leave their fields. */
    return !p->wide &&
           qtri_setup_set_colors_565(c, p, t, &t->state->options, qtri_small_keeps_fields(p));
}

/* Finds colours that are linear, of a triangle so small that steps rounded to 2^-8 are off by 1/4
   at most: 60 + 60 of them. */
static bool find_packed(qtri_small_colors *f, const qtri_small_place *p, const qtri_small *t)
{
    return !qtri_small_is_beyond_middle(p) && qtri_small_colors_find(f, p, t, &t->state->options);
}

/* Sets red and blue, n.(16 - down), in halves of c, and green, n.16, in g. */
static inline void set_two_words(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                                 const qtri_small_colors *f, int32_t full, int32_t full_green,
                                 uint32_t half, int down)
{
    const uint32_t round = (uint32_t)1 << (down - 1);
    qtri_small_ramp r, b;
    qtri_small_channel_set(&r, p, f->at.r, f->d1.r, f->d2.r, full, half);
    qtri_small_channel_set(&b, p, f->at.b, f->d1.b, f->d2.b, full, half);
    c->at = (r.at >> down << 16) + qtri_small_signed_shift(b.at, down);
    c->dx = ((r.dx + round) >> down << 16) + qtri_small_signed_shift(b.dx + round, down);
    c->dy = ((r.dy + round) >> down << 16) + qtri_small_signed_shift(b.dy + round, down);
    qtri_small_channel_set(g, p, f->at.g, f->d1.g, f->d2.g, full_green, half);
    qtri_small_ramp_to_first_row(c, p);
    qtri_small_ramp_to_first_row(g, p);
}

bool qtri_small_set_colors_888(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                               const qtri_small *t)
{
    qtri_small_colors f;
    if (!find_packed(&f, p, t)) {
        return false;
    }
    const bool is_fine = qtri_kind_of(&t->state->options) == QTRI_IN_FINE_565;
    set_two_words(c, g, p, &f, is_fine ? 248 : 255, is_fine ? 252 : 255, 0x8000u, 8);
    return true;
}

bool qtri_small_set_weights(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                            const qtri_small *t, uint32_t half)
{
    qtri_small_colors f;
    if (!find_packed(&f, p, t)) {
        return false;
    }
    set_two_words(c, g, p, &f, 256, 256, half, 9);
    return true;
}

bool qtri_small_set_colors_gray(qtri_small_ramp *c, const qtri_small_place *p, const qtri_small *t)
{
    qtri_small_colors f;
    if (!qtri_small_colors_find(&f, p, t, &t->state->options)) {
        return false;
    }
    qtri_small_channel_set(c, p, qtri_small_luma(&f.at), qtri_small_luma(&f.d1),
                           qtri_small_luma(&f.d2), 255, 0x8000u);
    qtri_small_ramp_to_first_row(c, p);
    return true;
}

/* Light that follows perspective --------------------------------------------------------------- */

void qtri_small_find_light(qtri_small_value *light, const qtri_small *t, const qtri_options *o)
{
    const int32_t i0 = t->v[0]->intensity_q15;
    const uint32_t part = qtri_small_curve_part_of(o) - qtri_is_textured(o);
    light->value = (((uint32_t)i0 << 9) + qtri_light_half(o)) << QTRI_SMALL_FINE;
    light->f1 = t->v[1]->intensity_q15 - i0;
    light->f2 = t->v[2]->intensity_q15 - i0;
    light->up = 1 + QTRI_SMALL_FINE;
    light->unit_log2 = 8;  /* Q15 of full */
    light->by = 18 - part; /* half of 2^-part of full */
    light->bend = (uint32_t)1 << (25 + QTRI_SMALL_FINE - part);
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

/* Colours that follow perspective -------------------------------------------------------------- */

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
    if ((is_packed && (t->state->is_linear || p->q_abs == 0) && qtri_small_is_beyond_middle(p)) ||
        !qtri_small_set_curvature(&c, p, t)) {
        return false;
    }
    find_channels(channel, p, t, kind == QTRI_IN_GRAY && !textured);
    for (int i = 0; i < 3; i++) {
        const int32_t full = textured                   ? 256
                             : kind == QTRI_IN_FINE_565 ? (i == 1 ? 252 : 248)
                             : !is_packed               ? 255
                             : i == 1                   ? 63
                                                        : 31;
        qtri_small_value *v = &value[i];
        v->value = ((uint32_t)(channel[i][0] * full * 2) + half) << QTRI_SMALL_FINE;
        v->f1 = (channel[i][1] * full) >> 8;
        v->f2 = (channel[i][2] * full) >> 8;
        v->up = 1 + QTRI_SMALL_FINE;
        /* Q15 of full, or 31/32 and 63/64 of that: 2/35 has room for it. */
        v->unit_log2 = !is_packed ? 8 : i == 1 ? 6 : 5;
        v->by = 18 - part;
        v->bend = (uint32_t)full << (17 + QTRI_SMALL_FINE - part);
        is_near = is_near && qtri_small_is_near_curve(
                                 &c, qtri_small_range(channel[i][1], channel[i][2]), v->by);
    }
    qtri_small_disable_division(division);
    return is_near ? set_color_curves(k, p, &c, value, is_packed)
                   : !textured && divide_colors(k, division, p, &c, value);
}

/* Packs as qtri_pixel_walk and qtri_smooth_color() have it. */
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
