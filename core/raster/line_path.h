/* SPDX-License-Identifier: MIT */
/*
 * A line's pixels and what lies between its ends. Internal: line.c draws any line by it, and
 * fast/line_16.c short ones.
 */
#ifndef QTRI_RASTER_LINE_PATH_H
#define QTRI_RASTER_LINE_PATH_H

#include "divider.h"
#include "line.h"

/*
 * Colours and depths are ramps of 32 bits from pixel to pixel. Their steps are cut off to 2^-16
 * (depth: 2^-15, shares of the tint: 2^-22) and so lag by 128 of that at most after 128 pixels:
 * longer lines start anew every QTRI_LINE_CHUNK pixels, counted from their first one, whatever a
 * scissor or a band cuts off. Values lie between those of the ends and need no clamps.
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
    int32_t step, step_minor;        /* of an address to the next pixel along, and across */
} qtri_line_path;

/* Addresses count in any unit: a column and a row are `step_x` and `step_y` of it. */
static inline void qtri_line_path_init(qtri_line_path *l, const qtri_vertex *a,
                                       const qtri_vertex *b, int32_t step_x, int32_t step_y)
{
    int32_t step = step_x;
    int32_t step_minor = step_y;
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
        step = step_y;
        step_minor = step_x;
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
    l->step = step;
    l->step_minor = step_minor;
    l->minor = minor;
    l->length = length;
    l->delta = delta;
    /* Centres in [start, end): ceil((start - 128) / 256) is the first. */
    l->position = (major + 127) >> 8;
    l->along = (128 - major) & 255;
    l->count = ((major + length + 127) >> 8) - l->position;
}

/*
 * On the minor axis the line is at floor((minor + (along + 256 k) delta / length) / 256): a
 * quotient and a remainder, as in dda.h. Kept is the remainder less its denominator, below 0.
 */
typedef struct qtri_line_walk {
    int32_t k;     /* the pixel of the path */
    int32_t minor; /* where it is */
    int32_t slope; /* -1, 0 or 1 a pixel, and 1 more where the remainder runs over */
    int32_t rest, rest_step;
    uint32_t denominator; /* <= 2^31 */
} qtri_line_walk;

/* To pixel 0 of a short line: one of a single chunk, length < 2^15 + 2^8. */
static inline void qtri_line_walk_short(qtri_line_walk *w, const qtri_line_path *l)
{
    const int32_t denominator = l->length * 256;
    /*
     * From minor's pixel to where the line is at pixel 0, times length. 0 <= along < 256 and
     * |delta|
     * <= length: the slope moves it by less than a pixel.
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
static inline bool qtri_line_is_inside(const qtri_line_job *job, const qtri_vertex *a,
                                       const qtri_vertex *b)
{
    return (uint32_t)(a->at.x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(b->at.x_24p8 - job->left_24p8) < job->width_24p8 &&
           (uint32_t)(a->at.y_24p8 - job->top_24p8) < job->height_24p8 &&
           (uint32_t)(b->at.y_24p8 - job->top_24p8) < job->height_24p8;
}

/* Moves w to the first pixel inside of a short line; returns the end of those that are. */
int32_t qtri_line_cut_short(qtri_line_walk *w, const qtri_line_job *job, const qtri_line_path *l);

/* A value along the line, from one pixel to the next: modulo 2^32, signed. */
typedef struct qtri_line_ramp {
    uint32_t value, step; /* a single pixel's step may exceed 32 bits */
} qtri_line_ramp;

/* From its ends, at pixel 0, `along` from the first; `by`: the line's length. */
static inline void qtri_line_ramp_init(qtri_line_ramp *r, int32_t from, int32_t to, int32_t along,
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

/* 0..65535.0: differences fit 32 bits. */
static inline int32_t qtri_line_depth_16p15(uint32_t mask, const qtri_vertex *end)
{
    return (int32_t)((end->depth_16p8 & mask) >> 1);
}

/* Added to depths, so that cutting off rounds. */
#define QTRI_LINE_DEPTH_HALF ((uint32_t)1 << 14)

/* A share of the tint in Q22, of a lit end. */
static inline int32_t qtri_line_share_q22(const qtri_vertex *end)
{
    return (int32_t)((uint32_t)end->intensity_q15 << 7);
}

/*
 * Of shares of the tint, at pixel 0. What a step cuts off is less than a unit, and what the first
 * pixel lacks less than a step: along < length, so that their product is below 2^30.
 */
static inline void qtri_line_ramp_share(qtri_line_ramp *r, const qtri_line_path *l,
                                        const qtri_divider *by)
{
    const int32_t from = qtri_line_share_q22(l->first);
    const int32_t step = qtri_divide((qtri_line_share_q22(l->last) - from) * 256, by);
    r->value = (uint32_t)(from + ((step * l->along) >> 8));
    r->step = (uint32_t)step;
}

/* What is cut off a share for its number in the table of tints, and the half that rounds. */
#define QTRI_LINE_TINT_SHIFT (22 - QTRI_TINT_BITS)
#define QTRI_LINE_TINT_HALF  ((uint32_t)1 << (QTRI_LINE_TINT_SHIFT - 1))

#endif
