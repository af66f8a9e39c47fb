/* SPDX-License-Identifier: MIT */
/*
 * Arithmetic scalars against exact 128-bit arithmetic, in all builds of support/q16.h.
 */
#include "support/core.h"
#include "support/q16.h"

#include <limits.h>

#include "bits/bits.h"

static const q16_build library = Q16_BUILD("library");
static const q16_build *const builds[] = {&library, &q16_narrow_build, &q16_checked_build};

static int128 size_of(int128 x)
{
    return x < 0 ? -x : x;
}

/* n / d to nearest, halves away from zero, saturated; d = 0 by the sign of n. */
static q16 quotient(int128 n, int128 d)
{
    if (d == 0) {
        return n == 0 ? 0 : (n > 0 ? Q16_MAX : Q16_MIN);
    }
    int128 size = (2 * size_of(n) + size_of(d)) / (2 * size_of(d));
    return saturated((n < 0) != (d < 0) ? -size : size);
}

static void expect(const q16_build *build, const char *name, int64_t a, int64_t b, int64_t c,
                   int64_t result, int64_t exact)
{
    if (result != exact) {
        fail_msg("%s %s(%lld, %lld, %lld) is %lld, not %lld", build->name, name, (long long)a,
                 (long long)b, (long long)c, (long long)result, (long long)exact);
    }
}

static void check_pair(q16 a, q16 b)
{
    int128 product = (int128)a * b;
    q16 nearest = q16_of_products(product);
    q16 below = saturated(floor_div(product, 65536));
    q16 wrapped = (q16)(uint32_t)(uint64_t)floor_div(product + 32768, 65536);
    q16 ratio = quotient((int128)a * 65536, b);
    int128 modulo = b == 0 ? a : a - b * floor_div(a, b);
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        const q16_build *f = builds[i];
        expect(f, "mul", a, b, 0, f->mul(a, b), nearest);
        expect(f, "mul_floor", a, b, 0, f->mul_floor(a, b), below);
        expect(f, "mul_wrap", a, b, 0, f->mul_wrap(a, b), wrapped);
        expect(f, "div", a, b, 0, f->div(a, b), ratio);
        expect(f, "from_ratio", a, b, 0, f->from_ratio(a, b), ratio);
        expect(f, "add", a, b, 0, f->add(a, b), saturated((int128)a + b));
        expect(f, "sub", a, b, 0, f->sub(a, b), saturated((int128)a - b));
        expect(f, "add_sat", a, b, 0, f->add_sat(a, b), saturated((int128)a + b));
        expect(f, "sub_sat", a, b, 0, f->sub_sat(a, b), saturated((int128)a - b));
        expect(f, "mul_sat", a, b, 0, f->mul_sat(a, b), nearest);
        expect(f, "div_sat", a, b, 0, f->div_sat(a, b), ratio);
        expect(f, "mod", a, b, 0, f->mod(a, b), (int64_t)modulo);
        expect(f, "mul_s32", a, b, 0, f->mul_s32(a, b), (int64_t)product);
        expect(f, "mul_u32", a, b, 0, (int64_t)f->mul_u32((uint32_t)a, (uint32_t)b),
               (int64_t)((uint64_t)(uint32_t)a * (uint32_t)b));
    }
    assert_int_equal(q16_add_wrap(a, b), (q16)(uint32_t)((uint64_t)((int64_t)a + b) & UINT32_MAX));
    assert_int_equal(q16_sub_wrap(a, b), (q16)(uint32_t)((uint64_t)((int64_t)a - b) & UINT32_MAX));
}

static void check_hypot(q16 a, q16 b)
{
    int128 square = (int128)a * a + (int128)b * b;
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        int128 r = builds[i]->hypot(a, b);
        bool high = r > 0 && (2 * r - 1) * (2 * r - 1) > 4 * square;
        bool low = r < Q16_MAX && 4 * square >= (2 * r + 1) * (2 * r + 1);
        if (high || low) {
            fail_msg("%s hypot(%d, %d) is %d", builds[i]->name, (int)a, (int)b, (int)r);
        }
    }
}

static void check_triple(q16 a, q16 b, q16 c)
{
    q16 ratio = quotient((int128)a * b, c);
    q16 blend = q16_of_products((int128)a * 65536 + ((int128)b - a) * c);
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        const q16_build *f = builds[i];
        expect(f, "muldiv", a, b, c, f->muldiv(a, b, c), ratio);
        expect(f, "lerp", a, b, c, f->lerp(a, b, c), blend);
    }
}

TEST(stress_sets)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            check_pair(value[i], value[j]);
            check_hypot(value[i], value[j]);
            for (int k = (i + j) & 7; k < count; k += 8) {
                check_triple(value[i], value[j], value[k]);
            }
        }
    }
}

