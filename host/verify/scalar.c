/* SPDX-License-Identifier: MIT */
/*
 * The scalar functions of the table: all inputs of one argument, many of two and three.
 */
#include "table.h"

#include <math.h>
#include <stdlib.h>

enum { PLAIN, RELATIVE, OUTSIDE, MONOTONE }; /* the rows of a test */

static int arguments_of(const verify_function *function)
{
    return function->one != NULL ? 1 : (function->two != NULL ? 2 : 3);
}

/* --- one argument, block by block */

static verify_judge judge_of(const verify_function *f, const verify_options *options)
{
    verify_judge judge = {f->reference, arguments_of(f), options->exact_only, f->relative_from,
                          f->relative_unit};
    return judge;
}

/*
 * A whole block at once, if all of it is below relative_from and the rounding of every input clear;
 * false if not. `exact` is asked for the inputs only that may be the worst so far: those within
 * the bounds of the largest error of the block. (Where a function is nearly flat, every input is
 * worse than the one before.)
 */
static bool settled(const verify_judge *judge, q16 first, const q16 *result, const double *value,
                    const double *unsure, verify_row *row)
{
    double worst_low = 0; /* the largest error is between these two */
    double worst_high = 0;
    double largest = 0;
    int right = 0;
    int wrong = 0;
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        double error = fabs((double)result[i] - verify_clamp(value[i]));
        right += error < 0.5 - unsure[i];
        wrong += error > 0.5 + unsure[i];
        double low = error - unsure[i];
        double high = error + unsure[i];
        double size = fabs(value[i]) + unsure[i];
        worst_low = low > worst_low ? low : worst_low;
        worst_high = high > worst_high ? high : worst_high;
        largest = size > largest ? size : largest;
    }
    if (right + wrong != VERIFY_BLOCK ||
        (judge->relative_from > 0 && largest >= judge->relative_from)) {
        return false;
    }
    if (worst_high < row->max) {
        row->inputs += VERIFY_BLOCK;
        row->correct += (uint64_t)right;
        return true;
    }
    verify_judge exactly = *judge;
    exactly.exact_only = true;
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        double error = fabs((double)result[i] - verify_clamp(value[i]));
        double high = error + unsure[i];
        if (high >= worst_low && high >= row->max) {
            q16 x = first + i;
            verify_judge_result(&exactly, &x, result[i], row, row);
        } else {
            row->inputs++;
            row->correct += error < 0.5;
        }
    }
    return true;
}

/*
 * The same for a reference that is exact and fast: true if every result is the correctly rounded
 * one and none saturates.
 */
static bool settled_exactly(const verify_judge *judge, q16 first, const q16 *result,
                            verify_row *row)
{
    const verify_reference *reference = judge->reference;
    double worst = -1;
    q16 worst_at = first;
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        q16 x = first + i;
        verify_exact exact = reference->exact(reference->data, &x);
        double error = fabs(exact.delta);
        if (exact.nearest != result[i]) {
            return false;
        }
        worst_at = error > worst ? x : worst_at;
        worst = error > worst ? error : worst;
    }
    verify_row_add(row, &worst_at, 1, worst, true);
    row->inputs += VERIFY_BLOCK - 1;
    row->correct += VERIFY_BLOCK - 1;
    return true;
}

/* As verify_judge_result, with the value of a block instead of that of `fast`. */
typedef struct block_value {
    const verify_reference *reference;
    verify_value value;
} block_value;

static verify_value from_block(const void *data, const q16 *argument)
{
    (void)argument;
    return ((const block_value *)data)->value;
}

static verify_exact from_reference(const void *data, const q16 *argument)
{
    const verify_reference *reference = ((const block_value *)data)->reference;
    return reference->exact(reference->data, argument);
}

/* The inputs of a smooth block one by one: those that it decides, and those that `exact` must. */
static void block_singly(const verify_judge *judge, q16 first, const q16 *result,
                         const double *value, const double *unsure, verify_row *rows)
{
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        q16 x = first + i;
        block_value known = {judge->reference, {value[i], unsure[i]}};
        verify_reference reference = {from_reference, from_block, NULL, &known};
        verify_judge single = *judge;
        single.reference = &reference;
        verify_judge_result(&single, &x, result[i], &rows[PLAIN], &rows[RELATIVE]);
    }
}

