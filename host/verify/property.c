/* SPDX-License-Identifier: MIT */
/*
 * What must hold for every angle: symmetry, periods, sin^2 + cos^2 = 1, the pair as each of its
 * halves, and exact right angles.
 */
#include "verify.h"

#include "qtri/q16.h"

#include <math.h>
#include <stdlib.h>

enum { ODD, EVEN, UNIT, PAIR, PERIOD };

typedef struct circle {
    q16 (*sine)(q16);
    q16 (*cosine)(q16);
    void (*both)(q16, q16 *, q16 *);
    q16 turn; /* after which both repeat; 0: no whole number of ULPs */
} circle;

static const circle circles[] = {
    {q16_sin, q16_cos, q16_sincos, 0},
    {q16_sin_deg, q16_cos_deg, q16_sincos_deg, Q16(360)},
};

static double unit_error(q16 sine, q16 cosine)
{
    int64_t square = (int64_t)sine * sine + (int64_t)cosine * cosine;
    return fabs((double)(square - ((int64_t)1 << 32))) / 65536;
}

static double pair_error(const circle *c, q16 x, q16 sine, q16 cosine)
{
    q16 s;
    q16 k;
    c->both(x, &s, &k);
    return fmax(fabs((double)s - sine), fabs((double)k - cosine));
}

static void add(verify_row *row, q16 x, double error)
{
    verify_row_add(row, &x, 1, error, error == 0);
}

static void add_unit(verify_row *row, q16 x, q16 sine, q16 cosine)
{
    double error = unit_error(sine, cosine);
    verify_row_add(row, &x, 1, error, error <= 0.5);
}

/* x >= 0, and -x with it. */
static void circle_at(const circle *c, q16 x, verify_row *rows)
{
    q16 sine = c->sine(x);
    q16 cosine = c->cosine(x);
    q16 sine_back = c->sine(-x);
    q16 cosine_back = c->cosine(-x);
    add(&rows[ODD], x, fabs((double)sine + sine_back));
    add(&rows[EVEN], x, fabs((double)cosine - cosine_back));
    add_unit(&rows[UNIT], x, sine, cosine);
    add_unit(&rows[UNIT], -x, sine_back, cosine_back);
    add(&rows[PAIR], x, pair_error(c, x, sine, cosine));
    add(&rows[PAIR], -x, pair_error(c, -x, sine_back, cosine_back));
    if (c->turn != 0) { /* one turn down from x, one up from -x: every angle with the next */
        double s = fmax(fabs((double)sine - c->sine(x - c->turn)),
                        fabs((double)sine_back - c->sine(c->turn - x)));
        double k = fmax(fabs((double)cosine - c->cosine(x - c->turn)),
                        fabs((double)cosine_back - c->cosine(c->turn - x)));
        add(&rows[PERIOD], x, fmax(s, k));
    }
}

enum { CHUNK_BLOCKS = 2048, CHUNK_STRATA = 64 };

static uint64_t circle_chunks(const verify_test *test, const verify_options *options)
{
    (void)test;
    return options->mode == VERIFY_QUICK ? VERIFY_STRATA / CHUNK_STRATA
                                         : ((uint64_t)1 << 31) / VERIFY_BLOCK / CHUNK_BLOCKS;
}

/* Asks `at` for every x >= 0 of a chunk. */
static void each_input(const circle *c, const verify_options *options, uint64_t chunk,
                       verify_row *rows, void (*at)(const circle *, q16, verify_row *))
{
    const bool quick = options->mode == VERIFY_QUICK;
    const int blocks = quick ? CHUNK_STRATA : CHUNK_BLOCKS;
    for (int i = 0; i < blocks; i++) {
        int index = (int)chunk * blocks + i;
        q16 first = quick ? verify_stratum(index) & INT32_MAX : index * VERIFY_BLOCK;
        for (int k = 0; k < VERIFY_BLOCK; k++) {
            at(c, first + k, rows);
        }
    }
}

static void circle_run(const verify_test *test, const verify_options *options, uint64_t chunk,
                       verify_row *rows)
{
    const circle *c = (const circle *)test->subject;
    each_input(c, options, chunk, rows, circle_at);
    if (chunk == 0) { /* the one that has no opposite */
        q16 sine = c->sine(Q16_MIN);
        q16 cosine = c->cosine(Q16_MIN);
        add_unit(&rows[UNIT], Q16_MIN, sine, cosine);
        add(&rows[PAIR], Q16_MIN, pair_error(c, Q16_MIN, sine, cosine));
        if (c->turn != 0) {
            add(&rows[PERIOD], Q16_MIN,
                fmax(fabs((double)sine - c->sine(Q16_MIN + c->turn)),
                     fabs((double)cosine - c->cosine(Q16_MIN + c->turn))));
        }
    }
}

