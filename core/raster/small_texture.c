/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates of small triangles, light that follows perspective, and mipmap levels.
 *
 * What is interpolated linearly on the screen strays from perspective by the covariance of 1/w and
 * the value, which is at most range(u) range(q) / (4 q_min); where that could be more than
 * 2^-QTRI_SMALL_TEXEL_LOG2 texel it is a curve.
 *
 * With e, what q has more than at vertex 0 by its value there, a value along the edge from there is
 * u_0 + f s (1 + e) / (1 + e s), s from 0 to 1: f s + f k s (1 - s), k = e / (1 + e/2), is equal at
 * both ends and in the middle. Over the triangle that is the product of what is linear,
 *
 *     u_0 + G - F E,   F = 0, f_1, f_2,   E = 0, k_1, k_2,   G = F (1 + E) at the vertices,
 *
 * which on the third edge has k_2 - k_1 in place of (e_2 - e_1) / (1 + (e_1 + e_2) / 2), 1/64 of it
 * off at most. It strays by the third derivative, 6 range(u) (range(q) / q_min)^2, times .048 / 6,
 * .0481 being the maximum of s (1/2 - s) (1 - s).
 */
#include "qtri/body/small_setup.h"

#include "descriptions.h"

#include "../bits/bits.h"

/* f (1 + e), |f| <= 2^16, |e| <= 1/4 and a part. */
static int32_t scaled(int32_t f, int32_t e_q18)
{
    return f + (((f >> 2) * e_q18 + ((int32_t)1 << 15)) >> 16);
}

/* x 2^up, rounded down, |up| < 32. */
static int32_t shifted(int32_t x, int32_t up)
{
    return up >= 0 ? (int32_t)((uint32_t)x << up) : x >> -up;
}

/* What 1/w has more at vertices 1 and 2, as a part of that of vertex 0. */
static void find_e(int32_t e_q18[2], const qtri_small_place *p, const qtri_small *t)
{
    const int32_t y = (int32_t)qtri_small_reciprocal(t->v[0]->inv_w >> 15);
    e_q18[0] = ((p->q1 >> 14) * y + ((int32_t)1 << 13)) >> 14;
    e_q18[1] = ((p->q2 >> 14) * y + ((int32_t)1 << 13)) >> 14;
}

/* Texture coordinates -------------------------------------------------------------------------- */

/* Brings differences to what a ramp takes, and u_0 of what is clamped to four times that; returns
   how many bits they lost. */
static uint32_t reduce(int32_t f[3], uint32_t bits, bool is_clamped)
{
    const uint32_t first = is_clamped ? qtri_small_about(f[0]) >> 2 : 0;
    uint32_t down = 0;
    while ((first | qtri_small_about(f[1]) | qtri_small_about(f[2])) >> (bits + down) != 0) {
        down++;
    }
    f[1] >>= down;
    f[2] >>= down;
    return down;
}

/* u_0 in units of 2^-28 of a repeat or coarser ones, as they fit: below 2^30. */
static uint32_t clamp_axis_set(qtri_clamp_axis *axis, int32_t u0, uint32_t side_log2, uint32_t down)
{
    axis->shift = (uint8_t)(28 - down - side_log2);
    axis->limit = ((uint32_t)1 << (28 - down)) - 1;
    return (uint32_t)shifted(u0, 12 - (int32_t)down);
}

/* Where coordinates begin at vertex 0, and by how much differences go left, in the walk's units. */
typedef struct texture_units {
    uint32_t base[2];
    uint32_t up[2];
} texture_units;

/* Of any axes and differences. */
static void set_units(texture_units *units, qtri_small_curves *curves, int32_t f[2][3],
                      const qtri_small_place *p, const qtri_draw_state *state,
                      const qtri_options *o)
{
    const uint32_t side_log2[2] = {qtri_texture_width_log2(o, state),
                                   qtri_texture_height_log2(o, state)};
    for (int k = 0; k < 2; k++) {
        const uint32_t bits = p->wide ? 15 : 16;
        const bool is_clamped = (k == 0 ? o->wrap_u : o->wrap_v) == QTRI_CLAMP;
        uint32_t base, up, shift;
        if (is_clamped) {
            const uint32_t down = reduce(f[k], bits, true);
            up = 4;
            base = clamp_axis_set(&curves->axis[k], f[k][0], side_log2[k], down);
            shift = curves->axis[k].shift;
        } else {
            const bool is_v = k == 1 && !o->large_texture;
            const uint32_t unit =
                is_v ? side_log2[0] + side_log2[1] : 16; /* 2^(16 + it) a repeat */
            up = 0;
            if (unit < 8) {
                f[k][1] >>= 8 - unit;
                f[k][2] >>= 8 - unit;
            } else {
                up = unit - 8;
            }
            up += reduce(f[k], bits, false);
            base = (uint32_t)f[k][0] << unit;
            shift = is_v ? 16 + side_log2[0] : 32 - side_log2[k];
        }
        base += (uint32_t)1 << (shift - 1) >> 10; /* 1 <= shift: 28 less 17 and 10 at most */
        if (o->bilinear) {
            base -= (uint32_t)1 << (shift - 1);
        }
        units->base[k] = base;
        units->up[k] = up;
    }
}

