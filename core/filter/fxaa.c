/* SPDX-License-Identifier: MIT */
/*
 * FXAA over a surface: fxaa.inc filters a pixel, in any format and in RGB565; here are the loops
 * over rows, and the ring buffers of rows not yet filtered.
 */
#include "qtri/antialias.h"

#include "../frame/pixel.h"
#include "mix.h"

/* Differences of luma below this stay, as do those below 1/8 of the greatest. */
enum { LUMA_MIN = 10 };

/* 2^16 / n, rounded, for lengths of edges. */
static const uint16_t inverses[2 * QTRI_FXAA_REACH + 1] = {
    0,    0,    32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461,
    5041, 4681, 4369,  4096,  3855,  3641,  3449,  3277, 3121, 2979, 2849, 2731};

static inline int32_t magnitude(int32_t x)
{
    return x < 0 ? -x : x;
}

/* Whether a pixel's luma and that of its four neighbours differ too little to look further. */
static inline bool is_flat(int32_t m, int32_t a, int32_t b, int32_t c, int32_t d)
{
    const int32_t low = qtri_least32(qtri_least32(m, qtri_least32(a, b)), qtri_least32(c, d));
    const int32_t high =
        qtri_greatest32(qtri_greatest32(m, qtri_greatest32(a, b)), qtri_greatest32(c, d));
    return high - low < LUMA_MIN || (high - low) * 8 < high;
}

/* The weight, in 1/32, of a pixel's neighbour across an edge. The edge ends `first` pixels to one
   side and `last` to the other, where the luma of its two sides departs by first_end and last_end.
 */
static uint32_t share_of(int32_t first, int32_t last, int32_t first_end, int32_t last_end,
                         int32_t step, int32_t side)
{
    const int32_t nearer = first < last ? first : last;
    const int32_t end = first < last ? first_end : last_end;
    if (magnitude(end) < step || (end < 0) == (side < 0)) {
        return 0; /* no end within reach, or of the other side */
    }
    return 16u - ((uint32_t)nearer * inverses[first + last] >> 11); /* 32 nearer / sum */
}

/* ---- Any format: rows are decoded, with their luma in the high byte ---- */

enum { LUMA_SHIFT = 24, ROWS = 5 };

/* Weights 2 4 1, of 565 without a multiplication: 0..223 as (2 r + 4 g + b) / 8 of 8 bits. */
static uint32_t luma_of(const qtri_colors *kind, uint32_t color)
{
    if (kind->single) {
        return (color & 0xFF) * 7 >> 3;
    }
    if (kind->red == 11) {
        return 2 * (color >> 11) + (color >> 4 & 0x7E) + (color & 31);
    }
    return (2 * (color >> 16 & 0xFF) + 4 * (color >> 8 & 0xFF) + (color & 0xFF)) >> 3;
}

#define NAME(name)           name##_any
#define COLOR                uint32_t
#define LUMA(c)              ((int32_t)((c) >> LUMA_SHIFT))
#define MIX(w, a, b, s)      qtri_mix_colors((w)->kind, a, b, s)
#define MEMBERS              const qtri_colors *kind;
#define LIGHT                uint32_t
#define LIGHTS(w, i)         ((w)->row[i])
#define LUMAS(w, i, x, side) (LUMA((w)->row[i][x]) + LUMA((w)->row[i][(x) + (side)]))
#include "fxaa.inc"

static void decode_row(const qtri_surface *surface, int32_t y, uint32_t *out)
{
    const qtri_format *format = surface->format;
    const uint8_t *pixel = qtri_surface_at(surface, 0, y);
    for (int32_t x = 0; x < surface->width; x++) {
        const uint32_t color = qtri_color_of(format, format->pixels->load(pixel));
        out[x] = color | luma_of(format->colors, color) << LUMA_SHIFT;
        pixel += format->pixels->bytes;
    }
}

