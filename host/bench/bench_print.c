/* SPDX-License-Identifier: MIT */
#include "bench_print.h"

#include "../../port/boards/board.h"

void bench_write_number(uint32_t value, uint32_t base, uint32_t least_digits)
{
    char text[12];
    char *p = &text[sizeof text - 1];
    *p = '\0';
    for (; value != 0 || least_digits > 0; value /= base) {
        *--p = "0123456789abcdef"[value % base];
        least_digits -= least_digits > 0;
    }
    board_write(p);
}

void bench_write_decimal(uint32_t value)
{
    board_write(" ");
    bench_write_number(value, 10, 1);
}
