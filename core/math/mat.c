/* SPDX-License-Identifier: MIT */
/*
 * Matrices of 3 x 3 and of 4 x 4 numbers; identities and inverses of both.
 */
#include "qtri/error.h"
#include "qtri/mat.h"
#include "qtri/q16.h"

#include "dot.h"
#include "../bits/bits.h"
#include "rotation.h"

qtri_mat3 qtri_mat3_translate(qtri_vec2 offset)
{
    qtri_mat3 m = {{{Q16_ONE, 0, offset.x}, {0, Q16_ONE, offset.y}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_scale(qtri_vec2 factor)
{
    qtri_mat3 m = {{{factor.x, 0, 0}, {0, factor.y, 0}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_shear(q16 x_by_y, q16 y_by_x)
{
    qtri_mat3 m = {{{Q16_ONE, x_by_y, 0}, {y_by_x, Q16_ONE, 0}, {0, 0, Q16_ONE}}};
    return m;
}

/* p - R p with the rounded R: with the exact one, R p + offset would miss a far p. */
qtri_mat3 qtri_mat3_rotate_about_deg(q16 degrees, qtri_vec2 point)
{
    q16 s;
    q16 c;
    q16_sincos_deg(degrees, &s, &c);
    const q16 p[2] = {point.x, point.y};
    const q16 x[2] = {Q16_ONE - c, s};
    const q16 y[2] = {-s, Q16_ONE - c};
    qtri_mat3 m = {{{c, -s, qtri_dot(x, p, 2)}, {s, c, qtri_dot(y, p, 2)}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat3_rotate_deg(q16 degrees)
{
    qtri_vec2 origin = {0, 0};
    return qtri_mat3_rotate_about_deg(degrees, origin);
}

qtri_mat3 qtri_mat3_reflect_deg(q16 degrees)
{
    q16 s;
    q16 c;
    q16_sincos_deg(degrees % Q16(180) * 2, &s, &c);
    qtri_mat3 m = {{{c, s, 0}, {s, -c, 0}, {0, 0, Q16_ONE}}};
    return m;
}

qtri_vec3 qtri_mat3_vec3(const qtri_mat3 *m, qtri_vec3 v)
{
    QTRI_ASSERT(m != NULL);
    const q16 column[3] = {v.x, v.y, v.z};
    q16 image[3];
    qtri_dot_rows(image, m->m[0], column, 3);
    qtri_vec3 product = {image[0], image[1], image[2]};
    return product;
}

static qtri_vec2 transform3(const qtri_mat3 *m, qtri_vec2 v, q16 w)
{
    const q16 homogeneous[3] = {v.x, v.y, w};
    qtri_vec2 image = {qtri_dot(m->m[0], homogeneous, 3), qtri_dot(m->m[1], homogeneous, 3)};
    return image;
}

qtri_vec2 qtri_mat3_point(const qtri_mat3 *m, qtri_vec2 p)
{
    QTRI_ASSERT(m != NULL);
    return transform3(m, p, Q16_ONE);
}

qtri_vec2 qtri_mat3_vector(const qtri_mat3 *m, qtri_vec2 v)
{
    QTRI_ASSERT(m != NULL);
    return transform3(m, v, 0);
}

qtri_mat3 qtri_mat3_mul(const qtri_mat3 *a, const qtri_mat3 *b)
{
    QTRI_ASSERT(a != NULL && b != NULL);
    qtri_mat3 product;
    for (int j = 0; j < 3; j++) {
        const q16 column[3] = {b->m[0][j], b->m[1][j], b->m[2][j]};
        for (int i = 0; i < 3; i++) {
            product.m[i][j] = qtri_dot(a->m[i], column, 3);
        }
    }
    return product;
}

qtri_mat3 qtri_mat3_transpose(const qtri_mat3 *a)
{
    QTRI_ASSERT(a != NULL);
    qtri_mat3 result;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            result.m[i][j] = a->m[j][i];
        }
    }
    return result;
}

/*
 * Apart from the matrices that begin as an identity: they call it, and are no copies of it.
 */

qtri_mat3 qtri_mat3_identity(void)
{
    qtri_mat3 m = {{{Q16_ONE, 0, 0}, {0, Q16_ONE, 0}, {0, 0, Q16_ONE}}};
    return m;
}

QTRI_NOINLINE qtri_mat4 qtri_mat4_identity(void)
{
    qtri_mat4 m = {
        {{Q16_ONE, 0, 0, 0}, {0, Q16_ONE, 0, 0}, {0, 0, Q16_ONE, 0}, {0, 0, 0, Q16_ONE}}};
    return m;
}

/*
 * Determinants and inverses: exact cofactors, one rounding.
 *
 * With M the integers of a Q16.16 matrix, of n rows, the inverse counts 2^32 adj(M) / det(M) ULPs
 * for any n. |cofactor| < 2^98 and |det| <= 2^128 (Hadamard: a row is at most 2^32 long).
 */

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

qtri_mat4 qtri_mat4_translate(qtri_vec3 offset)
{
    qtri_mat4 m = qtri_mat4_identity();
    m.m[0][3] = offset.x;
    m.m[1][3] = offset.y;
    m.m[2][3] = offset.z;
    return m;
}

qtri_mat4 qtri_mat4_scale(qtri_vec3 factor)
{
    qtri_mat4 m = qtri_mat4_identity();
    m.m[0][0] = factor.x;
    m.m[1][1] = factor.y;
    m.m[2][2] = factor.z;
    return m;
}

qtri_mat4 qtri_mat4_shear(q16 x_by_y, q16 x_by_z, q16 y_by_x, q16 y_by_z, q16 z_by_x, q16 z_by_y)
{
    qtri_mat4 m = {{{Q16_ONE, x_by_y, x_by_z, 0},
                    {y_by_x, Q16_ONE, y_by_z, 0},
                    {z_by_x, z_by_y, Q16_ONE, 0},
                    {0, 0, 0, Q16_ONE}}};
    return m;
}

qtri_mat3 qtri_mat4_linear(const qtri_mat4 *m)
{
    QTRI_ASSERT(m != NULL);
    qtri_mat3 linear;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            linear.m[i][j] = m->m[i][j];
        }
    }
    return linear;
}

qtri_mat4 qtri_mat4_from_linear(const qtri_mat3 *linear)
{
    QTRI_ASSERT(linear != NULL);
    qtri_mat4 m = qtri_mat4_identity();
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            m.m[i][j] = linear->m[i][j];
        }
    }
    return m;
}

static inline q16 row_product(const q16 row[4], const qtri_right v[4], uint32_t *flags)
{
    qtri_sum sum = qtri_sum_start();
    qtri_sum_product(&sum, row[0], v[0], flags);
    qtri_sum_product(&sum, row[1], v[1], flags);
    qtri_sum_product(&sum, row[2], v[2], flags);
    qtri_sum_product(&sum, row[3], v[3], flags);
    return qtri_sum_q16(&sum, flags);
}

#if QTRI_LONG_MULTIPLY
/* v is `column`. One row's sum that does not fit is no concern of the others. */
static inline q16 row_or_dot(const q16 row[4], const qtri_right v[4], const q16 column[4])
{
    uint32_t flags = 0;
    q16 result = row_product(row, v, &flags);
    return qtri_sum_good(flags) ? result : qtri_dot(row, column, 4);
}
#endif

void qtri_mat4_times(q16 out[4], const qtri_mat4 *m, const q16 v[4])
{
    QTRI_ASSERT(out != NULL && m != NULL && v != NULL);
    QTRI_ASSERT(out != v);
    uint32_t flags = 0;
    const qtri_right right[4] = {qtri_right_of(v[0], &flags), qtri_right_beside(v[1], &flags),
                                 qtri_right_beside(v[2], &flags), qtri_right_beside(v[3], &flags)};
#if QTRI_LONG_MULTIPLY
    if (qtri_sum_good(flags)) {
        out[0] = row_or_dot(m->m[0], right, v);
        out[1] = row_or_dot(m->m[1], right, v);
        out[2] = row_or_dot(m->m[2], right, v);
        out[3] = row_or_dot(m->m[3], right, v);
        return;
    }
#else
    for (int i = 0; i < 4; i++) {
        out[i] = row_product(m->m[i], right, &flags);
    }
    if (qtri_sum_good(flags)) {
        return;
    }
#endif
    qtri_dot_rows(out, m->m[0], v, 4);
}

static qtri_vec3 transform(const qtri_mat4 *m, qtri_vec3 v, q16 w)
{
    qtri_vec4 homogeneous = {v.x, v.y, v.z, w};
    homogeneous = qtri_mat4_vec4(m, homogeneous);
    qtri_vec3 image = {homogeneous.x, homogeneous.y, homogeneous.z};
    return image;
}

qtri_vec3 qtri_mat4_point(const qtri_mat4 *m, qtri_vec3 p)
{
    QTRI_ASSERT(m != NULL);
    return transform(m, p, Q16_ONE);
}

qtri_vec3 qtri_mat4_vector(const qtri_mat4 *m, qtri_vec3 v)
{
    QTRI_ASSERT(m != NULL);
    return transform(m, v, 0);
}

qtri_mat4 qtri_mat4_mul(const qtri_mat4 *a, const qtri_mat4 *b)
{
    QTRI_ASSERT(a != NULL && b != NULL);
    qtri_mat4 product;
    for (int j = 0; j < 4; j++) {
        qtri_vec4 column = {b->m[0][j], b->m[1][j], b->m[2][j], b->m[3][j]};
        column = qtri_mat4_vec4(a, column);
        product.m[0][j] = column.x;
        product.m[1][j] = column.y;
        product.m[2][j] = column.z;
        product.m[3][j] = column.w;
    }
    return product;
}

qtri_mat4 qtri_mat4_transpose(const qtri_mat4 *a)
{
    QTRI_ASSERT(a != NULL);
    qtri_mat4 result;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            result.m[i][j] = a->m[j][i];
        }
    }
    return result;
}

/* I - 2 n n^T / n.n, and - 2 w n / n.n for the offset. */
qtri_mat4 qtri_mat4_reflect(qtri_vec4 plane)
{
    const q16 n[4] = {plane.x, plane.y, plane.z, plane.w};
    qtri_mat4 m = qtri_mat4_identity();
    qtri_wide scale;
    qtri_wide_dot(&scale, n, n, 3);
    if (scale.m == 0) {
        return m;
    }
    qtri_wide_invert(&scale, 2);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            qtri_wide part;
            qtri_wide_set(&part, qtri_mul_s32(n[i], n[j]), 32);
            m.m[i][j] = qtri_wide_less(m.m[i][j], &part, &scale);
        }
    }
    return m;
}

