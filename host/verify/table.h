/* SPDX-License-Identifier: MIT */
/*
 * The table of scalar functions. To add one: a line in table.c, and its reference if that is new.
 */
#ifndef QTRI_VERIFY_TABLE_H
#define QTRI_VERIFY_TABLE_H

#include "verify.h"

typedef struct verify_function {
    const char *name;
    /* The one that is not NULL. */
    q16 (*one)(q16);
    q16 (*two)(q16, q16);
    q16 (*three)(q16, q16, q16);
    const verify_reference *reference;
    double limit;
    /* One argument: where the limit holds. On either side the result is one documented constant. */
    q16 low, high;
    const char *domain;
    int monotone; /* 1 rising, -1 falling, 0 neither */
    double relative_from, relative_unit;
    const char *relative_domain;
} verify_function;

extern const verify_function verify_functions[];
extern const size_t verify_function_count;

/* A test of one function; the function must outlive it. */
verify_test verify_scalar_test(const verify_function *function);

#endif
