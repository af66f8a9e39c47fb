/* SPDX-License-Identifier: MIT */
/*
 * The matrix, the benchmark scenes and the random states in one program, for same.sh: a line with a
 * checksum for every picture.
 */
#include <stddef.h>

int draw_matrix(void *memory, size_t bytes);
int draw_scenes(void *memory, size_t bytes);
int draw_states(void *memory, size_t bytes);

/* The matrix by the generic pipeline, which compiles in no time: its own draw the same. */
#define NO_PIPELINES                                                                               \
    {                                                                                              \
        (const qtri_pipeline *)0                                                                   \
    }
#define MATRIX_FULL  1
#define MATRIX_EVERY 9

/* Each is the program of a board. */
#define board_program draw_matrix
#include "../../host/bench/matrix_program.c" // NOLINT(bugprone-suspicious-include)
#undef board_program
#define board_program draw_scenes
#include "../../host/bench/bench_program.c" // NOLINT(bugprone-suspicious-include)
#undef board_program
#define board_program draw_states
#include "same_states.c" // NOLINT(bugprone-suspicious-include)

const qtri_pipeline *const matrix_pipelines_flat[] = NO_PIPELINES;
const qtri_pipeline *const matrix_pipelines_lit[] = NO_PIPELINES;
const qtri_pipeline *const matrix_pipelines_colors[] = NO_PIPELINES;
const qtri_pipeline *const matrix_pipelines_texture[] = NO_PIPELINES;
const qtri_pipeline *const matrix_pipelines_texture_lit[] = NO_PIPELINES;
const qtri_pipeline *const matrix_pipelines_texture_colors[] = NO_PIPELINES;

int main(void)
{
    return draw_matrix(NULL, 0) + draw_scenes(NULL, 0) + draw_states(NULL, 0);
}
