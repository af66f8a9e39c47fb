/* SPDX-License-Identifier: MIT */
#include "large_piece.h"

/* a0 + (a1 - a0) b1 + (a2 - a0) b2, all times 2^16: 33 bits times 31. */
QTRI_NOINLINE static int64_t blend_q16(int32_t a0, int32_t a1, int32_t a2, const int32_t b_q30[2])
{
    int64_t one = (((int64_t)a1 - a0) * b_q30[0]) >> 14;
    int64_t two = (((int64_t)a2 - a0) * b_q30[1]) >> 14;
    return (int64_t)a0 * 65536 + one + two;
}

/* Attributes of a clipped vertex from those of the triangle's own three. */
void qtri_blend_attributes(qtri_screen_vertex *out, const qtri_screen_vertex *a0,
                           const qtri_screen_vertex *a1, const qtri_screen_vertex *a2,
                           int32_t b1_q30, int32_t b2_q30)
{
    const int32_t b_q30[2] = {b1_q30, b2_q30};
    for (int i = 0; i < 3; i++) {
        int64_t sum = blend_q16(a0->color_8p16[i], a1->color_8p16[i], a2->color_8p16[i], b_q30);
        out->color_8p16[i] = (int32_t)(sum >> 16); /* 0..255.0, as the three are */
    }
    out->u_q32 = blend_q16((int32_t)(a0->u_q32 >> 16), (int32_t)(a1->u_q32 >> 16),
                           (int32_t)(a2->u_q32 >> 16), b_q30);
    out->v_q32 = blend_q16((int32_t)(a0->v_q32 >> 16), (int32_t)(a1->v_q32 >> 16),
                           (int32_t)(a2->v_q32 >> 16), b_q30);
}

void qtri_spread_provoking(const qtri_material *material, qtri_screen_vertex v[3])
{
    if (qtri_is_smooth(material)) {
        return;
    }
    const qtri_screen_vertex *from = &v[qtri_provoking_of(material)];
    for (int i = 0; i < 3; i++) {
        for (int channel = 0; channel < 3; channel++) {
            v[i].color_8p16[channel] = from->color_8p16[channel];
        }
    }
}

/* Which of the triangle's own vertices this is, that no plane made; otherwise -1. Two weights of 1
   would be a sum of 2: they are parts of 1. */
int qtri_own_vertex(const qtri_fan_vertex *v)
{
    const int32_t one_q30 = (int32_t)1 << 30;
    if ((v->b1_q30 | v->b2_q30) == 0) {
        return 0;
    }
    if ((v->b1_q30 | v->b2_q30) != one_q30) {
        return -1;
    }
    return v->b1_q30 != 0 ? 1 : 2;
}

/* What is left of half a step of 1/256 pixel: texels show it, depths where they are steep. */
bool qtri_rests_matter(const qtri_draw_state *state, const qtri_screen_point *const p[3],
                       const uint32_t depth_16p16[3], int64_t area)
{
    uint32_t low, high;
    int32_t extent = 0;
    if (state->texture != NULL) {
        return true;
    }
    for (int i = 0; i < 3; i++) {
        const qtri_screen_point *next = p[i == 2 ? 0 : i + 1];
        extent += (int32_t)(qtri_magnitude32(p[i]->x_24p8 - next->x_24p8) +
                            qtri_magnitude32(p[i]->y_24p8 - next->y_24p8));
    }
    qtri_find_range(&low, &high, depth_16p16);
    /* Off by range extent / area at most: by a quarter of a step of 16 bits. */
    return qtri_mul_u32((high - low) >> 14, (uint32_t)extent) > 2 * qtri_magnitude64(area);
}

/* Alpha of a point of the triangle whose vertices have these numbers. */
static uint32_t alpha_at(const qtri_draw_state *state, const qtri_fan_vertex *v)
{
    const uint8_t *alpha = state->material->alphas;
    int64_t a[3];
    for (int i = 0; i < 3; i++) {
        const uint32_t x = alpha[state->alpha_index[i]];
        a[i] = (int64_t)((x << 16) / 255);
    }
    const int64_t sum = a[0] + (((a[1] - a[0]) * v->b1_q30 + (a[2] - a[0]) * v->b2_q30) >> 30);
    return (uint32_t)(sum < 0 ? 0 : sum > 65536 ? 65536 : sum);
}

