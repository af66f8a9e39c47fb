/* SPDX-License-Identifier: MIT */
#include "list_values.h"

#include "../geometry/projector.h"
#include "stage_color.h"
#include "tint.h"

/* The ramp of an attribute: f0 at vertex 0, differences without QTRI_PLACE_DOWN bits, 2^16 at most.
 */
static void ramp_of(qtri_ramp *ramp, const qtri_list_values *v, uint32_t f0, int32_t f1, int32_t f2)
{
    qtri_place_ramp(ramp, v->t->place, &v->inverse, f0, f1, f2);
}

/* That of l. */
static void curve_of(qtri_ramp *ramp, const qtri_list_values *v, int32_t f1, int32_t f2)
{
    ramp_of(ramp, v, 0, qtri_list_scaled(f1, v->e1_q18), qtri_list_scaled(f2, v->e2_q18));
}

void qtri_list_find_e(qtri_list_values *v)
{
    if (v->has_e) {
        return;
    }
    v->has_e = true;
    v->e1_q18 = 0;
    v->e2_q18 = 0;
    v->e_q26.origin = 0;
    v->e_q26.dx = 0;
    v->e_q26.dy = 0;
    if (!v->raster->perspective) {
        return;
    }
    const int32_t more1 = v->t->place->more1;
    const int32_t more2 = v->t->place->more2;
    if ((more1 | more2) != 0) {
        /* |more| <= 2^31 / 12.8, y = 2^46 / inv_w <= 2^16 */
        const int32_t y = (int32_t)qtri_reciprocal_q31(v->t->v[0]->inv_w >> 15);
        v->e1_q18 = ((more1 >> 13) * y + ((int32_t)1 << 14)) >> 15;
        v->e2_q18 = ((more2 >> 13) * y + ((int32_t)1 << 14)) >> 15;
        ramp_of(&v->e_q26, v, 0, v->e1_q18, v->e2_q18);
    }
}

bool qtri_list_follow(qtri_list_values *v)
{
    const qtri_place *p = v->t->place;
    const int32_t height = qtri_greatest_from_0(p->dy1, p->dy2) - qtri_least_from_0(p->dy1, p->dy2);
    const int32_t left = qtri_least_from_0(p->dx1, p->dx2);
    const int32_t right = qtri_greatest_from_0(p->dx1, p->dx2);
    const int32_t half = (right - left + 0x100) >> 9;
    const uint32_t limit = QTRI_PIECE_E_Q26;
    if (p->size < (uint32_t)height * (2 * 3 * 256) || v->e_q26.dx + limit >= 2 * limit) {
        return false;
    }
    v->half = (uint8_t)(half > QTRI_PIECE / 2 ? QTRI_PIECE / 2 : half);
    v->left = (uint32_t)((left + 128 - p->x) >> 8);
    const int32_t e_q16 = ((int32_t)v->e_q26.dx >> 10) * v->half; /* <= 1/32 */
    v->cubic_q16 = (uint8_t)((3 * e_q16 * e_q16) >> 18);
    return true;
}

/* Colours ------------------------------------------------------------------------------------- */

uint32_t qtri_list_flat_color(const qtri_raster *raster, const qtri_list_triangle *t)
{
    return t->color != NULL ? raster->units->pack(t->color[raster->provoking])
                            : qtri_raster_tinted(raster, t->light_q15, 15);
}

uint32_t qtri_list_flat_shade(const qtri_raster *raster, const qtri_list_triangle *t)
{
    return qtri_shade_of(t->color[raster->provoking]);
}

bool qtri_list_is_one_color(const qtri_list_triangle *t)
{
    int32_t differ = 0;
    for (int i = 0; i < 3; i++) {
        differ |= (t->color[1][i] ^ t->color[0][i]) | (t->color[2][i] ^ t->color[0][i]);
    }
    return differ == 0;
}

/* Of what a raster interpolates. */
static inline bool is_linear(const qtri_list_values *v, int32_t d1, int32_t d2, uint32_t part)
{
    const qtri_place *p = v->t->place;
    return !(QTRI_WITH_PERSPECTIVE && v->raster->perspective) ||
           qtri_list_is_linear(v->t->v[0]->inv_w, p->more1, p->more2, d1, d2, part);
}

/* Of light, Q15: 1/8 of 63 steps or of 255. */
static uint32_t light_part(const qtri_raster *raster)
{
    const qtri_colors *colors = raster->texture != NULL ? raster->working : raster->units;
    return colors == &qtri_colors_565 || colors->finer != 0 ? 3 : 5;
}

