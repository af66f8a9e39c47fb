/* SPDX-License-Identifier: MIT */
#include "blend_row.h"

#include "../frame/barrier.h"

/* One load and one store for two pixels, where the compiler and the order of bytes allow it. */
#if defined(__GNUC__) && defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define WORDS 1
#else
#define WORDS 0
#endif

/* Two pixels at a word, the first in the low half. */
QTRI_INLINE uint32_t load(const uint16_t *at)
{
#if WORDS
    uint32_t two;
    __builtin_memcpy(&two, __builtin_assume_aligned(at, 4), sizeof two);
    return two;
#else
    return at[0] | (uint32_t)at[1] << 16;
#endif
}

QTRI_INLINE void store(uint16_t *at, uint32_t two)
{
#if WORDS
    __builtin_memcpy(__builtin_assume_aligned(at, 4), &two, sizeof two);
#else
    at[0] = (uint16_t)two;
    at[1] = (uint16_t)(two >> 16);
#endif
}

/* Colours of two words, of which the low halves count. */
QTRI_INLINE uint32_t colors(const uint32_t *color)
{
    return (uint16_t)color[0] | color[1] << 16;
}

/*
 * TWO(c, u) makes of two colours and the two pixels under them what is stored. The first pixel of a
 * row that begins in the middle of a word, and the last of one that ends there, have another
 * beside them that does not count.
 */
#ifdef __OPTIMIZE_SIZE__
#define FOUR
#else
#define FOUR                                                                                       \
    const uint16_t *fours = pixel + (count & ~3);                                                  \
    while (pixel != fours) {                                                                       \
        PAIR(0)                                                                                    \
        PAIR(2)                                                                                    \
        pixel += 4;                                                                                \
        color += 4;                                                                                \
        QTRI_OPAQUE(pixel)                                                                         \
        QTRI_OPAQUE(color)                                                                         \
        QTRI_ASIDE(fours)                                                                          \
    }                                                                                              \
    count &= 3;
#endif
#define PAIR(i)                                                                                    \
    {                                                                                              \
        uint32_t two = TWO(colors(color + (i)), load(pixel + (i)));                                \
        store(pixel + (i), two);                                                                   \
        QTRI_OPAQUE(color)                                                                         \
    }
#define ROW                                                                                        \
    if (((uintptr_t)pixel & 2) != 0) {                                                             \
        *pixel = (uint16_t)TWO((uint16_t)*color, *pixel);                                          \
        pixel++;                                                                                   \
        color++;                                                                                   \
        count--;                                                                                   \
    }                                                                                              \
    FOUR for (; count >= 2; count -= 2)                                                            \
    {                                                                                              \
        PAIR(0)                                                                                    \
        pixel += 2;                                                                                \
        color += 2;                                                                                \
    }                                                                                              \
    if (count > 0) {                                                                               \
        *pixel = (uint16_t)TWO((uint16_t)*color, *pixel);                                          \
    }

/*
 * A channel of two pixels in halves of a word: of five bits, and of green's six; shares of 256 of
 * them, below 2^14 with their half, do not meet.
 */
typedef struct lanes {
    uint32_t five, six, half;
    uint32_t red_blue, green; /* shares */
} lanes;

static inline lanes lanes_of(uint32_t alpha)
{
    const qtri_share_565 share = qtri_share_565_of(alpha);
    const lanes all = {0x001F001Fu, 0x003F003Fu, 0x00800080u, 4 * share.red_blue, share.green};
    return all;
}

#define RED(x)   ((x) >> 11)
#define GREEN(x) ((x) >> 5)

/* To colours. */
QTRI_IN_PLACE uint32_t joined(uint32_t red, uint32_t green, uint32_t blue, const lanes *l)
{
    red &= 0x1F001F00u;
    QTRI_TOGETHER(red)
    return (blue >> 8 & l->five) | (green >> 3 & 0x07E007E0u) | red << 3;
}

