/* SPDX-License-Identifier: MIT */
/*
 * The program of a board with a display: draws the pictures of a display_show in bands, sends them
 * to the display, and tells the console of each when it can be seen:
 *
 *   frame <number> <scene> <instructions>
 *
 * Then it waits for a byte: Enter, or the script that looks at the display in the meantime. The
 * instructions count from the clear to the last pixel sent. The last lines are `# stack <bytes>`
 * and `end <frames>`.
 */
#include "../../port/boards/board.h"
#include "../../port/boards/display.h"
#include "board_print.h"
#include "display_show.h"

static const display_show *const show = &display_show_here;

static enum qtri_error draw_frame(qtri_panel *panel, void *scratch, void *memory, size_t bytes)
{
    enum qtri_error error = QTRI_OK;
    for (int32_t row = 0; row < show->height && error == QTRI_OK; row += show->band_rows) {
        qtri_surface band;
        error = qtri_surface_init(&band, show->format, show->width, show->height, row,
                                  show->band_rows, memory, bytes);
        if (error == QTRI_OK) {
            qtri_surface_clear(&band, show->background);
            show->draw(scratch, &band);
            error = qtri_panel_write(panel, &band);
        }
    }
    return error == QTRI_OK ? qtri_panel_finish(panel) : error;
}

static void write_frame(uint32_t frame, const char *scene, uint32_t instructions)
{
    board_write("frame ");
    board_write_decimal(frame);
    board_write(" ");
    board_write(scene);
    board_write(" ");
    board_write_decimal(instructions);
    board_write("\n");
}

static int fail(const char *what)
{
    board_write("# failed: ");
    board_write(what);
    board_write("\n");
    return 1;
}

int board_program(void *memory, size_t bytes)
{
    size_t scratch_bytes = (show->bytes + 7) / 8 * 8;
    if (bytes < scratch_bytes) {
        return fail("too little memory");
    }
    qtri_panel panel;
    if (board_display_init(&panel) != QTRI_OK) {
        return fail("display");
    }
    show->prepare(memory);
    for (uint32_t frame = 0; frame < show->frames; frame++) {
        const char *scene = show->advance(memory, frame);
        uint32_t start = board_ticks();
        if (draw_frame(&panel, memory, (uint8_t *)memory + scratch_bytes, bytes - scratch_bytes) !=
            QTRI_OK) {
            return fail(scene);
        }
        write_frame(frame, scene, board_instructions(start, board_ticks()));
        board_wait_for_key();
    }
    board_write("# stack ");
    board_write_decimal((uint32_t)board_stack_used());
    board_write("\nend ");
    board_write_decimal(show->frames);
    board_write("\n");
    return 0;
}
