/* SPDX-License-Identifier: MIT */
#include "stroke.h"

#include <string.h>

#include "checked_material.h"

bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke)
{
    stroker->edges = stroke->edges;
    stroker->has_ring = false;
    memset(stroker->window.coverage.sum, 0, sizeof stroker->window.coverage.sum);
    memset(stroker->window.cover, 0, sizeof stroker->window.cover);
    return stroke->alpha != 0 &&
           qtri_stroke_target_init(&stroker->to, surface, material, qtri_stroke_pipelines,
                                   stroke->alpha, stroke->edges != NULL);
}

/* Parts ---------------------------------------------------------------------------------------- */

/* A corner of a square cap is 3/2 radii away at most. */
static qtri_stroke_box box_of(const qtri_stroke_place *place)
{
    const int32_t reach = place->radius_24p8 + (place->radius_24p8 >> 1) + 2;
    const qtri_screen_point *a = &place->end[0];
    const qtri_screen_point *b = &place->end[1];
    const qtri_stroke_box box = {
        (int16_t)((qtri_least32(a->x_24p8, b->x_24p8) - reach) >> 8),
        (int16_t)((qtri_least32(a->y_24p8, b->y_24p8) - reach) >> 8),
        (int16_t)(((qtri_greatest32(a->x_24p8, b->x_24p8) + reach) >> 8) + 1),
        (int16_t)(((qtri_greatest32(a->y_24p8, b->y_24p8) + reach) >> 8) + 1)};
    return box;
}

static bool do_meet(const qtri_stroke_box *a, const qtri_stroke_box *b)
{
    return a->x0 < b->x1 && b->x0 < a->x1 && a->y0 < b->y1 && b->y0 < a->y1;
}

/* Whether a part is to be seen and meets a box; *own: its box. */
static bool is_near(const qtri_stroker *stroker, uint32_t part, const qtri_stroke_box *box,
                    qtri_stroke_box *own)
{
    qtri_stroke_place place;
    const qtri_stroke_source *source = stroker->source;
    if (!source->place(source->from, part, &place)) {
        return false;
    }
    *own = box_of(&place);
    return do_meet(own, box);
}

static void add_box(qtri_stroke_box *sum, const qtri_stroke_box *box)
{
    sum->x0 = box->x0 < sum->x0 ? box->x0 : sum->x0;
    sum->y0 = box->y0 < sum->y0 ? box->y0 : sum->y0;
    sum->x1 = box->x1 > sum->x1 ? box->x1 : sum->x1;
    sum->y1 = box->y1 > sum->y1 ? box->y1 : sum->y1;
}

/* Boxes of blocks of parts, and that of all; without a part that is seen it is empty. */
static qtri_stroke_box find_blocks(qtri_stroker *stroker)
{
    const qtri_stroke_box anywhere = {INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX};
    const qtri_stroke_box none = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};
    const uint32_t count = stroker->source->count;
    qtri_stroke_box all = none;
    stroker->block_parts = (count + QTRI_STROKE_BLOCKS - 1) / QTRI_STROKE_BLOCKS;
    for (uint32_t part = 0; part < count;) {
        qtri_stroke_box *block = &stroker->block[part / stroker->block_parts];
        const uint32_t left = count - part;
        const uint32_t end = part + (left < stroker->block_parts ? left : stroker->block_parts);
        *block = none;
        for (; part < end; part++) {
            qtri_stroke_box box;
            if (is_near(stroker, part, &anywhere, &box)) {
                add_box(block, &box);
            }
        }
        add_box(&all, block);
    }
    return all;
}

/* The next part from `part` on that meets the box; UINT32_MAX: none. */
static uint32_t next_near(const qtri_stroker *stroker, uint32_t part, const qtri_stroke_box *box,
                          qtri_stroke_box *own)
{
    const uint32_t count = stroker->source->count;
    while (part < count) {
        const uint32_t block = part / stroker->block_parts;
        const uint32_t end = (block + 1) * stroker->block_parts;
        if (do_meet(&stroker->block[block], box)) {
            for (; part < end && part < count; part++) {
                if (is_near(stroker, part, box, own)) {
                    return part;
                }
            }
        }
        part = end;
    }
    return UINT32_MAX;
}

/*
 * A joint's disc belongs to the part before it: the next one begins flat, unless it is so short
 * that the disc would reach out of it.
 */
