/* SPDX-License-Identifier: MIT */
/*
 * Numbers as decimal text: exact rounding, shortest text, every value there and back.
 */
#include "support/core.h"

static void check_round_trip(q16 x)
{
    char text[QTRI_Q16_TEXT_SIZE];
    q16 back = 1;
    int32_t length = q16_to_string(x, text, sizeof text);
    if (length < 1 || text[length] != '\0' || q16_from_string(text, &back) != length || back != x) {
        fail_msg("%d: \"%s\" is %d", (int)x, text, (int)back);
    }
}

/* Nothing shorter, rounded down or up, reads as the same. */
static void check_shortest(q16 x)
{
    char text[QTRI_Q16_TEXT_SIZE];
    int32_t length = q16_to_string(x, text, sizeof text);
    const char *point = strchr(text, '.');
    if (point == NULL) {
        return;
    }
    int places = (int)(text + length - point) - 1;
    assert_in_range(places, 1, 5);
    double power = pow(10, places - 1);
    for (int up = 0; up <= 1; up++) {
        char shorter[32];
        q16 back = 0;
        double decimal = (floor(real(x) * power) + up) / power; /* rounded in its 53rd bit only */
        snprintf(shorter, sizeof shorter, "%.*f", places - 1, decimal);
        if (q16_from_string(shorter, &back) > 0 && back == x) {
            fail_msg("\"%s\" could be \"%s\"", text, shorter);
        }
    }
    /* None with as many digits is nearer; 0.015625 has two that are as near. */
    char nearest[32];
    snprintf(nearest, sizeof nearest, "%.*f", places, real(x));
    double off = fabs(strtod(text, NULL) - real(x));
    assert_true(off <= fabs(strtod(nearest, NULL) - real(x)) + 1e-10);
}

TEST(round_trips)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < count; i++) {
        check_round_trip(value[i]);
        check_shortest(value[i]);
    }
    for (int32_t fraction = -70000; fraction <= 70000; fraction++) { /* every fraction */
        check_round_trip(fraction);
        check_shortest(fraction);
        check_round_trip(INT32_MAX - 70000 + fraction);
        check_round_trip(INT32_MIN + 70000 + fraction);
    }
    if (long_run()) {
        for (int64_t x = INT32_MIN; x <= INT32_MAX; x++) {
            check_round_trip((q16)x);
        }
    } else {
        for (int64_t x = INT32_MIN; x <= INT32_MAX; x += 4093) {
            check_round_trip((q16)x);
        }
    }
}

static void check_text(const char *text, int32_t length, q16 expected)
{
    q16 x = 12345;
    int32_t got = q16_from_string(text, &x);
    if (got != length || x != expected) {
        fail_msg("\"%s\": %d characters, %d", text, (int)got, (int)x);
    }
}

TEST(reads)
{
    check_text("0", 1, 0);
    check_text("-0", 2, 0);
    check_text("+1.5", 4, Q16(1.5));
    check_text("-.5", 3, Q16(-0.5));
    check_text("3.", 2, Q16(3));
    check_text("00007.5000000000000000000000000000000000000000000000", 52, Q16(7.5));
    check_text("1.70710678", 10, 111877);
    check_text("2.5rest", 3, Q16(2.5));
    check_text("1e3", 1, Q16(1));
    check_text("1.2.3", 3, 78643);
    check_text("1-", 1, Q16(1));
    /* Halves of a unit: 2^-17, and a digit less or more far behind. */
    check_text("0.00000762939453125", 19, 1);
    check_text("-0.00000762939453125", 20, -1);
    check_text("0.000007629394531249999999999999999999", 38, 0);
    check_text("0.00000762939453125000000000000000000001", 40, 1);
    check_text("0.00002288818359375", 19, 2); /* 1.5 units */
    check_text("0.99999237060546875", 19, Q16(1));
    check_text("0.999992370605468749", 20, Q16(1) - 1);
    /* The ends of the range. */
    check_text("32767.99999", 11, INT32_MAX);
    check_text("32767.99999237060546874", 23, INT32_MAX);
    check_text("-32768", 6, INT32_MIN);
    check_text("-32768.00000762939453124", 24, INT32_MIN);
    check_text("32767.99999237060546875", QTRI_ERROR_SIZE, INT32_MAX);
    check_text("32768", QTRI_ERROR_SIZE, INT32_MAX);
    check_text("-32768.00000762939453125", QTRI_ERROR_SIZE, INT32_MIN);
    check_text("-32769", QTRI_ERROR_SIZE, INT32_MIN);
    check_text("4294967296", QTRI_ERROR_SIZE, INT32_MAX);
    check_text("-99999999999999999999999999999999999999", QTRI_ERROR_SIZE, INT32_MIN);
    check_text("65536.5", QTRI_ERROR_SIZE, INT32_MAX);
    static const char *const none[] = {"",    "-",   "+",  ".",  "-.", "abc", " 1",
                                       "--1", "+-1", "e5", ",5", "/",  ":"};
    for (size_t i = 0; i < LENGTH_OF(none); i++) {
        check_text(none[i], 0, 12345);
    }
}

