/* SPDX-License-Identifier: MIT */
#include "../board.h"

/* Enough for whole frames; a microcontroller has less, and the program draws in bands only. */
static uint64_t memory[512 * 1024 / sizeof(uint64_t)];

int main(void)
{
    return board_program(memory, sizeof memory);
}
