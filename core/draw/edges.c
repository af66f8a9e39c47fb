/*
 * The pass over a surface: where notes are kept, and what becomes of them.
 *
 * A pixel that has got its share keeps its old colour for the pixels that take it as a neighbour:
 * in its note, which is spent, or, where a colour has more than two bytes, in a row of words. One
 * row is enough: pixels change from the top down and from the left to the right, and place x of
 * it holds the old colour of (x, y - 1) until (x, y) is through, and of (x, y) until (x + 1, y) is.
 */
#include "qtri/edges.h"

#include "edge_walk.h"

#include "../image/mix.h"

enum { WORD_PIXELS = 32 };

enum qtri_error qtri_edges_begin(qtri_edges *edges, const qtri_surface *surface, uint32_t *memory,
                                 uint32_t words)
{
    const qtri_rect nothing = {0, 0, 0, 0};
    const bool has_depth = surface->depth != NULL;
    const qtri_rect bounds = qtri_surface_bounds(surface);
    edges->surface = *surface;
    edges->bounds = nothing;
    if (bounds.x0 >= bounds.x1) {
        return QTRI_OK;
    }
    const ptrdiff_t pitch = has_depth ? surface->depth_pitch : (ptrdiff_t)surface->width;
    const ptrdiff_t magnitude = pitch < 0 ? -pitch : pitch;
    if (magnitude > QTRI_SURFACE_MAX * 8) {
        return QTRI_ERROR_MEMORY;
    }
    /* <= 2^16 2^13 */
    const uint32_t pixels = (uint32_t)magnitude * (uint32_t)surface->rows;
    const uint32_t marks = (pixels + WORD_PIXELS - 1) / WORD_PIXELS;
    const uint32_t line = surface->format->pixels->bytes > 2 ? (uint32_t)surface->width : 0;
    const uint32_t notes = has_depth ? 0 : (pixels + 1) / 2;
    if (words < marks + line + notes) {
        return QTRI_ERROR_MEMORY;
    }
    edges->marks = memory;
    edges->line = line != 0 ? memory + marks : NULL;
    edges->notes = has_depth ? surface->depth : (uint16_t *)(void *)(memory + marks + line);
    edges->pitch = (int32_t)pitch;
    edges->origin = 0;
    if (pitch < 0) { /* the last row is the first in memory */
        edges->origin = (int32_t)(pixels - (uint32_t)magnitude);
        edges->notes -= edges->origin;
    }
    for (uint32_t i = 0; i < marks; i++) {
        memory[i] = 0;
    }
    for (uint32_t i = 0; i < notes; i++) {
        memory[marks + line + i] = 0;
    }
    edges->bounds = bounds;
    return QTRI_OK;
}

/* A row inside of the bounds: its first note and the first pixel's place. */
typedef struct row {
    uint8_t *pixels; /* of column 0 */
    uint32_t place;  /* of column 0 */
} row;

static row row_of(const qtri_edges *edges, int32_t y)
{
    const int32_t down = y - edges->surface.first_row;
    const row r = {edges->surface.pixels + down * edges->surface.pitch,
                   (uint32_t)(edges->origin + down * edges->pitch)};
    return r;
}

/*
 * The marks of places `from` to end - 1 that are in the word of `from`, the first at bit 0; `from`
 * is moved behind them.
 */
static inline uint32_t next_marks(const qtri_edges *edges, uint32_t *from, uint32_t end)
{
    const uint32_t bit = *from % WORD_PIXELS;
    const uint32_t left = end - *from;
    uint32_t marks = edges->marks[*from / WORD_PIXELS] >> bit;
    uint32_t count = WORD_PIXELS - bit;
    if (left < count) {
        count = left;
        marks &= ((uint32_t)1 << left) - 1;
    }
    *from += count;
    return marks;
}

static inline uint32_t is_marked(const qtri_edges *edges, uint32_t place)
{
    return edges->marks[place / WORD_PIXELS] >> place % WORD_PIXELS & 1;
}

/* Zero bits at the low end that are certain, of a word that is not 0: 0, 4, 8 ... */
#define SKIP(marks, place)                                                                         \
    if (((marks)&0xFFFF) == 0) {                                                                   \
        (marks) >>= 16;                                                                            \
        (place) += 16;                                                                             \
    }                                                                                              \
    if (((marks)&0xFF) == 0) {                                                                     \
        (marks) >>= 8;                                                                             \
        (place) += 8;                                                                              \
    }                                                                                              \
    if (((marks)&0xF) == 0) {                                                                      \
        (marks) >>= 4;                                                                             \
        (place) += 4;                                                                              \
    }

