/* SPDX-License-Identifier: MIT */
#include "blend_row.h"
#include "stage_color.h"

#include "../frame/barrier.h"
#include "../frame/mix.h"

/* Where fragment i is in memory. */
static inline const uint8_t *pixel_at(const qtri_raster *raster, const qtri_fragments *at,
                                      int32_t i)
{
    const qtri_surface *surface = raster->surface;
    const uint32_t place = at->place != NULL ? at->place[i] : at->first + (uint32_t)i;
    return surface->pixels + (ptrdiff_t)(place >> 16) * surface->pitch +
           (ptrdiff_t)((place & 0xFFFF) * raster->format->pixels->bytes);
}

/* Stored pixels of two bytes: those of a row are read where they are. */
static const uint16_t *gather_16(uint16_t *stored, const qtri_raster *raster,
                                 const qtri_fragments *at, int32_t count)
{
    const uint8_t *pixels = raster->surface->pixels;
    const ptrdiff_t pitch = raster->surface->pitch;
    const uint32_t *place = at->place;
    uint16_t *out = stored;
    if (place == NULL) {
        return (const uint16_t *)(const void *)pixel_at(raster, at, 0);
    }
    for (const uint16_t *end = out + count; out != end; out++) {
        const uint32_t from = *place++;
        const uint8_t *row = pixels + (ptrdiff_t)(from >> 16) * pitch;
        *out = ((const uint16_t *)(const void *)row)[from & 0xFFFF];
    }
    return stored;
}

