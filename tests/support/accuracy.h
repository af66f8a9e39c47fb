/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_SUPPORT_ACCURACY_H
#define QTRI_TESTS_SUPPORT_ACCURACY_H

#include "tools/accuracy.h"

/* 100,000 count / of, 0 for nothing of nothing. */
static inline double accuracy_per_100k(uint64_t count, uint64_t of)
{
    return of == 0 ? 0.0 : 1e5 * (double)count / (double)of;
}

#endif
