/* SPDX-License-Identifier: MIT */
/*
 * Vectors of 2, 3 and 4 Q16.16 components.
 *
 * Every function is defined for every argument. Sums of products are exact until they are rounded
 * once, to nearest, halves up; results saturate. "1 ULP" is 2^-16. A program pays for what it
 * calls: what each number of components has is written once, for arrays (qtri_vec_*, count from 1
 * to 4), and given its types inline.
 */
#ifndef QTRI_VEC_H
#define QTRI_VEC_H

#include "q16.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A point or vector of the plane. */
typedef struct qtri_vec2 {
    q16 x, y;
} qtri_vec2;

/* A point or vector of space. */
typedef struct qtri_vec3 {
    q16 x, y, z;
} qtri_vec3;

/* A homogeneous point, or any four numbers. */
typedef struct qtri_vec4 {
    q16 x, y, z, w;
} qtri_vec4;

/* The same for arrays; out may be an argument. */

/* |a - b|, correctly rounded; b = NULL stands for the origin. From 32768 up: Q16_MAX. */
q16 qtri_vec_distance(const q16 *a, const q16 *b, int32_t count);
void qtri_vec_normalize(q16 *out, const q16 *a, int32_t count);

/* keep a - times (the part of a along b), for small integers: rounded once. */
void qtri_vec_along(q16 *out, const q16 *a, const q16 *b, int32_t count, int32_t keep,
                    int32_t times);
q16 qtri_vec_angle_deg(const q16 *a, const q16 *b, int32_t count);

/* Component by component: q16_add, q16_sub, q16_neg, q16_mul, q16_lerp (t is not clamped). */

static inline qtri_vec2 qtri_vec2_add(qtri_vec2 a, qtri_vec2 b)
{
    qtri_vec2 sum = {q16_add(a.x, b.x), q16_add(a.y, b.y)};
    return sum;
}

static inline qtri_vec3 qtri_vec3_add(qtri_vec3 a, qtri_vec3 b)
{
    qtri_vec3 sum = {q16_add(a.x, b.x), q16_add(a.y, b.y), q16_add(a.z, b.z)};
    return sum;
}

static inline qtri_vec4 qtri_vec4_add(qtri_vec4 a, qtri_vec4 b)
{
    qtri_vec4 sum = {q16_add(a.x, b.x), q16_add(a.y, b.y), q16_add(a.z, b.z), q16_add(a.w, b.w)};
    return sum;
}

static inline qtri_vec2 qtri_vec2_sub(qtri_vec2 a, qtri_vec2 b)
{
    qtri_vec2 difference = {q16_sub(a.x, b.x), q16_sub(a.y, b.y)};
    return difference;
}

static inline qtri_vec3 qtri_vec3_sub(qtri_vec3 a, qtri_vec3 b)
{
    qtri_vec3 difference = {q16_sub(a.x, b.x), q16_sub(a.y, b.y), q16_sub(a.z, b.z)};
    return difference;
}

static inline qtri_vec4 qtri_vec4_sub(qtri_vec4 a, qtri_vec4 b)
{
    qtri_vec4 difference = {q16_sub(a.x, b.x), q16_sub(a.y, b.y), q16_sub(a.z, b.z),
                            q16_sub(a.w, b.w)};
    return difference;
}

static inline qtri_vec2 qtri_vec2_neg(qtri_vec2 a)
{
    qtri_vec2 opposite = {q16_neg(a.x), q16_neg(a.y)};
    return opposite;
}

static inline qtri_vec3 qtri_vec3_neg(qtri_vec3 a)
{
    qtri_vec3 opposite = {q16_neg(a.x), q16_neg(a.y), q16_neg(a.z)};
    return opposite;
}

static inline qtri_vec4 qtri_vec4_neg(qtri_vec4 a)
{
    qtri_vec4 opposite = {q16_neg(a.x), q16_neg(a.y), q16_neg(a.z), q16_neg(a.w)};
    return opposite;
}

static inline qtri_vec2 qtri_vec2_scale(qtri_vec2 a, q16 s)
{
    qtri_vec2 product = {q16_mul(a.x, s), q16_mul(a.y, s)};
    return product;
}

static inline qtri_vec3 qtri_vec3_scale(qtri_vec3 a, q16 s)
{
    qtri_vec3 product = {q16_mul(a.x, s), q16_mul(a.y, s), q16_mul(a.z, s)};
    return product;
}

static inline qtri_vec4 qtri_vec4_scale(qtri_vec4 a, q16 s)
{
    qtri_vec4 product = {q16_mul(a.x, s), q16_mul(a.y, s), q16_mul(a.z, s), q16_mul(a.w, s)};
    return product;
}

