/* SPDX-License-Identifier: MIT */
/*
 * What the generic pipeline draws a blend, fog, a filter or depths of another format than linear16
 * with, any comparison of depths and none included: filters and depths on RGB565. Millions of
 * instructions on a Cortex-M0+ by its loop for all, and by these: half alpha B1l 24.7, 9.4, and
 * B4kl 17.8, 12.4, on XRGB8888 B1 24.0, 10.5 and B4k 18.4, 13.7, on GRAY8 21.9, 5.2 and 17.2, 10.5;
 * with "less or equal" the sprite B11 22.9, 12.9 (13.6 by draw_mixed), added 23.3, 14.9, and half
 * transparent in fog with "less" 27.5, 17.7; fog F4kl 19.3, 13.9, on XRGB8888 F11 21.7, 14.1;
 * bilinear S11l 28.1, 16.5; a lit textured mesh on float16 D6l 20.7, 15.0.
 */
#include <stdbool.h>
#include <stdint.h>

#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#include "qtri/body/loop.h"

#include "descriptions.h"
#include "any_loops.inc"

#define IN(kind)  (QTRI_IN_##kind << QTRI_ASK_KIND)
#define TEXEL_565 (all->texel != QTRI_NO_TEXEL ? QTRI_TEXEL_RGB565 : QTRI_NO_TEXEL)
#define BLEND                                                                                      \
    .blend = all->blend == QTRI_ALPHA ? QTRI_ALPHA                                                 \
             : all->blend == QTRI_ADD ? QTRI_ADD                                                   \
                                      : QTRI_MULTIPLY
#define SPRITE                                                                                     \
    .texel = all->texel == QTRI_TEXEL_ARGB4444   ? QTRI_TEXEL_ARGB4444                             \
             : all->texel == QTRI_TEXEL_ARGB1555 ? QTRI_TEXEL_ARGB1555                             \
             : all->texel == QTRI_TEXEL_ALPHA8   ? QTRI_TEXEL_ALPHA8                               \
                                                 : QTRI_TEXEL_ARGB8888,                              \
    .shade = all->shade == QTRI_FLAT ? QTRI_FLAT : QTRI_TINT

/* Colours, texels of RGB565 and light over what is there, and in fog, in 888 and in gray. */
#define IN_888(name, ASKS, ...)                                                                    \
    LOOP(name, IN(888) | (ASKS) | (all->asks & (ASK(565) | ASK(TWO_WORDS))),                       \
         .format = all->format, .pixel_bytes = all->pixel_bytes, .texel = TEXEL_565,               \
         .shade = all->shade, __VA_ARGS__)
#define IN_GRAY(name, ASKS, ...)                                                                   \
    LOOP(name, IN(GRAY) | (ASKS), .format = QTRI_GRAY8, .pixel_bytes = 1, .texel = TEXEL_565,      \
         .shade = all->shade, __VA_ARGS__)

IN_888(draw_blended_888, ASK(READ), BLEND)
IN_GRAY(draw_blended_gray, ASK(READ), BLEND)
IN_888(draw_fogged_888, 0, .fog = 1)
IN_GRAY(draw_fogged_gray, 0, .fog = 1)

ON_RGB565(draw_blended, ASK(READ) | (all->asks & (ASK(TWO_WORDS) | ASK(PACKED) | ASK(TABLE))),
          .texel = TEXEL_565, .shade = all->shade, BLEND)
ON_RGB565(draw_sprite, IN(FINE_565) | ASK(READ) | ASK(ALPHA) | ASK(ALPHA_USED), SPRITE,
          .blend = QTRI_ALPHA)
ON_RGB565(draw_added_sprite, IN(888) | ASK(READ) | ASK(ALPHA) | ASK(ALPHA_USED), SPRITE,
          .blend = QTRI_ADD)
ON_RGB565(draw_mixed,
          IN(FINE_565) | ASK(READ) | (all->asks & (ASK(ALPHA) | ASK(ALPHA_USED) | ASK(TWO_WORDS))),
          .texel = all->texel, .shade = all->shade, .blend = QTRI_ALPHA, .fog = all->fog,
          .vertex_alpha = all->vertex_alpha)
