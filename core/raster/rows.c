#include "rows.h"

/* Narrower than this, in 1/256 pixel, is short: see qtri_rows_short. */
#if QTRI_DIVIDE
#define NARROW ((int32_t)1 << 15)
#else
#define NARROW ((int32_t)1 << 13)
#endif

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

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
typedef struct edge {
    int32_t numerator, step, denominator;
#if !QTRI_DIVIDE
    int32_t quotient;
#endif
} edge;

static inline edge edge_from(const qtri_screen_point *a, const qtri_screen_point *b, int32_t base,
                             int32_t row)
{
    edge e;
    int32_t length = b->y_24p8 - a->y_24p8;
    int32_t delta = b->x_24p8 - a->x_24p8;
    int32_t along = row * 256 + 128 - a->y_24p8;
    e.numerator = (a->x_24p8 - base * 256) * length + along * delta + 128 * length - 1;
    e.step = delta * 256;
    e.denominator = length * 256;
#if !QTRI_DIVIDE
    e.quotient = 0;
#endif
    return e;
}

/* The pixel in this row; goes on to the next. */
static inline int32_t edge_next(edge *e)
{
#if QTRI_DIVIDE
    int32_t quotient = (int32_t)((uint32_t)e->numerator / (uint32_t)e->denominator);
    e->numerator += e->step;
    return quotient;
#else
    /* A pixel or two a row: cheaper than a division, and at most 33 at first. */
    int32_t numerator = e->numerator;
    int32_t quotient = e->quotient;
    while (numerator < 0) {
        numerator += e->denominator;
        quotient--;
    }
    while (numerator >= e->denominator) {
        numerator -= e->denominator;
        quotient++;
    }
    e->numerator = numerator + e->step;
    e->quotient = quotient;
    return quotient;
#endif
}

/* One side of `rows` spans; the other side is beside it. */
static void walk(int16_t *side, edge e, int32_t base, int32_t rows)
{
    for (; rows > 0; rows--) {
        *side = (int16_t)(base + edge_next(&e));
        side += 2;
    }
}

/* Whether one of the rows has a pixel: the two edges of a triangle never cross. */
static bool covers(const qtri_span *span, int32_t rows)
{
    for (; rows > 0; rows--, span++) {
        if (span->left != span->right) {
            return true;
        }
    }
    return false;
}

bool qtri_rows_short(qtri_triangle *t)
{
    const int32_t row = t->row;
    t->is_short = t->end - row <= QTRI_ROWS_AHEAD && t->x_greatest - t->x_least < NARROW &&
                  t->bottom->y_24p8 - t->top->y_24p8 < ((int32_t)1 << 15);
    if (!t->is_short) {
        return true;
    }
    const int32_t base = t->x_least >> 8;
    const int32_t middle = qtri_first_center(t->middle->y_24p8);
    const int32_t turn = middle < row ? row : least(middle, t->end);
    int16_t *one = t->long_is_left ? &t->spans->left : &t->spans->right;
    int16_t *other = t->long_is_left ? &t->spans->right : &t->spans->left;
    walk(one, edge_from(t->top, t->bottom, base, row), base, t->end - row);
    if (row < turn) {
        walk(other, edge_from(t->top, t->middle, base, row), base, turn - row);
    }
    if (turn < t->end) {
        other += 2 * (turn - row);
        walk(other, edge_from(t->middle, t->bottom, base, turn), base, t->end - turn);
    }
    return covers(t->spans, t->end - row);
}

static void dda_init(qtri_dda *dda, const qtri_screen_point *a, const qtri_screen_point *b,
                     int32_t row)
{
    int32_t length = b->y_24p8 - a->y_24p8;
    int32_t along = row * 256 + 128 - a->y_24p8;
    qtri_dda_init(dda, a->x_24p8, b->x_24p8 - a->x_24p8, length, along, 128 * length - 1);
}

void qtri_rows_init(qtri_rows *rows, const qtri_triangle *t)
{
    qtri_dda *long_edge = t->long_is_left ? &rows->left : &rows->right;
    qtri_dda *short_edge = t->long_is_left ? &rows->right : &rows->left;
    rows->lower_is_left = !t->long_is_left;
    rows->row = t->row;
    rows->end = t->end;
    rows->turn = least(qtri_first_center(t->middle->y_24p8), t->end);
    dda_init(long_edge, t->top, t->bottom, t->row);
    if (t->row < rows->turn) {
        dda_init(short_edge, t->top, t->middle, t->row);
        if (rows->turn < t->end) {
            dda_init(&rows->lower, t->middle, t->bottom, rows->turn);
        }
    } else {
        dda_init(short_edge, t->middle, t->bottom, t->row);
        rows->turn = t->end;
    }
}

int32_t qtri_rows_next(qtri_rows *rows, qtri_span spans[QTRI_ROWS_AHEAD])
{
    int32_t row = rows->row;
    int32_t end = least(row + QTRI_ROWS_AHEAD, rows->end);
    int32_t count = end - row;
    while (row < end) {
        if (row == rows->turn) {
            *(rows->lower_is_left ? &rows->left : &rows->right) = rows->lower;
        }
        int32_t stop = row < rows->turn ? least(rows->turn, end) : end;
        qtri_dda left = rows->left;
        qtri_dda right = rows->right;
        for (; row < stop; row++) {
            spans->left = (int16_t)left.value;
            spans->right = (int16_t)right.value;
            spans++;
            qtri_dda_next(&left);
            qtri_dda_next(&right);
        }
        rows->left = left;
        rows->right = right;
    }
    rows->row = end;
    return count;
}
