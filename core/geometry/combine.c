#include "qtri/transform.h"

#include "../bits/bits.h"
#include "row.h"
#include "row16.h"

/*
 * Sums of rows: the product of two transforms, and the viewport. In 64 bits, which is a tenth of
 * the work that wide scalars make of it; those serve what does not fit.
 */

/*
 * floor(m t 2^-shift) for |m| <= 2^30, |t| < 2^61 and 1 <= shift; false when it is not below 2^60.
 * The product is middle 2^32 + low.
 */
static bool scaled_product(int64_t *out, int32_t m, int64_t t, int32_t shift)
{
    int32_t t_low = (int32_t)(uint32_t)((uint64_t)t & UINT32_MAX);
    int64_t low = qtri_mul_s32(m, t_low);
    int64_t middle = qtri_mul_s32(m, (int32_t)(t >> 32)) + (low >> 32); /* < 2^59 + 2^30 */
    middle += t_low < 0 ? m : 0; /* t_low stands for t_low + 2^32 */
    if (shift >= 32) {
        *out = middle >> (shift > 94 ? 62 : shift - 32);
        return true;
    }
    int64_t beyond = middle >> (28 + shift);
    *out = (int64_t)((uint64_t)middle << (32 - shift) | ((uint64_t)low & UINT32_MAX) >> shift);
    return beyond == 0 || beyond == -1;
}

/* Adds t 2^-shift, rounded down, where that is below 2^60. */
static bool add_shifted(int64_t *sum, int64_t t, int32_t shift)
{
    if (shift < 0) {
        int32_t spare = qtri_clz64(qtri_magnitude64(t) | 1u) - 4;
        if (-shift > spare) {
            return t == 0;
        }
        *sum += t * ((int64_t)1 << -shift);
        return true;
    }
    *sum += t >> (shift > 63 ? 63 : shift);
    return qtri_magnitude64(t) >> 60 == 0 || shift > 0;
}

bool qtri_row_combine(qtri_row *out, const qtri_row *const row[], const int32_t factor[], int count,
                      int32_t exponent, int64_t t)
{
    int32_t least = INT32_MAX;
    for (int k = 0; k < count; k++) {
        if (factor[k] != 0 && row[k]->exponent < least) {
            least = row[k]->exponent;
        }
    }
    if (least == INT32_MAX) {
        return false; /* every factor is 0 */
    }
    int64_t sum[3] = {0, 0, 0};
    for (int k = 0; k < count; k++) {
        int32_t shift = row[k]->exponent - least;
        for (int j = 0; j < 3 && factor[k] != 0; j++) {
            int64_t product = qtri_mul_s32(factor[k], row[k]->m[j]);
            sum[j] += shift == 0 ? product : product >> (shift > 63 ? 63 : shift); /* < 3 2^60 */
        }
    }
    uint64_t size = qtri_magnitude64(sum[0]) | qtri_magnitude64(sum[1]) | qtri_magnitude64(sum[2]);
    int32_t down = 34 - qtri_clz64(size | 1u); /* leaves 30 bits */
    if (down < 16) {
        return false; /* below 2^45: what was cut off could show in 30 bits */
    }
    qtri_row result;
    result.exponent = exponent + least - down;
    result.t = 0;
    if (!add_shifted(&result.t, t, down - least)) {
        return false;
    }
    for (int k = 0; k < count; k++) {
        int64_t product = 0;
        if (factor[k] != 0 &&
            !scaled_product(&product, factor[k], row[k]->t, row[k]->exponent - least + down)) {
            return false;
        }
        result.t += product; /* <= 4 2^60 */
    }
    if (qtri_magnitude64(result.t) >> 61 != 0) {
        return false;
    }
    for (int j = 0; j < 3; j++) {
        result.m[j] = (int32_t)qtri_shift_round(sum[j], down);
    }
    *out = result;
    return true;
}

/* |m| <= 2^30, |t| < 2^61 and an exponent that builders make: a user's row may hold any bits. */
static bool is_sound(const qtri_row *row)
{
    for (int i = 0; i < 3; i++) {
        if (row->m[i] > (int32_t)1 << 30 || row->m[i] < -((int32_t)1 << 30)) {
            return false;
        }
    }
    return qtri_magnitude64(row->t) >> 61 == 0 && row->exponent >= -4096 && row->exponent <= 4096;
}

static bool is_linear_zero(const qtri_row *row)
{
    return (row->m[0] | row->m[1] | row->m[2]) == 0;
}

/* 0 0 0 1: of everything but a projection. */
static bool is_affine(const qtri_transform *b)
{
    return is_linear_zero(&b->row[3]) && b->row[3].t == (int64_t)1 << 59 &&
           b->row[3].exponent == 59 - 16 && is_sound(&b->row[0]) && is_sound(&b->row[1]) &&
           is_sound(&b->row[2]);
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

/* out may be a: a row of the product needs one row of it. */
QTRI_NOINLINE static void mul_rows(qtri_transform *out, const qtri_transform *a,
                                   const qtri_transform *b)
{
    const qtri_row *const row[3] = {&b->row[0], &b->row[1], &b->row[2]};
    const bool affine = is_affine(b);
    for (int i = 0; i < 4; i++) {
        const qtri_row *left = &a->row[i];
        const bool quick = affine && is_sound(left);
        if (quick && is_linear_zero(left)) {
            out->row[i] = *left;
        } else if (!quick ||
                   !qtri_row_combine(&out->row[i], row, left->m, 3, left->exponent, left->t)) {
            qtri_row_mul(&out->row[i], left, b);
        }
    }
}

QTRI_NOINLINE static void mul_onto(qtri_transform *b, const qtri_transform *a)
{
    const qtri_transform copy = *b;
    mul_rows(b, a, &copy);
}

void qtri_transform_mul(qtri_transform *out, const qtri_transform *a, const qtri_transform *b)
{
    if (out == b) {
        mul_onto(out, a);
    } else {
        mul_rows(out, a, b);
    }
}
