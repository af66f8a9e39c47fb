/* SPDX-License-Identifier: MIT */
#include <stddef.h>

#include "../bits/bits.h"
#include "../bits/wide.h"
#include "row.h"

/*
 * The smallest exponent wins: m keeps 30 bits of the largest linear element, t at most 60 bits.
 * |wide m| < 2^62, so a shift of 32 leaves |m| <= 2^30 after rounding, and 2 leave |t| <= 2^60.
 */
void qtri_row_from_wide(qtri_row *row, const qtri_wide element[4])
{
    const int32_t least = qtri_wide_least(element, 3);
    const int32_t exponent = qtri_least32(least != INT32_MAX ? least - 32 : INT32_MAX,
                                          element[3].m != 0 ? element[3].e - 18 : INT32_MAX);
    row->exponent = exponent == INT32_MAX ? 0 : exponent; /* 0: a row of zeros */
    for (int i = 0; i < 4; i++) {
        int32_t shift = element[i].e - row->exponent - (i < 3 ? 0 : 16);
        int64_t rounded = qtri_shift_round(element[i].m, shift);
        if (i < 3) {
            row->m[i] = (int32_t)rounded;
        } else {
            row->t = rounded;
        }
    }
}

void qtri_row_from_two(qtri_row *row, int i, const qtri_wide *x, int j, const qtri_wide *y)
{
    qtri_wide element[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    element[i] = *x;
    element[j] = *y;
    qtri_row_from_wide(row, element);
}

void qtri_wide_from_vec3(qtri_wide out[3], const qtri_vec3 *v)
{
    qtri_wide_set(&out[0], v->x, 16);
    qtri_wide_set(&out[1], v->y, 16);
    qtri_wide_set(&out[2], v->z, 16);
}

void qtri_row_axis(qtri_wide out[3], const qtri_row *row)
{
    for (int i = 0; i < 3; i++) {
        qtri_wide_set(&out[i], row->m[i], row->exponent);
    }
}

qtri_wide qtri_row_element(const qtri_row *row, int column)
{
    if (column < 3) {
        return qtri_wide_make(row->m[column], row->exponent);
    }
    /* A row of random bits must not overflow; qtri_wide_make makes 0 of such exponents. */
    return qtri_wide_make(row->t, row->exponent > INT32_MAX - 16 ? INT32_MAX : row->exponent + 16);
}

void qtri_row_about(qtri_row *row, const qtri_wide axis[3], const qtri_wide point[3],
                    const qtri_wide *image)
{
    qtri_wide element[4] = {axis[0], axis[1], axis[2], {0, 0}};
    /* A large translation costs the axis bits: the first pass finds the exponent, the second t. */
    for (int pass = 0; pass < 2; pass++) {
        if (image != NULL) {
            element[3] = *image;
        } else {
            qtri_wide_set(&element[3], 0, 0);
        }
        for (int column = 0; column < 3; column++) {
            qtri_wide_sub_product(&element[3], &element[column], &point[column]);
        }
        qtri_row_from_wide(row, element);
        for (int column = 0; column < 3; column++) {
            element[column] = qtri_row_element(row, column);
        }
    }
}

/*
 * Weighted sums of rows, for products of transforms and the viewport. In 64 bits, which is a tenth
 * of the work of wide scalars; these serve what does not fit.
 */

/* The two words of x. */
static inline int32_t high_word(int64_t x)
{
    return (int32_t)(x >> 32);
}

static inline uint32_t low_word(int64_t x)
{
    return (uint32_t)((uint64_t)x & UINT32_MAX);
}

/*
 * floor(m t 2^-shift) for |t| < 2^61 and 16 <= shift; false where shift < 32 and it is not below
 * 2^60. The product is middle 2^32 + low.
 */
static inline bool scaled_product(int64_t *out, int32_t m, int64_t t, int32_t shift)
{
    const int32_t t_low = (int32_t)low_word(t);
    int32_t t_high = high_word(t);
    QTRI_HOLD(t_high); /* or GCC 12 multiplies 64 bits */
    const int64_t low = qtri_mul_s32(m, t_low);
    int64_t middle = qtri_mul_s32(m, t_high) + high_word(low); /* < 2^60 + 2^31 */
    middle += t_low < 0 ? m : 0;                               /* t_low stands for t_low + 2^32 */
    if (shift >= 32) {
        *out = middle >> (shift > 94 ? 62 : shift - 32);
        return true;
    }
    const uint32_t upper = (uint32_t)high_word(middle) << (32 - shift) | low_word(middle) >> shift;
    const uint32_t lower = low_word(middle) << (32 - shift) | low_word(low) >> shift;
    const int32_t beyond = high_word(middle) >> (shift - 4);
    *out = (int64_t)((uint64_t)upper << 32 | lower);
    return (uint32_t)beyond + 1u < 2u; /* 0 or -1 */
}

/* Adds t 2^-shift, t not 0, rounded down, where that is below 2^60. */
static bool add_shifted(int64_t *sum, int64_t t, int32_t shift)
{
    if (shift < 0) {
        int32_t spare = qtri_clz64(qtri_magnitude64(t)) - 4;
        if (-shift > spare) {
            return false;
        }
        *sum += qtri_shift_left64(t, -shift);
        return true;
    }
    *sum += t >> (shift > 63 ? 63 : shift);
    return qtri_magnitude64(t) >> 60 == 0 || shift > 0;
}

/* x 2^-down to nearest, halves up, for 2 <= down <= 32 and a result within 2^30. */
static inline int32_t rounded(int64_t x, int32_t down)
{
    const int32_t twice =
        (int32_t)((uint32_t)high_word(x) << (33 - down) | low_word(x) >> (down - 1));
    return (twice >> 1) + (twice & 1);
}

/* A row times 2^n 2^-exponent, plus the translation: without products. */
static bool scale_by_power(qtri_row *out, const qtri_row *row, int32_t factor, int32_t exponent,
                           int64_t t)
{
    const int32_t n = 31 - qtri_clz32((uint32_t)factor);
    const uint32_t most = (uint32_t)1 << 30; /* a user's m may be more */
    int64_t moved = row->t;
    if (qtri_magnitude32(row->m[0]) > most || qtri_magnitude32(row->m[1]) > most ||
        qtri_magnitude32(row->m[2]) > most ||
        (t != 0 && !add_shifted(&moved, t, n - row->exponent)) ||
        qtri_magnitude64(moved) >> 61 != 0) {
        return false;
    }
    out->t = moved;
    out->exponent = exponent + row->exponent - n;
    for (int j = 0; j < 3; j++) {
        out->m[j] = row->m[j];
    }
    return true;
}

bool qtri_row_combine(qtri_row *out, const qtri_row *const row[], const int32_t factor[], int count,
                      int32_t exponent, int64_t t)
{
    int32_t least = INT32_MAX;
    int used = 0;
    int last = 0;
    for (int k = 0; k < count; k++) {
        if (factor[k] != 0) {
            least = qtri_least32(least, row[k]->exponent);
            last = k;
            used++;
        }
    }
    if (used == 0) {
        return false; /* every factor is 0 */
    }
    if (used == 1 && factor[last] > 0 && (factor[last] & (factor[last] - 1)) == 0) {
        return scale_by_power(out, row[last], factor[last], exponent, t);
    }
    /* In three variables: in an array they cost an empty draw call 5 % more on a Cortex-M0+. */
    uint64_t x = 0;
    uint64_t y = 0;
    uint64_t z = 0;
    for (int k = 0; k <= last; k++) {
        const int32_t by = factor[k];
        if (by == 0) {
            continue;
        }
        const int32_t *const m = row[k]->m;
        const int32_t shift = row[k]->exponent - least;
        if (shift == 0) { /* mostly: an empty draw call takes 5 % less on a Cortex-M3 */
            x += (uint64_t)qtri_mul_s32(by, m[0]); /* <= 2^62 each, < 2^60 within the promise */
            y += (uint64_t)qtri_mul_s32(by, m[1]);
            z += (uint64_t)qtri_mul_s32(by, m[2]);
        } else {
            const int32_t held = qtri_least32(shift, 63);
            x += (uint64_t)(qtri_mul_s32(by, m[0]) >> held);
            y += (uint64_t)(qtri_mul_s32(by, m[1]) >> held);
            z += (uint64_t)(qtri_mul_s32(by, m[2]) >> held);
        }
    }
    const uint64_t size = qtri_magnitude64(qtri_wrap64(x)) | qtri_magnitude64(qtri_wrap64(y)) |
                          qtri_magnitude64(qtri_wrap64(z));
    const int32_t down = 34 - qtri_clz64(size | 1u); /* leaves 30 bits */
    /* Below 2^45 what was cut off could show in 30 bits; from 2^62 on, where sums up to 3 2^62 that
       have wrapped are as well, an m or a factor is none of a builder's. */
    if (down < 16 || down > 32) {
        return false;
    }
    int64_t moved = 0;
    if (t != 0 && !add_shifted(&moved, t, down - least)) {
        return false;
    }
    for (int k = 0; k <= last; k++) {
        int64_t product = 0;
        if (factor[k] != 0 && row[k]->t != 0 &&
            !scaled_product(&product, factor[k], row[k]->t, row[k]->exponent - least + down)) {
            return false;
        }
        moved += product; /* <= 4 2^60 */
    }
    if (qtri_magnitude64(moved) >> 61 != 0) {
        return false;
    }
    out->t = moved; /* may be one of the rows, which have been read */
    out->exponent = exponent + least - down;
    out->m[0] = rounded(qtri_wrap64(x), down);
    out->m[1] = rounded(qtri_wrap64(y), down);
    out->m[2] = rounded(qtri_wrap64(z), down);
    return true;
}

void qtri_row_mul(qtri_row *out, const qtri_row *a, const qtri_transform *b)
{
    qtri_wide element[4];
    for (int j = 0; j < 4; j++) {
        qtri_wide_set(&element[j], 0, 0);
        for (int k = 0; k < 4; k++) {
            const qtri_wide left = qtri_row_element(a, k);
            const qtri_wide right = qtri_row_element(&b->row[k], j);
            qtri_wide_add_product(&element[j], &left, &right);
        }
    }
    qtri_row_from_wide(out, element);
}

/* ---- Linear parts ---- */

int32_t qtri_linear_align(int32_t out[3][4], const qtri_transform *t)
{
    int32_t least = INT32_MAX;
    for (int row = 0; row < 3; row++) {
        const int32_t *m = t->row[row].m;
        if ((m[0] | m[1] | m[2]) != 0 && t->row[row].exponent < least) {
            least = t->row[row].exponent;
        }
    }
    for (int row = 0; row < 3; row++) {
        int32_t shift = least == INT32_MAX ? 0 : t->row[row].exponent - least;
        for (int i = 0; i < 3; i++) {
            out[row][i] = t->row[row].m[i] >> (shift < 0 || shift > 31 ? 31 : shift);
        }
    }
    return least == INT32_MAX ? 0 : least;
}

int64_t qtri_linear_dot(int32_t m[3][4], int i, int j)
{
    return qtri_mul_s32(m[0][i], m[0][j]) + qtri_mul_s32(m[1][i], m[1][j]) +
           qtri_mul_s32(m[2][i], m[2][j]);
}

bool qtri_linear_is_even(int32_t m[3][4])
{
    const int64_t square = qtri_linear_dot(m, 0, 0);
    const uint64_t noise = (uint64_t)square >> 20;
    return square != 0 && qtri_magnitude64(qtri_linear_dot(m, 1, 1) - square) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 2, 2) - square) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 0, 1)) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 1, 2)) <= noise &&
           qtri_magnitude64(qtri_linear_dot(m, 2, 0)) <= noise;
}

/* Cofactors times the sign of the determinant: the inverse transpose without its division. */
void qtri_linear_normals(int32_t out_q28[3][3], const qtri_transform *object_to_eye)
{
    qtri_wide column[3][3];
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 3; row++) {
            column[i][row] = qtri_row_element(&object_to_eye->row[row], i);
        }
    }
    qtri_wide cofactor[3][3]; /* columns */
    for (int i = 0; i < 3; i++) {
        int next = i < 2 ? i + 1 : 0;
        qtri_wide_cross(cofactor[i], column[next], column[3 - i - next]);
    }
    const int32_t least = qtri_wide_least(cofactor[0], 9);
    bool mirrored = qtri_wide_inner(column[0], cofactor[0]).m < 0;
    for (int i = 0; i < 3; i++) {
        for (int row = 0; row < 3; row++) {
            qtri_wide c = cofactor[i][row];
            int32_t size = (int32_t)qtri_shift_round(c.m, c.m == 0 ? 0 : c.e - least + 34);
            out_q28[row][i] = mirrored ? -size : size;
        }
    }
}
