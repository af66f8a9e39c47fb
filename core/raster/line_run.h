/* SPDX-License-Identifier: MIT */
/*
 * Pixels of a line, one in each column or, of a steep line, in each row: written by the pipelines'
 * body. Internal.
 *
 * The options are those of triangles in one colour (QTRI_FLAT), which each pixel sets; with shares
 * of the material's colour those of QTRI_LIGHT, where that has a table.
 */
#ifndef QTRI_RASTER_LINE_RUN_H
#define QTRI_RASTER_LINE_RUN_H

#include "qtri/body/small.h"

/*
 * Where a line is across its longer axis: at floor((minor + (along + 256 k) delta / length) / 256)
 * in the column (row) of its pixel k, a quotient and a remainder, as in dda.h. Kept is the
 * remainder less its denominator, below 0.
 */
typedef struct qtri_line_walk {
    int32_t k;     /* the pixel of the path */
    int32_t minor; /* where it is */
    int32_t slope; /* -1, 0 or 1 a pixel, and 1 more where the remainder runs over */
    int32_t rest, rest_step;
    uint32_t denominator; /* <= 2^31 */
} qtri_line_walk;

/* A value along the line, from one pixel to the next: modulo 2^32. */
typedef struct qtri_line_ramp {
    uint32_t value, step;
} qtri_line_ramp;

/* Pixels of a line that lie inside the state's bounds; along its longer axis they follow each
   other. */
typedef struct qtri_line_run {
    const qtri_draw_state *state;
    int32_t x, y, count; /* the first pixel; count > 0 */
    bool is_steep;
    bool is_lit;  /* color[0] is light, 8.16, of the state's table */
    bool is_even; /* one colour */
    qtri_line_walk walk;
    qtri_line_ramp z;        /* 16.16 */
    qtri_line_ramp color[3]; /* red, green, blue, or luma, n.16 of their kind with the half that
                                rounds */
} qtri_line_run;

/* What draws runs, by the draw state's options. */
extern const qtri_pipeline *const qtri_line_pipelines[];
extern const qtri_pipeline qtri_line_any; /* its last: by options that are read for each pixel */

QTRI_BODY uint32_t qtri_line_run_color(const qtri_options *o, const qtri_surface *surface,
                                       const qtri_line_ramp color[3])
{
    const uint32_t c = color[0].value >> 16;
    const uint32_t g = color[1].value >> 16;
    const uint32_t b = color[2].value >> 16;
    const qtri_color_kind kind = qtri_kind_of(o);
    const uint32_t word = kind == QTRI_IN_GRAY  ? c
                          : kind == QTRI_IN_565 ? c << 11 | g << 5 | b
                                                : c << 16 | g << 8 | b;
    return qtri_is_plain(o) ? qtri_encode(o, surface, word) : word;
}

QTRI_BODY void qtri_line_run_draw(const qtri_options *o, const qtri_line_run *run)
{
    const bool paired = qtri_is_paired(o); /* a row of pixels has the bytes of a row of depths */
    const qtri_draw_state *state = run->state;
    const qtri_surface *surface = state->surface;
    const ptrdiff_t bytes = (ptrdiff_t)qtri_pixel_bytes(o);
    const ptrdiff_t depth_bytes = (ptrdiff_t)qtri_depth_size(o, surface);
    const ptrdiff_t row = run->y - surface->first_row;
    const bool is_steep = run->is_steep, is_even = run->is_even;
    const int32_t slope = run->walk.slope, rest_step = run->walk.rest_step;
    const ptrdiff_t across = is_steep ? bytes : surface->pitch;
    const ptrdiff_t along = (is_steep ? surface->pitch : bytes) + slope * across;
    const ptrdiff_t depth_across = is_steep ? depth_bytes : state->depth_pitch;
    const ptrdiff_t depth_along =
        (is_steep ? state->depth_pitch : depth_bytes) + slope * depth_across;
    const uint32_t denominator = run->walk.denominator;
    int32_t rest = run->walk.rest, count = run->count;
    qtri_line_ramp color[3] = {run->color[0]};
    qtri_pixel_walk w = QTRI_BODY_ZERO;
    qtri_walk_begin(o, &w, state);
    if (!paired) {
        w.pixel = surface->pixels + row * surface->pitch + run->x * bytes;
    }
    if (qtri_tests_depth(o)) {
        w.depth =
            (uint8_t *)(void *)surface->depth + row * state->depth_pitch + run->x * depth_bytes;
        w.apart = (uintptr_t)surface->pixels - (uintptr_t)surface->depth;
    }
    w.x = run->x;
    w.y = run->y;
    w.z = run->z.value + QTRI_DEPTH_HALF;
    w.z_step = run->z.step;
    if (qtri_is_lit(o)) {
        w.c = color[0].value + qtri_light_half(o);
        w.c_step = color[0].step;
    } else {
        color[1] = run->color[1];
        color[2] = run->color[2];
        w.color = qtri_line_run_color(o, surface, color);
    }
    QTRI_BODY_BARRIER(count);
    do {
        if (o->fog) {
            w.fog = qtri_fog_share(state->fog, w.z);
        }
        qtri_pixel_at(o, &w, false, paired ? qtri_small_pixel_of(&w) : w.pixel, w.depth);
        if (!paired) {
            w.pixel += along;
        }
        if (qtri_tests_depth(o)) {
            w.depth += depth_along;
        }
        if (qtri_needs_place(o)) { /* it was stepped along a row */
            w.x += is_steep ? slope - 1 : 0;
            w.y += is_steep ? 1 : slope;
        }
        rest += rest_step; /* < 0 and < 2^31 */
        if (rest >= 0) {
            rest = (int32_t)((uint32_t)rest - denominator);
            if (!paired) {
                w.pixel += across;
            }
            if (qtri_tests_depth(o)) {
                w.depth += depth_across;
            }
            if (qtri_needs_place(o)) {
                w.x += is_steep;
                w.y += !is_steep;
            }
        }
        if (!qtri_is_lit(o) && !is_even) {
            for (int i = 0; i < 3; i++) {
                color[i].value += color[i].step;
            }
            w.color = qtri_line_run_color(o, surface, color);
        }
    } while (--count != 0);
}

#endif
