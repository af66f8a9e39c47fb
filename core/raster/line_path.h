/* SPDX-License-Identifier: MIT */
/*
 * Lines one pixel wide: one pixel in each column or, of a steep line, in each row. From their ends
 * to runs of pixels, which the pipelines' body draws. Internal.
 *
 * The options are those of triangles in one colour (QTRI_FLAT), which each pixel sets; with shares
 * of the material's colour those of QTRI_LIGHT, where that has a table.
 */
#ifndef QTRI_RASTER_LINE_PATH_H
#define QTRI_RASTER_LINE_PATH_H

#include "qtri/body/small.h"

#include "dda.h"
#include "divider.h"
#include "line.h"

/* Where a line is across its longer axis in the column (row) of its pixel k. */
typedef struct qtri_line_walk {
    int32_t k;
    qtri_dda minor; /* its step is -1, 0 or 1 */
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
    bool is_lit;        /* color[0] is light, 8.16, of the state's table */
    bool has_one_color; /* one colour */
    qtri_line_walk walk;
    qtri_line_ramp z;        /* 16.16 */
    qtri_line_ramp color[3]; /* red, green, blue, or luma, n.16 of their kind with the half that
                                rounds */
} qtri_line_run;

/* Pipelines that draw lines. */
extern const qtri_pipeline *const qtri_line_pipelines[];
extern const qtri_pipeline qtri_line_any; /* the last: generic */

QTRI_BODY uint32_t qtri_line_run_color(const qtri_options *o, const qtri_surface *surface,
                                       const qtri_line_ramp color[3])
{
    const uint32_t c = color[0].value >> 16, g = color[1].value >> 16, b = color[2].value >> 16;
    const qtri_color_kind kind = qtri_kind_of(o);
    const uint32_t word = kind == QTRI_IN_GRAY  ? c
                          : kind == QTRI_IN_565 ? c << 11 | g << 5 | b
                                                : c << 16 | g << 8 | b;
    return qtri_has_constant_color(o) ? qtri_encode(o, surface, word) : word;
}

QTRI_BODY void qtri_line_run_draw(const qtri_options *o, const qtri_line_run *run)
{
    const bool paired = qtri_is_paired(o); /* a row of pixels has the bytes of a row of depths */
    const qtri_draw_state *state = run->state;
    const qtri_surface *surface = state->surface;
    const ptrdiff_t bytes = (ptrdiff_t)qtri_pixel_bytes(o);
    const ptrdiff_t depth_bytes = (ptrdiff_t)qtri_depth_size(o, surface);
    const ptrdiff_t row = run->y - surface->first_row;
    const bool is_steep = run->is_steep, has_one_color = run->has_one_color;
    const int32_t slope = run->walk.minor.step;
    const int32_t rest_step = (int32_t)run->walk.minor.remainder_step;
    const ptrdiff_t across = is_steep ? bytes : surface->pitch;
    const ptrdiff_t along = (is_steep ? surface->pitch : bytes) + slope * across;
    const ptrdiff_t depth_across = is_steep ? depth_bytes : state->depth_pitch;
    const ptrdiff_t depth_along =
        (is_steep ? state->depth_pitch : depth_bytes) + slope * depth_across;
    const uint32_t denominator = run->walk.minor.denominator;
    int32_t rest = (int32_t)(run->walk.minor.remainder - denominator); /* < 0: its sign tells */
    int32_t count = run->count;
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
        rest += rest_step; /* < 2^31 */
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
        if (!qtri_is_lit(o) && !has_one_color) {
            for (int i = 0; i < 3; i++) {
                color[i].value += color[i].step;
            }
            w.color = qtri_line_run_color(o, surface, color);
        }
    } while (--count != 0);
}

/*
 * Colours and depths are ramps of 32 bits from pixel to pixel. Their steps are cut off to 2^-16
 * (depth: 2^-15, light: 2^-22) and so lag by 128 of that at most after 128 pixels: longer lines
 * start anew every QTRI_LINE_CHUNK pixels, counted from their first one, whatever a scissor or a
 * band cuts off. Values lie between those of the ends and need no clamps.
 */
enum { QTRI_LINE_CHUNK = 128 };

/*
 * A line along its major axis: x when it is at least as wide as high. Pixel k, k = 0, 1, ..., is
 * where it passes the k-th centre on that axis: along + 256 k from the first end.
 */
typedef struct qtri_line_path {
    const qtri_vertex *first, *last; /* by increasing major coordinate */
    bool turned;                     /* `first` is b */
    bool steep;                      /* the major axis is y */
    int32_t minor;                   /* of the first end, 1/256 pixel */
    int32_t length, delta;           /* to the last: 0 <= |delta| <= length <= 2^23 */
    int32_t along;                   /* 0..255, and below length where there is a pixel */
    int32_t position;                /* of pixel 0 on the major axis */
    int32_t count;                   /* may be negative */
} qtri_line_path;

QTRI_INLINE void qtri_line_path_init(qtri_line_path *l, const qtri_vertex *a, const qtri_vertex *b)
{
    int32_t major = a->at.x_24p8, minor = a->at.y_24p8;
    int32_t length = b->at.x_24p8 - major, delta = b->at.y_24p8 - minor;
    bool steep = false;
    if (qtri_magnitude32(delta) > qtri_magnitude32(length)) {
        int32_t x = major, width = length;
        major = minor;
        length = delta;
        minor = x;
        delta = width;
        steep = true;
    }
    l->first = a;
    l->last = b;
    l->turned = length < 0;
    if (length < 0) {
        major += length;
        minor += delta;
        length = -length;
        delta = -delta;
        l->first = b;
        l->last = a;
    }
    l->steep = steep;
    l->minor = minor;
    l->length = length;
    l->delta = delta;
    /* Centres in [start, end): ceil((start - 128) / 256) is the first. */
    l->position = (major + 127) >> 8;
    l->along = (128 - major) & 255;
    l->count = ((major + length + 127) >> 8) - l->position;
}

