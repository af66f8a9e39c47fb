/* SPDX-License-Identifier: MIT */
/*
 * Smooth edges: the area of each pixel that the union of the parts covers.
 *
 * What one part covers of a row is exact but for the chords of its arcs. Where several parts cover
 * a pixel in part, the row is cut at the levels where one of their bounds bends or two of them
 * cross: in such a slice each part lies between two straight sides, and parts that overlap are one.
 */
#include "stroke.h"

/* Parts of a slice that are one: the bounds at its levels. */
typedef struct span {
    int32_t left[2], right[2];
} span;

enum { SPANS = 12 };

typedef struct spans {
    span of[SPANS];
    int count;
} spans;

/*
 * Two parts cover together at least what the one covers that covers more, and at most the sum or
 * all of the pixel. Where these differ by no more than this the middle serves.
 */
enum { FULL = QTRI_COVERAGE_FULL, MARGIN = FULL / 48 };

/* The sides between two levels of a row between which they are straight. */
QTRI_INLINE void find_sides(span *out, qtri_stroke_shape *s, int32_t y0, int32_t y1)
{
    if (s->is_short && qtri_stroke_shape_is_straight(s, y0, y1)) {
        const int32_t across = s->is_left ? s->offset_y : -s->offset_y;
        const int32_t offset_x = s->is_left ? s->offset_x : -s->offset_x;
        const int32_t left = s->a.x_24p8 + offset_x;
        const int32_t right = s->a.x_24p8 - offset_x;
        const int32_t down = s->slope_q16 * (y0 - s->a.y_24p8) + 0x8000; /* < 2^31 */
        const int32_t height = s->slope_q16 * (y1 - y0);
        const int32_t turn = s->slope_q16 * across;
        out->left[0] = left + ((down - turn) >> 16);
        out->left[1] = left + ((down - turn + height) >> 16);
        out->right[0] = right + ((down + turn) >> 16);
        out->right[1] = right + ((down + turn + height) >> 16);
        return;
    }
    out->left[0] = qtri_stroke_shape_x(s, 0, y0, true);
    out->left[1] = qtri_stroke_shape_x(s, 0, y1, false);
    out->right[0] = qtri_stroke_shape_x(s, 1, y0, true);
    out->right[1] = qtri_stroke_shape_x(s, 1, y1, false);
}

static inline void add_side(qtri_stroke_shape *s, int side, const int32_t x[2], int32_t y0,
                            int32_t y1, qtri_coverage *coverage)
{
    const int32_t min = qtri_least32(x[0], x[1]);
    const int32_t max = qtri_greatest32(x[0], x[1]);
    if (side == 0) {
        s->min_x = qtri_least32(s->min_x, min);
        s->max_left = qtri_greatest32(s->max_left, max);
    } else {
        s->min_right = qtri_least32(s->min_right, min);
        s->max_x = qtri_greatest32(s->max_x, max);
    }
    if (coverage != NULL) {
        qtri_coverage_add(coverage, x[0], y0, x[1], y1, side == 0 ? 1 : -1);
    }
}

static void find_row(qtri_stroke_shape *s, int32_t row, qtri_coverage *coverage)
{
    const int32_t level = row * 256;
    const int32_t top = qtri_greatest32(s->top, level);
    const int32_t bottom = qtri_least32(s->bottom, level + 256);
    s->row = row;
    s->min_x = s->min_right = INT32_MAX;
    s->max_x = s->max_left = INT32_MIN;
    if (top >= bottom) {
        return;
    }
    if (qtri_stroke_shape_is_straight(s, top, bottom)) {
        span sides;
        find_sides(&sides, s, top, bottom);
        add_side(s, 0, sides.left, top - level, bottom - level, coverage);
        add_side(s, 1, sides.right, top - level, bottom - level, coverage);
        return;
    }
    for (int side = 0; side < 2; side++) {
        for (int32_t y = top; y < bottom;) {
            const int32_t to = qtri_least32(qtri_stroke_shape_next(s, side, y), bottom);
            const int32_t x[2] = {qtri_stroke_shape_x(s, side, y, true),
                                  qtri_stroke_shape_x(s, side, to, false)};
            add_side(s, side, x, y - level, to - level, coverage);
            y = to;
        }
    }
}

