/* SPDX-License-Identifier: MIT */
/*
 * The same program for a machine with a C library: the host, and others by QEMU's user emulation.
 *   math_sums SAMPLES
 */
#include <stdio.h>
#include <stdlib.h>

#include "../../port/boards/board.h"
#include "math_sums.h"

void board_write(const char *text)
{
    fputs(text, stdout);
}

int main(int argc, char **argv)
{
    unsigned long samples = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    if (samples == 0 || samples > UINT32_MAX) {
        fprintf(stderr, "usage: math_sums SAMPLES\n");
        return 2;
    }
    math_sums_write((uint32_t)samples);
    return fflush(stdout) != 0;
}
