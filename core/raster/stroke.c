/* SPDX-License-Identifier: MIT */
/* Strokes: strips, rows and windows; which part gives each pixel its colour; polylines. */
#include "stroke.h"

#include <string.h>

#include "checked_material.h"

enum { MIN_WIDTH = 4 }; /* columns of a window, halved where a row has too many shapes */

/* Half of a width in 24.8; 0: nothing is drawn. */
static int32_t radius_of(q16 width)
{
    const q16 max = QTRI_STROKE_WIDTH_MAX * Q16_ONE;
    return width <= 0 ? 0 : (qtri_least32(width, max) + 256) >> 9;
}

bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke, bool in_space)
{
    const bool is_flat = stroke->cap == QTRI_CAP_BUTT || stroke->cap == QTRI_CAP_SQUARE;
    stroker->edges = stroke->edges;
    stroker->radius = radius_of(stroke->width);
    stroker->cap = (uint8_t)(is_flat ? stroke->cap : QTRI_CAP_ROUND);
    stroker->ring.radius = 0;
    stroker->disc.radius = 0;
    memset(stroker->window.coverage.sum, 0, sizeof stroker->window.coverage.sum);
    return stroke->alpha != 0 && stroke->width > 0 && (stroker->radius > 0 || in_space) &&
           qtri_stroke_target_init(&stroker->to, surface, material, qtri_stroke_pipelines,
                                   stroke->alpha, stroke->edges != NULL);
}

/* ---- Parts ---- */

/* Whether a part is so short that the disc around one end may reach beyond the other end. */
static bool is_short(const qtri_stroke_place *place)
{
    const uint32_t dx = qtri_magnitude32(place->end[1].x_24p8 - place->end[0].x_24p8);
    const uint32_t dy = qtri_magnitude32(place->end[1].y_24p8 - place->end[0].y_24p8);
    const uint32_t reach = (uint32_t)place->radius_24p8 + 1;
    return dx <= reach && dy <= reach;
}

/*
 * Where the first or the last part ends flat and is short, the disc of its joint would make a shape
 * of it that is not convex: each of these discs is a part of its own, behind all others.
 */
static uint32_t count_of(const qtri_stroker *stroker)
{
    const bool has_discs = !stroker->closed && stroker->cap != QTRI_CAP_ROUND;
    return stroker->count + (has_discs ? 2 : 0);
}

/* Finds a part's place and, where `end` is not NULL, its ends; false: it is not drawn. */
static bool find_part(const qtri_stroker *stroker, uint32_t part, qtri_stroke_place *place,
                      qtri_stroke_end end[2])
{
    const uint32_t last = stroker->count - 1;
    const uint32_t owner = part <= last ? part : part == last + 1 ? 0 : last;
    if (!stroker->source(stroker->from, owner, place->end, end)) {
        return false;
    }
    place->radius_24p8 = stroker->radius;
    place->caps[0] = owner == 0 && !stroker->closed ? stroker->cap : QTRI_CAP_ROUND;
    place->caps[1] = owner == last && !stroker->closed ? stroker->cap : QTRI_CAP_ROUND;
    if (part <= last) {
        return true;
    }
    const int joint = owner == 0 ? 1 : 0;
    const bool is_disc = is_short(place);
    place->end[1 - joint] = place->end[joint];
    place->caps[0] = place->caps[1] = QTRI_CAP_ROUND;
    if (end != NULL) {
        end[1 - joint] = end[joint];
    }
    return is_disc;
}

/*
 * A joint's disc belongs to the part before it: the next one begins flat, unless it is so short
 * that the disc reaches out of it.
 */
