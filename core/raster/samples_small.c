/* SPDX-License-Identifier: MIT */
/*
 * Small triangles on surfaces with four samples a pixel: fragments as those of list.c, with a bit
 * for each sample.
 *
 * Where the three edge functions E = X dy - Y dx of the vertices' differences are, at a pixel's
 * centre, tells it for all samples: the grid is a square's four corners, turned, so an edge adds p,
 * q, -q or -p (Pineda 1988). All is below 2^30: |X|, |Y| <= 74 256 and |dx|, |dy| <= 72 256, both
 * products in E; |p|, |q| <= 128 72 256.
 *
 * A pixel takes one colour: at its centre, or, where that is not covered, at the first sample that
 * is. Colours of fragments at the same one of these five places are found together, by values that
 * are set up for the triangle moved there: so they stay in the triangle's range, whatever it is.
 */
#include "samples.h"

#include "list.h"
#include "list_late.h"
#include "list_values.h"
#include "words.h"

enum {
    CENTER = QTRI_SAMPLES,
    PLACES,
    ALL = 15,
    COVERED = 1 << CENTER, /* the centre is */
    ROW_MAX = 2 * QTRI_PLACE_PIXELS + 3,
    MARGIN = 96, /* a sample is as far from the centre, 1/256 pixel */
    THICK = 32
};

/* Which place a pixel is coloured at whose centre is not covered, by the samples that are. */
static const uint8_t first_of[ALL + 1] = {0, 0, 1, 0, 2, 0, 1, 0, 3, 0, 1, 0, 2, 0, 1, 0};

/* ---- Where ---- */

qtri_placed qtri_samples_place(qtri_place *p, uint8_t spans[QTRI_PLACE_SPANS],
                               const qtri_raster *raster, const qtri_vertex *a,
                               const qtri_vertex *b, const qtri_vertex *c)
{
    const int32_t dx1 = b->at.x_24p8 - a->at.x_24p8;
    const int32_t dy1 = b->at.y_24p8 - a->at.y_24p8;
    const int32_t dx2 = c->at.x_24p8 - a->at.x_24p8;
    const int32_t dy2 = c->at.y_24p8 - a->at.y_24p8;
    if ((raster->rejects && raster->depth_write) || qtri_place_is_far(dx1, dy1, dx2, dy2)) {
        return QTRI_PLACED_LARGE;
    }
    const int32_t size = dx2 * dy1 - dx1 * dy2;
    const qtri_rect *bounds = &raster->bounds;
    const int32_t x = a->at.x_24p8;
    const int32_t y = a->at.y_24p8;
    const int32_t before = 255 - 128 - MARGIN;
    const int32_t after = 256 - 128 + MARGIN;
    const int32_t left = (x + qtri_least_from_0(dx1, dx2) + before) >> 8;
    const int32_t right = (x + qtri_greatest_from_0(dx1, dx2) + after) >> 8;
    const int32_t top = (y + qtri_least_from_0(dy1, dy2) + before) >> 8;
    const int32_t bottom = (y + qtri_greatest_from_0(dy1, dy2) + after) >> 8;
    const int32_t column = qtri_greatest32(left, bounds->x0);
    const int32_t row = qtri_greatest32(top, bounds->y0);
    const int32_t columns = qtri_least32(right, bounds->x1) - column;
    const int32_t rows = qtri_least32(bottom, bounds->y1) - row;
    if (size == 0 || columns <= 0 || rows <= 0) {
        return QTRI_PLACED_NOWHERE;
    }
    p->back = size < 0;
    p->size = qtri_magnitude32(size);
    p->dx1 = p->back ? dx2 : dx1;
    p->dy1 = p->back ? dy2 : dy1;
    p->dx2 = p->back ? dx1 : dx2;
    p->dy2 = p->back ? dy1 : dy2;
    p->column = column;
    p->row = row - raster->surface->first_row;
    p->x = column * 256 + 128 - x;
    p->y = row * 256 + 128 - y;
    p->cut = false;
    p->first = spans;
    spans[0] = (uint8_t)columns;
    spans[1] = (uint8_t)rows;
    return qtri_place_set_more(p, a, b, c) ? QTRI_PLACED_SMALL : QTRI_PLACED_LARGE;
}

/* ---- Coverage ---- */

