/* SPDX-License-Identifier: MIT */
/* Small triangles: the set-up that pipelines do not inline, and rare cases. */
#include "qtri/body/small_setup.h"

#include "../geometry/lighting.h"
#include "descriptions.h"

qtri_small_found qtri_small_find(qtri_small_place *p, uint8_t spans[QTRI_SMALL_SPANS],
                                 qtri_small *t)
{
    return qtri_setup_find(p, spans, t);
}

void qtri_small_ramp_set_at(qtri_small_ramp *r, const qtri_small_place *p, int32_t x, int32_t y,
                            uint32_t value, int32_t f1, int32_t f2, int32_t up)
{
    qtri_setup_ramp_set_at(r, p, x, y, value, f1, f2, up);
}

/* 1/w of b in the scale of a, less that of a. */
static inline int32_t inv_w_difference(const qtri_vertex *a, const qtri_vertex *b)
{
    const uint32_t up = (b->depth_16p8 & 0xFF) - (a->depth_16p8 & 0xFF) + 1;
    if (up > 2) {
        return INT32_MAX;
    }
    return (int32_t)((up == 0 ? b->inv_w >> 1 : b->inv_w << (up - 1)) - a->inv_w);
}

/* Whether inv_w + q is 3/4 to 3/2 of inv_w. */
static inline bool is_in_range(int32_t q, uint32_t inv_w)
{
    return qtri_small_abs(q) <= inv_w >> (q < 0 ? 2 : 1);
}

bool qtri_small_find_uneven(int32_t q[2], const qtri_small *t)
{
    const uint32_t inv_w = t->v[0]->inv_w;
    q[0] = inv_w_difference(t->v[0], t->v[1]);
    q[1] = inv_w_difference(t->v[0], t->v[2]);
    return is_in_range(q[0], inv_w) && is_in_range(q[1], inv_w);
}

bool qtri_small_turn(qtri_small *t, int32_t size)
{
    if (size == 0 || t->state->material->cull == QTRI_CULL_BACK) {
        return false;
    }
    qtri_vertex *const v = t->v[1];
    t->v[1] = t->v[2];
    t->v[2] = v;
    const uint32_t index = t->index[1];
    t->index[1] = t->index[2];
    t->index[2] = index;
    return true;
}

bool qtri_small_cut(uint8_t *span, int32_t left, int32_t right)
{
    const int32_t least = qtri_small_clamp(left, 0, QTRI_SMALL_STOP - 1);
    const int32_t greatest = qtri_small_clamp(right, 0, QTRI_SMALL_STOP - 1);
    bool any = false;
    for (; span[0] != QTRI_SMALL_STOP; span += 2) {
        span[0] = (uint8_t)qtri_small_clamp(span[0], least, greatest);
        span[1] = (uint8_t)qtri_small_clamp(span[1], least, greatest);
        any |= span[0] < span[1];
    }
    return any;
}

uint32_t qtri_small_color(const qtri_small *t)
{
    const qtri_draw_state *state = t->state;
    const uint32_t light_q15 =
        t->light_q15 <= QTRI_INTENSITY_ONE ? t->light_q15 : QTRI_INTENSITY_ONE;
    uint32_t rgb = state->color;
    if (state->is_lit) {
        return state->lit[qtri_provoking_of(state->material)] & 0xFFFFFFu;
    }
    if (t->mesh->colors != NULL) {
        const uint16_t *wide = t->indices;
        const uint8_t *narrow = t->indices;
        const int i = qtri_provoking_of(state->material);
        rgb = qtri_pixel_rgb_to_888(
            &t->mesh->colors[t->mesh->triangles8 != NULL ? narrow[i] : wide[i]]);
    }
    if (light_q15 == QTRI_INTENSITY_ONE) {
        return rgb;
    }
    const uint32_t half = (uint32_t)1 << 14;
    return ((rgb >> 16) * light_q15 + half) >> 15 << 16 |
           ((rgb >> 8 & 255) * light_q15 + half) >> 15 << 8 |
           ((rgb & 255) * light_q15 + half) >> 15;
}
