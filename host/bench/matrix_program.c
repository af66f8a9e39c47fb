/* SPDX-License-Identifier: MIT */
/*
 * The matrix on a board, or on the host: one line for each case,
 *
 *   case hash pixels instructions
 *
 * and `end`. pixels are those that the geometry covers, drawn or not. MATRIX_CASES: patterns of the
 * cases to draw; MATRIX_FULL: 1 for the whole product; MATRIX_EVERY: of these only each such.
 */
#include "../../port/boards/board.h"
#include "bench_core.h"
#include "bench_print.h"
#include "matrix.h"

#ifndef MATRIX_CASES
#define MATRIX_CASES ""
#endif
#ifndef MATRIX_FULL
#define MATRIX_FULL 0
#endif
#ifndef MATRIX_EVERY
#define MATRIX_EVERY 1
#endif

static matrix_frame memory_of_frame;

static void measure(matrix_frame *frame, const matrix_case *now, const char *name, uint32_t pixels)
{
    if (!matrix_prepare(frame, now)) {
        return;
    }
    uint32_t start = board_ticks();
    matrix_draw(frame, now);
    uint32_t instructions = board_instructions(start, board_ticks());
    board_write(name);
    board_write(" ");
    bench_write_number(bench_hash(&frame->surface), 16, 8);
    bench_write_decimal(pixels);
    bench_write_decimal(instructions);
    board_write("\n");
}

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    matrix_frame *frame = &memory_of_frame;
    const matrix_geometry *counted = NULL;
    uint32_t pixels = 0;
    uint32_t number = 0;
    matrix_case now;
    bench_set_up_core();
    matrix_set_textures(frame);
    matrix_first(&now);
    do {
        char name[MATRIX_NAME_MAX];
        matrix_name(&now, name);
        if (number++ % MATRIX_EVERY != 0 || !matrix_matches(MATRIX_CASES, name)) {
            continue;
        }
        if (counted != now.geometry) {
            counted = now.geometry;
            pixels = matrix_pixels(frame, counted);
        }
        measure(frame, &now, name, pixels);
    } while (matrix_next(&now, MATRIX_FULL));
    board_write("end\n");
    return 0;
}
