/* SPDX-License-Identifier: MIT */
#include "board_print.h"

#include "../../port/boards/board.h"

static void write_number(uint32_t value, uint32_t base, int least_digits)
{
    char text[12];
    char *p = &text[sizeof text - 1];
    *p = '\0';
    do {
        *--p = "0123456789abcdef"[value % base];
        value /= base;
    } while (--least_digits > 0 || value != 0);
    board_write(p);
}

void board_write_decimal(uint32_t value)
{
    write_number(value, 10, 1);
}

void board_write_hex8(uint32_t value)
{
    write_number(value, 16, 8);
}