/* Edge functions: 0 and more is inside. */
typedef struct edges {
    int32_t at[3]; /* with `most`, at the box's first pixel in a row */
    int32_t right[3], down[3];
    int32_t most[3];               /* the greatest of the next */
    int32_t more[QTRI_SAMPLES][3]; /* at samples */
} edges;

/* From (x, y) on, from the box's first pixel, along (dx, dy). */
static void set_edge(edges *e, int i, int32_t x, int32_t y, int32_t dx, int32_t dy)
{
    const int32_t p = 32 * dy - 96 * dx;
    const int32_t q = 96 * dy + 32 * dx;
    const int32_t most = qtri_greatest32(p < 0 ? -p : p, q < 0 ? -q : q);
    const bool is_inside = dy > 0 || (dy == 0 && dx < 0); /* on a left or upper edge */
    e->at[i] = y * dx - x * dy - (is_inside ? 0 : 1) + most;
    e->right[i] = dy * 256;
    e->down[i] = dx * -256;
    e->most[i] = most;
    e->more[0][i] = -p;
    e->more[1][i] = q;
    e->more[2][i] = -q;
    e->more[3][i] = p;
}

static void set_edges(edges *e, const qtri_place *p)
{
    const int32_t x1 = p->dx1 - p->x;
    const int32_t y1 = p->dy1 - p->y;
    set_edge(e, 0, -p->x, -p->y, p->dx1, p->dy1);
    set_edge(e, 1, x1, y1, p->dx2 - p->dx1, p->dy2 - p->dy1);
    set_edge(e, 2, -p->x, -p->y, -p->dx2, -p->dy2);
}

/* Pushes whether any of three edges is negative; `sign` in a register. */
#define PUSH_OUTSIDE(outside, a, b, c)                                                             \
    {                                                                                              \
        const uint32_t any = (uint32_t)((a) | (b) | (c));                                          \
        QTRI_PUSH_GREATER_EQUAL(outside, any, sign)                                                \
    }

/* The covered samples of a pixel, and COVERED; a to c: the edges at its centre. */
static inline uint32_t samples_of(const edges *e, int32_t a, int32_t b, int32_t c)
{
    uint32_t sign = 0x80000000u;
    uint32_t outside = 0;
    QTRI_OPAQUE(sign)
#define SAMPLE(k) PUSH_OUTSIDE(outside, a + e->more[k][0], b + e->more[k][1], c + e->more[k][2])
    PUSH_OUTSIDE(outside, a, b, c)
    SAMPLE(3)
    SAMPLE(2)
    SAMPLE(1)
    SAMPLE(0)
#undef SAMPLE
    return outside ^ (COVERED | ALL);
}

/*
 * Of the next row's pixels those that may be covered, as samples_of(); *first: the column. Returns
 * how many. With `most` added an edge is that of the sample that is farthest inside: pixels where
 * none of those is negative follow each other.
 */
QTRI_NOINLINE static int32_t cover_row(edges *e, int32_t columns, uint8_t *cover, int32_t *first)
{
    int32_t a = e->at[0];
    int32_t b = e->at[1];
    int32_t c = e->at[2];
    int32_t x = 0;
    e->at[0] = a + e->down[0];
    e->at[1] = b + e->down[1];
    e->at[2] = c + e->down[2];
    while ((a | b | c) < 0) {
        x++;
        if (x == columns) {
            return 0;
        }
        a += e->right[0];
        b += e->right[1];
        c += e->right[2];
    }
    *first = x;
    const uint8_t *const begin = cover;
    const uint8_t *const end = cover + (columns - x);
    do {
        const int32_t own_a = a - e->most[0];
        const int32_t own_b = b - e->most[1];
        const int32_t own_c = c - e->most[2];
        *cover++ = (uint8_t)samples_of(e, own_a, own_b, own_c);
        a += e->right[0];
        b += e->right[1];
        c += e->right[2];
    } while (cover != end && (a | b | c) >= 0);
    return (int32_t)(cover - begin);
}

/* ---- A triangle ---- */

