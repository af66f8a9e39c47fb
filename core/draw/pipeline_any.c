/* SPDX-License-Identifier: MIT */
/*
 * The generic pipeline: the body with options that are read at run time. What most programs ask for
 * has loops in which most are constants. Millions of instructions on a Cortex-M0+ without a loop,
 * and with it: draw_flat S1l 15.1, 4.7; draw_smooth S4kg 16.6, 13.1, on RGB565 S2l 8.5, 5.7;
 * draw_texture S3l 15.7, 10.1, on RGB565 5.3.
 */
#include <stdbool.h>
#include <stdint.h>

struct qtri_pixel_walk;
static void draw_piece(struct qtri_pixel_walk *w, bool bent, int32_t count);

#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#define QTRI_PIPELINE_IS_ANY_LOOP draw_piece
#include "qtri/pipeline_make.h"

#include "../raster/draw_state.h"

QTRI_BODY void draw_pixels(const qtri_options *o, qtri_pixel_walk *w, bool bent, int32_t count)
{
    do {
        qtri_pixel_at(o, w, bent, w->pixel, w->depth);
        if (qtri_is_packed_565(o)) { /* see qtri_pixel_next() */
            const uint32_t step = w->c_step;
            w->c_step = w->c_other;
            w->c_other = step;
        }
        w->pixel += o->pixel_bytes;
        if (qtri_tests_depth(o)) {
            w->depth += o->depth_bytes;
        }
    } while (--count > 0);
}

/* Options of pixels that are shaded and stored, with 16 bits of depth or none; `asks`: a set of
   QTRI_ASK_ bits that may be set besides. */
QTRI_BODY qtri_options shaded(const qtri_pixel_walk *w, uint32_t asks)
{
    const qtri_options *all = &w->state->options;
    const uint32_t kept =
        3u << QTRI_ASK_KIND | 1u << QTRI_ASK_565 | 1u << QTRI_ASK_TEST | 1u << QTRI_ASK_WRITE;
    const qtri_options o = {.format = all->format,
                            .depth = QTRI_LINEAR16,
                            .texel = all->texel,
                            .key = all->key,
                            .shade = all->shade,
                            .pixel_bytes = all->pixel_bytes,
                            .depth_bytes = 2,
                            /* Depth is stepped, whether it is tested or not. */
                            .asks = (uint16_t)((all->asks & (kept | asks)) | 1u << QTRI_ASK_DEPTH)};
    return o;
}

/* These on RGB565, in colours of 565. */
QTRI_BODY qtri_options on_rgb565(const qtri_pixel_walk *w, uint32_t asks)
{
    qtri_options o = shaded(w, asks);
    o.format = QTRI_RGB565;
    o.pixel_bytes = 2;
    o.asks &= (uint16_t) ~(3u << QTRI_ASK_KIND);
    o.asks |= QTRI_IN_565 << QTRI_ASK_KIND | 1u << QTRI_ASK_565;
    return o;
}

QTRI_BODY_ALONE void draw_flat(qtri_pixel_walk *w, int32_t count)
{
    qtri_options o = shaded(w, 0);
    o.texel = QTRI_NO_TEXEL;
    o.shade = QTRI_FLAT;
    o.asks |= 1u << QTRI_ASK_PLAIN;
    draw_pixels(&o, w, false, count);
}

QTRI_BODY_ALONE void draw_smooth(qtri_pixel_walk *w, int32_t count)
{
    qtri_options o =
        shaded(w, 1u << QTRI_ASK_TWO_WORDS | 1u << QTRI_ASK_PACKED | 1u << QTRI_ASK_TABLE);
    o.texel = QTRI_NO_TEXEL;
    draw_pixels(&o, w, false, count);
}

QTRI_BODY_ALONE void draw_smooth_rgb565(qtri_pixel_walk *w, int32_t count)
{
    qtri_options o = on_rgb565(w, 1u << QTRI_ASK_PACKED | 1u << QTRI_ASK_TABLE);
    o.texel = QTRI_NO_TEXEL;
    draw_pixels(&o, w, false, count);
}

QTRI_BODY_ALONE void draw_texture_rgb565(qtri_pixel_walk *w, bool bent, int32_t count)
{
    qtri_options o = on_rgb565(w, 1u << QTRI_ASK_TWO_WORDS);
    o.texel = QTRI_TEXEL_RGB565;
    o.key = 0;
    draw_pixels(&o, w, bent, count);
}

QTRI_BODY_ALONE void draw_texture(qtri_pixel_walk *w, bool bent, int32_t count)
{
    const qtri_options o =
        shaded(w, 1u << QTRI_ASK_TWO_WORDS | 1u << QTRI_ASK_DISCARD | 1u << QTRI_ASK_ALPHA);
    draw_pixels(&o, w, bent, count);
}

QTRI_BODY_ALONE void draw_other(qtri_pixel_walk *w, bool bent, int32_t count)
{
    draw_pixels(&w->state->options, w, bent, count);
}

static void draw_piece(struct qtri_pixel_walk *w, bool bent, int32_t count)
{
    const qtri_options *o = &w->state->options;
    if ((o->bilinear | o->alpha_test | o->keep | o->fog | o->blend | o->large_texture) != 0 ||
        o->fragment != NULL || o->depth > QTRI_LINEAR16) {
        draw_other(w, bent, count);
    } else if (o->texel == QTRI_TEXEL_RGB565 && !o->key && o->format == QTRI_RGB565) {
        draw_texture_rgb565(w, bent, count);
    } else if (o->texel != QTRI_NO_TEXEL) {
        draw_texture(w, bent, count);
    } else if (o->shade == QTRI_FLAT) {
        draw_flat(w, count);
    } else if (o->format == QTRI_RGB565) {
        draw_smooth_rgb565(w, count);
    } else {
        draw_smooth(w, count);
    }
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
    .options = {.format = QTRI_ANY}, .large = large, .small = small, .choose = qtri_draw_state_ask};
