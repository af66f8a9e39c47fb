/* SPDX-License-Identifier: MIT */
#include "../bits/bits.h"
#include "rows.h"

/* Narrower than this, in 1/256 pixel, is short: see `edge`. */
#if QTRI_DIVIDE
#define NARROW ((int32_t)1 << 15)
#else
#define NARROW ((int32_t)1 << 13)
#endif

/*
 * x where the edge from a down to b crosses the centre of `row`, as the first pixel whose centre is
 * at or right of it: ceil((X - 128) / 256) = floor((X + 127.99..) / 256). Taken as the first pixel
 * of a left edge and the end of a right one, a centre exactly on an edge is inside on the left
 * only.
 *
 * In a short triangle that is (numerator + k step) / denominator for row k, all of 31 bits: with x
 * from a pixel `base` left of everything, 0 <= X < 2^15 + 2^8 and length < 2^15 the numerator
 * X length + 128 length - 1 is below 2^31, and not negative in the rows that the edge passes.
 */
static inline qtri_edge edge_from(const qtri_screen_point *a, const qtri_screen_point *b,
                                  int32_t base, int32_t row)
{
    qtri_edge e;
    int32_t length = b->y_24p8 - a->y_24p8;
    int32_t delta = b->x_24p8 - a->x_24p8;
    int32_t along = row * 256 + 128 - a->y_24p8;
    e.numerator = (a->x_24p8 - base * 256 + 128) * length + along * delta - 1;
    e.step = delta * 256;
    e.denominator = length * 256;
#if !QTRI_DIVIDE
    e.quotient = base;
#endif
    return e;
}

/* The spans of a short triangle. False when none of them has a pixel: its edges never cross. */
static bool find_spans(qtri_triangle *t)
{
    const int32_t base = t->x_least >> 8;
    const qtri_screen_point *from = t->top;
    const qtri_screen_point *to = t->middle;
    int32_t row = t->row;
    int32_t stop = qtri_least32(qtri_first_center(to->y_24p8), t->end);
    qtri_edge long_edge = edge_from(from, t->bottom, base, row);
    int16_t *side = t->long_is_left ? &t->spans->left : &t->spans->right;
    int32_t across = t->long_is_left ? 1 : -1;
    int32_t any = 0;
    for (;;) {
        if (row < stop) {
            qtri_edge short_edge = edge_from(from, to, base, row);
            const int16_t *end = side + 2 * (stop - row);
            row = stop;
            do {
                int32_t x = qtri_edge_next(&long_edge, base);
                int32_t x_other = qtri_edge_next(&short_edge, base);
                any |= x ^ x_other;
                side[across] = (int16_t)x_other;
                *side = (int16_t)x;
                side += 2;
                QTRI_HOLD(side);
            } while (side != end);
        }
        if (row == t->end) {
            return any != 0;
        }
        from = to;
        to = t->bottom;
        stop = t->end;
    }
}

/*
 * The long edge goes from top to bottom, two short ones by way of the middle. It is on the left
 * when the middle lies right of it: when the area of top, middle, bottom is positive, which is the
 * triangle's, or its negative after an odd number of exchanges.
 */
bool qtri_triangle_begin(const qtri_raster *raster, qtri_triangle *t)
{
    const qtri_screen_point *top = t->p[0];
    const qtri_screen_point *middle = t->p[1];
    const qtri_screen_point *bottom = t->p[2];
    const qtri_screen_point *swap;
    bool positive = t->area >= 0; /* never 0 */
    if (middle->y_24p8 < top->y_24p8) {
        swap = top, top = middle, middle = swap;
        positive = !positive;
    }
    if (bottom->y_24p8 < middle->y_24p8) {
        swap = middle, middle = bottom, bottom = swap;
        positive = !positive;
        if (middle->y_24p8 < top->y_24p8) {
            swap = top, top = middle, middle = swap;
            positive = !positive;
        }
    }
    t->row = qtri_greatest32(qtri_first_center(top->y_24p8), raster->bounds.y0);
    t->end = qtri_least32(qtri_first_center(bottom->y_24p8), raster->bounds.y1);
    if (t->row >= t->end && raster->samples == NULL) {
        return false;
    }
    int32_t x_least = qtri_least32(top->x_24p8, qtri_least32(middle->x_24p8, bottom->x_24p8));
    int32_t x_greatest =
        qtri_greatest32(top->x_24p8, qtri_greatest32(middle->x_24p8, bottom->x_24p8));
    t->top = top;
    t->middle = middle;
    t->bottom = bottom;
    t->long_is_left = positive;
    t->x_least = x_least;
    t->x_greatest = x_greatest;
    t->cut = x_least < raster->bounds.x0 * 256 || x_greatest > raster->bounds.x1 * 256;
    if (t->cut && raster->samples == NULL &&
        qtri_greatest32(qtri_first_center(x_least), raster->bounds.x0) >=
            qtri_least32(qtri_first_center(x_greatest), raster->bounds.x1)) {
        return false;
    }
    const int32_t width = x_greatest - x_least;
    const int32_t height = bottom->y_24p8 - top->y_24p8;
    t->extent = width + height;
    t->is_short =
        t->end - t->row <= QTRI_ROWS_AHEAD && width < NARROW && height < ((int32_t)1 << 15);
    return !QTRI_WITH_FAST_PATHS || !t->is_short || raster->samples != NULL || find_spans(t);
}

#if !QTRI_LONG_MULTIPLY
int64_t qtri_triangle_area_far(const qtri_screen_point *a, const qtri_screen_point *b,
                               const qtri_screen_point *c)
{
    return qtri_mul_s32(b->x_24p8 - a->x_24p8, c->y_24p8 - a->y_24p8) -
           qtri_mul_s32(c->x_24p8 - a->x_24p8, b->y_24p8 - a->y_24p8);
}
#endif