QTRI_NOINLINE static void filter_rows_any(const qtri_surface *surface, qtri_rect bounds,
                                          uint32_t *memory)
{
    const int32_t width = surface->width;
    const qtri_format *format = surface->format;
    const int32_t first = bounds.x0 > 0 ? bounds.x0 : 1;
    const int32_t end = bounds.x1 < width ? bounds.x1 : width - 1;
    window_any w = {{NULL, NULL, NULL, NULL, NULL}, format->colors};
    for (int32_t y = bounds.y0 - 2; y < bounds.y1; y++) {
        /* Row y + 2 is decoded before it is filtered, in place of y - 3. */
        uint32_t *slot = memory + (ptrdiff_t)((y + 2) % ROWS) * width;
        for (int i = 0; i < ROWS - 1; i++) {
            w.row[i] = w.row[i + 1];
        }
        w.row[ROWS - 1] = NULL;
        if (y + 2 < bounds.y1) {
            decode_row(surface, y + 2, slot);
            w.row[ROWS - 1] = slot;
        }
        if (w.row[1] == NULL || w.row[3] == NULL) { /* no row above, or below */
            continue;
        }
        uint8_t *row = qtri_surface_at(surface, 0, y);
        for (int32_t x = first; x < end; x++) {
            const uint32_t old = w.row[2][x];
            const uint32_t color = filter_any(&w, x, width);
            if (color != old) {
                const uint32_t stored = qtri_stored_of(format, color & 0xFFFFFF);
                format->pixels->store(row + x * (ptrdiff_t)format->pixels->bytes, &stored, 1, 1);
            }
        }
    }
}

/* ---- RGB565: lumas of two pixels at once ---- */

/* Lumas of two pixels, the first in the lower half: what is masked is masked once for both. */
static inline uint32_t lumas_of_two(uint32_t two)
{
    return (two >> 10 & 0x003E003Eu) + (two >> 4 & 0x007E007Eu) + (two & 0x001F001Fu);
}

static inline uint32_t lumas_565(uint32_t first, uint32_t second)
{
    return lumas_of_two(first | second << 16);
}

/* The sum of the lumas of columns x and x + side. */
static inline int32_t luma_sum(const uint16_t *row, int32_t x, int32_t side)
{
    const uint32_t two = lumas_565(row[x], row[x + side]);
    return (int32_t)((two + (two >> 16)) & 0xFFFF);
}

static inline int32_t kept_sum(const uint16_t *lumas, int32_t x, int32_t side)
{
    return lumas[x] + lumas[x + side];
}

#define NAME(name)   name##_565
#define COLOR        uint16_t
#define MEMBERS      const uint16_t *lumas[5]; /* of rows 1 to 3 */
#define LIGHT        uint16_t
#define LUMA(l)      ((int32_t)(l))
#define LIGHTS(w, i) ((w)->lumas[i])
#define LUMAS(w, i, x, side)                                                                       \
    ((i) == 0 || (i) == 4 ? luma_sum((w)->row[i], x, side) : kept_sum((w)->lumas[i], x, side))
#define MIX(w, a, b, s) qtri_lerp_565(a, b, s)
#include "fxaa.inc"

/* Old colours that are kept: of this row and two above; lumas: of this row and its neighbours. */
enum { KEPT_ROWS = 3 };

static void filter_pixels(const window_565 *w, uint16_t *out, int32_t x, int32_t end, int32_t width)
{
    for (; x < end; x++) {
        out[x] = (uint16_t)filter_565(w, x, width);
    }
}

/*
 * Two lumas in one word, 0..255 in halves of 16 bits. With a half's highest bit set nothing is
 * borrowed from the other half, and the bit stays where the difference is not below 0.
 */
enum { HALF_BIT = 15 };
static const uint32_t high_bits = 0x80008000u;

/* By how much each half of a is above that of b; 0 where it is not. */
static inline uint32_t above_two(uint32_t a, uint32_t b)
{
    const uint32_t difference = (a | high_bits) - b;
    const uint32_t is_above = difference & high_bits;
    return difference & (is_above - (is_above >> HALF_BIT));
}

/* !is_flat() of two pixels m and their neighbours, as the high bits of halves. */
static inline uint32_t edges_of_two(uint32_t m, uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    QTRI_HOLD(a); /* GCC 12 would compute what follows for flat pixels too */
    QTRI_HOLD(c);
    const uint32_t first = above_two(a, b);
    const uint32_t second = above_two(c, d);
    const uint32_t high_1 = b + first;
    const uint32_t low_1 = a - first;
    const uint32_t high_2 = d + second;
    const uint32_t low_2 = c - second;
    uint32_t high = high_2 + above_two(high_1, high_2);
    uint32_t low = low_1 - above_two(low_1, low_2);
    high += above_two(m, high);
    low -= above_two(low, m);
    const uint32_t range = high - low;
    return (range + 0x80008000u - 0x00010001u * LUMA_MIN) & ((range << 3 | high_bits) - high) &
           high_bits;
}

/* Whether the first of two pixels is in the lower half of their word. */
static inline bool is_first_low(void)
{
    const union {
        uint32_t word;
        uint16_t first;
    } one = {1};
    return one.first == 1;
}

