/* SPDX-License-Identifier: MIT */
#include "wide.h"

qtri_wide qtri_wide_make(int64_t m, int32_t e)
{
    qtri_wide result;
    qtri_wide_set(&result, m, e);
    return result;
}

qtri_wide qtri_wide_neg(qtri_wide a)
{
    a.m = -a.m;
    return a;
}

qtri_wide qtri_wide_add(qtri_wide a, qtri_wide b)
{
    qtri_wide_add_to(&a, &b);
    return a;
}

qtri_wide qtri_wide_sub(qtri_wide a, qtri_wide b)
{
    b.m = -b.m;
    qtri_wide_add_to(&a, &b);
    return a;
}

qtri_wide qtri_wide_mul(qtri_wide a, qtri_wide b)
{
    qtri_wide_mul_by(&a, &b);
    return a;
}

qtri_wide qtri_wide_div(qtri_wide a, qtri_wide b)
{
    qtri_wide_div_by(&a, &b);
    return a;
}
