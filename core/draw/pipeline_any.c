/* SPDX-License-Identifier: MIT */
/*
 * The generic pipeline: the body with options that are read at run time. What most programs ask for
 * has loops in which most are constants, any comparison of depths included. Millions of
 * instructions on a Cortex-M0+ by draw_other, and by these: flat S1l 14.9, 1.4; colours S2l 17.7,
 * 3.6; a texture S3l 15.5, 3.0, of 888 S3v 9.2, 5.0; a lit mesh S4kl 14.9, 7.8; on GRAY8 S4kg 15.6,
 * 8.4; without depths rgb565/off/flat/level of the matrix .40 by draw_flat_565, .09 as words; a
 * texture on XRGB8888, xrgb8888/less/replace/rgb565/nearest/repeat/level, 3.5 by draw_texture, 2.7.
 */
#include <stdbool.h>
#include <stdint.h>

#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#define QTRI_PIPELINE_IS_ANY_LOOP
#include "qtri/pipeline_make.h"

#include "../frame/pixel.h"
#include "../raster/descriptions.h"
#include "../raster/draw_state.h"

#include "../raster/any_loops.inc"

/* Of any format. Texels of other formats than surfaces have are never in 565. */
#define IN_888        (QTRI_IN_888 << QTRI_ASK_KIND | (ASK(TWO_WORDS) & all->asks))
#define IN_GRAY       (QTRI_IN_GRAY << QTRI_ASK_KIND)
#define OF_TEXELS     ((all->asks & 3) == QTRI_IN_GRAY ? IN_GRAY : IN_888)
#define ON_ANY_FORMAT .format = all->format, .pixel_bytes = all->pixel_bytes

LOOP(draw_flat, ASK(PLAIN), ON_ANY_FORMAT, .shade = QTRI_FLAT)
LOOP(draw_smooth, IN_888, ON_ANY_FORMAT, .shade = all->shade)
LOOP(draw_smooth_gray, IN_GRAY, .format = QTRI_GRAY8, .pixel_bytes = 1, .shade = all->shade)
LOOP(draw_texture_of_565, OF_TEXELS | ASK(DISCARD), ON_ANY_FORMAT, .texel = QTRI_TEXEL_RGB565,
     .key = 1, .shade = all->shade)
LOOP(draw_texture, OF_TEXELS | ((ASK(565) | ASK(DISCARD) | ASK(ALPHA)) & all->asks), ON_ANY_FORMAT,
     .texel = all->texel != QTRI_NO_TEXEL ? all->texel : QTRI_TEXEL_XRGB8888, .key = all->key,
     .shade = all->shade)

QTRI_BODY_ALONE void draw_other(qtri_pixel_walk *w, bool bent, int32_t count)
{
    const qtri_options *o = &w->state->options;
    draw_pixels(o, w, bent, count, o->depth_bytes);
}

/* One colour without depths: rows of words, and short ones pixel by pixel. */
QTRI_BODY_ALONE void draw_fill(qtri_pixel_walk *w, bool bent, int32_t count)
{
    const uint32_t bytes = w->state->options.pixel_bytes, color = w->color;
    uint8_t *pixel = w->pixel;
    w->pixel += (uint32_t)count * bytes;
    (void)bent;
    if (count >= 8) {
        const uint32_t ones = bytes == 1 ? 0x01010101u : bytes == 2 ? 0x00010001u : 1;
        qtri_fill_words(pixel, 0, (uint32_t)count * bytes, 1, color * ones);
        return;
    }
    for (; pixel != w->pixel; pixel += bytes) {
        qtri_save(bytes, pixel, color);
    }
}

/* In colours of 565. */
ON_RGB565(draw_flat_565, ASK(PLAIN), .shade = QTRI_FLAT)
ON_RGB565(draw_lit_565, ASK(TABLE), .shade = QTRI_LIGHT)
ON_RGB565(draw_colors_565, ASK(PACKED), .shade = QTRI_COLORS)
/* Where a texture has no key, the state's is none that a texel can be: see choose(). */
ON_RGB565(draw_texture_565, ASK(DISCARD), .texel = QTRI_TEXEL_RGB565, .key = 1)
ON_RGB565(draw_texture_white_565, 0, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_WHITE_LIGHT)
ON_RGB565(draw_texture_shaded_565, ASK(TWO_WORDS), .texel = QTRI_TEXEL_RGB565, .shade = all->shade)
ON_RGB565(draw_stored_565, ASK(TWO_WORDS) | ASK(DISCARD),
          .texel = all->texel == QTRI_TEXEL_RGB565 ? QTRI_TEXEL_RGB565 : QTRI_TEXEL_PALETTE565,
          .key = 1, .shade = all->shade)