/* Random digits against exact arithmetic, halves away from zero. */
TEST(reads_any_digits)
{
    uint64_t seed = 31;
    for (int i = 0; i < 300000; i++) {
        char text[64];
        int places = random_in(&seed, 0, 24);
        int128 power = 1;
        int128 whole = random_in(&seed, 0, 32766);
        int128 fraction = 0;
        bool negative = random_flag(&seed);
        /* A half of a unit has 17 places; then a digit is changed. */
        int64_t half = (int64_t)random_in(&seed, 0, 65535) * 2 + 1;
        bool tie = random_in(&seed, 0, 3) == 0;
        int changed = random_in(&seed, 0, 30);
        places = tie ? (places < 17 ? 17 : places) : places;
        int length = snprintf(text, sizeof text, "%s%d%s", negative ? "-" : "", (int)whole,
                              places > 0 ? "." : "");
        for (int k = 0; k < places; k++) {
            int digit = random_in(&seed, 0, 9);
            if (tie) {
                half *= 10;
                digit = (int)(half >> 17);
                half &= (1 << 17) - 1;
                digit = k == changed ? (digit + 1) % 10 : digit;
            }
            text[length++] = (char)('0' + digit);
            fraction = fraction * 10 + digit;
            power *= 10;
        }
        text[length] = '\0';
        int128 size = ((whole * power + fraction) * 131072 + power) / (2 * power);
        check_text(text, length, (q16)(negative ? -size : size));
    }
}

TEST(writes)
{
    static const struct {
        q16 x;
        const char *text;
    } known[] = {{0, "0"},
                 {Q16(3), "3"},
                 {Q16(-1.5), "-1.5"},
                 {Q16(0.1), "0.1"},
                 {1, "0.00002"},
                 {-1, "-0.00002"},
                 {2, "0.00003"},
                 {Q16(1) - 1, "0.99998"},
                 {INT32_MAX, "32767.99998"},
                 {INT32_MIN, "-32768"},
                 {INT32_MIN + 1, "-32767.99998"},
                 {Q16(1.70710678), "1.7071"}};
    for (size_t i = 0; i < LENGTH_OF(known); i++) {
        char text[QTRI_Q16_TEXT_SIZE + 2];
        size_t length = strlen(known[i].text);
        for (size_t size = 0; size <= sizeof text; size++) { /* too small, fitting, roomy */
            memset(text, '#', sizeof text);
            int32_t got = q16_to_string(known[i].x, text, size);
            if (size > length) {
                assert_int_equal(got, length);
                assert_string_equal(text, known[i].text);
            } else {
                assert_int_equal(got, QTRI_ERROR_MEMORY);
                assert_true(size == 0 || text[0] == '\0');
            }
            for (size_t k = size; k < sizeof text; k++) {
                assert_int_equal(text[k], '#');
            }
        }
    }
    char text[QTRI_Q16_TEXT_SIZE];
    assert_int_equal(q16_to_string(INT32_MIN + 1, text, sizeof text), QTRI_Q16_TEXT_SIZE - 1);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