TEST(random_sets)
{
    uint64_t seed = 1;
    int count = long_run() ? 200000000 : 2000000;
    for (int i = 0; i < count; i++) {
        q16 a = random_any(&seed);
        q16 b = random_any(&seed);
        check_pair(a, b);
        check_hypot(a, b);
        check_triple(a, b, random_any(&seed));
        check_triple(a, b, random_in(&seed, 0, 65536));
    }
}

/* Quotients at and beside the middle of two results, and of the largest ones. */
TEST(near_halves)
{
    uint64_t seed = 2;
    for (int i = 0; i < 400000; i++) {
        int64_t b = (int64_t)size_of(random_any(&seed));
        int64_t q = (int64_t)size_of(random_any(&seed));
        for (int64_t near_by = -1; near_by <= 1; near_by++) {
            int64_t a = ((2 * q + 1) * b / 2 >> 16) + near_by;
            if (a <= INT32_MAX && b <= INT32_MAX) {
                check_pair((q16)a, (q16)b);
                check_pair((q16)-a, (q16)b);
            }
            int64_t c = (2 * q + 1) * b;
            int32_t power = random_in(&seed, 0, 30);
            if (c + near_by <= INT32_MAX && (b << power) <= INT32_MAX) {
                check_triple((q16)(c + near_by), (q16)(1 << power), (q16)(b << 1 & INT32_MAX));
                check_triple((q16)(c + near_by), 1 << (power & 15), -(1 << power));
            }
        }
    }
    for (int32_t odd = 1; odd < 2001; odd += 2) { /* exactly halfway */
        check_pair(odd, 131072 << 1);
        check_pair(-odd, 131072);
        check_pair(odd, INT32_MIN);
        check_pair(odd * 3, -(3 << 17));
    }
    for (int64_t b = 1; b < 65536; b++) { /* a 2^16 / b is 2^31 */
        int64_t a = b << 15;
        check_pair((q16)(a - 1), (q16)b);
        check_pair((q16)(a - 1), (q16)-b);
        check_pair((q16)(a > INT32_MAX ? INT32_MAX : a), (q16)b);
        check_pair((q16)-a, (q16)b);
    }
}

static void check_roots(q16 x)
{
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        const q16_build *f = builds[i];
        int64_t root = f->sqrt(x);
        int64_t inverse = f->rsqrt(x);
        if (x <= 0) {
            expect(f, "sqrt", x, 0, 0, root, 0);
            expect(f, "rsqrt", x, 0, 0, inverse, Q16_MAX);
            continue;
        }
        int64_t square = (int64_t)x << 18;
        if ((2 * root - 1) * (2 * root - 1) > square || (2 * root + 1) * (2 * root + 1) < square) {
            fail_msg("%s sqrt(%d) is %d", f->name, (int)x, (int)root);
        }
        int128 above = (int128)((2 * inverse + 1) * (2 * inverse + 1)) * x;
        int128 below = (int128)((2 * inverse - 1) * (2 * inverse - 1)) * x;
        if (above < (int128)1 << 50 || below > (int128)1 << 50) {
            fail_msg("%s rsqrt(%d) is %d", f->name, (int)x, (int)inverse);
        }
    }
}

static void check_single(q16 x)
{
    q16 inverse = x == 0 ? Q16_MAX : quotient((int128)1 << 32, x);
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        expect(builds[i], "recip", x, 0, 0, builds[i]->recip(x), inverse);
    }
    check_roots(x);
    int128 below = floor_div(x, 65536);
    int128 above = -floor_div(-(int128)x, 65536);
    int128 nearest = floor_div((int128)x + 32768, 65536);
    if (q16_to_int_floor(x) != below || q16_to_int_ceil(x) != above ||
        q16_to_int_round(x) != nearest || q16_to_int_trunc(x) != (x < 0 ? above : below) ||
        q16_floor(x) != below * 65536 || q16_ceil(x) != saturated(above * 65536) ||
        q16_round(x) != saturated(nearest * 65536) || q16_fract(x) != x - below * 65536 ||
        q16_neg(x) != saturated(-(int128)x) || q16_abs(x) != saturated(size_of(x)) ||
        q16_neg_wrap(x) != (x == Q16_MIN ? Q16_MIN : -x) ||
        q16_sign(x) != (x > 0 ? Q16_ONE : (x < 0 ? -Q16_ONE : 0)) ||
        q16_from_int(x) != saturated((int128)x * 65536)) {
        fail_msg("rounding, sign or integer of %d", (int)x);
    }
    if (q16_from_q30(x) != floor_div((int128)x + 8192, 16384) ||
        q16_to_q30(x) != saturated((int128)x * 16384) ||
        q16_from_q8(x) != saturated((int128)x * 256) ||
        q16_to_q8(x) != floor_div((int128)x + 128, 256)) {
        fail_msg("formats of %d", (int)x);
    }
}

