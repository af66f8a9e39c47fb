/* SPDX-License-Identifier: MIT */
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

#include "../filter/mix.h"
#include "../frame/barrier.h"
#include "../frame/depth_format.h"
#include "checked.h"

enum { WORD_PIXELS = 32, PITCH_MAX = 1 << 16 };

static void clear(uint32_t *word, uint32_t count)
{
    for (; count >= 4; count -= 4, word += 4) {
        word[0] = 0;
        word[1] = 0;
        word[2] = 0;
        word[3] = 0;
    }
    for (; count > 0; count--) {
        *word++ = 0;
    }
}

enum qtri_error qtri_edges_begin(qtri_edges *edges, const qtri_surface *surface, uint32_t *memory,
                                 uint32_t words)
{
    QTRI_ASSERT(edges != NULL);
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_ASSERT(memory != NULL || words == 0);
    const bool has_depth = surface->depth != NULL;
    const qtri_rect bounds = qtri_surface_bounds(surface);
    edges->surface = *surface;
    edges->bounds = bounds;
    edges->bounds.x1 = bounds.x0; /* nothing, until all is there */
    if (bounds.x0 >= bounds.x1) {
        return QTRI_OK;
    }
    const ptrdiff_t pitch = has_depth ? surface->depth_pitch : (ptrdiff_t)surface->width;
    const ptrdiff_t magnitude = pitch < 0 ? -pitch : pitch;
    if (magnitude < surface->width || magnitude > PITCH_MAX) {
        return QTRI_ERROR_SIZE;
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
    const qtri_depth_ops *ops = qtri_depth_ops_of(surface);
    if (ops != NULL && has_depth) {
        edges->notes = ops->flatten(surface);
    }
    clear(memory, marks);
    clear(memory + marks + line, notes);
    edges->bounds = bounds;
    return QTRI_OK;
}

/* A row of the surface, in the order that its notes have in memory. */
typedef struct row {
    uint32_t place, end; /* of its notes */
    uint8_t *pixels;     /* of column 0 */
    ptrdiff_t next;      /* to those of the row that follows in that order */
    uint32_t length;     /* of a row of notes */
} row;

static row first_row(const qtri_edges *edges)
{
    const qtri_surface *surface = &edges->surface;
    const bool upwards = edges->pitch < 0;
    const uint32_t length = (uint32_t)(upwards ? -edges->pitch : edges->pitch);
    row r = {0, length, surface->pixels, surface->pitch, length};
    if (upwards) {
        r.pixels += (surface->rows - 1) * surface->pitch;
        r.next = -surface->pitch;
    }
    return r;
}

/* To the row of a place that is not before it. */
static inline void find_row(row *r, uint32_t place)
{
    while (place >= r->end) {
        r->place = r->end;
        r->end += r->length;
        r->pixels += r->next;
    }
}

static uint32_t mark_words(const qtri_edges *edges)
{
    const uint32_t pitch = (uint32_t)(edges->pitch < 0 ? -edges->pitch : edges->pitch);
    return (pitch * (uint32_t)edges->surface.rows + WORD_PIXELS - 1) / WORD_PIXELS;
}

static inline uint32_t is_marked(const qtri_edges *edges, uint32_t place)
{
    return edges->marks[place / WORD_PIXELS] >> place % WORD_PIXELS & 1;
}

/* The lowest bit's number, of a word that is not 0. */
static inline uint32_t lowest(uint32_t marks)
{
#if defined(__GNUC__) && QTRI_LONG_MULTIPLY && (__SIZEOF_INT__ == 4)
    return (uint32_t)__builtin_ctz(marks);
#else
    /* The product's upper five bits are another for each power of two (Leiserson 1998). */
    static const uint8_t number[32] = {0,  1,  28, 2,  29, 14, 24, 3,  30, 22, 20,
                                       15, 25, 17, 4,  8,  31, 27, 13, 23, 21, 19,
                                       16, 7,  26, 12, 18, 6,  11, 5,  10, 9};
    return number[(marks & (0 - marks)) * 0x077CB531u >> 27];
#endif
}

/* From a pixel to its neighbour, by the direction of a note. */
typedef struct steps {
    int32_t place[4];
    ptrdiff_t pixel[4]; /* bytes */
} steps;

static steps steps_of(const qtri_edges *edges)
{
    const ptrdiff_t pitch = edges->surface.pitch;
    const ptrdiff_t bytes = edges->surface.format->pixels->bytes;
    const steps s = {{-edges->pitch, edges->pitch, -1, 1}, {-pitch, pitch, -bytes, bytes}};
    return s;
}

enum { DIRECTIONS = 3 };

/* The same in any format; x: the column. */
static void blend_any(const qtri_edges *edges, const steps *s, uint8_t *pixel, uint32_t place,
                      int32_t x)
{
    const qtri_format *format = edges->surface.format;
    uint16_t *note = &edges->notes[place];
    const uint32_t code = *note;
    const uint32_t old = format->pixels->load(pixel);
    const int32_t step = s->place[code & DIRECTIONS];
    uint32_t neighbour;
    if (step >= 0 || is_marked(edges, place + (uint32_t)step) == 0) {
        neighbour = format->pixels->load(pixel + s->pixel[code & DIRECTIONS]);
    } else if (edges->line == NULL) {
        neighbour = note[step];
    } else {
        neighbour = edges->line[(code & QTRI_NOTE_IN_ROW) != 0 ? x - 1 : x];
    }
    if (edges->line == NULL) {
        *note = (uint16_t)old;
    } else {
        edges->line[x] = old;
    }
    const uint32_t mixed =
        qtri_mix_colors(format->colors, qtri_color_of(format, old),
                        qtri_color_of(format, neighbour), code >> QTRI_NOTE_SHARE_SHIFT);
    const uint32_t stored = qtri_stored_of(format, mixed);
    format->pixels->store(pixel, &stored, 1, 1);
}

void qtri_edges_blend(qtri_edges *edges)
{
    QTRI_ASSERT(edges != NULL);
    if (edges->bounds.x0 >= edges->bounds.x1) {
        return;
    }
    const steps s = steps_of(edges);
    const uint32_t *word = edges->marks;
    const uint32_t *end = word + mark_words(edges);
    const ptrdiff_t bytes = edges->surface.format->pixels->bytes;
    row r = first_row(edges);
    for (; word != end; word++) {
        const uint32_t first = (uint32_t)(word - edges->marks) * WORD_PIXELS;
        for (uint32_t marks = *word; marks != 0; marks &= marks - 1) {
            const uint32_t place = first + lowest(marks);
            find_row(&r, place);
            const int32_t x = (int32_t)(place - r.place);
            blend_any(edges, &s, r.pixels + x * bytes, place, x);
        }
    }
}

/* Notes of pixels that lie in memory as their colours do. */
QTRI_NOINLINE static void blend_565(const qtri_edges *edges)
{
    const int32_t pitch = edges->pitch;
    const int32_t steps_to[4] = {-pitch, pitch, -1, 1};
    const int32_t *step = steps_to;
    const uint32_t *marks = edges->marks;
    const uint32_t *end = marks + mark_words(edges);
    uint16_t *note = edges->notes;
    uint16_t *pixel = (uint16_t *)(void *)edges->surface.pixels;
    QTRI_OPAQUE(step) /* in a register */
    for (const uint32_t *word = marks; word != end;) {
        uint32_t left = *word++;
        if (left == 0) {
            continue;
        }
        uint32_t first = (uint32_t)(word - marks - 1) * WORD_PIXELS;
        do {
            QTRI_ASIDE(first)
            const uint32_t place = first + lowest(left);
            const uint32_t code = note[place];
            const uint32_t old = pixel[place];
            const int32_t to = step[code & DIRECTIONS];
            const uint32_t other = place + (uint32_t)to;
            uint32_t neighbour = pixel[other];
            if (to < 0 && (int32_t)(qtri_rotated(marks[other / WORD_PIXELS], other) << 31) < 0) {
                neighbour = note[other];
            }
            note[place] = (uint16_t)old;
            pixel[place] = (uint16_t)qtri_lerp_565(old, neighbour, code >> QTRI_NOTE_SHARE_SHIFT);
            left &= left - 1;
        } while (left != 0);
    }
}

enum qtri_error qtri_edges_blend_565(qtri_edges *edges)
{
    QTRI_ASSERT(edges != NULL);
    if (edges->bounds.x0 >= edges->bounds.x1) {
        return QTRI_OK;
    }
    if (!qtri_is_565(edges->surface.format)) {
        return QTRI_ERROR_FORMAT;
    }
    if (edges->pitch > 0 && edges->surface.pitch == 2 * (ptrdiff_t)edges->pitch) {
        blend_565(edges);
    } else {
        qtri_edges_blend(edges);
    }
    return QTRI_OK;
}
