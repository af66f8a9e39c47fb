/* SPDX-License-Identifier: MIT */
/*
 * Spans of a stroke: pixels with the colours of one part and a weight each, drawn by the pipelines'
 * body. Internal.
 *
 * Depth and colour are linear along a part: a pixel has a share of its length, from which both
 * follow. The options are those of triangles in one colour (QTRI_FLAT), which each pixel sets, and
 * `covered` where a pixel may take less than all of it.
 */
#ifndef QTRI_RASTER_STROKE_PIXELS_H
#define QTRI_RASTER_STROKE_PIXELS_H

#include "qtri/body/pixel.h"

#include "../paint/coverage.h"

/* Depth and colour at an end of a part. */
typedef struct qtri_stroke_end {
    uint32_t depth_16p8; /* 0..65535.0 */
    int32_t color_8p16[3];
} qtri_stroke_end;

/* Depth and colour along a part, by a point's share of its length, Q16, from the first end on. */
typedef struct qtri_stroke_look {
    uint32_t z_16p16, z_low; /* the difference: z_high 2^16 + z_low, 0 <= z_low < 2^16 */
    int32_t z_high;
    int32_t color_8p8[3], color_delta[3]; /* at the first end, and the difference */
    bool has_one_color;                   /* one colour */
    bool is_constant;                     /* and one depth */
    /* Not NULL: 129 RGB565 colours by light, in place of those above; light at the first end, Q29,
       and the difference of that at the last, Q15. */
    const uint16_t *light_table;
    int32_t light_q29, light_step;
} qtri_stroke_look;

/* Added to a weight where half of the pixel or more is covered: its depth is written. */
#define QTRI_STROKE_WRITES 0x8000u

typedef struct qtri_stroke_span {
    const qtri_draw_state *state;
    const qtri_stroke_look *look;
    int32_t x, y, count, rows; /* inside the state's bounds; of each pixel: */
    const uint16_t *weight;    /* 0..256, 0 is skipped, and QTRI_STROKE_WRITES */
    const uint16_t *share;     /* not read where the look is constant */
} qtri_stroke_span;

/* The weight of a pixel by its coverage, 0..QTRI_COVERAGE_FULL, and alpha: to nearest, so that less
   than a half of 1/256 is 0. */
static inline uint32_t qtri_stroke_weight(uint32_t cover, uint32_t alpha_q16)
{
    const uint32_t weight = ((cover >> 2) * alpha_q16 + ((uint32_t)1 << 22)) >> 23; /* < 2^32 */
    return cover >= QTRI_COVERAGE_FULL / 2 ? weight | QTRI_STROKE_WRITES : weight;
}

/* The draw state of strokes of a draw call, and surfaces of samples. */
typedef struct qtri_stroke_target {
    qtri_draw_state state;
    qtri_material material;      /* the draw call's, without fragment function and alphas */
    const qtri_surface *samples; /* of four a pixel; NULL: the state's surface is the target */
    qtri_surface pixel;          /* a pixel of it, with one sample, in a qtri_stroke_sample */
    uint32_t alpha_q16;          /* 2^16: opaque */
} qtri_stroke_target;

/* False: nothing can be drawn. `alpha`: 1..255. Not `is_smooth`: coverage is 0 or full. */
bool qtri_stroke_target_init(qtri_stroke_target *to, const qtri_surface *surface,
                             const qtri_material *material, const qtri_pipeline *const *pipelines,
                             uint8_t alpha, bool is_smooth);

/* A pixel of samples, while it is drawn as column x of to->pixel, the state's surface. */
typedef struct qtri_stroke_sample {
    uint32_t words[4];
    uint8_t *record; /* on the surface of samples */
    uint32_t before; /* the mean of its samples */
    int32_t x;       /* 0..3 */
} qtri_stroke_sample;

void qtri_stroke_sample_begin(qtri_stroke_sample *sample, qtri_stroke_target *to, int32_t x,
                              int32_t y);
void qtri_stroke_sample_end(const qtri_stroke_sample *sample, const qtri_stroke_target *to);

/* Draws a span whose state is the target's. */
void qtri_stroke_target_draw(qtri_stroke_target *to, const qtri_stroke_span *span);

/* Sets depth and colour along a part with these ends. */
void qtri_stroke_look_init(qtri_stroke_look *look, const qtri_stroke_end end[2]);

/* Pipelines that draw spans of strokes. */
extern const qtri_pipeline *const qtri_stroke_pipelines[];
extern const qtri_pipeline qtri_stroke_any; /* the last: generic */

static inline void qtri_stroke_look_set_depth(qtri_stroke_look *look, uint32_t from, uint32_t to)
{
    look->z_16p16 = from;
    look->z_low = (to - from) & 0xFFFFu;
    look->z_high = (int32_t)((to >> 16) - (from >> 16)) - ((to & 0xFFFFu) < (from & 0xFFFFu));
}

/* Sets one colour and depth. */
static inline void qtri_stroke_look_set_constant(qtri_stroke_look *look, uint32_t depth_16p16,
                                                 const qtri_rgb *color)
{
    look->z_16p16 = depth_16p16;
    look->color_8p8[0] = color->r << 8;
    look->color_8p8[1] = color->g << 8;
    look->color_8p8[2] = color->b << 8;
    look->has_one_color = look->is_constant = true;
    look->light_table = NULL;
}

