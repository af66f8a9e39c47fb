/* SPDX-License-Identifier: MIT */
/*
 * Expressions of the debug build (math_checked.c), with and without a result.
 */
#ifndef QTRI_TESTS_SUPPORT_MATH_CHECKED_H
#define QTRI_TESTS_SUPPORT_MATH_CHECKED_H

#include <stddef.h>

typedef struct math_checked_case {
    const char *name;
    void (*sound)(void);  /* is not to stop */
    void (*faulty)(void); /* is to */
} math_checked_case;

extern const math_checked_case math_checked_cases[]; /* ends with a NULL */

#endif
