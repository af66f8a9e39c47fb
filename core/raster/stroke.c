/* SPDX-License-Identifier: MIT */
#include "stroke.h"

bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke)
{
    stroker->edges = stroke->edges;
    stroker->ring.radius = 0;
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

/* Whether a part is to be seen and meets a box; where it is. */
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

/* Boxes of blocks of parts; that of one of which nothing is seen is empty. */
static void find_blocks(qtri_stroker *stroker)
{
    const qtri_stroke_box all = {INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX};
    const uint32_t count = stroker->source->count;
    stroker->block_parts = (count + QTRI_STROKE_BLOCKS - 1) / QTRI_STROKE_BLOCKS;
    for (uint32_t part = 0; part < count;) {
        qtri_stroke_box *block = &stroker->block[part / stroker->block_parts];
        const uint32_t rest = count - part;
        const uint32_t end = part + (rest < stroker->block_parts ? rest : stroker->block_parts);
        const qtri_stroke_box none = {INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN};
        *block = none;
        for (; part < end; part++) {
            qtri_stroke_box box;
            if (is_near(stroker, part, &all, &box)) {
                block->x0 = box.x0 < block->x0 ? box.x0 : block->x0;
                block->y0 = box.y0 < block->y0 ? box.y0 : block->y0;
                block->x1 = box.x1 > block->x1 ? box.x1 : block->x1;
                block->y1 = box.y1 > block->y1 ? box.y1 : block->y1;
            }
        }
    }
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

static qtri_stroke_shape *shape_of(qtri_stroker *stroker, uint32_t part)
{
    const qtri_stroke_source *source = stroker->source;
    qtri_stroke_shape *shape = &stroker->shape[part % QTRI_STROKE_SHAPES];
    if (shape->part != part) {
        qtri_stroke_place place;
        qtri_stroke_end end[2];
        (void)source->place(source->from, part, &place);
        source->ends(source->from, part, end);
        qtri_stroke_shape_init(shape, &place, stroker->edges != NULL ? QTRI_STROKE_CHORDS : 0);
        qtri_stroke_look_init(&shape->look, end);
        shape->part = part;
    }
    return shape;
}

/* Lists the parts that meet the box of part `own`. */
static void find_neighbours(qtri_stroker *stroker, uint32_t own, const qtri_stroke_box *box)
{
    qtri_stroke_box other;
    stroker->neighbour_count = 0;
    stroker->rest = UINT32_MAX;
    for (uint32_t part = 0; (part = next_near(stroker, part, box, &other)) != UINT32_MAX; part++) {
        if (part == own) {
            continue;
        }
        if (stroker->neighbour_count == QTRI_STROKE_NEIGHBOURS) {
            stroker->rest = part;
            return;
        }
        qtri_stroke_neighbour *n = &stroker->neighbour[stroker->neighbour_count++];
        n->part = part;
        n->y0 = other.y0;
        n->y1 = other.y1;
    }
}

/* Rows ----------------------------------------------------------------------------------------- */

/* The columns that a shape touches in the row; of hard edges, those whose centres are inside. */
static bool find_columns(const qtri_stroker *stroker, qtri_stroke_shape *s, int32_t columns[2])
{
    const int32_t y = stroker->row * 256;
    int32_t x[2];
    if (stroker->edges != NULL) {
        if (!qtri_stroke_shape_reach(s, y, y + 256, x)) {
            return false;
        }
        columns[0] = x[0] >> 8;
        columns[1] = (x[1] + 255) >> 8;
        return columns[0] < columns[1];
    }
    if (y + 128 < s->top || y + 128 >= s->bottom) {
        return false;
    }
    columns[0] = (qtri_stroke_shape_x(s, 0, y + 128, true) + 127) >> 8;
    columns[1] = (qtri_stroke_shape_x(s, 1, y + 128, true) + 127) >> 8;
    return columns[0] < columns[1];
}

/* Of a part, with the disc that is apart. */
static bool find_part_columns(qtri_stroker *stroker, qtri_stroke_shape *s, int32_t columns[2])
{
    bool found = find_columns(stroker, s, columns);
    if (s->apart != 0) {
        int32_t more[2];
        qtri_stroke_shape_disc(&stroker->disc, s);
        if (find_columns(stroker, &stroker->disc, more)) {
            columns[0] = found ? qtri_least32(columns[0], more[0]) : more[0];
            columns[1] = found ? qtri_greatest32(columns[1], more[1]) : more[1];
            found = true;
        }
    }
    return found;
}

/* The next neighbour that may touch the row: *at is 0 at first. UINT32_MAX: none. */
static uint32_t next_neighbour(const qtri_stroker *stroker, uint32_t *at)
{
    while (*at < stroker->neighbour_count) {
        const qtri_stroke_neighbour *n = &stroker->neighbour[(*at)++];
        if (n->y0 <= stroker->row && stroker->row < n->y1) {
            return n->part;
        }
    }
    if (stroker->rest == UINT32_MAX) {
        return UINT32_MAX;
    }
    qtri_stroke_box own;
    const qtri_stroke_box row = {(int16_t)stroker->first, (int16_t)stroker->row,
                                 (int16_t)stroker->end, (int16_t)(stroker->row + 1)};
    uint32_t part = stroker->rest + (*at - stroker->neighbour_count);
    part = next_near(stroker, part, &row, &own);
    if (part == stroker->own->part) {
        part = next_near(stroker, part + 1, &row, &own);
    }
    *at = part == UINT32_MAX ? UINT32_MAX : part + 1 - stroker->rest + stroker->neighbour_count;
    return part;
}

/* Whether a neighbour reaches into the row's columns. */
static bool reaches(qtri_stroker *stroker, uint32_t part)
{
    int32_t columns[2];
    return find_part_columns(stroker, shape_of(stroker, part), columns) &&
           columns[0] < stroker->end && columns[1] > stroker->first;
}

/* Where a shape has a disc apart, that follows: see below. */
#define DISC ((uint32_t)1 << 31)

/* 0: the own part; others by what next_neighbour() counts, or the group's numbers. */
qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at)
{
    qtri_stroke_shape *s = NULL;
    if ((*at & DISC) != 0) {
        *at &= ~DISC;
        return &stroker->disc;
    }
    if (*at == 0) {
        *at = 1;
        s = stroker->own;
    } else if (stroker->group_count <= QTRI_STROKE_GROUP) {
        if (*at > stroker->group_count) {
            return NULL;
        }
        s = shape_of(stroker, stroker->group[*at - 1]);
        (*at)++;
    } else {
        uint32_t next = *at - 1;
        uint32_t part;
        do {
            part = next_neighbour(stroker, &next);
        } while (part != UINT32_MAX && (part < stroker->own->part || !reaches(stroker, part)));
        if (part == UINT32_MAX) {
            return NULL;
        }
        *at = next + 1;
        s = shape_of(stroker, part);
    }
    if (s->apart != 0) {
        qtri_stroke_shape_disc(&stroker->disc, s);
        *at |= DISC;
    }
    return s;
}

static bool look_alike(const qtri_stroke_shape *a, const qtri_stroke_shape *b)
{
    const qtri_stroke_look *l = &a->look;
    const qtri_stroke_look *k = &b->look;
    return l->is_level && k->is_level && l->z_16p16 == k->z_16p16 &&
           l->color_8p8[0] == k->color_8p8[0] && l->color_8p8[1] == k->color_8p8[1] &&
           l->color_8p8[2] == k->color_8p8[2];
}

/* The later parts that reach into the row's columns. */
static void find_group(qtri_stroker *stroker)
{
    uint32_t at = 0;
    uint32_t count = 0;
    bool alike = true;
    for (uint32_t part; (part = next_neighbour(stroker, &at)) != UINT32_MAX;) {
        if (part < stroker->own->part || !reaches(stroker, part)) {
            continue;
        }
        if (count == QTRI_STROKE_GROUP) {
            count++;
            alike = false;
            break;
        }
        alike = alike && look_alike(stroker->own, shape_of(stroker, part));
        stroker->group[count++] = part;
    }
    stroker->group_count = count;
    stroker->is_alike = alike;
    stroker->is_alone = count == 0 && stroker->own->apart == 0;
}

/* Of columns first .. end-1, at most a window of them, those that no earlier part touches. */
static uint32_t own_columns(qtri_stroker *stroker)
{
    const int32_t count = stroker->end - stroker->first;
    uint32_t own = count == 32 ? UINT32_MAX : ((uint32_t)1 << count) - 1;
    uint32_t at = 0;
    for (uint32_t part; own != 0 && (part = next_neighbour(stroker, &at)) != UINT32_MAX;) {
        int32_t columns[2];
        if (part > stroker->own->part) {
            break;
        }
        if (find_part_columns(stroker, shape_of(stroker, part), columns)) {
            const int32_t first = qtri_hold32(columns[0] - stroker->first, 0, count);
            const int32_t end = qtri_hold32(columns[1] - stroker->first, 0, count);
            if (first < end) {
                own &= ~((UINT32_MAX >> (32 - (end - first))) << first);
            }
        }
    }
    return own;
}

/* Those whose centres lie inside. */
static void cover_hard(qtri_stroker *stroker)
{
    uint32_t at = 0;
    for (int32_t i = stroker->first; i < stroker->end; i++) {
        stroker->cover[i - stroker->first] = 0;
    }
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &at)) != NULL;) {
        int32_t columns[2];
        if (find_columns(stroker, s, columns)) {
            const int32_t end = qtri_least32(columns[1], stroker->end);
            for (int32_t i = qtri_greatest32(columns[0], stroker->first); i < end; i++) {
                stroker->cover[i - stroker->first] = QTRI_STROKE_FULL;
            }
        }
    }
}