/* (c k + u (256 - k) + 128) / 256: under + (color - under) share, rounded. */
QTRI_IN_PLACE uint32_t over(uint32_t c, uint32_t u, const lanes *l)
{
    const uint32_t under = 256 - l->red_blue;
    uint32_t blue = (c & l->five) * l->red_blue + l->half;
    uint32_t red = (RED(c) & l->five) * l->red_blue + l->half;
    uint32_t green = (GREEN(c) & l->six) * l->green + l->half;
    blue += (u & l->five) * under;
    red += (RED(u) & l->five) * under;
    green += (GREEN(u) & l->six) * (256 - l->green);
    return joined(red, green, blue, l);
}

void qtri_blend_row_alpha(uint8_t *pixels, const uint32_t *color, int32_t count,
                          const qtri_raster *raster, uint32_t z, uint32_t z_step)
{
    uint16_t *pixel = (uint16_t *)(void *)pixels;
    lanes l = lanes_of(raster->alpha);
    (void)z;
    (void)z_step;
    QTRI_OPAQUE(l.five)
    QTRI_OPAQUE(l.six)
    QTRI_OPAQUE(l.half)
#define TWO(c, u) over(c, u, &l)
    ROW
#undef TWO
}

/* What a full channel has as its highest bit, and the highest bit of green. */
#define TOPS      0x84108410u
#define GREEN_TOP 0x04000400u

/*
 * c + u of each channel, at most full. (c + u) / 2 fits its channel, rounded down, and its highest
 * bit says whether c + u does: the sum of all is then 2 of them too much, which would be carried
 * into the channel before, and what fills the channel are the bits from there down to its lowest.
 */
QTRI_IN_PLACE uint32_t sum(uint32_t c, uint32_t u, uint32_t tops)
{
    uint32_t all = c + u;
    u ^= c;
    QTRI_OPAQUE(u) /* c without it: the bits of both, with no register for a copy */
    c &= ~u;
    const uint32_t half = c + (u >> 1 & 0x7BEF7BEFu);
    const uint32_t full = half & tops;
    uint32_t fill = full << 1;
    all -= fill;
    QTRI_OPAQUE(all) /* first, or its subtrahend is kept twice */
    fill -= full >> 4;
    all |= fill;
    return all | (full & GREEN_TOP) >> 5; /* it has six bits */
}

QTRI_NOINLINE static void sum_row(uint16_t *pixel, const uint32_t *color, int32_t count)
{
    uint32_t tops = TOPS;
    QTRI_OPAQUE(tops)
#define TWO(c, u) sum(c, u, tops)
    ROW
#undef TWO
}

/* Shares of colours, rounded. */
QTRI_IN_PLACE uint32_t share_of(uint32_t c, const lanes *l)
{
    const uint32_t green = (GREEN(c) & l->six) * l->green + l->half;
    const uint32_t red = (RED(c) & l->five) * l->red_blue + l->half;
    const uint32_t blue = (c & l->five) * l->red_blue + l->half;
    return joined(red, green, blue, l);
}

QTRI_NOINLINE static void add_row(uint16_t *pixel, const uint32_t *color, int32_t count,
                                  uint32_t alpha)
{
    lanes l = lanes_of(alpha);
    uint32_t tops = TOPS;
    QTRI_OPAQUE(l.five)
    QTRI_OPAQUE(l.six)
    QTRI_OPAQUE(l.half)
    QTRI_OPAQUE(tops)
#define TWO(c, u) sum(share_of(c, &l), u, tops)
    ROW
#undef TWO
}

void qtri_blend_row_add(uint8_t *pixels, const uint32_t *color, int32_t count,
                        const qtri_raster *raster, uint32_t z, uint32_t z_step)
{
    uint16_t *pixel = (uint16_t *)(void *)pixels;
    (void)z;
    (void)z_step;
    if (raster->alpha == 255) {
        sum_row(pixel, color, count);
    } else {
        add_row(pixel, color, count, raster->alpha);
    }
}
