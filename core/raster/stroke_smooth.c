/* SPDX-License-Identifier: MIT */
/*
 * Smooth edges: the area of each pixel that the union of the parts covers.
 *
 * The row is cut at levels into slices. In a slice each part lies between two sides that are taken
 * as straight; the parts that overlap at its middle are one. Where a group has one part, and none
 * of its discs, the levels are those at which its sides begin and end: areas are exact. Elsewhere
 * they are 3/32 of a row apart as well. What that neglects: the area between an arc and its chord,
 * h w / 6 at most for a slice of height h in which the arc moves by w; and where sides cross in a
 * slice, triangles of half its height. Where those are wider than a quarter of a pixel the slice is
 * cut into four. Tests find 1/40 of a pixel at most.
 */
#include "stroke.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "stroke_line.h"

enum { SPANS = 12 };

/* Levels 24 apart, where sides may be curved or cross: bits 0 24, 16, 8 of a word, and so on. */
static const uint32_t grid[8] = {0x01000001u, 0x00010000u, 0x00000100u, 0x01000001u,
                                 0x00010000u, 0x00000100u, 0x01000001u, 0x00010000u};

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
 * Sides that cross in a slice, a quarter of a pixel apart at both of its levels or more: half of
 * the height times half of that is what it misses if one of them counts in all of it.
 */
enum { FAR = 64 };

static bool cross(const int32_t a[2], const int32_t b[2])
{
    const int32_t from = a[0] - b[0];
    const int32_t to = a[1] - b[1];
    return (from > FAR && to < -FAR) || (from < -FAR && to > FAR);
}

/* Whether a side moves so far that it may cross one that does not, each FAR from the other. */
static bool moves_far(const qtri_stroke_slice *slice)
{
    const int32_t left = slice->left[1] - slice->left[0] + FAR;
    const int32_t right = slice->right[1] - slice->right[0] + FAR;
    return (uint32_t)(left | right) >= 2 * FAR; /* a power of two */
}