/* What is asked for most comes first: it is reached at once. */
typedef struct work {
    const qtri_raster *raster;
    int32_t count;         /* fragments that wait */
    uint32_t places;       /* bits: where they take their colours */
    uint32_t more[PLACES]; /* depth that samples have; the centre 0 */
    qtri_ramp depth;
    bool is_thick; /* see set_depths() */
    bool is_set;   /* and values are, at the centre */
    edges edges;
    uint32_t place[QTRI_BATCH];  /* with their samples */
    uint8_t colored[QTRI_BATCH]; /* at which place */
    uint8_t cover[ROW_MAX];
    qtri_list_values values;
} work;

static void move(const work *w, int place, int32_t back)
{
    qtri_place *p = w->values.t->place;
    p->x += back * qtri_sample_offset[place][0];
    p->y += back * qtri_sample_offset[place][1];
}

/*
 * More that a ramp has at a place. Of a triangle that is thick, with THICK times its size the
 * greatest difference, steps of differences below 2^16 (see place_ramp.h) are below 2^28 as they
 * are: none wrapped, nor does the sum of four.
 */
static uint32_t more_at(const qtri_ramp *ramp, int place)
{
    const int32_t dx = (int32_t)ramp->dx;
    const int32_t dy = (int32_t)ramp->dy;
    const int32_t p = (dx + 3 * dy) >> 3;
    const int32_t q = (3 * dx - dy) >> 3;
    switch (place) {
    case 0:
        return 0u - (uint32_t)p;
    case 1:
        return (uint32_t)q;
    case 2:
        return 0u - (uint32_t)q;
    case 3:
        return (uint32_t)p;
    default:
        return 0;
    }
}

static bool is_thick(const qtri_place *p)
{
    return p->size >= THICK * (qtri_about(p->dx1) | qtri_about(p->dy1) | qtri_about(p->dx2) |
                               qtri_about(p->dy2)); /* the greatest or more */
}

static void set_depths(work *w)
{
    const qtri_ramp no_ramp = {0, 0, 0};
    const qtri_list_triangle *t = w->values.t;
    const uint32_t first = t->v[0]->depth_16p8 >> 8;
    const uint32_t steep = qtri_about((int32_t)((t->v[1]->depth_16p8 >> 8) - first)) |
                           qtri_about((int32_t)((t->v[2]->depth_16p8 >> 8) - first));
    w->depth = no_ramp;
    w->more[CENTER] = 0;
    qtri_list_set_depth(&w->depth, &w->values);
    for (int k = 0; k < QTRI_SAMPLES; k++) {
        if (w->is_thick && steep >> 16 == 0) {
            w->more[k] = more_at(&w->depth, k);
        } else {
            qtri_ramp there = no_ramp;
            move(w, k, 1);
            qtri_list_set_depth(&there, &w->values);
            move(w, k, -1);
            w->more[k] = there.origin - w->depth.origin;
        }
    }
}

/* All ramps of a triangle's values, which are curved or have texels: e is set. */
enum { RAMPS = 6 };

static int ramps_of(qtri_list_values *v, qtri_ramp *ramp[RAMPS])
{
    int count = 0;
    for (int i = 3 - v->channels; i < 3; i++) {
        ramp[count++] = &v->channel[i];
    }
    ramp[count++] = &v->e_q26;
    if (v->raster->texture != NULL) {
        ramp[count++] = &v->uv[0].l;
        ramp[count++] = &v->uv[1].l;
    }
    return count;
}

/* The fragments that take their colours at a place, with them into the batch. */
static void put_place(const work *w, int place)
{
    qtri_batch *batch = w->raster->batch;
    uint32_t *const begin = batch->place + batch->count;
    uint32_t *out = begin;
    uint32_t whole[QTRI_BATCH];
    uint32_t *kept = whole;
    for (int32_t i = 0; i < w->count; i++) {
        if (w->colored[i] == place) {
            *kept++ = w->place[i];
            *out++ = w->place[i] & QTRI_SAMPLE_PLACE;
        }
    }
    const int32_t count = (int32_t)(out - begin);
    const uint32_t mask = qtri_list_append(&w->values, count);
    if (w->raster->late != NULL) {
        qtri_ramp depth = w->depth;
        depth.origin += w->more[place];
        w->raster->late->note(w->raster, &depth, mask, count);
    }
    while (out != begin) {
        *--out = *--kept;
    }
}

