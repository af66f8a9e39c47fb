/* SPDX-License-Identifier: MIT */
/*
 * Elementary functions against long double, their properties, and the generated coefficients.
 *
 * The short run takes every argument near those that hurt, windows of neighbours all over the range
 * and random ones; with QTRI_TEST_LONG every argument is tried.
 */
#include "support/core.h"
#include "support/elementary.h"

#include <float.h>

#include "generate/coefficients.h"
#include "math/q16_trig.h"

static const long double pi = 3.14159265358979323846264338327950288L;

/* Degrees reduced exactly to within 45 of a right angle, then turned. */
static void turned(long double degrees, long double *sine, long double *cosine)
{
    long double rest = fmodl(degrees, 360);
    int quarter = (int)floorl(rest / 90 + .5L);
    long double radians = (rest - 90 * quarter) * pi / 180;
    long double s = sinl(radians);
    long double c = cosl(radians);
    switch (quarter & 3) {
    case 0:
        *sine = s, *cosine = c;
        break;
    case 1:
        *sine = c, *cosine = -s;
        break;
    case 2:
        *sine = -s, *cosine = -c;
        break;
    default:
        *sine = -c, *cosine = s;
        break;
    }
}

static long double sine_degrees(long double x)
{
    long double s, c;
    turned(x, &s, &c);
    return s;
}

static long double cosine_degrees(long double x)
{
    long double s, c;
    turned(x, &s, &c);
    return c;
}

/* At the poles as documented. */
static long double tangent_degrees(long double x)
{
    long double s, c;
    turned(x, &s, &c);
    return c == 0 ? copysignl(1e9L, x) : s / c;
}

static long double held(long double x)
{
    return fminl(fmaxl(x, -1), 1);
}

static long double arcsine(long double x)
{
    return asinl(held(x));
}

static long double arccosine(long double x)
{
    return acosl(held(x));
}

static long double arcsine_degrees(long double x)
{
    return asinl(held(x)) * 180 / pi;
}

static long double arccosine_degrees(long double x)
{
    return acosl(held(x)) * 180 / pi;
}

static long double arctangent_degrees(long double x)
{
    return atanl(x) * 180 / pi;
}

static long double natural_log(long double x)
{
    return x <= 0 ? -32768 : logl(x);
}

static long double binary_log(long double x)
{
    return x <= 0 ? -32768 : log2l(x);
}

typedef struct single {
    const char *name;
    q16 (*function)(q16 x);
    long double (*reference)(long double x);
    double limit;  /* ULP, while the result is below 256 */
    int direction; /* 1: nowhere falls; -1: nowhere rises */
    int symmetry;  /* 1: even, -1: odd */
    q16 worst;     /* the argument that gives the largest error of all 2^32 */
    q16 low, high; /* arguments of interest: beyond, the result is constant */
} single;

static const single singles[ELEMENTARY_SINGLE] = {
    {"sin", q16_sin, sinl, .5036, 0, -1, -761732193, Q16_MIN, Q16_MAX},
    {"cos", q16_cos, cosl, .5036, 0, 1, -1831420521, Q16_MIN, Q16_MAX},
    {"sin_deg", q16_sin_deg, sine_degrees, .5027, 0, -1, 2889113, Q16_MIN, Q16_MAX},
    {"cos_deg", q16_cos_deg, cosine_degrees, .5027, 0, 1, 3009127, Q16_MIN, Q16_MAX},
    {"tan", q16_tan, tanl, .5222, 0, -1, 875742390, Q16_MIN, Q16_MAX},
    {"tan_deg", q16_tan_deg, tangent_degrees, .5111, 0, -1, 5883194, Q16_MIN, Q16_MAX},
    {"asin", q16_asin, arcsine, .5001, 1, -1, -2344, -70000, 70000},
    {"asin_deg", q16_asin_deg, arcsine_degrees, .5079, 1, -1, -47410, -70000, 70000},
    {"acos", q16_acos, arccosine, .5002, -1, 0, -45440, -70000, 70000},
    {"acos_deg", q16_acos_deg, arccosine_degrees, .5076, -1, 0, -45980, -70000, 70000},
    {"atan", q16_atan, atanl, .5002, 1, -1, -420737989, Q16_MIN, Q16_MAX},
    {"atan_deg", q16_atan_deg, arctangent_degrees, .5091, 1, -1, 66106, Q16_MIN, Q16_MAX},
    {"exp", q16_exp, expl, .9166, 1, 0, 662032, Q16(-13), Q16(11)},
    {"exp2", q16_exp2, exp2l, .6887, 1, 0, 966091, Q16(-19), Q16(16)},
    {"log", q16_log, natural_log, .5073, 1, 0, 1140799976, -2, Q16_MAX},
    {"log2", q16_log2, binary_log, .5107, 1, 0, 1140844951, -2, Q16_MAX},
};