static void flatten_joint(const qtri_stroke_source *source, uint32_t part, qtri_stroke_place *place)
{
    qtri_stroke_place last;
    if (part == 0 || place->caps[0] != QTRI_CAP_ROUND || place->caps[1] != QTRI_CAP_ROUND ||
        !source->place(source->from, part - 1, &last) || last.caps[0] != QTRI_CAP_ROUND) {
        return; /* without a length, a part with a flat end is no whole disc */
    }
    const int32_t dx = place->end[1].x_24p8 - place->end[0].x_24p8;
    const int32_t dy = place->end[1].y_24p8 - place->end[0].y_24p8;
    const uint32_t max =
        qtri_magnitude32(dx) > qtri_magnitude32(dy) ? qtri_magnitude32(dx) : qtri_magnitude32(dy);
    if (max > (uint32_t)place->radius_24p8 + 1 && last.caps[1] == QTRI_CAP_ROUND &&
        last.end[1].x_24p8 == place->end[0].x_24p8 && last.end[1].y_24p8 == place->end[0].y_24p8) {
        place->caps[0] = QTRI_CAP_BUTT;
    }
}

/* A shape that ends above the row is not needed any more. */
static qtri_stroke_shape *free_shape(qtri_stroker *stroker)
{
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        qtri_stroke_shape *s = &stroker->shape[i];
        if (s->part == UINT32_MAX || s->bottom <= stroker->window.row * 256) {
            return s;
        }
    }
    stroker->next_shape = (stroker->next_shape + 1) % QTRI_STROKE_SHAPES;
    return &stroker->shape[stroker->next_shape];
}

static qtri_stroke_shape *shape_of(qtri_stroker *stroker, uint32_t part)
{
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        if (stroker->shape[i].part == part) {
            return &stroker->shape[i];
        }
    }
    qtri_stroke_place place;
    qtri_stroke_shape *shape = free_shape(stroker);
    (void)stroker->source->place(stroker->source->from, part, &place);
    flatten_joint(stroker->source, part, &place);
    qtri_stroke_shape_init(shape, &place, stroker->edges != NULL ? QTRI_STROKE_CHORDS : 0);
    shape->part = part;
    return shape;
}

/* Lists the parts that meet a box; false: there are more than there is room for. */
static bool list_parts(qtri_stroker *stroker, const qtri_stroke_box *box)
{
    qtri_stroke_box own;
    stroker->near_count = 0;
    stroker->others = UINT32_MAX;
    for (uint32_t part = 0; (part = next_near(stroker, part, box, &own)) != UINT32_MAX; part++) {
        if (stroker->near_count == QTRI_STROKE_NEAR) {
            stroker->others = part;
            return false;
        }
        qtri_stroke_near *near = &stroker->of.parts.near[stroker->near_count++];
        near->part = part;
        near->y0 = own.y0;
        near->y1 = own.y1;
    }
    return true;
}

/* Hard edges: pixels whose centres lie inside; bounds are columns' left sides. */
static void find_row_hard(qtri_stroke_shape *s, int32_t row)
{
    const int32_t y = row * 256 + 128;
    s->row = row;
    s->min_x = s->max_x = 0;
    if (y >= s->top && y < s->bottom) {
        s->min_x = (qtri_stroke_shape_x(s, 0, y, true) + 127) & ~255;
        s->max_x = (qtri_stroke_shape_x(s, 1, y, true) + 127) & ~255;
    }
}

static void add_hard(qtri_stroke_window *w, qtri_stroke_shape *s)
{
    find_row_hard(s, w->row);
    const int32_t end = qtri_least32(s->max_x >> 8, w->coverage.end) - w->coverage.x;
    for (int32_t i = qtri_greatest32((s->min_x >> 8) - w->coverage.x, 0); i < end; i++) {
        w->shared |= w->cover[i] != 0 ? (uint32_t)1 << i : 0;
        w->cover[i] = QTRI_COVERAGE_FULL;
    }
}

static void find_row(const qtri_stroker *stroker, qtri_stroke_shape *s)
{
    if (stroker->edges != NULL) {
        stroker->edges->find_row(s, stroker->window.row, NULL);
    } else {
        find_row_hard(s, stroker->window.row);
    }
}

/* A disc apart follows its shape. */
#define DISC ((uint32_t)1 << 31)

/* Counts parts that are active, then others. UINT32_MAX: there are no more. */
static uint32_t next_part(const qtri_stroker *stroker, uint32_t *at, int32_t first, int32_t end)
{
    const qtri_stroke_window *w = &stroker->window;
    const uint32_t count = stroker->active_count;
    while (*at < count) {
        const qtri_stroke_near *near = &stroker->of.parts.near[stroker->of.parts.active[(*at)++]];
        if (near->first < end && near->end > first) {
            return near->part;
        }
    }
    if (stroker->others == UINT32_MAX) {
        return UINT32_MAX;
    }
    qtri_stroke_box own;
    const qtri_stroke_box box = {(int16_t)(w->coverage.x + first), (int16_t)w->row,
                                 (int16_t)(w->coverage.x + end), (int16_t)(w->row + 1)};
    const uint32_t part = next_near(stroker, stroker->others + (*at - count), &box, &own);
    if (part != UINT32_MAX) {
        *at = part + 1 - stroker->others + count;
    }
    return part;
}

qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at, int32_t first,
                                     int32_t end)
{
    const qtri_stroke_window *w = &stroker->window;
    const int32_t x0 = (w->coverage.x + first) * 256;
    const int32_t x1 = (w->coverage.x + end) * 256;
    for (;;) {
        qtri_stroke_shape *s;
        if ((*at & DISC) != 0) {
            *at &= ~DISC;
            s = &stroker->disc;
            qtri_stroke_shape_disc(s, shape_of(stroker, stroker->apart));
        } else {
            const uint32_t part = next_part(stroker, at, first, end);
            if (part == UINT32_MAX) {
                return NULL;
            }
            s = shape_of(stroker, part);
            if (s->apart != 0) {
                stroker->apart = part;
                *at |= DISC;
            }
        }
        if (s->row != w->row) {
            find_row(stroker, s);
        }
        if (s->min_x < x1 && s->max_x > x0) {
            return s;
        }
    }
}

/* Rows ----------------------------------------------------------------------------------------- */

static void draw_span(qtri_stroker *stroker, const qtri_stroke_shape *s, int32_t first, int32_t end,
                      const uint16_t *weight)
{
    uint16_t share[QTRI_COVERAGE_WINDOW];
    const int32_t row = stroker->window.row;
    const qtri_stroke_span span = {&stroker->to.state, &stroker->look, first, row,
                                   end - first,        weight,         share, false};
    if (!stroker->look.is_level) {
        qtri_stroke_shape_shares(s, first, row, end - first, share);
    }
    qtri_stroke_target_draw(&stroker->to, &span);
}

/* The part that is nearest to each pixel that several touch. */
QTRI_NOINLINE static void find_nearest(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    uint64_t min[QTRI_COVERAGE_WINDOW];
    uint32_t at = 0;
    for (int32_t i = w->first; i < w->end; i++) {
        min[i] = UINT64_MAX;
    }
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &at, w->first, w->end)) != NULL;) {
        for (uint32_t bits = w->shared; bits != 0; bits &= bits - 1) {
            const int32_t i = 31 - qtri_clz32(bits & (0 - bits));
            const uint64_t square = qtri_stroke_shape_distance(s, w->coverage.x + i, w->row);
            // NOLINTNEXTLINE(clang-analyzer-core.*): bits of columns of the window
            if (square < min[i]) {
                min[i] = square;
                w->part[i] = s->part;
            }
        }
    }
}

/* Runs of pixels with colours of one part, of columns first .. end-1 of the window. */
QTRI_NOINLINE static void draw_looks(qtri_stroker *stroker, int32_t first, int32_t end,
                                     const uint16_t *weight)
{
    const qtri_stroke_window *w = &stroker->window;
    for (int32_t i = first; i < end;) {
        const int32_t from = i;
        if (w->cover[i] == 0) {
            i++;
            continue;
        }
        qtri_stroke_end ends[2];
        const uint32_t part = w->part[i];
        while (i < end && w->cover[i] != 0 && w->part[i] == part) {
            i++;
        }
        stroker->source->ends(stroker->source->from, part, ends);
        qtri_stroke_look_init(&stroker->look, ends);
        draw_span(stroker, shape_of(stroker, part), w->coverage.x + from, w->coverage.x + i,
                  weight + (from - first));
    }
}

/* What parts have added to the row's window. */
static void draw_window(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    const qtri_rect *bounds = &stroker->to.state.bounds;
    const int32_t first = qtri_greatest32(w->first, bounds->x0 - w->coverage.x);
    const int32_t end = qtri_least32(w->end, bounds->x1 - w->coverage.x);
    uint16_t weight[QTRI_COVERAGE_WINDOW];
    if (first >= end) {
        return;
    }
    if (w->in_part != 0) {
        stroker->edges->unite(stroker);
    }
    for (int32_t i = first; i < end; i++) {
        weight[i - first] =
            (uint16_t)qtri_stroke_weight((uint32_t)w->cover[i], stroker->to.alpha_q16);
    }
    if (stroker->has_one_look) {
        draw_span(stroker, &stroker->shape[0], w->coverage.x + first, w->coverage.x + end, weight);
    } else {
        if (w->shared != 0) {
            find_nearest(stroker);
        }
        draw_looks(stroker, first, end, weight);
    }
}

