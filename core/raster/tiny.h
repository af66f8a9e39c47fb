/*
 * Tiny triangles of a mesh of one colour, as most are, in RGB565 with depth "less" and written, in
 * surfaces whose rows of pixels and of depths are equally far apart: placed, set up and filled in
 * one go, with the general path's pixels to the bit. Internal.
 *
 * Between qtri_tiny_place and qtri_tiny_draw the caller finds the light of what touches a pixel.
 * Both are inline: of a triangle of seven pixels, calls and what they pass would be a tenth.
 * Positions count from the first pixel, so that all is small.
 */
#ifndef QTRI_RASTER_TINY_H
#define QTRI_RASTER_TINY_H

#include "../geometry/projector.h"
#include "../bits/multiply.h"
#include "loop.h"
#include "packed.h"
#include "rows.h"
#include "setup.h"
#include "small.h"

/* Centres of rows below QTRI_TINY_SIDE. */
#define QTRI_TINY_ROWS (2 * QTRI_TINY_REACH + 1)

typedef struct qtri_tiny {
    int32_t column, row, end;   /* the first pixel's place; the row after the last */
    int32_t x, y;               /* its centre from vertex 0, 1/256 pixel */
    int32_t middle_x, middle_y; /* the anchor's pixel from there */
    int32_t dx1, dy1, dx2, dy2; /* vertices 1 and 2 from 0; of a back face 2 and 1 */
    int32_t size;               /* twice the area, 1/256 pixel squared; negative: a back face */
    /* Of each row the first pixel and the one after the last, from `column` on; then a row that
       begins with QTRI_TINY_STOP, after which nothing can end. */
    uint8_t spans[2 * QTRI_TINY_ROWS + 2];
} qtri_tiny;

#define QTRI_TINY_STOP 255

typedef enum qtri_placed {
    QTRI_PLACED_NOWHERE, /* touches no pixel */
    QTRI_PLACED_OTHER,   /* not tiny, a sliver, or cut off at a side */
    QTRI_PLACED_TINY
} qtri_placed;

