/* SPDX-License-Identifier: MIT */
/*
 * Where results end: what rounds up to more than the greatest number is that number, and bounds
 * that kernels rely on without asking.
 */
#include "support/core.h"

#include "bits/seed.h"

#include <qtri/mat.h>
#include <qtri/q16_exp.h>

static void quotients_round_up_to_the_end(void **state)
{
    (void)state;
    /* (2^32 - 1) / 2 = 2^31 - 1/2. */
    assert_int_equal(q16_muldiv(65537, 65535, 2), Q16_MAX);
    assert_int_equal(q16_muldiv(-65537, 65535, 2), Q16_MIN); /* away from zero */
    assert_int_equal(q16_muldiv(65537, -65535, 2), Q16_MIN);
    assert_int_equal(q16_muldiv(65537, 65535, -2), Q16_MIN);
    assert_int_equal(q16_muldiv(-65537, -65535, 2), Q16_MAX);
    assert_int_equal(q16_muldiv(Q16_MAX, 3, 3), Q16_MAX);
    assert_int_equal(q16_muldiv(Q16_MIN, 3, 3), Q16_MIN);
    for (int32_t c = 2; c < 3000;
         c++) { /* all between 2^31 - 1/2 and 2^31 that the factors reach */
        const int64_t product = ((int64_t)c << 31) - 1;
        const int32_t b = product % 3 == 0 ? 3 : (product % 7 == 0 ? 7 : 1);
        if (product / b <= INT32_MAX) {
            assert_int_equal(q16_muldiv((int32_t)(product / b), b, c), Q16_MAX);
        }
    }
}

/*
 * The greatest base whose power is below 2^k, for exponents around those that have one near it:
 * results next to powers of two, where a mantissa may round up to two, and to 32768, where it is
 * more than there is.
 */
static void powers_round_up_to_the_next(void **state)
{
    (void)state;
    int held = 0;
    for (int k = 15; k >= 1; k--) {
        for (int32_t y = 65536 * k / 15 + 1; y < 65536 * k / 15 + (k == 15 ? 1500 : 400); y++) {
            const long double base = powl(2, 65536.L * k / y) * 65536;
            for (int32_t off = 0; off < 2; off++) {
                const int32_t x = (int32_t)floorl(base) - off;
                const long double exact = powl(x / 65536.L, y / 65536.L) * 65536;
                const long double error = fabsl(q16_pow(x, y) - fminl(exact, Q16_MAX));
                if (error > (exact < 64 * 65536 ? .6L : exact * 1.37e-7L)) {
                    fail_msg("pow(%d, %d) is %d", (int)x, (int)y, (int)q16_pow(x, y));
                }
                held += exact + .5L >= 2147483648.L;
            }
        }
    }
    assert_true(held > 100);
}

static void identities_change_nothing(void **state)
{
    (void)state;
    uint64_t seed = 3;
    const qtri_mat3 one = qtri_mat3_identity();
    for (int n = 0; n < 100; n++) {
        qtri_mat3 m;
        for (int i = 0; i < 9; i++) {
            m.m[i / 3][i % 3] = random_any(&seed);
        }
        const qtri_mat3 left = qtri_mat3_mul(&one, &m);
        const qtri_mat3 right = qtri_mat3_mul(&m, &one);
        assert_memory_equal(&left, &m, sizeof m);
        assert_memory_equal(&right, &m, sizeof m);
    }
}

/* light_point.h: v y of a square's upper half v in [1/4, 1) stays below 2^16 for every v. */
static void lengths_by_the_seed_fit_a_half_word(void **state)
{
    (void)state;
    for (uint32_t v = 0x4000; v <= 0xFFFF; v++) {
        assert_true((v * qtri_rsqrt_seed_in_place(v)) >> 15 <= 0xFFFD);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quotients_round_up_to_the_end),
        cmocka_unit_test(powers_round_up_to_the_next),
        cmocka_unit_test(identities_change_nothing),
        cmocka_unit_test(lengths_by_the_seed_fit_a_half_word),
    };
    return cmocka_run_group_tests_name("core math ends", tests, NULL, NULL);
}