static void add(qtri_stroke_window *w, qtri_stroke_shape *s)
{
    find_row(s, w->row, &w->coverage);
    if (s->min_x >= s->max_x) {
        s->max_x = s->min_x; /* nothing */
        return;
    }
    const int32_t first = qtri_greatest32((s->min_x >> 8) - w->coverage.x, 0);
    const int32_t end = qtri_least32(((s->max_x + 255) >> 8) - w->coverage.x, QTRI_COVERAGE_WINDOW);
    int32_t sum = 0;
    if (first > end) {
        return;
    }
    for (int32_t i = first; i < end; i++) {
        sum += w->coverage.sum[i];
        w->coverage.sum[i] = 0;
        const int32_t own = qtri_hold32(sum, 0, FULL);
        const int32_t other = w->cover[i];
        if (other == 0 || own == 0) {
            w->cover[i] = own | other;
            continue;
        }
        const int32_t more = qtri_greatest32(own, other);
        const int32_t margin = qtri_least32(qtri_least32(own, other), FULL - more);
        w->shared |= (uint32_t)1 << i;
        w->in_part |= margin > MARGIN ? (uint32_t)1 << i : 0;
        w->cover[i] = margin > MARGIN ? more : more + (margin >> 1);
    }
    w->coverage.sum[end] = 0;
}

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
 * The level up to which two sides do not cross, in a slice from 0 to `height`: all of it where
 * the triangle that is missed, at most the smaller distance times half of the height, and half of
 * that, is below 1/128 of a pixel.
 */
static int32_t up_to_crossing(const int32_t a[2], const int32_t b[2], int32_t height)
{
    const int32_t from = a[0] - b[0];
    const int32_t to = a[1] - b[1];
    if ((from ^ to) >= 0) {
        return height;
    }
    uint32_t d0 = qtri_magnitude32(from);
    uint32_t d1 = qtri_magnitude32(to);
    if ((d0 < d1 ? d0 : d1) * (uint32_t)height <= 2048) { /* < 2^24 2^8 */
        return height;
    }
    d0 >>= 3; /* < 2^22: the sum times 2^8 fits */
    d1 >>= 3;
    const int32_t at = (int32_t)(d0 * (uint32_t)height / (d0 + d1 + 1));
    return qtri_hold32(at, 1, height - 1);
}

static int32_t up_to_crossings(const spans *all, const span *more, int32_t height)
{
    for (int i = 0; i < all->count; i++) {
        const span *other = &all->of[i];
        height = qtri_least32(height, up_to_crossing(other->left, more->left, height));
        height = qtri_least32(height, up_to_crossing(other->right, more->right, height));
        height = qtri_least32(height, up_to_crossing(other->left, more->right, height));
        height = qtri_least32(height, up_to_crossing(other->right, more->left, height));
    }
    return height;
}

/*
 * Adds one to the disjoint spans, which are sorted: those that it touches become one with it. Where
 * there is no room it is taken together with the one before it, a slice of which more than twelve
 * separate parts lie in one strip.
 */
static void add_span(spans *all, span more)
{
    int at = 0;
    int end;
    while (at < all->count && middle(all->of[at].right) < middle(more.left)) {
        at++;
    }
    for (end = at; end < all->count && middle(all->of[end].left) <= middle(more.right); end++) {
        widen(more.left, all->of[end].left, -1);
        widen(more.right, all->of[end].right, 1);
    }
    if (end == at && all->count == SPANS) {
        at = at > 0 ? at - 1 : 0;
        end = at + 1;
        widen(more.left, all->of[at].left, -1);
        widen(more.right, all->of[at].right, 1);
    }
    const int moved = at + 1 - end; /* 1, 0, or less */
    if (moved > 0) {
        for (int i = all->count; i > at; i--) {
            all->of[i] = all->of[i - 1];
        }
    } else {
        for (int i = end; i < all->count; i++) {
            all->of[i + moved] = all->of[i];
        }
    }
    all->of[at] = more;
    all->count += moved;
}

/*
 * Shapes that touch columns: most often there is room for all of them, with nothing to look up
 * again from slice to slice.
 */
enum { GROUP = 6 };

typedef struct group {
    qtri_stroker *stroker;
    int32_t first, end; /* columns of the window */
    int32_t x0, x1;     /* their sides */
    bool is_complete;
    uint32_t count;
    qtri_stroke_shape *shape[GROUP];
} group;

