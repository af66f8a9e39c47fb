/* SPDX-License-Identifier: MIT */
/*
 * Light, colours and alpha of small triangles, and how near what is linear or a curve is to them.
 *
 * Channels are Q15 of full, times light, and a ramp has n.16: differences, at most 2^15, times its
 * full value. On the screen what differs by `range` strays from perspective by range (q_max -
 * q_min) / (4 q_min) at most, q being 1/w, by Gruess's bound of a covariance.
 */
#include "../geometry/lighting.h"
#include "small_curves.h"

void qtri_small_ramp_set_at(qtri_small_ramp *r, const qtri_small_place *p, int32_t x, int32_t y,
                            uint32_t value, int32_t f1, int32_t f2, int32_t up)
{
    qtri_setup_ramp_set_at(r, p, x, y, value, f1, f2, up);
}

bool qtri_small_is_linear_by_range(uint32_t range, uint32_t q_range, uint32_t q_part)
{
    return range * ((q_range >> 15) + 1) <= q_part;
}

bool qtri_small_are_linear(const int32_t differences[6], uint32_t inv_w, int32_t q1, int32_t q2,
                           uint32_t part)
{
    const uint32_t q_range = qtri_small_range(q1, q2);
    const uint32_t q_part = (inv_w + (uint32_t)qtri_small_min(q1, q2)) >> (part - 2);
    for (int i = 0; i < 6; i += 2) {
        const uint32_t range = qtri_small_range(differences[i], differences[i + 1]);
        if (!qtri_small_is_linear_by_range(range, q_range, q_part)) {
            return false;
        }
    }
    return true;
}

bool qtri_small_is_near_curve(const qtri_curvature *c, uint32_t range, uint32_t by)
{
    return range <= (uint32_t)1 << 20 && range * c->ratio_q12 <= c->q_mid2_q10 << (by + 2);
}

int32_t qtri_small_chord_log2(const qtri_small_curve *c, int32_t most, uint32_t bend)
{
    const uint32_t by = qtri_small_about((int32_t)c->xx);
    int32_t log2 = most;
    while (log2 > 0 && by > bend >> 2 * log2) {
        log2--;
    }
    return log2;
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
    return qtri_small_about(more_x * p->dx1 + more_y * p->dy1) < most &&
           qtri_small_about(more_x * p->dx2 + more_y * p->dy2) < most;
}

/* To nearest, or else one or both to the other side. Not needed where all three vertices are 6/10
   of a step of 31 or more from both ends: over 32 pixels each way steps stray by 1, and half is
   there. */
bool qtri_small_round_steps(qtri_small_ramp *r, const qtri_small_place *p, int32_t f0, int32_t f1,
                            int32_t f2, int down)
{
    const int32_t least = f0 + qtri_small_min(f1, f2) - 640;
    const int32_t most = f0 + qtri_small_max(f1, f2) + 640;
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

/* Linear, and near enough for rounded steps of 2^-8: 60 + 60 of them are off by 1/4 at most. */
static bool find_packed(qtri_small_colors *f, const qtri_small_place *p, const qtri_small *t)
{
    return !qtri_small_is_beyond_middle(p) && qtri_small_colors_find(f, p, t, &t->state->options);
}

/* Red and blue n.(16 - down) in halves of a word, green as it is. */
static inline void set_two_words(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                                 const qtri_small_colors *f, int32_t full, uint32_t half, int down)
{
    qtri_small_ramp r;
    qtri_small_channel_set(&r, p, f->at.r, f->d1.r, f->d2.r, full, half);
    qtri_small_pack_red(c, &r, down);
    qtri_small_channel_set(&r, p, f->at.b, f->d1.b, f->d2.b, full, half);
    qtri_small_pack_blue(c, &r, down);
    qtri_small_channel_set(g, p, f->at.g, f->d1.g, f->d2.g, full, half);
    qtri_small_set_base(c, p);
    qtri_small_set_base(g, p);
}

bool qtri_small_set_colors_888(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                               const qtri_small *t)
{
    qtri_small_colors f;
    if (!find_packed(&f, p, t)) {
        return false;
    }
    set_two_words(c, g, p, &f, 255, 0x8000u, 8);
    return true;
}

bool qtri_small_set_weights(qtri_small_ramp *c, qtri_small_ramp *g, const qtri_small_place *p,
                            const qtri_small *t, uint32_t half)
{
    qtri_small_colors f;
    if (!find_packed(&f, p, t)) {
        return false;
    }
    set_two_words(c, g, p, &f, 256, half, 9);
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
    qtri_small_set_base(c, p);
    return true;
}

uint32_t qtri_small_fog_step(uint32_t from, uint32_t to, int32_t count)
{
    if (count < 2) {
        return 0;
    }
    const int32_t difference = (int32_t)(to - from); /* |.| <= 2^24 */
    return (uint32_t)qtri_divide32(difference, (uint32_t)count - 1);
}
