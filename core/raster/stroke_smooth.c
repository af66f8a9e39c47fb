/* SPDX-License-Identifier: MIT */
/*
 * Smooth edges: the area of each pixel that the union of the parts covers.
 *
 * A row is cut at the levels where a bound of a part bends, or where two of them cross: in such a
 * slice each part lies between two straight sides, and parts that overlap are one span. What the
 * sides of spans cover is exact but for the chords of arcs and the rounding to 1/256.
 */
#include "stroke.h"

/* The columns between two sides of a slice, 24.8 at its upper and at its lower level. */
typedef struct span {
    int32_t left[2], right[2];
    int32_t left_sum, right_sum; /* of both levels: twice the middle */
} span;

/* A slice's spans are disjoint and sorted. Windows with more parts are a few columns wide. */
enum { SPANS = 8 };

typedef struct spans {
    span of[SPANS];
    int count;
    int32_t min_x, max_x; /* of all slices of the row */
} spans;

/* The union of two spans: of their sides, those further out at the middle. */
static inline void widen(span *s, const span *by)
{
    if (by->left_sum < s->left_sum) {
        s->left[0] = by->left[0];
        s->left[1] = by->left[1];
        s->left_sum = by->left_sum;
    }
    if (by->right_sum > s->right_sum) {
        s->right[0] = by->right[0];
        s->right[1] = by->right[1];
        s->right_sum = by->right_sum;
    }
}

/*
 * The level at which two sides cross in a slice from 0 to `height`. All of it serves where the
 * triangle that is missed, at most the smaller distance times half of the height, and half of that,
 * is below 1/128 of a pixel.
 */
QTRI_NOINLINE static int32_t crossing(const int32_t a[2], const int32_t b[2], int32_t height)
{
    uint32_t d0 = qtri_magnitude32(a[0] - b[0]), d1 = qtri_magnitude32(a[1] - b[1]);
    if ((d0 < d1 ? d0 : d1) * (uint32_t)height <= 2048) { /* < 2^24 2^8 */
        return height;
    }
    d0 >>= 3; /* < 2^22: the sum times 2^8 fits */
    d1 >>= 3;
    const int32_t at = (int32_t)(d0 * (uint32_t)height / (d0 + d1 + 1));
    return qtri_hold32(at, 1, height - 1);
}

/* The height of the slice's upper part in which the sides a and b do not cross. */
QTRI_INLINE int32_t height_to_crossing(const int32_t a[2], const int32_t b[2], int32_t height)
{
    return ((a[0] - b[0]) ^ (a[1] - b[1])) >= 0 ? height
                                                : qtri_least32(height, crossing(a, b, height));
}

/* The height of the slice's upper part in which a span's sides cross none of the others. */
static int32_t height_to_crossings(const spans *all, const span *more, int32_t height)
{
    for (int i = 0; i < all->count; i++) {
        const span *other = &all->of[i];
        if (((other->right[0] - more->left[0]) & (other->right[1] - more->left[1])) < 0 ||
            ((more->right[0] - other->left[0]) & (more->right[1] - other->left[1])) < 0) {
            continue; /* one lies left of the other */
        }
        height = height_to_crossing(other->left, more->left, height);
        height = height_to_crossing(other->right, more->right, height);
        height = height_to_crossing(other->left, more->right, height);
        height = height_to_crossing(other->right, more->left, height);
    }
    return height;
}

/*
 * Adds a span: those that it touches become one with it. Where there is no room it is taken
 * together with the one before it, in a slice of which more than eight separate parts lie in a few
 * columns.
 */
static void add_span(spans *all, const span *more)
{
    int at = 0;
    while (at < all->count && all->of[at].right_sum < more->left_sum) {
        at++;
    }
    if (at == all->count || all->of[at].left_sum > more->right_sum) { /* it touches none */
        if (all->count < SPANS) {
            for (int i = all->count++; i > at; i--) {
                all->of[i] = all->of[i - 1];
            }
            all->of[at] = *more;
            return;
        }
        at -= at > 0;
    }
    span *s = &all->of[at];
    int end = at + 1;
    widen(s, more);
    for (; end < all->count && all->of[end].left_sum <= s->right_sum; end++) {
        widen(s, &all->of[end]);
    }
    if (end > at + 1) {
        for (int i = end; i < all->count; i++) {
            all->of[at + 1 + i - end] = all->of[i];
        }
        all->count -= end - at - 1;
    }
}

/* The next level below y, at most `bottom`, where a bound of a part bends. */
static inline int32_t slice_end(qtri_stroke_shape *s, int32_t y, int32_t bottom)
{
    bottom = qtri_least32(bottom, qtri_stroke_shape_piece(s, 0, y)->bottom);
    return qtri_least32(bottom, qtri_stroke_shape_piece(s, 1, y)->bottom);
}

