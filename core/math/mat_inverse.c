/* SPDX-License-Identifier: MIT */
/*
 * Determinants and inverses: exact cofactors, one rounding.
 *
 * With M the integers of a Q16.16 matrix, of n rows, the inverse counts 2^32 adj(M) / det(M) ULPs
 * for any n. |cofactor| < 2^98 and |det| <= 2^128 (Hadamard: a row is at most 2^32 long).
 */
#include "qtri/mat.h"
#include "qtri/error.h"

#include "../bits/bits.h"
#include "wide_q16.h"

/* Two's complement, the lowest word first. */
enum { BIG_WORDS = 5 };
typedef struct big {
    uint32_t word[BIG_WORDS];
} big;

/* sum += x a, or sum -= x a with `minus`: ~(~sum + y) = sum - y. */
static void big_add_product(big *sum, const big *x, int32_t a, bool minus)
{
    const uint32_t flip = (a < 0) != minus ? UINT32_MAX : 0;
    const uint32_t size = qtri_magnitude32(a);
    uint32_t carry = 0;
    for (int i = 0; i < BIG_WORDS; i++) { /* (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1 */
        uint64_t t = qtri_mul_u32(x->word[i], size) + (sum->word[i] ^ flip) + carry;
        sum->word[i] = (uint32_t)(t & UINT32_MAX) ^ flip;
        carry = (uint32_t)(t >> 32);
    }
}

static void big_set(big *x, int64_t value)
{
    x->word[0] = (uint32_t)((uint64_t)value & UINT32_MAX);
    x->word[1] = (uint32_t)((uint64_t)value >> 32);
    for (int i = 2; i < BIG_WORDS; i++) {
        x->word[i] = value < 0 ? UINT32_MAX : 0;
    }
}

/* out = x 2^-e. What is cut off leaves its mark in the last bit, for roundings to see. */
static void big_wide(qtri_wide *out, const big *x, int32_t e)
{
    big size = {{0}};
    bool negative = (x->word[BIG_WORDS - 1] >> 31) != 0;
    big_add_product(&size, x, 1, negative);
    uint32_t *word = size.word;
    for (int zeros = 0; zeros < BIG_WORDS && word[4] == 0; zeros++) {
        word[4] = word[3];
        word[3] = word[2];
        word[2] = word[1];
        word[1] = word[0];
        word[0] = 0;
        e += 32;
    }
    int32_t shift = qtri_clz32(word[4]) & 31; /* if the word is 0, all are */
    uint64_t m = ((uint64_t)word[4] << 32 | word[3]) << shift | word[2] >> 1 >> (31 - shift);
    uint32_t lost = ((uint32_t)m & 3u) | word[2] << shift | word[1] | word[0];
    int64_t mantissa = (int64_t)(m >> 2 | (lost != 0));
    qtri_wide_set(out, negative ? -mantissa : mantissa, e + shift - 2 - 96);
}

/*
 * The signed minor without row i and column j. Rows and columns in cyclic order: an even
 * permutation of three leaves the determinant, and of two gives the sign.
 */
static void cofactor(big *out, const q16 *m, int n, int i, int j)
{
    const q16 *a = m + (i + 1) % n * n;
    const q16 *b = m + (i + 2) % n * n;
    if (n == 3) {
        int p = (j + 1) % 3;
        int q = (j + 2) % 3;
        big_set(out, qtri_mul_s32(a[p], b[q]) - qtri_mul_s32(a[q], b[p]));
        return;
    }
    const q16 *c = m + (i + 3) % 4 * 4;
    const int column[5] = {(j + 1) % 4, (j + 2) % 4, (j + 3) % 4, (j + 1) % 4, (j + 2) % 4};
    big_set(out, 0);
    for (int k = 0; k < 3; k++) {
        int q = column[k + 1];
        int r = column[k + 2];
        big minor; /* |minor| <= 2^63 - 2^31 */
        big_set(&minor, qtri_mul_s32(b[q], c[r]) - qtri_mul_s32(b[r], c[q]));
        big_add_product(out, &minor, a[column[k]], ((i + j) & 1) != 0);
    }
}

/* Scaled as the integers are: 2^-16n. */
static void determinant(qtri_wide *out, const q16 *m, int n)
{
    big sum;
    big_set(&sum, 0);
    for (int j = 0; j < n; j++) {
        big minor;
        cofactor(&minor, m, n, 0, j);
        big_add_product(&sum, &minor, m[j], false);
    }
    big_wide(out, &sum, 16 * n);
}

static bool invert(q16 *out, const q16 *m, int n)
{
    q16 inverse[16] = {0};
    qtri_wide scale;
    determinant(&scale, m, n);
    bool regular = scale.m != 0;
    qtri_wide_invert(&scale, -1);
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            big minor;
            qtri_wide element;
            cofactor(&minor, m, n, i, j);
            big_wide(&element, &minor, 16 * (n - 1));
            inverse[j * n + i] =
                regular ? qtri_wide_less(0, &element, &scale) : (i == j ? Q16_ONE : 0);
        }
    }
    for (int i = 0; i < n * n; i++) {
        out[i] = inverse[i];
    }
    return regular;
}

static q16 determinant_q16(const q16 *m, int n)
{
    qtri_wide value;
    determinant(&value, m, n);
    return qtri_wide_to_q16(value);
}

q16 qtri_mat3_determinant(const qtri_mat3 *m)
{
    QTRI_ASSERT(m != NULL);
    return determinant_q16(m->m[0], 3);
}

q16 qtri_mat4_determinant(const qtri_mat4 *m)
{
    QTRI_ASSERT(m != NULL);
    return determinant_q16(m->m[0], 4);
}

bool qtri_mat3_inverse(qtri_mat3 *out, const qtri_mat3 *m)
{
    QTRI_ASSERT(out != NULL && m != NULL);
    return invert(out->m[0], m->m[0], 3);
}

bool qtri_mat4_inverse(qtri_mat4 *out, const qtri_mat4 *m)
{
    QTRI_ASSERT(out != NULL && m != NULL);
    return invert(out->m[0], m->m[0], 4);
}

bool qtri_mat4_inverse_affine(qtri_mat4 *out, const qtri_mat4 *m)
{
    QTRI_ASSERT(out != NULL && m != NULL);
    qtri_mat4 affine = *m;
    affine.m[3][0] = affine.m[3][1] = affine.m[3][2] = 0;
    affine.m[3][3] = Q16_ONE;
    return invert(out->m[0], affine.m[0], 4);
}

bool qtri_mat4_normal_matrix(qtri_mat3 *out, const qtri_mat4 *m)
{
    QTRI_ASSERT(out != NULL && m != NULL);
    qtri_mat3 transposed = qtri_mat4_linear(m);
    transposed = qtri_mat3_transpose(&transposed);
    return qtri_mat3_inverse(out, &transposed);
}
