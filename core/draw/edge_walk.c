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
#include "../bits/seed.h"

enum {
    CHUNK_LOG2 = 7,
    CHUNK = 1 << CHUNK_LOG2,
    SHORT_24P8 = CHUNK << 8,
    FLAT_6 = 16 << 6, /* 16 steps of depth */
    NO_LIMIT = INT32_MIN / 2
};

/* Of one edge: what its pixels share. */
typedef struct walk {
    const qtri_edges *edges;
    uint16_t *notes;
    int32_t low, high;             /* pixels on the major axis that count */
    int32_t first;                 /* pixel on the minor axis that is 0 */
    uint32_t wide;                 /* pixels on it */
    int32_t along, across, origin; /* steps of a note's place, and the place of pixel (0, first) */
    uint32_t code;                 /* the note's direction on the minor axis */
    uint32_t flip;                 /* depths are compared after this is exclusive-ored */
    uint32_t weak;                 /* 0, or all bits: a pixel with a note keeps it */
    int32_t half;                  /* of the slope, in 1/32 */
    uint32_t inverse;              /* 2^16 / 4 half */
} walk;

/* A part of it: pixels k..end-1, from `at` on, 16.16 on the minor axis; limits of depth, n.6. */
typedef struct part {
    int32_t k, end;
    int32_t at, step;
    int32_t limit, limit_step;
} part;

/* 2^16 / (4 n), rounded. */
static const uint16_t inverses[17] = {0,    16384, 8192, 5461, 4096, 3277, 2731, 2341, 2048,
                                      1820, 1638,  1489, 1365, 1260, 1170, 1092, 1024};

/* Notes `code` at place i if it is the greatest there, or the first and not hidden. */
QTRI_INLINE void note(const walk *w, uint32_t i, uint32_t code, int32_t limit)
{
    uint16_t *at = &w->notes[i];
    uint32_t *marks = &w->edges->marks[i >> 5];
    const uint32_t mark = *marks;
    const uint32_t bit = (uint32_t)1 << (i & 31);
    const uint32_t stored = *at;
    if ((mark & bit) != 0) {
        if (code > (stored | w->weak)) {
            *at = (uint16_t)code;
        }
    } else if ((int32_t)(stored ^ w->flip) >= limit) {
        *marks = mark | bit;
        *at = (uint16_t)code;
    }
}

QTRI_NOINLINE static void walk_part(const walk *w, const part *p)
{
    int32_t at = p->at - w->first * 65536;
    int32_t limit = p->limit;
    int32_t place = w->origin + p->k * w->along;
    const int32_t step = p->step;
    for (int32_t n = p->end - p->k; n > 0; n--) {
        const int32_t pixel = at >> 16;
        uint32_t share = (uint32_t)at >> 11 & 31;
        int32_t other = pixel - 1;
        uint32_t code = w->code;
        if (share >= 16) {
            share = 32 - share;
            other = pixel + 1;
            code += QTRI_NOTE_AFTER;
        }
        if ((uint32_t)pixel < w->wide && (uint32_t)other < w->wide) {
            const int32_t i = place + pixel * w->across;
            const int32_t rest = w->half - (int32_t)share;
            if (rest > 0) {
                const uint32_t inverse = w->inverse;
                const uint32_t sum = share + (uint32_t)w->half;          /* <= 32 */
                const uint32_t less = (uint32_t)(rest * rest) * inverse; /* <= 16^2 2^14 */
                share = (sum * sum * inverse + 0x8000) >> 16;            /* < half */
                const uint32_t second = (less + 0x8000) >> 16;
                if (second != 0) {
                    note(w, (uint32_t)(place + other * w->across),
                         second << QTRI_NOTE_SHARE_SHIFT | (code ^ QTRI_NOTE_AFTER), limit >> 6);
                }
            }
            if (share != 0) {
                note(w, (uint32_t)i, share << QTRI_NOTE_SHARE_SHIFT | code, limit >> 6);
            }
        }
        at += step;
        limit += p->limit_step;
        place += w->along;
    }
}