/* Sets a walk to pixel 0 of a short line: of a single chunk, length < 2^15 + 2^8. */
QTRI_INLINE void qtri_line_walk_short(qtri_line_walk *w, const qtri_line_path *l)
{
    const int32_t denominator = l->length * 256;
    /*
     * From minor's pixel to where the line is at pixel 0, times length. As 0 <= along < 256 and
     * |delta| <= length, the slope moves it by less than a pixel.
     */
    int32_t remainder = (l->minor & 255) * l->length + l->along * l->delta; /* |.| < 2^9 2^15 */
    int32_t remainder_step = l->delta * 256;
    w->k = 0;
    w->minor.value = l->minor >> 8;
    w->minor.step = 0;
    if (l->delta < 0) {
        w->minor.step = -1;
        remainder_step += denominator;
        if (remainder < 0) {
            remainder += denominator;
            w->minor.value--;
        }
    } else if (remainder >= denominator) {
        remainder -= denominator;
        w->minor.value++;
    }
    w->minor.remainder = (uint32_t)remainder;
    w->minor.remainder_step = (uint32_t)remainder_step;
    w->minor.denominator = (uint32_t)denominator;
}

/* Whether both ends are inside the bounds. */
QTRI_INLINE bool qtri_line_is_inside(const qtri_line_job *job, const qtri_line_path *l)
{
    return (uint32_t)(l->first->at.x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(l->last->at.x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(l->first->at.y_24p8 - job->top_24p8) < job->height_24p8 &&
           (uint32_t)(l->last->at.y_24p8 - job->top_24p8) < job->height_24p8;
}

/* Moves w to the first pixel inside of a short line; returns how many follow that are. */
int32_t qtri_line_clip_short(qtri_line_walk *w, const qtri_line_job *job, const qtri_line_path *l);

/* A ramp between values of a short line's ends, at pixel 0, `along` from the first; `by`: length.
 */
QTRI_INLINE void qtri_line_ramp_short(qtri_line_ramp *r, int32_t from, int32_t to, int32_t along,
                                      const qtri_divider *by)
{
    const uint32_t small = (uint32_t)1 << 22;
    int32_t rest = to - from;
    int32_t quotient = 0;
    if (QTRI_DIVIDE || (uint32_t)rest + small >= 2 * small) { /* else the others serve alone */
        quotient = qtri_divide(rest, by);
        rest -= quotient * (int32_t)by->divisor;
    }
    r->value = (uint32_t)(from + quotient * along + qtri_divide(rest * along, by));
    r->step = (uint32_t)quotient * 256u + (uint32_t)qtri_divide(rest * 256, by);
}

/*
 * Light of two lit ends, 8.16, from pixel 0. What a step cuts off is less than 2^-22, and what the
 * first pixel lacks less than a step: along < length, so that their product is below 2^30.
 */
QTRI_INLINE void qtri_line_run_light(qtri_line_run *run, const qtri_line_path *l,
                                     const qtri_divider *by)
{
    const int32_t from = (int32_t)((uint32_t)l->first->intensity_q15 << 7);
    const int32_t to = (int32_t)((uint32_t)l->last->intensity_q15 << 7);
    const int32_t step = qtri_divide((to - from) * 256, by);
    run->color[0].value = (uint32_t)(from + ((step * l->along) >> 8)) << 2;
    run->color[0].step = (uint32_t)step << 2;
    run->is_lit = run->has_one_color = true;
}

/* Depth of an end, 0..65535.0 in 16.15: differences fit 32 bits. */
QTRI_INLINE int32_t qtri_line_depth(const qtri_line_job *job, const qtri_vertex *end)
{
    return (int32_t)((end->depth_16p8 & job->depth_mask) >> 1);
}

/* Sets the divider of a short line's ramps, and run->z, 0 without depth. */
QTRI_INLINE void qtri_line_run_depth(qtri_line_run *run, qtri_divider *by, const qtri_line_job *job,
                                     const qtri_line_path *l, bool has_depth)
{
    qtri_divider_init_short(by, (uint32_t)l->length);
    run->z.value = run->z.step = 0;
    if (has_depth) {
        qtri_line_ramp_short(&run->z, qtri_line_depth(job, l->first), qtri_line_depth(job, l->last),
                             l->along, by);
    }
}

/*
 * Sets position and start values of a run from its walk; depth, 16.15, and colours are set for
 * pixel `start`, with which the chunk begins.
 */
QTRI_INLINE void qtri_line_run_place(qtri_line_run *run, const qtri_line_job *job,
                                     const qtri_line_path *l, int32_t start)
{
    const int32_t along = l->position + run->walk.k;
    const uint32_t number = (uint32_t)(run->walk.k - start);
    run->state = &job->to->state;
    run->is_steep = l->steep;
    run->x = l->steep ? run->walk.minor.value : along;
    run->y = l->steep ? along : run->walk.minor.value;
    run->z.step *= 2;
    run->z.value = 2 * run->z.value + number * run->z.step;
    run->color[0].value += number * run->color[0].step;
    if (!run->is_lit) {
        run->color[1].value += number * run->color[1].step;
        run->color[2].value += number * run->color[2].step;
    }
}

#endif