QTRI_NOINLINE static bool crosses_any(const spans *all, const qtri_stroke_slice *more)
{
    for (int i = 0; i < all->count; i++) {
        const span *other = &all->of[i];
        if (cross(other->left, more->left) || cross(other->right, more->right) ||
            cross(other->left, more->right) || cross(other->right, more->left)) {
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
static void add_span(spans *all, const qtri_stroke_slice *slice)
{
    span more = {{slice->left[0], slice->left[1]}, {slice->right[0], slice->right[1]}};
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
 * Adds the area to the right of a side that moves from `x0` to `x1`, in 1/256 behind the window's
 * first column, while `height` (1/256, signed) goes by. The sum of all sums up to a pixel is then
 * what its area has, in 1/512 by 1/256 pixel.
 */
static void add_side(int32_t cover[], int32_t x0, int32_t x1, int32_t height)
{
    const int32_t end = QTRI_STROKE_WINDOW * 256;
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

/* In columns behind the window's first, so that slopes far away do not overflow. */
static int32_t in_window(int32_t x, int32_t column)
{
    return x - column * 256;
}

/* Of a span: what lies to the right of its left side and not of its right. */
static void add_sides(qtri_stroker *stroker, const int32_t left[2], const int32_t right[2],
                      int32_t height)
{
    const int32_t column = stroker->column;
    add_side(stroker->cover, in_window(left[0], column), in_window(left[1], column), height);
    add_side(stroker->cover, in_window(right[0], column), in_window(right[1], column), -height);
}

/* Of one part there is nothing to unite. */
static void add_slice_alone(qtri_stroker *stroker, qtri_stroke_shape *s, int32_t y0, int32_t y1)
{
    qtri_stroke_slice slice;
    if (qtri_stroke_shape_slice(s, y0, y1, &slice)) {
        add_sides(stroker, slice.left, slice.right, y1 - y0);
    }
}

/* The spans of the group's parts in a slice. True: their sides cross. */
static bool find_spans(spans *all, qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    bool found = false;
    bool any_far = false;
    uint32_t listed = 0;
    all->count = 0;
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &listed)) != NULL;) {
        qtri_stroke_slice slice;
        bool is_there = qtri_stroke_shape_slice(s, y0, y1, &slice);
        bool more = s->disc_apart != 0;
        for (;;) {
            if (is_there) {
                any_far = any_far || moves_far(&slice);
                found = found || (any_far && crosses_any(all, &slice));
                add_span(all, &slice);
            }
            if (!more) {
                break;
            }
            more = false;
            is_there = qtri_stroke_shape_disc(s, y0, y1, &slice);
        }
    }
    return found;
}

/* Where sides cross, the slice is cut into four. */
static void add_slice(qtri_stroker *stroker, int32_t y0, int32_t y1)
{
    spans all;
    int32_t height = y1 - y0;
    bool is_cut = false;
    for (int32_t from = y0; from < y1;) {
        const int32_t to = qtri_least32(from + height, y1);
        if (find_spans(&all, stroker, from, to) && !is_cut) {
            is_cut = true;
            height = (height + 3) >> 2;
            continue;
        }
        for (int i = 0; i < all.count; i++) {
            add_sides(stroker, all.of[i].left, all.of[i].right, to - from);
        }
        from = to;
    }
}

/* Whether a disc reaches into the window's columns and the row. */
static bool has_disc(const qtri_stroke_shape *s, const qtri_stroker *stroker)
{
    const qtri_screen_point *const center[2] = {&s->a, &s->b};
    for (int i = 0; i < 2; i++) {
        const int32_t x = center[i]->x_24p8 - stroker->column * 256;
        const int32_t y = center[i]->y_24p8 - stroker->row * 256;
        if (((s->discs | s->disc_apart) >> i & 1) != 0 && x + s->radius > -256 &&
            x - s->radius < QTRI_STROKE_WINDOW * 256 + 256 && y + s->radius > 0 &&
            y - s->radius < 256) {
            return true;
        }
    }
    return false;
}

static void add_one(qtri_stroker *stroker, qtri_stroke_shape *alone, int32_t y0, int32_t y1)
{
    if (alone != NULL) {
        add_slice_alone(stroker, alone, y0, y1);
    } else {
        add_slice(stroker, y0, y1);
    }
}

/* Slices from level to level, each where a bit is set. `alone`: the only part, if convex. */
static void add_slices(qtri_stroker *stroker, qtri_stroke_shape *alone, const uint32_t levels[8])
{
    const int32_t top = stroker->row * 256;
    int32_t y = 0;
    for (int word = 0; word < 8; word++) {
        for (uint32_t bits = levels[word]; bits != 0; bits &= bits - 1) {
            const int32_t at = word * 32 + 31 - qtri_clz32(bits & (0 - bits)); /* the lowest */
            if (at > y) {
                add_one(stroker, alone, top + y, top + at);
                y = at;
            }
        }
    }
    add_one(stroker, alone, top + y, top + 256);
}

static void add_group(qtri_stroker *stroker)
{
    uint32_t levels[8] = {0};
    uint32_t listed = 0;
    int count = 0;
    bool is_fine = false;
    qtri_stroke_shape *alone = NULL;
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &listed)) != NULL;) {
        count++;
        alone = count == 1 && s->disc_apart == 0 ? s : NULL;
        is_fine = is_fine || count > 1 || has_disc(s, stroker);
        qtri_stroke_shape_breaks(s, stroker->row * 256, levels);
    }
    for (int i = 0; i < 8 && is_fine; i++) {
        levels[i] |= grid[i];
    }
    add_slices(stroker, alone, levels);
}

static void finish(qtri_stroker *stroker)
{
    int32_t sum = 0;
    for (int32_t i = stroker->first; i < stroker->end; i++) {
        sum += stroker->cover[i];
        stroker->cover[i] = qtri_least32(sum, QTRI_STROKE_FULL);
    }
}

const qtri_stroke_edges qtri_stroke_smooth = {add_group, finish, qtri_stroke_line_draw};
