/* SPDX-License-Identifier: MIT */
/*
 * Integer helpers, sines of Q30 and wide numbers against exact or longer arithmetic;
 * test_core_q16.c has the scalars, test_core_elementary.c what angles give.
 */
#include "support/core.h"

#include "bits/bits.h"
#include "math/q16_trig.h"
#include "bits/wide.h"
#include "support/math_checked.h"
#include "support/q16.h"

static const long double pi = 3.141592653589793238462643383279502884L;

TEST(square_roots_of_words)
{
    for (uint32_t root = 0; root < 65536; root++) { /* the ends of what is nearest to it */
        const uint32_t square = root * root;
        assert_int_equal(qtri_sqrt32_round(square), root);
        assert_int_equal(qtri_sqrt32_round(square + root), root);
        assert_int_equal(qtri_sqrt32_round(square - (root != 0 ? root - 1 : 0)), root);
    }
    assert_int_equal(qtri_sqrt32_round(UINT32_MAX), 65536);
}

TEST(integers)
{
    for (int bit = 0; bit < 64; bit++) {
        assert_int_equal(qtri_clz64((uint64_t)1 << bit), 63 - bit);
        assert_int_equal(qtri_clz64(UINT64_MAX >> bit), bit);
    }
    assert_int_equal(qtri_clz64(0), 64);
    assert_int_equal(qtri_clz32(0), 32);
    assert_int_equal(qtri_clz32(1), 31);
    assert_true(qtri_magnitude64(INT64_MIN) == (uint64_t)1 << 63);
    assert_true(qtri_wrap64((uint64_t)1 << 63) == INT64_MIN);
    assert_true(qtri_wrap64(UINT64_MAX) == -1);
    assert_int_equal(qtri_shift_round(3, 1), 2);
    assert_int_equal(qtri_shift_round(-3, 1), -1);
    assert_int_equal(qtri_shift_round(((int64_t)1 << 62) - 1, 63), 0);
    assert_int_equal(qtri_shift_round(5, 0), 5);
}

TEST(quotients)
{
    uint64_t seed = 9;
    for (int i = 0; i < 1000000; i++) {
        uint64_t n = random64(&seed) >> (2 + i % 62);
        uint64_t divisor = (random64(&seed) >> (2 + i / 62 % 61)) | 1;
        int32_t more = i % 5 == 0 ? 0 : i % 17;
        if (i % 7 == 0) {
            n = divisor * (random64(&seed) >> (40 + i % 24)) & (((uint64_t)1 << 62) - 1);
        }
        bool half;
        uint64_t quotient = qtri_divide64(n, divisor, more, &half);
        __extension__ unsigned __int128 shifted = (unsigned __int128)n << more;
        __extension__ unsigned __int128 rest = shifted % divisor;
        if (quotient != (uint64_t)(shifted / divisor) || half != (2 * rest >= divisor)) {
            fail_msg("%llu 2^%d / %llu", (unsigned long long)n, (int)more,
                     (unsigned long long)divisor);
        }
    }
}

enum { TURN = 360 * 65536 };

TEST(angles)
{
    double worst = 0;
    double worst_q30 = 0;
    int32_t worst_at = 0;
    int32_t stride = long_run() ? 1 : 13;
    for (int32_t turn = 0; turn < TURN; turn += stride) {
        long double radians = (long double)turn * pi / (180 * 65536);
        long double exact[2] = {sinl(radians), cosl(radians)};
        int32_t q30[2];
        q16 result[2];
        qtri_sincos_deg_q30(turn, &q30[0], &q30[1]);
        q16_sincos_deg(turn, &result[0], &result[1]);
        for (int i = 0; i < 2; i++) {
            double error = (double)fabsl((long double)result[i] - exact[i] * 65536);
            double error_q30 = (double)fabsl((long double)q30[i] - exact[i] * 1073741824);
            worst_q30 = error_q30 > worst_q30 ? error_q30 : worst_q30;
            if (error > worst) {
                worst = error;
                worst_at = turn;
            }
        }
    }
    print_message("sin, cos: %.5f ULP at %d/65536 degrees; Q30: %.4f ULP\n", worst, (int)worst_at,
                  worst_q30);
    assert_true(worst <= .51);
    assert_true(worst_q30 <= 1.4142); /* 2^-29.5 */
}

static long double value_of(qtri_wide a)
{
    return ldexpl((long double)a.m, -a.e);
}

static qtri_wide random_wide(uint64_t *seed)
{
    switch (random_in(seed, 0, 9)) {
    case 0:
        return qtri_wide_make(random_any(seed), 16);
    case 1:
        return qtri_wide_make(0, 17);
    case 2:
        return qtri_wide_make((int64_t)random64(seed), random_in(seed, -1900, 1900));
    default:
        return qtri_wide_make((int64_t)random64(seed), random_in(seed, 40, 80));
    }
}

