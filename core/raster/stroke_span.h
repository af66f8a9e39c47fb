/* SPDX-License-Identifier: MIT */
/*
 * Pixels of a row that one part of a stroke colours: written by the pipelines' body, each with what
 * the stroke covers of it. Internal.
 *
 * Depth and colour are linear along a part: a pixel has a share of its length, from which both
 * follow. The options are those of triangles in one colour (QTRI_FLAT), which each pixel sets, and
 * `covered` where a pixel may take less than all of it.
 */
#ifndef QTRI_RASTER_STROKE_SPAN_H
#define QTRI_RASTER_STROKE_SPAN_H

#include "qtri/body/pixel.h"

/* From a part's first end to its last, at shares of 16 bits. */
typedef struct qtri_stroke_look {
    uint32_t z_16p16, z_low; /* the difference: z_high 2^16 + z_low, 0 <= z_low < 2^16 */
    int32_t z_high;
    int32_t color_8p8[3], color_delta[3];
    bool is_even;  /* one colour */
    bool is_level; /* and one depth */
} qtri_stroke_look;

/* Added to a weight: half of the pixel or more is covered, so that its depth is written. */
#define QTRI_STROKE_WRITES 0x8000u

typedef struct qtri_stroke_span {
    const qtri_draw_state *state;
    const qtri_stroke_look *look;
    int32_t x, y, count;    /* inside the state's bounds */
    const uint16_t *weight; /* 256: all of a pixel; 0: nothing of it is drawn */
    const uint16_t *share;  /* of a level part it is not read */
} qtri_stroke_span;

/* Strokes whose pixels are covered in part, or wholly: what draws them, by the draw state's
 * options. */
extern const qtri_pipeline *const qtri_stroke_pipelines[];

/* `from` + delta share / 2^16, modulo 2^32. */
QTRI_BODY uint32_t qtri_stroke_look_depth(const qtri_stroke_look *look, uint32_t share_q16)
{
    return look->z_16p16 + (uint32_t)look->z_high * share_q16 + ((look->z_low * share_q16) >> 16);
}

/* |delta| < 2^16; shares are cut off to 15 bits. */
QTRI_BODY uint32_t qtri_stroke_look_channel(const qtri_stroke_look *look, int i, uint32_t share_q16)
{
    const int32_t more = look->color_delta[i] * (int32_t)(share_q16 >> 1);
    const int32_t c = look->color_8p8[i] + ((more + (1 << 14)) >> 15) + 128;
    return (uint32_t)c >> 8;
}

QTRI_BODY uint32_t qtri_stroke_look_color(const qtri_stroke_look *look, uint32_t share_q16)
{
    return qtri_stroke_look_channel(look, 0, share_q16) << 16 |
           qtri_stroke_look_channel(look, 1, share_q16) << 8 |
           qtri_stroke_look_channel(look, 2, share_q16);
}

QTRI_BODY void qtri_stroke_span_draw(const qtri_options *o, const qtri_stroke_span *span)
{
    const qtri_draw_state *state = span->state;
    const qtri_surface *surface = state->surface;
    const qtri_stroke_look *look = span->look;
    const ptrdiff_t row = span->y - surface->first_row;
    const uint16_t *weight = span->weight;
    const uint16_t *const end = weight + span->count;
    const uint16_t *share = span->share;
    const bool is_level = look->is_level;
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
    uint32_t z = look->z_16p16;
    if (look->is_even) {
        w.color = qtri_walk_color(o, surface, qtri_stroke_look_color(look, 0));
    }
    for (; weight != end; weight++, share++) {
        if (*weight != 0) {
            if (!is_level) {
                z = qtri_stroke_look_depth(look, *share);
                if (!look->is_even) {
                    w.color = qtri_walk_color(o, surface, qtri_stroke_look_color(look, *share));
                }
            }
            if (qtri_needs_depth(o)) {
                w.z = z + qtri_depth_half(o);
            }
            if (o->covered) {
                w.cover = *weight & 0x1FFu;
                w.cover_writes = *weight >= QTRI_STROKE_WRITES;
            }
            if (o->fog) {
                w.fog = qtri_fog_share(state->fog, z + 0x8000u);
            }
            qtri_pixel_at(o, &w, false, w.pixel, w.depth);
        } else if (qtri_needs_place(o)) {
            w.x++;
        }
        qtri_walk_move(o, &w, 1);
    }
}

#endif