/* An edge's pixels in rows up to `stop`; returns their sum. */
static inline int32_t qtri_tiny_walk(uint8_t *side, const uint8_t *stop, int32_t numerator,
                                     int32_t step, int32_t denominator)
{
    int32_t sum = 0;
    qtri_edge edge;
    edge.numerator = numerator;
    edge.step = step;
    edge.denominator = denominator;
#if !QTRI_DIVIDE
    edge.quotient = 0;
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
 * cover.c its pixel in a row is numerator / (256 dy); with Y from the centre of the first row, X
 * from half a pixel left of the first column's edge, and `cross` X dy - Y dx of either end, the
 * numerator is cross + 256 row dx - 1. Sides are below 2304, so that 0 <= X < 2^12, |Y| < 2^12 even
 * where a scissor cuts rows off, rows <= 9, and all of that is below 2^25.
 *
 * Returns the sum of its pixels, negative on the right: of all three together it is 0 where no row
 * has a pixel, since edges never cross.
 */
static inline int32_t qtri_tiny_edge(uint8_t *spans, int32_t dx, int32_t dy, int32_t cross,
                                     int32_t from, int32_t to)
{
    const int32_t step = dx * 256;
    if (from < to) {
        return qtri_tiny_walk(&spans[2 * from], &spans[2 * to], cross + from * step - 1, step,
                              dy * 256);
    }
    if (from > to) {
        return -qtri_tiny_walk(&spans[2 * to + 1], &spans[2 * from + 1], -cross - to * step - 1,
                               -step, dy * -256);
    }
    return 0;
}

/* -1 where x is negative, or 0. */
static inline int32_t qtri_sign(int32_t x)
{
    return x >> 31; // cppcheck-suppress shiftTooManyBitsSigned
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

/* Finds the spans of one whose place is known; `cut`: some of its rows are not to be drawn. */
static inline qtri_placed qtri_tiny_cover(qtri_tiny *t, bool cut)
{
    const int32_t ax = 256 - t->x;
    const int32_t bx = ax + t->dx1;
    const int32_t by = t->dy1 - t->y;
    int32_t a_row = (255 - t->y) >> 8;
    int32_t b_row = (by + 255) >> 8;
    int32_t c_row = (t->dy2 - t->y + 255) >> 8;
    if (cut) {
        QTRI_RARELY();
        a_row = qtri_hold32(a_row, 0, t->end - t->row);
        b_row = qtri_hold32(b_row, 0, t->end - t->row);
        c_row = qtri_hold32(c_row, 0, t->end - t->row);
    }
    const int32_t dx = t->dx2 - t->dx1;
    const int32_t dy = t->dy2 - t->dy1;
    const int32_t ab = ax * t->dy1 + t->y * t->dx1;
    const int32_t bc = bx * dy - by * dx;
    const int32_t ca = -ax * t->dy2 - t->y * t->dx2;
    int32_t pixels = qtri_tiny_edge(t->spans, t->dx1, t->dy1, ab, a_row, b_row);
    pixels += qtri_tiny_edge(t->spans, dx, dy, bc, b_row, c_row);
    pixels += qtri_tiny_edge(t->spans, -t->dx2, -t->dy2, ca, c_row, a_row);
    t->spans[2 * (t->end - t->row)] = QTRI_TINY_STOP;
    return pixels != 0 ? QTRI_PLACED_TINY : QTRI_PLACED_NOWHERE;
}

static inline void qtri_swap(int32_t *a, int32_t *b)
{
    int32_t swap = *a;
    *a = *b;
    *b = swap;
}

/* The whole of *t, within the bounds; where it is not tiny or touches no pixel, less. */
static inline qtri_placed qtri_tiny_place(qtri_tiny *t, const qtri_rect *bounds,
                                          const qtri_vertex *a, const qtri_vertex *b,
                                          const qtri_vertex *c)
{
    const int32_t x0 = a->at.x_24p8;
    const int32_t y0 = a->at.y_24p8;
    t->dx1 = b->at.x_24p8 - x0;
    t->dy1 = b->at.y_24p8 - y0;
    t->dx2 = c->at.x_24p8 - x0;
    t->dy2 = c->at.y_24p8 - y0;
    const int32_t x_low = qtri_least_from_0(t->dx1, t->dx2);
    const int32_t width = qtri_greatest_from_0(t->dx1, t->dx2) - x_low;
    const int32_t y_low = qtri_least_from_0(t->dy1, t->dy2);
    const int32_t height = qtri_greatest_from_0(t->dy1, t->dy2) - y_low;
    const int32_t x_least = x0 + x_low;
    if (width >= QTRI_TINY_SIDE || height >= QTRI_TINY_SIDE || x_least < bounds->x0 * 256 ||
        x_least + width > bounds->x1 * 256) {
        return QTRI_PLACED_OTHER;
    }
    const int32_t y_least = y0 + y_low;
    bool cut = false;
    t->row = qtri_first_center(y_least);
    t->end = qtri_first_center(y_least + height);
    if (t->row < bounds->y0 || t->end > bounds->y1) {
        cut = true;
        t->row = t->row < bounds->y0 ? bounds->y0 : t->row;
        t->end = t->end > bounds->y1 ? bounds->y1 : t->end;
    }
    t->size = t->dx2 * t->dy1 - t->dx1 * t->dy2;
    if (t->row >= t->end || t->size == 0) {
        return QTRI_PLACED_NOWHERE;
    }
    if (qtri_gradient_is_sliver(qtri_magnitude32(t->size), width + height)) {
        return QTRI_PLACED_OTHER;
    }
    if (t->size < 0) {
        qtri_swap(&t->dx1, &t->dx2);
        qtri_swap(&t->dy1, &t->dy2);
    }
    t->column = x_least >> 8;
    t->x = t->column * 256 + 128 - x0;
    t->y = t->row * 256 + 128 - y0;
    t->middle_x = ((2 * x_least + width) >> 9) - t->column;
    t->middle_y = ((2 * y_least + height) >> 9) - t->row;
    QTRI_READ_AGAIN
    return qtri_tiny_cover(t, cut);
}

/* What turns a numerator into a step, as qtri_gradient_set_inverse() has it for a front face. */
typedef struct qtri_tiny_inverse {
    int32_t inverse, left;
} qtri_tiny_inverse;

static inline qtri_tiny_inverse qtri_tiny_invert(uint32_t size)
{
    qtri_tiny_inverse i;
    const int32_t zeros = qtri_clz32(size);
    i.inverse = qtri_gradient_inverse(qtri_reciprocal_below(size << zeros) >> 1, zeros, &i.left);
    return i;
}

/*
 * qtri_ramp_from_steps() from the first pixel on: its anchor, moved by whole pixels, is the same
 * modulo 2^32.
 */
static inline void qtri_tiny_ramp(qtri_ramp *ramp, const qtri_tiny *t, const qtri_tiny_inverse *i,
                                  uint32_t f0, int32_t f1, int32_t f2)
{
    const int32_t gx =
        qtri_mul_high_s30((f2 * t->dy1 - f1 * t->dy2) * ((int32_t)1 << i->left), i->inverse);
    const int32_t gy =
        qtri_mul_high_s30((f1 * t->dx2 - f2 * t->dx1) * ((int32_t)1 << i->left), i->inverse);
    ramp->origin = f0 + qtri_gradient_along(gx, t->x, gy, t->y) + 0x8000u;
    ramp->dx = (uint32_t)gx;
    ramp->dy = (uint32_t)gy;
}

/* Packed: shares of the tint at the anchor, what they step by, and then the first pixel. */
static inline void qtri_tiny_color(qtri_ramp *out, const int32_t tint_n6[3], const qtri_tiny *t,
                                   const qtri_tiny_inverse *inverse, int32_t i0_q15, int32_t i1_q15,
                                   int32_t i2_q15)
{
    const int32_t one_q20 = (int32_t)1 << 20;
    const int32_t half_q15 = (int32_t)1 << 14;
    const int32_t half_q16 = (int32_t)1 << 15;
    const uint32_t x = (uint32_t)t->middle_x;
    const uint32_t y = (uint32_t)t->middle_y;
    qtri_ramp share;
    qtri_tiny_ramp(&share, t, inverse, (uint32_t)i0_q15 << 7, (i1_q15 + 2) >> (QTRI_RAMP_DOWN - 7),
                   (i2_q15 + 2) >> (QTRI_RAMP_DOWN - 7));
    const uint32_t at_middle = share.origin + x * share.dx + y * share.dy - 0x8000u;
    out->origin = qtri_pack_tint(tint_n6, (int32_t)at_middle, one_q20, one_q20);
    out->dx = qtri_pack_tint(tint_n6, (int32_t)share.dx, half_q15, half_q16);
    out->dy = qtri_pack_tint(tint_n6, (int32_t)share.dy, half_q15, half_q16);
    out->origin -= x * out->dx + y * out->dy;
}

/* |x| or one less. */
static inline uint32_t qtri_about(int32_t x)
{
    return (uint32_t)(x ^ qtri_sign(x));
}

/*
 * Whether no colour strays for being linear on the screen, for intensities i1 and i2 from that of
 * vertex 0: enough for the general path's nearly_linear, range q_range < 2^16 q_least for a share
 * in Q22, since q_least >= 2^30. Neither range is more than the sum of its two differences.
 */
static inline bool qtri_tiny_is_linear(const qtri_vertex *a, const qtri_vertex *b,
                                       const qtri_vertex *c, int32_t i1_q15, int32_t i2_q15)
{
    const uint32_t range_q15 = qtri_about(i1_q15) + qtri_about(i2_q15) + 2; /* <= 2^16 + 2 */
    const uint32_t q_range = qtri_about((int32_t)(b->inv_w - a->inv_w)) +
                             qtri_about((int32_t)(c->inv_w - a->inv_w)) + 2; /* <= 2^31 + 2 */
    const uint32_t exponents = (a->depth_16p8 ^ b->depth_16p8) | (a->depth_16p8 ^ c->depth_16p8);
    return (exponents & 0xFF) == 0 && range_q15 * ((q_range >> 16) + 1) < (uint32_t)1 << 23;
}

/*
 * The pixel of a depth, which is as many bytes from it all over the surface: one pointer then walks
 * both. An integer, since no pointer may lead from one array to another.
 */
static inline uint16_t *qtri_tiny_pixel(const uint16_t *depth, uintptr_t apart)
{
    return (uint16_t *)((uintptr_t)depth + apart); /* NOLINT(performance-no-int-to-ptr) */
}

/* The rows: of packed colours, or of one pixel. Ramps start at the first pixel. */
static inline void qtri_tiny_fill(const qtri_raster *raster, const qtri_tiny *t,
                                  const qtri_ramp *depth, const qtri_ramp *color, uint32_t pixel,
                                  bool smooth)
{
    const uint8_t *span = t->spans;
    const qtri_surface *surface = raster->surface;
    uint32_t depth_step = depth->dx;
    uint32_t step = smooth ? color->dx : 0;
    const uint32_t color_dy = smooth ? color->dy : 0;
    uint32_t depth_row = depth->origin;
    uint32_t color_row = smooth ? color->origin : 0;
    const ptrdiff_t depth_pitch = surface->depth_pitch;
    qtri_lines lines = qtri_lines_at(surface, t->row);
    const uintptr_t apart = (uintptr_t)lines.pixels - (uintptr_t)lines.depths;
    uint16_t *depths = lines.depths + t->column;
    for (;;) {
        const uint32_t x = span[0];
        const uint32_t end = span[1];
        span += 2;
        if (x < end) {
            uint32_t z = depth_row + x * depth_step;
            uint32_t packed = color_row + x * step;
            uint16_t *at = depths + x;
            const uint16_t *stop = depths + end;
            do {
                if (z >> 16 < *at) {
                    QTRI_BRANCH
                    *at = (uint16_t)(z >> 16);
                    *qtri_tiny_pixel(at, apart) =
                        (uint16_t)(smooth ? qtri_packed_pixel(packed) : pixel);
                }
                z += depth_step;
                packed += step;
                at++;
                QTRI_OPAQUE(at)
                QTRI_ASIDE(depth_step)
                QTRI_ASIDE(step)
            } while (at != stop);
        } else if (x == QTRI_TINY_STOP) {
            return;
        }
        depth_row += depth->dy;
        color_row += color_dy;
        depths += depth_pitch;
    }
}

/*
 * A placed one. `face_q15`: intensity of the face; QTRI_VERTEX_UNLIT: smooth between those of the
 * vertices. False when it is not that simple: then nothing was drawn.
 */
static inline bool qtri_tiny_draw(const qtri_raster *raster, const qtri_tiny *t,
                                  const qtri_vertex *a, const qtri_vertex *b, const qtri_vertex *c,
                                  uint32_t face_q15)
{
    int32_t i0 = (int32_t)face_q15;
    int32_t i1 = 0;
    int32_t i2 = 0;
    uint32_t size = (uint32_t)t->size;
    if (t->size < 0) {
        const qtri_vertex *swap = b;
        b = c;
        c = swap;
        size = 0 - size;
    }
    if (face_q15 == QTRI_VERTEX_UNLIT) {
        i0 = a->intensity_q15;
        i1 = b->intensity_q15 - i0;
        i2 = c->intensity_q15 - i0;
    }
    const bool smooth = QTRI_WITH_SMOOTH && (i1 | i2) != 0;
    if (smooth && raster->perspective && !qtri_tiny_is_linear(a, b, c, i1, i2) &&
        (!QTRI_SMALL || !qtri_tint_is_linear(a, b, c))) {
        return false;
    }
    QTRI_READ_AGAIN
    if (!qtri_depths_are_close(a, b, c)) {
        return false;
    }
    qtri_ramp depth;
    qtri_ramp color;
    const qtri_tiny_inverse inverse = qtri_tiny_invert(size);
    qtri_tiny_ramp(&depth, t, &inverse, a->depth_16p8 & ~0xFFu, qtri_depth_step(a, b),
                   qtri_depth_step(a, c));
    if (!smooth) {
        qtri_tiny_fill(raster, t, &depth, &depth, qtri_raster_shade_565(raster, (uint32_t)i0),
                       false);
        return true;
    }
    QTRI_READ_AGAIN
    qtri_tiny_color(&color, raster->tint_n6, t, &inverse, i0, i1, i2);
    qtri_tiny_fill(raster, t, &depth, &color, 0, true);
    return true;
}

#endif
