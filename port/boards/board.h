/* SPDX-License-Identifier: MIT */
/*
 * What lies between a board and the program that every board runs. The host implements the board's
 * side as well (tests/boards/board_host.c).
 */
#ifndef QTRI_BOARD_H
#define QTRI_BOARD_H

#include <stddef.h>
#include <stdint.h>

/* Clocks, console, counter. The start-up code calls it before main. */
void board_init(void);

/* Sends text to the console; waits while the console is busy. */
void board_write(const char *text);

/* A free-running counter, and the instructions executed between two of its readings; on the RP2040
 * cycles. */
uint32_t board_ticks(void);
uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks);

/* Bytes of stack that were in use at the deepest moment since start-up; 0: not measured. */
size_t board_stack_used(void);

/* Ends the emulation with the status: 0 for success. */
void board_exit(int status);

/*
 * The program, called by the board's main with the memory it has to spare, aligned for any type.
 * Returns the status to end with.
 */
int board_program(void *memory, size_t bytes);

#endif
