/* SPDX-License-Identifier: MIT */
/*
 * Which parts of a stroke a strip of columns has, and of these a row: those that touch it, by their
 * columns.
 */
#include "stroke.h"

/* How far a part reaches around its line: a corner of a square cap is 3/2 radii away at most. */
static int32_t reach_of(const qtri_stroke_place *place)
{
    return place->radius_24p8 + (place->radius_24p8 >> 1) + 1;
}

/*
 * Whether a part may touch the rows of the bounds. Its ends may be moved out by a radius, and from
 * there qtri_stroke_shape_columns() looks a radius further; one row more is for what is rounded.
 */
static bool touches_rows(const qtri_stroker *stroker, const qtri_stroke_place *place)
{
    const int32_t reach = 2 * place->radius_24p8 + 256;
    const int32_t y0 = place->end[0].y_24p8;
    const int32_t y1 = place->end[1].y_24p8;
    return qtri_least32(y0, y1) <= stroker->bounds.y1 * 256 + reach &&
           qtri_greatest32(y0, y1) >= stroker->bounds.y0 * 256 - reach;
}

/* Whether a part may touch the strip; where it is. */
static bool is_in_strip(const qtri_stroker *stroker, uint32_t part, qtri_stroke_place *place)
{
    const qtri_stroke_source *source = stroker->source;
    if (!source->place(source->from, part, place)) {
        return false;
    }
    const int32_t left = stroker->column * 256;
    const int32_t x0 = place->end[0].x_24p8;
    const int32_t x1 = place->end[1].x_24p8;
    return qtri_least32(x0, x1) <= left + QTRI_STROKE_WINDOW * 256 + reach_of(place) &&
           qtri_greatest32(x0, x1) >= left - reach_of(place);
}

static inline bool touches_strip(const qtri_stroker *stroker, uint32_t part,
                                 qtri_stroke_place *place)
{
    const bool may_touch =
        part >= QTRI_STROKE_MARKED || (stroker->marks[part >> 5] >> (part & 31) & 1) != 0;
    return may_touch && is_in_strip(stroker, part, place);
}

qtri_stroke_shape *qtri_stroker_shape(qtri_stroker *stroker, uint32_t part)
{
    const qtri_stroke_source *source = stroker->source;
    qtri_stroke_shape *shape = &stroker->shape[part % QTRI_STROKE_SHAPES];
    if (shape->part != part) {
        qtri_stroke_place place;
        (void)source->place(source->from, part, &place);
        qtri_stroke_shape_init(shape, &place);
        source->ends(source->from, part, shape->end);
        const int32_t *first = shape->end[0].color_8p16;
        const int32_t *last = shape->end[1].color_8p16;
        shape->even = first[0] == last[0] && first[1] == last[1] && first[2] == last[2];
        shape->level =
            shape->even && shape->end[0].depth_16p8 >> 8 == shape->end[1].depth_16p8 >> 8;
        shape->part = part;
    }
    return shape;
}

/*
 * The parts that may touch the strip: those that are listed, and behind them any. *at is 0 at
 * first; UINT32_MAX: none.
 */
static uint32_t next_part(const qtri_stroker *stroker, uint32_t *at)
{
    if (*at < stroker->part_count) {
        return stroker->part[(*at)++];
    }
    if (stroker->rest == UINT32_MAX) {
        return UINT32_MAX;
    }
    qtri_stroke_place place;
    uint32_t part = stroker->rest + (*at - stroker->part_count);
    while (part < stroker->source->count && !touches_strip(stroker, part, &place)) {
        part++;
    }
    *at = part + 1 - stroker->rest + stroker->part_count;
    return part < stroker->source->count ? part : UINT32_MAX;
}

/* Whether a part touches the row in the strip; its columns. */
static bool find_columns(qtri_stroker *stroker, uint32_t part, int32_t *first, int32_t *end)
{
    const int32_t left = stroker->column;
    return qtri_stroke_shape_columns(qtri_stroker_shape(stroker, part), stroker->row, first, end) &&
           *first < left + QTRI_STROKE_WINDOW && left < *end;
}

qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at)
{
    if (stroker->touch_count != QTRI_STROKE_MANY) {
        const uint32_t touch = stroker->first_touch + *at;
        (*at)++;
        return touch < stroker->touch_end ? qtri_stroker_shape(stroker, stroker->touch[touch].part)
                                          : NULL;
    }
    for (;;) {
        int32_t first;
        int32_t end;
        const uint32_t part = next_part(stroker, at);
        if (part == UINT32_MAX) {
            return NULL;
        }
        if (find_columns(stroker, part, &first, &end)) {
            return qtri_stroker_shape(stroker, part);
        }
    }
}

/* Of the touches, those that begin at `from` and their columns touch. */
static uint32_t group_end(const qtri_stroker *stroker, uint32_t from)
{
    int32_t end = stroker->touch[from].end;
    uint32_t to = from + 1;
    while (to < stroker->touch_count && stroker->touch[to].first < end) {
        end = qtri_greatest32(end, stroker->touch[to].end);
        to++;
    }
    return to;
}

