/* SPDX-License-Identifier: MIT */
/*
 * The level of a small triangle: of the footprint at vertex 0. With the names of small_texture.c
 * what u gains from there is l / (1 + e) with l = 0 there, so its steps are those of l: n / size,
 * where n are the numerators of ramps, times 256 a pixel.
 */
#include "small_place.h"

enum { EVEN_Q6 = 5 /* 1/w of vertices 1 and 2 may be this by 64, 1/12.8, off that of vertex 0 */ };

/* The length of a step, of the magnitudes of both its parts: .97 to 1.07 of it. */
static uint32_t length_of(uint32_t a, uint32_t b)
{
    return a > b ? a + (3 * (b >> 3)) : b + (3 * (a >> 3));
}

/* x 2^up, rounded down. */
static int32_t shifted(int32_t x, int32_t up)
{
    return up >= 0 ? (int32_t)((uint32_t)x << up) : x >> (up < -31 ? 31 : -up);
}

/* The greatest step of both axes, times size / 256, in 2^-fraction of a texel. */
static uint32_t step_of(int32_t f[2][2], const int32_t up[2], int32_t fraction,
                        const qtri_small_place *p, const int32_t e_q18[2])
{
    uint32_t right[2], down[2];
    for (int i = 0; i < 2; i++) {
        const int32_t f1 = qtri_small_scaled(shifted(f[i][0], fraction - up[i]), e_q18[0]);
        const int32_t f2 = qtri_small_scaled(shifted(f[i][1], fraction - up[i]), e_q18[1]);
        right[i] = qtri_small_about(f2 * p->dy1 - f1 * p->dy2);
        down[i] = qtri_small_about(f1 * p->dx2 - f2 * p->dx1);
    }
    const uint32_t across = length_of(right[0], right[1]);
    const uint32_t along = length_of(down[0], down[1]);
    return across > along ? across : along;
}

/*
 * Differences have 14 bits of the greatest, in 2^-fraction of a texel: f (1 + e) is below 2^14.2, a
 * numerator below 2 2^14.2 2^13.91 and its length below 2^29.6.
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
        up[i] = 16 - side_log2[i]; /* f has so many bits of a texel's fraction */
        const int32_t zeros = qtri_clz32(qtri_small_about(f[i][0]) | qtri_small_about(f[i][1]));
        fraction = zeros - 18 + up[i] < fraction ? zeros - 18 + up[i] : fraction;
    }
    const uint32_t length = step_of(f, up, fraction, p, e_q18);
    const uint32_t limit = size + (size >> 2) + (size >> 3) + (size >> 5) + (size >> 7);
    uint32_t level = 0;
    while (level < state->last_level) {
        const int32_t shift = (int32_t)level + fraction - 8;
        if (shift >= 0 ? length >> (shift < 31 ? shift : 31) < limit
                       : length <= (limit - 1) >> (shift > -31 ? -shift : 31)) {
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

bool qtri_small_set_level(const qtri_small_place *p, const qtri_small *t)
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
        const int32_t y = (int32_t)qtri_small_reciprocal(inv_w >> 15);
        e_q18[0] = ((p->q1 >> 14) * y + ((int32_t)1 << 13)) >> 14;
        e_q18[1] = ((p->q2 >> 14) * y + ((int32_t)1 << 13)) >> 14;
    }
    const uint32_t level = level_of(p, t, e_q18);
    if (level != state->level) {
        qtri_draw_state_set_level(state, level);
    }
    return true;
}
