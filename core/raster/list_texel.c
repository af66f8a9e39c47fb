/* SPDX-License-Identifier: MIT */
#include "bilinear.h"
#include "list_values.h"
#include "stage_color.h"
#include "texel_copy.h"
#include "texel_number.h"
#include "textured.h"

enum {
    GENTLE_UP = 31 - 24, /* |f| < 2^15 + 2^10: |l| < 2^24 */
    KEPT = 15,           /* bits of the larger difference */
    TEXEL = 18,          /* of a texel's fraction, where coordinates do not fill 32 bits */
    UP = QTRI_PLACE_DOWN
};

/* Added to coordinates, so that those somewhat below 0 can be shifted; a multiple of the side. */
#define ABOVE_ZERO ((uint32_t)1 << 30)

/*
 * A coordinate's differences with KEPT bits, times 1 + e, their fraction held to `most`. Returns
 * the fraction of what comes out.
 */
static inline int32_t differences(int32_t f[2], const qtri_list_values *v,
                                  const qtri_coordinates *c, int32_t most)
{
    const int32_t d1 = c->at[v->second] - c->at[0];
    const int32_t d2 = c->at[v->third] - c->at[0];
    int32_t up = qtri_clz32(qtri_about(d1) | qtri_about(d2)) - (32 - KEPT); /* -16..15 */
    up = qtri_least32(up, most - c->fraction);                              /* >= -23 */
    if (up >= 0) {
        f[0] = d1 * ((int32_t)1 << up);
        f[1] = d2 * ((int32_t)1 << up);
    } else {
        const int32_t half = (int32_t)1 << (-up - 1);
        f[0] = (d1 + half) >> -up;
        f[1] = (d2 + half) >> -up;
    }
    f[0] = qtri_list_scaled(f[0], v->e1_q18);
    f[1] = qtri_list_scaled(f[1], v->e2_q18);
    return c->fraction + up;
}

/*
 * Coordinates on a texel's edge, give or take an error, go up by 2^-10 of a texel. To a filter they
 * count from texels' centres, and edges are nothing special.
 */
static uint32_t bias_of(const qtri_list_values *v, int32_t shift)
{
    if (v->raster->texture->filter != NULL) {
        return 0u - ((uint32_t)1 << (shift - 1));
    }
    return shift > 10 ? (uint32_t)1 << (shift - 10) : 0;
}

/*
 * Coordinates that fill 32 bits. Most triangles are gentle: |l| < 2^31 in the unit of the
 * coordinate, so that ramps may be in that, and |e| < 1/32, so that w = e - e^2 leaves l e^3, less
 * than 1/640 of a pixel of 51.
 */
static bool fill_axes(qtri_list_values *v, bool gentle)
{
    const qtri_raster *raster = v->raster;
    const qtri_place *p = v->t->place;
    for (int i = 0; i < 2; i++) {
        int32_t f[2];
        qtri_ramp l;
        const qtri_coordinates *c = &v->t->uv[i];
        const int32_t unit = raster->coordinate[i].unit;
        const int32_t fraction = differences(f, v, c, unit - UP);
        const int32_t down = c->fraction - unit;
        const int32_t up = unit - UP - fraction;
        const int32_t at = c->at[0];
        qtri_list_axis *out = &v->uv[i];
        if (gentle && up > GENTLE_UP) {
            return false;
        }
        qtri_place_ramp(&l, p, &v->inverse, 0, f[0], f[1]);
        out->l.origin = gentle ? l.origin << up : l.origin;
        out->l.dx = gentle ? l.dx << up : l.dx;
        out->l.dy = gentle ? l.dy << up : l.dy;
        out->up = up;
        out->at = (down > 0 ? (uint32_t)(at >> down) : (uint32_t)at << -down) +
                  bias_of(v, raster->coordinate[i].shift);
    }
    return true;
}

/*
 * Coordinates of which whole columns or rows are looked at: in texels, from the whole repeat of
 * vertex 0 on. The others are less than 2^(KEPT + 1 - fraction) repeats away: with the shift below
 * by less than 2^30.
 */