static void find_group(group *g, qtri_stroker *stroker, int32_t first, int32_t end)
{
    uint32_t part[GROUP];
    uint32_t at = 0;
    qtri_stroke_shape *s;
    g->stroker = stroker;
    g->first = first;
    g->end = end;
    g->x0 = (stroker->window.coverage.x + first) * 256;
    g->x1 = (stroker->window.coverage.x + end) * 256;
    g->count = 0;
    g->is_complete = false;
    while ((s = qtri_stroker_next(stroker, &at, first, end)) != NULL) {
        if (g->count == GROUP || s == &stroker->disc) {
            return;
        }
        part[g->count] = s->part;
        g->shape[g->count++] = s;
    }
    for (uint32_t i = 0; i < g->count; i++) {
        if (g->shape[i]->part != part[i]) {
            return; /* another took its room */
        }
    }
    g->is_complete = true;
}

static inline qtri_stroke_shape *next_of_group(const group *g, uint32_t *at)
{
    if (g->is_complete) {
        return *at < g->count ? g->shape[(*at)++] : NULL;
    }
    return qtri_stroker_next(g->stroker, at, g->first, g->end);
}

/* The spans of the slice from y0 to y1; returns where it ends, earlier where sides cross. */
static int32_t find_spans(spans *all, const group *g, int32_t y0, int32_t y1)
{
    uint32_t at = 0;
    all->count = 0;
    for (qtri_stroke_shape *s; (s = next_of_group(g, &at)) != NULL;) {
        if (s->top > y0 || s->bottom < y1) {
            continue;
        }
        span more;
        find_sides(&more, s, y0, y1);
        if ((more.left[0] >= g->x1 && more.left[1] >= g->x1) ||
            (more.right[0] <= g->x0 && more.right[1] <= g->x0)) {
            continue;
        }
        const int32_t height = up_to_crossings(all, &more, y1 - y0);
        if (height < y1 - y0) {
            y1 = y0 + height; /* sides are others: once more */
            all->count = 0;
            at = 0;
            continue;
        }
        add_span(all, more);
    }
    return y1;
}

/*
 * The next level below y where a bound bends that passes through the columns, or a part begins or
 * ends.
 */
static int32_t next_level(const group *g, int32_t y, int32_t bottom)
{
    uint32_t at = 0;
    for (qtri_stroke_shape *s; (s = next_of_group(g, &at)) != NULL;) {
        if (s->top > y) {
            bottom = qtri_least32(bottom, s->top);
        } else if (s->bottom > y) {
            bottom = qtri_least32(bottom, s->bottom);
            if (s->max_left > g->x0) {
                bottom = qtri_least32(bottom, qtri_stroke_shape_next(s, 0, y));
            }
            if (s->min_right < g->x1) {
                bottom = qtri_least32(bottom, qtri_stroke_shape_next(s, 1, y));
            }
        }
    }
    return bottom;
}

/* Columns first .. end-1 of the window: what all parts cover together. */
static void unite_columns(qtri_stroker *stroker, int32_t first, int32_t end)
{
    qtri_stroke_window *w = &stroker->window;
    const int32_t row = w->row * 256;
    qtri_coverage c;
    group g;
    find_group(&g, stroker, first, end);
    c.x = w->coverage.x + first;
    c.end = w->coverage.x + end;
    for (int32_t i = 0; i <= end - first; i++) {
        c.sum[i] = 0;
    }
    for (int32_t y = row; y < row + 256;) {
        spans all;
        int32_t to = next_level(&g, y, row + 256);
        to = find_spans(&all, &g, y, to);
        for (int i = 0; i < all.count; i++) {
            const span *s = &all.of[i];
            qtri_coverage_add(&c, s->left[0], y - row, s->left[1], to - row, 1);
            qtri_coverage_add(&c, s->right[0], y - row, s->right[1], to - row, -1);
        }
        y = to;
    }
    int32_t sum = 0;
    for (int32_t i = first; i < end; i++) {
        // NOLINTNEXTLINE(clang-analyzer-core.*): first < end, so that all are 0 above
        sum += c.sum[i - first];
        w->cover[i] = qtri_hold32(sum, 0, FULL);
    }
}

static void unite(qtri_stroker *stroker)
{
    const qtri_stroke_window *w = &stroker->window;
    for (int32_t i = w->first; i < w->end;) {
        const int32_t first = i;
        while (i < w->end && (w->in_part >> i & 1) != 0 && w->cover[i] != FULL) {
            i++;
        }
        if (i > first) {
            unite_columns(stroker, first, i);
        } else {
            i++;
        }
    }
}

/* Small round points --------------------------------------------------------------------------- */

