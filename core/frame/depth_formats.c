/* SPDX-License-Identifier: MIT */
/*
 * Depth formats: encoding, decoding, and operations on buffers of those that are not linear16.
 */
#include "depth_format.h"

#include "qtri/body/stored.h"

#include "../bits/bits.h"
#include "pixel.h"

#define FARTHEST 0xFFFF0000u /* 65535.0 */

enum { AT_ONCE = 32 };

/* Depths move towards the first one: none is overwritten before it is read. */
static uint16_t *flatten(const qtri_surface *surface)
{
    const qtri_depth_format *format = surface->depth_format;
    const int32_t bytes = format->bytes;
    const ptrdiff_t pitch = surface->depth_pitch < 0 ? -surface->depth_pitch : surface->depth_pitch;
    uint8_t *first = (uint8_t *)surface->depth;
    if (surface->depth_pitch < 0) {
        first -= bytes * pitch * (surface->rows - 1);
    }
    uint16_t *to = (uint16_t *)(void *)first;
    for (int32_t row = 0; row < surface->rows; row++) {
        for (int32_t x = 0; x < surface->width; x += AT_ONCE) {
            uint32_t depth[AT_ONCE];
            const int32_t count = qtri_least32(AT_ONCE, surface->width - x);
            const ptrdiff_t at = row * pitch + x;
            for (int32_t i = 0; i < count; i++) {
                depth[i] = qtri_load(format->bytes, first + bytes * (at + i));
            }
            format->decode(depth, count);
            for (int32_t i = 0; i < count; i++) {
                to[at + i] =
                    (uint16_t)((depth[i] < FARTHEST ? depth[i] + 0x8000u : FARTHEST) >> 16);
            }
        }
    }
    return to;
}

/* Fills depths as if they were pixels of a surface. */
static void fill(const qtri_surface *surface, const qtri_rect *rect, uint32_t depth_16p16)
{
    const qtri_pixels memory = {surface->depth_format->bytes, NULL, NULL, NULL};
    const qtri_format format = {&memory, NULL, NULL, NULL, NULL, 0};
    qtri_surface depths = *surface;
    depths.format = &format;
    depths.pixels = (uint8_t *)surface->depth;
    depths.pitch = memory.bytes * surface->depth_pitch;
    surface->depth_format->encode(&depth_16p16, 1);
    qtri_fill_rect(&depths, rect, depth_16p16);
}

const qtri_depth_ops qtri_depth_words = {fill, flatten};

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
    const uint32_t t = FARTHEST - z_16p16;
    octave o;
    find_octave(&o, t);
    return 65535 - (o.base + (t >> o.down));
}

/* Z = z less the half lies in 65535.0 - t. With M = (from + size) >> down what is stored is
   65535 - base - (M - 1) + (Z' >> down), Z' from the octave's greatest t on. Depths before the
   first have Z' < 2^16, of which the shift by 19 leaves nothing: they are stored as it is. */
qtri_octave qtri_depth_octave(uint32_t z)
{
    const uint32_t first = z < QTRI_DEPTH_HALF ? 0 : z - QTRI_DEPTH_HALF;
    qtri_octave out = {FARTHEST + QTRI_DEPTH_HALF + 1, 0xFFFF - QTRI_DEPTH_HALF, 65535, 31};
    if (first <= FARTHEST) {
        octave o;
        find_octave(&o, FARTHEST - first);
        const uint32_t end = (o.from >> o.down) + (o.size >> o.down);
        out.zero = QTRI_DEPTH_HALF + FARTHEST - (o.from + (o.size - 1));
        out.size = o.size;
        out.base = 65536 - o.base - end;
        out.down = o.down;
    }
    return out;
}

void qtri_depth_to_float16(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] = qtri_depth_encode_float16(depth[i]);
    }
}

/* The middle of the depths that are stored alike; the farthest is itself. */
void qtri_depth_from_float16(uint32_t *depth, int32_t count)
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

/* <= 65535.0: the half does not carry out of 32 bits. */
static void encode_linear16(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] = (depth[i] + 0x8000) >> 16;
    }
}

static void decode_linear16(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] <<= 16;
    }
}

void qtri_depth_to_linear24(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] = (depth[i] + 0x80) >> 8;
    }
}

void qtri_depth_from_linear24(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] <<= 8;
    }
}

/* Depths are stored as they are: NOLINTNEXTLINE(readability-non-const-parameter) */
void qtri_depth_as_it_is(uint32_t *depth, int32_t count)
{
    (void)depth;
    (void)count;
}

const qtri_depth_format qtri_depth_linear16 = {
    QTRI_DEPTH_LINEAR16_BYTES, NULL, encode_linear16, decode_linear16, QTRI_LINEAR16, NULL};
