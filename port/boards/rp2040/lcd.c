/* SPDX-License-Identifier: MIT */
/*
 * An ILI9341 on SPI 0, wired as in ../../README.md, pixels by DMA:
 *
 *   GP18 clock, GP19 data    driven by the SPI
 *   GP17 select              low: the display is alone on its bus
 *   GP20 D/C                 low for commands
 *   GP21 reset               low resets
 */
#include "../display.h"

#include "qtri_port/ili9341.h"
#include "rp2040.h"

enum { PIN_CS = 17, PIN_CLOCK = 18, PIN_DATA = 19, PIN_DC = 20, PIN_RESET = 21 };

/* 125 MHz / 2 / 2: 31.25 of the 40 MHz that these modules stand in practice. */
#define SPI_PRESCALER 2u
#define SPI_DIVISOR   2u

static uint8_t line_memory[QTRI_PANEL_LINE_BYTES(320)];

/* The last bit is out. */
static void wait_until_sent(void)
{
    while ((SPI0[SPI_STATUS] & SPI_STATUS_BUSY) != 0) {
    }
}

/* What is received, nothing, stays in the FIFO: nobody asks whether it overran. */
static bool send(const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        while ((SPI0[SPI_STATUS] & SPI_STATUS_NOT_FULL) == 0) {
        }
        SPI0[SPI_DATA] = bytes[i];
    }
    wait_until_sent();
    return true;
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    pin_write(PIN_DC, 0);
    return send(bytes, count);
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    pin_write(PIN_DC, 1);
    return send(bytes, count);
}

static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    pin_write(PIN_DC, 1);
    DMA_CHANNEL_0[DMA_READ] = (uint32_t)(uintptr_t)bytes;
    DMA_CHANNEL_0[DMA_WRITE] = (uint32_t)(uintptr_t)&SPI0[SPI_DATA];
    DMA_CHANNEL_0[DMA_COUNT] = (uint32_t)count;
    DMA_CHANNEL_0[DMA_CONTROL] = DMA_BYTES_TO_SPI0;
    return true;
}

/* The DMA is done when the last byte is in the SPI's FIFO; the SPI when it has been sent. */
static bool data_finish(void *context)
{
    (void)context;
    while ((DMA_CHANNEL_0[DMA_CONTROL] & DMA_BUSY) != 0) {
    }
    wait_until_sent();
    return true;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    const uint32_t start = TIMER[TIMER_LOW];
    while (TIMER[TIMER_LOW] - start < 1000u * ms) {
    }
}

static void reset(void *context, bool active)
{
    (void)context;
    pin_write(PIN_RESET, !active);
}

static const qtri_bus bus = {.command = command,
                             .data = data,
                             .data_start = data_start,
                             .data_finish = data_finish,
                             .wait_ms = wait_ms,
                             .reset = reset};

static void start_spi(void)
{
    release_from_reset(RESET_SPI0 | RESET_DMA);
    pin_output(PIN_CS, 0);
    pin_output(PIN_DC, 1);
    pin_output(PIN_RESET, 1);
    pin_function(PIN_CLOCK, PIN_SPI);
    pin_function(PIN_DATA, PIN_SPI);
    SPI0[SPI_PRESCALE] = SPI_PRESCALER;
    SPI0[SPI_CONTROL_0] = SPI_CONTROL_0_8_BITS | SPI_CONTROL_0_DIVIDE_BY(SPI_DIVISOR);
    SPI0[SPI_DMA] = SPI_DMA_SENDS;
    SPI0[SPI_CONTROL_1] = SPI_CONTROL_1_ON;
}

enum qtri_error board_display_init(qtri_panel *panel)
{
    start_spi();
    return qtri_panel_init(panel, &qtri_ili9341, &bus, QTRI_ROTATE_90, line_memory,
                           sizeof line_memory);
}