static void clamp_axis(qtri_list_axis *out, qtri_texel_axis *axis, const qtri_list_values *v,
                       const qtri_coordinates *c, uint8_t side_log2, bool clamped)
{
    int32_t f[2];
    side_log2 = side_log2 > 10 ? 10 : side_log2;
    const int32_t fraction = differences(f, v, c, side_log2 + TEXEL - UP);
    const int32_t shift = qtri_least32(TEXEL, 29 - KEPT + fraction - side_log2); /* >= 1 */
    const int32_t base = c->at[0] >> c->fraction;
    const int32_t up = side_log2 + shift - c->fraction;
    const uint32_t rest = (uint32_t)c->at[0] & (((uint32_t)1 << c->fraction) - 1);
    axis->side_log2 = side_log2;
    axis->texel_shift = (uint8_t)shift;
    axis->clamped = clamped;
    axis->mask = (uint16_t)((1u << side_log2) - 1);
    axis->first = (int32_t)(ABOVE_ZERO >> shift) - (base + c->repeats) * ((int32_t)1 << side_log2);
    out->up = side_log2 + shift - UP - fraction;
    out->at = ABOVE_ZERO + bias_of(v, shift) + (up >= 0 ? rest << up : rest >> -up);
    qtri_place_ramp(&out->l, v->t->place, &v->inverse, 0, f[0], f[1]);
}

static bool can_follow(qtri_list_values *v)
{
    return qtri_list_is_even(&v->uv[0].l) && qtri_list_is_even(&v->uv[1].l) && qtri_list_follow(v);
}

void qtri_list_set_texels(qtri_list_values *v)
{
    const qtri_raster *raster = v->raster;
    const qtri_texture *texture = raster->texture;
    const qtri_coordinates *uv = v->t->uv;
    qtri_list_find_e(v);
    if (!raster->repeated) {
        clamp_axis(&v->uv[0], &v->axis[0], v, &uv[0], texture->width_log2,
                   texture->wrap_u == QTRI_CLAMP);
        clamp_axis(&v->uv[1], &v->axis[1], v, &uv[1], texture->height_log2,
                   texture->wrap_v == QTRI_CLAMP);
        v->blocks = can_follow(v);
        return;
    }
    v->blocks = false;
    v->gentle = texture->filter == NULL && raster->samples == NULL && /* whose ramps are moved */
                ((qtri_about(v->e1_q18) | qtri_about(v->e2_q18)) >> 13) == 0 && fill_axes(v, true);
    if (!v->gentle) {
        (void)fill_axes(v, false);
        v->blocks =
            qtri_list_is_even(&v->uv[0].l) && qtri_list_is_even(&v->uv[1].l) && qtri_list_follow(v);
    }
    if (texture->filter != NULL) {
        for (int i = 0; i < 2; i++) {
            v->axis[i].side_log2 = i == 0 ? texture->width_log2 : texture->height_log2;
            v->axis[i].texel_shift = raster->coordinate[i].shift;
            v->axis[i].clamped = false;
            v->axis[i].mask = (uint16_t)((1u << v->axis[i].side_log2) - 1);
        }
    }
}

static inline uint32_t coordinate(const qtri_list_axis *axis, uint32_t x, uint32_t y, int32_t w)
{
    const int32_t l = (int32_t)qtri_list_at(&axis->l, x, y);
    return axis->at + ((uint32_t)qtri_list_divided(l, w) << axis->up);
}

static void numbers_repeated(const qtri_list_values *v, uint32_t *number, const uint32_t *place,
                             int32_t count)
{
    const qtri_list_axis u_axis = v->uv[0];
    const qtri_list_axis v_axis = v->uv[1];
    const qtri_ramp e = v->e_q26;
    const uint32_t cut = v->raster->texel_cut;
    const uint32_t *end = place + count;
    do {
        const uint32_t x = *place & 0xFFFF;
        const uint32_t y = *place >> 16;
        const int32_t w = qtri_list_w(&e, x, y);
        place++;
        *number++ =
            qtri_texel_index(coordinate(&u_axis, x, y, w), coordinate(&v_axis, x, y, w), cut);
    } while (place != end);
}

