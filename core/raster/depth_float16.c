/* SPDX-License-Identifier: MIT */
#include "qtri/body/state.h"

#include "../bits/bits.h"
#include "depth_rows.h"
#include "loop.h"

/*
 * With perspective what is twice as far has half of 1 - z: a step that is a part of 1 - z is about
 * the same part of a distance. So t = 65535.0 - z, 32 bits, is kept as
 *
 *     e 2^12 + m,  t = m 2^5                where e is 0,
 *                  t = (2^12 + m) 2^(e + 4)  of e = 1..15,
 *
 * rounded down, and stored is 65535 less that, so that nearer is less. A step is 2^-13 to 2^-12 of
 * 1 - z, and no finer than 2^5: vertices have steps of 2^8.
 */
#define FARTHEST   QTRI_DEPTH_FARTHEST
#define MANTISSA   12 /* bits */
#define LEAST_LOG2 5

/* Values of t with one exponent: `size` of them from `from` on. */
typedef struct octave {
    uint32_t from, size;
    uint32_t base; /* added to t >> down */
    uint32_t down;
} octave;

static void find_octave(octave *o, uint32_t t)
{
    const int32_t top = 31 - qtri_clz32(t | 1); /* t's highest bit */
    const int32_t e = top - (MANTISSA + LEAST_LOG2 - 1);
    if (e <= 0) {
        const octave first = {0, (uint32_t)1 << (MANTISSA + LEAST_LOG2), 0, LEAST_LOG2};
        *o = first;
        return;
    }
    o->from = (uint32_t)1 << top;
    o->size = o->from;
    o->base = (uint32_t)(e - 1) << MANTISSA; /* the shifted t has its highest bit */
    o->down = (uint32_t)(LEAST_LOG2 + e - 1);
}

uint32_t qtri_depth_encode_float16(uint32_t z_16p16)
{
    const uint32_t t = z_16p16 > FARTHEST ? 0 : FARTHEST - z_16p16;
    octave o;
    find_octave(&o, t);
    return 65535 - (o.base + (t >> o.down));
}

/* Neighbours mostly have one exponent. */
static void encode(uint32_t *depth, int32_t count)
{
    const uint32_t *const end = depth + count;
    while (depth != end) {
        octave o;
        find_octave(&o, FARTHEST - *depth);
        const uint32_t first = FARTHEST - o.from;
        const uint32_t base = 65535 - o.base;
        const uint32_t size = o.size;
        const uint32_t down = o.down;
#ifndef __OPTIMIZE_SIZE__
        /* Four at once: of one exponent are those that differ below its highest bit alone. */
        for (; end - depth >= 4; depth += 4) {
            const uint32_t t0 = FARTHEST - depth[0];
            const uint32_t t1 = FARTHEST - depth[1];
            const uint32_t t2 = FARTHEST - depth[2];
            const uint32_t t3 = FARTHEST - depth[3];
            if (((t0 ^ o.from) | (t1 ^ o.from) | (t2 ^ o.from) | (t3 ^ o.from)) >= size) {
                break;
            }
            depth[0] = base - (t0 >> down);
            depth[1] = base - (t1 >> down);
            depth[2] = base - (t2 >> down);
            depth[3] = base - (t3 >> down);
        }
        if (depth == end) {
            return;
        }
#endif
        do {
            const uint32_t t = FARTHEST - *depth;
            if (first - *depth >= size) {
                break;
            }
            *depth++ = base - (t >> down);
        } while (depth != end);
    }
}

/* The middle of what is stored so, which is more than 0; the farthest is itself. */
static void decode(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        const uint32_t code = 65535 - depth[i];
        const uint32_t e = code >> MANTISSA;
        const uint32_t down = LEAST_LOG2 + (e == 0 ? 0 : e - 1);
        const uint32_t m = e == 0 ? code : code - ((e - 1) << MANTISSA);
        const uint32_t half = code == 0 ? 0 : (uint32_t)1 << (down - 1);
        const uint32_t t = (m << down) + half; /* code <= 65535: <= 0xFFFC0000 */
        depth[i] = FARTHEST - t;
    }
}

/*
 * Within an octave 65535 - base - (t >> down) is v >> down, where v = z + a constant: what is
 * rounded down for t is rounded up below 0, which 2^down - 1 more turns down again. v is below
 * 2^31: of e >= 1 what is stored is below (16 - e) 2^12, and down is e + 4; of e = 0 below 2^16,
 * and it is 5.
 *
 * A row is as linear as its depths, so of two that are in an octave all between are: where the
 * octave ends is found by halves.
 */
static int32_t find_piece(qtri_depth_piece *p, uint32_t z, uint32_t step, int32_t count)
{
    octave o;
    const uint32_t depth = qtri_depth_of(z);
    find_octave(&o, FARTHEST - depth);
    p->down = o.down;
    p->z = ((65535 - o.base) << o.down) + depth - FARTHEST + ((uint32_t)1 << o.down) - 1;
    p->step = step;
    if (z != depth + QTRI_DEPTH_HALF) {
        return 1;
    }
    const uint32_t within = FARTHEST - depth - o.from;
    int32_t last = 0; /* is in the octave */
    int32_t beyond = count - 1;
    if (within - (uint32_t)beyond * step < o.size) {
        return count;
    }
    while (beyond - last > 1) {
        const int32_t middle = (last + beyond) / 2;
        if (within - (uint32_t)middle * step < o.size) {
            last = middle;
        } else {
            beyond = middle;
        }
    }
    return last + 1;
}

#define BYTES    2
#define SHIFT(p) ((p)->down)
#include "depth_rows.inc"

#ifdef __OPTIMIZE_SIZE__
#define FLAT NULL
#else
/* As in core/fast/flat.inc: S1 takes 1.8 times as much without. */
QTRI_INLINE void fill_piece(uint16_t *depth, uint16_t *pixel, const qtri_depth_piece *p,
                            int32_t count, uint16_t color, bool equal)
{
    uint32_t z = p->z;
    const uint32_t step = p->step;
    const uint32_t down = p->down;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t own = z >> down;                                                            \
        const uint32_t stored = depth[i];                                                          \
        if (equal ? own <= stored : own < stored) {                                                \
            QTRI_BRANCH                                                                            \
            depth[i] = (uint16_t)own;                                                              \
            pixel[i] = color;                                                                      \
        }                                                                                          \
        z += step;                                                                                 \
        QTRI_OPAQUE(z)                                                                             \
    }
    QTRI_PIXELS(count)
#undef ONE
}

static void fill_row(uint16_t *depth, uint16_t *pixel, uint32_t z, uint32_t step, int32_t count,
                     uint16_t color, bool equal)
{
    for (;;) {
        qtri_depth_piece p;
        const int32_t some = find_piece(&p, z, step, count);
        if (equal) {
            fill_piece(depth, pixel, &p, some, color, true);
        } else {
            fill_piece(depth, pixel, &p, some, color, false);
        }
        count -= some;
        if (count == 0) {
            return;
        }
        depth += some;
        pixel += some;
        z += (uint32_t)some * step;
    }
}
#define FLAT fill_row
#endif

static const qtri_depth_testing testing = QTRI_DEPTH_TESTING(test_row, FLAT);
const qtri_depth_format qtri_depth_float16 = {QTRI_DEPTH_FLOAT16_BYTES, &testing, encode, decode,
                                              QTRI_FLOAT16};