/* Pixels of the window that are drawn, and what of each. */
typedef struct window {
    int32_t first, end; /* of those inside the bounds */
    uint16_t weight[QTRI_STROKE_WINDOW];
    uint32_t part[QTRI_STROKE_WINDOW]; /* whose colours they have; of `alike` ones not set */
} window;

/* Weights from what is covered. */
static void set_weights(window *w, const qtri_stroker *stroker, uint32_t own)
{
    for (int32_t i = w->first; i < w->end; i++) {
        const uint32_t cover = (uint32_t)stroker->cover[i - stroker->first];
        const bool is_own = (own >> (i - stroker->first) & 1) != 0;
        w->weight[i - w->first] =
            (uint16_t)(is_own ? qtri_stroke_weight(cover, stroker->to.alpha_q16) : 0);
    }
}

/* The part that is nearest to each pixel. */
QTRI_NOINLINE static void find_nearest(window *w, qtri_stroker *stroker)
{
    uint64_t least[QTRI_STROKE_WINDOW];
    uint32_t at = 0;
    const int32_t count = w->end - w->first;
    for (int32_t i = 0; i < count; i++) {
        least[i] = UINT64_MAX;
    }
    for (qtri_stroke_shape *s; (s = qtri_stroker_next(stroker, &at)) != NULL;) {
        for (int32_t i = 0; i < count; i++) {
            if (w->weight[i] != 0) {
                const uint64_t square = qtri_stroke_shape_distance(s, w->first + i, stroker->row);
                if (square < least[i]) {
                    least[i] = square;
                    w->part[i] = s->part;
                }
            }
        }
    }
}

