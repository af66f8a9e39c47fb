/* SPDX-License-Identifier: MIT */
/*
 * Where a small triangle is: its rows, and what its ramps have in common. Internal.
 *
 * Small is a triangle whose vertices 1 and 2 are within 36 pixels of vertex 0 in x and in y, 1/w at
 * most 1/12 from that of vertex 0, and depth not steep. That is asked of the vertices alone, never
 * of a scissor, a band, a format or a material: so a triangle's depths are the same however often
 * and in whatever pieces of the frame it is drawn. All that follows fits 32 bits.
 */
#ifndef QTRI_RASTER_PLACE_H
#define QTRI_RASTER_PLACE_H

#include "qtri/view.h"

#include "loop.h"
#include "raster.h"
#include "rows.h"

#define QTRI_PLACE_PIXELS 36
#define QTRI_PLACE_REACH  ((int32_t)256 * QTRI_PLACE_PIXELS)
#define QTRI_PLACE_NEAR   ((int32_t)1 << 13) /* within it in all four needs one comparison */

typedef enum qtri_placed {
    QTRI_PLACED_NOWHERE, /* touches no pixel */
    QTRI_PLACED_LARGE,
    QTRI_PLACED_SMALL
} qtri_placed;

/* Rows count from the surface's first one, columns from that of the frame. */
typedef struct qtri_place {
    int32_t column, row;        /* the base: spans count columns from it and begin in its row */
    int32_t x, y;               /* its centre from vertex 0, 1/256 pixel */
    int32_t dx1, dy1, dx2, dy2; /* vertices 1 and 2 from vertex 0; of a back face 2 and 1 */
    uint32_t size;              /* twice the area, 1/256 pixel squared: < 2^28 */
    int32_t more1, more2;       /* qtri_place_near: what 1/w has more there, in vertex 0's scale */
    int32_t pixels;             /* of all rows, before they are cut */
    bool back;
    bool cut;       /* spans may reach past the bounds, see qtri_place_cut */
    uint8_t *first; /* the first row's span, in the caller's memory */
} qtri_place;

/*
 * Of each row the first pixel and the one after the last, then a row that begins with
 * QTRI_PLACE_STOP, after which nothing can end. Vertex 0 is in row QTRI_PLACE_PIXELS of them.
 */
#define QTRI_PLACE_SPANS (2 * (2 * QTRI_PLACE_PIXELS + 1))
#define QTRI_PLACE_STOP  255

/* An edge's pixels in rows up to `stop`; returns their sum. */
static inline int32_t qtri_place_walk(uint8_t *side, const uint8_t *stop, int32_t numerator,
                                      int32_t step, int32_t denominator)
{
    int32_t sum = 0;
    qtri_edge edge;
    edge.numerator = numerator;
    edge.step = step;
    edge.denominator = denominator;
#if !QTRI_DIVIDE
    edge.quotient = QTRI_PLACE_PIXELS;
#endif
    do {
        int32_t x = qtri_edge_next(&edge, 0);
        sum += x;
        *side = (uint8_t)x;
        side += 2;
        QTRI_HOLD(side);
    } while (side != stop);
    return sum;
}

/*
 * An edge between rows `from` and `to`: of a front face it is on the left when it goes down. As in
 * cover.c its pixel in a row is numerator / (256 dy); with Y from the centre of vertex 0's first
 * row, X from half a pixel left of the base column's edge, and `cross` X dy - Y dx of either end,
 * the numerator is cross + 256 row dx - 1. |X|, |Y|, |dx|, |dy| <= 73 256 < 2^14.2 and |row| <= 36:
 * all of that is below 2^30.
 *
 * Returns the sum of its pixels, negative on the right: of all three together it is 0 where no row
 * has a pixel, since edges never cross.
 */
static inline int32_t qtri_place_edge(uint8_t *spans, int32_t dx, int32_t dy, int32_t cross,
                                      int32_t from, int32_t to)
{
    const int32_t step = dx * 256;
    if (from < to) {
        return qtri_place_walk(&spans[2 * from], &spans[2 * to], cross + from * step - 1, step,
                               dy * 256);
    }
    if (from > to) {
        return -qtri_place_walk(&spans[2 * to + 1], &spans[2 * from + 1], -cross - to * step - 1,
                                -step, dy * -256);
    }
    return 0;
}

/* -1 where x is negative, or 0. */
static inline int32_t qtri_sign(int32_t x)
{
    return x >> 31; // cppcheck-suppress shiftTooManyBitsSigned
}

/* |x| or one less. */
static inline uint32_t qtri_about(int32_t x)
{
    return (uint32_t)(x ^ qtri_sign(x));
}

/* The least of 0, a, b. */
static inline int32_t qtri_least_from_0(int32_t a, int32_t b)
{
    a &= qtri_sign(a);
    return a < b ? a : b;
}