TEST(singles)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < count; i++) {
        check_single(value[i]);
    }
    for (q16 x = -70000; x <= 70000; x++) {
        check_single(x);
    }
    uint64_t seed = 3;
    for (int i = 0; i < 2000000; i++) {
        check_single(random_any(&seed));
    }
    if (long_run()) {
        for (int64_t x = INT32_MIN; x <= INT32_MAX; x++) {
            check_single((q16)x);
        }
    }
}

TEST(formats)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < count; i++) {
        for (int bits = -20; bits <= 60; bits++) {
            int shift = bits - 16;
            int128 to = shift >= 0 ? (int128)value[i] * ((int128)1 << shift)
                                   : floor_div((int128)value[i] * 2 + ((int128)1 << -shift),
                                               (int128)2 << -shift);
            int128 from = shift <= 0 ? (int128)value[i] * ((int128)1 << -shift)
                                     : floor_div((int128)value[i] * 2 + ((int128)1 << shift),
                                                 (int128)2 << shift);
            assert_int_equal(q16_to_fixed(value[i], bits), saturated(to));
            assert_int_equal(q16_from_fixed(value[i], bits), saturated(from));
        }
        q16 extreme = value[i] == 0 ? 0 : (value[i] > 0 ? Q16_MAX : Q16_MIN);
        assert_int_equal(q16_to_fixed(value[i], INT_MAX), extreme);
        assert_int_equal(q16_to_fixed(value[i], INT_MIN), 0);
        assert_int_equal(q16_from_fixed(value[i], INT_MIN), extreme);
        assert_int_equal(q16_from_fixed(value[i], INT_MAX), 0);
    }
}

TEST(choices)
{
    assert_int_equal(q16_clamp(5, 0, 3), 3);
    assert_int_equal(q16_clamp(-5, 0, 3), 0);
    assert_int_equal(q16_clamp(1, 3, 0), 0);
    assert_int_equal(q16_clamp(5, 3, 0), 0);
    assert_int_equal(q16_min(INT32_MIN, INT32_MAX), INT32_MIN);
    assert_int_equal(q16_max(INT32_MIN, INT32_MAX), INT32_MAX);
    assert_int_equal(Q16(0.5), 32768);
    assert_int_equal(Q16(-3), -196608);
    assert_int_equal(Q16(-32768), INT32_MIN);
}

/* How often the debug build would stop at an expression: once at a fault, never at what is meant.
 */
#define FAULTS(expression) (q16_checked_faults = 0, (void)(expression), q16_checked_faults)

static void check_faults(q16 a, q16 b)
{
    const q16_build *f = &q16_checked_build;
    int128 sum = (int128)a + b;
    int128 difference = (int128)a - b;
    int128 product = floor_div((int128)a * b + 32768, 65536);
    int128 size = b == 0 ? 0 : (131072 * size_of(a) + size_of(b)) / (2 * size_of(b));
    int128 ratio = (a < 0) != (b < 0) ? -size : size;
    assert_int_equal(FAULTS(f->add(a, b)), sum != saturated(sum));
    assert_int_equal(FAULTS(f->sub(a, b)), difference != saturated(difference));
    assert_int_equal(FAULTS(f->mul(a, b)), product != saturated(product));
    assert_int_equal(FAULTS(f->div(a, b)), b == 0 || ratio != saturated(ratio));
    assert_int_equal(FAULTS(f->muldiv(a, Q16_ONE, b)), b == 0 || ratio != saturated(ratio));
    assert_int_equal(FAULTS(f->mod(a, b)), b == 0);
    assert_int_equal(FAULTS(f->recip(a)), a >= -1 && a <= 2);
    assert_int_equal(FAULTS(f->neg(a)), a == Q16_MIN);
    assert_int_equal(FAULTS(f->abs(a)), a == Q16_MIN);
    assert_int_equal(FAULTS(f->ceil(a)), a > 0x7FFF0000);
    assert_int_equal(FAULTS(f->round(a)), a >= 0x7FFF8000);
    assert_int_equal(FAULTS(f->from_int(a)), a < -32768 || a > 32767);
    assert_int_equal(FAULTS(f->to_fixed(a, 20)), a < -(1 << 27) || a >= 1 << 27);
    assert_int_equal(FAULTS(f->sqrt(a)), a < 0);
    assert_int_equal(FAULTS(f->rsqrt(a)), a <= 0);
    q16_checked_faults = 0;
    (void)f->add_sat(a, b);
    (void)f->sub_sat(a, b);
    (void)f->mul_sat(a, b);
    (void)f->div_sat(a, b);
    (void)f->mul_wrap(a, b);
    assert_int_equal(q16_checked_faults, 0);
}

