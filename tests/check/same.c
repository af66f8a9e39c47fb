/* SPDX-License-Identifier: MIT */
/*
 * The matrix, the benchmark scenes and the random states in one program, for same.sh: a line with a
 * checksum for every picture.
 */
#include <stddef.h>

int draw_matrix(void *memory, size_t bytes);
int draw_scenes(void *memory, size_t bytes);
int draw_states(void *memory, size_t bytes);

/* Each is the program of a board. */
#define board_program draw_matrix
#include "../../host/bench/matrix_program.c" // NOLINT(bugprone-suspicious-include)
#undef board_program
#define board_program draw_scenes
#include "../../host/bench/bench_program.c" // NOLINT(bugprone-suspicious-include)
#undef board_program
#define board_program draw_states
#include "same_states.c" // NOLINT(bugprone-suspicious-include)

int main(void)
{
    return draw_matrix(NULL, 0) + draw_scenes(NULL, 0) + draw_states(NULL, 0);
}
