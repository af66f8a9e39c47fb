/* SPDX-License-Identifier: MIT */
/*
 * Microchip ATmega1284P: 8 bits, int of 16 bits, 128 KB of flash, 16 KB of RAM; run by simavr.
 * Console on USART 0. Start-up and linker script are avr-libc's.
 */
#include "../board.h"

/* registers.S */
extern volatile uint8_t UCSR0A, UCSR0B, UDR0;
void atmega_stop(void);

#define UCSR0A_DATA_EMPTY 0x20u
#define UCSR0B_TRANSMIT   0x08u

void board_init(void)
{
    UCSR0B = UCSR0B_TRANSMIT;
}

void board_write(const char *text)
{
    for (; *text != '\0'; text++) {
        while ((UCSR0A & UCSR0A_DATA_EMPTY) == 0) {
        }
        UDR0 = (uint8_t)*text;
    }
}

uint32_t board_ticks(void)
{
    return 0; /* not counted */
}

uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    return to_ticks - from_ticks;
}

size_t board_stack_used(void)
{
    return 0; /* not measured */
}

/* The simulator's own status is 0 whatever happens: the program must say on its console that it
 * ended. */
void board_exit(int status)
{
    board_write(status == 0 ? "" : "# failed\n");
    atmega_stop();
}