static void set_joints(const qtri_stroker *stroker, uint32_t part, qtri_stroke_place *place)
{
    qtri_stroke_place before;
    if (is_short(place)) {
        if (place->caps[0] != place->caps[1]) { /* one is a joint's: round */
            place->caps[place->caps[0] == QTRI_CAP_ROUND ? 0 : 1] = QTRI_CAP_BUTT;
        }
    } else if (place->caps[0] == QTRI_CAP_ROUND && part > 0 &&
               find_part(stroker, part - 1, &before, NULL) &&
               before.end[1].x_24p8 == place->end[0].x_24p8 &&
               before.end[1].y_24p8 == place->end[0].y_24p8) {
        place->caps[0] = QTRI_CAP_BUTT;
    }
}

/* Pixels that a part may touch. A corner of a square cap is 3/2 radii away at most; a small disc's
   polygon reaches out of it. */
static qtri_stroke_box box_of(const qtri_stroke_place *place)
{
    const bool has_corners = place->caps[0] == QTRI_CAP_SQUARE || place->caps[1] == QTRI_CAP_SQUARE;
    const int32_t radius = place->radius_24p8;
    const int32_t reach = radius + (radius >> (has_corners ? 1 : 4)) + 2;
    const qtri_point *a = &place->end[0], *b = &place->end[1];
    const qtri_stroke_box box = {
        (int16_t)((qtri_least32(a->x_24p8, b->x_24p8) - reach) >> 8),
        (int16_t)((qtri_least32(a->y_24p8, b->y_24p8) - reach) >> 8),
        (int16_t)(((qtri_greatest32(a->x_24p8, b->x_24p8) + reach) >> 8) + 1),
        (int16_t)(((qtri_greatest32(a->y_24p8, b->y_24p8) + reach) >> 8) + 1)};
    return box;
}

static inline bool do_overlap(const qtri_stroke_box *a, const qtri_stroke_box *b)
{
    return a->y0 < b->y1 && b->y0 < a->y1 && a->x0 < b->x1 && b->x0 < a->x1;
}

static void add_box(qtri_stroke_box *sum, const qtri_stroke_box *box)
{
    sum->x0 = box->x0 < sum->x0 ? box->x0 : sum->x0;
    sum->y0 = box->y0 < sum->y0 ? box->y0 : sum->y0;
    sum->x1 = box->x1 > sum->x1 ? box->x1 : sum->x1;
    sum->y1 = box->y1 > sum->y1 ? box->y1 : sum->y1;
}

/* Finds the boxes of all blocks; returns their union, empty where no part is drawn. */
static qtri_stroke_box find_blocks(qtri_stroker *stroker)
{
    const qtri_stroke_box none = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};
    const uint32_t count = count_of(stroker);
    qtri_stroke_box all = none;
    stroker->block_parts = (count + QTRI_STROKE_BLOCKS - 1) / QTRI_STROKE_BLOCKS;
    for (uint32_t part = 0; part < count;) {
        qtri_stroke_box *block = &stroker->block[part / stroker->block_parts];
        const uint32_t left = count - part;
        const uint32_t end = part + (left < stroker->block_parts ? left : stroker->block_parts);
        *block = none;
        for (; part < end; part++) {
            qtri_stroke_place place;
            if (find_part(stroker, part, &place, NULL)) {
                const qtri_stroke_box box = box_of(&place);
                add_box(block, &box);
            }
        }
        add_box(&all, block);
    }
    return all;
}

/* The next part from `part` on that overlaps the box, and its own box, or QTRI_STROKE_NONE. */
static uint32_t next_near(const qtri_stroker *stroker, uint32_t part, const qtri_stroke_box *box,
                          qtri_stroke_box *own)
{
    const uint32_t count = count_of(stroker);
    while (part < count) {
        const uint32_t block = part / stroker->block_parts;
        const uint32_t end = (block + 1) * stroker->block_parts;
        if (!do_overlap(&stroker->block[block], box)) {
            part = end;
        }
        for (; part < end && part < count; part++) {
            qtri_stroke_place place;
            if (find_part(stroker, part, &place, NULL)) {
                *own = box_of(&place);
                if (do_overlap(own, box)) {
                    return part;
                }
            }
        }
    }
    return QTRI_STROKE_NONE;
}