static inline qtri_vec2 qtri_vec2_lerp(qtri_vec2 a, qtri_vec2 b, q16 t)
{
    qtri_vec2 between = {q16_lerp(a.x, b.x, t), q16_lerp(a.y, b.y, t)};
    return between;
}

static inline qtri_vec3 qtri_vec3_lerp(qtri_vec3 a, qtri_vec3 b, q16 t)
{
    qtri_vec3 between = {q16_lerp(a.x, b.x, t), q16_lerp(a.y, b.y, t), q16_lerp(a.z, b.z, t)};
    return between;
}

static inline qtri_vec4 qtri_vec4_lerp(qtri_vec4 a, qtri_vec4 b, q16 t)
{
    qtri_vec4 between = {q16_lerp(a.x, b.x, t), q16_lerp(a.y, b.y, t), q16_lerp(a.z, b.z, t),
                         q16_lerp(a.w, b.w, t)};
    return between;
}

/* a . b, correctly rounded. */
q16 qtri_vec2_dot(qtri_vec2 a, qtri_vec2 b);
q16 qtri_vec3_dot(qtri_vec3 a, qtri_vec3 b);
q16 qtri_vec4_dot(qtri_vec4 a, qtri_vec4 b);

/*
 * a x b, right-handed, correctly rounded. Of two components the z of it: positive where b is
 * counter-clockwise of a.
 */
q16 qtri_vec2_cross(qtri_vec2 a, qtri_vec2 b);
qtri_vec3 qtri_vec3_cross(qtri_vec3 a, qtri_vec3 b);

/* Euclidean length and distance, correctly rounded. The distance is not that of a rounded a - b. */
static inline q16 qtri_vec2_length(qtri_vec2 a)
{
    const q16 u[2] = {a.x, a.y};
    return qtri_vec_distance(u, 0, 2);
}

static inline q16 qtri_vec3_length(qtri_vec3 a)
{
    const q16 u[3] = {a.x, a.y, a.z};
    return qtri_vec_distance(u, 0, 3);
}

static inline q16 qtri_vec4_length(qtri_vec4 a)
{
    const q16 u[4] = {a.x, a.y, a.z, a.w};
    return qtri_vec_distance(u, 0, 4);
}

static inline q16 qtri_vec2_distance(qtri_vec2 a, qtri_vec2 b)
{
    const q16 u[2] = {a.x, a.y};
    const q16 v[2] = {b.x, b.y};
    return qtri_vec_distance(u, v, 2);
}

static inline q16 qtri_vec3_distance(qtri_vec3 a, qtri_vec3 b)
{
    const q16 u[3] = {a.x, a.y, a.z};
    const q16 v[3] = {b.x, b.y, b.z};
    return qtri_vec_distance(u, v, 3);
}

static inline q16 qtri_vec4_distance(qtri_vec4 a, qtri_vec4 b)
{
    const q16 u[4] = {a.x, a.y, a.z, a.w};
    const q16 v[4] = {b.x, b.y, b.z, b.w};
    return qtri_vec_distance(u, v, 4);
}

/*
 * a / |a|: each component within .501 ULP, the length within 1 ULP of 1, for the shortest and the
 * longest a. The zero vector gives the zero vector.
 */
static inline qtri_vec2 qtri_vec2_normalize(qtri_vec2 a)
{
    q16 out[2] = {a.x, a.y};
    qtri_vec_normalize(out, out, 2);
    qtri_vec2 result = {out[0], out[1]};
    return result;
}

static inline qtri_vec3 qtri_vec3_normalize(qtri_vec3 a)
{
    q16 out[3] = {a.x, a.y, a.z};
    qtri_vec_normalize(out, out, 3);
    qtri_vec3 result = {out[0], out[1], out[2]};
    return result;
}

static inline qtri_vec4 qtri_vec4_normalize(qtri_vec4 a)
{
    q16 out[4] = {a.x, a.y, a.z, a.w};
    qtri_vec_normalize(out, out, 4);
    qtri_vec4 result = {out[0], out[1], out[2], out[3]};
    return result;
}

/*
 * b (a . b) / (b . b): the part of a along b, of any length, within .501 ULP. b = 0 gives 0.
 */
static inline qtri_vec2 qtri_vec2_project(qtri_vec2 a, qtri_vec2 b)
{
    q16 out[2] = {a.x, a.y};
    const q16 v[2] = {b.x, b.y};
    qtri_vec_along(out, out, v, 2, 0, -1);
    qtri_vec2 result = {out[0], out[1]};
    return result;
}

