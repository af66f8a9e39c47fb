/* SPDX-License-Identifier: MIT */
/*
 * The edge pass over a surface: where notes are kept, the walk along an edge, and the blend.
 *
 * Notes. A pixel's note is weight << 2 | direction: the weight of a neighbour in 1/32, 1..16, and
 * whether the neighbour is the pixel before (0) or after it (1) in the column, or in the row (2 and
 * 3). A bit a pixel marks those that have one; notes lie in the surface's depth.
 *
 * The walk. An edge is followed along its major axis, the one on which it is longer. At the centre
 * of each column (or row) it passes between the centres of two pixels of the minor axis, p and the
 * next one, q, a fraction t from p. The pixel that it passes through is p where t < 1/2, and takes
 * the weight w = 1/2 - t of q if the edge is level; else it is q, and w = t - 1/2. An edge of slope
 * s leaves that pixel within its width where w < s / 2: the other side then covers
 * (w + s/2)^2 / 2s of it, and its own side (s/2 - w)^2 / 2s of the other pixel. Both are exact for
 * an edge that goes on beyond the column.
 *
 * Positions, in 16.16, and depths are linear from the edge's first pixel on, in parts of less than
 * PART pixels that begin exactly: a pixel's values depend on the edge alone, not on the surface's
 * rows or its scissor.
 *
 * A pixel is noted where the edge is not hidden: where the stored depth is not nearer than the
 * edge's less some slack. At a pixel's centre the face's depth differs from that on the edge, by
 * up to what it has across a pixel or two; slack is 8 to 16 times its range over its extent across,
 * and FLAT steps. (Half as much loses outlines of faces seen at a low angle, more gains nothing.)
 *
 * The blend. A pixel that has got its share keeps its old colour for the pixels that take it as a
 * neighbour: in its note, which is spent, or, where a colour has more than two bytes, in a row of
 * words. One row is enough: pixels change from the top down and from the left to the right, and
 * column x of it holds the old colour of (x, y - 1) until (x, y) is through, and of (x, y) until
 * (x + 1, y) is.
 */
#include "edge_pass.h"

#include "../bits/bits.h"
#include "../filter/mix.h"
#include "../frame/depth_format.h"
#include "../frame/pixel.h"
#include "checked.h"

enum {
    NOTE_AFTER = 1,
    NOTE_IN_ROW = 2,
    NOTE_DIRECTIONS = 3,
    NOTE_WEIGHT_SHIFT = 2,
    WORD_PIXELS = 32,
    PITCH_MAX = 1 << 16,
    PART_LOG2 = 7,
    PART_24P8 = 256 << PART_LOG2,
    LEVEL_MAX = 4,    /* pixels of an edge whose depth counts as one, the nearest */
    FLAT_6 = 16 << 6, /* 16 steps of depth */
    NO_LIMIT = INT32_MIN / 2,
    HALF = 1 << 15,    /* of a pixel */
    WEIGHT_SHIFT = 11, /* to 1/32 */
    WEIGHT_ROUND = 1 << (WEIGHT_SHIFT - 1),
    SLOPES = 17,
    WEIGHTS = 17
};

/* ---- Memory ---- */

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
    qtri_fill_words((uint8_t *)memory, 0, marks * sizeof *memory, 1, 0);
    if (notes != 0) {
        qtri_fill_words((uint8_t *)(memory + marks + line), 0, notes * sizeof *memory, 1, 0);
    }
    edges->bounds = bounds;
    return QTRI_OK;
}

