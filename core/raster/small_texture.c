/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates of small triangles, and mipmap levels.
 *
 * What is interpolated linearly on the screen strays from perspective by the covariance of 1/w and
 * the value, which is at most range(u) range(q) / (4 q_min); where that could be more than
 * 2^-QTRI_SMALL_TEXEL_LOG2 texel it is a curve (small_curves.h), or found by division
 * (small_division.c).
 */
#include "small_curves.h"

#include <stddef.h>

#include "descriptions.h"

#include "../bits/bits.h"

/* Texture coordinates -------------------------------------------------------------------------- */

typedef enum clamp_result {
    CROSSES, /* an end of the texture */
    INSIDE,
    AT_END
} clamp_result;

/*
 * Clamped coordinates: vertices at an end of the texture, or beyond by 1/128 texel at most, are
 * clamped 1/32 texel inside, and pixels reach no end then: what is linear lies between the
 * vertices, less what rounding takes of it, 2^-16 of a repeat, and what bends is off by .84 of 1/32
 * texel at most. Where texels are filtered it is the centres of outer texels that vertices are
 * clamped to; a pixel that is beyond one by so little has as little of a wrong texel.
 */
static clamp_result clamp_axis(int32_t f[3], uint32_t side_log2, bool bilinear)
{
    const int32_t little = (512 >> side_log2) + 1, inside = bilinear ? 0 : (2048 >> side_log2) + 1;
    const int32_t low = bilinear ? 32768 >> side_log2 : 0, high = 65536 - low;
    const int32_t a = f[0], b = (int32_t)((uint32_t)a + (uint32_t)f[1]);
    const int32_t c = (int32_t)((uint32_t)a + (uint32_t)f[2]);
    const int32_t least = qtri_least32(a, qtri_least32(b, c));
    const int32_t most = qtri_greatest32(a, qtri_greatest32(b, c));
    if (least >= low + 4 * inside && most <= high - 4 * inside) {
        return INSIDE;
    }
    if ((least < low - little && most > low) || (most > high + little && least < high)) {
        return CROSSES;
    }
    f[0] = qtri_hold32(a, low + inside, high - inside);
    f[1] = qtri_hold32(b, low + inside, high - inside) - f[0];
    f[2] = qtri_hold32(c, low + inside, high - inside) - f[0];
    return AT_END;
}

/* Clamps both axes. CROSSES also of a needle, whose steps are less exact, and of a texture one
   texel wide, whose u is 0: the large path clamps them. */
static clamp_result clamp_uv(qtri_small_uv *f, const qtri_small_place *p,
                             const qtri_draw_state *state, const qtri_options *o)
{
    clamp_result u = INSIDE, v = INSIDE;
    if ((state->traits & QTRI_CLAMPS_U) != 0) {
        u = clamp_axis(f->u, qtri_texture_width_log2(o, state), o->bilinear);
    }
    if ((state->traits & QTRI_CLAMPS_V) != 0) {
        v = clamp_axis(f->v, qtri_texture_height_log2(o, state), o->bilinear);
    }
    if (u == CROSSES || v == CROSSES || (state->traits & QTRI_ONE_WIDE) != 0) {
        return CROSSES;
    }
    return u == INSIDE && v == INSIDE ? INSIDE : p->up != 0 ? CROSSES : AT_END;
}

/* Brings differences to what a ramp takes; returns how many bits they lost. */
static uint32_t reduce(int32_t f[3], uint32_t bits)
{
    uint32_t down = 0;
    while ((qtri_small_abs(f[1]) | qtri_small_abs(f[2])) >> (bits + down) != 0) {
        down++;
    }
    if (down != 0) { /* rounded */
        f[1] = ((f[1] >> (down - 1)) + 1) >> 1;
        f[2] = ((f[2] >> (down - 1)) + 1) >> 1;
    }
    return down;
}

