/* SPDX-License-Identifier: MIT */
/*
 * From the ends of a line to its pixels. Internal: what a short one needs, in place.
 */
#ifndef QTRI_RASTER_LINE_PATH_H
#define QTRI_RASTER_LINE_PATH_H

#include "divider.h"
#include "line.h"
#include "line_run.h"

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
    bool steep;                      /* the major axis is y */
    int32_t minor;                   /* of the first end, 1/256 pixel */
    int32_t length, delta;           /* to the last: 0 <= |delta| <= length <= 2^23 */
    int32_t along;                   /* 0..255, and below length where there is a pixel */
    int32_t position;                /* of pixel 0 on the major axis */
    int32_t count;                   /* may be negative */
} qtri_line_path;

QTRI_INLINE void qtri_line_path_init(qtri_line_path *l, const qtri_vertex *a, const qtri_vertex *b)
{
    int32_t major = a->at.x_24p8;
    int32_t minor = a->at.y_24p8;
    int32_t length = b->at.x_24p8 - major;
    int32_t delta = b->at.y_24p8 - minor;
    bool steep = false;
    if (qtri_magnitude32(delta) > qtri_magnitude32(length)) {
        int32_t x = major;
        int32_t width = length;
        major = minor;
        length = delta;
        minor = x;
        delta = width;
        steep = true;
    }
    l->first = a;
    l->last = b;
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

/* To pixel 0 of a short line: one of a single chunk, length < 2^15 + 2^8. */
QTRI_INLINE void qtri_line_walk_short(qtri_line_walk *w, const qtri_line_path *l)
{
    const int32_t denominator = l->length * 256;
    /*
     * From minor's pixel to where the line is at pixel 0, times length. As 0 <= along < 256 and
     * |delta| <= length, the slope moves it by less than a pixel.
     */
    int32_t rest = (l->minor & 255) * l->length + l->along * l->delta; /* |.| < 2^9 2^15 */
    w->k = 0;
    w->minor = l->minor >> 8;
    w->rest_step = l->delta * 256;
    w->slope = 0;
    if (l->delta < 0) {
        w->slope = -1;
        w->rest_step += denominator;
        if (rest < 0) {
            rest += denominator;
            w->minor--;
        }
    } else if (rest >= denominator) {
        rest -= denominator;
        w->minor++;
    }
    w->rest = rest - denominator;
    w->denominator = (uint32_t)denominator;
}

static inline void qtri_line_walk_next(qtri_line_walk *w)
{
    w->k++;
    w->minor += w->slope;
    w->rest += w->rest_step; /* < 0 and < 2^31 */
    if (w->rest >= 0) {
        w->rest = (int32_t)((uint32_t)w->rest - w->denominator);
        w->minor++;
    }
}

/* Whether both ends are. */
QTRI_INLINE bool qtri_line_is_inside(const qtri_line_job *job, const qtri_vertex *a,
                                     const qtri_vertex *b)
{
    return (uint32_t)(a->at.x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(b->at.x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(a->at.y_24p8 - job->top_24p8) < job->height_24p8 &&
           (uint32_t)(b->at.y_24p8 - job->top_24p8) < job->height_24p8;
}

/* Pixels begin..end - 1 of a path are inside along the major axis, these on the minor one. */
typedef struct qtri_line_limits {
    int32_t begin, end;
    int32_t minor;
    uint32_t minor_count;
} qtri_line_limits;

void qtri_line_limits_init(qtri_line_limits *in, const qtri_line_job *job, const qtri_line_path *l);

/* Moves w to the first pixel inside; returns the end of those that are, at most `end`. */
int32_t qtri_line_walk_cut(qtri_line_walk *w, const qtri_line_limits *in, int32_t end);

/* Moves w to the first pixel inside of a short line; returns the end of those that are. */
int32_t qtri_line_cut_short(qtri_line_walk *w, const qtri_line_job *job, const qtri_line_path *l);

/* From a line's ends, at pixel 0, `along` from the first; `by`: its length. */
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
 * Light of two lit ends, 8.16, at pixel 0. What a step cuts off is less than 2^-22, and what the
 * first pixel lacks less than a step: along < length, so that their product is below 2^30.
 */
QTRI_INLINE void qtri_line_ramp_light(qtri_line_ramp *r, const qtri_line_path *l,
                                      const qtri_divider *by)
{
    const int32_t from = (int32_t)((uint32_t)l->first->intensity_q15 << 7);
    const int32_t to = (int32_t)((uint32_t)l->last->intensity_q15 << 7);
    const int32_t step = qtri_divide((to - from) * 256, by);
    r->value = (uint32_t)(from + ((step * l->along) >> 8)) << 2;
    r->step = (uint32_t)step << 2;
}

/* Depth of an end, 0..65535.0 in 16.15: differences fit 32 bits. */
QTRI_INLINE int32_t qtri_line_depth(const qtri_line_job *job, const qtri_vertex *end)
{
    return (int32_t)((end->depth_16p8 & job->depth_mask) >> 1);
}

/*
 * The pixels of the walk, up to `end`, of the chunk of a line that begins at pixel `start`, where
 * depth is 16.15 and with colours set.
 */
QTRI_INLINE void qtri_line_run_place(qtri_line_run *run, const qtri_line_job *job,
                                     const qtri_line_path *l, int32_t end, int32_t start)
{
    const int32_t along = l->position + run->walk.k;
    const uint32_t number = (uint32_t)(run->walk.k - start);
    run->state = &job->to->state;
    run->is_steep = l->steep;
    run->x = l->steep ? run->walk.minor : along;
    run->y = l->steep ? along : run->walk.minor;
    run->count = end - run->walk.k;
    run->z.step *= 2;
    run->z.value = 2 * run->z.value + number * run->z.step;
    run->color[0].value += number * run->color[0].step;
    if (!run->is_lit) {
        run->color[1].value += number * run->color[1].step;
        run->color[2].value += number * run->color[2].step;
    }
}

#endif