static long double clamped(long double ulp)
{
    return fminl(fmaxl(ulp, INT32_MIN), INT32_MAX);
}

typedef struct sweep {
    const single *f;
    double worst;
    q16 worst_at;
    double worst_relative; /* of results from 256 up */
    int64_t before;        /* the argument before, */
    q16 result_before;     /* and its result */
} sweep;

static void check_single(sweep *s, int64_t argument)
{
    const single *f = s->f;
    q16 x = (q16)argument;
    q16 result = f->function(x);
    long double exact = clamped(f->reference((long double)x / 65536) * 65536);
    double error = (double)fabsl(result - exact);
    bool large = fabsl(exact) >= 256 * 65536 && f->symmetry == -1; /* tan */
    if (large) {
        double relative = error / (double)fabsl(exact);
        s->worst_relative = relative > s->worst_relative ? relative : s->worst_relative;
    } else if (error > s->worst) {
        s->worst = error;
        s->worst_at = x;
    }
    if (f->direction != 0 && argument > s->before && s->before >= INT32_MIN &&
        (result - (int64_t)s->result_before) * f->direction < 0) {
        fail_msg("%s(%d) is on the wrong side of that of %d", f->name, (int)x, (int)s->before);
    }
    if (f->symmetry != 0 && x != Q16_MIN) {
        q16 mirrored = f->function(-x);
        bool both_ends = (result == Q16_MAX && mirrored == Q16_MIN) ||
                         (result == Q16_MIN && mirrored == Q16_MAX); /* tan */
        if (!both_ends && mirrored != f->symmetry * (int64_t)result) {
            fail_msg("%s(%d) and %s(%d) differ", f->name, (int)x, f->name, (int)-x);
        }
    }
    s->before = argument;
    s->result_before = result;
}

/* Neighbours, as far as they are in range. */
static void check_window(sweep *s, int64_t from, int count)
{
    s->before = INT64_MIN;
    for (int64_t x = from; x < from + count; x++) {
        if (x >= s->f->low && x <= s->f->high) {
            check_single(s, x);
        }
    }
}

TEST(single_functions)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < ELEMENTARY_SINGLE; i++) {
        const single *f = &singles[i];
        sweep s = {f, 0, 0, 0, INT64_MIN, 0};
        int64_t width = (int64_t)f->high - f->low + 1;
        if (long_run() || width < 200000) {
            for (int64_t x = f->low; x <= f->high; x++) {
                check_single(&s, x);
            }
        } else {
            uint64_t seed = (uint64_t)i;
            for (int64_t x = f->low; x <= f->high; x += width / 4000) {
                check_window(&s, x, 16);
            }
            for (int k = 0; k < 60000; k++) {
                check_single(&s, random_in(&seed, f->low, f->high));
                s.before = INT64_MIN;
                check_window(&s, random_any(&seed), 2);
            }
            for (int k = 0; k < count; k++) {
                check_window(&s, (int64_t)value[k] - 40, 80);
            }
            check_window(&s, f->worst, 1);
        }
        check_single(&s, Q16_MIN);
        check_single(&s, Q16_MAX);
        print_message("%-8s %.5f ULP at %d, relative %.3g where large\n", f->name, s.worst,
                      (int)s.worst_at, s.worst_relative);
        if (!(s.worst <= f->limit)) {
            fail_msg("%s: %.5f ULP at %d", f->name, s.worst, (int)s.worst_at);
        }
        assert_true(s.worst_relative <= 3.2e-8); /* 2^-24.9: half an ULP of 256 is 2^-25 */
    }
}

