/* SPDX-License-Identifier: MIT */
/*
 * The scalars compiled for a core without a long multiply and without a division.
 */
#define QTRI_LONG_MULTIPLY 0
#define QTRI_DIVIDE        0
#define OTHER(name)        narrow_##name
#include "q16_other.inc"

const q16_build q16_narrow_build = Q16_BUILD("narrow");