/* A block on one side of the domain, where the result is one constant: true if it is that. */
static bool settled_outside(const verify_function *f, verify_row *row, q16 first, const q16 *result)
{
    const q16 last = first + (VERIFY_BLOCK - 1);
    if ((first <= f->high && last >= f->low) || row->max < 0) {
        return false;
    }
    int64_t documented = f->reference->exact(f->reference->data, &first).nearest;
    bool same = true;
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        same &= result[i] == documented;
    }
    if (same) {
        row->inputs += VERIFY_BLOCK;
        row->correct += VERIFY_BLOCK;
    }
    return same;
}

static void block_of_values(const verify_function *f, const verify_options *options, q16 first,
                            const q16 *result, verify_row *rows)
{
    const verify_judge judge = judge_of(f, options);
    const verify_reference *reference = f->reference;
    double value[VERIFY_BLOCK];
    double unsure[VERIFY_BLOCK];
    const q16 last = first + (VERIFY_BLOCK - 1);
    const bool within = first >= f->low && last <= f->high;
    if (within && reference->fast == NULL && settled_exactly(&judge, first, result, &rows[PLAIN])) {
        return;
    }
    if (within && !options->exact_only && reference->block != NULL &&
        reference->block(reference->data, first, value, unsure)) {
        if (!settled(&judge, first, result, value, unsure, &rows[PLAIN])) {
            block_singly(&judge, first, result, value, unsure, rows);
        }
        return;
    }
    if (settled_outside(f, &rows[OUTSIDE], first, result)) {
        return;
    }
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        q16 x = first + i;
        bool outside = x < f->low || x > f->high;
        verify_judge_result(&judge, &x, result[i], &rows[outside ? OUTSIDE : PLAIN],
                            &rows[outside ? OUTSIDE : RELATIVE]);
    }
}

/* Steps against the direction, in ULP; `before` is the result for first - 1. */
static void block_monotone(const verify_function *f, q16 first, q16 before, const q16 *result,
                           verify_row *row)
{
    int64_t direction = f->monotone;
    bool rises = direction * ((int64_t)result[0] - before) >= 0;
    for (int i = 1; i < VERIFY_BLOCK; i++) {
        rises &= direction * ((int64_t)result[i] - result[i - 1]) >= 0;
    }
    if (rises && row->max >= 0) {
        row->inputs += VERIFY_BLOCK;
        row->correct += VERIFY_BLOCK;
        return;
    }
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        q16 x = first + i;
        int64_t step = direction * ((int64_t)result[i] - (i == 0 ? before : result[i - 1]));
        verify_row_add(row, &x, 1, step < 0 ? (double)-step : 0, step >= 0);
    }
}

static void run_block(const verify_function *f, const verify_options *options, q16 first,
                      verify_row *rows)
{
    q16 result[VERIFY_BLOCK];
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        result[i] = f->one(first + i);
    }
    block_of_values(f, options, first, result, rows);
    if (f->monotone != 0) {
        q16 before = first == Q16_MIN ? result[0] : f->one(first - 1);
        block_monotone(f, first, before, result, &rows[MONOTONE]);
    }
}

enum { CHUNK_BLOCKS = 4096, CHUNK_STRATA = 64 };

static uint64_t blocks_chunks(const verify_options *options)
{
    return options->mode == VERIFY_QUICK ? VERIFY_STRATA / CHUNK_STRATA
                                         : ((uint64_t)1 << 32) / VERIFY_BLOCK / CHUNK_BLOCKS;
}

static void run_blocks(const verify_function *f, const verify_options *options, uint64_t chunk,
                       verify_row *rows)
{
    if (options->mode == VERIFY_QUICK) {
        for (int i = 0; i < CHUNK_STRATA; i++) {
            run_block(f, options, verify_stratum((int)chunk * CHUNK_STRATA + i), rows);
        }
        return;
    }
    int64_t first = Q16_MIN + (int64_t)chunk * CHUNK_BLOCKS * VERIFY_BLOCK;
    for (int i = 0; i < CHUNK_BLOCKS; i++) {
        run_block(f, options, (q16)(first + (int64_t)i * VERIFY_BLOCK), rows);
    }
}

