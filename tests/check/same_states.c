/* SPDX-License-Identifier: MIT */
/*
 * Pictures of random states on a board, or on the host: one line for each,
 *
 *   states kind number checksum
 *
 * and `end`. Each picture has a seed of its own, so that a line that differs can be drawn alone.
 * Every other picture is drawn in bands, where its kind allows.
 */
#include "../../host/bench/bench_print.h"
#include "../../port/boards/board.h"
#include "../support/random_states.h"

enum { STATES_OF_A_KIND = 52, STATES_BAND_ROWS_MAX = 19 };

static uint8_t states_memory[STATES_BYTES], states_resolved[STATES_BYTES];
static random_states states_now;

static void draw_state(const random_kind *kind, int32_t number)
{
    random_states *w = &states_now;
    memset(w, 0, sizeof *w);
    w->seed = (uint64_t)number;
    w->memory = states_memory;
    w->resolved = states_resolved;
    w->band_rows = kind->in_bands && number % 2 != 0 ? 1 + number % STATES_BAND_ROWS_MAX : 0;
    const uint32_t hash = kind->picture(w, RANDOM_HASH_BEGIN, kind->draw);
    board_write("states ");
    board_write(kind->name);
    bench_write_decimal((uint32_t)number);
    board_write(" ");
    bench_write_number(hash, 16, 8);
    board_write(w->failed ? " failed\n" : "\n");
}

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    for (const random_kind *kind = random_kinds; kind->name != NULL; kind++) {
        for (int32_t number = 0; number < STATES_OF_A_KIND; number++) {
            draw_state(kind, number);
        }
    }
    board_write("end\n");
    return 0;
}
