/* SPDX-License-Identifier: MIT */
#include "wide.h"

#include "bits.h"

void qtri_wide_set(qtri_wide *x, int64_t m, int32_t e)
{
    x->m = 0;
    x->e = 0;
    if (m == 0 || e > ((int32_t)1 << 30) || e < -((int32_t)1 << 30)) {
        return; /* no caller comes near these exponents */
    }
    uint64_t size = qtri_magnitude64(m);
    int32_t shift = qtri_clz64(size) - 2;
    size = shift >= 0 ? size << shift : size >> -shift;
    e += shift;
    if (e > QTRI_WIDE_EXPONENT_MAX) {
        return;
    }
    if (e < -QTRI_WIDE_EXPONENT_MAX) {
        e = -QTRI_WIDE_EXPONENT_MAX;
        size = ((uint64_t)1 << 62) - 1;
    }
    x->m = m < 0 ? -(int64_t)size : (int64_t)size;
    x->e = e;
}

/* *to = *from by fields: compilers for small cores would call memcpy(). */
static void copy(qtri_wide *to, const qtri_wide *from)
{
    to->m = from->m;
    to->e = from->e;
}

void qtri_wide_add_to(qtri_wide *a, const qtri_wide *b)
{
    if (b->m == 0) {
        return;
    }
    if (a->m == 0) {
        copy(a, b);
        return;
    }
    const qtri_wide *large = a;
    const qtri_wide *small = b;
    int32_t shift = b->e - a->e;
    if (shift < 0) {
        shift = -shift;
        large = b;
        small = a;
    }
    int64_t sum = large->m + (shift > 62 ? 0 : small->m >> shift); /* |sum| < 2^63 */
    qtri_wide_set(a, sum, large->e);
}

int64_t qtri_mul_q62(int64_t a, int64_t b)
{
    const uint64_t size = qtri_mul_high64(qtri_magnitude64(a) << 1, qtri_magnitude64(b) << 1);
    return (a < 0) == (b < 0) ? (int64_t)size : -(int64_t)size;
}

void qtri_wide_mul_by(qtri_wide *a, const qtri_wide *b)
{
    /* Without qtri_mul_q62(), whose frame is on the deepest stack of transforms. */
    const uint64_t size = qtri_mul_high64(qtri_magnitude64(a->m) << 1, qtri_magnitude64(b->m) << 1);
    const int64_t product = (a->m < 0) == (b->m < 0) ? (int64_t)size : -(int64_t)size;
    qtri_wide_set(a, product, a->e + b->e - 62);
}

void qtri_wide_add_product(qtri_wide *sum, const qtri_wide *a, const qtri_wide *b)
{
    qtri_wide product;
    copy(&product, a);
    qtri_wide_mul_by(&product, b);
    qtri_wide_add_to(sum, &product);
}

void qtri_wide_sub_product(qtri_wide *sum, const qtri_wide *a, const qtri_wide *b)
{
    qtri_wide minus;
    minus.m = -a->m;
    minus.e = a->e;
    qtri_wide_add_product(sum, &minus, b);
}

void qtri_wide_div_by(qtri_wide *a, const qtri_wide *b)
{
    if (b->m == 0) {
        qtri_wide_set(a, a->m, -2 * QTRI_WIDE_EXPONENT_MAX);
        return;
    }
    bool half;
    const int64_t quotient =
        (int64_t)qtri_divide64(qtri_magnitude64(a->m), qtri_magnitude64(b->m), 61, &half);
    qtri_wide_set(a, (a->m < 0) == (b->m < 0) ? quotient : -quotient, a->e - b->e + 61);
}

qtri_wide qtri_wide_sqrt(qtri_wide a)
{
    qtri_wide root = {0, 0};
    if (a.m <= 0) {
        return root;
    }
    int32_t odd = a.e & 1;
    uint64_t remainder = 0;
    /* 31 bits. Heron's step doubles the good ones: (r + a / r) / 2. */
    qtri_wide_set(&root, qtri_sqrt64_floor((uint64_t)a.m << odd, &remainder), (a.e + odd) / 2);
    qtri_wide_div_by(&a, &root);
    qtri_wide_add_to(&root, &a);
    qtri_wide_set(&root, root.m, root.e + 1);
    return root;
}

int32_t qtri_wide_least(const qtri_wide *v, int count)
{
    int32_t least = INT32_MAX;
    for (int i = 0; i < count; i++) {
        least = v[i].m != 0 && v[i].e < least ? v[i].e : least;
    }
    return least;
}

/*
 * x: the components in the scale of the longest, 2^61 <= |x| < 2^62. With v = (2x)^2 4^even / 2^128
 * in [1/4, 1), 3 2^-60 of which is cut off, and y = v^-1/2: the root of 32 bits and its reciprocal
 * are within 2^-30 of y, and Newton's step y + y (1 - v y^2) / 2 leaves 3/2 2^-60.
 */
bool qtri_wide_unit_q62(int64_t unit_q62[3], const qtri_wide v[3])
{
    uint64_t x[3];
    uint64_t square = 0;
    const int32_t least = qtri_wide_least(v, 3);
    if (least == INT32_MAX) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        const int32_t shift = v[i].m == 0 ? 0 : v[i].e - least;
        x[i] = shift > 62 ? 0 : qtri_magnitude64(v[i].m) >> shift;
        square += qtri_mul_high64(x[i] << 1, x[i] << 1); /* < 2^62 each, >= 2^60 in all */
    }
    const int32_t even = (qtri_clz64(square) & 2) >> 1;
    uint64_t remainder;
    square <<= 2 * even;
    const uint32_t y_q30 = qtri_reciprocal_q62(qtri_sqrt64_floor(square, &remainder));
    const uint64_t unit_q60 = qtri_mul_high64(square, qtri_mul_u32(y_q30, y_q30));
    const int64_t half_error_q60 = (((int64_t)1 << 60) - (int64_t)unit_q60) >> 1; /* <= 2^30 */
    const int64_t step = qtri_mul_s32((int32_t)(y_q30 >> 1), (int32_t)half_error_q60);
    const uint64_t y_q62 = ((uint64_t)y_q30 << 32) + (uint64_t)(step >> 27);
    for (int i = 0; i < 3; i++) {
        const uint64_t size = qtri_mul_high64(x[i] << (1 + even), y_q62);
        unit_q62[i] = v[i].m < 0 ? -(int64_t)size : (int64_t)size;
    }
    return true;
}

bool qtri_wide_normalize(qtri_wide v[3])
{
    int64_t unit_q62[3];
    if (!qtri_wide_unit_q62(unit_q62, v)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        qtri_wide_set(&v[i], unit_q62[i], 62);
    }
    return true;
}

void qtri_wide_cross(qtri_wide out[3], const qtri_wide a[3], const qtri_wide b[3])
{
    int j = 1;
    int k = 2;
    for (int i = 0; i < 3; i++) {
        qtri_wide_set(&out[i], 0, 0);
        qtri_wide_add_product(&out[i], &a[j], &b[k]);
        qtri_wide_sub_product(&out[i], &a[k], &b[j]);
        j = k;
        k = i;
    }
}

qtri_wide qtri_wide_inner(const qtri_wide a[3], const qtri_wide b[3])
{
    qtri_wide sum = {0, 0};
    for (int i = 0; i < 3; i++) {
        qtri_wide_add_product(&sum, &a[i], &b[i]);
    }
    return sum;
}

qtri_wide qtri_wide_make(int64_t m, int32_t e)
{
    qtri_wide result;
    qtri_wide_set(&result, m, e);
    return result;
}
