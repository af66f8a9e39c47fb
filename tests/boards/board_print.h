/* SPDX-License-Identifier: MIT */
/* Numbers on the board's console. */
#ifndef QTRI_BOARD_PRINT_H
#define QTRI_BOARD_PRINT_H

#include <stdint.h>

void board_write_decimal(uint32_t value);
void board_write_hex8(uint32_t value); /* eight digits */

#endif
