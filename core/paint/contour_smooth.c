/* SPDX-License-Identifier: MIT */
/* Contours and rectangles with antialiased edges: &qtri_ink_smooth. */
#include "contour.h"

#include "coverage.h"

#include "../bits/bits.h"

enum { WINDOW = QTRI_COVERAGE_WINDOW };

/*
 * log2 of the chords that an arc is drawn as, 1, 4 or 16. One of length l leaves the arc of radius
 * r by l^2 / 8 r; a 64th of a pixel is 4 / 256. Where the arc is steep, four chords have a quarter
 * of its length each, or little more; near its highest and lowest point 16 of equal height h leave
 * it by h / 4, a 64th again.
 *
 * Each is higher than nothing: l^2 of a part that is h high is 2 r h at most, and across, rounded,
 * r at most. More than 32 r take h > 15, since 15 would take an r of 15 to 19, and there
 * r^2 + 15^2 < 32 r.
 */
static int32_t chords_log2_of(const qtri_crossing *c)
{
    const int32_t across = qtri_least32(c->x1 > c->x0 ? c->x1 - c->x0 : c->x0 - c->x1, 32767);
    const int32_t down = c->y1 - c->y0;
    const uint32_t square = (uint32_t)(across * across) + (uint32_t)(down * down); /* < 2^31 */
    const uint32_t radius = (uint32_t)c->arc->radius;                              /* <= 2^22 */
    if (square <= 32 * radius) {
        return 0;
    }
    return square <= 256 * radius && across <= 2 * down ? 2 : 4;
}

/* Adds the coverage by a crossing that begins before the window's end. */
static void add_crossing(qtri_coverage *w, const qtri_crossing *c, int32_t row)
{
    const int32_t chords_log2 = c->arc == NULL ? 0 : chords_log2_of(c);
    const int32_t chords = (int32_t)1 << chords_log2;
    const int32_t most = qtri_greatest32(c->x0, c->x1);
    if (chords == 1 || most <= w->x * 256) {
        qtri_coverage_add(w, c->x0, c->y0, c->x1, c->y1, c->winding);
        return;
    }
    const qtri_ink_arc *arc = &c->arc->as.arc;
    int32_t x = c->x0;
    int32_t y = c->y0;
    for (int32_t i = 1; i <= chords; i++) {
        const int32_t to_y = c->y0 + (((c->y1 - c->y0) * i) >> chords_log2);
        int32_t to = c->x1;
        if (i < chords) {
            to = arc->center_x + arc->side * qtri_ink_half_chord(c->arc, row * 256 + to_y);
        }
        qtri_coverage_add(w, x, y, to, to_y, c->winding);
        x = to;
        y = to_y;
    }
}

/* Coverage, 0..255, from a sum; winding numbers above 1 count as 1. */
static uint32_t coverage_of(int32_t sum)
{
    const uint32_t share = qtri_magnitude32(sum);
    return share >= (uint32_t)QTRI_COVERAGE_FULL
               ? 255
               : (share * 255 + QTRI_COVERAGE_FULL / 2) / QTRI_COVERAGE_FULL;
}

/*
 * Adds all crossings that begin before the window's end. *busy: the end of the pixels that edges
 * pass through; *next: the column where the first edge behind the window begins. Sums are those up
 * to *busy, and one more, which an edge that is its side adds nothing to.
 */
static void fill_window(qtri_coverage *w, const qtri_crossings *crossings, int32_t row,
                        int32_t *busy, int32_t *next)
{
    w->end = w->x + WINDOW;
    *busy = w->x;
    *next = INT32_MAX;
    int32_t position = 0;
    qtri_crossing room;
    const qtri_crossing *c;
    while ((c = qtri_crossings_next(crossings, &position, &room)) != NULL) {
        const int32_t first = qtri_least32(c->x0, c->x1) >> 8;
        if (first >= w->x + WINDOW) {
            *next = qtri_least32(*next, first);
        } else {
            *busy = qtri_greatest32(*busy, (qtri_greatest32(c->x0, c->x1) + 255) >> 8);
        }
    }
    const int32_t last = qtri_least32(*busy - w->x + 1, WINDOW);
    for (int32_t i = 0; i <= last; i++) {
        w->sum[i] = 0;
    }
    position = 0;
    while ((c = qtri_crossings_next(crossings, &position, &room)) != NULL) {
        if (qtri_least32(c->x0, c->x1) >> 8 < w->x + WINDOW) {
            add_crossing(w, c, row);
        }
    }
}

