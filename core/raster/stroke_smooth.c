/* SPDX-License-Identifier: MIT */
/*
 * Smooth edges: the area of each pixel that the union of the parts covers.
 *
 * The row is cut at levels into slices: where bounds turn, and arcs so often that their chords
 * serve (stroke_shape.h). In a slice each part lies between two sides that are taken as straight;
 * the parts that overlap at its middle are one. Of one part areas are exact, but for the chords.
 * Where sides of two parts cross in a slice, the one that is further out at its middle serves for
 * all of it: that misses a triangle of half its height, and if that may be more than 1/128 of a
 * pixel the slice is cut into four, down to 1/16 of a row.
 */
#include "stroke.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "stroke_line.h"

enum { SPANS = 12, LEAST_HEIGHT = 16 };

/* The bounds of a shape at the levels of a slice. */
typedef struct slice_bounds {
    int32_t left[2], right[2];
} slice_bounds;

/* Parts of a slice that are one. */
typedef struct span {
    int32_t left[2], right[2];
} span;

typedef struct spans {
    span of[SPANS];
    int count;
} spans;

static int32_t middle(const int32_t at[2])
{
    return (at[0] >> 1) + (at[1] >> 1);
}

/* Takes the side that is further out at the middle; `sign` 1: to the right, -1: to the left. */
static void widen(int32_t side[2], const int32_t by[2], int32_t sign)
{
    if ((middle(by) - middle(side)) * sign > 0) {
        side[0] = by[0];
        side[1] = by[1];
    }
}

/*
 * Whether sides cross so far that it matters: the smaller of both distances, times half of the
 * height and half of that.
 */
static bool cross(const int32_t a[2], const int32_t b[2], int32_t height)
{
    const int32_t from = a[0] - b[0];
    const int32_t to = a[1] - b[1];
    if ((from ^ to) >= 0) {
        return false;
    }
    const int32_t least =
        qtri_least32((int32_t)qtri_magnitude32(from), (int32_t)qtri_magnitude32(to));
    return least > 2048 / height;
}

QTRI_NOINLINE static bool crosses_any(const spans *all, const slice_bounds *more, int32_t height)
{
    for (int i = 0; i < all->count; i++) {
        const span *other = &all->of[i];
        if (cross(other->left, more->left, height) || cross(other->right, more->right, height) ||
            cross(other->left, more->right, height) || cross(other->right, more->left, height)) {
            return true;
        }
    }
    return false;
}

/*
 * Adds one to the disjoint spans, which are sorted: those that it touches become one with it. Where
 * there is no room it is taken together with the one before it, a slice of which more than twelve
 * separate parts lie in one strip.
 */
static void add_span(spans *all, const slice_bounds *slice)
{
    span more = {{slice->left[0], slice->left[1]}, {slice->right[0], slice->right[1]}};
    if (all->count == 0) {
        all->of[0] = more;
        all->count = 1;
        return;
    }
    int first = 0;
    while (first < all->count && middle(all->of[first].right) < middle(more.left)) {
        first++;
    }
    int end = first;
    while (end < all->count && middle(all->of[end].left) <= middle(more.right)) {
        widen(more.left, all->of[end].left, -1);
        widen(more.right, all->of[end].right, 1);
        end++;
    }
    if (end == first && all->count == SPANS) {
        first = first > 0 ? first - 1 : 0;
        end = first + 1;
        widen(more.left, all->of[first].left, -1);
        widen(more.right, all->of[first].right, 1);
    }
    const int moved = first + 1 - end; /* 1 where there is one more */
    if (moved > 0) {
        for (int i = all->count; i > first; i--) {
            all->of[i] = all->of[i - 1];
        }
    } else if (moved < 0) {
        for (int i = first + 1; i - moved < all->count; i++) {
            all->of[i] = all->of[i - moved];
        }
    }
    all->count += moved;
    all->of[first] = more;
}

/*
 * Adds the area to the right of a side that moves from `x0` to `x1`, in 1/256 behind the first
 * column, while `height` (1/256, signed) goes by. The sum of all sums up to a pixel is then what
 * its area has, in 1/512 by 1/256 pixel; it is the same whatever the first column is.
 */
static void add_side(qtri_stroker *stroker, int32_t x0, int32_t x1, int32_t height)
{
    int32_t *cover = stroker->cover;
    const int32_t end = (stroker->end - stroker->first) * 256;
    x0 -= stroker->first * 256;
    x1 -= stroker->first * 256;
    if (x0 > x1) {
        const int32_t x = x0;
        x0 = x1;
        x1 = x;
    }
    if (x0 >= end) {
        return;
    }
    if (x1 <= 0) {
        cover[0] += height * 512;
        return;
    }
    /* Most sides stay in a column: without this a wireframe of strokes takes 15 to 19 % more. */
    const int32_t first = x0 >> 8;
    if (x0 >= 0 && x1 <= (first + 1) * 256) {
        const int32_t behind = height * (x0 + x1 - 512 * first);
        cover[first] += height * 512 - behind;
        cover[first + 1] += behind;
        return;
    }
    /* Of height, up to each column's side: height (x - x0) / (x1 - x0), rounded down. */
    const uint32_t width = (uint32_t)(x1 - x0);  /* < 2^25 */
    const int32_t zeros = qtri_clz32(width | 1); /* 7..31 */
    const uint32_t reciprocal = (uint32_t)qtri_reciprocal_below(width << zeros);
    const uint32_t size = qtri_magnitude32(height);
    int32_t x = x0;
    int32_t done = 0;
    if (x0 < 0) {
        x = 0;
        done = (int32_t)(qtri_mul_u32(size * (uint32_t)-x0, reciprocal) >> (62 - zeros));
        cover[0] += (height < 0 ? -done : done) * 512;
    }
    while (x < x1 && x < end) {
        const int32_t column = x >> 8;
        const int32_t to = qtri_least32((column + 1) * 256, x1);
        const int32_t upto =
            to == x1
                ? (int32_t)size
                : (int32_t)(qtri_mul_u32(size * (uint32_t)(to - x0), reciprocal) >> (62 - zeros));
        const int32_t part = height < 0 ? done - upto : upto - done;
        const int32_t behind = part * (x + to - 512 * column);
        cover[column] += part * 512 - behind;
        cover[column + 1] += behind;
        x = to;
        done = upto;
    }
}

