/* SPDX-License-Identifier: MIT */
#include "math_sums.h"

static qtri_vec3 vec3(const q16 *x)
{
    qtri_vec3 v = {x[0], x[1], x[2]};
    return v;
}

static qtri_mat4 mat4(const q16 *x)
{
    qtri_mat4 m;
    for (uint8_t i = 0; i < 16; i++) {
        m.m[i / 4][i % 4] = x[i];
    }
    return m;
}

static uint32_t mix_transform(uint32_t sum, const qtri_transform *t)
{
    for (uint8_t i = 0; i < 4; i++) {
        const qtri_row *row = &t->row[i];
        sum = math_mix(sum, (int32_t)(row->t >> 32));
        sum = math_mix(sum, (int32_t)(row->t >> 16 & 0xFFFF));
        sum = math_mix(sum, (int32_t)(row->t & 0xFFFF));
        sum = math_mix(math_mix(math_mix(sum, row->m[0]), row->m[1]), row->m[2]);
        sum = math_mix(sum, row->exponent);
    }
    return sum;
}

#define CASE(name) static uint32_t name(uint32_t sum, const q16 *x)

CASE(transform_from_mat4)
{
    qtri_mat4 m = mat4(x);
    qtri_transform t;
    qtri_transform_from_mat4(&t, &m);
    return mix_transform(sum, &t);
}

CASE(transform_mul)
{
    qtri_mat4 m[2] = {mat4(x), mat4(x + 16)};
    qtri_transform a;
    qtri_transform b;
    qtri_transform_from_mat4(&a, &m[0]);
    qtri_transform_from_mat4(&b, &m[1]);
    qtri_transform_mul(&a, &a, &b);
    return mix_transform(sum, &a);
}

CASE(transform_rotate)
{
    qtri_transform t;
    qtri_transform_identity(&t);
    qtri_transform_rotate(&t, x[0], vec3(x + 1));
    return mix_transform(sum, &t);
}

CASE(transform_look_at)
{
    qtri_transform t;
    qtri_transform_identity(&t);
    qtri_transform_look_at(&t, vec3(x), vec3(x + 3), vec3(x + 6));
    return mix_transform(sum, &t);
}

CASE(transform_perspective)
{
    qtri_transform t;
    qtri_transform_identity(&t);
    qtri_transform_perspective(&t, x[0], x[1], x[2], x[3]);
    return mix_transform(sum, &t);
}

/* clang-format off */
const math_case math_transform_cases[] = {
    {"qtri_transform_from_mat4", transform_from_mat4, 16},
    {"qtri_transform_mul", transform_mul, 32},
    {"qtri_transform_rotate", transform_rotate, 4},
    {"qtri_transform_look_at", transform_look_at, 9},
    {"qtri_transform_perspective", transform_perspective, 4},
    {NULL, NULL, 0}};
/* clang-format on */