bool qtri_small_set_linear_texture(qtri_small_ramp *u, qtri_small_ramp *v,
                                   const qtri_small_place *p, const qtri_small *t,
                                   const qtri_options *o)
{
    return qtri_setup_set_linear_texture(u, v, p, t, o);
}

/* Curves --------------------------------------------------------------------------------------- */

/* What all curves of a triangle have in common. */
typedef struct curvature {
    int32_t k_q18[2];
    int32_t e, ex, ey;   /* Q17 of 1: E at the pixel of vertex 0, and its steps, below 2^13 */
    uint32_t ratio_q12;  /* (range(q) / q_0)^2 */
    uint32_t q_min2_q10; /* (q_min / q_0)^2 */
} curvature;

/* e / (1 + e/2) = 2 h / (1 + h), h = e/2: off by 2 h^4, 2^-11, at most. */
static int32_t bend_of(int32_t e_q18)
{
    const int32_t h = e_q18 >> 1; /* |h| <= 2^15 */
    return 2 * (h - ((h * (h - ((h * h) >> 18))) >> 18));
}

/* False: E changes too much from pixel to pixel, over a triangle of hardly any width. */
static bool set_curvature(curvature *c, const qtri_small_place *p, const qtri_small *t)
{
    const int32_t limit = (int32_t)1 << 13;
    int32_t e[2];
    qtri_small_ramp ramp;
    find_e(e, p, t);
    c->k_q18[0] = bend_of(e[0]);
    c->k_q18[1] = bend_of(e[1]);
    QTRI_SMALL_SETUP(ramp_set_at)
    (&ramp, p, p->x + QTRI_SMALL_FAR, p->y - 256 * p->first, 0, c->k_q18[0] >> 1, c->k_q18[1] >> 1,
     -p->up);
    c->e = (int32_t)ramp.at >> (8 - p->up); /* Q25, 2^up less */
    c->ex = (int32_t)ramp.dx >> (8 - p->up);
    c->ey = (int32_t)ramp.dy >> (8 - p->up);
    const uint32_t range = qtri_small_range(e[0], e[1]) >> 8;                   /* Q10, <= 2^9 */
    const uint32_t q_min = 1024u + (uint32_t)(qtri_small_min(e[0], e[1]) >> 8); /* >= 3/4 2^10 */
    c->ratio_q12 = (range * range >> 8) + 1;
    c->q_min2_q10 = q_min * q_min >> 10;
    return c->ex >= -limit && c->ex < limit && c->ey >= -limit && c->ey < limit;
}

/* Whether a curve is off by range / 2^by (range(q) / q_min)^2 <= 1 at most, by <= 22. */
static bool is_near_curve(const curvature *c, uint32_t range, uint32_t by)
{
    return range <= (uint32_t)1 << 20 && range * c->ratio_q12 <= c->q_min2_q10 << (by + 2);
}

/* F E / 2^14, rounded down: |F| < 2^30.2, |E| < 2^13.6. */
static inline int32_t product(int32_t f, int32_t e)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(((int64_t)f * e) >> 14);
#else
    return (f >> 16) * e * 4 + (((int32_t)qtri_low16((uint32_t)f) * e) >> 14);
#endif
}

