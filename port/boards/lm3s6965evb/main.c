/* SPDX-License-Identifier: MIT */
#include "../board.h"

/* The whole frame of 128x64 in GRAY8 with depth, 24 KB, and what the scene needs. */
static uint64_t memory[28 * 1024 / sizeof(uint64_t)];

int main(void)
{
    return board_program(memory, sizeof memory);
}
