/* SPDX-License-Identifier: MIT */
/*
 * The matrix on the host: the pictures that the boards must reproduce.
 */
#include "../../port/boards/board.h"

int main(void)
{
    return board_program(NULL, 0);
}
