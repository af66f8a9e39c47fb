/* SPDX-License-Identifier: MIT */
/*
 * Double matrices from the course's formulae, and how far a qtri_transform is from one.
 */
#ifndef QTRI_TESTS_SUPPORT_TRANSFORM_H
#define QTRI_TESTS_SUPPORT_TRANSFORM_H

#include "core.h"

typedef struct matrix {
    double m[4][4];
} matrix;

static const double radians = 3.14159265358979323846 / 180;

static inline matrix identity(void)
{
    matrix a = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    return a;
}

static inline matrix multiply(const matrix *a, const matrix *b)
{
    matrix p;
    for (int i = 0; i < 16; i++) {
        p.m[i / 4][i % 4] = 0;
        for (int k = 0; k < 4; k++) {
            p.m[i / 4][i % 4] += a->m[i / 4][k] * b->m[k][i % 4];
        }
    }
    return p;
}

static inline matrix absolute(const matrix *a)
{
    matrix p;
    for (int i = 0; i < 16; i++) {
        p.m[i / 4][i % 4] = fabs(a->m[i / 4][i % 4]);
    }
    return p;
}

static inline double element(const qtri_transform *t, int i, int j)
{
    const qtri_row *row = &t->row[i];
    return j < 3 ? ldexp((double)row->m[j], -row->exponent)
                 : ldexp((double)row->t, -row->exponent - 16);
}

/* The promises of transform.h about every row. */
static inline void check_form(const qtri_transform *t)
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 3; j++) {
            assert_true(abs(t->row[i].m[j]) <= 1 << 30);
        }
        assert_true(llabs(t->row[i].t) < (int64_t)1 << 61);
    }
}

/* Largest error in 2^-30 of the same row of `scale`. */
static inline double error_of(const qtri_transform *t, const matrix *exact, const matrix *scale)
{
    double worst = 0;
    check_form(t);
    for (int i = 0; i < 4; i++) {
        double largest = 0;
        for (int j = 0; j < 4; j++) {
            largest = fmax(largest, fabs(scale->m[i][j]));
        }
        for (int j = 0; j < 4; j++) {
            double error = fabs(element(t, i, j) - exact->m[i][j]);
            worst = fmax(worst, error == 0 ? 0 : ldexp(error / largest, 30));
        }
    }
    return worst;
}

static inline matrix translation(qtri_vec3 v)
{
    matrix a = identity();
    a.m[0][3] = real(v.x);
    a.m[1][3] = real(v.y);
    a.m[2][3] = real(v.z);
    return a;
}

static inline matrix scaling(qtri_vec3 v)
{
    matrix a = identity();
    a.m[0][0] = real(v.x);
    a.m[1][1] = real(v.y);
    a.m[2][2] = real(v.z);
    return a;
}

/* Rodrigues about an axis of any length; zero: identity. */
static inline matrix rotation(double degrees, const double axis[3])
{
    matrix a = identity();
    double length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    if (length == 0) {
        return a;
    }
    double x = axis[0] / length;
    double y = axis[1] / length;
    double z = axis[2] / length;
    double c = cos(degrees * radians);
    double s = sin(degrees * radians);
    matrix r = {{{c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s, 0},
                 {x * y * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s, 0},
                 {x * z * (1 - c) - y * s, y * z * (1 - c) + x * s, c + z * z * (1 - c), 0},
                 {0, 0, 0, 1}}};
    return r;
}

static inline matrix rotation_about(double degrees, const double axis[3], const double point[3])
{
    matrix r = rotation(degrees, axis);
    for (int i = 0; i < 3; i++) {
        r.m[i][3] = point[i];
        for (int k = 0; k < 3; k++) {
            r.m[i][3] -= r.m[i][k] * point[k];
        }
    }
    return r;
}

static inline qtri_vec3 random_vec3(uint64_t *seed, int bits)
{
    int32_t limit = (int32_t)1 << bits;
    qtri_vec3 v = {random_in(seed, -limit, limit), random_in(seed, -limit, limit),
                   random_in(seed, -limit, limit)};
    return v;
}

static inline void doubles(double out[3], qtri_vec3 v)
{
    out[0] = real(v.x);
    out[1] = real(v.y);
    out[2] = real(v.z);
}

static inline q16 random_angle(uint64_t *seed)
{
    return random_in(seed, -720 * 65536, 720 * 65536);
}

static inline void cross(double out[3], const double a[3], const double b[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
}

static inline double normalize(double v[3])
{
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3 && length > 0; i++) {
        v[i] /= length;
    }
    return length;
}

/* t applied to a Q16.16 point, without rounding. */
static inline void apply(long double out[4], const qtri_transform *t, qtri_vec3 p)
{
    for (int i = 0; i < 4; i++) {
        const qtri_row *row = &t->row[i];
        int128 sum =
            (int128)row->m[0] * p.x + (int128)row->m[1] * p.y + (int128)row->m[2] * p.z + row->t;
        out[i] = ldexpl((long double)sum, -row->exponent - 16);
    }
}

#endif