void qtri_edge_axes_init(qtri_edge_axis axis[2], const qtri_edges *edges, qtri_compare compare)
{
    const bool is_farther = compare == QTRI_GREATER || compare == QTRI_GREATER_EQUAL;
    const bool hides =
        edges->surface.depth != NULL && compare != QTRI_DEPTH_OFF && compare != QTRI_ALWAYS;
    const qtri_rect *bounds = &edges->bounds;
    const int32_t pitch = edges->pitch;
    const int32_t first_row = edges->surface.first_row;
    const int32_t origin = edges->origin - first_row * pitch; /* of pixel (0, 0) of the frame */
    qtri_edge_axis level = {.low = bounds->x0,
                            .high = bounds->x1,
                            .first = bounds->y0 * 65536 + HALF + 1,
                            .pairs = (uint32_t)(bounds->y1 - bounds->y0 - 1),
                            .along = 1,
                            .across = pitch,
                            .origin = origin + bounds->y0 * pitch,
                            .marks = edges->marks,
                            .notes = edges->notes,
                            .flip = is_farther ? 0xFFFF : 0,
                            .hides = hides};
    axis[0] = level;
    level.low = bounds->y0;
    level.high = bounds->y1;
    level.first = bounds->x0 * 65536 + HALF + 1;
    level.pairs = (uint32_t)(bounds->x1 - bounds->x0 - 1);
    level.along = pitch;
    level.across = 1;
    level.origin = origin + bounds->x0;
    level.direction = NOTE_IN_ROW;
    axis[1] = level;
}

/* ---- The walk along an edge ---- */

/*
 * Notes, as codes without a direction, for half the slope and w in 1/32 of a pixel, each 0..16:
 * that of the pixel which the edge passes through in the low byte, that of the other in the high
 * one. (w + h)^2 / 4 h and (h - w)^2 / 4 h to nearest where w < h; else w and 0.
 */
