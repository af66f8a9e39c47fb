/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700 /* M_PI */

#include "demo_waves.h"

#include <math.h>
#include <stdio.h>

#include "../io/file.h"
#include "mesh_generate.h"

enum { COLUMNS = 24, ROWS = 12, FRAMES = 4 };

/* A point of the flag, which is held at its left side, u = 0, and its normal. */
static void write_vertex(FILE *out, double u, double v, double phase)
{
    const double turn = 2.0 * M_PI * (1.25 * u - phase);
    const double x = 2.0 * u - 1.0;
    const double z = .35 * u * sin(turn);
    const double slope = (.35 * sin(turn) + .35 * u * 2.5 * M_PI * cos(turn)) / 2.0; /* dz / dx */
    const double length = sqrt(1.0 + slope * slope);
    fprintf(out, "v %.6f %.6f %.6f\nvn %.6f 0 %.6f\nvt %.6f %.6f\n", x, 1.2 * v - .6, z,
            -slope / length, 1.0 / length, u, v);
}

static void write_wave(FILE *out, double phase)
{
    for (int row = 0; row <= ROWS; row++) {
        for (int column = 0; column <= COLUMNS; column++) {
            write_vertex(out, (double)column / COLUMNS, (double)row / ROWS, phase);
        }
    }
    mesh_write_quads(out, ROWS, COLUMNS);
}

bool demo_write_waves(const char *folder, struct text_error *error)
{
    bool ok = true;
    for (int i = 0; ok && i < FRAMES; i++) {
        char path[1024];
        struct file_output out;
        (void)snprintf(path, sizeof path, "%s/wave-%d.obj", folder, i);
        ok = file_output_open(&out, path, error);
        if (ok) {
            write_wave(out.stream, (double)i / FRAMES);
            ok = file_output_commit(&out, error);
        }
    }
    return ok;
}
