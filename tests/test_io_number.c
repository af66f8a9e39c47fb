/* SPDX-License-Identifier: MIT */
/*
 * Decimal text to Q16.16, integers, lines and tokens.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include "io/lines.h"
#include "io/number.h"

/* ---- Q16.16 ---- */

static enum number_result parse(const char *text, size_t length, int32_t *value)
{
    char *copy = exact_copy(text, length);
    enum number_result result = number_parse_q16(copy, length, value);
    free(copy);
    return result;
}

static void assert_q16(const char *text, int32_t expected)
{
    int32_t value = 12345;
    enum number_result result = parse(text, strlen(text), &value);
    if (result != NUMBER_OK || value != expected) {
        fail_msg("%s: %s, 0x%08lx instead of 0x%08lx", text, number_problem(result),
                 (unsigned long)(uint32_t)value, (unsigned long)(uint32_t)expected);
    }
}

static void assert_refused(const char *text, enum number_result expected)
{
    int32_t value = 12345;
    enum number_result result = parse(text, strlen(text), &value);
    if (result != expected || value != 12345) {
        fail_msg("'%s' gave result %d, value %ld", text, (int)result, (long)value);
    }
}

TEST(plain_decimals)
{
    assert_q16("0", 0);
    assert_q16("-0", 0);
    assert_q16("-0.0", 0);
    assert_q16("1", ONE);
    assert_q16("+1", ONE);
    assert_q16("-1", -ONE);
    assert_q16("1.", ONE);
    assert_q16(".5", ONE / 2);
    assert_q16("-.5", -ONE / 2);
    assert_q16("0.1", 6554); /* 6553.6 */
    assert_q16("0.30000001", 19661);
    assert_q16("60", 60 * ONE);
    assert_q16("0000000000000000000000012.25", 12 * ONE + ONE / 4);
    assert_q16("3.14159265358979323846", 205887);
}

TEST(exponents)
{
    assert_q16("1e-3", 66); /* 65.536 */
    assert_q16("2.5E+4", 25000 * ONE);
    assert_q16("2.5e4", 25000 * ONE);
    assert_q16("250000e-4", 25 * ONE);
    assert_q16("0.000025e6", 25 * ONE);
    assert_q16("0e999999999999999999999999", 0);
    assert_q16("1e-999999999999999999999999", 0);
    assert_q16("1e0000000000000000000000001", 10 * ONE);
    assert_q16("000.0000000000000000000000000000001e31", ONE);
    assert_refused("1e99", NUMBER_OUT_OF_RANGE);
    assert_refused("1e999999999999999999999999", NUMBER_OUT_OF_RANGE);
    assert_refused("-1e9223372036854775807", NUMBER_OUT_OF_RANGE);
}

/* 2^-17 is half a unit: 7.62939453125e-6 exactly. */
TEST(ties_go_away_from_zero)
{
    assert_q16("0.00000762939453125", 1);
    assert_q16("-0.00000762939453125", -1);
    assert_q16("0.00000762939453124", 0);
    assert_q16("0.0000076293945312499999999999999999999999999999999999", 0);
    assert_q16("-0.0000076293945312499999999999999999999999999999999999", 0);
    assert_q16("0.0000076293945312500000000000000000000000000000000001", 1);
    assert_q16("7.62939453125e-6", 1);
    assert_q16("762939453125e-17", 1);
    assert_q16("0.00002288818359375", 2); /* 1.5 units */
    assert_q16("-0.00002288818359375", -2);
    assert_q16("0.00002288818359374999", 1);
    assert_q16("1.00000762939453125", ONE + 1);
    assert_q16("1.00000762939453124", ONE);
}

