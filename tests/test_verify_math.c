/* SPDX-License-Identifier: MIT */
/*
 * The accuracy of every function of the mathematics, over strata of its arguments, by the code of
 * `make verify-math`, which looks at all of them; and that code itself: it finds what is wrong.
 */
#include "support/test.h"

#include <string.h>

#include "verify/reference.h"
#include "verify/table.h"

#include "qtri/q16.h"

#define LENGTH_OF(array) (sizeof(array) / sizeof((array)[0]))

static const verify_options quick = {VERIFY_QUICK, false, 1, NULL};

static void check_test(const verify_test *test)
{
    verify_row rows[VERIFY_ROWS];
    verify_run(test, &quick, rows);
    for (int i = 0; i < VERIFY_ROWS; i++) {
        const verify_label *label = &test->label[i];
        if (rows[i].inputs > 0 && label->function != NULL && !verify_row_passes(&rows[i], label)) {
            fail_msg(
                "%s%s: %s: error %.6f, limit %g, %llu of %llu correct, worst input %ld %ld %ld",
                label->function, label->suffix, label->domain, rows[i].max, label->limit,
                (unsigned long long)rows[i].correct, (unsigned long long)rows[i].inputs,
                (long)rows[i].worst[0], (long)rows[i].worst[1], (long)rows[i].worst[2]);
        }
    }
}

TEST(accuracy)
{
    verify_test tests[VERIFY_TESTS];
    size_t count = verify_all_tests(tests);
    assert_true(count > 40 && count < VERIFY_TESTS);
    for (size_t i = 0; i < count; i++) {
        check_test(&tests[i]);
    }
}

static verify_function named(const char *name)
{
    verify_function function = verify_functions[0];
    for (size_t i = 0; i < verify_function_count; i++) {
        if (strcmp(verify_functions[i].name, name) == 0) {
            function = verify_functions[i];
        }
    }
    assert_string_equal(function.name, name);
    return function;
}

/* The table's function with another implementation. */
static verify_function with(const char *name, q16 (*one)(q16), q16 (*two)(q16, q16))
{
    verify_function changed = named(name);
    changed.one = one;
    changed.two = two;
    return changed;
}

/* One ULP off at a single argument that the strata hold. */
enum { WRONG_AT = 54321 };

static q16 wrong_sqrt(q16 x)
{
    return q16_sqrt(x) + (x == WRONG_AT);
}

static q16 wrong_sin(q16 x)
{
    return q16_sin(x) - (x == WRONG_AT);
}

static q16 wrong_neg(q16 x)
{
    return q16_neg(x) + (x == WRONG_AT);
}

static q16 wrong_tan(q16 x)
{
    return q16_tan_deg(x) + (x == -WRONG_AT);
}

static q16 wrong_asin_outside(q16 x)
{
    return q16_asin(x) - (x == 70000);
}

TEST(a_single_wrong_ulp_is_found)
{
    static const struct {
        const char *name;
        q16 (*function)(q16);
        int row;
        q16 at;
    } wrong[] = {{"sqrt", wrong_sqrt, 0, WRONG_AT},
                 {"sin", wrong_sin, 0, WRONG_AT},
                 {"neg", wrong_neg, 0, WRONG_AT},
                 {"tan_deg", wrong_tan, 0, -WRONG_AT},
                 {"asin", wrong_asin_outside, 2, 70000}};
    for (size_t i = 0; i < LENGTH_OF(wrong); i++) {
        verify_function changed = with(wrong[i].name, wrong[i].function, NULL);
        verify_test test = verify_scalar_test(&changed);
        verify_row rows[VERIFY_ROWS];
        verify_run(&test, &quick, rows);
        assert_non_null(test.label[wrong[i].row].function);
        assert_false(verify_row_passes(&rows[wrong[i].row], &test.label[wrong[i].row]));
        assert_int_equal(rows[wrong[i].row].worst[0], wrong[i].at);
        assert_true(rows[wrong[i].row].max > 0.5 && rows[wrong[i].row].max < 1.51);
    }
}

static q16 wrong_mul(q16 a, q16 b)
{
    return q16_mul(a, b) - (a == 3 * 65536 && b == 65537);
}

TEST(a_single_wrong_pair_is_found)
{
    verify_options full = quick;
    full.mode = VERIFY_FULL; /* all pairs of the stress set: its first chunks are enough for mul */
    verify_function changed = with("mul", NULL, wrong_mul);
    verify_test test = verify_scalar_test(&changed);
    verify_row rows[VERIFY_ROWS];
    for (int i = 0; i < VERIFY_ROWS; i++) {
        verify_row_clear(&rows[i]);
    }
    for (uint64_t chunk = 0; chunk < (uint64_t)VERIFY_STRESS * VERIFY_STRESS >> 16; chunk++) {
        test.run(&test, &full, chunk, rows);
    }
    assert_int_equal(rows[0].inputs, (uint64_t)VERIFY_STRESS * VERIFY_STRESS);
    assert_int_equal(rows[0].correct, rows[0].inputs - 1);
    assert_int_equal(rows[0].worst[0], 3 * 65536);
    assert_int_equal(rows[0].worst[1], 65537);
}

/* Blocks and fast values give the rows that MPFR alone gives. */
TEST(shortcuts_change_nothing)
{
    static const char *const names[] = {"sin", "tan_deg", "atan_deg", "log2", "asin", "exp", "pow"};
    verify_options exact = quick;
    exact.exact_only = true;
    for (size_t i = 0; i < LENGTH_OF(names); i++) {
        verify_function function = named(names[i]);
        verify_test test = verify_scalar_test(&function);
        verify_row fast_rows[VERIFY_ROWS];
        verify_row exact_rows[VERIFY_ROWS];
        for (int k = 0; k < VERIFY_ROWS; k++) {
            verify_row_clear(&fast_rows[k]);
            verify_row_clear(&exact_rows[k]);
        }
        /* One chunk about zero, one of the spread ones. */
        for (uint64_t chunk = 3; chunk < 12; chunk += 6) {
            test.run(&test, &quick, chunk, fast_rows);
            test.run(&test, &exact, chunk, exact_rows);
        }
        for (int k = 0; k < VERIFY_ROWS; k++) {
            assert_memory_equal(&fast_rows[k], &exact_rows[k], sizeof fast_rows[k]);
        }
    }
}

int main(void)
{
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return run_all_tests(NULL, NULL);
}
