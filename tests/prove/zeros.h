/* SPDX-License-Identifier: MIT */
/*
 * For proofs that need no more of leading zeros than how many there can be, before all other
 * headers: a loop that counts them is no interval. prove_products shows it by their pieces.
 */
#ifndef QTRI_TESTS_PROVE_ZEROS_H
#define QTRI_TESTS_PROVE_ZEROS_H

#include "bits/bits.h"

/*@ assigns \result \from x;
    ensures 0 <= \result <= 32;
    ensures x == 0 || \result <= 31; */
int32_t specified_clz32(uint32_t x);

/*@ assigns \result \from x;
    ensures 0 <= \result <= 64;
    ensures x == 0 || \result <= 63; */
int32_t specified_clz64(uint64_t x);

#define qtri_clz32(x) specified_clz32(x)
#define qtri_clz64(x) specified_clz64(x)

#endif