/* clang-format off */
static const uint16_t coverage[SLOPES][WEIGHTS] = {
    {0x0000, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0000, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0004, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0408, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0404, 0x0408, 0x0008, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x0408, 0x040C, 0x000C, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x0408, 0x040C, 0x0410, 0x0010, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x080C, 0x040C, 0x0410, 0x0414, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0808, 0x080C, 0x040C, 0x0410, 0x0414, 0x0014, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x080C, 0x0810, 0x0410, 0x0414, 0x0418, 0x0018, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x080C, 0x0810, 0x0410, 0x0414, 0x0418, 0x041C, 0x001C, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x0C10, 0x0810, 0x0814, 0x0414, 0x0418, 0x041C, 0x0420, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x0C0C, 0x0C10, 0x0810, 0x0814, 0x0818, 0x0418, 0x041C, 0x0420, 0x0020, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x1010, 0x0C10, 0x0C14, 0x0814, 0x0818, 0x0418, 0x041C, 0x0420, 0x0424, 0x0024, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x1010, 0x0C10, 0x0C14, 0x0814, 0x0818, 0x081C, 0x041C, 0x0420, 0x0424, 0x0428, 0x0028, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
    {0x1010, 0x1014, 0x0C14, 0x0C18, 0x0818, 0x081C, 0x0820, 0x0420, 0x0424, 0x0428, 0x042C, 0x002C, 0x0030, 0x0034, 0x0038, 0x003C, 0x0040},
};
/* clang-format on */

/* An edge shorter than PART_24P8, or a part of one, by increasing coordinate on its major axis. */
typedef struct part {
    int32_t major, length;      /* 1/256 pixel */
    int32_t minor, delta;       /* 16.16; |delta| <= 256 length, and a few units */
    int32_t depth, depth_delta; /* 16.6, flipped where greater is nearer */
    int32_t slack;              /* 16.6 */
} part;

/* Notes `code` at index i if it is the greatest there, or the first and its depth, 16.6, not below
   `limit`. */
QTRI_INLINE void note(const qtri_edge_axis *axis, uint32_t i, uint32_t code, int32_t limit)
{
    uint16_t *at = &axis->notes[i];
    uint32_t *mark = &axis->marks[i / WORD_PIXELS];
    if ((int32_t)(qtri_rotated(*mark, i) << 31) < 0) {
        if (code > (*at | axis->weak)) {
            *at = (uint16_t)code;
        }
    } else if ((int32_t)((*at ^ axis->flip) << 6) >= limit) {
        *at = (uint16_t)code;
        *mark |= qtri_rotated(1, 0 - i);
    }
}

/*
 * Notes pixels k..end_k - 1 of the major axis. `at`: the edge's position on the minor axis at pixel
 * k, counted from axis->first, so that its upper half counts pairs p, q and its lower half is
 * t - 2^-16: an edge on a pixel's centre leaves the pixel to the side after it. `limit`: the least
 * depth at k that does not hide it, 16.6. `weights`: the slope's row of the table.
 */
QTRI_INLINE void walk(const qtri_edge_axis *axis, int32_t k, int32_t end_k, uint32_t at,
                      int32_t step, int32_t limit, int32_t limit_step, const uint16_t *weights)
{
    int32_t place = axis->origin + k * axis->along;
    const int32_t end = axis->origin + end_k * axis->along;
    do {
        const int32_t pair = (int32_t)at >> 16;
        if ((uint32_t)pair < axis->pairs) {
            uint32_t i = (uint32_t)(place + pair * axis->across); /* of p */
            uint32_t other = i + (uint32_t)axis->across;
            uint32_t code = axis->direction;
            uint32_t w; /* 2^-16, and WEIGHT_ROUND; in the low 15 bits */
            if ((int32_t)(at << 16) >= 0) {
                w = WEIGHT_ROUND + HALF - 1 - (at & (HALF - 1));
                code += NOTE_AFTER;
            } else {
                w = WEIGHT_ROUND + 1 + (at & (HALF - 1));
                const uint32_t p = i;
                i = other;
                other = p;
            }
            const uint32_t both = weights[w >> WEIGHT_SHIFT];
            if (both >> 8 != 0) {
                note(axis, other, both >> 8 | (code ^ NOTE_AFTER), limit);
            }
            if ((both & 0xFF) != 0) {
                note(axis, i, (both & 0xFF) | code, limit);
            }
        }
        at += (uint32_t)step;
        limit += limit_step;
        place += axis->along;
    } while (place != end);
}

/*
 * 2^8 delta / length to nearest, for a step from delta in 16.16 and length < 2^15 in 24.8.
 * r = floor(2^31 / (2^up length)) less at most one: the quotient by it is at most 3 too small, and
 * 2^16 / length for the bits of delta that are cut off, which are 0 below 2^13.
 */
static inline uint32_t step_of(uint32_t delta, uint32_t length, uint32_t r, int32_t up)
{
    uint32_t step = (((delta >> 8) << up) * r) >> 15; /* <= 2^31 / 2^15, and a few units */
    uint32_t remainder = (delta << 8) - step * length + length / 2; /* modulo 2^32 */
    while (remainder >= length) {
        remainder -= length;
        step++;
    }
    return step;
}

static void note_part(const qtri_edge_axis *axis, const part *e)
{
    /* Centres in [major, major + length): the first is ceil((major - 128) / 256). */
    int32_t k = (e->major + 127) >> 8;
    int32_t end = (e->major + e->length + 127) >> 8;
    if (k >= end || k >= axis->high || end <= axis->low) {
        return;
    }
    const int32_t along = (128 - e->major) & 255;            /* to the first centre */
    const int32_t up = qtri_clz32((uint32_t)e->length) - 16; /* 2^up length is 2^15..2^16 - 1 */
    const uint32_t r = qtri_reciprocal_q31((uint32_t)e->length << up);
    const uint32_t slope = step_of(qtri_magnitude32(e->delta), (uint32_t)e->length, r, up);
    const int32_t step = e->delta < 0 ? -(int32_t)slope : (int32_t)slope;
    int32_t at = e->minor + ((step * along + 128) >> 8) - axis->first;
    int32_t limit = NO_LIMIT;
    int32_t limit_step = 0;
    if (axis->hides) {
        limit = e->depth - e->slack;
        if (end - k > LEVEL_MAX) {
            limit_step = qtri_mul_high_s31(e->depth_delta * 256, r << up) * 2; /* < 2^30 */
            limit += (limit_step >> 8) * along + (((limit_step & 255) * along) >> 8);
        } else {
            limit += e->depth_delta < 0 ? e->depth_delta : 0;
        }
    }
    const int32_t before = axis->low - k;
    if (before > 0) {
        k = axis->low;
        at += before * step; /* within the edge's ends, as the part does not end before `low` */
        limit += before * limit_step;
    }
    walk(axis, k, end < axis->high ? end : axis->high, (uint32_t)at, step, limit, limit_step,
         coverage[(slope + 2048) >> 12]); /* slope <= 2^16, and a few units */
}

/* floor(2^up x i / 2^log2) modulo 2^32, for |x| < 2^24, i <= 2^log2 <= 2^10 and up <= 8. */
static inline uint32_t fraction_of(int32_t x, int32_t i, int32_t log2, int32_t up)
{
    return (uint32_t)((qtri_mul_s32(x, i) * ((int64_t)1 << up)) >> log2); /* < 2^42 */
}

/* Part i of 2^log2 of edge e, which moves from `minor` by `delta` on the minor axis, 24.8. */
QTRI_NOINLINE static part part_of(const part *e, int32_t minor, int32_t delta, int32_t i,
                                  int32_t log2)
{
    const uint32_t start = fraction_of(e->length, i, log2, 0);
    const uint32_t start_minor = fraction_of(delta, i, log2, 8);
    const uint32_t start_depth = fraction_of(e->depth_delta, i, log2, 0);
    part p = *e;
    p.major += (int32_t)start;
    p.minor = (int32_t)((uint32_t)minor * 256 + start_minor);
    p.depth += (int32_t)start_depth;
    p.length = (int32_t)(fraction_of(e->length, i + 1, log2, 0) - start);
    p.delta = (int32_t)(fraction_of(delta, i + 1, log2, 8) - start_minor);
    p.depth_delta = (int32_t)(fraction_of(e->depth_delta, i + 1, log2, 0) - start_depth);
    return p;
}

/* Notes edge e, PART_24P8 or longer, in parts of at least half of that; see part_of(). */
QTRI_NOINLINE static void note_long(const qtri_edge_axis *axis, const part *e, int32_t minor,
                                    int32_t delta)
{
    const int32_t log2 = 32 - PART_LOG2 - 7 - qtri_clz32((uint32_t)e->length); /* 1..10 */
    for (int32_t i = 0; i < (int32_t)1 << log2; i++) {
        const part p = part_of(e, minor, delta, i, log2);
        note_part(axis, &p);
    }
}

/* From the least of a, b and c to the greatest. */
static inline int32_t range_of(int32_t a, int32_t b, int32_t c)
{
    return qtri_greatest32(qtri_greatest32(a, b), c) - qtri_least32(qtri_least32(a, b), c);
}

/* How much nearer than the edge a pixel may be, 16.6. range: of the face's depths, 16.6, below
   2^22; extent: of the face across the edge, 24.8. */
static inline int32_t depth_slack(int32_t range, int32_t extent)
{
    int32_t slack = 8 * range;
    if (extent >= 512) {
        slack >>= 23 - qtri_clz32((uint32_t)extent); /* 1 for 2 pixels and more, 2 for 4 ... */
    }
    return slack + FLAT_6;
}

void qtri_edge_note(const qtri_edge_axis axis[2], const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_vertex *c)
{
    const uint32_t flip = axis->flip << 6; /* 65535 less the depth */
    const int32_t depth_c = (int32_t)(c->depth_16p8 >> 10 ^ flip);
    const int32_t depth_b = (int32_t)(b->depth_16p8 >> 10 ^ flip);
    part e;
    e.major = a->at.x_24p8;
    e.length = b->at.x_24p8 - e.major;
    int32_t minor = a->at.y_24p8;
    int32_t delta = b->at.y_24p8 - minor;
    int32_t minor_c = c->at.y_24p8;
    if (qtri_magnitude32(delta) > qtri_magnitude32(e.length)) {
        const int32_t width = e.length;
        axis++;
        e.length = delta;
        delta = width;
        e.major = minor;
        minor = a->at.x_24p8;
        minor_c = c->at.x_24p8;
    }
    e.depth = (int32_t)(a->depth_16p8 >> 10 ^ flip);
    e.depth_delta = depth_b - e.depth;
    e.slack =
        depth_slack(range_of(e.depth, depth_b, depth_c), range_of(minor, minor + delta, minor_c));
    if (e.length < 0) { /* from b to a */
        e.major += e.length;
        e.length = -e.length;
        minor += delta;
        delta = -delta;
        e.depth = depth_b;
        e.depth_delta = -e.depth_delta;
    }
    if (e.length >= PART_24P8) {
        note_long(axis, &e, minor, delta);
        return;
    }
    e.minor = minor * 256;
    e.delta = delta * 256;
    note_part(axis, &e);
}

/* ---- The blend ---- */

/* From a note and from a pixel to a neighbour's, by the direction of a note. */
typedef struct steps {
    int32_t note[4];
    ptrdiff_t pixel[4]; /* bytes */
} steps;

/* Blends a pixel of column x, whose note is the i-th, with its neighbour. */
QTRI_INLINE void blend_pixel(const qtri_edges *edges, const steps *s, uint8_t *pixel, uint32_t i,
                             uint32_t x, bool is_565)
{
    const qtri_format *format = edges->surface.format;
    uint16_t *note = &edges->notes[i];
    const uint32_t code = *note;
    const uint32_t weight = code >> NOTE_WEIGHT_SHIFT;
    const int32_t step = s->note[code & NOTE_DIRECTIONS];
    const uint32_t other = i + (uint32_t)step;
    const uint8_t *beside = pixel + s->pixel[code & NOTE_DIRECTIONS];
    const bool is_changed =
        step < 0 && (int32_t)(qtri_rotated(edges->marks[other / WORD_PIXELS], other) << 31) < 0;
    if (is_565) {
        uint16_t *stored = (uint16_t *)(void *)pixel;
        const uint32_t old = *stored;
        const uint32_t neighbour =
            is_changed ? note[step] : *(const uint16_t *)(const void *)beside;
        *note = (uint16_t)old;
        *stored = (uint16_t)qtri_lerp_565(old, neighbour, weight);
        return;
    }
    const uint32_t old = format->pixels->load(pixel);
    uint32_t neighbour;
    if (!is_changed) {
        neighbour = format->pixels->load(beside);
    } else if (edges->line == NULL) {
        neighbour = note[step];
    } else {
        neighbour = edges->line[(code & NOTE_IN_ROW) != 0 ? x - 1 : x];
    }
    if (edges->line == NULL) {
        *note = (uint16_t)old;
    } else {
        edges->line[x] = old;
    }
    const uint32_t mixed = qtri_mix_colors(format->colors, qtri_color_of(format, old),
                                           qtri_color_of(format, neighbour), weight);
    const uint32_t stored = qtri_stored_of(format, mixed);
    format->pixels->store(pixel, &stored, 1, 1);
}

/* Blends all pixels that have notes, in the order of their notes in memory. */
QTRI_INLINE void blend(const qtri_edges *edges, bool is_565)
{
    const qtri_surface *surface = &edges->surface;
    const ptrdiff_t bytes = is_565 ? 2 : surface->format->pixels->bytes;
    const ptrdiff_t pitch = surface->pitch;
    const bool upwards = edges->pitch < 0;
    const uint32_t length = (uint32_t)(upwards ? -edges->pitch : edges->pitch);
    const ptrdiff_t gap = (upwards ? -pitch : pitch) - (ptrdiff_t)length * bytes;
    const steps from_pixel = {{-edges->pitch, edges->pitch, -1, 1}, {-pitch, pitch, -bytes, bytes}};
    const steps *s = &from_pixel;
    uint8_t *pixels = surface->pixels + (upwards ? (surface->rows - 1) * pitch : 0);
    uint32_t row_end = length;
    const uint32_t *word = edges->marks;
    const uint32_t *end = word + (length * (uint32_t)surface->rows + WORD_PIXELS - 1) / WORD_PIXELS;
    QTRI_BODY_BARRIER(s); /* in a register */
    while (word != end) {
        uint32_t marks = *word++;
        if (marks == 0) {
            continue;
        }
        const uint32_t first = (uint32_t)(word - 1 - edges->marks) * WORD_PIXELS;
        for (; marks != 0; marks &= marks - 1) {
            const uint32_t i = first + 31 - (uint32_t)qtri_clz32(marks & (0 - marks));
            while (i >= row_end) {
                row_end += length;
                pixels += gap;
            }
            blend_pixel(edges, s, pixels + (ptrdiff_t)i * bytes, i, i - (row_end - length), is_565);
        }
    }
}

void qtri_edges_blend(qtri_edges *edges)
{
    QTRI_ASSERT(edges != NULL);
    if (edges->bounds.x0 >= edges->bounds.x1) {
        return;
    }
    if (qtri_is_565(edges->surface.format)) {
        blend(edges, true);
    } else {
        blend(edges, false);
    }
}
