/* SPDX-License-Identifier: MIT */
/*
 * Texels: from coordinates to colours. Internal, part of the pipelines' body (pipeline_make.h).
 */
#ifndef QTRI_BODY_TEXEL_H
#define QTRI_BODY_TEXEL_H

#include "stored.h"

/* NOLINTBEGIN(clang-analyzer-core.NullDereference): texels and axes of a texture are set by
   qtri_walk_begin() and set-up; without a texture nothing here is called */

/* The column at u. */
QTRI_BODY uint32_t qtri_texel_column(const qtri_pixel_walk *w, uint32_t u)
{
    return qtri_body_shift(u, w->rows);
}

/* The index of the first texel in v's row. */
QTRI_BODY uint32_t qtri_texel_row(const qtri_options *o, const qtri_pixel_walk *w, uint32_t v)
{
    return o->large_texture ? v >> w->v_shift << w->width_log2 : (v & w->rows) >> 16;
}

/* Which of a checker's two colours texel `number` has: 0 or 1. */
QTRI_BODY uint32_t qtri_checker_index(const qtri_texture *texture, uint32_t width_log2,
                                      uint32_t number)
{
    const uint32_t column = number & (((uint32_t)1 << width_log2) - 1), row = number >> width_log2;
    const uint32_t fields = texture->fields;
    const uint32_t height_log2 = texture->height_log2 < 10 ? texture->height_log2 : 10;
    return ((column * fields >> width_log2) + (row * fields >> height_log2)) & 1;
}

/* Texel `number` as the texture stores it. */
QTRI_BODY uint32_t qtri_texel_stored(const qtri_options *o, const qtri_pixel_walk *w,
                                     uint32_t number)
{
    switch (o->texel) {
    case QTRI_TEXEL_RGB565:
    case QTRI_TEXEL_ARGB4444:
    case QTRI_TEXEL_ARGB1555:
        return ((const uint16_t *)w->texels)[number];
    case QTRI_TEXEL_XRGB8888:
    case QTRI_TEXEL_ARGB8888:
        return ((const uint32_t *)w->texels)[number];
    case QTRI_TEXEL_CHECKER:
        return qtri_checker_index(w->state->texture, w->width_log2, number);
    case QTRI_OTHER_TEXEL:
        return o->fetch != NULL ? o->fetch(w->state->texture, number)
                                : qtri_fetch_other(w->state->texture, number);
    default:
        return ((const uint8_t *)w->texels)[number];
    }
}

/* An RGB565 colour in the format pixels are computed in, which is gray, 888 or fine. */
QTRI_BODY_PART uint32_t qtri_texel_from_565(qtri_color_kind kind, uint32_t c)
{
    if (kind == QTRI_IN_FINE_565) {
        return qtri_pixel_565_to_fine(c);
    }
    return kind == QTRI_IN_GRAY ? qtri_pixel_565_to_luma(c) : qtri_pixel_565_to_888(c);
}

QTRI_BODY_PART uint32_t qtri_texel_gray(uint32_t c)
{
    return qtri_pixel_888_to_luma(c);
}

/* One of 888, whose alpha stays. */
QTRI_BODY uint32_t qtri_texel_from_888(qtri_color_kind kind, uint32_t c)
{
    return kind == QTRI_IN_GRAY       ? qtri_texel_gray(c)
           : kind == QTRI_IN_FINE_565 ? qtri_pixel_888_to_fine(c)
                                      : c;
}

/* A stored texel as a colour of the kind; with alpha, 0xAARRGGBB. */
QTRI_BODY uint32_t qtri_texel_color(const qtri_options *o, const qtri_pixel_walk *w, uint32_t t)
{
    const qtri_color_kind kind = qtri_kind_of(o);
    switch (o->texel) {
    case QTRI_TEXEL_PALETTE565:
    case QTRI_TEXEL_RGB565:
        t = o->texel == QTRI_TEXEL_PALETTE565 ? ((const uint16_t *)w->palette)[t] : t;
        return kind == QTRI_IN_565 ? t : qtri_texel_from_565(kind, t);
    case QTRI_TEXEL_XRGB8888:
        return qtri_texel_from_888(kind, t & 0xFFFFFFu);
    case QTRI_TEXEL_GRAY8:
        return kind == QTRI_IN_GRAY ? t : qtri_texel_from_888(kind, t * 0x010101u);
    case QTRI_TEXEL_PALETTE8:
    case QTRI_TEXEL_CHECKER: /* both colours are its palette */
        return qtri_texel_from_888(kind, qtri_pixel_rgb_to_888((const qtri_rgb *)w->palette + t));
    case QTRI_TEXEL_ARGB4444:
        return qtri_texel_from_888(kind, qtri_pixel_4444_to_8888(t));
    case QTRI_TEXEL_ARGB1555:
        return qtri_texel_from_888(kind, qtri_pixel_1555_to_8888(t));
    case QTRI_TEXEL_ALPHA8:
        return t << 24 | (kind == QTRI_IN_FINE_565 ? 0xF8FCF8u : 0xFFFFFFu);
    case QTRI_OTHER_TEXEL:
        t = o->fetch != NULL ? t : qtri_texel_other(w->state->texture, t);
        return qtri_texel_from_888(kind, t);
    default:
        return qtri_texel_from_888(kind, t);
    }
}

