/* SPDX-License-Identifier: MIT */
/*
 * For proofs of what divides without an instruction for it, before all other headers: seeds of
 * reciprocals. Newton's steps are no intervals: math_inputs.c tries each argument.
 */
#ifndef QTRI_TESTS_PROVE_SPECIFIED_H
#define QTRI_TESTS_PROVE_SPECIFIED_H

#include "bits/bits.h"

/*@ requires 32768 <= x <= 65536;
    assigns \result \from x;
    ensures 32767 <= \result <= 65536; */
uint32_t specified_seed(uint32_t x);

#define qtri_reciprocal_seed(x)        specified_seed(x)
#define qtri_reciprocal_seed_newton(x) specified_seed(x)

#endif
