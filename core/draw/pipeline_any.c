/* SPDX-License-Identifier: MIT */
/*
 * The generic pipeline: the body with options that are read at run time. What most programs ask for
 * has loops in which most are constants, any comparison of depths included. Millions of
 * instructions on a Cortex-M0+ by draw_other, and by these: flat S1l 14.9, 1.4; colours S2l 17.7,
 * 3.6; a texture S3l 15.5, 3.0; a lit mesh S4kl 14.9, 7.8; on other formats S4kg 15.6, 10.4.
 */
#include <stdbool.h>
#include <stdint.h>

#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#define QTRI_PIPELINE_IS_ANY_LOOP
#include "qtri/pipeline_make.h"

#include "../raster/draw_state.h"

QTRI_BODY void draw_pixels(const qtri_options *o, qtri_pixel_walk *w, bool bent, int32_t count,
                           uint32_t depth_step)
{
    do {
        qtri_pixel_at(o, w, bent, w->pixel, w->depth);
        qtri_walk_swap_steps(o, w);
        w->pixel += o->pixel_bytes;
        w->depth += depth_step;
    } while (--count != 0);
}

/* With 16 bits of depth, by a copy of the walk, which the compiler keeps in registers; what rows go
   on with is copied back. */
QTRI_BODY void draw_shaded(qtri_options o, qtri_pixel_walk *w, bool bent, int32_t count)
{
    const qtri_options *all = &w->state->options;
    qtri_pixel_walk own = *w;
    own.keeps_depth = all->read_only;
    o.depth = QTRI_LINEAR16;
    o.depth_bytes = 2;
    o.read_only = QTRI_ANY;
    o.asks |= 1u << QTRI_ASK_TEST | 1u << QTRI_ASK_WRITE | 1u << QTRI_ASK_DEPTH;
    QTRI_BODY_ASSUME(count > 0);
    draw_pixels(&o, &own, bent, count, all->depth_bytes);
    w->pixel = own.pixel;
    w->depth = own.depth;
    w->z = own.z;
    if (qtri_is_textured(&o)) {
        w->u = own.u;
        w->v = own.v;
        w->u_step = own.u_step;
        w->v_step = own.v_step;
    }
    if (qtri_varies(&o)) {
        w->c = own.c;
    }
    if (qtri_has_two_words(&o)) {
        w->g = own.g;
    }
}

/* Surfaces of any format, with 16 bits of depth or none; `asks`: QTRI_ASK_ bits that may be set. */
QTRI_BODY qtri_options of_any(const qtri_pixel_walk *w, uint32_t asks)
{
    const qtri_options *all = &w->state->options;
    asks |= 3u << QTRI_ASK_KIND | 1u << QTRI_ASK_565;
    const qtri_options o = {.format = all->format,
                            .texel = all->texel,
                            .key = all->key,
                            .shade = all->shade,
                            .pixel_bytes = all->pixel_bytes,
                            .asks = (uint16_t)(all->asks & asks)};
    return o;
}

QTRI_BODY_ALONE void draw_flat(qtri_pixel_walk *w, bool bent, int32_t count)
{
    qtri_options o = of_any(w, 0);
    o.texel = QTRI_NO_TEXEL;
    o.shade = QTRI_FLAT;
    o.asks |= 1u << QTRI_ASK_PLAIN;
    draw_shaded(o, w, bent, count);
}

QTRI_BODY_ALONE void draw_smooth(qtri_pixel_walk *w, bool bent, int32_t count)
{
    qtri_options o = of_any(w, 1u << QTRI_ASK_TWO_WORDS);
    o.texel = QTRI_NO_TEXEL;
    draw_shaded(o, w, bent, count);
}

QTRI_BODY_ALONE void draw_texture(qtri_pixel_walk *w, bool bent, int32_t count)
{
    qtri_options o =
        of_any(w, 1u << QTRI_ASK_TWO_WORDS | 1u << QTRI_ASK_DISCARD | 1u << QTRI_ASK_ALPHA);
    QTRI_BODY_ASSUME(o.texel != QTRI_NO_TEXEL);
    draw_shaded(o, w, bent, count);
}

