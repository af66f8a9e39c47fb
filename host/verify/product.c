/* SPDX-License-Identifier: MIT */
/*
 * Sums of products, rounded once. References are exact: sums in 128 bits, below 2^66, and a result
 * that fits is exact in long double with its sixteen bits of fraction.
 */
#include "tuple.h"

#include "qtri/mat.h"
#include "qtri/quat.h"
#include "qtri/vec.h"

/* --- the functions */

static qtri_vec3 vec3_of(const q16 *a)
{
    qtri_vec3 v = {a[0], a[1], a[2]};
    return v;
}

static qtri_vec4 vec4_of(const q16 *a)
{
    qtri_vec4 v = {a[0], a[1], a[2], a[3]};
    return v;
}

static void vec2_dot(const q16 *a, q16 *r)
{
    qtri_vec2 v = {a[0], a[1]};
    qtri_vec2 w = {a[2], a[3]};
    *r = qtri_vec2_dot(v, w);
}

static void vec3_dot(const q16 *a, q16 *r)
{
    *r = qtri_vec3_dot(vec3_of(a), vec3_of(a + 3));
}

static void vec4_dot(const q16 *a, q16 *r)
{
    *r = qtri_vec4_dot(vec4_of(a), vec4_of(a + 4));
}

static void vec3_cross(const q16 *a, q16 *r)
{
    qtri_vec3 v = qtri_vec3_cross(vec3_of(a), vec3_of(a + 3));
    r[0] = v.x;
    r[1] = v.y;
    r[2] = v.z;
}

static void quat_mul(const q16 *a, q16 *r)
{
    qtri_quat p = {a[0], a[1], a[2], a[3]};
    qtri_quat q = {a[4], a[5], a[6], a[7]};
    qtri_quat product = qtri_quat_mul(p, q);
    r[0] = product.w;
    r[1] = product.x;
    r[2] = product.y;
    r[3] = product.z;
}

static void mat4_vec4(const q16 *a, q16 *r)
{
    qtri_mat4 m;
    for (int i = 0; i < 16; i++) {
        m.m[i / 4][i % 4] = a[i];
    }
    qtri_vec4 v = qtri_mat4_vec4(&m, vec4_of(a + 16));
    r[0] = v.x;
    r[1] = v.y;
    r[2] = v.z;
    r[3] = v.w;
}

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
