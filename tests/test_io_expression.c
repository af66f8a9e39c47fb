/* SPDX-License-Identifier: MIT */
/*
 * Expressions of $t, and scenes that have them.
 */
#define _POSIX_C_SOURCE 200809L
#include "support/io.h"

#include <math.h>

#include "io/expression.h"
#include "io/scene.h"

static struct token token_of(const char *text)
{
    const struct token token = {text, strlen(text)};
    return token;
}

TEST(values)
{
    static const struct {
        const char *text;
        double value; /* at t = .25 */
    } cases[] = {
        {"$t", .25},
        {"360*$t", 90},
        {"1-$t", .75},
        {"1-$t-.5", .25},
        {"2*3+4*5", 26},
        {"2*(3+4)*5", 70},
        {"-(1+2)", -3},
        {"--1", 1},
        {"2*-$t", -.5},
        {"8/4/2", 1},
        {"1e2+2.5E+1", 125},
        {"1e-2*100", 1},
        {"sin(30)", .5},
        {"cos(240*$t)", .5},
        {"sin(90)*pi", 3.14159265358979},
        {"lerp(10,20,$t)", 12.5},
        {"lerp(0,lerp(0,8,.5),1)", 4},
        {"((((((1))))))", 1},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        const struct token token = token_of(cases[i].text);
        struct expression_error error = {0, ""};
        double value = -1;
        if (!expression_evaluate(&token, .25, &value, &error) ||
            fabs(value - cases[i].value) > 1e-12) {
            fail_msg("%s: %g, not %g; %s", cases[i].text, value, cases[i].value, error.problem);
        }
    }
}

TEST(errors)
{
    static const struct {
        const char *text;
        size_t column;
        const char *problem;
    } cases[] = {
        {"", 1, "a value is missing"},
        {"1+", 3, "a value is missing"},
        {"1+*2", 3, "is not understood here"},
        {"$x", 1, "is not understood here"},
        {"2*$t)", 5, "is not understood here"},
        {"(2*$t", 6, ") is missing"},
        {"sin2", 4, "( is missing"},
        {"lerp(1,2)", 9, ", is missing"},
        {"lerp(1,2,3,4)", 11, ") is missing"},
        {"1.2.3", 1, "is not a number"},
        {"1e+*2", 1, "is not a number"},
        {"1/(1-1)", 8, "is divided by 0"},
        {"1e30*1e30*1e30*1e30*1e30*1e30*1e30*1e30*1e30*1e30*1e30", 55, "has no finite value"},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        const struct token token = token_of(cases[i].text);
        struct expression_error error = {0, ""};
        double value;
        if (expression_evaluate(&token, 0, &value, &error) || error.column != cases[i].column ||
            strcmp(error.problem, cases[i].problem) != 0) {
            fail_msg("%s: column %zu, %s", cases[i].text, error.column, error.problem);
        }
    }
}

/* As many parentheses and signs as a line may hold end with a message. */
TEST(nests_only_so_deep)
{
    char text[100001];
    const char *const opening = "(-";
    for (int kind = 0; kind < 2; kind++) {
        memset(text, opening[kind], sizeof text - 1);
        text[sizeof text - 1] = '\0';
        const struct token token = token_of(text);
        struct expression_error error = {0, ""};
        double value;
        assert_false(expression_evaluate(&token, 0, &value, &error));
        assert_string_equal(error.problem, "is nested too deep");
    }
}

TEST(scenes_at_a_time)
{
    const char *path = io_write_text("s", "viewport 4*8 33-1\nrotate 360*$t 0 1 0\n"
                                          "clear lerp(0,1,$t) 1-$t .5\n");
    for (int i = 0; i <= 4; i++) {
        const struct scene_reading how = {.time = i / 4.0};
        struct scene scene;
        struct text_error error;
        assert_true(scene_read_as(path, &how, &scene, &error));
        assert_int_equal(scene.width, 32);
        assert_int_equal(scene.height, 32);
        assert_int_equal(scene.ops[0].u.number[0], 90 * i * ONE);
        assert_int_equal(scene.clear[0], i * ONE / 4);
        assert_int_equal(scene.clear[1], (4 - i) * ONE / 4);
        scene_free(&scene);
    }
}

TEST(scene_errors)
{
    static const char *const cases[][2] = {
        {"rotate  5*$x 0 1 0", ":1: rotate: '5*$x' is not understood here (column 11)"},
        {"clear 2*$t+1.5 0 0", ":1: clear: '2*$t+1.5' does not lie in 0..1"},
        {"translate 200*200 0 0", ":1: translate: '200*200' does not fit Q16.16"},
        {"viewport 1/0 4", ":1: viewport: '1/0' is divided by 0 (column 13)"},
        {"viewport 5000*1 4", ":1: viewport: '5000*1' is not a whole number in 1..4096"},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        struct scene scene;
        struct text_error error;
        assert_false(scene_read(io_write_text("s", cases[i][0]), &scene, &error));
        if (strstr(error.message, cases[i][1]) == NULL) {
            fail_msg("%s", error.message);
        }
    }
}

int main(void)
{
    return run_all_tests(io_setup, io_teardown);
}
