/* SPDX-License-Identifier: MIT */
/*
 * Proof of accuracy: the functions of core/math against correctly rounded references.
 *
 * The unit is the ULP of the result, 2^-16, everywhere: a reference value of 65536.25 is a result
 * of 65536 that is a quarter of an ULP too low. How a value is decided:
 *
 *   exact    The rounded result by integers (exact.c), for everything that is a root or a quotient,
 *            or by MPFR with 200 bits (real.c).
 *   fast     A value in double with a bound of its error. An input is passed on to `exact` when its
 *            rounding, or whether it is the worst so far, lies within that bound; so the counts
 *            and maxima reported are those that `exact` alone would give (option --exact-only).
 *   block    The fast values of 1024 consecutive inputs at once, by local interpolation (block.c).
 */
#ifndef QTRI_VERIFY_H
#define QTRI_VERIFY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "qtri/q16.h"

__extension__ typedef __int128 int128;

enum {
    VERIFY_BLOCK = 1024,   /* inputs in a row that are treated together */
    VERIFY_ARGUMENTS = 20, /* of one call, as scalars: a matrix and a vector */
    VERIFY_ROWS = 6        /* that one test may fill */
};

enum verify_mode {
    VERIFY_QUICK, /* strata, seconds */
    VERIFY_FULL,  /* every input of one argument, every pair of the stress set */
    VERIFY_LONG   /* and 10^9 random pairs */
};

/*
 * The exact value is nearest + delta, |delta| <= .5. On a tie, nearest is what the contract says;
 * it is the floor, and delta < 1, for q16_mul_floor.
 */
typedef struct verify_exact {
    int64_t nearest;
    double delta;
} verify_exact;

/* A value in ULP and how far from it the exact one may be. */
typedef struct verify_value {
    double value;
    double unsure;
} verify_value;

typedef struct verify_reference {
    verify_exact (*exact)(const void *data, const q16 *argument);
    verify_value (*fast)(const void *data, const q16 *argument); /* NULL: `exact` is fast */
    /* Or NULL. False: not smooth here, ask for one value at a time. */
    bool (*block)(const void *data, q16 first, double *value, double *unsure);
    const void *data;
} verify_reference;

/* What was found. */
typedef struct verify_row {
    uint64_t inputs;
    uint64_t correct; /* correctly rounded */
    double max;       /* error; -1 before the first input */
    q16 worst[VERIFY_ARGUMENTS];
} verify_row;

/* What a row of the table says besides. */
typedef struct verify_label {
    const char *function, *suffix; /* "tan", "_relative" */
    const char *domain;
    int arguments;
    double limit;
    bool all_correct; /* asked of every input */
} verify_label;

typedef struct verify_options {
    enum verify_mode mode;
    bool exact_only;
    int threads;
    const char *progress; /* NULL: none on stderr; else what comes before the name of the test */
} verify_options;

/*
 * A test is a number of chunks of work that may run in any order, on any thread, and fill rows; it
 * gives the same rows whatever the order.
 */
typedef struct verify_test {
    const char *name;
    void (*run)(const struct verify_test *test, const verify_options *options, uint64_t chunk,
                verify_row *rows);
    uint64_t (*chunks)(const struct verify_test *test, const verify_options *options);
    const void *subject;
    verify_label label[VERIFY_ROWS]; /* of each row; a test without one has no function there */
} verify_test;

/* --- rows (row.c) */

void verify_row_clear(verify_row *row);

/* One more input. The worst is the one with the largest error, then the smallest arguments. */
void verify_row_add(verify_row *row, const q16 *argument, int arguments, double error,
                    bool correct);

/* Counts of both, worst of both. */
void verify_row_merge(verify_row *into, const verify_row *from);

bool verify_row_passes(const verify_row *row, const verify_label *label);

/* --- references */

double verify_clamp(double value); /* to Q16_MIN..Q16_MAX */

/*
 * Adds a result to `plain`, or to `relative` where the value is at least `relative_from` in
 * magnitude: there the error counts in units of `relative_unit` times the value.
 */
typedef struct verify_judge {
    const verify_reference *reference;
    int arguments;
    bool exact_only;
    double relative_from, relative_unit; /* 0: all is plain */
} verify_judge;

void verify_judge_result(const verify_judge *judge, const q16 *argument, q16 result,
                         verify_row *plain, verify_row *relative);

/* --- inputs (inputs.c) */

uint64_t verify_random(uint64_t *state);

/* Half of them uniform over all 32 bits, half over the magnitudes; some are ties of products. */
q16 verify_random_q16(uint64_t *state);

enum { VERIFY_STRESS = 4096 };

/* Zero, powers of two, whole numbers and halves with their neighbours, extremes, random. */
const q16 *verify_stress(void);

/* First inputs of the blocks that the quick mode looks at. */
enum { VERIFY_STRATA = 1024 };
q16 verify_stratum(int index);

/* --- the tests */

enum { VERIFY_PROPERTIES = 4, VERIFY_TESTS = 160 };
extern const verify_test verify_property_tests[VERIFY_PROPERTIES];
extern const verify_test verify_power_test;

size_t verify_all_tests(verify_test tests[VERIFY_TESTS]);

/* Runs a test on options->threads threads; rows must have VERIFY_ROWS. */
void verify_run(const verify_test *test, const verify_options *options, verify_row *rows);

/* --- pictures (plot.c) */

/* Writes the error of sin, atan2 or sqrt over its domain for gnuplot; false: no such plot, or no
 * file.
 */
bool verify_plot(const char *name, FILE *file);

#endif
