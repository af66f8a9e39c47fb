/* SPDX-License-Identifier: MIT */
#include "rows.h"

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
    rows->turn = qtri_least32(qtri_first_center(t->middle->y_24p8), t->end);
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
    int32_t end = qtri_least32(row + QTRI_ROWS_AHEAD, rows->end);
    int32_t count = end - row;
    while (row < end) {
        if (row == rows->turn) {
            *(rows->lower_is_left ? &rows->left : &rows->right) = rows->lower;
        }
        int32_t stop = row < rows->turn ? qtri_least32(rows->turn, end) : end;
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