/* The greatest of 0, a, b. */
static inline int32_t qtri_greatest_from_0(int32_t a, int32_t b)
{
    a &= ~qtri_sign(a);
    return a > b ? a : b;
}

/* Depths that differ from that of vertex 0 by less than 2^10 are not steep. */
#define QTRI_PLACE_STEEP_LOG2 10

/* Of differing bits of vertices' depth_16p8: exponents, and what steep depths have one of. */
#define QTRI_PLACE_UNEVEN (UINT32_MAX << (16 + QTRI_PLACE_STEEP_LOG2) | 0xFF)

/*
 * Whether half a step of 1/256 pixel, by which vertices are snapped, may be a step of depth and
 * more: a small triangle knows nothing of unsnapped.h. z1, z2: depths from vertex 0, times 2^8.
 *
 * The slopes along x and y together are at most 2^8 range (width + height) / size a pixel, and
 * 1/512 pixel of it is what snapping does. range < 2^16, width + height < 2^15.3.
 */
static inline bool qtri_place_is_steep(const qtri_place *p, int32_t z1, int32_t z2)
{
    if ((qtri_about(z1) | qtri_about(z2)) >> (8 + QTRI_PLACE_STEEP_LOG2) == 0) {
        return false;
    }
    const uint32_t range =
        (uint32_t)(qtri_greatest_from_0(z1, z2) - qtri_least_from_0(z1, z2)) >> 8;
    const uint32_t extent =
        (uint32_t)(qtri_greatest_from_0(p->dx1, p->dx2) - qtri_least_from_0(p->dx1, p->dx2) +
                   qtri_greatest_from_0(p->dy1, p->dy2) - qtri_least_from_0(p->dy1, p->dy2));
    return range * extent > 2 * p->size;
}

/* What 1/w of b has more than that of a, in the scale of a. False: that is more than 1/12 of it. */
bool qtri_inv_w_more(int32_t *more, const qtri_vertex *a, const qtri_vertex *b);

/* Most triangles: equal exponents, and differences below 1/16. */
static inline bool qtri_place_is_level(const qtri_vertex *a, const qtri_vertex *b,
                                       const qtri_vertex *c)
{
    const uint32_t exponents = (a->depth_16p8 ^ b->depth_16p8) | (a->depth_16p8 ^ c->depth_16p8);
    const uint32_t most =
        qtri_about((int32_t)(b->inv_w - a->inv_w)) | qtri_about((int32_t)(c->inv_w - a->inv_w));
    return ((exponents & 0xFF) | most >> 26) == 0;
}

/* Whether any of these is outside the reach. */
static inline bool qtri_place_is_far(int32_t dx1, int32_t dy1, int32_t dx2, int32_t dy2)
{
    const uint32_t reach = QTRI_PLACE_REACH;
    QTRI_RARELY();
    return (uint32_t)dx1 + reach >= 2 * reach || (uint32_t)dy1 + reach >= 2 * reach ||
           (uint32_t)dx2 + reach >= 2 * reach || (uint32_t)dy2 + reach >= 2 * reach;
}

/* Holds spans from `column` on to the columns of the bounds. False when nothing is left. */
bool qtri_place_cut(uint8_t *span, int32_t column, const qtri_rect *bounds);

/*
 * Where it is, except that 1/w is not looked at. Inline for loops over a mesh: a triangle of seven
 * pixels would pay a tenth for the call.
 */