/* ---- Shapes ---- */

static void init_shape(qtri_stroker *stroker, qtri_stroke_shape *shape,
                       const qtri_stroke_place *place)
{
    const bool has_ring = stroker->edges != NULL;
    if (has_ring && stroker->ring.radius != place->radius_24p8) {
        stroker->edges->set_ring(&stroker->ring, place->radius_24p8);
    }
    qtri_stroke_shape_init(shape, place, has_ring ? &stroker->ring : NULL);
    shape->min_x = INT32_MIN; /* not known */
    shape->max_x = INT32_MAX;
}

/* Whether the window has this shape in use. */
static bool is_in_row(const qtri_stroke_window *w, const qtri_stroke_shape *shape)
{
    for (uint32_t i = 0; i < w->shape_count; i++) {
        if (w->shape[i] == shape) {
            return true;
        }
    }
    return false;
}

/* An entry of the cache for another shape: free, of a shape above the row, or not of the window. */
static qtri_stroke_shape *free_shape(qtri_stroker *stroker)
{
    const qtri_stroke_window *w = &stroker->window;
    for (uint32_t i = 0; i < QTRI_STROKE_SHAPES; i++) {
        qtri_stroke_shape *s = &stroker->shape[i];
        if (s->part == QTRI_STROKE_NONE || s->bottom <= w->row * 256) {
            return s;
        }
    }
    qtri_stroke_shape *next;
    do {
        stroker->next_shape =
            stroker->next_shape != 0 ? stroker->next_shape - 1 : QTRI_STROKE_SHAPES - 1;
        next = &stroker->shape[stroker->next_shape];
    } while (is_in_row(w, next));
    return next;
}

/* A part's shape, from the cache or made. */
static qtri_stroke_shape *find_shape(qtri_stroker *stroker, uint32_t part)
{
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        if (stroker->shape[i].part == part) {
            return &stroker->shape[i];
        }
    }
    qtri_stroke_place place;
    qtri_stroke_shape *shape = free_shape(stroker);
    (void)find_part(stroker, part, &place, NULL);
    set_joints(stroker, part, &place);
    init_shape(stroker, shape, &place);
    shape->part = part;
    return shape;
}

/* Lists the parts that overlap a box; false: there are more than there is room for. */
static bool list_parts(qtri_stroker *stroker, const qtri_stroke_box *box)
{
    qtri_stroke_box own;
    stroker->near_count = 0;
    stroker->others = QTRI_STROKE_NONE;
    for (uint32_t part = 0; (part = next_near(stroker, part, box, &own)) != QTRI_STROKE_NONE;
         part++) {
        if (stroker->near_count == QTRI_STROKE_NEAR) {
            stroker->others = part;
            return false;
        }
        stroker->near[stroker->near_count].part = part;
        stroker->near[stroker->near_count++].box = own;
    }
    return true;
}

static qtri_stroke_box row_box(const qtri_stroke_window *w)
{
    const qtri_stroke_box box = {(int16_t)w->coverage.x, (int16_t)w->row, (int16_t)w->coverage.end,
                                 (int16_t)(w->row + 1)};
    return box;
}

qtri_stroke_shape *qtri_stroker_find_next(qtri_stroker *stroker, uint32_t part)
{
    const qtri_stroke_box box = row_box(&stroker->window);
    qtri_stroke_box own;
    for (uint32_t i = 0; i < stroker->near_count; i++) {
        const qtri_stroke_near *near = &stroker->near[i];
        if (near->part >= part && do_overlap(&near->box, &box)) {
            return find_shape(stroker, near->part);
        }
    }
    part = part > stroker->others ? part : stroker->others;
    part = next_near(stroker, part, &box, &own);
    return part != QTRI_STROKE_NONE ? find_shape(stroker, part) : NULL;
}