/* --- two and three arguments: tuples of the stress set, then random ones */

enum { CHUNK_TUPLES = 1 << 16 };

/* Every `step`th value of the stress set takes part, so that triples and the quick mode end. */
static int stress_step(const verify_function *f, const verify_options *options)
{
    bool quick = options->mode == VERIFY_QUICK;
    return arguments_of(f) == 2 ? (quick ? 9 : 1) : (quick ? 64 : 16);
}

static uint64_t stress_values(const verify_function *f, const verify_options *options)
{
    return (uint64_t)((VERIFY_STRESS - 1) / stress_step(f, options) + 1);
}

static uint64_t stress_tuples(const verify_function *f, const verify_options *options)
{
    uint64_t values = stress_values(f, options);
    return arguments_of(f) == 2 ? values * values : values * values * values;
}

static uint64_t chunks_of(uint64_t tuples)
{
    return (tuples + CHUNK_TUPLES - 1) / CHUNK_TUPLES;
}

static uint64_t random_tuples(const verify_options *options)
{
    return options->mode == VERIFY_LONG ? 1000000000u
                                        : (options->mode == VERIFY_FULL ? 20000000u : 300000u);
}

static void run_tuple(const verify_function *f, const verify_judge *judge, const q16 *a,
                      verify_row *rows)
{
    q16 result = f->two != NULL ? f->two(a[0], a[1]) : f->three(a[0], a[1], a[2]);
    verify_judge_result(judge, a, result, &rows[PLAIN], &rows[RELATIVE]);
}

static void run_tuples(const verify_function *f, const verify_options *options, uint64_t chunk,
                       verify_row *rows)
{
    const verify_judge judge = judge_of(f, options);
    uint64_t stressed = chunks_of(stress_tuples(f, options));
    uint64_t seed = chunk << 32;
    q16 a[3] = {0, 0, 0};
    if (chunk >= stressed) {
        for (int i = 0; i < CHUNK_TUPLES; i++) {
            for (int k = 0; k < judge.arguments; k++) {
                a[k] = verify_random_q16(&seed);
            }
            run_tuple(f, &judge, a, rows);
        }
        return;
    }
    const q16 *stress = verify_stress();
    uint64_t values = stress_values(f, options);
    uint64_t step = (uint64_t)stress_step(f, options);
    uint64_t end = stress_tuples(f, options);
    end = end < (chunk + 1) * CHUNK_TUPLES ? end : (chunk + 1) * CHUNK_TUPLES;
    for (uint64_t i = chunk * CHUNK_TUPLES; i < end; i++) {
        uint64_t digits = i;
        for (int k = 0; k < judge.arguments; k++) {
            a[k] = stress[digits % values * step];
            digits /= values;
        }
        run_tuple(f, &judge, a, rows);
    }
}

/* --- as a test */

static void scalar_run(const verify_test *test, const verify_options *options, uint64_t chunk,
                       verify_row *rows)
{
    const verify_function *f = (const verify_function *)test->subject;
    (arguments_of(f) == 1 ? run_blocks : run_tuples)(f, options, chunk, rows);
}

static uint64_t scalar_chunks(const verify_test *test, const verify_options *options)
{
    const verify_function *f = (const verify_function *)test->subject;
    return arguments_of(f) == 1
               ? blocks_chunks(options)
               : chunks_of(stress_tuples(f, options)) + chunks_of(random_tuples(options));
}

verify_test verify_scalar_test(const verify_function *f)
{
    const int arguments = arguments_of(f);
    const bool all_correct = f->reference->fast == NULL;
    const verify_test test = {
        f->name,
        scalar_run,
        scalar_chunks,
        f,
        {[PLAIN] = {f->name, "", f->domain, arguments, f->limit, all_correct},
         [RELATIVE] = {f->name, "_relative", f->relative_domain, arguments, 1, all_correct},
         [OUTSIDE] = {f->name, "_outside", "elsewhere: as documented", arguments, 0, all_correct},
         [MONOTONE] = {f->name, "_monotone", f->monotone > 0 ? "never falls" : "never rises",
                       arguments, 0, all_correct}}};
    return test;
}