/* The pixel at `place`, column x, of a row of 16-bit pixels. */
static inline void blend_565(const qtri_edges *edges, uint16_t *pixel, uint32_t place)
{
    uint16_t *note = &edges->notes[place];
    const uint32_t code = *note;
    const bool in_row = (code & QTRI_NOTE_IN_ROW) != 0;
    const uint32_t old = *pixel;
    uint32_t neighbour;
    if ((code & QTRI_NOTE_AFTER) != 0) {
        neighbour =
            in_row ? pixel[1] : *(uint16_t *)(void *)((uint8_t *)pixel + edges->surface.pitch);
    } else {
        const uint32_t other = in_row ? place - 1 : place - (uint32_t)edges->pitch;
        if (is_marked(edges, other) != 0) {
            neighbour = edges->notes[other];
        } else {
            neighbour =
                in_row ? pixel[-1] : *(uint16_t *)(void *)((uint8_t *)pixel - edges->surface.pitch);
        }
    }
    *note = (uint16_t)old;
    *pixel = (uint16_t)qtri_mix_565(old, neighbour, code >> QTRI_NOTE_SHARE_SHIFT);
}

enum qtri_error qtri_edges_blend_565(qtri_edges *edges)
{
    const qtri_rect *bounds = &edges->bounds;
    if (bounds->x0 < bounds->x1 && !qtri_is_565(edges->surface.format)) {
        return QTRI_ERROR_FORMAT;
    }
    for (int32_t y = bounds->y0; y < bounds->y1; y++) {
        const row r = row_of(edges, y);
        uint16_t *pixels = (uint16_t *)(void *)r.pixels;
        uint32_t from = r.place + (uint32_t)bounds->x0;
        const uint32_t end = r.place + (uint32_t)bounds->x1;
        while (from < end) {
            uint32_t place = from;
            uint32_t marks = next_marks(edges, &from, end);
            for (; marks != 0; marks >>= 1, place++) {
                SKIP(marks, place)
                if ((marks & 1) != 0) {
                    blend_565(edges, pixels + (place - r.place), place);
                }
            }
        }
    }
    return QTRI_OK;
}

/* The colour of the neighbour that a note names, as it was. */
static uint32_t neighbour_of(const qtri_edges *edges, const uint8_t *pixel, uint32_t place,
                             int32_t x, uint32_t code)
{
    const qtri_pixels *pixels = edges->surface.format->pixels;
    const bool in_row = (code & QTRI_NOTE_IN_ROW) != 0;
    const ptrdiff_t step = in_row ? (ptrdiff_t)pixels->bytes : edges->surface.pitch;
    if ((code & QTRI_NOTE_AFTER) != 0) {
        return pixels->load(pixel + step);
    }
    const uint32_t other = in_row ? place - 1 : place - (uint32_t)edges->pitch;
    if (is_marked(edges, other) == 0) {
        return pixels->load(pixel - step);
    }
    return edges->line != NULL ? edges->line[in_row ? x - 1 : x] : edges->notes[other];
}

static void blend_pixel(const qtri_edges *edges, uint8_t *pixel, uint32_t place, int32_t x)
{
    const qtri_format *format = edges->surface.format;
    const uint32_t code = edges->notes[place];
    const uint32_t old = format->pixels->load(pixel);
    const uint32_t other = neighbour_of(edges, pixel, place, x, code);
    const uint32_t mixed =
        qtri_mix_colors(format->colors, qtri_color_of(format, old), qtri_color_of(format, other),
                        code >> QTRI_NOTE_SHARE_SHIFT);
    if (edges->line != NULL) {
        edges->line[x] = old;
    } else {
        edges->notes[place] = (uint16_t)old;
    }
    const uint32_t stored = qtri_stored_of(format, mixed);
    format->pixels->store(pixel, &stored, 1, 1);
}

void qtri_edges_blend(qtri_edges *edges)
{
    const qtri_rect *bounds = &edges->bounds;
    for (int32_t y = bounds->y0; y < bounds->y1; y++) {
        const row r = row_of(edges, y);
        uint32_t from = r.place + (uint32_t)bounds->x0;
        const uint32_t end = r.place + (uint32_t)bounds->x1;
        while (from < end) {
            uint32_t place = from;
            uint32_t marks = next_marks(edges, &from, end);
            for (; marks != 0; marks >>= 1, place++) {
                if ((marks & 1) != 0) {
                    const int32_t x = (int32_t)(place - r.place);
                    const ptrdiff_t bytes = edges->surface.format->pixels->bytes;
                    blend_pixel(edges, r.pixels + x * bytes, place, x);
                }
            }
        }
    }
}