/* Turns axis i towards axis j. */
static qtri_mat4 rotation_plane(q16 degrees, int i, int j)
{
    qtri_mat4 m = qtri_mat4_identity();
    q16_sincos_deg(degrees, &m.m[j][i], &m.m[i][i]);
    m.m[i][j] = -m.m[j][i];
    m.m[j][j] = m.m[i][i];
    return m;
}

qtri_mat4 qtri_mat4_rotate_axis_deg(qtri_vec3 axis, q16 degrees)
{
    int32_t q_q30[4];
    qtri_rotation_axis(q_q30, axis, degrees);
    qtri_mat3 linear = qtri_rotation_mat3(q_q30);
    return qtri_mat4_from_linear(&linear);
}

/* p - R p with the rounded R: with the exact one, R p + offset would miss a far p. */
qtri_mat4 qtri_mat4_rotate_about_deg(qtri_vec3 axis, q16 degrees, qtri_vec3 point)
{
    qtri_mat4 m = qtri_mat4_rotate_axis_deg(axis, degrees);
    const q16 p[3] = {point.x, point.y, point.z};
    for (int i = 0; i < 3; i++) {
        q16 row[3] = {-m.m[i][0], -m.m[i][1], -m.m[i][2]};
        row[i] += Q16_ONE;
        m.m[i][3] = qtri_dot(row, p, 3);
    }
    return m;
}

qtri_mat4 qtri_mat4_rotate_euler_deg(qtri_vec3 degrees, qtri_euler order)
{
    int32_t q_q30[4];
    qtri_rotation_euler(q_q30, degrees, order);
    qtri_mat3 linear = qtri_rotation_mat3(q_q30);
    return qtri_mat4_from_linear(&linear);
}

qtri_mat4 qtri_mat4_rotate_x_deg(q16 degrees)
{
    return rotation_plane(degrees, 1, 2);
}

qtri_mat4 qtri_mat4_rotate_y_deg(q16 degrees)
{
    return rotation_plane(degrees, 2, 0);
}

qtri_mat4 qtri_mat4_rotate_z_deg(q16 degrees)
{
    return rotation_plane(degrees, 0, 1);
}