/* Tangents: odd, and after half a turn the same, where there is one. */

enum { TAN_ODD, TAN_DEG_ODD, TAN_PERIOD };

static double sum_of_opposites(q16 a, q16 b)
{
    return fabs(fmax(a, -Q16_MAX) + fmax(b, -Q16_MAX)); /* saturated, both are extremes */
}

/* x >= 0, and -x with it; half a turn down from x, and up from -x: every angle with the next. */
static void tangent_at(const circle *none, q16 x, verify_row *rows)
{
    (void)none;
    const q16 half_turn = Q16(180);
    const q16 degrees = q16_tan_deg(x);
    const q16 degrees_back = q16_tan_deg(-x);
    add(&rows[TAN_ODD], x, sum_of_opposites(q16_tan(x), q16_tan(-x)));
    add(&rows[TAN_DEG_ODD], x, sum_of_opposites(degrees, degrees_back));
    if (x % half_turn != half_turn / 2) {
        add(&rows[TAN_PERIOD], x,
            fmax(fabs((double)degrees - q16_tan_deg(x - half_turn)),
                 fabs((double)degrees_back - q16_tan_deg(half_turn - x))));
    }
}

static void tangent_run(const verify_test *test, const verify_options *options, uint64_t chunk,
                        verify_row *rows)
{
    (void)test;
    each_input(NULL, options, chunk, rows, tangent_at);
    if (chunk == 0) { /* the one that has no opposite */
        add(&rows[TAN_PERIOD], Q16_MIN,
            fabs((double)q16_tan_deg(Q16_MIN) - q16_tan_deg(Q16_MIN + Q16(180))));
    }
}

/* Multiples of 90 degrees: sine and cosine are whole. */

static uint64_t right_chunks(const verify_test *test, const verify_options *options)
{
    (void)test;
    (void)options;
    return 1;
}

static void right_run(const verify_test *test, const verify_options *options, uint64_t chunk,
                      verify_row *rows)
{
    static const q16 sine[4] = {0, 65536, 0, -65536};
    (void)test;
    (void)options;
    (void)chunk;
    for (int n = -364; n <= 364; n++) {
        q16 x = n * 90 * 65536;
        double s = fabs((double)q16_sin_deg(x) - sine[n & 3]);
        double c = fabs((double)q16_cos_deg(x) - sine[(n + 1) & 3]);
        add(&rows[0], x, fmax(s, c));
    }
}

const verify_test verify_property_tests[VERIFY_PROPERTIES] = {
    {"sincos",
     circle_run,
     circle_chunks,
     &circles[0],
     {[ODD] = {"sin", "_odd", "sin(-x) = -sin(x)", 1, 0, true},
      [EVEN] = {"cos", "_even", "cos(-x) = cos(x)", 1, 0, true},
      [UNIT] = {"sincos", "_unit", "sin^2 + cos^2 = 1", 1, 2, false},
      [PAIR] = {"sincos", "", "as sin and cos", 1, 0, true}}},
    {"sincos_deg",
     circle_run,
     circle_chunks,
     &circles[1],
     {[ODD] = {"sin_deg", "_odd", "sin(-x) = -sin(x)", 1, 0, true},
      [EVEN] = {"cos_deg", "_even", "cos(-x) = cos(x)", 1, 0, true},
      [UNIT] = {"sincos_deg", "_unit", "sin^2 + cos^2 = 1", 1, 2, false},
      [PAIR] = {"sincos_deg", "", "as sin and cos", 1, 0, true},
      [PERIOD] = {"sincos_deg", "_period", "as of x - 360 and x + 360", 1, 0, true}}},
    {"tangents",
     tangent_run,
     circle_chunks,
     NULL,
     {[TAN_ODD] = {"tan", "_odd", "tan(-x) = -tan(x)", 1, 0, true},
      [TAN_DEG_ODD] = {"tan_deg", "_odd", "tan(-x) = -tan(x)", 1, 0, true},
      [TAN_PERIOD] = {"tan_deg", "_period", "as of x - 180 and x + 180", 1, 0, true}}},
    {"right_angles",
     right_run,
     right_chunks,
     NULL,
     {{"sincos_deg", "_right", "multiples of 90", 1, 0, true}}},
};
