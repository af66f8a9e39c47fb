/* SPDX-License-Identifier: MIT */
/*
 * Fragments of small triangles blended where they are, one after the other: each is loaded and
 * stored before the next, so that none needs to know whether it lies on another. The pixels are
 * those that blend.c makes.
 */
#include "blend_row.h"

#include "../frame/barrier.h"

#define RED_BLUE 0xF81Fu
#define GREEN    0x07E0u
#define LANES    0x07E0F81Fu

/* ONE(c, u) makes of a colour and the pixel under it what is stored. */
#define LIST                                                                                       \
    const uint32_t *color = raster->batch->color;                                                  \
    const uint32_t *place = raster->batch->place;                                                  \
    const uint32_t *const end = place + count;                                                     \
    uint8_t *const pixels = raster->surface->pixels;                                               \
    const ptrdiff_t pitch = raster->surface->pitch;                                                \
    do {                                                                                           \
        uint16_t *pixel = qtri_placed_16(pixels, pitch, *place++);                                 \
        uint32_t c = *color++;                                                                     \
        uint32_t u = *pixel;                                                                       \
        ONE *pixel = (uint16_t)c;                                                                  \
    } while (place != end);

void qtri_blend_list_alpha(const qtri_raster *raster, int32_t count)
{
    const qtri_share_565 share = qtri_share_565_of(raster->alpha);
    QTRI_OVER_565_BEGIN(share)
#define ONE                                                                                        \
    QTRI_OVER_565(c, u) c |= x;                                                                    \
    QTRI_OVER_565_ASIDE
    LIST
#undef ONE
}

/* The sum of lanes, at most full: see sum_565() in blend.c. */
#define SUM(x, u)                                                                                  \
    (x) += ((u) | (u) << 16) & lanes;                                                              \
    c = (x)&over;                                                                                  \
    (x) |= c - (c >> 5);                                                                           \
    (x) = ((x) | c >> 6) & lanes;                                                                  \
    c = (x) | (x) >> 16;

QTRI_NOINLINE static void sum(const qtri_raster *raster, int32_t count)
{
    uint32_t lanes = LANES;
    uint32_t over = 0x08010020u;
    QTRI_OPAQUE(lanes)
    QTRI_OPAQUE(over)
#define ONE                                                                                        \
    uint32_t x = (c | c << 16) & lanes;                                                            \
    SUM(x, u)
    LIST
#undef ONE
}

/* See add_565() there. */
QTRI_NOINLINE static void add(const qtri_raster *raster, int32_t count)
{
    const qtri_share_565 share = qtri_share_565_of(raster->alpha);
    uint32_t lanes = LANES;
    uint32_t over = 0x08010020u;
    uint32_t mask = RED_BLUE;
    uint32_t red_blue = share.red_blue;
    uint32_t green = share.green;
    QTRI_OPAQUE(lanes)
    QTRI_OPAQUE(mask)
#define ONE                                                                                        \
    uint32_t x = ((c & mask) * red_blue + 0x10020u) >> 6 & mask;                                   \
    x |= ((c & GREEN) * green + 0x1000u) << 8 & (lanes ^ mask);                                    \
    SUM(x, u)                                                                                      \
    QTRI_ASIDE(red_blue)                                                                           \
    QTRI_ASIDE(green)                                                                              \
    QTRI_ASIDE(over)
    LIST
#undef ONE
}

void qtri_blend_list_add(const qtri_raster *raster, int32_t count)
{
    if (raster->alpha == 255) {
        sum(raster, count);
    } else {
        add(raster, count);
    }
}