/* The same for gentle triangles, with linear light or without. */
static inline void numbers_gentle(const qtri_list_values *v, uint32_t *number, uint32_t *shade,
                                  const uint32_t *place, int32_t count, bool lit)
{
    const qtri_ramp u_ramp = v->uv[0].l;
    const qtri_ramp v_ramp = v->uv[1].l;
    const qtri_ramp e_ramp = v->e_q26;
    const qtri_ramp light = v->channel[2];
    const uint32_t u_at = v->uv[0].at;
    const uint32_t v_at = v->uv[1].at;
    const uint32_t cut = v->raster->texel_cut;
    const uint32_t *end = place + count;
    do {
        const uint32_t x = *place & 0xFFFF;
        const uint32_t y = *place >> 16;
        const int32_t e = (int32_t)qtri_list_at(&e_ramp, x, y) >> 10;
        const int32_t w = e - ((e * e) >> 16);
        const uint32_t along = qtri_list_at(&u_ramp, x, y);
        const uint32_t across = qtri_list_at(&v_ramp, x, y);
        place++;
        if (lit) {
            *shade++ = qtri_list_at(&light, x, y) >> QTRI_LIGHT_SHIFT;
        }
        *number++ = qtri_texel_index(along + u_at - (uint32_t)(((int32_t)along >> 16) * w),
                                     across + v_at - (uint32_t)(((int32_t)across >> 16) * w), cut);
    } while (place != end);
}

/* The pieces of the row that the fragment at a place is in; returns where they begin. */
static uint32_t find_pieces(qtri_list_piece piece[3], const qtri_list_values *v, uint32_t place,
                            bool lit)
{
    const uint32_t first = qtri_list_piece_first(v, place);
    const uint32_t x = (place & 0xFFFF) - (place - first) + v->half;
    const uint32_t y = place >> 16;
    const int32_t w = qtri_list_w(&v->e_q26, x, y);
    qtri_list_piece_set(&piece[0], v, &v->uv[0].l, x, y, w, v->uv[0].at, v->uv[0].up);
    qtri_list_piece_set(&piece[1], v, &v->uv[1].l, x, y, w, v->uv[1].at, v->uv[1].up);
    if (lit && v->curved) {
        qtri_list_piece_set(&piece[2], v, &v->channel[2], x, y, w, v->base[2], 0);
    } else if (lit) {
        qtri_list_piece_linear(&piece[2], &v->channel[2], x - v->half, y);
    }
    return first;
}

/* The same along rows, see qtri_list_piece; lit: light that varies, too. */
QTRI_INLINE void follow(const qtri_list_values *v, uint32_t *number, uint32_t *shade,
                        const uint32_t *place, int32_t count, bool lit)
{
    const uint32_t cut = v->raster->texel_cut;
    const uint32_t *const end = place + count;
    do {
        qtri_list_piece piece[3];
        const uint32_t first = find_pieces(piece, v, *place, lit);
        const qtri_list_piece u_piece = piece[0];
        const qtri_list_piece v_piece = piece[1];
        const qtri_list_piece light = lit ? piece[2] : piece[0];
        uint32_t d = *place - first;
        do {
            if (lit) {
                *shade++ = qtri_list_piece_at(&light, d) >> QTRI_LIGHT_SHIFT;
            }
            *number++ = qtri_texel_index(qtri_list_piece_at(&u_piece, d),
                                         qtri_list_piece_at(&v_piece, d), cut);
            d = *++place - first;
        } while (d < QTRI_PIECE);
    } while (place != end);
}

static void numbers_lit(const qtri_list_values *v, uint32_t *number, uint32_t *shade,
                        const uint32_t *place, int32_t count)
{
    follow(v, number, shade, place, count, true);
}

static void numbers_along(const qtri_list_values *v, uint32_t *number, const uint32_t *place,
                          int32_t count)
{
    follow(v, number, NULL, place, count, false);
}

QTRI_NOINLINE static void coordinates_along(const qtri_list_values *v, uint32_t *out_u,
                                            uint32_t *out_v, const uint32_t *place, int32_t count)
{
    const uint32_t *const end = place + count;
    do {
        qtri_list_piece piece[3];
        const uint32_t first = find_pieces(piece, v, *place, false);
        const qtri_list_piece u_piece = piece[0];
        const qtri_list_piece v_piece = piece[1];
        uint32_t d = *place - first;
        do {
            *out_u++ = qtri_list_piece_at(&u_piece, d);
            *out_v++ = qtri_list_piece_at(&v_piece, d);
            d = *++place - first;
        } while (d < QTRI_PIECE);
    } while (place != end);
}