ON_RGB565(draw_fogged, IN(FINE_565) | (all->asks & ASK(TWO_WORDS)), .shade = all->shade, .fog = 1)
ON_RGB565(draw_fogged_texture, IN(FINE_565) | (all->asks & ASK(TWO_WORDS)),
          .texel = QTRI_TEXEL_RGB565, .shade = all->shade, .fog = 1)
ON_RGB565(draw_filtered, ASK(TWO_WORDS), .texel = QTRI_TEXEL_RGB565, .bilinear = 1,
          .shade = all->shade)

static bool is_plain_565(const qtri_options *o)
{
    return o->texel == QTRI_NO_TEXEL || o->texel == QTRI_TEXEL_RGB565;
}

/* No other effect, no key. */
static bool is_alone(const qtri_options *o)
{
    return (o->depth > QTRI_LINEAR16) + (o->blend != QTRI_STORE) + (o->fog != 0) +
                   (o->bilinear != 0) ==
               1 &&
           !o->key && !o->vertex_alpha;
}

qtri_pixels_loop *qtri_blended_loop(const qtri_options *o)
{
    const qtri_color_kind kind = qtri_kind_of(o);
    if (is_alone(o) && qtri_has_alpha(o) && o->texel != QTRI_OTHER_TEXEL && o->shade <= QTRI_TINT &&
        qtri_stores_565(o) && o->blend <= QTRI_ADD) {
        return o->blend == QTRI_ALPHA ? draw_sprite : draw_added_sprite;
    }
    if (o->blend == QTRI_ALPHA && kind == QTRI_IN_FINE_565) {
        return o->bilinear || o->key || o->depth > QTRI_LINEAR16 ? NULL : draw_mixed;
    }
    return !is_alone(o) || !is_plain_565(o) || o->blend > QTRI_MULTIPLY ? NULL
           : kind == QTRI_IN_565                                        ? draw_blended
           : kind == QTRI_IN_GRAY                                       ? draw_blended_gray
                                                                        : draw_blended_888;
}

qtri_pixels_loop *qtri_fogged_loop(const qtri_options *o)
{
    const qtri_color_kind kind = qtri_kind_of(o);
    return !is_alone(o) || !is_plain_565(o) ? NULL
           : kind == QTRI_IN_888            ? draw_fogged_888
           : kind == QTRI_IN_GRAY           ? draw_fogged_gray
           : o->texel == QTRI_NO_TEXEL      ? draw_fogged
                                            : draw_fogged_texture;
}

qtri_pixels_loop *qtri_filtered_loop(const qtri_options *o)
{
    return is_alone(o) && is_plain_565(o) && qtri_stores_565(o) ? draw_filtered : NULL;
}

/* Depths of another format. A copy of one is of the application's own: its kind may differ. */
#define ON_DEPTHS(name, DEPTH)                                                                     \
    ON_RGB565(draw_on_##name, all->asks &(ASK(TWO_WORDS) | ASK(PACKED) | ASK(TABLE) | ASK(PLAIN)), \
              .texel = TEXEL_565, .shade = all->shade, .depth = (DEPTH))                           \
    qtri_pixels_loop *qtri_##name##_loop(const qtri_options *o)                                    \
    {                                                                                              \
        return is_alone(o) && o->depth == (DEPTH) && is_plain_565(o) && qtri_stores_565(o)         \
                   ? draw_on_##name                                                                \
                   : NULL;                                                                         \
    }

ON_DEPTHS(float16, QTRI_FLOAT16)
ON_DEPTHS(linear24, QTRI_LINEAR24)
ON_DEPTHS(linear32, QTRI_LINEAR32)

/* Without the frequent case S11l takes a quarter more by the loop for all options. */
uint32_t qtri_texel_between(const qtri_pixel_walk *w, bool *drawn)
{
    static const qtri_options frequent = {
        .texel = QTRI_TEXEL_RGB565, .bilinear = 1, .asks = QTRI_IN_565 << QTRI_ASK_KIND};
    const qtri_options *o = &w->state->options;
    return is_plain_565(o) && qtri_kind_of(o) == QTRI_IN_565 && !o->key && !o->large_texture
               ? qtri_texel_bilinear(&frequent, w, drawn)
               : qtri_texel_bilinear(o, w, drawn);
}