/* Each place by itself: of a triangle that is not thick, values are set anew for it. */
QTRI_NOINLINE static void put_places(work *w)
{
    qtri_ramp *ramp[RAMPS];
    uint32_t origin[RAMPS];
    const int ramps = w->is_thick ? ramps_of(&w->values, ramp) : 0;
    for (int i = 0; i < ramps; i++) {
        origin[i] = ramp[i]->origin;
    }
    for (int place = 0; place < PLACES; place++) {
        if ((w->places >> place & 1) == 0) {
            continue;
        }
        for (int i = 0; i < ramps; i++) {
            ramp[i]->origin = origin[i] + more_at(ramp[i], place);
        }
        if (!w->is_thick) {
            w->values.has_e = false;
            move(w, place, 1);
            qtri_list_set(&w->values);
            move(w, place, -1);
        }
        put_place(w, place);
    }
    for (int i = 0; i < ramps; i++) {
        ramp[i]->origin = origin[i];
    }
}

/* Adds a channel to all words. */
static void add_channel(const work *w, uint32_t *out, const qtri_ramp *ramp, uint32_t shift,
                        uint32_t left)
{
    const qtri_ramp r = *ramp;
    uint32_t more[PLACES];
    const uint32_t *place = w->place;
    const uint8_t *colored = w->colored;
    for (int k = 0; k < PLACES; k++) {
        more[k] = more_at(ramp, k) + r.origin;
    }
    for (const uint32_t *end = place + w->count; place != end; place++, out++, colored++) {
        const uint32_t x = *place & QTRI_SAMPLE_PLACE_MAX;
        const uint32_t y = *place >> 16 & QTRI_SAMPLE_PLACE_MAX;
        *out += (more[*colored] + x * r.dx + y * r.dy) >> shift << left;
    }
}

/* The depths of fragments that are in the batch, where each takes its colour. */
QTRI_NOINLINE static void note_linear(const work *w)
{
    qtri_batch *batch = w->raster->batch;
    const int32_t first = batch->count - w->count;
    for (int32_t i = 0; i < w->count; i++) {
        batch->place[first + i] = w->place[i] & QTRI_SAMPLE_PLACE;
    }
    w->raster->late->note(w->raster, &w->depth, UINT32_MAX, w->count);
    for (int32_t i = 0; i < w->count; i++) {
        batch->place[first + i] = w->place[i];
        batch->depth[first + i] += w->more[w->colored[i]];
    }
}

/* Without texture, one colour or some that are linear. */
QTRI_NOINLINE static void put_linear(work *w)
{
    const qtri_list_values *v = &w->values;
    const qtri_colors *colors = w->raster->units;
    qtri_batch *batch = w->raster->batch;
    uint32_t *color = batch->color + batch->count;
    for (int32_t i = 0; i < w->count; i++) {
        batch->place[batch->count + i] = w->place[i];
        color[i] = v->channels == 0 ? v->constant : 0;
    }
    if (v->channels != 0 && batch->kind == QTRI_LIST_TINT_SHARES) {
        add_channel(w, color, &v->channel[2], 22u - colors->light_bits, 0);
    } else if (v->channels != 0) {
        add_channel(w, color, &v->channel[2], 16, 0);
        if (v->channels == 3) {
            add_channel(w, color, &v->channel[1], 16, colors->green);
            add_channel(w, color, &v->channel[0], 16, colors->red);
        }
    }
    batch->count = (uint8_t)(batch->count + w->count);
    if (w->raster->late != NULL) {
        note_linear(w);
    }
}

/* All fragments that wait go into the batch, with their colours. */
QTRI_NOINLINE static void put_waiting(work *w)
{
    if (w->raster->batch->count + w->count > QTRI_BATCH) {
        qtri_list_flush(w->raster);
    }
    const qtri_list_values *v = &w->values;
    if (w->is_thick && !w->is_set) {
        qtri_list_set(&w->values);
        w->is_set = true;
    }
    if (w->is_thick && w->raster->texture == NULL && (v->channels == 0 || !v->curved)) {
        put_linear(w);
    } else {
        put_places(w);
    }
    w->count = 0;
    w->places = 0;
}

static inline void append(work *w, uint32_t place, uint32_t pass, uint32_t cover)
{
    const int colored = (cover & COVERED) != 0 ? CENTER : first_of[cover];
    const int32_t i = w->count;
    w->place[i] = place | qtri_sample_bits(pass);
    w->colored[i] = (uint8_t)colored;
    w->places |= 1u << colored;
    w->count = i + 1;
    if (i + 1 == QTRI_BATCH) {
        put_waiting(w);
    }
}