/* In 888. */
ON_RGB565(draw_texture_888, IN_888 | ASK(DISCARD),
          .texel = all->texel == QTRI_TEXEL_XRGB8888 ? QTRI_TEXEL_XRGB8888 : QTRI_TEXEL_PALETTE8,
          .key = 1, .shade = QTRI_FLAT)

/* The loop for a blend, fog, a filter or depths of another format, which brings it: programs
   without them link none. */
static qtri_pixels_loop *loop_of_effect(const qtri_draw_state *state)
{
    const qtri_options *o = &state->options;
    const qtri_material *material = state->material;
    const bool has_depth = o->depth > QTRI_LINEAR16;
    const bool has_blend = o->blend != QTRI_STORE, has_fog = o->fog != 0;
    const qtri_effect *effect = has_depth   ? state->surface->depth_format->effect
                                : has_blend ? material->blend->effect
                                : has_fog   ? material->fog->effect
                                            : state->texture->filter->effect;
    qtri_pixels_loop *loop = effect != NULL ? effect->loop_of(o) : NULL;
    return loop != NULL ? loop : draw_other;
}

/* The loop that draws the pixels, by what options ask for. */
static qtri_pixels_loop *loop_of(const qtri_draw_state *state)
{
    const qtri_options *o = &state->options;
    const bool is_565 = qtri_stores_565(o);
    const bool has_effect = (o->bilinear | o->fog | o->blend) != 0 || o->depth > QTRI_LINEAR16;
    if ((o->alpha_test | o->keep | o->large_texture) != 0 || o->fragment != NULL) {
        return draw_other;
    }
    if (has_effect) {
        return loop_of_effect(state);
    }
    if (qtri_has_constant_color(o) && !qtri_tests_depth(o) && o->pixel_bytes != 3) {
        return draw_fill;
    }
    if (is_565 && o->texel == QTRI_NO_TEXEL) {
        return o->shade == QTRI_COLORS ? draw_colors_565
               : qtri_is_lit(o)        ? draw_lit_565
                                       : draw_flat_565;
    }
    if (is_565 && (o->texel == QTRI_TEXEL_RGB565 || o->texel == QTRI_TEXEL_PALETTE565)) {
        const bool has_palette = o->texel != QTRI_TEXEL_RGB565, is_flat = o->shade == QTRI_FLAT;
        return has_palette || (o->key && !is_flat) ? draw_stored_565
               : is_flat                           ? draw_texture_565
               : o->shade == QTRI_WHITE_LIGHT      ? draw_texture_white_565
                                                   : draw_texture_shaded_565;
    }
    if (is_565 && o->shade == QTRI_FLAT &&
        (o->texel == QTRI_TEXEL_XRGB8888 || o->texel == QTRI_TEXEL_PALETTE8)) {
        return draw_texture_888;
    }
    return o->texel == QTRI_TEXEL_RGB565 ? draw_texture_of_565
           : o->texel != QTRI_NO_TEXEL   ? draw_texture
           : o->shade == QTRI_FLAT       ? draw_flat
           : o->format == QTRI_GRAY8     ? draw_smooth_gray
                                         : draw_smooth;
}

/* Where there are no depths, one stands for all: each pixel passes, and loops need not ask. */
static const qtri_pipeline *choose(const qtri_pipeline *generic, qtri_draw_state *state)
{
    qtri_options *o = &state->options;
    (void)qtri_draw_state_ask(generic, state);
    state->loop = loop_of(state);
    state->key = o->key ? state->key : UINT32_MAX;
    if (!qtri_tests_depth(o) && state->loop != draw_other) {
        o->asks |= ASK(TEST);
        o->depth_bytes = 0;
        state->depth = &state->no_depth;
        state->depth_pitch = state->no_depth = 0;
    }
    return generic;
}

static void large(const struct qtri_large_input *triangle)
{
    qtri_large_triangle_draw(&triangle->state->options, NULL, triangle);
}

static bool small(struct qtri_small *triangle)
{
    return qtri_small_instance_draw(&triangle->state->options, NULL, triangle);
}

const qtri_pipeline qtri_pipeline_any = {
    .options = {.format = QTRI_ANY}, .large = large, .small = small, .choose = choose};
