/* SPDX-License-Identifier: MIT */
/*
 * Sums of products, rounded once. References are exact: sums in 128 bits, below 2^66, and a result
 * that fits is exact in long double with its sixteen bits of fraction.
 */
#include "tuple.h"

#include "qtri/mat.h"

/* --- the functions */

CALL(vec2_dot, q16, qtri_vec2_dot(VEC2(a), VEC2(a + 2)))
CALL(vec3_dot, q16, qtri_vec3_dot(VEC3(a), VEC3(a + 3)))
CALL(vec4_dot, q16, qtri_vec4_dot(VEC4(a), VEC4(a + 4)))
CALL(vec3_cross, qtri_vec3, qtri_vec3_cross(VEC3(a), VEC3(a + 3)))
CALL(quat_mul, qtri_quat, qtri_quat_mul(QUAT(a), QUAT(a + 4)))
CALL(mat4_vec4, qtri_vec4, qtri_mat4_vec4((const qtri_mat4 *)(const void *)a, VEC4(a + 16)))

/* --- the references */

static int128 product(q16 a, q16 b)
{
    return (int128)a * b;
}

static int128 dot(const q16 *a, const q16 *b, int count)
{
    int128 sum = 0;
    for (int i = 0; i < count; i++) {
        sum += product(a[i], b[i]);
    }
    return sum;
}

static long double in_ulp(int128 sum)
{
    return (long double)sum / 65536;
}

static bool dot_reference(const verify_tuple *t, const q16 *a, long double *value)
{
    *value = in_ulp(dot(a, a + t->arguments / 2, t->arguments / 2));
    return true;
}

static bool cross_reference(const verify_tuple *self, const q16 *a, long double *value)
{
    (void)self;
    const q16 *b = a + 3;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        value[i] = in_ulp(product(a[j], b[k]) - product(a[k], b[j]));
    }
    return true;
}

/* (s, v)(t, w) = (s t - v.w, s w + t v + v x w) */
static bool quat_reference(const verify_tuple *self, const q16 *a, long double *value)
{
    (void)self;
    const q16 *b = a + 4;
    value[0] = in_ulp(2 * product(a[0], b[0]) - dot(a, b, 4));
    for (int i = 1; i < 4; i++) {
        int j = i % 3 + 1;
        int k = j % 3 + 1;
        value[i] = in_ulp(product(a[0], b[i]) + product(b[0], a[i]) + product(a[j], b[k]) -
                          product(a[k], b[j]));
    }
    return true;
}

static bool matrix_reference(const verify_tuple *self, const q16 *a, long double *value)
{
    (void)self;
    for (int row = 0; row < 4; row++) {
        value[row] = in_ulp(dot(a + 4 * row, a + 16, 4));
    }
    return true;
}

const verify_tuple verify_products[] = {
    {"vec2_dot", 4, 1, vec2_dot, dot_reference, NULL, 0.5, true, false},
    {"vec3_dot", 6, 1, vec3_dot, dot_reference, NULL, 0.5, true, false},
    {"vec4_dot", 8, 1, vec4_dot, dot_reference, NULL, 0.5, true, false},
    {"vec3_cross", 6, 3, vec3_cross, cross_reference, NULL, 0.5, true, false},
    {"quat_mul", 8, 4, quat_mul, quat_reference, NULL, 0.5, true, false},
    {"mat4_vec4", 20, 4, mat4_vec4, matrix_reference, NULL, 0.5, true, false},
};

const size_t verify_product_count = sizeof verify_products / sizeof verify_products[0];