QTRI_BODY_ALONE void draw_other(qtri_pixel_walk *w, bool bent, int32_t count)
{
    const qtri_options *o = &w->state->options;
    draw_pixels(o, w, bent, count, o->depth_bytes);
}

/* RGB565 in either order of bytes, in colours of 565, and what is constant then. */
#define ON_RGB565(name, TEXEL, KEY, SHADE, ASKS)                                                   \
    QTRI_BODY_ALONE void name(qtri_pixel_walk *w, bool bent, int32_t count)                        \
    {                                                                                              \
        const bool swaps = w->state->options.format != QTRI_RGB565;                                \
        const qtri_options o = {.format = swaps ? QTRI_RGB565_SWAPPED : QTRI_RGB565,               \
                                .texel = (TEXEL),                                                  \
                                .key = (KEY),                                                      \
                                .shade = (SHADE),                                                  \
                                .pixel_bytes = 2,                                                  \
                                .asks =                                                            \
                                    QTRI_IN_565 << QTRI_ASK_KIND | 1u << QTRI_ASK_565 | (ASKS)};   \
        draw_shaded(o, w, bent, count);                                                            \
    }

ON_RGB565(draw_flat_565, QTRI_NO_TEXEL, 0, QTRI_FLAT, 1u << QTRI_ASK_PLAIN)
ON_RGB565(draw_lit_565, QTRI_NO_TEXEL, 0, QTRI_LIGHT, 1u << QTRI_ASK_TABLE)
ON_RGB565(draw_colors_565, QTRI_NO_TEXEL, 0, QTRI_COLORS, 1u << QTRI_ASK_PACKED)
/* Where a texture has no key, the state's is none that a texel can be: see choose(). */
ON_RGB565(draw_texture_565, QTRI_TEXEL_RGB565, 1, QTRI_FLAT, 1u << QTRI_ASK_DISCARD)
ON_RGB565(draw_texture_white_565, QTRI_TEXEL_RGB565, 0, QTRI_WHITE_LIGHT, 0)
ON_RGB565(draw_texture_shaded_565, QTRI_TEXEL_RGB565, 0, w->state->options.shade,
          1u << QTRI_ASK_TWO_WORDS)
ON_RGB565(draw_stored_565,
          w->state->options.texel == QTRI_TEXEL_RGB565 ? QTRI_TEXEL_RGB565 : QTRI_TEXEL_PALETTE565,
          1, w->state->options.shade, 1u << QTRI_ASK_TWO_WORDS | 1u << QTRI_ASK_DISCARD)

/* By what options ask for: the loop that draws the pixels. */
static qtri_pixels_loop *loop_of(const qtri_options *o)
{
    const bool is_565 = o->format == QTRI_RGB565 || o->format == QTRI_RGB565_SWAPPED;
    if ((o->bilinear | o->alpha_test | o->keep | o->fog | o->blend | o->large_texture) != 0 ||
        o->fragment != NULL || o->depth > QTRI_LINEAR16) {
        return draw_other;
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
    return o->texel != QTRI_NO_TEXEL ? draw_texture
           : o->shade == QTRI_FLAT   ? draw_flat
                                     : draw_smooth;
}

/* Where there are no depths, one stands for all: each pixel passes, and loops need not ask. */
static const qtri_pipeline *choose(const qtri_pipeline *generic, qtri_draw_state *state)
{
    qtri_options *o = &state->options;
    state->loop = loop_of(o);
    (void)qtri_draw_state_ask(generic, state);
    state->key = o->key ? state->key : UINT32_MAX;
    if (!qtri_tests_depth(o) && state->loop != draw_other) {
        o->asks |= 1u << QTRI_ASK_TEST;
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
