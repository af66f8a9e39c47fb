/* SPDX-License-Identifier: MIT */
/*
 * Where results end: what rounds up to more than the greatest number is that number, and bounds
 * that kernels rely on without asking.
 */
#include "support/core.h"

#include "bits/bits.h"

#include <qtri/mat.h>
#include <qtri/q16.h>

TEST(quotients_round_up_to_the_end)
{
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
TEST(powers_round_up_to_the_next)
{
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

/* light_kinds.c: v y of a square's upper half v in [1/4, 1) stays below 2^16 for every v. */
TEST(lengths_by_the_seed_fit_a_half_word)
{
    for (uint32_t v = 0x4000; v <= 0xFFFF; v++) {
        assert_true((v * qtri_rsqrt_seed_in_place(v)) >> 15 <= 0xFFFD);
    }
}

/* floor(x / 2^shift), by a division that rounds towards zero. */
static int64_t floored(int64_t x, int shift)
{
    const int64_t by = (int64_t)1 << shift;
    return x / by - (x % by < 0);
}

/* Up to `most`, often an end of it, of its halves or of what a half-word holds. */
static uint32_t factor_up_to(uint64_t *seed, uint32_t most)
{
    static const uint32_t ends[] = {0,       1,          0x7FFF,     0x8000,     0xFFFF,    0x10000,
                                    0x10001, 0x3FFFFFFF, 0x40000000, 0x7FFFFFFF, 0x80000000};
    const uint32_t end = ends[random_in(seed, 0, (int32_t)LENGTH_OF(ends) - 1)];
    const uint32_t any = (uint32_t)random_bits32(seed) >> random_in(seed, 0, 31);
    switch (random_in(seed, 0, 3)) {
    case 0:
        return most;
    case 1:
        return end <= most ? end : most - (end & 0xFF);
    default:
        return any <= most ? any : any % most;
    }
}

static int32_t signed_up_to(uint64_t *seed, uint32_t most)
{
    const int32_t size = (int32_t)factor_up_to(seed, most);
    return random_flag(seed) ? -size : size;
}

/* multiply.h: high words by half-words, in a narrow build, are those of the long product. */
TEST(high_words_are_those_of_the_long_product)
{
    uint64_t seed = 5;
    for (int n = 0; n < 20000; n++) {
        const uint32_t any = factor_up_to(&seed, UINT32_MAX);
        const uint32_t a = factor_up_to(&seed, (uint32_t)1 << 31);
        const uint32_t b = factor_up_to(&seed, (uint32_t)1 << 31);
        const uint32_t half = factor_up_to(&seed, 0xFFFF);
        const int32_t s31 = signed_up_to(&seed, INT32_MAX);
        const int32_t s30 = signed_up_to(&seed, (uint32_t)1 << 30);
        const int32_t u30 = (int32_t)factor_up_to(&seed, ((uint32_t)1 << 30) - 1);
        const int32_t s15 = signed_up_to(&seed, 0x7FFF);
        assert_int_equal(qtri_mul_high31(a, b), (uint32_t)((uint64_t)a * b >> 32));
        assert_int_equal(qtri_mul_high_s30(s30, u30), floored((int64_t)s30 * u30, 32));
        assert_int_equal(qtri_mul_high_s31(s31, b), floored((int64_t)s31 * (int64_t)b, 32));
        assert_int_equal(qtri_mul_high16(any, half), (uint32_t)((uint64_t)any * half >> 16));
        assert_int_equal(qtri_mul_round16(any, half),
                         (uint32_t)(((uint64_t)any * half + 0x8000) >> 16));
        assert_int_equal(qtri_mul_wrap12(any, half), (uint32_t)((uint64_t)any * half >> 12));
        assert_int_equal(qtri_mul_wrap12(any, 0x10000), any << 4);
        assert_int_equal(qtri_mul_s16(s30, s15), floored((int64_t)s30 * s15, 16));
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