static qtri_wide product_of(qtri_wide a, qtri_wide b)
{
    qtri_wide_mul_by(&a, &b);
    return a;
}

static qtri_wide quotient_of(qtri_wide a, qtri_wide b)
{
    qtri_wide_div_by(&a, &b);
    return a;
}

static void check_wide(qtri_wide result, long double exact, long double scale, const char *name)
{
    bool normal = result.m == 0 ? result.e == 0
                                : qtri_magnitude64(result.m) >> 61 == 1 &&
                                      abs(result.e) <= QTRI_WIDE_EXPONENT_MAX;
    /* Beyond the exponents: 0 or the limit. */
    int exponent = 0;
    long double size = fabsl(exact);
    (void)frexpl(size, &exponent);
    if (size == 0 || (exponent > -1980 && exponent < 2100)) {
        if (!normal || fabsl(value_of(result) - exact) > ldexpl(scale, -59)) {
            fail_msg("%s: %La is not %La", name, value_of(result), exact);
        }
    } else if (!normal || (exponent < -2200 && result.m != 0) ||
               (exponent > 2200 && result.e != -QTRI_WIDE_EXPONENT_MAX)) {
        fail_msg("%s out of range: %La for %La", name, value_of(result), exact);
    }
}

TEST(wides)
{
    uint64_t seed = 5;
    for (int i = 0; i < 300000; i++) {
        qtri_wide a = random_wide(&seed);
        qtri_wide b = i % 16 == 0 ? qtri_wide_make(-a.m, a.e) : random_wide(&seed);
        if (i % 32 == 0 && b.m != 0) {
            b = qtri_wide_make(b.m + random_in(&seed, -3, 3), b.e); /* cancels nearly */
        }
        long double x = value_of(a);
        long double y = value_of(b);
        long double larger = fabsl(x) > fabsl(y) ? fabsl(x) : fabsl(y);
        qtri_wide sum = a;
        qtri_wide_add_to(&sum, &b);
        check_wide(sum, x + y, larger, "add");
        check_wide(product_of(a, b), x * y, fabsl(x * y), "mul");
        if (b.m != 0) {
            check_wide(quotient_of(a, b), x / y, fabsl(x / y), "div");
        }
        long double root = x > 0 ? sqrtl(x) : 0;
        check_wide(qtri_wide_sqrt(a), root, root, "sqrt");
    }
    qtri_wide zero = {0, 0};
    qtri_wide one = qtri_wide_make(1, 0);
    assert_true(quotient_of(zero, zero).m == 0);
    assert_true(quotient_of(one, zero).e == -QTRI_WIDE_EXPONENT_MAX);
    assert_true(quotient_of(qtri_wide_make(-1, 0), zero).m < 0);
    assert_true(value_of(qtri_wide_make(INT64_MIN, 63)) == -1);
    assert_true(value_of(qtri_wide_make(INT64_MAX, 0)) > 9.2e18L);
    (void)qtri_wide_make(1, INT32_MAX);
    (void)qtri_wide_make(1, INT32_MIN);
}

TEST(wide_vectors)
{
    uint64_t seed = 6;
    long double worst = 0;
    for (int i = 0; i < 30000; i++) {
        qtri_wide v[3];
        qtri_wide w[3];
        qtri_wide cross[3];
        long double x[3];
        long double y[3];
        for (int k = 0; k < 3; k++) {
            v[k] = i % 3 == 0 ? qtri_wide_make(random_any(&seed), 16) : random_wide(&seed);
            w[k] = qtri_wide_make(random_any(&seed), 16);
            x[k] = value_of(v[k]);
            y[k] = value_of(w[k]);
        }
        long double length = sqrtl(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (length == 0) {
            assert_false(qtri_wide_normalize(v));
            continue;
        }
        qtri_wide_cross(cross, v, w);
        assert_true(qtri_wide_normalize(v));
        for (int k = 0; k < 3; k++) {
            long double error = fabsl(value_of(v[k]) - x[k] / length);
            worst = error > worst ? error : worst;
            int p = (k + 1) % 3;
            int q = (k + 2) % 3;
            long double size = fabsl(x[p] * y[q]) + fabsl(x[q] * y[p]);
            check_wide(cross[k], x[p] * y[q] - x[q] * y[p], size, "cross");
        }
    }
    print_message("wide normalize: 2^%.1f\n", (double)log2l(worst));
    assert_true(worst < ldexpl(1, -58));
}

/* The debug build stops at what saturates and at arguments without a result, at nothing else. */
TEST(faults)
{
    for (const math_checked_case *c = math_checked_cases; c->name != NULL; c++) {
        q16_checked_faults = 0;
        c->sound();
        if (q16_checked_faults != 0) {
            fail_msg("%s stops where there is a result", c->name);
        }
        c->faulty();
        if (q16_checked_faults == 0) {
            fail_msg("%s does not stop where there is no result", c->name);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