static void draw_span(qtri_stroker *stroker, const qtri_stroke_shape *s, int32_t first, int32_t end,
                      const uint16_t *weight)
{
    uint16_t share[QTRI_STROKE_WINDOW];
    const qtri_stroke_span span = {&stroker->to.state, &s->look, first, stroker->row,
                                   end - first,        weight,   share, false};
    if (!s->look.is_level) {
        qtri_stroke_shape_shares(s, first, stroker->row, end - first, share);
    }
    qtri_stroke_target_draw(&stroker->to, &span);
}

/* Runs of pixels with colours of one part. */
static void draw_nearest(const window *w, qtri_stroker *stroker)
{
    for (int32_t i = w->first; i < w->end;) {
        const uint16_t *weight = &w->weight[i - w->first];
        const int32_t first = i;
        if (*weight == 0) {
            i++;
            continue;
        }
        const uint32_t part = w->part[i - w->first];
        while (i < w->end && w->weight[i - w->first] != 0 && w->part[i - w->first] == part) {
            i++;
        }
        draw_span(stroker, part == stroker->own->part ? stroker->own : shape_of(stroker, part),
                  first, i, weight);
    }
}

/* The row's columns first .. end-1, at most a window of them. */
static void draw_window(qtri_stroker *stroker)
{
    const qtri_rect *bounds = &stroker->to.state.bounds;
    window w;
    uint32_t own = own_columns(stroker);
    if (own == 0) {
        return;
    }
    const int32_t before = 31 - qtri_clz32(own & (0 - own)); /* of others */
    stroker->end = stroker->first + 32 - qtri_clz32(own);
    stroker->first += before;
    own >>= before;
    w.first = qtri_greatest32(stroker->first, bounds->x0);
    w.end = qtri_least32(stroker->end, bounds->x1);
    if (w.first >= w.end) {
        return;
    }
    find_group(stroker);
    if (stroker->edges != NULL) {
        stroker->edges->cover(stroker);
    } else {
        cover_hard(stroker);
    }
    set_weights(&w, stroker, own);
    if (stroker->is_alike) {
        draw_span(stroker, stroker->own, w.first, w.end, w.weight);
    } else {
        find_nearest(&w, stroker);
        draw_nearest(&w, stroker);
    }
}

