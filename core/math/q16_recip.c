/* SPDX-License-Identifier: MIT */
/*
 * Divisions under other names; apart from q16_div, which they would be made copies of.
 */
#include "qtri/q16.h"

q16 q16_from_ratio(int32_t numerator, int32_t denominator)
{
    return q16_div(numerator, denominator);
}

q16 q16_recip(q16 x)
{
    return x == 0 ? q16_div(1, 0) : q16_div(Q16_ONE, x);
}