/* `value` at vertex 0, more by f1 and f2, of units 2^(8 + up), at vertices 1 and 2. */
static void set_curve(qtri_small_curve *r, const qtri_small_place *p, const curvature *c,
                      uint32_t value, int32_t f1, int32_t f2, int32_t up)
{
    const int32_t x = p->x + QTRI_SMALL_FAR, y = p->y - 256 * p->first;
    const uint32_t rows = (uint32_t)p->first;
    qtri_small_ramp f, g;
    QTRI_SMALL_SETUP(ramp_set_at)(&f, p, x, y, 0, f1, f2, -p->up);
    QTRI_SMALL_SETUP(ramp_set_at)
    (&g, p, x, y, value, scaled(f1, c->k_q18[0]), scaled(f2, c->k_q18[1]), up);
    const int32_t at = (int32_t)f.at, fx = (int32_t)f.dx, fy = (int32_t)f.dy;
    up += p->up - 3; /* Q17 of E, and 14 bits that product() drops */
    const int32_t down = up < 0 ? -up : 0;
    up += down;
    r->xx = 0u - ((uint32_t)(product(fx, c->ex) >> down) << up);
    r->xy = 0u - ((uint32_t)((product(fx, c->ey) + product(fy, c->ex)) >> down) << up);
    const uint32_t yy = 0u - ((uint32_t)(product(fy, c->ey) >> down) << up);
    const uint32_t dy = g.dy - ((uint32_t)((product(at, c->ey) + product(fy, c->e)) >> down) << up);
    const uint32_t dx = g.dx - ((uint32_t)((product(at, c->ex) + product(fx, c->e)) >> down) << up);
    r->at = g.at - ((uint32_t)(product(at, c->e) >> down) << up) + rows * (dy + rows * yy);
    r->dx = dx + rows * r->xy;
    r->dy = dy + (2 * rows + 1) * yy;
    r->yy = 2 * yy;
}

static bool set_texture_curves(qtri_small_curves *curves, const curvature *c, int32_t f[2][3],
                               const qtri_small_place *p, const qtri_small *t,
                               const qtri_options *o)
{
    texture_units units;
    for (int k = 0; k < 2; k++) {
        const uint32_t side_log2 =
            k == 0 ? qtri_texture_width_log2(o, t->state) : qtri_texture_height_log2(o, t->state);
        /* 2^-6 texel; by 1/16 (range(q) / q_min)^2 of it, 1/16 texel at most */
        if (!is_near_curve(c, qtri_small_range(f[k][1], f[k][2]) >> (10 - side_log2), 6)) {
            return false;
        }
    }
    set_units(&units, curves, f, p, t->state, o);
    for (int k = 0; k < 2; k++) {
        qtri_small_curve *r = k == 0 ? &curves->u : &curves->v;
        if ((int32_t)units.up[k] + p->up > 16) {
            return false;
        }
        set_curve(r, p, c, units.base[k], f[k][1], f[k][2], (int32_t)units.up[k]);
    }
    return true;
}

static bool set_light_curve(qtri_small_curves *curves, const curvature *c,
                            const qtri_small_place *p, const qtri_small *t, const qtri_options *o)
{
    const int32_t part = (int32_t)qtri_small_part_of(o);
    const int32_t i0 = t->v[0]->intensity_q15;
    const int32_t f1 = t->v[1]->intensity_q15 - i0, f2 = t->v[2]->intensity_q15 - i0;
    /* half of 2^-part of full, 2^15, by 1/16 of (range(q) / q_min)^2 */
    if (!is_near_curve(c, qtri_small_range(f1, f2), (uint32_t)(18 - part))) {
        return false;
    }
    set_curve(&curves->c, p, c, ((uint32_t)i0 << 9) + qtri_light_half(o), f1, f2, 1);
    /* A chord over n pixels is off by n^2 / 4 of xx: half of 2^(24 - part) at most. */
    const uint32_t bend = qtri_small_about((int32_t)curves->c.xx);
    uint32_t log2 = 6;
    while (log2 > 0 && bend > (uint32_t)1 << (25 - part) >> 2 * log2) {
        log2--;
    }
    curves->light_piece = (uint32_t)1 << log2;
    return true;
}

bool qtri_small_set_light_curve(qtri_small_curves *curves, const qtri_small_place *p,
                                const qtri_small *t, const qtri_options *o)
{
    curvature c;
    curves->is_curved = true;
    return set_curvature(&c, p, t) && set_light_curve(curves, &c, p, t, o);
}

bool qtri_small_set_curves(qtri_small_curves *curves, const qtri_small_place *p,
                           const qtri_small *t, const qtri_options *o, bool has_light)
{
    qtri_small_uv at;
    curvature c;
    qtri_small_uv_find(&at, t);
    int32_t f[2][3] = {{at.u0, at.u1, at.u2}, {at.v0, at.v1, at.v2}};
    curves->light_piece = 0;
    curves->is_curved =
        has_light || (!t->state->is_linear && qtri_small_is_texture_curved(&at, p, t, o));
    if (!curves->is_curved) {
        texture_units units;
        set_units(&units, curves, f, p, t->state, o);
        for (int k = 0; k < 2; k++) {
            qtri_small_ramp_set(&curves->linear[k], p, units.base[k], f[k][1], f[k][2],
                                (int32_t)units.up[k]);
        }
        return true;
    }
    return set_curvature(&c, p, t) && set_texture_curves(curves, &c, f, p, t, o) &&
           (!has_light || set_light_curve(curves, &c, p, t, o));
}