/*
 * A disc, as most of a cloud of points are, is a polygon whose vertices follow from its radius
 * alone, and are kept from point to point.
 *
 * Vertices around its top lie (k / 4)^2 pixels below it, as the levels of arcs (stroke_shape.h),
 * and at its centre; half of each chord is 1/128 pixel longer.
 */

/* Radii, 24.8: up to these the polygon is regular, of 8 and of 12 vertices; and the most. */
enum { SMALL = 160, MEDIUM = 400, MOST = 1024, COLUMNS = 2 * (MOST >> 8) + 2 };

/*
 * A regular polygon of the disc's area: 8 or 12 vertices, of which there are three or four from its
 * top to its side. In 2^-14 of the radius.
 */
static int32_t set_regular(qtri_stroke_ring *ring)
{
    static const uint16_t side[2][4] = {{0, 12210, 17267}, {0, 8383, 14520, 16766}};
    const uint16_t *of = side[ring->radius > SMALL];
    const int32_t last = ring->radius > SMALL ? 3 : 2;
    for (int32_t i = 0; i <= last; i++) {
        ring->at[i].y = -(((int32_t)of[last - i] * ring->radius + 8192) >> 14);
        ring->at[i].half = ((int32_t)of[i] * ring->radius + 8192) >> 14;
    }
    return last;
}

/* By levels: the number of the one at the centre. */
static int32_t set_levels(qtri_stroke_ring *ring)
{
    static const int16_t down[8] = {16, 64, 144, 256, 400, 576, 784, 1024};
    const int32_t radius = ring->radius;
    int32_t count = 1;
    ring->at[0].y = -radius;
    ring->at[0].half = 0;
    for (int i = 0; i < 8 && down[i] < radius; i++, count++) {
        ring->at[count].y = down[i] - radius;
        ring->at[count].half =
            qtri_stroke_half_chord(radius, down[i] - radius) + QTRI_STROKE_CHORDS;
    }
    ring->at[count].y = 0;
    ring->at[count].half = radius + QTRI_STROKE_CHORDS;
    return count;
}

static void set_ring(qtri_stroke_ring *ring, int32_t radius)
{
    ring->radius = radius;
    const int32_t last = radius > MEDIUM ? set_levels(ring) : set_regular(ring);
    ring->count = 2 * last + 1; /* <= 17 */
    for (int32_t i = 0; i < last; i++) {
        const int32_t height = qtri_greatest32(ring->at[i + 1].y - ring->at[i].y, 1);
        const int32_t wide = ring->at[i + 1].half - ring->at[i].half;
        const int32_t mirrored = 2 * last - i;
        ring->at[i].slope_q16 = wide * 65536 / height; /* 0 <= wide < 2^11 */
        ring->at[i].inverse_q16 = wide == 0 ? 0 : height * 65536 / wide;
        ring->at[mirrored].y = -ring->at[i].y;
        ring->at[mirrored].half = ring->at[i].half;
        ring->at[mirrored - 1].slope_q16 = -ring->at[i].slope_q16;
        ring->at[mirrored - 1].inverse_q16 = ring->at[i].inverse_q16;
    }
}

/*
 * Adds the area to the right of a side between x0 and x1, x0 <= x1, behind the first column, while
 * `height` (signed) goes by.
 */
static inline void add_ring_side(int32_t *cover, int32_t x0, int32_t x1, int32_t height,
                                 int32_t inverse_q16)
{
    int32_t column = x0 >> 8;
    if (x1 <= (column + 1) * 256) {
        const int32_t behind = height * (x0 + x1 - 512 * column);
        cover[column] += height * 512 - behind;
        cover[column + 1] += behind;
        return;
    }
    const int32_t size = height < 0 ? -height : height;
    int32_t done = 0;
    for (int32_t x = x0; x < x1; column++) {
        const int32_t to = qtri_least32((column + 1) * 256, x1);
        const int32_t upto =
            to == x1 ? size : qtri_least32(((to - x0) * inverse_q16) >> 16, size); /* < 2^31 */
        const int32_t part = height < 0 ? done - upto : upto - done;
        const int32_t behind = part * (x + to - 512 * column);
        cover[column] += part * 512 - behind;
        cover[column + 1] += behind;
        x = to;
        done = upto;
    }
}

