/* SPDX-License-Identifier: MIT */
/*
 * Lengths, unit vectors and quaternions. References are long double from exact sums of squares: off
 * by less than 2^-40 ULP.
 */
#include "tuple.h"

#include <math.h>

/* --- the functions */

CALL(vec2_length, q16, qtri_vec2_length(VEC2(a)))
CALL(vec3_length, q16, qtri_vec3_length(VEC3(a)))
CALL(vec4_length, q16, qtri_vec4_length(VEC4(a)))
CALL(vec2_normalize, qtri_vec2, qtri_vec2_normalize(VEC2(a)))
CALL(vec3_normalize, qtri_vec3, qtri_vec3_normalize(VEC3(a)))
CALL(vec4_normalize, qtri_vec4, qtri_vec4_normalize(VEC4(a)))
CALL(quat_normalize, qtri_quat, qtri_quat_normalize(QUAT(a)))
CALL(quat_slerp, qtri_quat, qtri_quat_slerp(QUAT(a), QUAT(a + 4), a[8]))
CALL(quat_nlerp, qtri_quat, qtri_quat_nlerp(QUAT(a), QUAT(a + 4), a[8]))

/* --- the references */

static long double length_of(const q16 *a, int count)
{
    int128 sum = 0; /* <= 4 2^62 */
    for (int i = 0; i < count; i++) {
        sum += (int64_t)a[i] * a[i];
    }
    return sqrtl((long double)sum);
}

static bool length_reference(const verify_tuple *t, const q16 *a, long double *value)
{
    *value = length_of(a, t->arguments);
    return true;
}

static bool unit_reference(const verify_tuple *t, const q16 *a, long double *value)
{
    long double length = length_of(a, t->arguments);
    for (int i = 0; i < t->arguments; i++) {
        value[i] = length > 0 ? 65536 * ((long double)a[i] / length) : 0;
    }
    return length > 0;
}

/* As documented: without a direction, the identity. */
static bool quat_reference(const verify_tuple *t, const q16 *a, long double *value)
{
    bool defined = unit_reference(t, a, value);
    value[0] = defined ? value[0] : 65536;
    return defined;
}

static long double norm(const long double *v)
{
    return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3]);
}

/* Of unit quaternions: below 2^33. */
static int64_t dot_of(const q16 *a, const q16 *b)
{
    int64_t dot = 0;
    for (int i = 0; i < 4; i++) {
        dot += (int64_t)a[i] * b[i];
    }
    return dot;
}

/* Two orientations as unit quaternions on the same side, and the angle between them. */
static long double two_orientations(const q16 *a, long double *p, long double *q)
{
    long double length_p = length_of(a, 4);
    long double length_q = length_of(a + 4, 4) * (dot_of(a, a + 4) < 0 ? -1 : 1);
    long double sum[4];
    long double difference[4];
    for (int i = 0; i < 4; i++) {
        p[i] = (long double)a[i] / length_p;
        q[i] = (long double)a[i + 4] / length_q;
        sum[i] = p[i] + q[i];
        difference[i] = p[i] - q[i];
    }
    return 2 * atan2l(norm(difference), norm(sum));
}

static bool slerp_reference(const verify_tuple *self, const q16 *a, long double *value)
{
    (void)self;
    long double p[4];
    long double q[4];
    long double angle = two_orientations(a, p, q);
    long double t = (long double)a[8] / 65536;
    long double of_p = angle > 0 ? sinl((1 - t) * angle) / sinl(angle) : 1 - t;
    long double of_q = angle > 0 ? sinl(t * angle) / sinl(angle) : t;
    for (int i = 0; i < 4; i++) {
        value[i] = 65536 * (of_p * p[i] + of_q * q[i]);
    }
    return true;
}

static bool nlerp_reference(const verify_tuple *self, const q16 *a, long double *value)
{
    (void)self;
    long double p[4];
    long double q[4];
    (void)two_orientations(a, p, q);
    long double t = (long double)a[8] / 65536;
    for (int i = 0; i < 4; i++) {
        value[i] = (1 - t) * p[i] + t * q[i];
    }
    long double length = norm(value);
    for (int i = 0; i < 4; i++) {
        value[i] *= 65536 / length;
    }
    return true;
}

/* Two unit quaternions, sometimes close together or opposite, and t in 0 .. 1. */
static void two_units(q16 *a)
{
    int near_by = a[8] & 3;
    for (int i = 0; i < 4 && near_by == 0; i++) {
        a[i] /= 4;
        a[i + 4] = (a[8] & 4 ? -a[i] : a[i]) + (a[i + 4] >> (8 + (a[8] >> 3 & 15)));
    }
    for (int k = 0; k < 8; k += 4) {
        if (length_of(a + k, 4) == 0) {
            a[k] = 1;
        }
        quat_normalize(a + k, a + k);
    }
    int64_t dot = dot_of(a, a + 4);
    if (dot > -64 && dot < 64) { /* at a right angle: both arcs are the shortest */
        for (int i = 0; i < 4; i++) {
            a[i + 4] = a[i];
        }
    }
    a[8] = (a[8] & 0xF0000) == 0 ? ((a[8] & 1) != 0 ? 65536 : 0) : a[8] & 65535;
}

const verify_tuple verify_lengths[] = {
    {"vec2_length", 2, 1, vec2_length, length_reference, NULL, 0.5, true, false},
    {"vec3_length", 3, 1, vec3_length, length_reference, NULL, 0.5, true, false},
    {"vec4_length", 4, 1, vec4_length, length_reference, NULL, 0.5, true, false},
    {"vec2_normalize", 2, 2, vec2_normalize, unit_reference, NULL, 1, false, true},
    {"vec3_normalize", 3, 3, vec3_normalize, unit_reference, NULL, 1, false, true},
    {"vec4_normalize", 4, 4, vec4_normalize, unit_reference, NULL, 1, false, true},
    {"quat_normalize", 4, 4, quat_normalize, quat_reference, NULL, 1, false, true},
    {"quat_slerp", 9, 4, quat_slerp, slerp_reference, two_units, 2, false, true},
    {"quat_nlerp", 9, 4, quat_nlerp, nlerp_reference, two_units, 2, false, true},
};

const size_t verify_length_count = sizeof verify_lengths / sizeof verify_lengths[0];