/* The tint's widest channel differs by n.9, below 2^15 255 2^-6 and what is cut off. */
QTRI_NOINLINE bool qtri_list_tint_is_linear(const qtri_raster *raster, uint32_t q0, int32_t q1,
                                            int32_t q2, int32_t i1, int32_t i2)
{
    if (!(QTRI_WITH_PERSPECTIVE && raster->perspective)) {
        return true;
    }
    const uint32_t range =
        (uint32_t)(qtri_greatest_from_0(i1, i2) - qtri_least_from_0(i1, i2)); /* <= 2^15 */
    const uint32_t most = (range * qtri_raster_widest_tint(raster) >> 14) + 1;
    return qtri_list_is_linear(q0, q1, q2, (int32_t)most, 0, 3u - raster->units->finer);
}

bool qtri_list_tint_is_simple(const qtri_raster *raster, const qtri_vertex *a, const qtri_vertex *b,
                              const qtri_vertex *c, int32_t i1, int32_t i2)
{
    int32_t more1;
    int32_t more2;
    return qtri_inv_w_more(&more1, a, b) && qtri_inv_w_more(&more2, a, c) &&
           (qtri_list_is_linear(a->inv_w, more1, more2, i1, i2, 3) ||
            qtri_list_tint_is_linear(raster, a->inv_w, more1, more2, i1, i2));
}

/* Apart, so that others do not pay for it. */
QTRI_NOINLINE static bool is_linear_tint(const qtri_list_values *v, int32_t i1, int32_t i2)
{
    const qtri_place *p = v->t->place;
    return v->raster->texture == NULL &&
           qtri_list_tint_is_linear(v->raster, v->t->v[0]->inv_w, p->more1, p->more2, i1, i2);
}

void qtri_list_set_light(qtri_list_values *v, uint32_t shift)
{
    const qtri_list_triangle *t = v->t;
    const int32_t round = (int32_t)1 << (shift - 1);
    v->channels = 0;
    if (t->light_q15 != QTRI_VERTEX_UNLIT) {
        v->constant = ((t->light_q15 << 7) + (uint32_t)round) >> shift;
        return;
    }
    const int32_t i0 = t->v[0]->intensity_q15;
    const int32_t i1 = t->v[v->second]->intensity_q15 - i0;
    const int32_t i2 = t->v[v->third]->intensity_q15 - i0;
    const int32_t f1 = (i1 + 1) >> (QTRI_PLACE_DOWN - 7);
    const int32_t f2 = (i2 + 1) >> (QTRI_PLACE_DOWN - 7);
    v->channels = 1;
    v->base[2] = ((uint32_t)i0 << 7) + (uint32_t)round;
    v->curved = !is_linear(v, i1, i2, light_part(v->raster)) && !is_linear_tint(v, i1, i2);
    if (v->curved) {
        qtri_list_find_e(v);
        curve_of(&v->channel[2], v, f1, f2);
        v->even = qtri_list_follow(v);
    } else {
        ramp_of(&v->channel[2], v, v->base[2], f1, f2);
    }
}

/* Whether all channels are linear: the one that varies most is. */
static bool are_linear(const qtri_list_values *v, int first)
{
    const int32_t(*color)[3] = v->t->color;
    int32_t most = 0;
    for (int i = first; i < 3; i++) {
        const int32_t d1 = (color[v->second][i] - color[0][i]) >> 7;
        const int32_t d2 = (color[v->third][i] - color[0][i]) >> 7;
        const int32_t range = qtri_greatest_from_0(d1, d2) - qtri_least_from_0(d1, d2);
        most = range > most ? range : most;
    }
    return is_linear(v, most, 0, 3u - v->raster->units->finer);
}

void qtri_list_set_channels(qtri_list_values *v, uint32_t shift)
{
    const int32_t(*color)[3] = v->t->color;
    const int first = v->raster->units->single ? 2 : 0;
    const int32_t half = (int32_t)1 << (QTRI_PLACE_DOWN - 1);
    const bool linear = are_linear(v, first);
    v->curved = !linear;
    v->channels = (uint8_t)(3 - first);
    if (!linear) {
        qtri_list_find_e(v);
        v->even = qtri_list_follow(v);
    }
    for (int i = first; i < 3; i++) {
        const int32_t c0 = color[0][i];
        const int32_t f1 = (color[v->second][i] - c0 + half) >> QTRI_PLACE_DOWN;
        const int32_t f2 = (color[v->third][i] - c0 + half) >> QTRI_PLACE_DOWN;
        v->base[i] = (uint32_t)c0 + ((uint32_t)1 << (shift - 1));
        if (linear) {
            ramp_of(&v->channel[i], v, v->base[i], f1, f2);
        } else {
            curve_of(&v->channel[i], v, f1, f2);
            v->even = v->even && (qtri_about(f1) | qtri_about(f2)) >> 15 == 0 &&
                      qtri_list_is_even(&v->channel[i]);
        }
    }
}

