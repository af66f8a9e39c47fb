/*
 * Lengths, unit vectors and quaternions: of stressed components and random ones, the smallest and
 * the largest among them. References are long double from exact sums of squares: off by less than
 * 2^-40 ULP.
 */
#include "reference.h"

#include "qtri/quat.h"
#include "qtri/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COMPONENT, LENGTH }; /* the rows of a test */

typedef struct tuple {
    const char *name;
    int arguments, results;
    void (*call)(const q16 *argument, q16 *result);
    /* In ULP; false where the result is a matter of convention. */
    bool (*reference)(const struct tuple *self, const q16 *argument, long double *value);
    void (*prepare)(q16 *argument); /* or NULL: makes random arguments valid ones */
    double limit;
    bool all_correct, unit; /* unit: the result's length is to be 1, within 2 ULP */
} tuple;

/* --- the functions */

static void vec2_length(const q16 *a, q16 *r)
{
    qtri_vec2 v = {a[0], a[1]};
    *r = qtri_vec2_length(v);
}

static void vec3_length(const q16 *a, q16 *r)
{
    qtri_vec3 v = {a[0], a[1], a[2]};
    *r = qtri_vec3_length(v);
}

static void vec4_length(const q16 *a, q16 *r)
{
    qtri_vec4 v = {a[0], a[1], a[2], a[3]};
    *r = qtri_vec4_length(v);
}

static void vec2_normalize(const q16 *a, q16 *r)
{
    qtri_vec2 v = {a[0], a[1]};
    v = qtri_vec2_normalize(v);
    r[0] = v.x;
    r[1] = v.y;
}

static void vec3_normalize(const q16 *a, q16 *r)
{
    qtri_vec3 v = {a[0], a[1], a[2]};
    v = qtri_vec3_normalize(v);
    r[0] = v.x;
    r[1] = v.y;
    r[2] = v.z;
}

static void vec4_normalize(const q16 *a, q16 *r)
{
    qtri_vec4 v = {a[0], a[1], a[2], a[3]};
    v = qtri_vec4_normalize(v);
    r[0] = v.x;
    r[1] = v.y;
    r[2] = v.z;
    r[3] = v.w;
}

static qtri_quat quat_of(const q16 *a)
{
    qtri_quat q = {a[0], a[1], a[2], a[3]};
    return q;
}

static void quat_to(qtri_quat q, q16 *r)
{
    r[0] = q.w;
    r[1] = q.x;
    r[2] = q.y;
    r[3] = q.z;
}

static void quat_normalize(const q16 *a, q16 *r)
{
    quat_to(qtri_quat_normalize(quat_of(a)), r);
}

static void quat_slerp(const q16 *a, q16 *r)
{
    quat_to(qtri_quat_slerp(quat_of(a), quat_of(a + 4), a[8]), r);
}

static void quat_nlerp(const q16 *a, q16 *r)
{
    quat_to(qtri_quat_nlerp(quat_of(a), quat_of(a + 4), a[8]), r);
}

/* --- the references */

static long double length_of(const q16 *a, int count)
{
    int128 sum = 0; /* <= 4 2^62 */
    for (int i = 0; i < count; i++) {
        sum += (int64_t)a[i] * a[i];
    }
    return sqrtl((long double)sum);
}

static bool length_reference(const tuple *t, const q16 *a, long double *value)
{
    *value = length_of(a, t->arguments);
    return true;
}

static bool unit_reference(const tuple *t, const q16 *a, long double *value)
{
    long double length = length_of(a, t->arguments);
    for (int i = 0; i < t->arguments; i++) {
        value[i] = length > 0 ? 65536 * ((long double)a[i] / length) : 0;
    }
    return length > 0;
}

/* As documented: without a direction, the identity. */
static bool quat_reference(const tuple *t, const q16 *a, long double *value)
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

static bool slerp_reference(const tuple *self, const q16 *a, long double *value)
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

static bool nlerp_reference(const tuple *self, const q16 *a, long double *value)
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

