/* SPDX-License-Identifier: MIT */
/*
 * Functions of many arguments or results: what tuple.c tries and length.c and product.c list.
 */
#ifndef QTRI_VERIFY_TUPLE_H
#define QTRI_VERIFY_TUPLE_H

#include "verify.h"

typedef struct verify_tuple {
    const char *name;
    int arguments, results;
    void (*call)(const q16 *argument, q16 *result);
    /* In ULP; false where the result is a matter of convention. */
    bool (*reference)(const struct verify_tuple *self, const q16 *argument, long double *value);
    void (*prepare)(q16 *argument); /* or NULL: makes random arguments valid ones */
    double limit;
    bool all_correct, unit; /* unit: the result's length is to be 1, within 2 ULP */
} verify_tuple;

extern const verify_tuple verify_lengths[];
extern const size_t verify_length_count;

extern const verify_tuple verify_products[];
extern const size_t verify_product_count;

#endif
