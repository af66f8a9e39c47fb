/* SPDX-License-Identifier: MIT */
/*
 * The scalars as a debug build has them; what it would stop at is counted.
 */
#ifndef QTRI_CHECK_MATH
#define QTRI_CHECK_MATH
#endif
#define QTRI_MATH_FAULT q16_checked_fault
#define OTHER(name)     checked_##name
#include "q16_other.inc"

int q16_checked_faults;

void q16_checked_fault(void)
{
    q16_checked_faults++;
}

const q16_build q16_checked_build = Q16_BUILD("checked");