/* The next level below y where a part begins, ends, or bends. */
static int32_t next_level(qtri_stroker *stroker, int32_t y, int32_t bottom)
{
    uint32_t count = 0;
    for (qtri_stroke_shape *s = NULL; (s = qtri_stroker_next(stroker, s, &count)) != NULL;) {
        if (s->top > y) {
            bottom = qtri_least32(bottom, s->top);
        } else if (s->bottom > y) {
            bottom = slice_end(s, y, bottom);
        }
    }
    return bottom;
}

/* A part's span from level y0 to y1, where it has straight pieces; false: it has no column of the
   window. */
QTRI_INLINE bool set_span(span *out, spans *all, qtri_stroke_shape *s, const qtri_coverage *c,
                          int32_t y0, int32_t y1)
{
    const qtri_stroke_piece *left = &s->piece[0], *right = &s->piece[1];
    out->left[0] = qtri_stroke_piece_x(left, y0);
    out->left[1] = qtri_stroke_piece_x(left, y1);
    out->right[0] = qtri_stroke_piece_x(right, y0);
    out->right[1] = qtri_stroke_piece_x(right, y1);
    out->left_sum = out->left[0] + out->left[1];
    out->right_sum = out->right[0] + out->right[1];
    const int32_t min = qtri_least32(out->left[0], out->left[1]);
    const int32_t max = qtri_greatest32(out->right[0], out->right[1]);
    s->min_x = qtri_least32(s->min_x, min);
    s->max_x = qtri_greatest32(s->max_x, max);
    if (min >= c->end * 256 || max <= c->x * 256) {
        return false;
    }
    all->min_x = qtri_least32(all->min_x, min);
    all->max_x = qtri_greatest32(all->max_x, max);
    return true;
}

/* The spans of the slice from y0 to y1; returns where it ends, earlier where sides cross. */
static int32_t find_spans(spans *all, qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    uint32_t count = 0;
    all->count = 0;
    for (qtri_stroke_shape *s = NULL; (s = qtri_stroker_next(stroker, s, &count)) != NULL;) {
        span more;
        if (s->top > y0 || s->bottom <= y0) {
            continue;
        }
        if (!stroker->window.is_complete) {
            (void)slice_end(s, y0, y1); /* another shape may have replaced it since next_level() */
        }
        if (!set_span(&more, all, s, &stroker->window.coverage, y0, y1)) {
            continue;
        }
        const int32_t height = height_to_crossings(all, &more, y1 - y0);
        if (height < y1 - y0) {
            y1 = y0 + height; /* sides differ in a lower slice: start again */
            all->count = 0;
            count = 0;
            s = NULL;
            continue;
        }
        add_span(all, &more);
    }
    return y1;
}

/* Adds a span from y0 to y1 below the row's upper side. */
static inline void cover_span(qtri_coverage *c, const span *s, int32_t y0, int32_t y1)
{
    qtri_coverage_add(c, s->left[0], y0, s->left[1], y1, 1);
    qtri_coverage_add(c, s->right[0], y0, s->right[1], y1, -1);
}

/* A row that has one part: slice by slice, without a union. */
static void cover_one(spans *all, qtri_stroke_window *w, qtri_stroke_shape *s)
{
    const int32_t row = w->row * 256;
    const int32_t bottom = qtri_least32(s->bottom, row + 256);
    for (int32_t y = qtri_greatest32(s->top, row); y < bottom;) {
        span one;
        const int32_t to = slice_end(s, y, bottom);
        if (set_span(&one, all, s, &w->coverage, y, to)) {
            cover_span(&w->coverage, &one, y - row, to - row);
        }
        y = to;
    }
}

static void cover(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    const int32_t row = w->row * 256;
    spans all;
    all.min_x = INT32_MAX;
    all.max_x = INT32_MIN;
    if (w->is_complete && w->shape_count == 1) {
        cover_one(&all, w, w->shape[0]);
    } else {
        for (int32_t y = row; y < row + 256;) {
            const int32_t to = find_spans(&all, stroker, y, next_level(stroker, y, row + 256));
            for (const span *s = all.of; s != &all.of[all.count]; s++) {
                cover_span(&w->coverage, s, y - row, to - row);
            }
            y = to;
        }
    }
    if (all.min_x < all.max_x) {
        qtri_stroke_window_add(w, all.min_x, all.max_x);
    }
}

const qtri_stroke_edges qtri_stroke_smooth = {
    .set_ring = qtri_stroke_ring_init,
    .cover = cover,
    .cover_point = qtri_stroke_point_cover,
    .line = qtri_stroke_line_draw,
};

/* ---- The stroke of an application that has chosen nothing ---- */

/*
 * The constant has a name because it holds an address: in a file of the whole library, a linker
 * that keeps one constant without a name keeps them all, and here the smooth edges with them.
 */
static const qtri_stroke smooth_line = {
    .width = Q16_ONE,
    .cap = QTRI_CAP_ROUND,
    .edges = &qtri_stroke_smooth,
    .alpha = 255,
    .closed = false,
    .in_space = false,
};

qtri_stroke qtri_stroke_default(void)
{
    return smooth_line;
}
