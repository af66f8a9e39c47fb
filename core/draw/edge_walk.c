/* SPDX-License-Identifier: MIT */
/*
 * The walk along an edge.
 *
 * An edge is followed along its major axis, the one on which it is longer. At the centre of each
 * column (or row) it passes through pixel i of the minor axis, at a fraction f of it. The pixel has
 * been drawn in the colour of the side that its centre lies on; the other side, that of the nearer
 * neighbour j, covers the share w = min(f, 1 - f) <= 1/2 of it if the edge is level. One of slope s
 * leaves the pixel within its width where w < s / 2: it then covers (w + s/2)^2 / 2s of i, and the
 * triangle on the other side (s/2 - w)^2 / 2s of j, which takes that of i. Both are exact for an
 * edge that goes on beyond the column.
 *
 * Places, in 16.16, and depths are linear from the edge's first pixel on, in chunks of CHUNK pixels
 * each of which begins exactly: a pixel's values depend on the edge alone, not on the surface's
 * rows or its scissor.
 *
 * A pixel is noted where the edge is not hidden: where the stored depth is not nearer than the
 * edge's less some slack. At a pixel's centre the face's depth differs from that on the edge, by
 * up to what it has across a pixel or two; slack is 8 to 16 times its range over its extent across,
 * and FLAT steps. (Half as much loses outlines of faces seen at a low angle, more gains nothing.)
 * Each pixel that would change is tested alone.
 */
#include "edge_walk.h"

#include "../bits/bits.h"
#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "../frame/barrier.h"

enum {
    CHUNK_LOG2 = 7,
    CHUNK = 1 << CHUNK_LOG2,
    SHORT_24P8 = CHUNK << 8,
    LEVEL_MOST = 4,   /* pixels of an edge whose depth counts as one, the nearest */
    FLAT_6 = 16 << 6, /* 16 steps of depth */
    NO_LIMIT = INT32_MIN / 2,
    HALF = 1 << 15,   /* of a pixel */
    SHARE_SHIFT = 11, /* to 1/32 */
    ROUND = 1 << (SHARE_SHIFT - 1),
    SLOPES = 17,
    SHARES = 17
};

/* A part of an edge: pixels k..end-1, from `at` on, 16.16 on the minor axis; limits of depth, n.6.
 */
typedef struct part {
    int32_t k, end;
    int32_t at, step;
    int32_t limit, limit_step;
} part;

/*
 * Notes, as codes without a direction, for half the slope and w in 1/32 of a pixel, each 0..16:
 * that of i in the low byte, that of j in the high one. (w + h)^2 / 4 h and (h - w)^2 / 4 h to
 * nearest where w < h; else w and 0.
 */
