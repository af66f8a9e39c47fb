/* SPDX-License-Identifier: MIT */
/*
 * Expressions of one variable, $t: decimal numbers, + - * /, parentheses, pi, sin(degrees),
 * cos(degrees), lerp(from, to, share). No white space: an expression is one token of a scene file.
 */
#ifndef QTRI_HOST_IO_EXPRESSION_H
#define QTRI_HOST_IO_EXPRESSION_H

#include <stdbool.h>
#include <stddef.h>

#include "lines.h"

struct expression_error {
    size_t column; /* of the token, from 1 */
    const char *problem;
};

/* Whether a token that is no number looks like an expression: it has an operator or a variable. */
bool expression_is(const struct token *token);

/* Its value with $t = t, which is finite; false with *error set. */
bool expression_evaluate(const struct token *token, double t, double *value,
                         struct expression_error *error);

#endif
