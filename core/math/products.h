/*
 * Sums of Q16.16 products that cannot overflow and round once. Internal.
 */
#ifndef QTRI_MATH_PRODUCTS_H
#define QTRI_MATH_PRODUCTS_H

#include "bits.h"

/* high 2^16 + low, in Q32: four products of INT32_MIN with itself would not fit 64 bits. */
typedef struct qtri_products {
    int64_t high;
    uint32_t low; /* sums up to 2^16 products of 16 bits */
} qtri_products;

static inline void qtri_products_add(qtri_products *sum, int32_t a, int32_t b)
{
    int64_t product = (int64_t)a * b;
    sum->high += product >> 16;
    sum->low += (uint32_t)product & 0xFFFFu;
}

static inline void qtri_products_subtract(qtri_products *sum, int32_t a, int32_t b)
{
    int64_t product = -((int64_t)a * b);
    sum->high += product >> 16;
    sum->low += (uint32_t)product & 0xFFFFu;
}

/* The sum in Q16.16, to nearest, saturated. */
static inline int32_t qtri_products_q16(const qtri_products *sum)
{
    return qtri_saturate32(sum->high + (int64_t)((sum->low + 0x8000u) >> 16));
}

#endif