/* Mipmap levels -------------------------------------------------------------------------------- */

/*
 * The level is that of the footprint at vertex 0: what u gains from there is l / (1 + e), l = f (1
 * + e) at vertices 1 and 2, so its steps there are those of l: n / size, where n are the numerators
 * of ramps, times 256 a pixel.
 */
enum { EVEN_Q6 = 5 /* 1/w of vertices 1 and 2 may be this by 64, 1/12.8, off that of vertex 0 */ };

/* The length of a step, of the magnitudes of both its parts: .97 to 1.07 of it. */
static uint32_t length_of(uint32_t a, uint32_t b)
{
    return a > b ? a + (3 * (b >> 3)) : b + (3 * (a >> 3));
}

/* The greatest step of both axes, times size / 256, in 2^-fraction of a texel. */
static uint32_t step_of(int32_t f[2][2], const int32_t up[2], int32_t fraction,
                        const qtri_small_place *p, const int32_t e_q18[2])
{
    uint32_t right[2], down[2];
    for (int i = 0; i < 2; i++) {
        const int32_t f1 = scaled(shifted(f[i][0], fraction - up[i]), e_q18[0]);
        const int32_t f2 = scaled(shifted(f[i][1], fraction - up[i]), e_q18[1]);
        right[i] = qtri_small_about(f2 * p->dy1 - f1 * p->dy2);
        down[i] = qtri_small_about(f1 * p->dx2 - f2 * p->dx1);
    }
    const uint32_t across = length_of(right[0], right[1]);
    const uint32_t along = length_of(down[0], down[1]);
    return across > along ? across : along;
}

/*
 * Differences have 14 bits of the greatest, in 2^-fraction of a texel: f (1 + e) is below 2^14.2, a
 * numerator below 2 2^14.2 2^13.91 and its length below 2^29.6. Of zeros from 1 to 32 and a side
 * from 1 to 1024, fraction is -11..30, f goes up by -27..14, and `shift` is -19..30.
 *
 * A level is left behind where length 2^(8 - fraction) / size is 2^(level + 1/2) or more; 1 + 1/4 +
 * 1/8 + 1/32 + 1/128 stands in for 2^(1/2), .00011 of it less.
 */
static uint32_t level_of(const qtri_small_place *p, const qtri_small *t, const int32_t e_q18[2])
{
    const qtri_draw_state *state = t->state;
    const int32_t side_log2[2] = {state->width_log2, state->height_log2};
    const uint32_t size = (uint32_t)(p->dx2 * p->dy1 - p->dx1 * p->dy2); /* < 2^28.9 */
    qtri_small_uv at;
    int32_t up[2];
    int32_t fraction = INT32_MAX;
    qtri_small_uv_find(&at, t);
    int32_t f[2][2] = {{at.u1, at.u2}, {at.v1, at.v2}};
    for (int i = 0; i < 2; i++) {
        up[i] = 16 - side_log2[i]; /* 6..16: f has so many bits of a texel's fraction */
        const int32_t zeros = qtri_clz32(qtri_small_about(f[i][0]) | qtri_small_about(f[i][1]));
        fraction = qtri_least32(fraction, zeros - 18 + up[i]);
    }
    const uint32_t length = step_of(f, up, fraction, p, e_q18);
    const uint32_t limit = size + (size >> 2) + (size >> 3) + (size >> 5) + (size >> 7);
    uint32_t level = 0;
    while (level < state->last_level) {
        const int32_t shift = (int32_t)level + fraction - 8;
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): shift is -19..30
        if (shift >= 0 ? length >> shift < limit : length <= (limit - 1) >> -shift) {
            break;
        }
        level++;
    }
    return level;
}

static bool is_even(int32_t q, uint32_t inv_w)
{
    return qtri_small_about(q) <= (inv_w >> 6) * EVEN_Q6;
}

bool qtri_small_find_level(const qtri_small_place *p, const qtri_small *t)
{
    qtri_draw_state *state = t->state;
    const uint32_t inv_w = t->v[0]->inv_w;
    int32_t e_q18[2] = {0, 0};
    if (state->last_level == 0) {
        return true;
    }
    if (!t->state->is_linear) {
        if (!is_even(p->q1, inv_w) || !is_even(p->q2, inv_w)) {
            return false;
        }
        find_e(e_q18, p, t);
    }
    const uint32_t level = level_of(p, t, e_q18);
    if (level != state->level) {
        qtri_draw_state_set_level(state, level);
    }
    return true;
}
