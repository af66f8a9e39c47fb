#include "list_values.h"

#include "../geometry/projector.h"

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
    const qtri_vertex *const *vertex = v->t->v;
    int32_t more1;
    int32_t more2;
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
    const qtri_vertex *b = vertex[v->second];
    const qtri_vertex *c = vertex[v->third];
    if ((((vertex[0]->depth_16p8 ^ b->depth_16p8) | (vertex[0]->depth_16p8 ^ c->depth_16p8)) &
         0xFF) == 0) {
        more1 = (int32_t)(b->inv_w - vertex[0]->inv_w);
        more2 = (int32_t)(c->inv_w - vertex[0]->inv_w);
    } else {
        (void)qtri_inv_w_more(&more1, vertex[0], b);
        (void)qtri_inv_w_more(&more2, vertex[0], c);
    }
    if ((more1 | more2) != 0) {
        /* |more| <= 2^31 / 12.8, y = 2^46 / inv_w <= 2^16 */
        const int32_t y = (int32_t)qtri_reciprocal_q31(vertex[0]->inv_w >> 15);
        v->e1_q18 = ((more1 >> 13) * y + ((int32_t)1 << 14)) >> 15;
        v->e2_q18 = ((more2 >> 13) * y + ((int32_t)1 << 14)) >> 15;
        ramp_of(&v->e_q26, v, 0, v->e1_q18, v->e2_q18);
    }
}

/* Colours ------------------------------------------------------------------------------------- */

QTRI_NOINLINE bool qtri_list_is_linear(const qtri_vertex *a, const qtri_vertex *b,
                                       const qtri_vertex *c, int32_t d1, int32_t d2, uint32_t part)
{
    int32_t q1 = 0;
    int32_t q2 = 0;
    (void)qtri_inv_w_more(&q1, a, b);
    (void)qtri_inv_w_more(&q2, a, c);
    const int32_t q_least = qtri_least_from_0(q1, q2);
    const uint32_t q_range = (uint32_t)(qtri_greatest_from_0(q1, q2) - q_least); /* < 2^29 */
    const uint32_t range = (uint32_t)(qtri_greatest_from_0(d1, d2) - qtri_least_from_0(d1, d2));
    return range * ((q_range >> 15) + 1) <= (a->inv_w + (uint32_t)q_least) >> (4 + part);
}

/* The same for what a raster interpolates. */
static bool is_linear(const qtri_list_values *v, int32_t d1, int32_t d2, uint32_t part)
{
    const qtri_vertex *a = v->t->v[0];
    const qtri_vertex *b = v->t->v[1];
    const qtri_vertex *c = v->t->v[2];
    return !(QTRI_WITH_PERSPECTIVE && v->raster->perspective) ||
           qtri_list_is_plain(a, b, c, d1, d2, part) || qtri_list_is_linear(a, b, c, d1, d2, part);
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

/* Whether all channels are linear: where the sum of their differences is, or each of them. */
static bool are_linear(const qtri_list_values *v, int first)
{
    const int32_t(*color)[3] = v->t->color;
    int32_t d1[3];
    int32_t d2[3];
    uint32_t most1 = 0;
    uint32_t most2 = 0;
    for (int i = first; i < 3; i++) {
        d1[i] = (color[v->second][i] - color[0][i]) >> 7;
        d2[i] = (color[v->third][i] - color[0][i]) >> 7;
        most1 |= qtri_about(d1[i]);
        most2 |= qtri_about(d2[i]);
    }
    if (!(QTRI_WITH_PERSPECTIVE && v->raster->perspective) ||
        qtri_list_is_plain(v->t->v[0], v->t->v[1], v->t->v[2], (int32_t)most1, (int32_t)most2, 3)) {
        return true;
    }
    for (int i = first; i < 3; i++) {
        if (!is_linear(v, d1[i], d2[i], 3)) {
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