/* The own part's rows. */
static void draw_own(qtri_stroker *stroker)
{
    const qtri_rect *bounds = &stroker->to.state.bounds;
    qtri_stroke_shape *own = stroker->own;
    int32_t top = own->top;
    int32_t bottom = own->bottom;
    if (own->apart != 0) {
        qtri_stroke_shape_disc(&stroker->disc, own);
        top = qtri_least32(top, stroker->disc.top);
        bottom = qtri_greatest32(bottom, stroker->disc.bottom);
    }
    const int32_t end = qtri_least32((bottom + 255) >> 8, bounds->y1);
    for (int32_t row = qtri_greatest32(top >> 8, bounds->y0); row < end; row++) {
        int32_t columns[2];
        stroker->row = row;
        if (!find_part_columns(stroker, own, columns)) {
            continue;
        }
        const int32_t last = qtri_least32(columns[1], bounds->x1);
        int32_t x = qtri_greatest32(columns[0], bounds->x0 & ~(QTRI_STROKE_WINDOW - 1));
        for (; x < last; x = (x | (QTRI_STROKE_WINDOW - 1)) + 1) {
            stroker->first = x;
            stroker->end = qtri_least32(columns[1], (x | (QTRI_STROKE_WINDOW - 1)) + 1);
            draw_window(stroker);
        }
    }
}

void qtri_stroker_draw_part(qtri_stroker *stroker, const qtri_stroke_place *place,
                            const qtri_stroke_end end[2])
{
    qtri_stroke_shape *own = &stroker->shape[QTRI_STROKE_SHAPES];
    if (stroker->edges != NULL && stroker->edges->point(stroker, place, end)) {
        return;
    }
    qtri_stroke_shape_init(own, place, stroker->edges != NULL ? QTRI_STROKE_CHORDS : 0);
    qtri_stroke_look_init(&own->look, end);
    own->part = 0;
    stroker->own = own;
    stroker->neighbour_count = 0;
    stroker->rest = UINT32_MAX;
    draw_own(stroker);
}

/* A source's only part. */
static void draw_only(qtri_stroker *stroker, const qtri_stroke_source *source)
{
    qtri_stroke_place place;
    qtri_stroke_end end[2];
    if (source->place(source->from, 0, &place)) {
        source->ends(source->from, 0, end);
        qtri_stroker_draw_part(stroker, &place, end);
    }
}

void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source)
{
    const qtri_rect *b = &stroker->to.state.bounds;
    const qtri_stroke_box bounds = {(int16_t)b->x0, (int16_t)b->y0, (int16_t)b->x1, (int16_t)b->y1};
    qtri_stroke_box box;
    if (source->count == 1) {
        draw_only(stroker, source);
        return;
    }
    stroker->source = source;
    stroker->own = &stroker->shape[QTRI_STROKE_SHAPES];
    for (int i = 0; i < QTRI_STROKE_SHAPES; i++) {
        stroker->shape[i].part = UINT32_MAX;
    }
    find_blocks(stroker);
    for (uint32_t part = 0; (part = next_near(stroker, part, &bounds, &box)) != UINT32_MAX;
         part++) {
        *stroker->own = *shape_of(stroker, part);
        find_neighbours(stroker, part, &box);
        draw_own(stroker);
    }
}