TEST(ends_of_the_range)
{
    assert_q16("32767.9999847412109375", INT32_MAX);
    assert_q16("32767.9999923706054687499999", INT32_MAX);
    assert_refused("32767.99999237060546875", NUMBER_OUT_OF_RANGE); /* the tie */
    assert_refused("32768", NUMBER_OUT_OF_RANGE);
    assert_q16("-32768", INT32_MIN);
    assert_q16("-32768.0000076293945312499999", INT32_MIN);
    assert_refused("-32768.00000762939453125", NUMBER_OUT_OF_RANGE);
    assert_refused("99999999999", NUMBER_OUT_OF_RANGE);
    assert_refused("65536", NUMBER_OUT_OF_RANGE);
    assert_refused("4294967296", NUMBER_OUT_OF_RANGE);
    assert_refused("18446744073709551616", NUMBER_OUT_OF_RANGE);
    assert_refused("-281474976710656", NUMBER_OUT_OF_RANGE);
}

TEST(malformed_numbers)
{
    const char *const texts[] = {"",     "+",     "-",    ".",     "-.",  "e5",   ".e5",  "1e",
                                 "1e+",  "1e1.5", "1.2.", "1..2",  "--1", "+-1",  "1-",   "nan",
                                 "inf",  "-inf",  "0x10", "0x1p4", "1f",  "1,5",  "1 ",   " 1",
                                 "1e5x", "1d3",   "NaN",  "1e--3", "1_0", "1\t2", "1e 3", "/1"};
    for (size_t i = 0; i < ARRAY_LENGTH(texts); i++) {
        assert_refused(texts[i], NUMBER_MALFORMED);
    }
    int32_t value;
    assert_int_equal(parse("1\0", 2, &value), NUMBER_MALFORMED);
    assert_int_equal(parse("\xB1", 1, &value), NUMBER_MALFORMED);
}

/* Every Q16.16 multiple of a step, printed exactly, comes back; and half a unit beside it too. */
TEST(exact_decimals_come_back)
{
    for (int64_t q = INT32_MIN; q <= INT32_MAX; q += 65521 * 3) {
        char text[64];
        uint64_t magnitude = (uint64_t)(q < 0 ? -q : q);
        /* fraction / 2^16 = fraction * 5^16 / 10^16 */
        uint64_t fraction = (magnitude & 0xFFFF) * UINT64_C(152587890625);
        (void)snprintf(text, sizeof text, "%s%lu.%016lu", q < 0 ? "-" : "",
                       (unsigned long)(magnitude >> 16), (unsigned long)fraction);
        assert_q16(text, (int32_t)q);
        /* half a unit further is a tie: 5^16 * 10 / 2 more in the 17th place */
        (void)snprintf(text, sizeof text, "%s%lu.%017lu", q < 0 ? "-" : "",
                       (unsigned long)(magnitude >> 16),
                       (unsigned long)(fraction * 10 + UINT64_C(762939453125)));
        if (q > INT32_MIN) {
            assert_q16(text, (int32_t)(q < 0 ? q - 1 : q + 1));
        }
    }
}

TEST(million_digits)
{
    const size_t length = 1000000;
    char *text = malloc(length);
    int32_t value;
    assert_non_null(text);
    memset(text, '0', length);
    text[length - 1] = '7';
    assert_int_equal(number_parse_q16(text, length, &value), NUMBER_OK);
    assert_int_equal(value, 7 * ONE);
    memset(text, '9', length);
    assert_int_equal(number_parse_q16(text, length, &value), NUMBER_OUT_OF_RANGE);
    text[1] = '.';
    assert_int_equal(number_parse_q16(text, length, &value), NUMBER_OK);
    assert_int_equal(value, 10 * ONE);
    free(text);
}

