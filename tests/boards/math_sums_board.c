/* SPDX-License-Identifier: MIT */
/*
 * The program of a board: MATH_SUMS_SAMPLES samples of every function.
 */
#include "../../port/boards/board.h"
#include "math_sums.h"

#ifndef MATH_SUMS_SAMPLES
#define MATH_SUMS_SAMPLES 100000u
#endif

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    math_sums_write(MATH_SUMS_SAMPLES);
    return 0;
}