/* A share 0..65535 as 0..2^16, so that the last end has all of its own depth and colour. */
QTRI_BODY uint32_t qtri_stroke_share(uint32_t share_q16)
{
    return share_q16 + (share_q16 >> 15);
}

/* Depth, 16.16, at a share: `from` + delta share / 2^16, modulo 2^32. */
QTRI_BODY uint32_t qtri_stroke_depth_at(const qtri_stroke_look *look, uint32_t share_q16)
{
    return look->z_16p16 + (uint32_t)look->z_high * share_q16 + ((look->z_low * share_q16) >> 16);
}

/* Channel i, 0..255, at a share, of which 15 bits count; |delta| < 2^16. */
QTRI_BODY uint32_t qtri_stroke_channel_at(const qtri_stroke_look *look, int i, uint32_t share_q16)
{
    const int32_t more = look->color_delta[i] * (int32_t)(share_q16 >> 1);
    const int32_t c = look->color_8p8[i] + ((more + (1 << 14)) >> 15) + 128;
    return (uint32_t)c >> 8;
}

/* 0xRRGGBB at a share. */
QTRI_BODY uint32_t qtri_stroke_color_at(const qtri_stroke_look *look, uint32_t share_q16)
{
    return qtri_stroke_channel_at(look, 0, share_q16) << 16 |
           qtri_stroke_channel_at(look, 1, share_q16) << 8 |
           qtri_stroke_channel_at(look, 2, share_q16);
}

/* RGB565 at a share, by the light there. */
QTRI_BODY uint32_t qtri_stroke_lit_color_at(const qtri_stroke_look *look, uint32_t share_q16)
{
    const int32_t light = look->light_q29 + look->light_step * (int32_t)(share_q16 >> 2);
    return look->light_table[((uint32_t)light + ((uint32_t)1 << 21)) >> 22];
}

/* Sets the walk's colour at a share, and returns the depth there. */
QTRI_BODY uint32_t qtri_stroke_pixel_look(const qtri_options *o, qtri_pixel_walk *w,
                                          const qtri_stroke_look *look, uint32_t share_q16)
{
    const uint32_t at = qtri_stroke_share(share_q16);
    if (look->light_table != NULL) {
        w->color = qtri_stroke_lit_color_at(look, at);
    } else if (!look->has_one_color) {
        w->color = qtri_walk_color(o, w->state->surface, qtri_stroke_color_at(look, at));
    }
    return qtri_stroke_depth_at(look, at);
}

/* Draws rows from the walk's pixel on. Pipelines have a loop of their own for a constant look. */
QTRI_BODY void qtri_stroke_rows(const qtri_options *o, qtri_pixel_walk *w,
                                const qtri_stroke_span *span, bool is_constant)
{
    const qtri_draw_state *state = span->state;
    const qtri_stroke_look *look = span->look;
    const ptrdiff_t step = (ptrdiff_t)qtri_pixel_bytes(o);
    const ptrdiff_t depth_step = (ptrdiff_t)qtri_depth_size(o, state->surface);
    const uint16_t *weight = span->weight;
    const uint16_t *share = span->share;
    uint32_t z = look->z_16p16;
    for (int32_t rows = span->rows; rows > 0; rows--) {
        const uint16_t *const end = weight + span->count;
        for (; weight != end; weight++) {
            if (*weight != 0) {
                if (!is_constant) {
                    z = qtri_stroke_pixel_look(o, w, look, *share);
                }
                if (qtri_needs_depth(o)) {
                    w->z = z + QTRI_DEPTH_HALF;
                }
                if (o->covered) {
                    w->cover = *weight & 0x1FFu;
                    w->cover_writes = *weight >= QTRI_STROKE_WRITES;
                }
                if (o->fog) {
                    w->fog = qtri_fog_share(state->fog, z + 0x8000u);
                }
                qtri_pixel_at(o, w, false, w->pixel, w->depth);
            } else {
                w->x++;
            }
            share += !is_constant;
            w->pixel += step;
            if (qtri_tests_depth(o)) {
                w->depth += depth_step;
            }
        }
        w->x = span->x;
        w->y++;
        w->pixel += state->surface->pitch - span->count * step;
        if (qtri_tests_depth(o)) {
            w->depth += state->depth_pitch - span->count * depth_step;
        }
    }
}

QTRI_BODY void qtri_stroke_span_draw(const qtri_options *o, const qtri_stroke_span *span)
{
    const qtri_draw_state *state = span->state;
    const qtri_surface *surface = state->surface;
    const qtri_stroke_look *look = span->look;
    const ptrdiff_t row = span->y - surface->first_row;
    qtri_pixel_walk w = QTRI_BODY_ZERO;
    qtri_walk_begin(o, &w, state);
    w.pixel = surface->pixels + row * surface->pitch +
              (ptrdiff_t)span->x * (ptrdiff_t)qtri_pixel_bytes(o);
    if (qtri_tests_depth(o)) {
        w.depth = (uint8_t *)(void *)surface->depth + row * state->depth_pitch +
                  (ptrdiff_t)span->x * (ptrdiff_t)qtri_depth_size(o, surface);
    }
    w.x = span->x;
    w.y = span->y;
    if (look->has_one_color) {
        w.color = qtri_walk_color(o, surface, qtri_stroke_color_at(look, 0));
    }
#if !defined(QTRI_PIPELINE_IS_ANY)
    if (look->is_constant) {
        qtri_stroke_rows(o, &w, span, true);
        return;
    }
#endif
    qtri_stroke_rows(o, &w, span, look->is_constant);
}

#endif