/* Adds a part's shape if it is in the row; false: the window has no room for another one. */
static bool add_shape(qtri_stroker *stroker, uint32_t part)
{
    qtri_stroke_window *w = &stroker->window;
    qtri_stroke_shape *s = find_shape(stroker, part);
    const int32_t first = s->top >> 8, end = (s->bottom + 255) >> 8; /* rows */
    if (first <= w->row && w->row < end) {
        w->shape[w->shape_count++] = s;
        w->same_end = qtri_least32(w->same_end, end);
    } else if (first > w->row) {
        w->same_end = qtri_least32(w->same_end, first);
    }
    return w->shape_count < QTRI_STROKE_SHAPES;
}

/* Lists all shapes of the window's columns in its row, or none. Mostly there is room, and neither
   this row nor rows with the same shapes look one up again. */
static void find_shapes(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    const qtri_stroke_box box = row_box(w);
    qtri_stroke_box own;
    w->shape_count = 0;
    w->is_complete = true;
    w->same_end = stroker->others == QTRI_STROKE_NONE ? INT32_MAX : w->row + 1;
    for (uint32_t i = 0; i < stroker->near_count && w->is_complete; i++) {
        const qtri_stroke_near *near = &stroker->near[i];
        if (near->box.y0 > w->row) {
            w->same_end = qtri_least32(w->same_end, near->box.y0);
        } else if (do_overlap(&near->box, &box)) {
            w->is_complete = add_shape(stroker, near->part);
        }
    }
    for (uint32_t part = stroker->others;
         w->is_complete && (part = next_near(stroker, part, &box, &own)) != QTRI_STROKE_NONE;
         part++) {
        w->is_complete = add_shape(stroker, part);
    }
    if (!w->is_complete) {
        w->shape_count = 0;
        w->same_end = w->row;
    }
}

/* ---- Rows ---- */

/* Hard edges: covers pixels whose centres lie inside. */
static void cover_hard(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    const int32_t y = w->row * 256 + 128;
    int32_t depth[QTRI_COVERAGE_WINDOW + 1] = {0}; /* of shapes, added up from the left */
    uint32_t count = 0;
    for (qtri_stroke_shape *s = NULL; (s = qtri_stroker_next(stroker, s, &count)) != NULL;) {
        if (y < s->top || y >= s->bottom) {
            continue;
        }
        const int32_t left = qtri_stroke_piece_x(qtri_stroke_shape_piece(s, 0, y), y);
        const int32_t right = qtri_stroke_piece_x(qtri_stroke_shape_piece(s, 1, y), y);
        s->min_x = (left + 127) & ~255;
        s->max_x = (right + 127) & ~255;
        const int32_t first = qtri_greatest32((s->min_x >> 8) - w->coverage.x, 0);
        const int32_t end = qtri_least32(s->max_x >> 8, w->coverage.end) - w->coverage.x;
        if (first < end) {
            depth[first]++;
            depth[end]--;
            qtri_stroke_window_add(w, s->min_x, s->max_x);
        }
    }
    int32_t before = 0;
    for (int32_t i = 0, sum = 0; i <= QTRI_COVERAGE_WINDOW; i++) {
        sum += depth[i];
        const int32_t full = sum > 0 ? QTRI_COVERAGE_FULL : 0;
        w->coverage.sum[i] = full - before;
        before = full;
    }
}

/* Gives each column a part that touches it, and marks columns that several touch. */
static void find_parts(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    uint32_t touched = 0, count = 0;
    w->shared = 0;
    for (qtri_stroke_shape *s = NULL; (s = qtri_stroker_next(stroker, s, &count)) != NULL;) {
        if (s->min_x >= w->coverage.end * 256 || s->max_x <= w->coverage.x * 256) {
            continue;
        }
        const int32_t first = qtri_greatest32((s->min_x >> 8) - w->coverage.x, w->first);
        const int32_t end =
            qtri_least32((int32_t)(((uint32_t)s->max_x + 255) >> 8) - w->coverage.x, w->end);
        for (int32_t i = first; i < end; i++) {
            const uint32_t bit = (uint32_t)1 << i;
            w->shared |= touched & bit;
            touched |= bit;
            w->part[i] = s->part;
        }
    }
}