/* Adds a shape to the row's window, and its columns to those from *first to *end. */
static void add_shape(qtri_stroker *stroker, qtri_stroke_shape *s, int32_t *first, int32_t *end)
{
    qtri_stroke_window *w = &stroker->window;
    if (stroker->edges != NULL) {
        stroker->edges->add(w, s);
    } else {
        add_hard(w, s);
    }
    if (s->min_x < s->max_x) {
        *first = qtri_least32(*first, qtri_greatest32((s->min_x >> 8) - w->coverage.x, 0));
        *end = qtri_greatest32(*end, qtri_least32((s->max_x + 255) >> 8, w->coverage.end) -
                                         w->coverage.x);
    }
}

/* Adds a part; *near: where its columns are noted. */
static void add_part(qtri_stroker *stroker, uint32_t part, qtri_stroke_near *near)
{
    qtri_stroke_window *w = &stroker->window;
    qtri_stroke_shape *s = shape_of(stroker, part);
    int32_t first = QTRI_COVERAGE_WINDOW;
    int32_t end = 0;
    add_shape(stroker, s, &first, &end);
    if (s->apart != 0) {
        qtri_stroke_shape_disc(&stroker->disc, s);
        add_shape(stroker, &stroker->disc, &first, &end);
    }
    near->first = (uint8_t)first;
    near->end = (uint8_t)end;
    if (first < end) {
        w->first = qtri_least32(w->first, first);
        w->end = qtri_greatest32(w->end, end);
        if (!stroker->has_one_look) {
            for (int32_t i = first; i < end; i++) {
                w->part[i] = part; /* of those that several touch another may be nearer */
            }
        }
    }
}

/* The row's window: columns from x on. */
static void draw_row(qtri_stroker *stroker, int32_t row, int32_t x)
{
    qtri_stroke_window *w = &stroker->window;
    w->row = row;
    w->coverage.x = x;
    w->coverage.end = x + QTRI_COVERAGE_WINDOW;
    w->first = QTRI_COVERAGE_WINDOW;
    w->end = 0;
    w->in_part = w->shared = 0;
    stroker->active_count = 0;
    for (uint32_t i = 0; i < stroker->near_count; i++) {
        qtri_stroke_near *near = &stroker->of.parts.near[i];
        if (near->y0 <= row && row < near->y1) {
            stroker->of.parts.active[stroker->active_count++] = (uint8_t)i;
            add_part(stroker, near->part, near);
        }
    }
    if (stroker->others != UINT32_MAX) {
        uint32_t at = stroker->active_count;
        uint32_t part;
        qtri_stroke_near unused;
        while ((part = next_part(stroker, &at, 0, QTRI_COVERAGE_WINDOW)) != UINT32_MAX) {
            add_part(stroker, part, &unused);
        }
    }
    draw_window(stroker);
    for (int32_t i = w->first; i < w->end; i++) {
        w->cover[i] = 0;
    }
}