/* sincos is sin and cos; the squares' sum is 1. */
static void check_sincos(q16 x)
{
    q16 sine, cosine, sine_deg, cosine_deg;
    q16_sincos(x, &sine, &cosine);
    q16_sincos_deg(x, &sine_deg, &cosine_deg);
    if (sine != q16_sin(x) || cosine != q16_cos(x) || sine_deg != q16_sin_deg(x) ||
        cosine_deg != q16_cos_deg(x)) {
        fail_msg("sincos of %d is not sin and cos", (int)x);
    }
    int64_t one = (int64_t)1 << 32;
    int64_t radians = (int64_t)sine * sine + (int64_t)cosine * cosine - one;
    int64_t degrees = (int64_t)sine_deg * sine_deg + (int64_t)cosine_deg * cosine_deg - one;
    if (llabs(radians) > 2 * 65536 || llabs(degrees) > 2 * 65536) {
        fail_msg("the squares of sin and cos of %d", (int)x);
    }
}

/* A whole turn changes nothing, nor does half a turn change the tangent, where there is one. */
static void check_turn(q16 x)
{
    q16 turn = q16_mod(x, Q16(360));
    q16 half = q16_mod(x, Q16(180));
    if (q16_sin_deg(x) != q16_sin_deg(turn) || q16_cos_deg(x) != q16_cos_deg(turn) ||
        (half != Q16(90) && q16_tan_deg(x) != q16_tan_deg(half))) {
        fail_msg("%d/65536 degrees and %d", (int)x, (int)turn);
    }
}

TEST(sine_and_cosine)
{
    int64_t step = long_run() ? 1 : 1021;
    for (int64_t x = INT32_MIN; x <= INT32_MAX; x += step) {
        check_sincos((q16)x);
        check_turn((q16)x);
    }
    check_turn(-2146941455); /* 1 ULP off while angles were rounded up */
    /* sin rises to 90 degrees: all arguments there. */
    for (q16 x = 1; x <= Q16(90); x++) {
        if (q16_sin_deg(x) < q16_sin_deg(x - 1) || q16_cos_deg(x) > q16_cos_deg(x - 1)) {
            fail_msg("sin or cos turns back at %d/65536 degrees", (int)x);
        }
    }
    for (q16 x = 1; x <= 102943; x++) {
        if (q16_sin(x) < q16_sin(x - 1) || q16_cos(x) > q16_cos(x - 1)) {
            fail_msg("sin or cos turns back at %d/65536", (int)x);
        }
    }
}

TEST(angles_that_are_exact)
{
    static const q16 quadrant[4] = {0, Q16_ONE, 0, -Q16_ONE};
    for (int32_t right = -364; right <= 364; right++) {
        q16 angle = right * Q16(90);
        assert_int_equal(q16_sin_deg(angle), quadrant[right & 3]);
        assert_int_equal(q16_cos_deg(angle), quadrant[(right + 1) & 3]);
        q16 tangent = (right & 1) == 0 ? 0 : (right < 0 ? Q16_MIN : Q16_MAX);
        assert_int_equal(q16_tan_deg(angle), tangent);
    }
    for (int32_t eighth = -363; eighth < 363; eighth += 2) {
        q16 angle = eighth * Q16(45);
        assert_int_equal(q16_tan_deg(angle), (eighth & 3) == 1 ? Q16_ONE : -Q16_ONE);
    }
    assert_int_equal(q16_sin_deg(Q16(90)), Q16_ONE);
    assert_int_equal(q16_sin_deg(Q16(30)), Q16(0.5));
    assert_int_equal(q16_cos_deg(Q16(60)), Q16(0.5));
    assert_int_equal(q16_sin_deg(Q16(-390)), Q16(-0.5));
    assert_int_equal(q16_asin_deg(Q16_ONE), Q16(90));
    assert_int_equal(q16_asin_deg(Q16(0.5)), Q16(30));
    assert_int_equal(q16_acos_deg(-Q16_ONE), Q16(180));
    assert_int_equal(q16_acos_deg(0), Q16(90));
    assert_int_equal(q16_acos_deg(Q16_ONE), 0);
    assert_int_equal(q16_asin_deg(Q16_MIN), Q16(-90));
    assert_int_equal(q16_acos(Q16_MAX), 0);
    assert_int_equal(q16_atan_deg(Q16_ONE), Q16(45));
    assert_int_equal(q16_atan_deg(Q16_MIN), -q16_atan_deg(Q16_MAX));
}