static void set_vertex(qtri_large_vertex *out, const qtri_draw_state *state,
                       const qtri_fan_vertex *v, const qtri_screen_vertex attributes[3])
{
    qtri_screen_vertex blend;
    const qtri_screen_vertex *from = &blend;
    const int own = qtri_own_vertex(v);
    if (own >= 0) {
        from = &attributes[own];
    } else {
        qtri_blend_attributes(&blend, &attributes[0], &attributes[1], &attributes[2], v->b1_q30,
                              v->b2_q30);
    }
    out->depth_16p16 = v->depth_16p8 & ~0xFFu;
    out->inv_w_q31 = v->inv_w_q31;
    out->inv_w_exponent = (int32_t)(v->depth_16p8 & 0xFFu);
    for (int i = 0; i < 3; i++) {
        out->color_8p16[i] = from->color_8p16[i];
    }
    out->light_q15 = (uint32_t)from->color_8p16[0] / 510; /* 255.0 is 1 */
    if (state->options.per_pixel) {
        out->color_8p16[0] = v->b1_q30;
        out->color_8p16[1] = v->b2_q30;
    }
    out->u_q32 = from->u_q32;
    out->v_q32 = from->v_q32;
    out->rest[0] = v->rest[0];
    out->rest[1] = v->rest[1];
    out->alpha_q16 = state->options.vertex_alpha ? alpha_at(state, v) : 65536;
}

uint32_t qtri_color_word(const int32_t color_8p16[3])
{
    uint32_t word = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t c = qtri_hold32(color_8p16[i] + 0x8000, 0, 0xFFFFFF);
        word = word << 8 | (uint32_t)c >> 16;
    }
    return word;
}

QTRI_NOINLINE static void draw_piece(qtri_draw_state *state, const qtri_fan_vertex *const vertex[3],
                                     int64_t area, const qtri_screen_vertex attributes[3])
{
    qtri_large_vertex v[3];
    const qtri_screen_point *const p[3] = {&vertex[0]->at, &vertex[1]->at, &vertex[2]->at};
    for (int i = 0; i < 3; i++) {
        set_vertex(&v[i], state, vertex[i], attributes);
    }
    qtri_large_triangle(state, p, area, qtri_color_word(attributes[0].color_8p16), v);
}

bool qtri_is_beside(const qtri_draw_state *state, const qtri_screen_point *const p[3])
{
    const qtri_rect *b = &state->bounds;
    const int32_t x0 = b->x0 * 256, x1 = b->x1 * 256, y0 = b->y0 * 256, y1 = b->y1 * 256;
    return (p[0]->x_24p8 < x0 && p[1]->x_24p8 < x0 && p[2]->x_24p8 < x0) ||
           (p[0]->x_24p8 > x1 && p[1]->x_24p8 > x1 && p[2]->x_24p8 > x1) ||
           (p[0]->y_24p8 < y0 && p[1]->y_24p8 < y0 && p[2]->y_24p8 < y0) ||
           (p[0]->y_24p8 > y1 && p[1]->y_24p8 > y1 && p[2]->y_24p8 > y1);
}

void qtri_draw_large_piece(const qtri_primitive *primitive, const qtri_fan_vertex *const vertex[3],
                           int64_t area, qtri_attribute_source source, const void *from)
{
    qtri_draw_state *state = primitive->to.solid.small.state;
    const qtri_screen_point *const p[3] = {&vertex[0]->at, &vertex[1]->at, &vertex[2]->at};
    qtri_screen_vertex attributes[3];
    if (!qtri_is_beside(state, p)) {
        source(from, attributes);
        qtri_spread_provoking(primitive->material, attributes);
        draw_piece(state, vertex, area, attributes);
    }
}