/* Values of u and v for curves or ramps, of any texture and differences. */
static void set_values(qtri_small_value value[2], qtri_small_uv *uv, uint32_t by,
                       const qtri_small_place *p, const qtri_draw_state *state,
                       const qtri_options *o)
{
    const uint32_t side_log2[2] = {qtri_texture_width_log2(o, state),
                                   qtri_texture_height_log2(o, state)};
    for (int k = 0; k < 2; k++) {
        const bool is_v = k == 1 && !o->large_texture;
        const uint32_t unit = is_v ? side_log2[0] + side_log2[1] : 16; /* 2^(16 + it) a repeat */
        const uint32_t shift = is_v ? 16 + side_log2[0] : 32 - side_log2[k];
        int32_t *f = k == 0 ? uv->u : uv->v;
        uint32_t base = (uint32_t)f[0] << unit, up = 0;
        if (unit < 8) {
            f[1] >>= 8 - unit;
            f[2] >>= 8 - unit;
        } else {
            up = unit - 8;
        }
        up += reduce(f, p->wide ? 15 : 16);
        base += (uint32_t)1 << (shift - 1) >> 10;
        if (o->bilinear) {
            base -= (uint32_t)1 << (shift - 1);
        }
        value[k].value = base;
        value[k].f1 = f[1];
        value[k].f2 = f[2];
        value[k].up = (int32_t)up;
        value[k].unit_log2 = (int32_t)shift - (int32_t)up - 6; /* 2^-6 texel */
        value[k].by = by;
        value[k].bend = 0;
    }
}

bool qtri_small_set_linear_texture(qtri_small_ramp *u, qtri_small_ramp *v,
                                   const qtri_small_place *p, const qtri_small *t,
                                   const qtri_options *o)
{
    qtri_small_uv f;
    if (o->bilinear || o->large_texture || (t->state->traits & QTRI_FEW_TEXELS) != 0) {
        return false;
    }
    qtri_small_uv_find(&f, t);
    if ((t->state->traits != 0 && clamp_uv(&f, p, t->state, o) == CROSSES) ||
        !qtri_small_is_linear_texture(&f, p, t, o)) {
        return false;
    }
    qtri_small_set_linear(u, v, p, &f, qtri_texture_width_log2(o, t->state),
                          qtri_texture_height_log2(o, t->state));
    return true;
}

/* Curves --------------------------------------------------------------------------------------- */

/* Whether curves of u and v stray from perspective by 2^(by - 10) texel at most. */
static bool are_near_curves(const qtri_curvature *c, const qtri_small_uv *f, uint32_t by,
                            const qtri_small *t, const qtri_options *o)
{
    const uint32_t u = qtri_small_range(f->u[1], f->u[2]) >> /* 2^-6 texel */
                       (10 - qtri_texture_width_log2(o, t->state));
    const uint32_t v =
        qtri_small_range(f->v[1], f->v[2]) >> (10 - qtri_texture_height_log2(o, t->state));
    return qtri_small_is_near_curve(c, u > v ? u : v, by);
}

bool qtri_small_set_curves(qtri_small_curves *curves, qtri_small_division *division,
                           const qtri_small_place *p, const qtri_small *t, const qtri_options *o,
                           bool curved)
{
    /* 1/16 texel at most; 1/32 where more pixels show it, and a quarter of that of filtered ones */
    uint32_t by = 6u - qtri_small_is_beyond_middle(p) - (o->bilinear ? 2u : 0);
    const bool lit = curved && qtri_is_lit(o);
    qtri_small_uv at;
    qtri_small_value value[2], light;
    qtri_curvature c;
    bool is_near = true, is_lit_near = true;
    const bool is_clamped = (t->state->traits & ~QTRI_FEW_TEXELS) != 0;
    curves->light_piece = 0;
    curves->is_curved = false;
    if (is_clamped && !curved &&
        qtri_small_set_linear_texture(&curves->linear[0], &curves->linear[1], p, t, o)) {
        return true;
    }
    qtri_small_uv_find(&at, t);
    if (is_clamped) {
        const clamp_result found = clamp_uv(&at, p, t->state, o);
        if (found == CROSSES) {
            return false;
        }
        by = found == AT_END && by > 5 ? 5 : by; /* 1/32 */
    }
    curves->is_curved =
        curved || (!t->state->is_linear && qtri_small_is_texture_curved(&at, p, t, o));
    if (curves->is_curved) {
        if (!qtri_small_set_curvature(&c, p, t)) {
            return false;
        }
        is_near = are_near_curves(&c, &at, by, t, o);
        if (lit) {
            qtri_small_find_light(&light, t, o);
            is_lit_near =
                qtri_small_is_near_curve(&c, qtri_small_range(light.f1, light.f2), light.by);
        }
    }
    set_values(value, &at, by, p, t->state, o);
    if (!curves->is_curved) {
        for (int k = 0; k < 2; k++) {
            qtri_small_ramp_set(&curves->linear[k], p, value[k].value, value[k].f1, value[k].f2,
                                value[k].up);
        }
        return true;
    }
    if (division != NULL) {
        qtri_small_disable_division(division);
    }
    if (lit && is_lit_near) {
        qtri_small_set_light_along(curves, &c, p, &light);
    }
    if (is_near && is_lit_near) {
        qtri_small_set_curve(&curves->u, p, &c, &value[0]);
        qtri_small_set_curve(&curves->v, p, &c, &value[1]);
        return value[0].up + p->up <= 16 && value[1].up + p->up <= 16;
    }
    if (division == NULL || !qtri_small_begin_division(division, &curves->light_piece, &c, p) ||
        !qtri_small_add_divided(division, &curves->u, &value[0], &c, p) ||
        !qtri_small_add_divided(division, &curves->v, &value[1], &c, p) ||
        (!is_lit_near && !qtri_small_add_divided(division, &curves->c, &light, &c, p))) {
        return false;
    }
    qtri_small_end_division(division);
    return true;
}