/* The pixels of the part that lie on the surface. */
static inline void cut_part(const walk *w, part *p)
{
    const int32_t before = w->low - p->k;
    if (before > 0) {
        p->k = w->low;
        p->at += before * p->step; /* within the edge's ends, if the part is not behind low */
        p->limit += before * p->limit_step;
    }
    if (p->end > w->high) {
        p->end = w->high;
    }
}

/* floor(2^31 / length), for 0 < length < 2^15: the same on all cores. */
static inline uint32_t reciprocal_q31(uint32_t length)
{
#if QTRI_DIVIDE
    return 0x80000000u / length;
#else
    const int32_t zeros = qtri_clz32(length); /* >= 17 */
    const uint32_t x = length << (zeros - 16);
    const uint32_t r_q15 = qtri_reciprocal_seed(x);
    const int32_t error_q31 = (int32_t)(0x80000000u - x * r_q15); /* |error| < 2^17 */
    uint32_t r = (r_q15 << 15) + (uint32_t)(((error_q31 >> 1) * (int32_t)r_q15) >> 15);
    r >>= 31 - zeros; /* the quotient or one less: all lengths tried */
    return r + (0x80000000u - r * length >= length);
#endif
}

/* An edge by increasing major coordinate. */
typedef struct path {
    int32_t minor;  /* of the first end, 1/256 pixel */
    int32_t delta;  /* to the other end: |delta| <= length */
    int32_t length; /* 0..2^23 */
    int32_t along;  /* from the first end to the centre of pixel `first`, 0..255 */
    int32_t first, end;
    int32_t depth, depth_delta; /* 16.6 */
} path;

/* A depth in 16.6, nearer being smaller. */
static inline int32_t depth_of(const qtri_vertex *v, qtri_edge_test test)
{
    const int32_t depth = (int32_t)(v->depth_16p8 >> 10);
    return test == QTRI_EDGE_FARTHER ? (65535 << 6) - depth : depth;
}

static inline void set_slope(walk *w, int32_t step)
{
    w->half = (int32_t)((qtri_magnitude32(step) + 2048) >> 12); /* <= 16 */
    w->inverse = inverses[w->half];
}