/* What lies to the right of the left side and not of the right one. */
static void add_sides(qtri_stroker *stroker, const int32_t left[2], const int32_t right[2],
                      int32_t height)
{
    add_side(stroker, left[0], left[1], height);
    add_side(stroker, right[0], right[1], -height);
}

/* A side, as qtri_stroke_shape_x() has it. */
static inline void set_straight(int32_t x[2], const qtri_stroke_shape *s, int side, int32_t y0,
                                int32_t y1)
{
    const qtri_stroke_chain *chain = &s->chain[side];
    const int32_t slope = s->slope_q16;
    x[0] = chain->x + ((slope * (y0 - chain->y0) + 0x8000) >> 16);
    x[1] = chain->x + ((slope * (y1 - chain->y0) + 0x8000) >> 16);
}

/*
 * The bounds of a shape between two levels. False: it is not there. Slices follow each other: where
 * no bound turns, one begins as the last one ended.
 */
static bool find_slice(slice_bounds *slice, qtri_stroke_shape *s, int32_t y0, int32_t y1)
{
    if (s->top > y0 || s->bottom < y1) {
        return false;
    }
    if (s->is_short && qtri_stroke_shape_is_straight(s, y0, y1)) {
        set_straight(slice->left, s, 0, y0, y1);
        set_straight(slice->right, s, 1, y0, y1);
        return true;
    }
    const bool follows = s->last_level == y0;
    for (int side = 0; side < 2; side++) {
        const qtri_stroke_chain *chain = &s->chain[side];
        int32_t *x = side == 0 ? slice->left : slice->right;
        x[0] = follows && y0 != chain->y0 && y0 != chain->y1
                   ? s->last_x[side]
                   : qtri_stroke_shape_x(s, side, y0, true);
        x[1] = qtri_stroke_shape_x(s, side, y1, false);
        s->last_x[side] = x[1];
    }
    s->last_level = y1;
    return true;
}

static void add_alone(qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    slice_bounds slice;
    if (find_slice(&slice, stroker->own, y0, y1)) {
        add_sides(stroker, slice.left, slice.right, y1 - y0);
    }
}

/* The spans of the shapes in a slice. False: they cross, and are not all there. */
static bool find_spans(spans *all, qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    uint32_t at = 0;
    all->count = 0;
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &at)) != NULL;) {
        slice_bounds slice;
        if (!find_slice(&slice, s, y0, y1)) {
            continue;
        }
        if (y1 - y0 > LEAST_HEIGHT && crosses_any(all, &slice, y1 - y0)) {
            return false;
        }
        add_span(all, &slice);
    }
    return true;
}

/* Where sides cross, the slice is cut into four. */
static void add_group(qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    spans all;
    int32_t height = y1 - y0;
    for (int32_t from = y0; from < y1;) {
        const int32_t to = qtri_least32(from + height, y1);
        if (!find_spans(&all, stroker, from, to)) {
            height = qtri_greatest32((height + 3) >> 2, LEAST_HEIGHT);
            continue;
        }
        for (int i = 0; i < all.count; i++) {
            add_sides(stroker, all.of[i].left, all.of[i].right, to - from);
        }
        from = to;
    }
}

static void add_slice(qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    if (stroker->is_alone) {
        add_alone(stroker, y0, y1);
    } else {
        add_group(stroker, y0, y1);
    }
}

/* Slices from level to level, each where a bit is set. */
static void add_slices(qtri_stroker *stroker, const uint32_t levels[8])
{
    const int32_t top = stroker->row * 256;
    int32_t y = 0;
    for (int word = 0; word < 8; word++) {
        for (uint32_t bits = levels[word]; bits != 0; bits &= bits - 1) {
            const int32_t at = word * 32 + 31 - qtri_clz32(bits & (0 - bits)); /* the lowest */
            if (at > y) {
                add_slice(stroker, top + y, top + at);
                y = at;
            }
        }
    }
    add_slice(stroker, top + y, top + 256);
}

static void cover(qtri_stroker *stroker)
{
    const int32_t top = stroker->row * 256;
    const int32_t count = stroker->end - stroker->first;
    for (int32_t i = 0; i <= count; i++) {
        stroker->cover[i] = 0;
    }
    if (stroker->is_alone && qtri_stroke_shape_is_straight(stroker->own, top, top + 256)) {
        add_alone(stroker, top, top + 256);
    } else {
        uint32_t levels[8] = {0};
        uint32_t at = 0;
        for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &at)) != NULL;) {
            qtri_stroke_shape_mark(s, top, levels);
        }
        add_slices(stroker, levels);
    }
    int32_t sum = 0;
    for (int32_t i = 0; i < count; i++) {
        sum += stroker->cover[i];
        stroker->cover[i] = qtri_hold32(sum, 0, QTRI_STROKE_FULL);
    }
}

const qtri_stroke_edges qtri_stroke_smooth = {cover, qtri_stroke_point_draw, qtri_stroke_line_draw};
