/* SPDX-License-Identifier: MIT */
/*
 * The host as one more board: for the programs that boards run.
 */
#include <stdio.h>

#include "../../port/boards/board.h"

void board_write(const char *text)
{
    fputs(text, stdout);
}

uint32_t board_ticks(void)
{
    return 0;
}

uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    (void)from_ticks;
    (void)to_ticks;
    return 0; /* not counted here */
}