/* Both sides of a ring's edge from level y0 to y1 below the centre; x: the centre's. */
static inline void add_edge(int32_t *cover, const qtri_stroke_ring *ring, int32_t i, int32_t x,
                            int32_t y0, int32_t y1)
{
    const int32_t slope = ring->at[i].slope_q16;
    const int32_t from = ring->at[i].half + ((slope * (y0 - ring->at[i].y) + 0x8000) >> 16);
    const int32_t to = ring->at[i].half + ((slope * (y1 - ring->at[i].y) + 0x8000) >> 16);
    const int32_t least = qtri_least32(from, to);
    const int32_t most = qtri_greatest32(from, to);
    add_ring_side(cover, x - most, x - least, y1 - y0, ring->at[i].inverse_q16);
    add_ring_side(cover, x + least, x + most, y0 - y1, ring->at[i].inverse_q16);
}

/* The row's pixels, whose upper side is `top` below the centre; *edge: the first that counts. */
static void cover_row(int32_t *cover, const qtri_stroke_ring *ring, int32_t *edge, int32_t x,
                      int32_t top)
{
    int32_t i = *edge;
    while (i + 1 < ring->count && ring->at[i + 1].y <= top) {
        i++;
    }
    *edge = i;
    for (; i + 1 < ring->count && ring->at[i].y < top + 256; i++) {
        add_edge(cover, ring, i, x, qtri_greatest32(ring->at[i].y, top),
                 qtri_least32(ring->at[i + 1].y, top + 256));
    }
}

/* Columns of a disc, and those of them inside the bounds. */
typedef struct columns {
    int32_t first, end;
    int32_t inside, inside_end;
} columns;

static void draw_disc_row(qtri_stroker *stroker, const int32_t *cover, const columns *c,
                          int32_t row)
{
    uint16_t weight[COLUMNS];
    int32_t sum = 0;
    for (int32_t x = c->first; x < c->inside_end; x++) {
        // NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign): the caller cleared all columns
        sum += *cover++;
        if (x >= c->inside) {
            const uint32_t held = (uint32_t)qtri_hold32(sum, 0, QTRI_STROKE_FULL);
            weight[x - c->inside] = (uint16_t)qtri_stroke_weight(held, stroker->to.alpha_q16);
        }
    }
    const qtri_stroke_span pixels = {&stroker->to.state,        &stroker->look, c->inside, row,
                                     c->inside_end - c->inside, weight,         weight,    false};
    qtri_stroke_target_draw(&stroker->to, &pixels);
}

static void draw_rows(qtri_stroker *stroker, const qtri_screen_point *center)
{
    const qtri_rect *bounds = &stroker->to.state.bounds;
    const qtri_stroke_ring *ring = &stroker->of.ring;
    const int32_t reach = ring->at[ring->count >> 1].half;
    const int32_t top = ring->at[0].y;
    const int32_t last = qtri_least32((center->y_24p8 - top + 255) >> 8, bounds->y1);
    int32_t row = qtri_greatest32((center->y_24p8 + top) >> 8, bounds->y0);
    int32_t edge = 0;
    columns c;
    c.first = (center->x_24p8 - reach) >> 8;
    c.end = (center->x_24p8 + reach + 255) >> 8;
    c.inside = qtri_greatest32(c.first, bounds->x0);
    c.inside_end = qtri_least32(c.end, bounds->x1);
    if (c.inside >= c.inside_end) {
        return;
    }
    for (; row < last; row++) {
        int32_t cover[COLUMNS + 1];
        for (int32_t i = 0; i <= c.end - c.first; i++) {
            cover[i] = 0;
        }
        cover_row(cover, ring, &edge, center->x_24p8 - c.first * 256, row * 256 - center->y_24p8);
        draw_disc_row(stroker, cover, &c, row);
    }
}

static bool draw_point(qtri_stroker *stroker, const qtri_stroke_place *place)
{
    if (place->end[0].x_24p8 != place->end[1].x_24p8 ||
        place->end[0].y_24p8 != place->end[1].y_24p8 || place->caps[0] != QTRI_CAP_ROUND ||
        place->caps[1] != QTRI_CAP_ROUND || place->radius_24p8 > MOST) {
        return false;
    }
    if (!stroker->has_ring || stroker->of.ring.radius != place->radius_24p8) {
        stroker->has_ring = true;
        set_ring(&stroker->of.ring, place->radius_24p8);
    }
    draw_rows(stroker, &place->end[0]);
    return true;
}

const qtri_stroke_edges qtri_stroke_smooth = {find_row, add, unite, draw_point,
                                              qtri_stroke_line_draw};

/* The stroke of an application that has chosen nothing -----------------------------------------
 */

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