/* Whether a sample is there and passes; `passes` as in list.c. */
QTRI_INLINE uint32_t test(uint32_t cover, int k, uint16_t *depth, uint32_t z, uint32_t passes,
                          bool write)
{
    if ((cover >> k & 1) == 0) {
        return 0;
    }
    const uint32_t top = z >> 16;
    const uint32_t stored = *depth;
    if (passes == 1 ? top >= stored
                    : (passes & (top < stored ? 1u : (top == stored ? 2u : 4u))) == 0) {
        return 0;
    }
    QTRI_BRANCH
    if (write) {
        *depth = (uint16_t)top;
    }
    return 1u << k;
}

/* Pixels from a place on, of which some samples are covered. */
QTRI_INLINE void test_row(work *w, uint32_t place, int32_t count, uint32_t passes, bool write)
{
    const qtri_surface *surface = w->raster->surface;
    const uint32_t column = place & 0xFFFF;
    const uint32_t row = place >> 16;
    const int32_t size = surface->format->pixels->bytes;
    uint32_t z = qtri_list_at(&w->depth, column, row);
    uint16_t *first = surface->depth + (ptrdiff_t)row * surface->depth_pitch + column;
    uint8_t *rest = surface->pixels + (ptrdiff_t)row * surface->pitch + (int32_t)column * size +
                    ((size - QTRI_SAMPLE_DEPTHS) & ~3); /* past colours */
    const uint8_t *cover = w->cover;
    const uint8_t *const end = cover + count;
    do {
        const uint32_t covered = *cover++;
        if (covered != 0) {
            uint16_t *depth = (uint16_t *)(void *)rest;
            uint32_t pass = test(covered, 0, first, z + w->more[0], passes, write);
            pass |= test(covered, 1, depth, z + w->more[1], passes, write);
            pass |= test(covered, 2, depth + 1, z + w->more[2], passes, write);
            pass |= test(covered, 3, depth + 2, z + w->more[3], passes, write);
            if (pass != 0) {
                append(w, place, pass, covered);
            }
        }
        z += w->depth.dx;
        place++;
        first++;
        rest += size;
    } while (cover != end);
}

QTRI_NOINLINE static void test_row_less(work *w, uint32_t place, int32_t count)
{
    test_row(w, place, count, 1, true);
}

QTRI_NOINLINE static void test_row_any(work *w, uint32_t place, int32_t count)
{
    const qtri_raster *raster = w->raster;
    if (raster->compare == QTRI_DEPTH_OFF) {
        for (int32_t i = 0; i < count; i++) {
            if ((w->cover[i] & ALL) != 0) {
                append(w, place + (uint32_t)i, w->cover[i] & ALL, w->cover[i]);
            }
        }
        return;
    }
    test_row(w, place, count, qtri_orders_of(raster->compare), raster->depth_write);
}

QTRI_NOINLINE void qtri_samples_small(const qtri_raster *raster, const qtri_list_triangle *t)
{
    work w;
    qtri_place *p = t->place;
    const bool is_less = raster->compare == QTRI_LESS && raster->depth_write;
    const int32_t columns = p->first[0];
    uint32_t place = ((uint32_t)p->row << 16) + (uint32_t)p->column;
    w.raster = raster;
    w.count = 0;
    w.places = 0;
    w.is_thick = is_thick(p);
    w.is_set = false;
    set_edges(&w.edges, p);
    qtri_list_begin(&w.values, raster, t);
    p->x -= p->column * 256;
    p->y -= p->row * 256;
    set_depths(&w);
    for (int32_t rows = p->first[1]; rows > 0; rows--, place += (uint32_t)1 << 16) {
        int32_t first;
        const int32_t count = cover_row(&w.edges, columns, w.cover, &first);
        if (count == 0) {
            continue;
        }
        if (is_less) {
            test_row_less(&w, place + (uint32_t)first, count);
        } else {
            test_row_any(&w, place + (uint32_t)first, count);
        }
    }
    if (w.count != 0) {
        put_waiting(&w);
    }
    if (raster->batch->count > QTRI_BATCH / 2) {
        qtri_list_flush(raster);
    }
}