/* 2^11 times the mean of lanes of four texels, the upper two first: by differences, which may have
   either sign. `both` is the product of the fractions, Q11. */
QTRI_BODY uint32_t qtri_lanes_mean(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t along,
                                   uint32_t across, uint32_t both)
{
    uint32_t right = b - a;
    QTRI_BODY_BARRIER(right);
    uint32_t sum = (a << 11) + right * along;
    QTRI_BODY_BARRIER(sum);
    d -= right;
    d -= c;
    sum += (c - a) * across;
    QTRI_BODY_BARRIER(sum);
    return sum + d * both;
}

/*
 * The bilinear mean of four texels, the upper two first, by fractions in Q11. Weights sum up to
 * 2^11 in lanes of RGB565 (31 2^11 < 2^16), to 2^22 of each channel in 888.
 */
QTRI_BODY uint32_t qtri_texel_mean(qtri_color_kind kind, const uint32_t t[4], uint32_t along,
                                   uint32_t across)
{
    if (kind == QTRI_IN_565) {
        const uint32_t both = along * across >> 11;
        const uint32_t lanes = qtri_lanes_mean(
            qtri_pixel_lanes_565(t[0]), qtri_pixel_lanes_565(t[1]), qtri_pixel_lanes_565(t[2]),
            qtri_pixel_lanes_565(t[3]), along, across, both);
        const uint32_t green = qtri_lanes_mean(t[0] & 0x07E0u, t[1] & 0x07E0u, t[2] & 0x07E0u,
                                               t[3] & 0x07E0u, along, across, both);
        return (uint16_t)qtri_join_565((lanes + 0x04000400u) >> 11 & QTRI_BODY_LANES_565,
                                       (green + 0x8000u) >> 16);
    }
    const uint32_t both = along * across;
    const uint32_t weight[4] = {((uint32_t)1 << 22) - (along << 11) - (across << 11) + both,
                                (along << 11) - both, (across << 11) - both, both};
    uint32_t r = (uint32_t)1 << 21, g = r, b = r;
    for (int i = 0; i < 4; i++) {
        if (kind != QTRI_IN_GRAY) {
            r += (t[i] >> 16 & 255) * weight[i];
            QTRI_BODY_BARRIER(r);
            g += (t[i] >> 8 & 255) * weight[i];
            QTRI_BODY_BARRIER(g);
        }
        b += (t[i] & 255) * weight[i];
        QTRI_BODY_BARRIER(b);
    }
    return kind == QTRI_IN_GRAY ? b >> 22 : r >> 22 << 16 | g >> 22 << 8 | b >> 22;
}

/* The fraction, Q11, of a texture coordinate that has `whole` bits above it. */
QTRI_BODY uint32_t qtri_texel_fraction(uint32_t at, uint32_t whole)
{
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): a row is 2^16 of v or more
    return at << whole >> 21;
}

/* The bilinear mean at u and v; *drawn becomes false where the nearest texel equals the key. */
QTRI_BODY uint32_t qtri_texel_bilinear(const qtri_options *o, const qtri_pixel_walk *w, bool *drawn)
{
    const uint32_t along = qtri_texel_fraction(w->u, w->width_log2);
    const uint32_t across = qtri_texel_fraction(w->v, 32 - w->v_shift);
    const uint32_t column = qtri_texel_column(w, w->u), row = qtri_texel_row(o, w, w->v);
    /* The next column; in a texture one texel wide, this one. */
    const uint32_t next_column =
        qtri_texel_column(w, w->u + ((uint32_t)2 << ((31 - w->width_log2) & 31)));
    const uint32_t next_row = qtri_texel_row(o, w, w->v + ((uint32_t)1 << w->v_shift));
    uint32_t t[4];
    t[0] = qtri_texel_stored(o, w, column + row);
    t[1] = qtri_texel_stored(o, w, next_column + row);
    t[2] = qtri_texel_stored(o, w, column + next_row);
    t[3] = qtri_texel_stored(o, w, next_column + next_row);
    if (o->key) { /* the nearest decides, and stands in for others that equal the key */
        const uint32_t key = w->state->key, mask = w->state->key_mask;
        const uint32_t nearest = t[(across >> 10) * 2 + (along >> 10)];
        *drawn = (nearest & mask) != key;
        for (int i = 0; i < 4; i++) {
            t[i] = (t[i] & mask) == key ? nearest : t[i];
        }
    }
    for (int i = 0; i < 4; i++) {
        t[i] = qtri_texel_color(o, w, t[i]);
    }
    return qtri_uses_alpha(o) ? qtri_alpha_mean(t, along, across)
                              : qtri_texel_mean(qtri_kind_of(o), t, along, across);
}

/* NOLINTEND(clang-analyzer-core.NullDereference) */

#endif
