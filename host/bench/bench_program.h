/* SPDX-License-Identifier: MIT */
/*
 * What the program of the boards and the host's own share.
 */
#ifndef BENCH_PROGRAM_H
#define BENCH_PROGRAM_H

#include "bench_scenes.h"

/* The frame that every scene is drawn into, one after the other. */
extern bench_frame bench_memory;

/* Pixels that were drawn; all of them for S0. */
uint32_t bench_pixels(const bench_frame *frame);

/*
 * Compares every scene's picture, and prints a line for each. FOLDER is where bench_meshes wrote
 * the meshes. Returns the status of a program: 0 when all are right.
 */
int bench_check(const char *folder);

#endif