static void check_atan2(double worst[2], q16 y, q16 x)
{
    long double exact = atan2l(y, x) * 65536;
    double error = (double)fabsl(q16_atan2(y, x) - exact);
    double error_deg = (double)fabsl(q16_atan2_deg(y, x) - exact * 180 / pi);
    worst[0] = error > worst[0] ? error : worst[0];
    worst[1] = error_deg > worst[1] ? error_deg : worst[1];
    if (!(error <= .5002) || !(error_deg <= .511)) {
        fail_msg("atan2(%d, %d): %.5f and %.5f ULP", (int)y, (int)x, error, error_deg);
    }
    if (y != Q16_MIN && (y != 0 || x > 0)) {
        assert_int_equal(q16_atan2(-y, x), -q16_atan2(y, x));
    }
}

TEST(two_sides)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    double worst[2] = {0, 0};
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < count; k++) {
            check_atan2(worst, value[i], value[k]);
        }
        q16 side = value[i] == Q16_MIN ? Q16_MAX : abs(value[i]);
        if (side != 0) {
            assert_int_equal(q16_atan2_deg(0, side), 0);
            assert_int_equal(q16_atan2_deg(0, -side), Q16(180));
            assert_int_equal(q16_atan2_deg(side, 0), Q16(90));
            assert_int_equal(q16_atan2_deg(-side, 0), Q16(-90));
            assert_int_equal(q16_atan2_deg(side, side), Q16(45));
            assert_int_equal(q16_atan2_deg(side, -side), Q16(135));
            assert_int_equal(q16_atan2_deg(-side, -side), Q16(-135));
        }
    }
    uint64_t seed = 7;
    int64_t tries = long_run() ? 200000000 : 600000;
    for (int64_t i = 0; i < tries; i++) {
        q16 y = random_any(&seed);
        check_atan2(worst, y, random_flag(&seed) ? random_any(&seed) : random_bits32(&seed));
    }
    assert_int_equal(q16_atan2(0, 0), 0);
    assert_int_equal(q16_atan2_deg(0, 0), 0);
    assert_int_equal(q16_atan2_deg(Q16_MIN, Q16_MIN), Q16(-135));
    print_message("atan2    %.5f ULP, in degrees %.5f\n", worst[0], worst[1]);
}

typedef struct power_worst {
    double ulp, relative;
} power_worst;

static void check_pow(power_worst *worst, q16 x, q16 y)
{
    q16 result = q16_pow(x, y);
    if (y == 0 || x == 0 || (x < 0 && (y & 65535) != 0)) {
        assert_int_equal(result, y == 0 ? Q16_ONE : (x == 0 && y < 0 ? Q16_MAX : 0));
        return;
    }
    long double exact = powl((long double)x / 65536, (long double)y / 65536) * 65536;
    exact = clamped(exact);
    double error = (double)fabsl(result - exact);
    if (fabsl(exact) < 64 * 65536) {
        worst->ulp = error > worst->ulp ? error : worst->ulp;
    } else {
        double relative = error / (double)fabsl(exact);
        worst->relative = relative > worst->relative ? relative : worst->relative;
    }
}

TEST(powers)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    power_worst worst = {0, 0};
    check_pow(&worst, 57230, -2005021);  /* the worst of all that are below 64 */
    check_pow(&worst, 65254, -63103757); /* where log2(x), small as it is, counts 960 times */
    check_pow(&worst, 65547, 1623860000);
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < count; k++) {
            check_pow(&worst, value[i], value[k]);
        }
    }
    uint64_t seed = 11;
    int64_t tries = long_run() ? 100000000 : 400000;
    for (int64_t i = 0; i < tries; i++) {
        q16 x = random_any(&seed);
        q16 y = random_any(&seed);
        check_pow(&worst, x, y);
        check_pow(&worst, x, y & -65536);
        /* Near the edge of the range: y of the size of 16 / log2(x). */
        double log = log2(fabs((double)x) / 65536);
        double most = fmin(fmax(15 / log, -32768), 32767);
        check_pow(&worst, x, (q16)(65535 * most * random_in(&seed, -1100, 1000) / 1000 / 1.1));
        check_pow(&worst, 65536 + (x >> 16), random_bits32(&seed));
    }
    print_message("pow      %.5f ULP, relative %.3g from 64 up\n", worst.ulp, worst.relative);
    assert_true(worst.ulp <= .518);
    assert_true(worst.relative <= 1.3e-7);

    /* The logarithm is rounded to its last place: what is cut off shows. */
    assert_int_equal(q16_pow(23874211, 83853), 124120025);
    assert_int_equal(q16_pow(70730, 7353332), 341239737);
    assert_int_equal(q16_pow(18132, -411705), 209950893);
    assert_int_equal(q16_pow(0, 0), Q16_ONE);
    assert_int_equal(q16_pow(0, Q16(2)), 0);
    assert_int_equal(q16_pow(0, Q16(-2)), Q16_MAX);
    assert_int_equal(q16_pow(Q16(-2), Q16(3)), Q16(-8));
    assert_int_equal(q16_pow(Q16(-2), Q16(-2)), Q16(.25));
    assert_int_equal(q16_pow(Q16(-2), Q16(.5)), 0);
    assert_int_equal(q16_pow(Q16_MIN, Q16_ONE), Q16_MIN);
    assert_int_equal(q16_pow(Q16_MIN, Q16(3)), Q16_MIN);
    assert_int_equal(q16_pow(Q16_MIN, Q16(2)), Q16_MAX);
    assert_int_equal(q16_pow(Q16(9), Q16(.5)), Q16(3));
    assert_int_equal(q16_pow(Q16(7), Q16(5)), Q16(16807));
    assert_int_equal(q16_pow(Q16_MIN, Q16_MIN), 0);
    assert_int_equal(q16_pow(Q16_MAX, Q16_MAX), Q16_MAX);
}