static void draw_span(qtri_stroker *stroker, const qtri_stroke_shape *s, int32_t first, int32_t end,
                      const uint16_t *weight)
{
    uint16_t share[QTRI_COVERAGE_WINDOW];
    const int32_t row = stroker->window.row;
    const qtri_stroke_span span = {
        &stroker->to.state, &stroker->look, first, row, end - first, 1, weight, share};
    if (!stroker->look.is_constant) {
        qtri_stroke_shape_shares(s, first, row, end - first, share);
    }
    qtri_stroke_target_draw(&stroker->to, &span);
}

/* Gives each pixel that several parts touch the nearest one. */
QTRI_NOINLINE static void find_nearest(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    uint64_t min[QTRI_COVERAGE_WINDOW];
    uint32_t count = 0;
    for (int32_t i = 0; i < QTRI_COVERAGE_WINDOW; i++) {
        min[i] = UINT64_MAX;
    }
    for (qtri_stroke_shape *s = NULL; (s = qtri_stroker_next(stroker, s, &count)) != NULL;) {
        for (uint32_t bits = w->shared; bits != 0; bits &= bits - 1) {
            const int32_t i = 31 - qtri_clz32(bits & (0 - bits));
            const uint64_t square = qtri_stroke_shape_distance(s, w->coverage.x + i, w->row);
            if (square < min[i]) {
                min[i] = square;
                w->part[i] = s->part;
            }
        }
    }
}

/* Draws columns first .. end-1 of the window in runs that have the colours of one part. */
QTRI_NOINLINE static void draw_looks(qtri_stroker *stroker, int32_t first, int32_t end,
                                     const uint16_t *weight)
{
    const qtri_stroke_window *w = &stroker->window;
    find_parts(stroker);
    if (w->shared != 0) {
        find_nearest(stroker);
    }
    for (int32_t i = first; i < end;) {
        const int32_t from = i;
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): all of them are set
        if (weight[i - first] == 0) {
            i++;
            continue;
        }
        qtri_stroke_place place;
        qtri_stroke_end ends[2];
        const uint32_t part = w->part[i];
        while (i < end && weight[i - first] != 0 && w->part[i] == part) {
            i++;
        }
        (void)find_part(stroker, part, &place, ends);
        qtri_stroke_look_init(&stroker->look, ends);
        draw_span(stroker, find_shape(stroker, part), w->coverage.x + from, w->coverage.x + i,
                  weight + (from - first));
    }
}

/* Covers and draws the window's columns in its row, whose shapes are known. */
static void draw_window(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    const qtri_rect *bounds = &stroker->to.state.bounds;
    uint16_t all[QTRI_COVERAGE_WINDOW]; /* weights of columns */
    w->first = QTRI_COVERAGE_WINDOW;
    w->end = 0;
    if (stroker->edges != NULL) {
        stroker->edges->cover(stroker);
    } else {
        cover_hard(stroker);
    }
    if (w->first >= w->end) {
        return;
    }
    const int32_t first = qtri_greatest32(w->first, bounds->x0 - w->coverage.x);
    const int32_t end = qtri_least32(w->end, bounds->x1 - w->coverage.x);
    int32_t sum = 0;
    for (int32_t i = w->first; i < w->end; i++) {
        sum += w->coverage.sum[i];
        w->coverage.sum[i] = 0;
        const uint32_t cover = (uint32_t)qtri_hold32(sum, 0, QTRI_COVERAGE_FULL);
        all[i] = (uint16_t)qtri_stroke_weight(cover, stroker->to.alpha_q16);
    }
    w->coverage.sum[w->end] = 0;
    if (first >= end) {
        return;
    }
    const uint16_t *weight = &all[first];
    if (stroker->has_one_look) {
        draw_span(stroker, &stroker->shape[0], w->coverage.x + first, w->coverage.x + end, weight);
    } else {
        draw_looks(stroker, first, end, weight);
    }
}

