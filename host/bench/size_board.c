/* SPDX-License-Identifier: MIT */
/*
 * The program of a board: the application's set-up and frames on a painted stack. Prints
 *
 *   setup BYTES       the deepest stack below the call of app_setup
 *   frame BYTES       the same for app_frame
 *   pixels COUNT      with a depth, in all frames: so that drawing nothing does not look frugal
 */
#include "../../port/boards/board.h"
#include "app.h"
#include "bench_core.h"
#include "bench_print.h"

#define PAINT       0xA5A5A5A5u
#define STACK_BYTES 6144 /* below the caller; the linker script gives the stack 8 KB */

static uint32_t pixels;

void display_write(const qtri_surface *band)
{
    for (int32_t i = 0; i < band->rows * band->width; i++) {
        pixels += band->depth[i] != UINT16_MAX;
    }
}

static void write_line(const char *name, uint32_t value)
{
    board_write(name);
    bench_write_decimal(value);
    board_write("\n");
}

static uint32_t *stack_pointer(void)
{
    uint32_t *sp;
    __asm__ volatile("mov %0, sp" : "=r"(sp));
    return sp;
}

/* The stack that a call uses, from its caller's stack pointer down. */
__attribute__((noinline)) static uint32_t measure(void (*call)(int32_t), int32_t argument)
{
    volatile uint32_t *top = stack_pointer();
    volatile uint32_t *low = top - STACK_BYTES / sizeof *top;
    for (volatile uint32_t *p = low; p != top; p++) {
        *p = PAINT;
    }
    call(argument);
    while (low != top && *low == PAINT) {
        low++;
    }
    return (uint32_t)(top - low) * (uint32_t)sizeof *top;
}

/* A tail call: no stack of its own. */
static void setup(int32_t unused)
{
    (void)unused;
    app_setup();
}

int board_program(void *memory, size_t bytes)
{
    (void)memory;
    (void)bytes;
    bench_set_up_core();
    write_line("setup", measure(setup, 0));
    uint32_t deepest = 0;
    for (int32_t i = 0; i < APP_FRAMES; i++) {
        uint32_t used = measure(app_frame, i);
        deepest = used > deepest ? used : deepest;
    }
    write_line("frame", deepest);
    write_line("pixels", pixels);
    return 0;
}