static inline qtri_vec3 qtri_vec3_project(qtri_vec3 a, qtri_vec3 b)
{
    q16 out[3] = {a.x, a.y, a.z};
    const q16 v[3] = {b.x, b.y, b.z};
    qtri_vec_along(out, out, v, 3, 0, -1);
    qtri_vec3 result = {out[0], out[1], out[2]};
    return result;
}

static inline qtri_vec4 qtri_vec4_project(qtri_vec4 a, qtri_vec4 b)
{
    q16 out[4] = {a.x, a.y, a.z, a.w};
    const q16 v[4] = {b.x, b.y, b.z, b.w};
    qtri_vec_along(out, out, v, 4, 0, -1);
    qtri_vec4 result = {out[0], out[1], out[2], out[3]};
    return result;
}

/* What project leaves: the part of a perpendicular to b, within .501 ULP. b = 0 gives a. */
static inline qtri_vec2 qtri_vec2_reject(qtri_vec2 a, qtri_vec2 b)
{
    q16 out[2] = {a.x, a.y};
    const q16 v[2] = {b.x, b.y};
    qtri_vec_along(out, out, v, 2, 1, 1);
    qtri_vec2 result = {out[0], out[1]};
    return result;
}

static inline qtri_vec3 qtri_vec3_reject(qtri_vec3 a, qtri_vec3 b)
{
    q16 out[3] = {a.x, a.y, a.z};
    const q16 v[3] = {b.x, b.y, b.z};
    qtri_vec_along(out, out, v, 3, 1, 1);
    qtri_vec3 result = {out[0], out[1], out[2]};
    return result;
}

static inline qtri_vec4 qtri_vec4_reject(qtri_vec4 a, qtri_vec4 b)
{
    q16 out[4] = {a.x, a.y, a.z, a.w};
    const q16 v[4] = {b.x, b.y, b.z, b.w};
    qtri_vec_along(out, out, v, 4, 1, 1);
    qtri_vec4 result = {out[0], out[1], out[2], out[3]};
    return result;
}

/*
 * a - 2 project(a, normal): a mirrored in the plane (the line) with this normal, of any length,
 * within .501 ULP: GLSL's reflect() without its demand for a unit normal. normal = 0 gives a.
 */
static inline qtri_vec2 qtri_vec2_reflect(qtri_vec2 a, qtri_vec2 normal)
{
    q16 out[2] = {a.x, a.y};
    const q16 v[2] = {normal.x, normal.y};
    qtri_vec_along(out, out, v, 2, 1, 2);
    qtri_vec2 result = {out[0], out[1]};
    return result;
}

static inline qtri_vec3 qtri_vec3_reflect(qtri_vec3 a, qtri_vec3 normal)
{
    q16 out[3] = {a.x, a.y, a.z};
    const q16 v[3] = {normal.x, normal.y, normal.z};
    qtri_vec_along(out, out, v, 3, 1, 2);
    qtri_vec3 result = {out[0], out[1], out[2]};
    return result;
}

static inline qtri_vec4 qtri_vec4_reflect(qtri_vec4 a, qtri_vec4 normal)
{
    q16 out[4] = {a.x, a.y, a.z, a.w};
    const q16 v[4] = {normal.x, normal.y, normal.z, normal.w};
    qtri_vec_along(out, out, v, 4, 1, 2);
    qtri_vec4 result = {out[0], out[1], out[2], out[3]};
    return result;
}

/*
 * The angle between a and b, of any lengths, in degrees, 0..180: the error of q16_atan2_deg and .01
 * ULP more. 0 where a or b is zero. (For a signed angle in the plane:
 * q16_atan2_deg(qtri_vec2_cross(a, b), qtri_vec2_dot(a, b)).)
 */
static inline q16 qtri_vec2_angle_deg(qtri_vec2 a, qtri_vec2 b)
{
    const q16 u[2] = {a.x, a.y};
    const q16 v[2] = {b.x, b.y};
    return qtri_vec_angle_deg(u, v, 2);
}

static inline q16 qtri_vec3_angle_deg(qtri_vec3 a, qtri_vec3 b)
{
    const q16 u[3] = {a.x, a.y, a.z};
    const q16 v[3] = {b.x, b.y, b.z};
    return qtri_vec_angle_deg(u, v, 3);
}

static inline q16 qtri_vec4_angle_deg(qtri_vec4 a, qtri_vec4 b)
{
    const q16 u[4] = {a.x, a.y, a.z, a.w};
    const q16 v[4] = {b.x, b.y, b.z, b.w};
    return qtri_vec_angle_deg(u, v, 4);
}

#ifdef __cplusplus
}
#endif

#endif
