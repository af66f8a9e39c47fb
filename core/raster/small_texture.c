/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates of small triangles.
 *
 * What is interpolated linearly on the screen strays from perspective by the covariance of 1/w and
 * the coordinate, which is at most range(u) range(q) / (4 q_min); where that could be more than
 * 2^-QTRI_SMALL_TEXEL_LOG2 texel they follow perspective: at vertex i l_i = (u_i - u_0) (1 + e_i),
 * e being what q has more than at vertex 0 by its value there; u = u_0 + l / (1 + e) at both ends
 * of pieces, linear between. With w = e - e^2 + e^3 - e^4, l (1 - w) is off by l e^5.
 */
#include "small_place.h"

const uint16_t qtri_small_part[17] = {0,    32768, 16384, 10923, 8192, 6554, 5461, 4681, 4096,
                                      3641, 3277,  2979,  2731,  2521, 2341, 2185, 2048};

/* Brings differences to what a ramp takes; returns how many bits they lost. */
static uint32_t reduce(int32_t f[3], uint32_t bits)
{
    uint32_t down = 0;
    while ((qtri_small_about(f[1]) | qtri_small_about(f[2])) >> (bits + down) != 0) {
        down++;
    }
    f[1] >>= down;
    f[2] >>= down;
    return down;
}

/* From u_0 on in units of 2^-28 of a repeat or coarser ones, as they fit. */
static uint32_t clamp_axis_set(qtri_clamp_axis *axis, int32_t u0, uint32_t side_log2, uint32_t down)
{
    const uint32_t whole = 16 - side_log2; /* Q16 of a texel */
    const uint32_t fraction = (uint32_t)u0 & (((uint32_t)1 << whole) - 1);
    axis->shift = (uint8_t)(28 - down - side_log2);
    axis->mask = (uint16_t)(((uint32_t)1 << side_log2) - 1);
    axis->first = -(u0 >> whole);
    return down <= 12 ? fraction << (12 - down) : fraction >> (down - 12);
}

/* Where coordinates begin at vertex 0, and by how much differences go left, in the walk's units. */
typedef struct texture_units {
    uint32_t base[2];
    uint32_t up[2];
} texture_units;

/* Of any axes and differences. */
static void set_units(texture_units *units, qtri_small_texture *uv, int32_t f[2][3],
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
            const uint32_t down = reduce(f[k], bits);
            up = 4;
            base = clamp_axis_set(&uv->axis[k], f[k][0], side_log2[k], down);
            shift = uv->axis[k].shift;
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
            up += reduce(f[k], bits);
            base = (uint32_t)f[k][0] << unit;
            shift = is_v ? 16 + side_log2[0] : 32 - side_log2[k];
        }
        base += shift > 11 ? (uint32_t)1 << (shift - 11) : 0;
        if (o->bilinear) { /* from texels' centres */
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

void qtri_small_set_texture(qtri_small_texture *uv, const qtri_small_place *p, const qtri_small *t,
                            const qtri_options *o)
{
    qtri_small_uv at;
    texture_units units;
    qtri_small_uv_find(&at, t);
    int32_t f[2][3] = {{at.u0, at.u1, at.u2}, {at.v0, at.v1, at.v2}};
    uv->curved = !t->state->is_linear && qtri_small_is_texture_curved(&at, p, t, o);
    set_units(&units, uv, f, p, t->state, o);
    if (!uv->curved) {
        qtri_small_ramp_set(&uv->u, p, units.base[0], f[0][1], f[0][2], (int32_t)units.up[0]);
        qtri_small_ramp_set(&uv->v, p, units.base[1], f[1][1], f[1][2], (int32_t)units.up[1]);
        return;
    }
    const int32_t y = (int32_t)qtri_small_reciprocal(t->v[0]->inv_w >> 15);
    const int32_t e1 = ((p->q1 >> 14) * y + ((int32_t)1 << 13)) >> 14; /* Q18 */
    const int32_t e2 = ((p->q2 >> 14) * y + ((int32_t)1 << 13)) >> 14;
    uv->u0 = units.base[0];
    uv->v0 = units.base[1];
    uv->u_up = units.up[0];
    uv->v_up = units.up[1];
    qtri_small_ramp_set(&uv->e, p, 0, e1, e2, 0);
    qtri_small_ramp_set(&uv->u, p, 0, qtri_small_scaled(f[0][1], e1),
                        qtri_small_scaled(f[0][2], e2), 0);
    qtri_small_ramp_set(&uv->v, p, 0, qtri_small_scaled(f[1][1], e1),
                        qtri_small_scaled(f[1][2], e2), 0);
    /* A chord over n pixels is off by u_x e_x n^2 / 4: by 1/32 of a pixel's step or less. */
    const uint32_t bend = (qtri_small_about((int32_t)uv->e.dx) >> 8) + 1; /* Q18, <= 2^23 */
    uint32_t n = 16;
    while (n > 1 && n * n * bend > (uint32_t)1 << 15) {
        n--;
    }
    uv->piece = n;
}