TEST(powers_of_two)
{
    for (int32_t n = -16; n < 15; n++) {
        q16 power = n < 0 ? 65536 >> -n : (q16)65536 << n;
        assert_int_equal(q16_exp2(n * 65536), power);
        assert_int_equal(q16_log2(power), n * 65536);
        assert_int_equal(q16_pow(Q16(2), n * 65536), power);
        assert_int_equal(q16_pow(power, Q16_ONE), power);
    }
    assert_int_equal(q16_exp2(Q16(15)), Q16_MAX);
    assert_int_equal(q16_exp2(Q16_MAX), Q16_MAX);
    assert_int_equal(q16_exp2(Q16_MIN), 0);
    assert_int_equal(q16_exp(0), Q16_ONE);
    assert_int_equal(q16_exp(Q16_MAX), Q16_MAX);
    assert_int_equal(q16_exp(Q16_MIN), 0);
    assert_int_equal(q16_log(Q16_ONE), 0);
    assert_int_equal(q16_log(0), Q16_MIN);
    assert_int_equal(q16_log2(Q16_MIN), Q16_MIN);
}

/* Half-word products give the same bits. */
TEST(narrow_cores)
{
    static const elementary_build here = ELEMENTARY_BUILD;
    const elementary_build *narrow = &elementary_narrow_build;
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    uint64_t seed = 13;
    for (int i = 0; i < (long_run() ? 20000000 : 60000); i++) {
        q16 x = i < count ? value[i] : random_any(&seed);
        q16 y = random_any(&seed);
        for (int k = 0; k < ELEMENTARY_SINGLE; k++) {
            if (narrow->single[k](x) != here.single[k](x)) {
                fail_msg("%s(%d) without a long multiply", singles[k].name, (int)x);
            }
        }
        for (int k = 0; k < 3; k++) {
            if (narrow->pair[k](x, y) != here.pair[k](x, y)) {
                fail_msg("atan2, atan2_deg or pow of %d, %d without a long multiply", (int)x,
                         (int)y);
            }
        }
        for (int k = 0; k < 2; k++) {
            q16 a[2], b[2];
            narrow->sincos[k](x, &a[0], &a[1]);
            here.sincos[k](x, &b[0], &b[1]);
            assert_memory_equal(a, b, sizeof a);
        }
    }
}

/* The committed header is what the generator prints. */
TEST(generated_coefficients)
{
    FILE *committed = fopen("core/math/coefficients.h", "r");
    if (committed == NULL || LDBL_MANT_DIG < 64) {
        print_message("needs the source folder and a long double of 64 bits\n");
        if (committed != NULL) {
            fclose(committed);
        }
        skip();
        return;
    }
    FILE *printed = tmpfile();
    assert_non_null(printed);
    generate_coefficients(printed);
    rewind(printed);
    int a, b;
    do {
        a = getc(committed);
        b = getc(printed);
        assert_int_equal(a, b);
    } while (a != EOF);
    fclose(printed);
    fclose(committed);
}

/* Of no direction there is none, to the last bit of a turn. */
TEST(angle_of_nothing)
{
    assert_int_equal(qtri_angle_q31(0, 0, false), 0);
    assert_int_equal(qtri_angle_q31(0, 0, true), 0);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
