/* SPDX-License-Identifier: MIT */
/*
 * Parts of a stroke: their ends and caps, boxes, lists by strip and row, and the cache of shapes.
 */
#include "stroke.h"

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

bool qtri_stroker_find_part(const qtri_stroker *stroker, uint32_t part, qtri_stroke_place *place,
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
               qtri_stroker_find_part(stroker, part - 1, &before, NULL) &&
               before.end[1].x_24p8 == place->end[0].x_24p8 &&
               before.end[1].y_24p8 == place->end[0].y_24p8) {
        place->caps[0] = QTRI_CAP_BUTT;
    }
}

/* A corner of a square cap is 3/2 radii away at most; a small disc's polygon reaches out of it. */
qtri_stroke_box qtri_stroke_box_of(const qtri_stroke_place *place)
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

qtri_stroke_box qtri_stroker_find_blocks(qtri_stroker *stroker)
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
            if (qtri_stroker_find_part(stroker, part, &place, NULL)) {
                const qtri_stroke_box box = qtri_stroke_box_of(&place);
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
            if (qtri_stroker_find_part(stroker, part, &place, NULL)) {
                *own = qtri_stroke_box_of(&place);
                if (do_overlap(own, box)) {
                    return part;
                }
            }
        }
    }
    return QTRI_STROKE_NONE;
}

/* Shapes --------------------------------------------------------------------------------------- */

void qtri_stroker_init_shape(qtri_stroker *stroker, qtri_stroke_shape *shape,
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
    uint32_t next = stroker->next_shape;
    for (uint32_t i = 0; i < QTRI_STROKE_SHAPES; i++) {
        qtri_stroke_shape *s = &stroker->shape[i];
        if (s->part == QTRI_STROKE_NONE || s->bottom <= w->row * 256) {
            return s;
        }
    }
    do {
        next = next + 1 < QTRI_STROKE_SHAPES ? next + 1 : 0;
    } while (is_in_row(w, &stroker->shape[next]));
    stroker->next_shape = next;
    return &stroker->shape[next];
}

qtri_stroke_shape *qtri_stroker_shape(qtri_stroker *stroker, uint32_t part)
{
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        if (stroker->shape[i].part == part) {
            return &stroker->shape[i];
        }
    }
    qtri_stroke_place place;
    qtri_stroke_shape *shape = free_shape(stroker);
    (void)qtri_stroker_find_part(stroker, part, &place, NULL);
    set_joints(stroker, part, &place);
    qtri_stroker_init_shape(stroker, shape, &place);
    shape->part = part;
    return shape;
}

bool qtri_stroker_list_parts(qtri_stroker *stroker, const qtri_stroke_box *box)
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

/* The box of the window's columns in its row. */
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
            return qtri_stroker_shape(stroker, near->part);
        }
    }
    part = part > stroker->others ? part : stroker->others;
    part = next_near(stroker, part, &box, &own);
    return part != QTRI_STROKE_NONE ? qtri_stroker_shape(stroker, part) : NULL;
}

/* Adds a part's shape if it is in the row; false: the window has no room for another one. */
static bool add_shape(qtri_stroker *stroker, uint32_t part)
{
    qtri_stroke_window *w = &stroker->window;
    qtri_stroke_shape *s = qtri_stroker_shape(stroker, part);
    const int32_t first = s->top >> 8, end = (s->bottom + 255) >> 8; /* rows */
    if (first <= w->row && w->row < end) {
        w->shape[w->shape_count++] = s;
        w->same_end = qtri_least32(w->same_end, end);
    } else if (first > w->row) {
        w->same_end = qtri_least32(w->same_end, first);
    }
    return w->shape_count < QTRI_STROKE_SHAPES;
}

/* Lists all shapes of the window; false: there is no room. Mostly there is, and neither this row
   nor rows with the same shapes look one up again. */
static bool find_all(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    const qtri_stroke_box box = row_box(w);
    qtri_stroke_box own;
    w->shape_count = 0;
    w->same_end = stroker->others == QTRI_STROKE_NONE ? INT32_MAX : w->row + 1;
    for (uint32_t i = 0; i < stroker->near_count; i++) {
        const qtri_stroke_near *near = &stroker->near[i];
        if (near->box.y0 > w->row) {
            w->same_end = qtri_least32(w->same_end, near->box.y0);
        } else if (do_overlap(&near->box, &box) && !add_shape(stroker, near->part)) {
            return false;
        }
    }
    for (uint32_t part = stroker->others;
         (part = next_near(stroker, part, &box, &own)) != QTRI_STROKE_NONE; part++) {
        if (!add_shape(stroker, part)) {
            return false;
        }
    }
    return true;
}

void qtri_stroker_find_shapes(qtri_stroker *stroker)
{
    qtri_stroke_window *w = &stroker->window;
    w->is_complete = find_all(stroker);
    if (!w->is_complete) {
        w->shape_count = 0;
        w->same_end = w->row;
    }
}