TEST(integers)
{
    int64_t value = 0;
    assert_int_equal(number_parse_integer("42", 2, 1, 42, &value), NUMBER_OK);
    assert_int_equal(value, 42);
    assert_int_equal(number_parse_integer("-7", 2, -7, 0, &value), NUMBER_OK);
    assert_int_equal(value, -7);
    assert_int_equal(number_parse_integer("+0005", 5, 0, 9, &value), NUMBER_OK);
    assert_int_equal(value, 5);
    assert_int_equal(number_parse_integer("43", 2, 1, 42, &value), NUMBER_OUT_OF_RANGE);
    assert_int_equal(number_parse_integer("0", 1, 1, 42, &value), NUMBER_OUT_OF_RANGE);
    assert_int_equal(
        number_parse_integer("18446744073709551617", 20, 0, INT64_C(100000000000000000), &value),
        NUMBER_OUT_OF_RANGE);
    assert_int_equal(number_parse_integer("-99999999999999999999", 21, 0, 5, &value),
                     NUMBER_OUT_OF_RANGE);
    assert_int_equal(value, 5);
    const char *const malformed[] = {"", "-", "+", "1.0", "1e2", "0x1", "1 ", " 1", "a"};
    for (size_t i = 0; i < ARRAY_LENGTH(malformed); i++) {
        assert_int_equal(number_parse_integer(malformed[i], strlen(malformed[i]), -9, 9, &value),
                         NUMBER_MALFORMED);
    }
}

/* ---- Lines ---- */

/* Writes lines as "NUMBER:token|token;" so that one string shows what the reader saw. */
static void describe(const char *text, size_t length, bool continuations, char *out, size_t size)
{
    struct line_reader reader;
    struct line line;
    struct token token;
    char *copy = exact_copy(text, length);
    size_t used = 0;
    out[0] = '\0';
    lines_begin(&reader, copy, length, continuations);
    while (lines_next(&reader, &line)) {
        used += (size_t)snprintf(out + used, size - used, "%d:", line.number);
        while (line_token(&line, &token)) {
            char quoted[TOKEN_QUOTE_SIZE];
            used += (size_t)snprintf(out + used, size - used, "%s|", token_quote(&token, quoted));
        }
        used += (size_t)snprintf(out + used, size - used, ";");
    }
    free(copy);
}

static void assert_lines(const char *text, size_t length, bool continuations, const char *expected)
{
    char seen[1000];
    describe(text, length, continuations, seen, sizeof seen);
    assert_string_equal(seen, expected);
}

#define LITERAL(text) text, sizeof(text) - 1

TEST(lines_and_tokens)
{
    assert_lines(LITERAL(""), false, "");
    assert_lines(LITERAL("\n"), false, "1:;");
    assert_lines(LITERAL("a b\nc"), false, "1:a|b|;2:c|;");
    assert_lines(LITERAL("a b\r\n\r\n c \r\n"), false, "1:a|b|;2:;3:c|;");
    assert_lines(LITERAL("a#b c\n#\n d # e # f\n#g"), false, "1:a|;2:;3:d|;4:;");
    assert_lines(LITERAL("\ta\t\tb\v\f\n"), false, "1:a|b|;");
    assert_lines(LITERAL("\xEF\xBB\xBF"
                         "a\n"),
                 false, "1:a|;");
    assert_lines(LITERAL("a\0b c\n\0\n"), false, "1:a?b|c|;2:?|;");
    assert_lines(LITERAL("\x1B[2J\xC3\xA4"), false, "1:?[2J??|;");
}

TEST(continued_lines)
{
    assert_lines(LITERAL("a \\\nb\nc"), true, "1:a|b|;3:c|;");
    assert_lines(LITERAL("a \\\r\n b\\\r\nc\r\nd"), true, "1:a|b|c|;4:d|;");
    assert_lines(LITERAL("a \\\nb\n"), false, "1:a|\\|;2:b|;");
    assert_lines(LITERAL("# a \\\nb\n"), true, "1:;2:b|;");
    assert_lines(LITERAL("\\\n\\\n"), true, "1:;");
    assert_lines(LITERAL("a\\b \\"), true, "1:a\\b|\\|;");
    assert_lines(LITERAL("\\\r\\\n\n"), true, "1:\\|;");
}

TEST(long_tokens_are_cut_in_quotes)
{
    char text[100];
    char quoted[TOKEN_QUOTE_SIZE];
    memset(text, 'x', sizeof text);
    struct token token = {text, 40};
    assert_int_equal(strlen(token_quote(&token, quoted)), 40);
    token.length = 41;
    assert_string_equal(token_quote(&token, quoted), "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...");
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
