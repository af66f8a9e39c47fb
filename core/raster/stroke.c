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

/* Rows ----------------------------------------------------------------------------------------- */

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
        (void)qtri_stroker_find_part(stroker, part, &place, ends);
        qtri_stroke_look_init(&stroker->look, ends);
        draw_span(stroker, qtri_stroker_shape(stroker, part), w->coverage.x + from,
                  w->coverage.x + i, weight + (from - first));
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
            qtri_stroker_find_shapes(stroker);
        }
        if (!w->is_complete && width > MIN_WIDTH) {
            width >>= 1;
            continue;
        }
        for (int i = 0; !stroker->has_one_look && i < QTRI_STROKE_SHAPES; i++) {
            stroker->shape[i].min_x = w->is_complete ? INT32_MAX : INT32_MIN;
            stroker->shape[i].max_x = w->is_complete ? INT32_MIN : INT32_MAX;
        }
        draw_window(stroker);
        x += width;
    }
}

/* Draws rows y0 .. y1-1 of the strip from column x on, whose parts are listed. */
static void draw_strip(qtri_stroker *stroker, int32_t x, int32_t y0, int32_t y1)
{
    int32_t first = y1, end = y0;
    for (uint32_t i = 0; i < stroker->near_count; i++) {
        first = qtri_least32(first, stroker->near[i].box.y0);
        end = qtri_greatest32(end, stroker->near[i].box.y1);
    }
    if (stroker->others == QTRI_STROKE_NONE) {
        y0 = qtri_greatest32(first, y0);
        y1 = qtri_least32(end, y1);
    }
    stroker->window.same_end = INT32_MIN;
    for (stroker->window.row = y0; stroker->window.row < y1; stroker->window.row++) {
        draw_row(stroker, x);
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
    qtri_stroke_box box = qtri_stroke_box_of(place);
    box = clip_box(stroker, &box);
    qtri_stroker_init_shape(stroker, &stroker->shape[0], place);
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
        if (qtri_stroker_find_part(stroker, 0, &place, end)) {
            qtri_stroke_look_init(&stroker->look, end);
            qtri_stroker_draw_part(stroker, &place);
        }
        return;
    }
    stroker->has_one_look = find_look(stroker);
    qtri_stroke_box all = qtri_stroker_find_blocks(stroker);
    all = clip_box(stroker, &all);
    for (int32_t x = all.x0; x < all.x1; x += QTRI_COVERAGE_WINDOW) {
        int32_t height = all.y1 - all.y0;
        for (int32_t y = all.y0; y < all.y1;) {
            const int32_t end = qtri_least32(y + height, all.y1);
            const qtri_stroke_box strip = {(int16_t)x, (int16_t)y,
                                           (int16_t)(x + QTRI_COVERAGE_WINDOW), (int16_t)end};
            if (!qtri_stroker_list_parts(stroker, &strip) && height > 1) {
                height = (height + 1) >> 1; /* fewer rows, fewer parts */
                continue;
            }
            draw_strip(stroker, x, y, end);
            y = end;
        }
    }
}

/* On the screen -------------------------------------------------------------------------------- */

/* A polyline on the screen, and the qtri_stroke_source of its parts. */
typedef struct polyline {
    const qtri_screen_vertex *v;
    uint32_t count;
} polyline;

static bool find_part(const void *from, uint32_t part, qtri_point at[2], qtri_stroke_end end[2])
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
        qtri_stroker_draw(&stroker, find_part, &line, count, stroke->closed);
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
