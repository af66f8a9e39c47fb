/* SPDX-License-Identifier: MIT */
/*
 * The examples on the emulated boards: each frame is announced on the console, as
 *
 *   frame <number> <example> <instructions>
 *
 * and stays until a byte comes, Enter or that of tests/boards/run_display.sh. The instructions are
 * all since the frame before. The last line is `end <frames>`.
 */
#include "example.h"

#include "../boards/board.h"
#include "../boards/display.h"

enum { FRAMES = 8 };

static uint32_t frame, started;

static void write_decimal(uint32_t value)
{
    char text[11];
    char *at = text + sizeof text - 1;
    *at = '\0';
    do {
        *--at = (char)('0' + value % 10);
        value /= 10;
    } while (value > 0);
    board_write(at);
}

enum qtri_error example_display(qtri_panel *panel)
{
    enum qtri_error error = board_display_init(panel);
    started = board_ticks();
    return error;
}

bool example_next_frame(qtri_panel *panel)
{
    (void)qtri_panel_finish(panel);
    uint32_t instructions = board_instructions(started, board_ticks());
    board_write("frame ");
    write_decimal(frame);
    board_write(" ");
    board_write(example_name);
    board_write(" ");
    write_decimal(instructions);
    board_write("\n");
    board_wait_for_key();
    started = board_ticks();
    frame++;
    return frame < FRAMES;
}

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    if (example_run() != QTRI_OK) {
        board_write("# failed\n");
        return 1;
    }
    board_write("end ");
    write_decimal(frame);
    board_write("\n");
    return 0;
}
