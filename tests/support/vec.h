/* SPDX-License-Identifier: MIT */
/*
 * What the tests of vectors, matrices and quaternions share.
 */
#ifndef QTRI_TESTS_SUPPORT_VEC_H
#define QTRI_TESTS_SUPPORT_VEC_H

#include "core.h"
#include "vec_narrow.h"

/* Of any size, with extremes among them. */
static inline qtri_vec3 random_vec3(uint64_t *seed)
{
    int shift = random_in(seed, 0, 30);
    qtri_vec3 v = {random_bits32(seed) >> shift, random_bits32(seed) >> shift,
                   random_bits32(seed) >> shift};
    if (random_in(seed, 0, 15) == 0) {
        v.x = INT32_MIN;
    }
    if (random_in(seed, 0, 15) == 0) {
        v.y = random_flag(seed) ? INT32_MIN : INT32_MAX;
    }
    return v;
}

#endif