/* Draws a row of the strip from x on, in windows narrow enough for their shapes. */
static void draw_row(qtri_stroker *stroker, int32_t x)
{
    qtri_stroke_window *w = &stroker->window;
    const int32_t end = x + QTRI_COVERAGE_WINDOW;
    int32_t width = QTRI_COVERAGE_WINDOW;
    while (x < end) {
        if (w->row >= w->same_end || w->coverage.x != x) { /* or the window narrows */
            w->coverage.x = x;
            w->coverage.end = x + width;
            find_shapes(stroker);
        }
        if (!w->is_complete && width > MIN_WIDTH) {
            width >>= 1;
            continue;
        }
        for (int i = 0; !stroker->has_one_look && i < QTRI_STROKE_SHAPES; i++) {
            stroker->shape[i].min_x = w->is_complete ? INT32_MAX : INT32_MIN;
            stroker->shape[i].max_x = w->is_complete ? INT32_MIN : INT32_MAX;
        }
        if (!w->is_complete || w->shape_count != 0) {
            draw_window(stroker);
        }
        x += width;
    }
}

/* The part of a box that is inside the bounds, its columns from a multiple of a window's on. */
static qtri_stroke_box clip_box(const qtri_stroker *stroker, const qtri_stroke_box *box)
{
    const qtri_rect *bounds = &stroker->to.state.bounds;
    const qtri_stroke_box inside = {
        (int16_t)(qtri_greatest32(box->x0, bounds->x0) & ~(QTRI_COVERAGE_WINDOW - 1)),
        (int16_t)qtri_greatest32(box->y0, bounds->y0), (int16_t)qtri_least32(box->x1, bounds->x1),
        (int16_t)qtri_least32(box->y1, bounds->y1)};
    return inside;
}

/* Whether a part by itself, whose ends have the same cap, has no length. */
static bool is_point(const qtri_stroke_place *place)
{
    return place->end[0].x_24p8 == place->end[1].x_24p8 &&
           place->end[0].y_24p8 == place->end[1].y_24p8 &&
           place->radius_24p8 <= QTRI_STROKE_POINT_RADIUS && place->caps[0] != QTRI_CAP_BUTT;
}

void qtri_stroker_draw_part(qtri_stroker *stroker, const qtri_stroke_place *place)
{
    qtri_stroke_window *w = &stroker->window;
    if (is_point(place)) {
        qtri_stroker_draw_point(stroker, &place->end[0], place->radius_24p8,
                                place->caps[0] == QTRI_CAP_ROUND);
        return;
    }
    qtri_stroke_box box = box_of(place);
    box = clip_box(stroker, &box);
    init_shape(stroker, &stroker->shape[0], place);
    stroker->has_one_look = true;
    w->shape[0] = &stroker->shape[0];
    w->shape_count = 1;
    w->is_complete = true;
    for (int32_t x = box.x0; x < box.x1; x += QTRI_COVERAGE_WINDOW) {
        w->coverage.x = x;
        w->coverage.end = x + QTRI_COVERAGE_WINDOW;
        for (w->row = box.y0; w->row < box.y1; w->row++) {
            draw_window(stroker);
        }
    }
}

