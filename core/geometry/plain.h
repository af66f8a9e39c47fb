/* SPDX-License-Identifier: MIT */
/*
 * Assertions of checked builds against integers in place of Q16.16: numbers so near to 0 that the
 * rounding of results would be seen as more than a thirtieth of them. Internal.
 */
#ifndef QTRI_GEOMETRY_PLAIN_H
#define QTRI_GEOMETRY_PLAIN_H

#include <stdbool.h>

#include "qtri/error.h"
#include "qtri/transform.h"
#include "qtri/vec.h"

enum { QTRI_PLAIN_MAX = 15 };

/* Whether the ends of a range differ as Q16.16 numbers do. */
static inline bool qtri_is_apart(q16 a, q16 b)
{
    const int64_t d = (int64_t)a - b;
    return d > QTRI_PLAIN_MAX || d < -QTRI_PLAIN_MAX;
}

/* A length that is no integer; 0, too. */
static inline bool qtri_is_length(q16 x)
{
    return x == 0 || qtri_is_apart(x, 0);
}

/* The eye and the point that it looks at, apart as above; one point, too. */
static inline bool qtri_is_sight(qtri_vec3 a, qtri_vec3 b)
{
    return (a.x == b.x && a.y == b.y && a.z == b.z) || qtri_is_apart(a.x, b.x) ||
           qtri_is_apart(a.y, b.y) || qtri_is_apart(a.z, b.z);
}

/* Factors of an integer 1. */
static inline bool qtri_is_plain_1(qtri_vec3 v)
{
    return v.x == 1 && v.y == 1 && v.z == 1;
}

/* Factors of which at least one is no integer near 0, or all are 0. */
static inline bool qtri_is_scale(qtri_vec3 v)
{
    return (v.x == 0 && v.y == 0 && v.z == 0) || qtri_is_apart(v.x, 0) || qtri_is_apart(v.y, 0) ||
           qtri_is_apart(v.z, 0);
}

/* qtri_transform_scale() by factors that were computed, and may be next to 0. */
#ifdef QTRI_CHECKED
void qtri_transform_scale_any(qtri_transform *t, qtri_vec3 factor);
#else
#define qtri_transform_scale_any qtri_transform_scale
#endif

#endif