/* Mipmap levels -------------------------------------------------------------------------------- */

/*
 * The level is that of the footprint at vertex 0: what u gains from there is l / (1 + e), l = f (1
 * + e) at vertices 1 and 2, so its steps there are those of l: n / size, where n are the numerators
 * of ramps, times 256 a pixel.
 */
enum {
    MAX_CHANGE_Q6 = 5 /* 1/w of vertices 1 and 2 may be this by 64, 1/12.8, off that of vertex 0 */
};

/* The greatest step of both axes, times size / 256, in 2^-fraction of a texel. */
static uint32_t step_of(int32_t f[2][2], const int32_t up[2], int32_t fraction,
                        const qtri_small_place *p, const int32_t e_q18[2])
{
    uint32_t right[2], down[2];
    for (int i = 0; i < 2; i++) {
        const int32_t f1 = qtri_small_scaled(qtri_shift32(f[i][0], fraction - up[i]), e_q18[0]);
        const int32_t f2 = qtri_small_scaled(qtri_shift32(f[i][1], fraction - up[i]), e_q18[1]);
        right[i] = qtri_small_abs(f2 * p->dy1 - f1 * p->dy2);
        down[i] = qtri_small_abs(f1 * p->dx2 - f2 * p->dx1);
    }
    const uint32_t across = qtri_step_length(right[0], right[1]);
    const uint32_t along = qtri_step_length(down[0], down[1]);
    return across > along ? across : along;
}

/*
 * Differences have 14 bits of the greatest, in 2^-fraction of a texel: f (1 + e) is below 2^14.2, a
 * numerator below 2 2^14.2 2^14.91 and its length below 2^30.6. Of zeros from 1 to 32 and a side
 * from 1 to 1024, fraction is -11..30, f goes up by -27..14, and `shift` is -19..30.
 *
 * A level is left behind where length 2^(8 - fraction) / size is 2^(level + 1/2) or more; 1 + 1/4 +
 * 1/8 + 1/32 + 1/128 stands in for 2^(1/2), .00011 of it less.
 */
static uint32_t level_of(const qtri_small_place *p, const qtri_small *t, const int32_t e_q18[2])
{
    const qtri_draw_state *state = t->state;
    const int32_t side_log2[2] = {state->width_log2, state->height_log2};
    const uint32_t size = (uint32_t)(p->dx2 * p->dy1 - p->dx1 * p->dy2); /* < 2^30.9 */
    qtri_small_uv at;
    int32_t up[2];
    int32_t fraction = INT32_MAX;
    qtri_small_uv_find(&at, t);
    int32_t f[2][2] = {{at.u[1], at.u[2]}, {at.v[1], at.v[2]}};
    for (int i = 0; i < 2; i++) {
        up[i] = 16 - side_log2[i]; /* 6..16: f has so many bits of a texel's fraction */
        const int32_t zeros = qtri_clz32(qtri_small_abs(f[i][0]) | qtri_small_abs(f[i][1]));
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

static bool is_nearly_constant(int32_t q, uint32_t inv_w)
{
    return qtri_small_abs(q) <= (inv_w >> 6) * MAX_CHANGE_Q6;
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
        if (!is_nearly_constant(p->q1, inv_w) || !is_nearly_constant(p->q2, inv_w)) {
            return false;
        }
        qtri_small_find_inv_w_deltas(e_q18, p, t);
    }
    const uint32_t level = level_of(p, t, e_q18);
    if (level != state->level) {
        qtri_draw_state_set_level(state, level);
    }
    return true;
}
