/* SPDX-License-Identifier: MIT */
/*
 * Pixels of a row that one part of a stroke colours: written by the pipelines' body, each with what
 * the stroke covers of it. Internal.
 *
 * Depth and colour are linear along a part: a pixel has a share of its length, from which both
 * follow. The options are those of triangles in one colour (QTRI_FLAT), which each pixel sets, and
 * `covered` where a pixel may take less than all of it.
 */
#ifndef QTRI_RASTER_STROKE_PIXELS_H
#define QTRI_RASTER_STROKE_PIXELS_H

#include "qtri/body/pixel.h"

#include "../paint/coverage.h"

/* What an end of a part looks like. */
typedef struct qtri_stroke_end {
    uint32_t depth_16p8; /* 0..65535.0 */
    int32_t color_8p16[3];
} qtri_stroke_end;

/* Depth and colour along a part, by a point's share of its length, Q16, from the first end on. */
typedef struct qtri_stroke_look {
    uint32_t z_16p16, z_low; /* the difference: z_high 2^16 + z_low, 0 <= z_low < 2^16 */
    int32_t z_high;
    int32_t color_8p8[3], color_delta[3];
    bool is_even;  /* one colour */
    bool is_level; /* and one depth */
    /* Not NULL: 129 RGB565 colours by light, in place of those above; light at the first end, Q29,
       and the difference of that at the last, Q15. */
    const uint16_t *tints;
    int32_t light_q29, light_step;
} qtri_stroke_look;

/* Added to a weight where half of the pixel or more is covered: its depth is written. */
#define QTRI_STROKE_WRITES 0x8000u

typedef struct qtri_stroke_span {
    const qtri_draw_state *state;
    const qtri_stroke_look *look;
    int32_t x, y, count, rows; /* inside the state's bounds; row by row: */
    const uint16_t *weight;    /* 256: all of a pixel; 0: nothing of it is drawn */
    const uint16_t *share;     /* of a level part it is not read */
} qtri_stroke_span;

/* What a pixel takes of a stroke: see qtri_stroke_span and QTRI_COVERAGE_FULL. Less than a half of
   1/256 is nothing. */
static inline uint32_t qtri_stroke_weight(uint32_t cover, uint32_t alpha_q16)
{
    const uint32_t weight = ((cover >> 2) * alpha_q16 + ((uint32_t)1 << 22)) >> 23; /* < 2^32 */
    return cover >= QTRI_COVERAGE_FULL / 2 ? weight | QTRI_STROKE_WRITES : weight;
}

/* Where strokes of one draw call are drawn to, and how. */
typedef struct qtri_stroke_target {
    qtri_draw_state state;
    qtri_material material;      /* what of the draw call's counts */
    const qtri_surface *samples; /* of four a pixel; NULL: the state's surface is the target */
    qtri_surface pixel;          /* one of its pixels */
    uint32_t alpha_q16;          /* 2^16: opaque */
} qtri_stroke_target;

/* False: nothing can be drawn. `alpha` 1..255; not `is_smooth`: pixels are covered wholly. */
bool qtri_stroke_target_init(qtri_stroke_target *to, const qtri_surface *surface,
                             const qtri_material *material, const qtri_pipeline *const *pipelines,
                             uint8_t alpha, bool is_smooth);

/* A pixel of samples, while it is drawn: in column x and row y of the state's surface. */
typedef struct qtri_stroke_sample {
    uint32_t words[4];
    uint8_t *record;
    uint32_t before;
    int32_t x; /* 0..3 */
} qtri_stroke_sample;

void qtri_stroke_sample_begin(qtri_stroke_sample *sample, qtri_stroke_target *to, int32_t x,
                              int32_t y);
void qtri_stroke_sample_end(const qtri_stroke_sample *sample, const qtri_stroke_target *to);

/* span->state is the target's. */
void qtri_stroke_target_draw(qtri_stroke_target *to, const qtri_stroke_span *span);

/* Sets the look of a part with these ends. */
void qtri_stroke_look_init(qtri_stroke_look *look, const qtri_stroke_end end[2]);

/* Strokes whose pixels are covered in part, or wholly: what draws them, by the draw state's
 * options. */
extern const qtri_pipeline *const qtri_stroke_pipelines[];
extern const qtri_pipeline qtri_stroke_any; /* its last: by options that are read for each pixel */

static inline void qtri_stroke_look_set_depth(qtri_stroke_look *look, uint32_t from, uint32_t to)
{
    look->z_16p16 = from;
    look->z_low = (to - from) & 0xFFFFu;
    look->z_high = (int32_t)((to >> 16) - (from >> 16)) - ((to & 0xFFFFu) < (from & 0xFFFFu));
}

/* One colour and depth. */
static inline void qtri_stroke_look_set_level(qtri_stroke_look *look, uint32_t depth_16p16,
                                              const qtri_rgb *color)
{
    look->z_16p16 = depth_16p16;
    look->color_8p8[0] = color->r << 8;
    look->color_8p8[1] = color->g << 8;
    look->color_8p8[2] = color->b << 8;
    look->is_even = look->is_level = true;
    look->tints = NULL;
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
QTRI_BODY uint32_t qtri_stroke_tint_at(const qtri_stroke_look *look, uint32_t share_q16)
{
    const int32_t light = look->light_q29 + look->light_step * (int32_t)(share_q16 >> 2);
    return look->tints[((uint32_t)light + ((uint32_t)1 << 21)) >> 22];
}

/* Depth and colour of a pixel whose part is not level. */
QTRI_BODY uint32_t qtri_stroke_pixel_look(const qtri_options *o, qtri_pixel_walk *w,
                                          const qtri_stroke_look *look, uint32_t share_q16)
{
    const uint32_t at = qtri_stroke_share(share_q16);
    if (look->tints != NULL) {
        w->color = qtri_stroke_tint_at(look, at);
    } else if (!look->is_even) {
        w->color = qtri_walk_color(o, w->state->surface, qtri_stroke_color_at(look, at));
    }
    return qtri_stroke_depth_at(look, at);
}

/* From the walk's pixel on. A pipeline has a loop of its own for parts that are level. */
QTRI_BODY void qtri_stroke_rows(const qtri_options *o, qtri_pixel_walk *w,
                                const qtri_stroke_span *span, bool is_level)
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
                if (!is_level) {
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
            share += !is_level;
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
    if (look->is_even) {
        w.color = qtri_walk_color(o, surface, qtri_stroke_color_at(look, 0));
    }
#if !defined(QTRI_PIPELINE_IS_ANY)
    if (look->is_level) {
        qtri_stroke_rows(o, &w, span, true);
        return;
    }
#endif
    qtri_stroke_rows(o, &w, span, look->is_level);
}

#endif