static const tuple tuples[] = {
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

/* --- chunks: tuples of the stress set, then random ones */

enum { CHUNK_TUPLES = 1 << 14 };

/* How many values of the stress set take part. */
static uint64_t stress_values(const tuple *t, const verify_options *options)
{
    bool quick = options->mode == VERIFY_QUICK;
    switch (t->arguments) {
    case 2:
        return quick ? 256 : 2048;
    case 3:
        return quick ? 48 : 192;
    case 4:
        return quick ? 20 : 64;
    default:
        return 1; /* none: see stress_chunks */
    }
}

static uint64_t stress_chunks(const tuple *t, const verify_options *options)
{
    uint64_t values = stress_values(t, options);
    uint64_t count = t->arguments > 4 ? 0 : 1;
    for (int i = 0; i < t->arguments; i++) {
        count *= values;
    }
    return (count + CHUNK_TUPLES - 1) / CHUNK_TUPLES;
}

static uint64_t tuple_chunks(const verify_test *test, const verify_options *options)
{
    static const uint64_t random_chunks[] = {12, 1200, 12000};
    const tuple *t = (const tuple *)test->subject;
    return stress_chunks(t, options) + random_chunks[options->mode];
}

/* The stress set holds small and large, so every step-th value is a fair choice of it. */
static void stressed(uint64_t values, uint64_t index, int count, q16 *a)
{
    const q16 *stress = verify_stress();
    uint64_t step = VERIFY_STRESS / (values + 1);
    for (int i = 0; i < count; i++) {
        a[i] = stress[index % values * step];
        index /= values;
    }
}

/* All of a magnitude, or each of its own. */
static void random_tuple(uint64_t *seed, int count, q16 *a)
{
    uint64_t bits = verify_random(seed);
    for (int i = 0; i < count; i++) {
        a[i] = verify_random_q16(seed);
        if ((bits & 1) != 0) {
            uint32_t low = (uint32_t)verify_random(seed);
            memcpy(&a[i], &low, sizeof low);
            a[i] >>= bits >> 1 & 31;
        }
    }
}

static void judge(const tuple *t, const q16 *a, verify_row *rows)
{
    q16 result[VERIFY_ARGUMENTS];
    long double value[VERIFY_ARGUMENTS];
    t->call(a, result);
    bool defined = t->reference(t, a, value);
    double worst = 0;
    double square = 0;
    for (int i = 0; i < t->results; i++) {
        double exact = verify_clamp((double)value[i]);
        worst = fmax(worst, fabs((double)result[i] - exact));
        square += (double)result[i] * (double)result[i];
    }
    verify_row_add(&rows[COMPONENT], a, t->arguments, worst, worst <= 0.5);
    if (t->unit && defined) {
        double off = fabs(sqrt(square) - 65536);
        verify_row_add(&rows[LENGTH], a, t->arguments, off, off <= 0.5);
    }
}

static void tuple_run(const verify_test *test, const verify_options *options, uint64_t chunk,
                      verify_row *rows)
{
    const tuple *t = (const tuple *)test->subject;
    bool stress = chunk < stress_chunks(t, options);
    uint64_t seed = chunk << 32;
    for (uint64_t i = 0; i < CHUNK_TUPLES; i++) {
        q16 a[VERIFY_ARGUMENTS];
        if (stress) {
            stressed(stress_values(t, options), chunk * CHUNK_TUPLES + i, t->arguments, a);
        } else {
            random_tuple(&seed, t->arguments, a);
        }
        if (t->prepare != NULL) {
            t->prepare(a);
        }
        judge(t, a, rows);
    }
}

static bool tuple_label(const verify_test *test, int index, verify_label *label)
{
    const tuple *t = (const tuple *)test->subject;
    verify_label component = {t->name, "", "components", t->arguments, t->limit, t->all_correct};
    verify_label length = {t->name, "_unit", "length of the result is 1", t->arguments, 2, false};
    *label = index == COMPONENT ? component : length;
    return index == COMPONENT || index == LENGTH;
}

size_t verify_tuple_tests(verify_test *tests, size_t room)
{
    size_t count = sizeof tuples / sizeof tuples[0];
    count = count < room ? count : room;
    for (size_t i = 0; i < count; i++) {
        verify_test test = {tuples[i].name, tuple_run, tuple_chunks, tuple_label, &tuples[i]};
        tests[i] = test;
    }
    return count;
}
