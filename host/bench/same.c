/* SPDX-License-Identifier: MIT */
/*
 * The matrix and the benchmark scenes in one program, for tests/check/same.sh: a line with a
 * checksum for every picture.
 */
#include <stddef.h>

int draw_matrix(void *memory, size_t bytes);
int draw_scenes(void *memory, size_t bytes);

/* Both are the program of a board. */
#define board_program draw_matrix
#include "matrix_program.c" // NOLINT(bugprone-suspicious-include)
#undef board_program
#define board_program draw_scenes
#include "bench_program.c" // NOLINT(bugprone-suspicious-include)

int main(void)
{
    return draw_matrix(NULL, 0) + draw_scenes(NULL, 0);
}
