/* SPDX-License-Identifier: MIT */
/*
 * For proofs: what products of 32 bits are, where they are no single instruction.
 *
 * Where they are put together from half-words, with a = a1 2^16 + a0 and b likewise,
 *
 *     a b = a1 b1 2^32 + (a1 b0 + a0 b1) 2^16 + a0 b0,
 *
 * what is carried is added as it is, and prove_products() shows that none of the sums overflows.
 */
#ifndef QTRI_TESTS_PROVE_PRODUCTS_H
#define QTRI_TESTS_PROVE_PRODUCTS_H

#include "bits/bits.h"

#if !QTRI_LONG_MULTIPLY && QTRI_SHARE
/*@ assigns \result \from a, b;
    ensures \result == a * b; */
uint64_t qtri_mul_u32(uint32_t a, uint32_t b);

/*@ assigns \result \from a, b;
    ensures \result == a * b; */
int64_t qtri_mul_s32(int32_t a, int32_t b);
#endif

#endif