static void coordinates(const qtri_list_values *v, uint32_t *out_u, uint32_t *out_v,
                        const uint32_t *place, int32_t count)
{
    const uint32_t *end = place + count;
    do {
        const uint32_t x = *place & 0xFFFF;
        const uint32_t y = *place >> 16;
        const int32_t w = qtri_list_w(&v->e_q26, x, y);
        place++;
        *out_u++ = coordinate(&v->uv[0], x, y, w);
        *out_v++ = coordinate(&v->uv[1], x, y, w);
    } while (place != end);
}

/* Numbers from coordinates, v and u in place. */
static void numbers_wrapped(const qtri_list_values *v, uint32_t *color, const uint32_t *across,
                            int32_t count)
{
    const qtri_texel_axis *axis = v->axis;
    for (const uint32_t *end = color + count; color != end; color++, across++) {
        const uint32_t column = qtri_texel_wrapped(&axis[0], *color >> axis[0].texel_shift);
        const uint32_t row = qtri_texel_wrapped(&axis[1], *across >> axis[1].texel_shift);
        *color = (row << axis[0].side_log2) + column;
    }
}

/* What texels are multiplied by. */
static void set_shades(const qtri_list_values *v, uint32_t *shade, const uint32_t *place,
                       int32_t count)
{
    if (v->raster->batch->kind == QTRI_LIST_LIT_TEXELS) {
        qtri_list_words(v, shade, place, count, QTRI_LIGHT_SHIFT, 0, 0);
    } else if (v->raster->batch->kind == QTRI_LIST_RGB_TEXELS) {
        qtri_list_words(v, shade, place, count, QTRI_CHANNEL_SHIFT, QTRI_SHADE_RED,
                        QTRI_SHADE_GREEN);
    }
}

uint32_t qtri_list_texels(const qtri_list_values *v, uint32_t *color, uint32_t *shade,
                          const uint32_t *place, int32_t count)
{
    const qtri_raster *raster = v->raster;
    const qtri_texture *texture = raster->texture;
    uint32_t mask = UINT32_MAX;
    if (raster->repeated && texture->filter == NULL) {
        if (v->blocks && raster->batch->kind == QTRI_LIST_LIT_TEXELS && v->channels != 0) {
            numbers_lit(v, color, shade, place, count);
            return mask;
        }
        if (v->blocks) {
            numbers_along(v, color, place, count);
        } else if (!v->gentle) {
            numbers_repeated(v, color, place, count);
        } else if (raster->batch->kind == QTRI_LIST_LIT_TEXELS && v->channels != 0 && !v->curved) {
            numbers_gentle(v, color, shade, place, count, true);
            return mask;
        } else {
            numbers_gentle(v, color, shade, place, count, false);
        }
    } else {
        if (v->blocks) {
            coordinates_along(v, color, shade, place, count);
        } else {
            coordinates(v, color, shade, place, count);
        }
        if (texture->filter != NULL) {
            mask = texture->filter->sample(raster, v->axis, color, shade, count);
        } else {
            numbers_wrapped(v, color, shade, count);
        }
    }
    set_shades(v, shade, place, count);
    return mask;
}

static void shade_texels(const qtri_raster *raster, qtri_batch *batch, int32_t count)
{
    if (batch->kind == QTRI_LIST_LIT_TEXELS && !raster->white) {
        raster->tinted(batch->color, batch->by.shade, raster->tint_q10, count);
    } else if (batch->kind == QTRI_LIST_LIT_TEXELS) {
        raster->light(batch->color, batch->by.shade, count);
    } else {
        raster->times(batch->color, batch->by.shade, count);
    }
    if (raster->narrow != NULL && !raster->gray) {
        raster->narrow(batch->color, count);
    }
}

uint32_t qtri_list_finish_texels(const qtri_raster *raster, int32_t count, uint32_t mask)
{
    qtri_batch *batch = raster->batch;
    const bool shaded = batch->kind == QTRI_LIST_LIT_TEXELS || batch->kind == QTRI_LIST_RGB_TEXELS;
    if (raster->texture->filter == NULL) {
        for (int32_t i = count; (i & 3) != 0; i++) {
            batch->color[i] = 0; /* must be numbers of texels */
        }
        mask = qtri_texels_color(raster, NULL, batch->color, NULL, count, false, true);
    }
    mask &= qtri_mask_of(count);
    if (mask != 0 && shaded) {
        shade_texels(raster, batch, count);
    } else if (mask != 0 && raster->narrow != NULL) { /* as if in light of 1 */
        raster->narrow(batch->color, count);
    }
    return mask;
}