/* In one chunk. */
static inline void walk_short(walk *w, const path *l, bool hides)
{
    part p;
    const uint32_t r_q31 = reciprocal_q31((uint32_t)l->length);
    const uint32_t magnitude = (qtri_magnitude32(l->delta) * r_q31) >> 15; /* <= 2^31 / 2^15 */
    p.step = l->delta < 0 ? -(int32_t)magnitude : (int32_t)magnitude;
    p.at = l->minor * 256 + ((p.step * l->along) >> 8);
    p.k = l->first;
    p.end = l->end;
    p.limit = NO_LIMIT;
    p.limit_step = 0;
    if (hides) {
        const int32_t step = qtri_mul_high_s31(l->depth_delta * 256, r_q31) * 2; /* < 2^30 */
        p.limit_step = step;
        p.limit = l->depth + (step >> 8) * l->along + (((step & 255) * l->along) >> 8);
    }
    set_slope(w, p.step);
    cut_part(w, &p);
    walk_part(w, &p);
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
QTRI_NOINLINE static void walk_long(walk *w, const path *l, bool hides)
{
    part p;
    int32_t chunk = w->low > l->first ? (w->low - l->first) >> CHUNK_LOG2 : 0;
    const int32_t step = share_of(l->delta, 1, l->length, 16);
    const int32_t limit_step = share_of(l->depth_delta, 1, l->length, 8);
    set_slope(w, step);
    for (;; chunk++) {
        p.k = l->first + chunk * CHUNK;
        p.end = p.k + CHUNK < l->end ? p.k + CHUNK : l->end;
        if (p.k >= p.end || p.k >= w->high) {
            return;
        }
        const int32_t along = l->along + chunk * SHORT_24P8; /* < length */
        p.step = step;
        p.at = l->minor * 256 + share_of(l->delta, along, l->length, 8);
        p.limit = NO_LIMIT;
        p.limit_step = 0;
        if (hides) {
            p.limit = l->depth + share_of(l->depth_delta, along, l->length, 0);
            p.limit_step = limit_step;
        }
        cut_part(w, &p);
        walk_part(w, &p);
    }
}

/* How much nearer than the edge a pixel may be, 16.6. c: the face's third vertex. */
static int32_t slack_of(const path *l, int32_t depth_c, int32_t minor_c)
{
    const int32_t depth_b = l->depth + l->depth_delta;
    const int32_t minor_b = l->minor + l->delta;
    const int32_t range = qtri_greatest32(qtri_greatest32(l->depth, depth_b), depth_c) -
                          qtri_least32(qtri_least32(l->depth, depth_b), depth_c); /* < 2^22 */
    const int32_t extent = qtri_greatest32(qtri_greatest32(l->minor, minor_b), minor_c) -
                           qtri_least32(qtri_least32(l->minor, minor_b), minor_c);
    int32_t slack = 8 * range;
    if (extent >= 512) {
        slack >>= 23 - qtri_clz32((uint32_t)extent); /* 1 for 2 pixels and more, 2 for 4 ... */
    }
    return slack + FLAT_6;
}

/* Where the pixels are, for an edge that is steep, its major axis being y, or not. */
static inline void set_axes(walk *w, const qtri_edges *edges, bool steep)
{
    const qtri_rect *bounds = &edges->bounds;
    const int32_t first_row = edges->surface.first_row;
    const int32_t pitch = edges->pitch;
    w->edges = edges;
    w->notes = edges->notes;
    if (steep) {
        w->low = bounds->y0;
        w->high = bounds->y1;
        w->first = bounds->x0;
        w->wide = (uint32_t)(bounds->x1 - bounds->x0);
        w->along = pitch;
        w->across = 1;
        w->origin = edges->origin + bounds->x0 - first_row * pitch;
        w->code = QTRI_NOTE_IN_ROW;
    } else {
        w->low = bounds->x0;
        w->high = bounds->x1;
        w->first = bounds->y0;
        w->wide = (uint32_t)(bounds->y1 - bounds->y0);
        w->along = 1;
        w->across = pitch;
        w->origin = edges->origin + (bounds->y0 - first_row) * pitch;
        w->code = 0;
    }
}

void qtri_edge_note(const qtri_edges *edges, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_vertex *c, qtri_edge_test test, bool weak)
{
    walk w;
    path l;
    int32_t major = a->at.x_24p8;
    int32_t minor_c = c->at.y_24p8;
    l.minor = a->at.y_24p8;
    l.length = b->at.x_24p8 - major;
    l.delta = b->at.y_24p8 - l.minor;
    const bool steep = qtri_magnitude32(l.delta) > qtri_magnitude32(l.length);
    if (steep) {
        const int32_t width = l.length;
        l.length = l.delta;
        l.delta = width;
        major = l.minor;
        l.minor = a->at.x_24p8;
        minor_c = c->at.x_24p8;
    }
    l.depth = depth_of(a, test);
    l.depth_delta = depth_of(b, test) - l.depth;
    if (l.length < 0) { /* from b to a */
        major += l.length;
        l.minor += l.delta;
        l.depth += l.depth_delta;
        l.length = -l.length;
        l.delta = -l.delta;
        l.depth_delta = -l.depth_delta;
    }
    /* Centres in [major, major + length): the first is ceil((major - 128) / 256). */
    l.first = (major + 127) >> 8;
    l.end = (major + l.length + 127) >> 8;
    set_axes(&w, edges, steep);
    if (l.first >= l.end || l.first >= w.high || l.end <= w.low) {
        return;
    }
    l.along = (128 - major) & 255;
    w.flip = test == QTRI_EDGE_FARTHER ? 0xFFFF : 0;
    w.weak = weak ? UINT32_MAX : 0;
    const bool hides = test != QTRI_EDGE_ALWAYS;
    if (hides) {
        l.depth -= slack_of(&l, depth_of(c, test), minor_c);
    }
    if (l.length < SHORT_24P8) {
        walk_short(&w, &l, hides);
    } else {
        walk_long(&w, &l, hides);
    }
}