/* clang-format off */
static const uint16_t coverage[SLOPES][SHARES] = {
    {0x0000, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0000, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0408, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0408, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x0408, 0x040C, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x0408, 0x040C, 0x0410, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x080C, 0x040C, 0x0410, 0x0414, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x080C, 0x040C, 0x0410, 0x0414, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x080C, 0x0810, 0x0410, 0x0414, 0x0418, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x080C, 0x0810, 0x0410, 0x0414, 0x0418, 0x041C, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x0C10, 0x0810, 0x0814, 0x0414, 0x0418, 0x041C, 0x0420, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x0C10, 0x0810, 0x0814, 0x0818, 0x0418, 0x041C, 0x0420, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x1010, 0x0C10, 0x0C14, 0x0814, 0x0818, 0x0418, 0x041C, 0x0420, 0x0424, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x1010, 0x0C10, 0x0C14, 0x0814, 0x0818, 0x081C, 0x041C, 0x0420, 0x0424, 0x0428, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x1010, 0x1014, 0x0C14, 0x0C18, 0x0818, 0x081C, 0x0820, 0x0420, 0x0424, 0x0428, 0x042C, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
};
/* clang-format on */

/* Notes `code` at place i if it is the greatest there, or the first and not hidden. */
QTRI_INLINE void note(const qtri_edge_walker *w, uint32_t i, uint32_t code, int32_t limit)
{
    uint16_t *at = &w->notes[i];
    uint32_t *marks = &w->marks[i >> 5];
    const uint32_t mark = *marks;
    const uint32_t bit = (uint32_t)1 << (i & 31);
    const uint32_t stored = *at;
    if ((mark & bit) != 0) {
        if (code > (stored | w->weak)) {
            *at = (uint16_t)code;
        }
    } else if ((int32_t)((stored ^ w->flip) << 6) >= limit) {
        *marks = mark | bit;
        *at = (uint16_t)code;
    }
}

/*
 * Notes what one pixel of an edge gives itself and its neighbour. `at` on the minor axis is counted
 * from axis->first, which is a pixel and 2^-16 beyond the first: what lies on a pixel's border is
 * then the end of the pixel before it, with the same two shares. A function of its own: few pixels
 * come here, and it leaves the registers of the others alone.
 */
QTRI_NOINLINE static void note_both(const qtri_edge_walker *w, const qtri_edge_axis *axis,
                                    const uint16_t *shares, int32_t at, int32_t place,
                                    int32_t limit)
{
    int32_t pixel = at >> 16;
    uint32_t fraction = qtri_low16((uint32_t)at) + 1;
    uint32_t direction = axis->direction;
    int32_t other = pixel - 1;
    if (fraction > HALF) { /* on the centre: it belongs to the side after the edge */
        fraction = 2 * HALF - fraction;
        other = pixel + 1;
        direction += QTRI_NOTE_AFTER;
    }
    if ((uint32_t)pixel + 1 >= axis->wide || (uint32_t)other + 1 >= axis->wide) {
        return;
    }
    const uint32_t both = shares[(fraction + ROUND) >> SHARE_SHIFT];
    if (both >> 8 != 0) {
        note(w, (uint32_t)(place + other * axis->across), both >> 8 | (direction ^ QTRI_NOTE_AFTER),
             limit);
    }
    if ((both & 0xFF) != 0) {
        note(w, (uint32_t)(place + pixel * axis->across), (both & 0xFF) | direction, limit);
    }
}

/*
 * `shares`: the slope's row of the table. Of most pixels only the one that the edge passes through
 * takes a share, and both neighbours are on the surface: note_both() without its other half. `at`
 * less 2^-16 has the bit of a half where the fraction is more than that, so no constant is
 * compared, and less a pixel it is below `inner` where both neighbours count. Nothing but the axis
 * is asked for constants, and of a Cortex-M0+'s eight low registers it, the place, the limit and
 * `at` keep one each.
 */
QTRI_INLINE void walk_part(const qtri_edge_walker *w, const qtri_edge_axis *axis, const part *p,
                           const uint16_t *shares)
{
    int32_t along = axis->along;
    int32_t place = axis->origin + p->k * along;
    int32_t end = axis->origin + p->end * along;
    uint32_t at = (uint32_t)(p->at - axis->first);
    int32_t limit = p->limit;
    int32_t step = p->step;
    int32_t limit_step = p->limit_step;
    QTRI_ASIDE(limit_step)
    QTRI_ASIDE(step)
    QTRI_ASIDE(shares)
    do {
        uint32_t fraction = at << 16; /* f - 2^-16 */
        uint32_t code = axis->direction;
        QTRI_ASIDE(end)
        if ((int32_t)fraction >= 0) {
            fraction = at + (ROUND + 1); /* f + ROUND in its low half, */
        } else {
            QTRI_BRANCH
            fraction = (ROUND - 1) - at; /* and 1 - f + ROUND */
            code += QTRI_NOTE_AFTER;
        }
        const uint32_t both = shares[fraction << 16 >> (SHARE_SHIFT + 16)];
        int32_t pixel = (int32_t)at >> 16;
        if (both - 1 > 0xFE || (uint32_t)pixel >= axis->inner) {
            note_both(w, axis, shares, (int32_t)at, place, limit);
        } else {
            code |= both;
            const uint32_t i = (uint32_t)(place + pixel * axis->across);
            uint32_t *mark = &axis->marks[i >> 5];
            QTRI_OPAQUE(mark)
            if ((int32_t)(qtri_rotated(*mark, i) << 31) < 0) {
                uint16_t *at_note = &axis->notes[i];
                if (code > (*at_note | w->weak)) {
                    *at_note = (uint16_t)code;
                }
            } else {
                uint16_t *at_note = &axis->notes[i];
                if ((int32_t)((*at_note ^ axis->flip) << 6) >= limit) {
                    *at_note = (uint16_t)code;
                    QTRI_OPAQUE(mark)
                    *mark |= qtri_rotated(1, 0 - i);
                }
            }
        }
        QTRI_ASIDE(step)
        QTRI_ASIDE(limit_step)
        QTRI_OPAQUE(axis)
        QTRI_OPAQUE(at)
        at += (uint32_t)step;
        limit += limit_step;
        place += axis->along;
    } while (place != end);
}

/*
 * The pixels of the part that lie on the surface: one at least, since callers have asked whether
 * it begins before `high` and ends behind `low`, and no bounds are empty (qtri_edges_begin).
 */
static inline void cut_part(part *p, int32_t low, int32_t high)
{
    const int32_t before = low - p->k;
    if (before > 0) {
        p->k = low;
        p->at += before * p->step; /* within the edge's ends, as the part is not behind low */
        p->limit += before * p->limit_step;
    }
    if (p->end > high) {
        p->end = high;
    }
}

/* An edge by increasing major coordinate. */
typedef struct path {
    int32_t minor;  /* of the first end, 1/256 pixel */
    int32_t delta;  /* to the other end: |delta| <= length */
    int32_t length; /* 0..2^23 */
    int32_t along;  /* from the first end to the centre of pixel `first`, 0..255 */
    int32_t first, end;
    int32_t depth, depth_delta; /* 16.6 */
    bool hides;                 /* depth counts */
} path;

/* Of the magnitude of a step on the minor axis: its row of the table. */
static inline const uint16_t *shares_of(uint32_t step)
{
    return coverage[(step + 2048) >> 12]; /* step <= 2^16 */
}

/* x n / length 2^more, towards zero; |x|, n, length <= 2^23, length > 0. */
static int32_t share_of(int32_t x, int32_t n, int32_t length, int32_t more)
{
    bool half;
    const uint64_t product = qtri_mul_u32(qtri_magnitude32(x), (uint32_t)n);
    const int32_t q = (int32_t)qtri_divide64(product, (uint32_t)length, more, &half);
    return x < 0 ? -q : q;
}

/* In chunks, each of which begins exactly. */
QTRI_NOINLINE static void walk_long(const qtri_edge_walker *w, const qtri_edge_axis *axis,
                                    const path *l)
{
    part p;
    int32_t chunk = axis->low > l->first ? (axis->low - l->first) >> CHUNK_LOG2 : 0;
    const int32_t step = share_of(l->delta, 1, l->length, 16);
    const int32_t limit_step = share_of(l->depth_delta, 1, l->length, 8);
    for (;; chunk++) {
        p.k = l->first + chunk * CHUNK;
        p.end = p.k + CHUNK < l->end ? p.k + CHUNK : l->end;
        if (p.k >= p.end || p.k >= axis->high) {
            return;
        }
        const int32_t along = l->along + chunk * SHORT_24P8; /* < length */
        p.step = step;
        p.at = l->minor * 256 + share_of(l->delta, along, l->length, 8);
        p.limit = NO_LIMIT;
        p.limit_step = 0;
        if (l->hides) {
            p.limit = l->depth + share_of(l->depth_delta, along, l->length, 0);
            p.limit_step = limit_step;
        }
        cut_part(&p, axis->low, axis->high);
        walk_part(w, axis, &p, shares_of(qtri_magnitude32(step)));
    }
}

/* Down to hold a third value, or up. */
static inline int32_t range_of(int32_t low, int32_t high, int32_t third)
{
    return qtri_greatest32(high, third) - qtri_least32(low, third);
}

/* How much nearer than the edge a pixel may be, 16.6, by the face's range of depth, 16.6 and below
 * 2^22, and its extent across the edge. */
static inline int32_t slack_of(int32_t range, int32_t extent)
{
    int32_t slack = 8 * range;
    if (extent >= 512) {
        slack >>= 23 - qtri_clz32((uint32_t)extent); /* 1 for 2 pixels and more, 2 for 4 ... */
    }
    return slack + FLAT_6;
}

void qtri_edge_walker_init(qtri_edge_walker *w, const qtri_edges *edges, qtri_edge_test test)
{
    const qtri_rect *bounds = &edges->bounds;
    const int32_t pitch = edges->pitch;
    const int32_t first_row = edges->surface.first_row;
    const int32_t place = edges->origin - first_row * pitch; /* of pixel (0, 0), if it were there */
    const uint32_t flip = test == QTRI_EDGE_FARTHER ? 0xFFFF : 0;
    const uint32_t rows = (uint32_t)(bounds->y1 - bounds->y0);
    const uint32_t columns = (uint32_t)(bounds->x1 - bounds->x0);
    const qtri_edge_axis level = {.low = bounds->x0,
                                  .high = bounds->x1,
                                  .first = (bounds->y0 + 1) * 65536 + 1,
                                  .wide = rows,
                                  .inner = rows > 2 ? rows - 2 : 0,
                                  .marks = edges->marks,
                                  .notes = edges->notes,
                                  .flip = flip,
                                  .along = 1,
                                  .across = pitch,
                                  .origin = place + (bounds->y0 + 1) * pitch,
                                  .direction = 0};
    const qtri_edge_axis steep = {.low = bounds->y0,
                                  .high = bounds->y1,
                                  .first = (bounds->x0 + 1) * 65536 + 1,
                                  .wide = columns,
                                  .inner = columns > 2 ? columns - 2 : 0,
                                  .marks = edges->marks,
                                  .notes = edges->notes,
                                  .flip = flip,
                                  .along = pitch,
                                  .across = 1,
                                  .origin = place + bounds->x0 + 1,
                                  .direction = QTRI_NOTE_IN_ROW};
    w->marks = edges->marks;
    w->notes = edges->notes;
    w->flip = flip;
    w->weak = 0;
    w->hides = test != QTRI_EDGE_ALWAYS;
    w->axis[0] = level;
    w->axis[1] = steep;
}

/* Along a major axis that may be any of the two: coordinates of the ends on it, and on the other.
 */
typedef struct ends {
    const qtri_edge_axis *axis;
    int32_t major, minor, length, delta;
    int32_t third;        /* of the face's other vertex, on the minor axis */
    int32_t depth, other; /* at the ends; 16.6, flipped where greater is nearer */
    int32_t depth_c;
} ends;

/* By increasing major coordinate. */
QTRI_INLINE void order(ends *e, const qtri_edge_walker *w, const qtri_vertex *a,
                       const qtri_vertex *b, const qtri_vertex *c)
{
    const uint32_t flip = w->flip << 6; /* 65535 less the depth */
    e->axis = &w->axis[0];
    e->major = a->at.x_24p8;
    e->minor = a->at.y_24p8;
    e->third = c->at.y_24p8;
    e->length = b->at.x_24p8 - e->major;
    e->delta = b->at.y_24p8 - e->minor;
    if (qtri_magnitude32(e->delta) > qtri_magnitude32(e->length)) {
        const int32_t width = e->length;
        const int32_t x = e->major;
        e->axis = &w->axis[1];
        e->length = e->delta;
        e->delta = width;
        e->major = e->minor;
        e->minor = x;
        e->third = c->at.x_24p8;
    }
    e->depth = (int32_t)(a->depth_16p8 >> 10 ^ flip);
    e->other = (int32_t)(b->depth_16p8 >> 10 ^ flip);
    e->depth_c = (int32_t)(c->depth_16p8 >> 10 ^ flip);
    if (e->length < 0) { /* from b to a */
        const int32_t depth = e->depth;
        e->major += e->length;
        e->minor += e->delta;
        e->length = -e->length;
        e->delta = -e->delta;
        e->depth = e->other;
        e->other = depth;
    }
}

/* The lesser of the depths at its ends, less slack. */
static inline int32_t nearest_of(const ends *e)
{
    const int32_t end = e->minor + e->delta;
    const bool up = e->delta >= 0;
    const bool away = e->other >= e->depth;
    const int32_t low = away ? e->depth : e->other;
    return low - slack_of(range_of(low, away ? e->other : e->depth, e->depth_c),
                          range_of(up ? e->minor : end, up ? end : e->minor, e->third));
}

/* One of CHUNK pixels and more. */
QTRI_NOINLINE static void note_long(const qtri_edge_walker *w, const qtri_vertex *a,
                                    const qtri_vertex *b, const qtri_vertex *c)
{
    ends e;
    path l;
    order(&e, w, a, b, c);
    l.minor = e.minor;
    l.delta = e.delta;
    l.length = e.length;
    l.along = (128 - e.major) & 255;
    l.first = (e.major + 127) >> 8;
    l.end = (e.major + e.length + 127) >> 8;
    l.hides = w->hides;
    l.depth_delta = e.other - e.depth;
    l.depth = nearest_of(&e) - (l.depth_delta < 0 ? l.depth_delta : 0);
    if (l.first < e.axis->high && l.end > e.axis->low) {
        walk_long(w, e.axis, &l);
    }
}

/* A length below 2^15: times 2^up it is 2^15..2^16 - 1, and r is 2^31 / (2^up length), less than
 * one below. */
typedef struct inverse {
    uint32_t r;
    int32_t up;
} inverse;

static inline inverse inverse_of(uint32_t length)
{
    const int32_t up = qtri_clz32(length) - 16; /* >= 1 */
    const inverse i = {qtri_reciprocal_q31(length << up), up};
    return i;
}

QTRI_INLINE void find_limit(part *p, const ends *e, int32_t along, inverse i)
{
    const int32_t delta = e->other - e->depth;
    const int32_t step = qtri_mul_high_s31(delta * 256, i.r << i.up) * 2; /* < 2^30 */
    p->limit_step = step;
    p->limit -= delta < 0 ? delta : 0; /* from where it begins, not the nearest */
    p->limit += (step >> 8) * along + (((step & 255) * along) >> 8);
}

/*
 * 2^16 delta / length to nearest, for delta <= length < 2^15: the quotient by the inverse is at
 * most 3 too small.
 */
static inline uint32_t step_of(uint32_t delta, uint32_t length, inverse i)
{
    if (QTRI_DIVIDE) {
        return ((delta << 16) + length / 2) / length; /* < 2^31 + 2^14 */
    }
    uint32_t step = ((delta << i.up) * i.r) >> 15; /* <= 2^31 / 2^15 */
    uint32_t rest = (delta << 16) - step * length + length / 2;
    while (rest >= length) {
        rest -= length;
        step++;
    }
    return step;
}

void qtri_edge_note(const qtri_edge_walker *w, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_vertex *c)
{
    ends e;
    part p;
    order(&e, w, a, b, c);
    if (e.length >= SHORT_24P8) {
        note_long(w, a, b, c);
        return;
    }
    /* Centres in [major, major + length): the first is ceil((major - 128) / 256). */
    p.k = (e.major + 127) >> 8;
    p.end = (e.major + e.length + 127) >> 8;
    if (p.k >= p.end || p.k >= e.axis->high || p.end <= e.axis->low) {
        return;
    }
    const int32_t along = (128 - e.major) & 255; /* to the first centre */
    inverse i = {0, 0};
    if (!QTRI_DIVIDE) {
        i = inverse_of((uint32_t)e.length);
    }
    p.limit = NO_LIMIT;
    p.limit_step = 0;
    if (w->hides) {
        p.limit = nearest_of(&e);
        if (p.end - p.k > LEVEL_MOST) {
            find_limit(&p, &e, along, QTRI_DIVIDE ? inverse_of((uint32_t)e.length) : i);
        }
    }
    const uint32_t magnitude = step_of(qtri_magnitude32(e.delta), (uint32_t)e.length, i);
    p.step = e.delta < 0 ? -(int32_t)magnitude : (int32_t)magnitude;
    p.at = e.minor * 256 + ((p.step * along + 128) >> 8);
    cut_part(&p, e.axis->low, e.axis->high);
    walk_part(w, e.axis, &p, shares_of(magnitude));
}