void qtri_stroker_set_group(qtri_stroker *stroker, uint32_t from)
{
    stroker->first_touch = from;
    stroker->touch_end = stroker->touch_count == QTRI_STROKE_MANY ? 1 : group_end(stroker, from);
}

bool qtri_stroker_find_touches(qtri_stroker *stroker)
{
    uint32_t at = 0;
    uint32_t count = 0;
    for (uint32_t part; (part = next_part(stroker, &at)) != UINT32_MAX;) {
        int32_t first;
        int32_t end;
        if (!find_columns(stroker, part, &first, &end)) {
            continue;
        }
        const qtri_stroke_touch touch = {part, (int16_t)first, (int16_t)end};
        if (count == QTRI_STROKE_PARTS) {
            stroker->touch_count = QTRI_STROKE_MANY;
            return true;
        }
        uint32_t i = count++;
        for (; i > 0 && stroker->touch[i - 1].first > touch.first; i--) {
            stroker->touch[i] = stroker->touch[i - 1];
        }
        stroker->touch[i] = touch;
    }
    stroker->touch_count = count;
    return count > 0;
}

/* Rows and columns that parts may touch, inside the bounds. */
static void widen(int32_t range[2], int32_t a, int32_t b, int32_t reach)
{
    range[0] = qtri_least32(range[0], (qtri_least32(a, b) - reach) >> 8);
    range[1] = qtri_greatest32(range[1], ((qtri_greatest32(a, b) + reach) >> 8) + 1);
}

void qtri_stroker_begin(qtri_stroker *stroker, const qtri_stroke_source *source, int32_t columns[2])
{
    stroker->source = source;
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        stroker->shape[i].part = UINT32_MAX;
    }
    columns[0] = INT32_MAX;
    columns[1] = INT32_MIN;
    for (uint32_t part = 0; part < source->count; part++) {
        qtri_stroke_place place;
        if ((part & 31) == 0 && part < QTRI_STROKE_MARKED) {
            stroker->marks[part >> 5] = 0;
        }
        if (source->place(source->from, part, &place) && touches_rows(stroker, &place)) {
            if (part < QTRI_STROKE_MARKED) {
                stroker->marks[part >> 5] |= (uint32_t)1 << (part & 31);
            }
            widen(columns, place.end[0].x_24p8, place.end[1].x_24p8, reach_of(&place));
        }
    }
    columns[0] = qtri_greatest32(columns[0], stroker->bounds.x0);
    columns[1] = qtri_least32(columns[1], stroker->bounds.x1);
}

/* Of a band of less, looking at all is as quick. */
enum { FEW_ROWS = 4 };

/*
 * Rows that a part may touch in the strip: of a long one those where its line is near the strip.
 * What touches a pixel lies within 3/2 radii of the line, and its row and column end within a pixel
 * of there; one more is more than y is off.
 */
static void widen_rows(const qtri_stroker *stroker, int32_t rows[2], const qtri_stroke_place *place)
{
    const int32_t reach = reach_of(place);
    const int32_t left = stroker->column * 256 - reach - 512;
    const int32_t right = (stroker->column + QTRI_STROKE_WINDOW) * 256 + reach + 512;
    const bool few = stroker->bounds.y1 - stroker->bounds.y0 < FEW_ROWS;
    int32_t all[2] = {INT32_MAX, INT32_MIN};
    int32_t nearby[2] = {INT32_MAX, INT32_MIN};
    for (int i = 0; i < 2; i++) {
        const int32_t x = place->end[i].x_24p8;
        const int32_t y = place->end[i].y_24p8;
        widen(all, y, y, reach);
        if (!few &&
            (x < left || x > right)) { /* and the other end is not, or lies beyond the other side */
            const int32_t cut = qtri_stroke_line_y(place, x < left ? left : right);
            widen(nearby, cut, cut, reach + 512);
        } else {
            widen(nearby, y, y, reach);
        }
    }
    rows[0] = qtri_least32(rows[0], qtri_greatest32(all[0], nearby[0]));
    rows[1] = qtri_greatest32(rows[1], qtri_least32(all[1], nearby[1]));
}

void qtri_stroker_find_parts(qtri_stroker *stroker, int32_t rows[2])
{
    const qtri_stroke_source *source = stroker->source;
    stroker->part_count = 0;
    stroker->rest = UINT32_MAX;
    rows[0] = INT32_MAX;
    rows[1] = INT32_MIN;
    for (uint32_t part = 0; part < source->count; part++) {
        qtri_stroke_place place;
        if (!touches_strip(stroker, part, &place)) {
            continue;
        }
        widen_rows(stroker, rows, &place);
        if (stroker->part_count < QTRI_STROKE_PARTS) {
            stroker->part[stroker->part_count++] = part;
        } else if (stroker->rest == UINT32_MAX) {
            stroker->rest = part;
        }
    }
    rows[0] = qtri_greatest32(rows[0], stroker->bounds.y0);
    rows[1] = qtri_least32(rows[1], stroker->bounds.y1);
}