/* Stored pixels of any size. */
static void gather(uint32_t *stored, const qtri_raster *raster, const qtri_fragments *at,
                   int32_t count)
{
    const qtri_pixels *memory = raster->format->pixels;
    for (int32_t i = 0; i < count; i++) {
        stored[i] = memory->load(pixel_at(raster, at, i));
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
    union {
        uint32_t words[QTRI_BATCH + 3];   /* stages work on four at a time */
        uint16_t halves[QTRI_BATCH_ROOM]; /* of the kind 565 */
    } stored;
    const uint16_t *under; /* of the kind 565 what is stored: halves, or the pixels */
    const qtri_colors *kind;
    uint32_t alpha; /* of all: material.alpha, 0..255 */
    bool wide;      /* each has its own, in the high byte of its colour */
} mixture;

/* Of colours of the kind 565: whether pixels are that as they are, or with their bytes exchanged.
 */
static bool are_565(const qtri_format *format)
{
    return format->pixels->bytes == 2 &&
           (format->encode == NULL || format->decode == qtri_decode_rgb565_swapped);
}

static void load(mixture *m, const qtri_raster *raster, const qtri_fragments *at, int32_t count)
{
    m->wide = raster->wide;
    m->kind = m->wide ? &qtri_colors_888 : raster->format->colors;
    m->alpha = raster->alpha;
    if (m->kind == &qtri_colors_565 && are_565(raster->format)) {
        m->under = gather_16(m->stored.halves, raster, at, count);
    } else {
        m->under = m->stored.halves;
        gather(m->stored.words, raster, at, count);
    }
}

/* To the kind that is mixed. */
static void convert(mixture *m, const qtri_format *format, int32_t count)
{
    if (m->kind == &qtri_colors_565 && are_565(format)) {
        if (format->encode == NULL) {
            return;
        }
        for (int32_t i = 0; i < count; i++) {
            m->stored.halves[i] = (uint16_t)(m->under[i] << 8 | m->under[i] >> 8);
        }
        m->under = m->stored.halves;
        return;
    }
    decode(m->stored.words, format, m->wide, count);
    for (int32_t i = 0; m->kind == &qtri_colors_565 && i < count; i++) {
        // NOLINTNEXTLINE(clang-analyzer-core.*): load() has set what the kind needs
        m->stored.halves[i] = (uint16_t)m->stored.words[i]; /* not beyond the word */
    }
}

/* One after the other, so that neither's stack is beneath the other's. */
QTRI_INLINE void begin(mixture *m, const qtri_raster *raster, const qtri_fragments *at,
                       int32_t count)
{
    load(m, raster, at, count);
    convert(m, raster->format, count);
}

/* The bits of a colour that stay as they are. */
static uint32_t kept_bits(const qtri_colors *kind, uint32_t keep)
{
    const uint32_t red = keep & QTRI_KEEP_RED;
    const uint32_t green = keep & QTRI_KEEP_GREEN;
    const uint32_t blue = keep & QTRI_KEEP_BLUE;
    if (kind->single) {
        return red != 0 && green != 0 && blue != 0 ? 255 : 0;
    }
    return kind == &qtri_colors_565
               ? (red != 0 ? 0xF800u : 0) | (green != 0 ? 0x07E0u : 0) | (blue != 0 ? 0x1Fu : 0)
               : (red != 0 ? 0xFF0000u : 0) | (green != 0 ? 0xFF00u : 0) | (blue != 0 ? 255u : 0);
}

/* Of the kind that was mixed to that of the format, without what is to stay. */
static void finish(const mixture *m, const qtri_raster *raster, uint32_t *color, int32_t count)
{
    if (raster->keep != 0) {
        const uint32_t kept = kept_bits(m->kind, raster->keep);
        for (int32_t i = 0; i < count; i++) {
            // NOLINTNEXTLINE(clang-analyzer-core.*): begin() has set what the kind needs
            const uint32_t stored = m->kind == &qtri_colors_565 ? m->under[i] : m->stored.words[i];
            color[i] = (color[i] & ~kept) | (stored & kept);
        }
    }
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

/*
 * Shares of 8 bits a channel: 65536 is 1, so that what they are off is less than 1/256 of a step
 * and all but nothing is added to the two halves that rounding takes. Of an alpha of 255, and of
 * the product of two.
 */
static inline uint32_t share_of_alpha(uint32_t alpha)
{
    return alpha * 257 + (alpha >> 7); /* within 1/2 */
}

static inline uint32_t share_of(const mixture *m, uint32_t color)
{
    return (color >> 24) * m->alpha * 33026 >> 15; /* within 1; 255 255 is 65536 */
}

static inline uint32_t over(uint32_t c, uint32_t s, uint32_t k)
{
    const int32_t difference = (int32_t)(c - s) * (int32_t)k; /* |.| <= 255 2^16 */
    return s + (uint32_t)((difference + 32768) >> 16);
}
#define OVER(c, s, k, most) over(c, s, k)

static inline uint32_t sum(uint32_t c, uint32_t s, uint32_t k, uint32_t most)
{
    const uint32_t all = s + ((c * k + 32768) >> 16);
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

#define RED_BLUE 0xF81Fu
#define GREEN    0x07E0u

/* ONE(i), which replaces color[i], four at a time: they move on with what is under them. */
#ifdef __OPTIMIZE_SIZE__
#define EACH_565
#else
#define EACH_565                                                                                   \
    for (; count >= 4; count -= 4) {                                                               \
        ONE(0) ONE(1) ONE(2) ONE(3) color += 4;                                                    \
        under += 4;                                                                                \
        QTRI_OPAQUE(color)                                                                         \
        QTRI_OPAQUE(under)                                                                         \
    }
#endif
#define FOR_565                                                                                    \
    EACH_565                                                                                       \
    for (; count > 0; count--) {                                                                   \
        ONE(0)                                                                                     \
        color++;                                                                                   \
        under++;                                                                                   \
        QTRI_OPAQUE(color)                                                                         \
    }

/* Words, each over the pixel beneath it. */
QTRI_NOINLINE static void over_565(uint32_t *color, const uint16_t *under, int32_t count,
                                   uint32_t alpha)
{
    const qtri_share_565 share = qtri_share_565_of(alpha);
    QTRI_OVER_565_BEGIN(share)
#define ONE(i)                                                                                     \
    {                                                                                              \
        uint32_t c = color[i];                                                                     \
        uint32_t u = under[i];                                                                     \
        QTRI_OVER_565(c, u)                                                                        \
        color[i] = x | c;                                                                          \
        QTRI_OPAQUE(color)                                                                         \
        QTRI_OVER_565_ASIDE                                                                        \
    }
    FOR_565
#undef ONE
}

/*
 * under + color, at most full. Channels are apart, green above, and what one has too much is the
 * bit after it: less its lowest bit, that fills the channel.
 */
QTRI_NOINLINE static void sum_565(uint32_t *color, const uint16_t *under, int32_t count)
{
    uint32_t lanes = 0x07E0F81Fu;
    uint32_t over = 0x08010020u;
    QTRI_OPAQUE(lanes)
    QTRI_OPAQUE(over)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t c = color[i];                                                               \
        const uint32_t u = under[i];                                                               \
        uint32_t x = ((c | c << 16) & lanes) + ((u | u << 16) & lanes);                            \
        const uint32_t full = x & over;                                                            \
        x |= full - (full >> 5);                                                                   \
        x = (x | full >> 6) & lanes; /* green has six bits */                                      \
        color[i] = x | x >> 16;      /* what is above is not the pixel's */                        \
        QTRI_OPAQUE(color)                                                                         \
    }
    FOR_565
#undef ONE
}

/* A share of each colour is added, rounded. */
QTRI_NOINLINE static void add_565(uint32_t *color, const uint16_t *under, int32_t count,
                                  uint32_t alpha)
{
    const qtri_share_565 share = qtri_share_565_of(alpha);
    uint32_t mask = RED_BLUE;
    uint32_t lanes = 0x07E0F81Fu;
    uint32_t over = 0x08010020u;
    uint32_t half = 0x10020u;
    uint32_t green_half = 0x1000u;
    uint32_t red_blue = share.red_blue;
    uint32_t green = share.green;
    QTRI_OPAQUE(half)
    QTRI_OPAQUE(green_half)
#define ONE(i)                                                                                     \
    {                                                                                              \
        uint32_t c = color[i];                                                                     \
        const uint32_t u = under[i];                                                               \
        uint32_t x = ((c & mask) * red_blue + half) >> 6 & mask;                                   \
        c = ((c & GREEN) * green + green_half) << 8 & (lanes ^ mask);                              \
        x = (x | c) + ((u | u << 16) & lanes);                                                     \
        c = x & over;                                                                              \
        x |= c - (c >> 5);                                                                         \
        x = (x | c >> 6) & lanes;                                                                  \
        color[i] = x | x >> 16;                                                                    \
        QTRI_OPAQUE(color)                                                                         \
        QTRI_ASIDE(half)                                                                           \
        QTRI_ASIDE(green_half)                                                                     \
        QTRI_ASIDE(green)                                                                          \
        QTRI_ASIDE(red_blue)                                                                       \
        QTRI_ASIDE(over)                                                                           \
        QTRI_OPAQUE(lanes)                                                                         \
        QTRI_OPAQUE(mask)                                                                          \
    }
    FOR_565
#undef ONE
}

/*
 * What is stored under a row of which nothing else is to be known: pixels that are colours of the
 * kind 565, all channels of which are written. NULL: not that.
 */
static inline const uint16_t *plain_row(const qtri_raster *raster, const qtri_fragments *at)
{
    const qtri_format *format = raster->format;
    if (at->place != NULL || raster->wide || raster->keep != 0 ||
        format->colors != &qtri_colors_565 || format->encode != NULL ||
        format->pixels->bytes != 2) {
        return NULL;
    }
    return (const uint16_t *)(const void *)pixel_at(raster, at, 0);
}

static inline uint32_t times_565(uint32_t c, uint32_t u)
{
    return times(c >> 11 & 31, u >> 11, 31) << 11 | times(c >> 5 & 63, u >> 5 & 63, 63) << 5 |
           times(c & 31, u & 31, 31);
}

#define MIX(CHANNEL)                                                                               \
    if (m.wide) {                                                                                  \
        QTRI_MIX(color, m.stored.words[i], count, &qtri_colors_888, share_of(&m, color[i]),        \
                 CHANNEL)                                                                          \
    } else {                                                                                       \
        const uint32_t share = share_of_alpha(m.alpha);                                            \
        QTRI_MIX(color, m.stored.words[i], count, m.kind, share, CHANNEL)                          \
    }

static inline void over_row(const qtri_raster *raster, uint32_t *color, const uint16_t *under,
                            int32_t count)
{
    if (raster->finer) {
        raster->fog->stages->over(color, under, count, raster->alpha);
    } else {
        over_565(color, under, count, raster->alpha);
    }
}

QTRI_NOINLINE static uint32_t mix_alpha(const qtri_raster *raster, uint32_t *color,
                                        const qtri_fragments *at, uint32_t mask, int32_t count)
{
    mixture m;
    begin(&m, raster, at, count);
    if (m.kind == &qtri_colors_565) {
        over_row(raster, color, m.under, count);
    } else {
        MIX(OVER)
    }
    finish(&m, raster, color, count);
    return mask;
}

static uint32_t blend_alpha(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                            uint32_t mask, int32_t count)
{
    const uint16_t *under = plain_row(raster, at);
    if (under == NULL) {
        return mix_alpha(raster, color, at, mask, count);
    }
    over_row(raster, color, under, count);
    return mask;
}

static void add_all_565(uint32_t *color, const uint16_t *under, int32_t count, uint32_t alpha)
{
    if (alpha == 255) {
        sum_565(color, under, count);
    } else {
        add_565(color, under, count, alpha);
    }
}

QTRI_NOINLINE static uint32_t mix_add(const qtri_raster *raster, uint32_t *color,
                                      const qtri_fragments *at, uint32_t mask, int32_t count)
{
    mixture m;
    begin(&m, raster, at, count);
    if (m.kind == &qtri_colors_565) {
        add_all_565(color, m.under, count, m.alpha);
        for (int32_t i = 0; !are_565(raster->format) && i < count; i++) {
            color[i] &= 0xFFFF; /* other formats know of no bits above a colour's */
        }
    } else {
        MIX(sum)
    }
    finish(&m, raster, color, count);
    return mask;
}

static uint32_t blend_add(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                          uint32_t mask, int32_t count)
{
    const uint16_t *under = plain_row(raster, at);
    if (under == NULL) {
        return mix_add(raster, color, at, mask, count);
    }
    add_all_565(color, under, count, raster->alpha);
    return mask;
}

static uint32_t blend_multiply(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                               uint32_t mask, int32_t count)
{
    mixture m;
    begin(&m, raster, at, count);
    if (m.kind == &qtri_colors_565) {
        for (int32_t i = 0; i < count; i++) {
            color[i] = times_565(color[i], m.under[i]);
        }
    } else {
        MIX(TIMES)
    }
    finish(&m, raster, color, count);
    return mask;
}

static uint32_t blend_none(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                           uint32_t mask, int32_t count)
{
    mixture m;
    begin(&m, raster, at, count);
    for (int32_t i = 0; i < count; i++) {
        color[i] = m.kind == &qtri_colors_565 ? m.under[i] : m.stored.words[i];
    }
    finish(&m, raster, color, count);
    return mask;
}

static uint32_t blend_replace(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                              uint32_t mask, int32_t count)
{
    mixture m;
    begin(&m, raster, at, count);
    finish(&m, raster, color, count);
    return mask;
}

/* Bayer's pattern, by rows and columns of the frame: drawn where alpha is more than 16 of it + 8.
 */
static uint32_t screen_door(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                            uint32_t mask, int32_t count)
{
    static const uint8_t pattern[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const uint32_t first_row = (uint32_t)raster->surface->first_row;
    uint32_t bit = (uint32_t)1 << (count - 1);
    for (int32_t i = 0; i < count; i++, bit >>= 1) {
        const uint32_t place = at->place != NULL ? at->place[i] : at->first + (uint32_t)i;
        const uint32_t step = pattern[((place >> 16) + first_row) & 3][place & 3];
        const uint32_t alpha =
            raster->wide ? product(color[i] >> 24, raster->alpha) : raster->alpha;
        mask &= alpha > 16 * step + 8 ? UINT32_MAX : ~bit;
    }
    if (raster->wide) {
        narrow(raster->format, color, count);
    }
    return mask;
}

const qtri_blend qtri_blend_alpha = {
    &qtri_effects, blend_alpha, qtri_blend_row_alpha, qtri_blend_list_alpha, false, NULL,
    true,          QTRI_ALPHA};
const qtri_blend qtri_blend_add = {
    &qtri_effects, blend_add, qtri_blend_row_add, qtri_blend_list_add, false, NULL,
    false,         QTRI_ADD};
const qtri_blend qtri_blend_multiply = {&qtri_effects, blend_multiply, NULL,  NULL,
                                        false,         NULL,           false, QTRI_MULTIPLY};
const qtri_blend qtri_blend_none = {&qtri_effects, blend_none, NULL,  NULL,
                                    false,         NULL,       false, QTRI_KEEP_PIXEL};
const qtri_blend qtri_blend_replace = {&qtri_effects, blend_replace, NULL,  NULL,
                                       false,         NULL,          false, QTRI_STORE};
const qtri_blend qtri_blend_screen_door = {&qtri_effects, screen_door, NULL,  NULL,
                                           true,          NULL,        false, QTRI_SCREEN_DOOR};
