/* SPDX-License-Identifier: MIT */
/*
 * The host as one more board of the benchmark:
 *
 *   bench_host                the lines that the boards must reproduce
 *   bench_host check FOLDER   compares every picture with the double-precision reference;
 *                             FOLDER is where bench_meshes wrote the meshes
 *   bench_host time           microseconds per draw call, a line `scene median least` for each
 * scene
 */
#define _POSIX_C_SOURCE 199309L /* clock_gettime */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../port/boards/board.h"
#include "bench_program.h"

/* ---- Time ---- */

#define BATCHES            25
#define BATCH_NANOSECONDS  4e6
#define CALIBRATION_CALLS  8
#define NANOSECONDS_SECOND 1e9

static double nanoseconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now); /* not what other programs take meanwhile */
    return (double)now.tv_sec * NANOSECONDS_SECOND + (double)now.tv_nsec;
}

/* The time of `calls` draws; the clear before each is not counted. */
static double time_batch(const bench_scene *scene, int calls)
{
    double spent = 0.0;
    for (int i = 0; i < calls; i++) {
        bench_prepare(&bench_memory, scene);
        double start = nanoseconds();
        bench_draw(&bench_memory);
        spent += nanoseconds() - start;
    }
    return spent;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a;
    double y = *(const double *)b;
    return (x > y) - (x < y);
}

static int measure(void)
{
    for (const bench_scene *scene = bench_scenes; scene->name != NULL; scene++) {
        double batch[BATCHES];
        if (!bench_prepare(&bench_memory, scene)) {
            continue;
        }
        double call = time_batch(scene, CALIBRATION_CALLS) / CALIBRATION_CALLS;
        int calls = 1 + (int)(BATCH_NANOSECONDS / (call > 1.0 ? call : 1.0));
        for (int i = 0; i < BATCHES; i++) {
            batch[i] = time_batch(scene, calls) / calls;
        }
        qsort(batch, BATCHES, sizeof batch[0], by_value);
        printf("%s %.2f %.2f\n", scene->name, batch[BATCHES / 2] / 1e3, batch[0] / 1e3);
    }
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 1) {
        return board_program(NULL, 0);
    }
    if (argc == 3 && strcmp(argv[1], "check") == 0) {
        return bench_check(argv[2]);
    }
    if (argc == 2 && strcmp(argv[1], "time") == 0) {
        return measure();
    }
    fprintf(stderr, "usage: bench_host [check FOLDER | time]\n");
    return 2;
}
