/* SPDX-License-Identifier: MIT */
/*
 * What a program of tests has: `TEST(what_holds) { ... }` for each, and a main() that returns
 * run_all_tests(), which runs them in the order in which they stand.
 */
#ifndef QTRI_TESTS_SUPPORT_TEST_H
#define QTRI_TESTS_SUPPORT_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static struct CMUnitTest listed_tests[64] __attribute__((unused));
static size_t listed_count __attribute__((unused));

/* A test, and what is called before and after it, or NULL. */
#define TEST_WITH(name, before, after)                                                             \
    static void name(void **unused_state);                                                         \
    __attribute__((constructor)) static void list_##name(void)                                     \
    {                                                                                              \
        const struct CMUnitTest test = {#name, name, before, after, NULL};                         \
        listed_tests[listed_count++] = test;                                                       \
    }                                                                                              \
    static void name(void **unused_state __attribute__((unused)))

#define TEST(name) TEST_WITH(name, NULL, NULL)

/* Of what returns an enum qtri_error. */
#define assert_ok(error) assert_int_equal(error, QTRI_OK)

/* Runs all tests; what is called before the first and after the last, or NULL. Returns how many
   failed. */
static inline int run_all_tests(CMFixtureFunction before, CMFixtureFunction after)
{
    return _cmocka_run_group_tests("tests", listed_tests, listed_count, before, after);
}

#endif