/* The high bit of the first or the second pixel's half. */
static inline uint32_t bit_of(bool first)
{
    return (uint32_t)1 << (is_first_low() == first ? HALF_BIT : 16 + HALF_BIT);
}

/* Filters pixels x and x + 1, each if the high bit of its half is set. */
QTRI_NOINLINE static void resolve_two(const window_565 *w, uint16_t *out, int32_t x, int32_t width,
                                      uint32_t edges)
{
    if ((edges & bit_of(true)) != 0) {
        out[x] = (uint16_t)resolve_565(w, x, width);
    }
    if ((edges & bit_of(false)) != 0) {
        out[x + 1] = (uint16_t)resolve_565(w, x + 1, width);
    }
}

/* A word of two pixels, moved by one: another comes in at the left, or at the right. */
static inline uint32_t moved_in(uint32_t two, uint32_t other, bool at_left)
{
    return is_first_low() == at_left ? two << 16 | other : two >> 16 | other << 16;
}

/*
 * Filters columns x..end - 1, x even and at least 2. Most pixels' lumas are at most 3 less and 4
 * more than those of all neighbours, which is flat: that is tested for two at once, in halves of a
 * word. A half below 0 borrows from the other, but then has high bits itself.
 */
QTRI_NOINLINE static void filter_pairs(const window_565 *w, uint16_t *out, int32_t x, int32_t end,
                                       int32_t width)
{
    const uint32_t near = 0x00040004u;
    const uint16_t *up = w->lumas[1];
    const uint16_t *own = w->lumas[2];
    const uint16_t *down = w->lumas[3];
    for (; x + 1 < end; x += 2) {
        const uint32_t both = *(const qtri_word *)(const void *)(own + x);
        const uint32_t above = *(const qtri_word *)(const void *)(up + x);
        const uint32_t below = *(const qtri_word *)(const void *)(down + x);
        const uint32_t left = moved_in(both, own[x - 1], true);
        const uint32_t right = moved_in(both, own[x + 2], false);
        const uint32_t most = both + near;
        if ((((most - above) | (most - below) | (most - left) | (most - right)) & ~0x00070007u) !=
            0) {
            const uint32_t edges = edges_of_two(both, above, below, left, right);
            if (edges != 0) {
                resolve_two(w, out, x, width, edges);
            }
        }
    }
    filter_pixels(w, out, x, end, width);
}

/* The columns first..end - 1 of a row that differ from the colour that it begins and ends with. */
typedef struct extent {
    uint32_t color; /* of two pixels */
    int32_t first, end;
} extent;

static extent extent_of(const uint16_t *row, int32_t width)
{
    const qtri_word *words = (const qtri_word *)(const void *)row;
    const int32_t count = width / 2;
    const uint32_t color = words[0];
    extent e = {color, 0, width};
    if (color != (color << 16 | color >> 16)) {
        return e;
    }
    const qtri_word *at = words;
    const qtri_word *end = words + count;
    while (at != end && *at == color) {
        at++;
    }
    e.first = 2 * (int32_t)(at - words);
    while (end != at && end[-1] == color) {
        end--;
    }
    e.end = end == at ? 0 : 2 * (int32_t)(end - words); /* first is the width where that is 0 */
    return e;
}

/* Columns that differ from a neighbour lie in first..end - 1, of a row between two others. */
static extent extent_of_three(const extent *a, const extent *b, const extent *c, int32_t width)
{
    extent e = {b->color, 0, width};
    if (a->color == b->color && b->color == c->color) {
        e.first = qtri_least32(a->first, qtri_least32(b->first, c->first)) - 2;
        e.end = qtri_greatest32(a->end, qtri_greatest32(b->end, c->end)) + 2;
    }
    return e;
}

static uint16_t *row_of(const qtri_surface *surface, int32_t y)
{
    return (uint16_t *)(void *)qtri_surface_at(surface, 0, y);
}

static void fill_words(qtri_word *to, int32_t count, uint32_t word)
{
    if (count > 0) {
        qtri_fill_words((uint8_t *)to, 0, 4 * (size_t)count, 1, word);
    }
}

