/* SPDX-License-Identifier: MIT */
/*
 * What the generic pipeline draws a blend, fog, a filter or depths of another format than linear16
 * on RGB565 with, any comparison of depths and none included. Millions of instructions on a
 * Cortex-M0+ by its loop for all, and by these: half alpha B1l 24.7, 9.4, and B4kl 17.8, 12.4; a
 * floor of ARGB4444 25.2, 13.6; fog F4kl 20.8, 15.8; bilinear S11l 28.1, 16.7; a lit textured mesh
 * on float16 D6l 20.7, 15.0.
 */
#include <stdbool.h>
#include <stdint.h>

#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#include "qtri/body/loop.h"

#include "descriptions.h"
#include "any_loops.inc"

#define IN_FINE   (QTRI_IN_FINE_565 << QTRI_ASK_KIND)
#define TEXEL_565 (all->texel != QTRI_NO_TEXEL ? QTRI_TEXEL_RGB565 : QTRI_NO_TEXEL)

ON_RGB565(draw_blended, ASK(READ) | (all->asks & (ASK(TWO_WORDS) | ASK(PACKED) | ASK(TABLE))),
          .texel = TEXEL_565, .shade = all->shade,
          .blend = all->blend == QTRI_ALPHA ? QTRI_ALPHA
                   : all->blend == QTRI_ADD ? QTRI_ADD
                                            : QTRI_MULTIPLY)
#define SPRITE                                                                                     \
    .texel = all->texel == QTRI_TEXEL_ARGB4444   ? QTRI_TEXEL_ARGB4444                             \
             : all->texel == QTRI_TEXEL_ARGB1555 ? QTRI_TEXEL_ARGB1555                             \
             : all->texel == QTRI_TEXEL_ALPHA8   ? QTRI_TEXEL_ALPHA8                               \
                                                 : QTRI_TEXEL_ARGB8888,                              \
    .shade = all->shade == QTRI_FLAT ? QTRI_FLAT : QTRI_TINT
ON_RGB565(draw_sprite, IN_FINE | ASK(READ) | ASK(ALPHA) | ASK(ALPHA_USED), SPRITE,
          .blend = QTRI_ALPHA)
ON_RGB565(draw_light, QTRI_IN_888 << QTRI_ASK_KIND | ASK(READ) | ASK(ALPHA) | ASK(ALPHA_USED),
          SPRITE, .blend = QTRI_ADD)
ON_RGB565(draw_fogged, IN_FINE | (all->asks & ASK(TWO_WORDS)), .shade = all->shade, .fog = 1)
ON_RGB565(draw_fogged_texture, IN_FINE | (all->asks & ASK(TWO_WORDS)), .texel = QTRI_TEXEL_RGB565,
          .shade = all->shade, .fog = 1)
ON_RGB565(draw_filtered, ASK(TWO_WORDS), .texel = QTRI_TEXEL_RGB565, .bilinear = 1,
          .shade = all->shade)

static bool is_plain_565(const qtri_options *o)
{
    return o->texel == QTRI_NO_TEXEL || o->texel == QTRI_TEXEL_RGB565;
}

qtri_pixels_loop *qtri_blended_loop(const qtri_options *o)
{
    if (o->blend > QTRI_MULTIPLY) {
        return NULL;
    }
    return is_plain_565(o) ? draw_blended
           : o->blend != QTRI_MULTIPLY && o->texel >= QTRI_TEXEL_ARGB8888 &&
                   o->texel <= QTRI_TEXEL_ALPHA8 && o->shade <= QTRI_TINT
               ? (o->blend == QTRI_ALPHA ? draw_sprite : draw_light)
               : NULL;
}

qtri_pixels_loop *qtri_fogged_loop(const qtri_options *o)
{
    return !is_plain_565(o) || qtri_kind_of(o) != QTRI_IN_FINE_565 ? NULL
           : o->texel == QTRI_NO_TEXEL                             ? draw_fogged
                                                                   : draw_fogged_texture;
}

qtri_pixels_loop *qtri_filtered_loop(const qtri_options *o)
{
    return is_plain_565(o) ? draw_filtered : NULL;
}

/* Depths of another format. A copy of one is of the application's own: its kind may differ. */
#define ON_DEPTHS(name, DEPTH)                                                                     \
    ON_RGB565(draw_on_##name, all->asks &(ASK(TWO_WORDS) | ASK(PACKED) | ASK(TABLE) | ASK(PLAIN)), \
              .texel = TEXEL_565, .shade = all->shade, .depth = (DEPTH))                           \
    qtri_pixels_loop *qtri_##name##_loop(const qtri_options *o)                                    \
    {                                                                                              \
        return o->depth == (DEPTH) && is_plain_565(o) ? draw_on_##name : NULL;                     \
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