/* Windows where edges are, even runs between. */
static void smooth_row(const qtri_painter *painter, const qtri_contour *contour, int32_t row)
{
    qtri_crossings crossings;
    qtri_crossings_init(&crossings, contour, row);
    const int32_t end = painter->bounds.x1;
    qtri_coverage w;
    w.x = qtri_greatest32(painter->bounds.x0, crossings.first);
    while (w.x < end) {
        int32_t busy;
        int32_t next;
        fill_window(&w, &crossings, row, &busy, &next);
        int32_t count = qtri_least32(qtri_least32(busy, end) - w.x, WINDOW);
        int32_t sum = 0;
        if (count > 0) {
            uint8_t coverage[WINDOW];
            for (int32_t i = 0; i < count; i++) {
                // NOLINTNEXTLINE(clang-analyzer-core.*): fill_window() has set those up to `busy`
                sum += w.sum[i];
                coverage[i] = (uint8_t)coverage_of(sum);
            }
            painter->ink->cover(painter, qtri_surface_at(painter->surface, w.x, row), count,
                                coverage);
        }
        w.x += count;
        if (busy > w.x) {
            continue; /* the window was too short */
        }
        sum += w.sum[count]; /* no edge goes further */
        const uint32_t even = coverage_of(sum);
        if (even != 0) {
            qtri_painter_span(painter, row, w.x, next, even);
        }
        w.x = next;
    }
}

/* How much of pixel or row i the range from..to, 24.8, covers, in 1/256. */
static int32_t share_of(int32_t i, int32_t from, int32_t to)
{
    return qtri_least32(to - i * 256, 256) - qtri_greatest32(from - i * 256, 0);
}

/*
 * A row of which `rows` of 256 are covered: pixels that the left and the right side pass through,
 * and unless they are painted already, those between, columns x0 .. x1-1.
 */
static void smooth_rect_row(const qtri_painter *painter, const qtri_area *box, int32_t row,
                            uint32_t rows, bool between)
{
    const int32_t x0 = (box->x0_24p8 + 255) >> 8;
    const int32_t x1 = box->x1_24p8 >> 8;
    if ((box->x0_24p8 & 255) != 0) { /* both sides, where they are in one column */
        const uint32_t first = (uint32_t)share_of(x0 - 1, box->x0_24p8, box->x1_24p8);
        const uint32_t share = (first * rows * 255 + 0x8000) >> 16;
        if (share != 0) {
            qtri_painter_span(painter, row, x0 - 1, x0, share);
        }
    }
    if (between) {
        qtri_painter_span(painter, row, x0, x1, (rows * 255 + 128) >> 8); /* rows >= 1: not 0 */
    }
    if (x0 <= x1) {
        const uint32_t share = ((uint32_t)(box->x1_24p8 & 255) * rows * 255 + 0x8000) >> 16;
        if (share != 0) {
            qtri_painter_span(painter, row, x1, x1 + 1, share);
        }
    }
}

/* Each share is a product of two: exact. The pixels that are covered wholly are one rectangle. */
static void smooth_rect(const qtri_painter *painter, const qtri_area *box)
{
    const qtri_rect whole = {(box->x0_24p8 + 255) >> 8, (box->y0_24p8 + 255) >> 8,
                             box->x1_24p8 >> 8, box->y1_24p8 >> 8};
    const bool has_sides = ((box->x0_24p8 | box->x1_24p8) & 255) != 0;
    const int32_t end = qtri_least32((box->y1_24p8 + 255) >> 8, painter->bounds.y1);
    qtri_painter_rect(painter, &whole);
    for (int32_t row = qtri_greatest32(box->y0_24p8 >> 8, painter->bounds.y0); row < end; row++) {
        const bool is_whole = row >= whole.y0 && row < whole.y1;
        if (is_whole && !has_sides) {
            row = whole.y1 - 1; /* on behind them */
            continue;
        }
        smooth_rect_row(painter, box, row, (uint32_t)share_of(row, box->y0_24p8, box->y1_24p8),
                        !is_whole);
    }
}

const qtri_ink qtri_ink_smooth = {qtri_blend_span, qtri_blend_cover, qtri_blend_bits, smooth_row,
                                  smooth_rect};
