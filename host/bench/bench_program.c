/* SPDX-License-Identifier: MIT */
/*
 * The program of a board: one line for each scene,
 *
 *   scene hash pixels triangles instructions
 *
 * and `end`.
 */
#include "bench_program.h"

#include "../../port/boards/board.h"
#include "bench_core.h"
#include "bench_print.h"

bench_frame bench_memory;

uint32_t bench_pixels(const bench_frame *frame)
{
    uint32_t count = 0;
    for (int32_t y = 0; y < frame->surface.rows; y++) {
        for (int32_t x = 0; x < frame->surface.width; x++) {
            count += frame->scene->work == BENCH_CLEAR || bench_is_drawn(frame, x, y);
        }
    }
    return count;
}

/* BENCH_ONLY: the name of the one scene to draw. */
#ifdef BENCH_ONLY
static bool is_wanted(const char *name)
{
    const char *only = BENCH_ONLY;
    while (*name != '\0' && *name == *only) {
        name++;
        only++;
    }
    return *name == *only;
}
#else
static bool is_wanted(const char *name)
{
    (void)name;
    return true;
}
#endif

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    bench_set_up_core();
    for (const bench_scene *scene = bench_scenes; scene->name != NULL; scene++) {
        bench_frame *frame = &bench_memory;
        if (!is_wanted(scene->name) || !bench_prepare(frame, scene)) {
            continue;
        }
        uint32_t start = board_ticks();
        bench_draw(frame);
        uint32_t instructions = board_instructions(start, board_ticks());
        bench_finish(frame);
        board_write(scene->name);
        board_write(" ");
        bench_write_number(bench_hash(&frame->surface), 16, 8);
        bench_write_decimal(bench_pixels(frame));
        bench_write_decimal(bench_triangles(scene));
        bench_write_decimal(instructions);
        board_write("\n");
    }
    board_write("end\n");
    return 0;
}
