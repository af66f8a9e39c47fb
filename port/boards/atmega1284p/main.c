/* SPDX-License-Identifier: MIT */
#include "../board.h"

static uint32_t memory[1024 / sizeof(uint32_t)];

int main(void)
{
    board_init();
    int status = board_program(memory, sizeof memory);
    board_exit(status);
    return status;
}