static void one(uint32_t *out, const uint32_t *place, int32_t count, const qtri_ramp *ramp,
                uint32_t shift)
{
    const qtri_ramp r = *ramp;
    const uint32_t *end = place + count;
    do {
        const uint32_t at = *place++;
        *out++ = qtri_list_at(&r, at & 0xFFFF, at >> 16) >> shift;
    } while (place != end);
}

static inline void three(uint32_t *out, const uint32_t *place, int32_t count,
                         const qtri_ramp ramp[3], uint32_t shift, uint32_t red, uint32_t green)
{
    const qtri_ramp r = ramp[0];
    const qtri_ramp g = ramp[1];
    const qtri_ramp b = ramp[2];
    const uint32_t *end = place + count;
    do {
        const uint32_t at = *place++;
        const uint32_t x = at & 0xFFFF;
        const uint32_t y = at >> 16;
        *out++ = qtri_list_at(&r, x, y) >> shift << red | qtri_list_at(&g, x, y) >> shift << green |
                 qtri_list_at(&b, x, y) >> shift;
    } while (place != end);
}

static void curves(const qtri_list_values *v, uint32_t *out, const uint32_t *place, int32_t count,
                   uint32_t shift, uint32_t red, uint32_t green)
{
    const uint32_t *end = place + count;
    const uint32_t left[3] = {red, green, 0};
    do {
        const uint32_t x = *place & 0xFFFF;
        const uint32_t y = *place >> 16;
        const int32_t w = qtri_list_w(&v->e_q26, x, y);
        uint32_t word = 0;
        for (int i = 3 - v->channels; i < 3; i++) {
            const int32_t l = (int32_t)qtri_list_at(&v->channel[i], x, y);
            word |= (v->base[i] + (uint32_t)qtri_list_divided(l, w)) >> shift << left[i];
        }
        *out++ = word;
        place++;
    } while (place != end);
}

/* The same along rows, see qtri_list_piece. */
static void curves_along(const qtri_list_values *v, uint32_t *out, const uint32_t *place,
                         int32_t count, uint32_t shift, uint32_t red, uint32_t green)
{
    const uint32_t *const end = place + count;
    qtri_list_piece piece[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    do {
        const uint32_t first = qtri_list_piece_first(v, *place);
        const uint32_t x = (*place & 0xFFFF) - (*place - first) + v->half;
        const uint32_t y = *place >> 16;
        const int32_t w = qtri_list_w(&v->e_q26, x, y);
        for (int i = 3 - v->channels; i < 3; i++) {
            qtri_list_piece_set(&piece[i], v, &v->channel[i], x, y, w, v->base[i], 0);
        }
        const qtri_list_piece r = piece[0];
        const qtri_list_piece g = piece[1];
        const qtri_list_piece b = piece[2];
        uint32_t d = *place - first;
        do {
            *out++ = qtri_list_piece_at(&r, d) >> shift << red |
                     qtri_list_piece_at(&g, d) >> shift << green |
                     qtri_list_piece_at(&b, d) >> shift;
            d = *++place - first;
        } while (d < QTRI_PIECE);
    } while (place != end);
}

void qtri_list_words(const qtri_list_values *v, uint32_t *out, const uint32_t *place, int32_t count,
                     uint32_t shift, uint32_t red, uint32_t green)
{
    if (v->channels == 0) {
        do {
            *out++ = v->constant;
        } while (--count > 0);
    } else if (v->curved && v->even) {
        curves_along(v, out, place, count, shift, red, green);
    } else if (v->curved) {
        curves(v, out, place, count, shift, red, green);
    } else if (v->channels == 1) {
        one(out, place, count, &v->channel[2], shift);
#ifndef __OPTIMIZE_SIZE__
    } else if (red == 11) { /* RGB565: constants leave registers free */
        three(out, place, count, v->channel, 16, 11, 5);
#endif
    } else {
        three(out, place, count, v->channel, shift, red, green);
    }
}
