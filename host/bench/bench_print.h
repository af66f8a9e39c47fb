/* SPDX-License-Identifier: MIT */
/*
 * Numbers on a board's console.
 */
#ifndef BENCH_PRINT_H
#define BENCH_PRINT_H

#include <stdint.h>

/* In base 2..16, with zeros in front up to so many digits. */
void bench_write_number(uint32_t value, uint32_t base, uint32_t least_digits);

/* A space and the number. */
void bench_write_decimal(uint32_t value);

#endif
