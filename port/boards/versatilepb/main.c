/* SPDX-License-Identifier: MIT */
#include "../board.h"

/* A band of the frame, and what the scenes need. */
static uint64_t memory[80 * 1024 / sizeof(uint64_t)];

int main(void)
{
    return board_program(memory, sizeof memory);
}
