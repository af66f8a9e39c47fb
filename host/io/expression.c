/* SPDX-License-Identifier: MIT */
#include "expression.h"

#include <math.h>
#include <string.h>

#include "number.h"

#define PI 3.14159265358979323846

enum { DEPTH_MAX = 64 }; /* of parentheses and signs */

struct reader {
    const char *begin, *at, *end;
    double t;
    int depth;
    struct expression_error *error;
};

/* A token may hold the NUL that strchr() would find. */
static bool is_one_of(const char *characters, char c)
{
    return c != '\0' && strchr(characters, c) != NULL;
}

bool expression_is(const struct token *token)
{
    for (size_t i = 0; i < token->length; i++) {
        if (is_one_of("$()*/", token->text[i]) || (i > 0 && is_one_of("+-", token->text[i]))) {
            return true;
        }
    }
    return false;
}

static bool fail(struct reader *r, const char *problem)
{
    r->error->column = (size_t)(r->at - r->begin) + 1;
    r->error->problem = problem;
    return false;
}

static bool take(struct reader *r, const char *text)
{
    const size_t length = strlen(text);
    if ((size_t)(r->end - r->at) < length || memcmp(r->at, text, length) != 0) {
        return false;
    }
    r->at += length;
    return true;
}

// NOLINTBEGIN(misc-no-recursion): DEPTH_MAX bounds it
static bool sum(struct reader *r, double *value);

/* "(", and `count` values with commas between, and ")". */
static bool arguments(struct reader *r, double *value, int count)
{
    for (int i = 0; i < count; i++) {
        if (!take(r, i == 0 ? "(" : ",")) {
            return fail(r, i == 0 ? "( is missing" : ", is missing");
        }
        if (!sum(r, &value[i])) {
            return false;
        }
    }
    return take(r, ")") || fail(r, ") is missing");
}

/* Digits, a point, an exponent: as much as can belong to a number. */
static bool number(struct reader *r, double *value)
{
    const char *at = r->at;
    while (at < r->end && is_one_of("0123456789.", *at)) {
        at++;
    }
    if (at > r->at && at < r->end && (*at == 'e' || *at == 'E')) {
        at++;
        at += at < r->end && (*at == '+' || *at == '-');
        while (at < r->end && *at >= '0' && *at <= '9') {
            at++;
        }
    }
    if (at == r->at) {
        return fail(r, at == r->end ? "a value is missing" : "is not understood here");
    }
    if (number_parse_real(r->at, (size_t)(at - r->at), value) != NUMBER_OK) {
        return fail(r, "is not a number");
    }
    r->at = at;
    return true;
}

static bool primary(struct reader *r, double *value)
{
    double v[3];
    if (take(r, "$t")) {
        *value = r->t;
        return true;
    }
    if (take(r, "pi")) {
        *value = PI;
        return true;
    }
    const bool is_sine = take(r, "sin");
    if (is_sine || take(r, "cos")) {
        if (!arguments(r, v, 1)) {
            return false;
        }
        *value = is_sine ? sin(v[0] * PI / 180) : cos(v[0] * PI / 180);
        return true;
    }
    if (take(r, "lerp")) {
        if (!arguments(r, v, 3)) {
            return false;
        }
        *value = v[0] + (v[1] - v[0]) * v[2];
        return true;
    }
    if (r->at < r->end && *r->at == '(') {
        return arguments(r, value, 1);
    }
    return number(r, value);
}

static bool factor(struct reader *r, double *value)
{
    *value = 0;
    if (++r->depth > DEPTH_MAX) {
        return fail(r, "is nested too deep");
    }
    const bool is_negative = take(r, "-");
    const bool ok = is_negative || take(r, "+") ? factor(r, value) : primary(r, value);
    r->depth--;
    *value = ok && is_negative ? -*value : *value;
    return ok;
}

static bool product(struct reader *r, double *value)
{
    if (!factor(r, value)) {
        return false;
    }
    for (;;) {
        double other = 0;
        const bool divides = take(r, "/");
        if (!divides && !take(r, "*")) {
            return true;
        }
        if (!factor(r, &other)) {
            return false;
        }
        if (divides && other == 0) {
            return fail(r, "is divided by 0");
        }
        *value = divides ? *value / other : *value * other;
    }
}

static bool sum(struct reader *r, double *value)
{
    if (!product(r, value)) {
        return false;
    }
    for (;;) {
        double other = 0;
        const bool subtracts = take(r, "-");
        if (!subtracts && !take(r, "+")) {
            return true;
        }
        if (!product(r, &other)) {
            return false;
        }
        *value += subtracts ? -other : other;
    }
}

// NOLINTEND(misc-no-recursion)

bool expression_evaluate(const struct token *token, double t, double *value,
                         struct expression_error *error)
{
    struct reader r = {.begin = token->text,
                       .at = token->text,
                       .end = token->text + token->length,
                       .t = t,
                       .error = error};
    *value = 0;
    if (!sum(&r, value)) {
        return false;
    }
    if (r.at != r.end) {
        return fail(&r, "is not understood here");
    }
    return isfinite(*value) || fail(&r, "has no finite value");
}
