/* SPDX-License-Identifier: MIT */
#include "../board.h"

/* The examples have memory of their own. */
int main(void)
{
    return board_program(NULL, 0);
}
