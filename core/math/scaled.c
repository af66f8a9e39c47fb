/* SPDX-License-Identifier: MIT */
#include "scaled.h"

#include "../bits/bits.h"

int32_t qtri_scaled(int32_t value, int shift)
{
    if (shift < 0) {
        if (shift <= -32) {
            return 0; /* at least -1/2, less than 1/2 */
        }
        int32_t twice = value >> (-shift - 1);
        return (twice >> 1) + (twice & 1);
    }
    int32_t limit = shift < 32 ? (int32_t)((uint32_t)INT32_MAX >> shift) : 0;
    bool fits = value <= limit && value >= (shift < 32 ? -limit - 1 : 0);
    QTRI_MATH_CHECK(fits);
    return fits ? (int32_t)((uint32_t)value << (shift & 31)) : qtri_extreme32(value);
}
