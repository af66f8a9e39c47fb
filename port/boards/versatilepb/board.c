/* SPDX-License-Identifier: MIT */
/*
 * Arm Versatile/PB (DUI 0225; QEMU versatilepb): ARM926EJ-S without floating point, a colour LCD
 * of 320x240 on a PL110 controller, console on UART 0, instructions by the 24 MHz counter.
 */
#include "../board.h"
#include "../display.h"

#include "../common/pl011.h"
#include "../common/semihosting.h"
#include "qtri_port/framebuffer.h"

#define UART0         ((volatile uint32_t *)0x101F1000u)
#define UART_CLOCK_HZ 24000000u
#define BAUD          115200u

/* System registers, in words. */
#define SYSTEM ((volatile uint32_t *)0x10000000u)
enum { SYSTEM_LCD = 0x50 / 4, SYSTEM_24MHZ = 0x5C / 4 };
#define SYSTEM_LCD_565   3u                  /* the wires of the LCD: 5:6:5, blue in the low bits */
#define SYSTEM_LCD_POWER (1u << 2 | 1u << 4) /* signals and 3.5 V */

/* PL110 (DDI 0161), in words. The Versatile has the control register before the interrupt mask. */
#define LCD ((volatile uint32_t *)0x10120000u)
enum {
    LCD_HORIZONTAL = 0x00 / 4,
    LCD_VERTICAL = 0x04 / 4,
    LCD_CLOCK = 0x08 / 4,
    LCD_FRAME = 0x10 / 4,
    LCD_CONTROL = 0x18 / 4
};
#define LCD_CLOCK_UNDIVIDED (1u << 26)
#define LCD_CONTROL_ON      (1u << 0)
#define LCD_CONTROL_16_BITS (4u << 1)
#define LCD_CONTROL_TFT     (1u << 5)
#define LCD_CONTROL_POWER   (1u << 11)

enum { WIDTH = 320, HEIGHT = 240, MARGIN = 6, SYNC = 6 };

#define STACK_PAINT 0xA5A5A5A5u

/* From the linker script; only their addresses mean anything. */
extern const uint32_t stack_low[], stack_top[];

/* The LCD controller asks for words. QEMU 7.2 overlooks what is written to the end of a framebuffer
   that does not begin on a page: it rounds the beginning down and keeps the length. */
__attribute__((aligned(1024))) static uint16_t framebuffer[WIDTH * HEIGHT];

void board_init(void)
{
    pl011_init(UART0, UART_CLOCK_HZ, BAUD);
}

void board_write(const char *text)
{
    pl011_write(UART0, text);
}

void board_wait_for_key(void)
{
    (void)pl011_read(UART0);
}

/* Lengths are in pixels and rows, less one; the fields of a line start with its pixels / 16. */
static void start_lcd(void)
{
    SYSTEM[SYSTEM_LCD] = SYSTEM_LCD_565 | SYSTEM_LCD_POWER;
    LCD[LCD_HORIZONTAL] =
        (MARGIN - 1u) << 24 | (MARGIN - 1u) << 16 | (SYNC - 1u) << 8 | (WIDTH / 16u - 1u) << 2;
    LCD[LCD_VERTICAL] = MARGIN << 24 | MARGIN << 16 | (SYNC - 1u) << 10 | (HEIGHT - 1u);
    LCD[LCD_CLOCK] = LCD_CLOCK_UNDIVIDED | (WIDTH - 1u) << 16;
    LCD[LCD_FRAME] = (uint32_t)(uintptr_t)framebuffer;
    LCD[LCD_CONTROL] = LCD_CONTROL_ON | LCD_CONTROL_16_BITS | LCD_CONTROL_TFT | LCD_CONTROL_POWER;
}

enum qtri_error board_display_init(qtri_panel *panel)
{
    static const qtri_panel_description lcd =
        QTRI_FRAMEBUFFER(WIDTH, HEIGHT, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    start_lcd();
    return qtri_panel_init(panel, &lcd, NULL, QTRI_ROTATE_0, framebuffer, sizeof framebuffer);
}

uint32_t board_ticks(void)
{
    return SYSTEM[SYSTEM_24MHZ];
}

/* With -icount shift=0 an instruction takes 1 ns, a tick 1000/24 ns. Good for 4 seconds. */
uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    return (uint32_t)((uint64_t)(to_ticks - from_ticks) * 125u / 3u);
}

size_t board_stack_used(void)
{
    const uint32_t *deepest = stack_low;
    while (deepest < stack_top && *deepest == STACK_PAINT) {
        deepest++;
    }
    return (uintptr_t)stack_top - (uintptr_t)deepest;
}

void board_exit(int status)
{
    semihosting_exit(status);
}