/* Whether all parts have one colour and depth, which then become stroker->look. */
static bool find_look(qtri_stroker *stroker)
{
    bool is_first = true;
    for (uint32_t part = 0; part < stroker->count; part++) {
        qtri_point at[2];
        qtri_stroke_end end[2];
        qtri_stroke_look look;
        if (!stroker->source(stroker->from, part, at, end)) {
            continue;
        }
        qtri_stroke_look_init(&look, end);
        if (is_first) {
            stroker->look = look;
            is_first = false;
        }
        if (!look.is_constant || look.z_16p16 != stroker->look.z_16p16 ||
            look.color_8p8[0] != stroker->look.color_8p8[0] ||
            look.color_8p8[1] != stroker->look.color_8p8[1] ||
            look.color_8p8[2] != stroker->look.color_8p8[2]) {
            return false;
        }
    }
    return true;
}

void qtri_stroker_draw(qtri_stroker *stroker, qtri_stroke_source source, const void *from,
                       uint32_t points, bool closed)
{
    stroker->source = source;
    stroker->from = from;
    stroker->closed = closed && points > 2;
    stroker->count = stroker->closed || points == 1 ? points : points - 1;
    stroker->next_shape = 0;
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        stroker->shape[i].part = QTRI_STROKE_NONE;
    }
    if (stroker->count == 1) {
        qtri_stroke_place place;
        qtri_stroke_end end[2];
        if (find_part(stroker, 0, &place, end)) {
            qtri_stroke_look_init(&stroker->look, end);
            qtri_stroker_draw_part(stroker, &place);
        }
        return;
    }
    stroker->has_one_look = find_look(stroker);
    qtri_stroke_box all = find_blocks(stroker);
    all = clip_box(stroker, &all);
    for (int32_t x = all.x0; x < all.x1; x += QTRI_COVERAGE_WINDOW) {
        int32_t height = all.y1 - all.y0;
        for (int32_t y = all.y0; y < all.y1;) {
            const int32_t end = qtri_least32(y + height, all.y1);
            const qtri_stroke_box strip = {(int16_t)x, (int16_t)y,
                                           (int16_t)(x + QTRI_COVERAGE_WINDOW), (int16_t)end};
            if (!list_parts(stroker, &strip) && height > 1) {
                height = (height + 1) >> 1; /* fewer rows, fewer parts */
                continue;
            }
            stroker->window.same_end = INT32_MIN;
            for (; y < end; y++) {
                stroker->window.row = y;
                draw_row(stroker, x);
            }
        }
    }
}

/* ---- On the screen ---- */

/* A polyline on the screen, and the qtri_stroke_source of its parts. */
typedef struct polyline {
    const qtri_screen_vertex *v;
    uint32_t count;
} polyline;

static bool find_ends(const void *from, uint32_t part, qtri_point at[2], qtri_stroke_end end[2])
{
    const polyline *line = from;
    for (uint32_t i = 0; i < 2; i++) {
        qtri_vertex v;
        qtri_line_color color;
        qtri_line_end(&v, color, &line->v[part + i < line->count ? part + i : 0]);
        at[i] = v.at;
        if (end != NULL) {
            end[i].depth_16p8 = v.depth_16p8;
            memcpy(end[i].color_8p16, color, sizeof color);
        }
    }
    return true;
}

void qtri_raster_polyline(const qtri_surface *surface, const qtri_material *material,
                          const qtri_stroke *stroke, const qtri_screen_vertex *v, uint32_t count)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_ASSERT(v != NULL || count == 0);
    qtri_stroker stroker;
    const polyline line = {v, count};
    if (count > 0 && qtri_stroker_init(&stroker, surface, material, stroke, false)) {
        qtri_stroker_draw(&stroker, find_ends, &line, count, stroke->closed);
    }
}

void qtri_raster_point(const qtri_surface *surface, const qtri_material *material,
                       const qtri_stroke *stroke, const qtri_screen_vertex *v)
{
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_ASSERT(v != NULL);
    qtri_stroke point = *stroke;
    point.cap = stroke->cap == QTRI_CAP_BUTT ? QTRI_CAP_SQUARE : stroke->cap;
    qtri_raster_polyline(surface, material, &point, v, 1);
}
