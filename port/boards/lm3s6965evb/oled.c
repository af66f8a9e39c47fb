/* SPDX-License-Identifier: MIT */
/*
 * The board's OLED, an SSD0323 with 128x64 pixels of 16 grays, on SSI 0:
 *
 *   PA2 clock, PA3 select, PA5 data      driven by the SSI
 *   PC7 D/C: low for commands            PC6 the OLED's supply of 15 V, high: on
 *   PD0 select of the SD card on the same wires: high, not selected
 *
 * Reset is the board's own.
 */
#include "../display.h"

#include "lm3s6965.h"
#include "qtri_port/ssd0323.h"

#define PIN_SSI     (1u << 2 | 1u << 3 | 1u << 5)
#define PIN_SUPPLY  (1u << 6)
#define PIN_DATA    (1u << 7)
#define PIN_SD_CARD (1u << 0)

/* 50 MHz / 14: 3.6 of the 4 MHz that the SSD0323 stands. */
#define SSI_DIVISOR 14u

static uint8_t row[QTRI_SSD0323_ROW_BYTES];

/* What is received, nothing, is read away: a full receive FIFO would be an overrun. */
static void send(const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        SSI0[SSI_DATA] = bytes[i];
        while ((SSI0[SSI_STATUS] & SSI_STATUS_RECEIVED) == 0) {
        }
        (void)SSI0[SSI_DATA];
    }
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    gpio_write(GPIO_C, PIN_DATA, 0);
    send(bytes, count);
    return true;
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    gpio_write(GPIO_C, PIN_DATA, PIN_DATA);
    send(bytes, count);
    return true;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    for (uint32_t i = 0; i < ms; i++) {
        uint32_t start = SYSTICK[SYSTICK_VALUE];
        while (((start - SYSTICK[SYSTICK_VALUE]) & SYSTICK_MAX) < CLOCK_HZ / 1000u) {
        }
    }
}

static const qtri_bus bus = {.command = command, .data = data, .wait_ms = wait_ms};

static void start_ssi(void)
{
    enable(CLOCK_GATE_1, CLOCK_1_SSI0);
    enable(CLOCK_GATE_2, CLOCK_2_GPIO_A | CLOCK_2_GPIO_C | CLOCK_2_GPIO_D);
    gpio_function(GPIO_A, PIN_SSI);
    gpio_output(GPIO_C, PIN_DATA | PIN_SUPPLY);
    gpio_output(GPIO_D, PIN_SD_CARD);
    gpio_write(GPIO_D, PIN_SD_CARD, PIN_SD_CARD);
    gpio_write(GPIO_C, PIN_SUPPLY, PIN_SUPPLY);

    SSI0[SSI_CONTROL_1] = 0;
    SSI0[SSI_PRESCALE] = SSI_DIVISOR;
    SSI0[SSI_CONTROL_0] = SSI_CONTROL_0_8_BITS;
    SSI0[SSI_CONTROL_1] = SSI_CONTROL_1_ON;
}

enum qtri_error board_display_init(qtri_panel *panel)
{
    start_ssi();
    return qtri_panel_init(panel, &qtri_ssd0323, &bus, QTRI_ROTATE_0, row, sizeof row);
}
