/* SPDX-License-Identifier: MIT */
#include "list_values.h"

#include "../geometry/projector.h"
#include "stage_color.h"

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

/* Colours ------------------------------------------------------------------------------------- */

uint32_t qtri_list_flat_color(const qtri_raster *raster, const qtri_list_triangle *t)
{
    return t->color != NULL ? raster->format->colors->pack(t->color[raster->provoking])
                            : qtri_raster_tinted(raster, t->light_q15, 15);
}

uint32_t qtri_list_flat_shade(const qtri_raster *raster, const qtri_list_triangle *t)
{
    if (t->color != NULL) {
        return qtri_shade_of(t->color[raster->provoking]);
    }
    int32_t channel[3];
    for (int i = 0; i < 3; i++) {
        channel[i] = qtri_raster_shade(raster, (int32_t)(t->light_q15 << 7), i);
    }
    return qtri_shade_of(channel);
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
    v->curved = !is_linear(v, i1, i2, qtri_list_light_part(v->raster));
    if (v->curved) {
        qtri_list_find_e(v);
        curve_of(&v->channel[2], v, f1, f2);
    } else {
        ramp_of(&v->channel[2], v, v->base[2], f1, f2);
    }
}

/* Whether all channels are linear. */
static bool are_linear(const qtri_list_values *v, int first)
{
    const int32_t(*color)[3] = v->t->color;
    for (int i = first; i < 3; i++) {
        if (!is_linear(v, (color[v->second][i] - color[0][i]) >> 7,
                       (color[v->third][i] - color[0][i]) >> 7, 3)) {
            return false;
        }
    }
    return true;
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

static void three(uint32_t *out, const uint32_t *place, int32_t count, const qtri_ramp ramp[3],
                  uint32_t shift, uint32_t red, uint32_t green)
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

void qtri_list_words(const qtri_list_values *v, uint32_t *out, const uint32_t *place, int32_t count,
                     uint32_t shift, uint32_t red, uint32_t green)
{
    if (v->channels == 0) {
        do {
            *out++ = v->constant;
        } while (--count > 0);
    } else if (v->curved) {
        curves(v, out, place, count, shift, red, green);
    } else if (v->channels == 1) {
        one(out, place, count, &v->channel[2], shift);
    } else {
        three(out, place, count, v->channel, shift, red, green);
    }
}
