/* SPDX-License-Identifier: MIT */
/*
 * Functions of vectors, matrices and quaternions: of stressed components and random ones, the
 * smallest and the largest among them.
 */
#include "tuple.h"

#include <math.h>
#include <string.h>

enum { COMPONENT, LENGTH }; /* the rows of a test */

/* --- chunks: tuples of the stress set, then random ones */

enum { CHUNK_TUPLES = 1 << 14 };

/* How many values of the stress set take part where all their tuples do. */
static uint64_t stress_values(const verify_tuple *t, const verify_options *options)
{
    bool quick = options->mode == VERIFY_QUICK;
    switch (t->arguments) {
    case 2:
        return quick ? 256 : VERIFY_STRESS;
    case 3:
        return quick ? 48 : 192;
    case 4:
        return quick ? 20 : 64;
    default:
        return 1; /* too many tuples: see stress_chunks */
    }
}

static uint64_t stress_chunks(const verify_tuple *t, const verify_options *options)
{
    if (t->arguments > 4) { /* a random choice, if any may be taken */
        return t->prepare != NULL ? 0 : (options->mode == VERIFY_QUICK ? 4 : 400);
    }
    uint64_t values = stress_values(t, options);
    uint64_t count = 1;
    for (int i = 0; i < t->arguments; i++) {
        count *= values;
    }
    return (count + CHUNK_TUPLES - 1) / CHUNK_TUPLES;
}

static uint64_t tuple_chunks(const verify_test *test, const verify_options *options)
{
    static const uint64_t random_chunks[] = {12, 1200, 12000};
    const verify_tuple *t = (const verify_tuple *)test->subject;
    return stress_chunks(t, options) + random_chunks[options->mode];
}

/* The stress set holds small and large, so every step-th value is a fair choice of it. */
static void stressed(uint64_t values, uint64_t index, int count, q16 *a)
{
    const q16 *stress = verify_stress();
    for (int i = 0; i < count; i++) {
        a[i] = stress[index % values * VERIFY_STRESS / values];
        index /= values;
    }
}

static void chosen(uint64_t index, int count, q16 *a)
{
    const q16 *stress = verify_stress();
    uint64_t seed = index << 32;
    for (int i = 0; i < count; i++) {
        a[i] = stress[verify_random(&seed) % VERIFY_STRESS];
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

static void judge(const verify_tuple *t, const q16 *a, verify_row *rows)
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
    const verify_tuple *t = (const verify_tuple *)test->subject;
    bool stress = chunk < stress_chunks(t, options);
    uint64_t seed = chunk << 32;
    for (uint64_t i = 0; i < CHUNK_TUPLES; i++) {
        q16 a[VERIFY_ARGUMENTS];
        if (stress && t->arguments > 4) {
            chosen(chunk * CHUNK_TUPLES + i, t->arguments, a);
        } else if (stress) {
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

verify_test verify_tuple_test(const verify_tuple *t)
{
    const verify_test test = {
        t->name,
        tuple_run,
        tuple_chunks,
        t,
        {[COMPONENT] = {t->name, "", "components", t->arguments, t->limit, t->all_correct},
         [LENGTH] = {t->name, "_unit", "length of the result is 1", t->arguments, 2, false}}};
    return test;
}