/* Copies a row's colours, or sets its lumas; outside of its extent all are one. */
static void keep_row(uint32_t *out, const uint16_t *row, const extent *e, int32_t width, bool pairs,
                     bool luma)
{
    if (!pairs) {
        uint16_t *to = (uint16_t *)(void *)out;
        for (int32_t x = 0; x < width; x++) {
            to[x] = (uint16_t)(luma ? lumas_565(row[x], 0) : row[x]);
        }
        return;
    }
    qtri_word *to = (qtri_word *)out;
    const qtri_word *from = (const qtri_word *)(const void *)row;
    const int32_t first = e->first / 2;
    const int32_t end = qtri_greatest32(e->end / 2, first); /* e->end is 0 where there is nothing */
    const uint32_t about = luma ? lumas_of_two(e->color) : e->color;
    fill_words(to, first, about);
    if (luma) {
        for (int32_t i = first; i < end; i++) {
            to[i] = lumas_of_two(from[i]);
        }
    } else {
        qtri_copy((uint8_t *)(to + first), (const uint8_t *)(from + first),
                  4 * (size_t)(end - first));
    }
    fill_words(to + end, width / 2 - end, about);
}

/* Where lumas of the row below the filtered one come from and go to. */
typedef struct incoming {
    const qtri_surface *surface;
    uint32_t *memory; /* KEPT_ROWS rows of colours, KEPT_ROWS of lumas */
    int32_t words;    /* of a row */
    bool pairs;
} incoming;

static const uint16_t *come_in(const incoming *in, int32_t y, extent *e)
{
    const uint16_t *row = row_of(in->surface, y);
    uint32_t *lumas = in->memory + (ptrdiff_t)(KEPT_ROWS + y % KEPT_ROWS) * in->words;
    if (in->pairs) {
        *e = extent_of(row, in->surface->width);
    }
    keep_row(lumas, row, e, in->surface->width, in->pairs, true);
    return (const uint16_t *)(const void *)lumas;
}

QTRI_NOINLINE static void filter_rows_565(const qtri_surface *surface, qtri_rect bounds,
                                          uint32_t *memory)
{
    const int32_t width = surface->width;
    const incoming in = {surface, memory, (width + 1) / 2,
                         qtri_begins_with_words(surface) && (width & 1) == 0};
    window_565 w = {{NULL, NULL, NULL, NULL, NULL}, {NULL, NULL, NULL, NULL, NULL}};
    extent rows[KEPT_ROWS] = {{0, 0, width}, {0, 0, width}, {0, 0, width}}; /* above, this, below */
    w.lumas[3] = come_in(&in, bounds.y0, &rows[2]);
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint32_t *slot = memory + (ptrdiff_t)(y % KEPT_ROWS) * in.words;
        keep_row(slot, row_of(surface, y), &rows[2], width, in.pairs, false);
        w.row[0] = w.row[1];
        w.row[1] = w.row[2];
        w.row[2] = (const uint16_t *)(const void *)slot;
        w.row[3] = y + 1 < bounds.y1 ? row_of(surface, y + 1) : NULL;
        w.row[4] = y + 2 < bounds.y1 ? row_of(surface, y + 2) : NULL;
        w.lumas[1] = w.lumas[2];
        w.lumas[2] = w.lumas[3];
        rows[0] = rows[1];
        rows[1] = rows[2];
        if (w.row[3] != NULL) {
            w.lumas[3] = come_in(&in, y + 1, &rows[2]);
        }
        if (w.row[1] != NULL && w.row[3] != NULL) {
            const extent all = extent_of_three(&rows[0], &rows[1], &rows[2], width);
            const int32_t first = qtri_greatest32(all.first, bounds.x0 > 0 ? bounds.x0 : 1);
            const int32_t end = qtri_least32(all.end, bounds.x1 < width ? bounds.x1 : width - 1);
            const int32_t even = qtri_least32((first + 1) & ~1, end);
            uint16_t *out = row_of(surface, y);
            filter_pixels(&w, out, first, even, width);
            filter_pairs(&w, out, even, end, width);
        }
    }
}

enum qtri_error qtri_fxaa(const qtri_surface *surface, uint32_t *memory, uint32_t words)
{
    QTRI_ASSERT(memory != NULL || words == 0);
    const qtri_rect bounds = qtri_surface_bounds(surface);
    if (bounds.x0 >= bounds.x1) {
        return QTRI_OK;
    }
    const bool is_565 = qtri_is_565(surface->format);
    if (memory == NULL ||
        words < (is_565 ? QTRI_FXAA_565_WORDS(surface->width) : QTRI_FXAA_WORDS(surface->width))) {
        return QTRI_ERROR_MEMORY;
    }
    if (is_565) {
        filter_rows_565(surface, bounds, memory);
    } else {
        filter_rows_any(surface, bounds, memory);
    }
    return QTRI_OK;
}
