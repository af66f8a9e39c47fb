/* SPDX-License-Identifier: MIT */
/*
 * Functions of many arguments or results: what tuple.c tries and length.c and product.c list.
 */
#ifndef QTRI_VERIFY_TUPLE_H
#define QTRI_VERIFY_TUPLE_H

#include "verify.h"

#include "qtri/quat.h"
#include "qtri/vec.h"

#include <string.h>

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

/* Arguments from `a` on as what functions take, and the `call` of one: its result as scalars. */
#define VEC2(a) (*(const qtri_vec2 *)(const void *)(a))
#define VEC3(a) (*(const qtri_vec3 *)(const void *)(a))
#define VEC4(a) (*(const qtri_vec4 *)(const void *)(a))
#define QUAT(a) (*(const qtri_quat *)(const void *)(a))
#define CALL(name, type, expression)                                                               \
    static void name(const q16 *a, q16 *r)                                                         \
    {                                                                                              \
        const type result = expression;                                                            \
        memcpy(r, &result, sizeof result);                                                         \
    }

verify_test verify_tuple_test(const verify_tuple *tuple);

extern const verify_tuple verify_lengths[];
extern const size_t verify_length_count;

extern const verify_tuple verify_products[];
extern const size_t verify_product_count;

#endif