static inline qtri_placed qtri_place_inline(qtri_place *p, uint8_t spans[QTRI_PLACE_SPANS],
                                            const qtri_raster *raster, const qtri_vertex *a,
                                            const qtri_vertex *b, const qtri_vertex *c)
{
    const qtri_rect *const bounds = &raster->bounds;
    const int32_t first_row = raster->surface->first_row;
    const int32_t x0 = a->at.x_24p8;
    const int32_t y0 = a->at.y_24p8;
    int32_t dx1 = b->at.x_24p8 - x0;
    int32_t dy1 = b->at.y_24p8 - y0;
    int32_t dx2 = c->at.x_24p8 - x0;
    int32_t dy2 = c->at.y_24p8 - y0;
    const uint32_t near = QTRI_PLACE_NEAR;
    if ((((uint32_t)dx1 + near) | ((uint32_t)dy1 + near) | ((uint32_t)dx2 + near) |
         ((uint32_t)dy2 + near)) >= 2 * near &&
        qtri_place_is_far(dx1, dy1, dx2, dy2)) {
        return QTRI_PLACED_LARGE;
    }
    int32_t size = dx2 * dy1 - dx1 * dy2;
    p->back = false;
    if (size <= 0) {
        QTRI_RARELY();
        const int32_t dx = dx1;
        const int32_t dy = dy1;
        if (size == 0) {
            return QTRI_PLACED_NOWHERE;
        }
        dx1 = dx2, dx2 = dx;
        dy1 = dy2, dy2 = dy;
        size = -size;
        p->back = true;
    }
    int32_t a_row = 0;
    const int32_t row = qtri_first_center(y0);
    const int32_t y = row * 256 + 128 - y0; /* 1..256 */
    int32_t b_row = (dy1 - y + 255) >> 8;
    int32_t c_row = (dy2 - y + 255) >> 8;
    int32_t first = qtri_least_from_0(b_row, c_row);
    int32_t end = qtri_greatest_from_0(b_row, c_row);
    if (first == end) {
        return QTRI_PLACED_NOWHERE;
    }
    const bool inner = (uint32_t)x0 - raster->inner.x < raster->inner.width &&
                       (uint32_t)y0 - raster->inner.y < raster->inner.height;
    if (!inner && (row + first < bounds->y0 || row + end > bounds->y1)) {
        const int32_t least = bounds->y0 - row;
        const int32_t greatest = bounds->y1 - row;
        if (first >= greatest || end <= least) {
            return QTRI_PLACED_NOWHERE;
        }
        a_row = qtri_hold32(0, least, greatest);
        b_row = qtri_hold32(b_row, least, greatest);
        c_row = qtri_hold32(c_row, least, greatest);
        first = qtri_greatest32(first, least);
        end = qtri_least32(end, greatest);
    }
    uint8_t *const middle = &spans[2 * QTRI_PLACE_PIXELS];
    const int32_t column = (x0 >> 8) - QTRI_PLACE_PIXELS;
    const int32_t x = column * 256 + 128 - x0;
    p->size = (uint32_t)size;
    p->column = column;
    p->row = row + first - first_row;
    p->x = x;
    p->y = y + first * 256;
    p->dx1 = dx1;
    p->dy1 = dy1;
    p->dx2 = dx2;
    p->dy2 = dy2;
    p->first = &middle[2 * first];
    middle[2 * end] = QTRI_PLACE_STOP;
    middle[2 * end + 1] = QTRI_PLACE_STOP; /* read, and of no effect: nothing ends after a stop */
    QTRI_READ_AGAIN
    const int32_t ax = 256 - x - (QTRI_DIVIDE ? 0 : QTRI_PLACE_REACH); /* see qtri_place_walk */
    const int32_t bx = ax + dx1;
    const int32_t by = dy1 - y;
    const int32_t dx = dx2 - dx1;
    const int32_t dy = dy2 - dy1;
    int32_t pixels = qtri_place_edge(middle, dx1, dy1, ax * dy1 + y * dx1, a_row, b_row);
    pixels += qtri_place_edge(middle, dx, dy, bx * dy - by * dx, b_row, c_row);
    pixels += qtri_place_edge(middle, -dx2, -dy2, -ax * dy2 - y * dx2, c_row, a_row);
    if (pixels == 0) {
        return QTRI_PLACED_NOWHERE;
    }
    p->pixels = -pixels;
    p->cut = !inner && (column < bounds->x0 || column + 2 * QTRI_PLACE_PIXELS + 1 > bounds->x1);
    return QTRI_PLACED_SMALL;
}

/* The end of qtri_place_set_more() where depths or 1/w may differ by too much. */
bool qtri_place_uneven(qtri_place *p, const qtri_vertex *a, const qtri_vertex *b,
                       const qtri_vertex *c);

/* What 1/w has more. False: that is too much, or depth is too steep. */
static inline bool qtri_place_set_more(qtri_place *p, const qtri_vertex *a, const qtri_vertex *b,
                                       const qtri_vertex *c)
{
    const uint32_t exponents = (a->depth_16p8 ^ b->depth_16p8) | (a->depth_16p8 ^ c->depth_16p8);
    const int32_t b_more = (int32_t)(b->inv_w - a->inv_w);
    const int32_t c_more = (int32_t)(c->inv_w - a->inv_w);
    if (((exponents & QTRI_PLACE_UNEVEN) | (qtri_about(b_more) | qtri_about(c_more)) >> 26) != 0) {
        QTRI_RARELY();
        return qtri_place_uneven(p, a, b, c);
    }
    p->more1 = p->back ? c_more : b_more;
    p->more2 = p->back ? b_more : c_more;
    return true;
}

/* All of it. */
static inline qtri_placed qtri_place_near(qtri_place *p, uint8_t spans[QTRI_PLACE_SPANS],
                                          const qtri_raster *raster, const qtri_vertex *a,
                                          const qtri_vertex *b, const qtri_vertex *c)
{
    const qtri_placed placed = qtri_place_inline(p, spans, raster, a, b, c);
    return placed != QTRI_PLACED_SMALL || qtri_place_set_more(p, a, b, c) ? placed
                                                                          : QTRI_PLACED_LARGE;
}

/* The same as a function. */
qtri_placed qtri_place_triangle(qtri_place *p, uint8_t spans[QTRI_PLACE_SPANS],
                                const qtri_raster *raster, const qtri_vertex *a,
                                const qtri_vertex *b, const qtri_vertex *c);

#endif