/* Rows y0 .. y1-1 of the strip from column x on, of the parts that are listed. */
static void draw_strip(qtri_stroker *stroker, int32_t x, int32_t y0, int32_t y1)
{
    int32_t first = y1;
    int32_t end = y0;
    for (uint32_t i = 0; i < stroker->near_count; i++) {
        first = qtri_least32(first, stroker->of.parts.near[i].y0);
        end = qtri_greatest32(end, stroker->of.parts.near[i].y1);
    }
    if (stroker->others == UINT32_MAX) {
        y0 = qtri_greatest32(first, y0);
        y1 = qtri_least32(end, y1);
    }
    for (int32_t row = y0; row < y1; row++) {
        draw_row(stroker, row, x);
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

void qtri_stroker_draw_part(qtri_stroker *stroker, const qtri_stroke_place *place)
{
    if (stroker->edges != NULL && stroker->edges->point(stroker, place)) {
        return;
    }
    qtri_stroke_box box = box_of(place);
    box = clip_box(stroker, &box);
    qtri_stroke_shape *shape = &stroker->shape[0];
    qtri_stroke_shape_init(shape, place, stroker->edges != NULL ? QTRI_STROKE_CHORDS : 0);
    shape->part = 0;
    stroker->next_shape = 0;
    stroker->has_ring = false;
    stroker->has_one_look = true;
    stroker->near_count = 1;
    stroker->others = UINT32_MAX;
    stroker->of.parts.near[0].part = 0;
    stroker->of.parts.near[0].y0 = box.y0;
    stroker->of.parts.near[0].y1 = box.y1;
    for (int32_t x = box.x0; x < box.x1; x += QTRI_COVERAGE_WINDOW) {
        draw_strip(stroker, x, box.y0, box.y1);
    }
}

/* Whether all parts have one colour and depth, which the stroker's look has then. */
static bool find_look(qtri_stroker *stroker)
{
    const qtri_stroke_source *source = stroker->source;
    qtri_stroke_place place;
    qtri_stroke_look first;
    bool is_first = true;
    for (uint32_t part = 0; part < source->count; part++) {
        qtri_stroke_end end[2];
        if (!source->place(source->from, part, &place)) {
            continue;
        }
        qtri_stroke_look *look = is_first ? &first : &stroker->look;
        source->ends(source->from, part, end);
        qtri_stroke_look_init(look, end);
        if (!look->is_level || look->z_16p16 != first.z_16p16 ||
            look->color_8p8[0] != first.color_8p8[0] || look->color_8p8[1] != first.color_8p8[1] ||
            look->color_8p8[2] != first.color_8p8[2]) {
            return false;
        }
        is_first = false;
    }
    if (!is_first) {
        stroker->look = first;
    }
    return true;
}

void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source)
{
    if (source->count == 1) {
        qtri_stroke_place place;
        qtri_stroke_end end[2];
        if (source->place(source->from, 0, &place)) {
            source->ends(source->from, 0, end);
            qtri_stroke_look_init(&stroker->look, end);
            qtri_stroker_draw_part(stroker, &place);
        }
        return;
    }
    stroker->source = source;
    stroker->has_ring = false;
    stroker->next_shape = 0;
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        stroker->shape[i].part = UINT32_MAX;
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
            draw_strip(stroker, x, y, end);
            y = end;
        }
    }
}

/* On the screen -------------------------------------------------------------------------------- */

/* A polyline on the screen. */
typedef struct polyline {
    const qtri_screen_vertex *v;
    uint32_t count;
    int32_t radius;
    uint8_t cap;
    bool closed;
} polyline;

static int32_t hold(int32_t x)
{
    return qtri_hold32(x, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
}

static qtri_screen_point point_of(const qtri_screen_vertex *v)
{
    const qtri_screen_point point = {hold(v->x_24p8), hold(v->y_24p8)};
    return point;
}

static bool place(const void *from, uint32_t part, qtri_stroke_place *out)
{
    const polyline *line = from;
    const uint32_t next = part + 1 < line->count ? part + 1 : 0;
    out->end[0] = point_of(&line->v[part]);
    out->end[1] = point_of(&line->v[line->count == 1 ? 0 : next]);
    out->radius_24p8 = line->radius;
    const bool is_first = part == 0 && !line->closed;
    const bool is_last = part + 2 >= line->count && !line->closed;
    out->caps[0] = is_first ? line->cap : QTRI_CAP_ROUND;
    out->caps[1] = is_last ? line->cap : QTRI_CAP_ROUND;
    return true;
}

static void set_end(qtri_stroke_end *end, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    end->depth_16p8 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    for (int i = 0; i < 3; i++) {
        end->color_8p16[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
}

static void ends(const void *from, uint32_t part, qtri_stroke_end end[2])
{
    const polyline *line = from;
    set_end(&end[0], &line->v[part]);
    set_end(&end[1], &line->v[part + 1 < line->count ? part + 1 : 0]);
}

void qtri_raster_polyline(const qtri_surface *surface, const qtri_material *material,
                          const qtri_stroke *stroke, const qtri_screen_vertex *v, uint32_t count)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_ASSERT(v != NULL || count == 0);
    qtri_stroker stroker;
    const polyline line = {v, count, qtri_stroke_radius(stroke->width), qtri_stroke_cap(stroke),
                           stroke->closed && count > 2};
    const qtri_stroke_source source = {&line, line.closed || count == 1 ? count : count - 1, place,
                                       ends};
    if (count > 0 && line.radius > 0 && qtri_stroker_init(&stroker, surface, material, stroke)) {
        qtri_stroker_draw(&stroker, &source);
    }
}

void qtri_raster_point(const qtri_surface *surface, const qtri_material *material,
                       const qtri_stroke *stroke, const qtri_screen_vertex *v)
{
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_ASSERT(v != NULL);
    qtri_stroke point = *stroke;
    point.cap = qtri_stroke_cap(stroke) == QTRI_CAP_ROUND ? QTRI_CAP_ROUND : QTRI_CAP_SQUARE;
    qtri_raster_polyline(surface, material, &point, v, 1);
}