TEST(faults)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            check_faults(value[i], value[j]);
        }
    }
    assert_int_equal(FAULTS(q16_checked_build.lerp(Q16_MAX, 0, -1)), 1);
    assert_int_equal(FAULTS(q16_checked_build.lerp(Q16_MIN, Q16_MAX, Q16_ONE)), 0);
    assert_int_equal(FAULTS(q16_checked_build.hypot(Q16_MIN, 0)), 1);
    assert_int_equal(FAULTS(q16_checked_build.hypot(Q16_MAX, 0)), 0);
}

/* The bounds that the corrections rely on. */
TEST(seeds)
{
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        for (uint32_t x = 32768; x <= 65536; x++) {
            uint32_t seed = builds[i]->reciprocal_seed(x);
            int64_t loss = ((int64_t)1 << 31) - (int64_t)x * seed;
            assert_true(loss >= 0 && loss < 5 * (int64_t)x / 4);
        }
        for (uint32_t t = 16384; t < 65536; t++) {
            int128 y = builds[i]->rsqrt_seed(t);
            assert_true(y < 65536);
            /* y^2 v is within 2^-12 of 1 at both ends of what has these 16 bits. */
            assert_true(y * y * t > ((int128)1 << 46) - ((int128)1 << 34));
            assert_true(y * y * (t + 1) < ((int128)1 << 46) + ((int128)1 << 34));
        }
    }
}

static void check_sqrt64(uint64_t x)
{
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        uint64_t remainder = 0;
        uint64_t root = builds[i]->sqrt64_floor(x, &remainder);
        uint64_t nearest = root + (remainder > root);
        if (root * root + remainder != x || remainder > 2 * root ||
            builds[i]->sqrt64_round(x) != nearest) {
            fail_msg("%s sqrt64 of %llu", builds[i]->name, (unsigned long long)x);
        }
    }
}

static void check_reciprocal(uint32_t x)
{
    uint32_t exact = (uint32_t)(((uint64_t)1 << 62) / (x < 0x80000000u ? 0x80000000u : x));
    for (size_t i = 0; i < LENGTH_OF(builds); i++) {
        expect(builds[i], "reciprocal_q62", x, 0, 0, builds[i]->reciprocal_q62(x), exact);
        if (x >= 0x80000000u) {
            expect(builds[i], "reciprocal_below", x, 0, 0, builds[i]->reciprocal_below(x),
                   x == 0x80000000u ? INT32_MAX : exact);
        }
    }
}

TEST(integers)
{
    uint64_t seed = 4;
    for (int i = 0; i < 500000; i++) {
        uint64_t root = random64(&seed) >> (32 + i % 32);
        check_sqrt64(root * root);
        check_sqrt64(root * root + root);
        check_sqrt64(root * root + root + 1);
        check_sqrt64(root * root - 1);
        check_sqrt64(random64(&seed) >> (i % 64));
        check_sqrt64(UINT64_MAX - (uint64_t)i);
        check_sqrt64(((uint64_t)1 << 62) + (uint64_t)i);
        check_reciprocal((uint32_t)random64(&seed) >> (i & 1));
        check_reciprocal(0x80000000u + (uint32_t)i);
        check_reciprocal(0xFFFFFFFFu - (uint32_t)i);
        check_reciprocal(0xC0000000u + (uint32_t)i - 250000u);
        check_reciprocal(0xB504F334u + (uint32_t)i - 250000u);
        check_reciprocal((uint32_t)random64(&seed) | 0x80000000u);
        uint64_t a = i < 8 ? UINT64_MAX - (uint64_t)(i & 1) : random64(&seed) >> (i % 50);
        uint64_t b = i < 8 ? UINT64_MAX - (uint64_t)(i >> 1) : random64(&seed) >> (i % 37);
        __extension__ unsigned __int128 product = (unsigned __int128)a * b;
        assert_true(library.mul_high64(a, b) == (uint64_t)(product >> 64));
        assert_true(q16_narrow_build.mul_high64(a, b) == (uint64_t)(product >> 64));
    }
    check_sqrt64(0);
    check_reciprocal(0);
    check_reciprocal(1);
    check_reciprocal(0x7FFFFFFFu);
    if (long_run()) {
        for (uint32_t x = 0x80000000u; x != 0; x++) {
            check_reciprocal(x);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
