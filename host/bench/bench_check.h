/* SPDX-License-Identifier: MIT */
/*
 * The host's pictures of the scenes against the double-precision reference.
 */
#ifndef BENCH_CHECK_H
#define BENCH_CHECK_H

/*
 * Compares every scene's picture, and prints a line for each. FOLDER is where bench_meshes wrote
 * the meshes. Returns the status of a program: 0 when all are right.
 */
int bench_check(const char *folder);

#endif
