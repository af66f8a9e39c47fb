/* SPDX-License-Identifier: MIT */
#include "effect.h"
#include "stage_color.h"

#include "../frame/mix.h"

/* Stored pixels of those in the mask. */
static void gather(uint32_t *stored, const qtri_raster *raster, const uint32_t *place,
                   uint32_t mask, int32_t count)
{
    const qtri_pixels *memory = raster->format->pixels;
    const ptrdiff_t pitch = raster->surface->pitch;
    const uint32_t bytes = memory->bytes;
    uint8_t *pixels = raster->surface->pixels;
    if (bytes == 2 && mask == qtri_mask_of(count) &&
        place[count - 1] - place[0] == (uint32_t)count - 1) { /* neighbours, as places ascend */
        const uint16_t *pixel =
            (const uint16_t *)(const void *)(pixels + (ptrdiff_t)(place[0] >> 16) * pitch) +
            (place[0] & 0xFFFF);
        for (const uint32_t *end = stored + count; stored != end; stored++) {
            *stored = *pixel++;
        }
        return;
    }
    mask <<= 32 - count;
    for (int32_t i = 0; i < count; i++, mask <<= 1) {
        const uint8_t *at =
            pixels + (ptrdiff_t)(place[i] >> 16) * pitch + (ptrdiff_t)((place[i] & 0xFFFF) * bytes);
        stored[i] = 0;
        if ((int32_t)mask < 0) {
            stored[i] = bytes == 2 ? *(const uint16_t *)(const void *)at : memory->load(at);
        }
    }
}

/* Whether what encodes colours decodes them as well: it exchanges bytes. */
static bool is_exchange(const qtri_format *format)
{
    return format->decode == qtri_decode_rgb565_swapped || format->decode == qtri_decode_rgb888;
}

/* 8 bits a channel to the format's kind. */
static void narrow(const qtri_format *format, uint32_t *color, int32_t count)
{
    if (format->colors == &qtri_colors_565) {
        qtri_888_to_565(color, count);
    } else if (format->colors == &qtri_colors_gray) {
        qtri_888_to_gray(color, count);
    }
}

/* To the kind that is mixed: `wide` 8 bits a channel, elsewhere the format's. */
static void decode(uint32_t *stored, const qtri_format *format, bool wide, int32_t count)
{
    if (format->encode == NULL && !wide) {
        return;
    }
    if (!wide && is_exchange(format)) {
        format->encode(stored, count);
        return;
    }
    for (int32_t i = 0; i < count; i++) {
        stored[i] = format->decode(stored[i]);
    }
    if (!wide) {
        narrow(format, stored, count);
    }
}

/* Which colours are mixed, and with what. */
typedef struct mixture {
    uint32_t stored[QTRI_BATCH_ROOM];
    const qtri_colors *kind;
    uint32_t alpha; /* of all: material.alpha, 0..255 */
    bool wide;      /* each has its own, in the high byte of its colour */
} mixture;

static void begin(mixture *m, const qtri_raster *raster, const uint32_t *place, uint32_t mask,
                  int32_t count)
{
    m->wide = raster->wide;
    m->kind = m->wide ? &qtri_colors_888 : raster->format->colors;
    m->alpha = raster->alpha;
    gather(m->stored, raster, place, mask, count);
    decode(m->stored, raster->format, m->wide, count);
}

static void finish(const mixture *m, const qtri_raster *raster, uint32_t *color, int32_t count)
{
    if (m->wide) {
        for (int32_t i = 0; i < count; i++) {
            color[i] &= 0xFFFFFF;
        }
        narrow(raster->format, color, count);
    }
}

/* Alpha times alpha of 255, rounded. */
static inline uint32_t product(uint32_t a, uint32_t b)
{
    const uint32_t p = a * b + 128;
    return (p + (p >> 8)) >> 8;
}

static inline uint32_t share_of(const mixture *m, uint32_t color)
{
    return ((color >> 24) * m->alpha * 1032 + 32768) >> 16; /* 255 255 is 1024 */
}

#define OVER(c, s, k, most) qtri_mix_over(c, s, k)

static inline uint32_t sum(uint32_t c, uint32_t s, uint32_t k, uint32_t most)
{
    const uint32_t all = s + ((c * k + 512) >> 10);
    return all < most ? all : most;
}

/* c s / most, rounded; within .02 more for most = 63. */
static inline uint32_t times(uint32_t c, uint32_t s, uint32_t most)
{
    const uint32_t p = c * s;
    if (most == 255) {
        return product(c, s);
    }
    return most == 31 ? (p * 1057 + 16384) >> 15 : (p * 1040 + 32768) >> 16;
}
#define TIMES(c, s, k, most) ((void)(k), times(c, s, most))

#define SUM_565(c, s, k)   QTRI_MIX_565(sum, c, s, k)
#define TIMES_565(c, s, k) QTRI_MIX_565(TIMES, c, s, k)

#define MIX(CHANNEL, PIXEL_565)                                                                    \
    mixture m;                                                                                     \
    begin(&m, raster, place, mask, count);                                                         \
    if (m.wide) {                                                                                  \
        QTRI_MIX(color, m.stored[i], count, &qtri_colors_888, share_of(&m, color[i]), CHANNEL,     \
                 PIXEL_565)                                                                        \
    } else {                                                                                       \
        const uint32_t share = qtri_mix_share(m.alpha);                                            \
        QTRI_MIX(color, m.stored[i], count, m.kind, share, CHANNEL, PIXEL_565)                     \
    }                                                                                              \
    finish(&m, raster, color, count);                                                              \
    return mask;

static uint32_t blend_alpha(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                            uint32_t mask, int32_t count)
{
    MIX(OVER, qtri_mix_over_565)
}

static uint32_t blend_add(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                          uint32_t mask, int32_t count)
{
    MIX(sum, SUM_565)
}

static uint32_t blend_multiply(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                               uint32_t mask, int32_t count)
{
    MIX(TIMES, TIMES_565)
}

static uint32_t blend_none(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                           uint32_t mask, int32_t count)
{
    mixture m;
    begin(&m, raster, place, mask, count);
    for (int32_t i = 0; i < count; i++) {
        color[i] = m.stored[i];
    }
    finish(&m, raster, color, count);
    return mask;
}

/* Bayer's pattern, by rows and columns of the frame: drawn where alpha is more than 16 of it + 8.
 */
static uint32_t screen_door(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                            uint32_t mask, int32_t count)
{
    static const uint8_t pattern[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const uint32_t first_row = (uint32_t)raster->surface->first_row;
    uint32_t bit = (uint32_t)1 << (count - 1);
    for (int32_t i = 0; i < count; i++, bit >>= 1) {
        const uint32_t step = pattern[((place[i] >> 16) + first_row) & 3][place[i] & 3];
        const uint32_t alpha =
            raster->wide ? product(color[i] >> 24, raster->alpha) : raster->alpha;
        mask &= alpha > 16 * step + 8 ? UINT32_MAX : ~bit;
    }
    if (raster->wide) {
        narrow(raster->format, color, count);
    }
    return mask;
}

const qtri_blend qtri_blend_alpha = {qtri_effects, blend_alpha, false};
const qtri_blend qtri_blend_add = {qtri_effects, blend_add, false};
const qtri_blend qtri_blend_multiply = {qtri_effects, blend_multiply, false};
const qtri_blend qtri_blend_none = {qtri_effects, blend_none, false};
const qtri_blend qtri_blend_screen_door = {qtri_effects, screen_door, true};
