/* SPDX-License-Identifier: MIT */
/*
 * The stand-ins of the Pico SDK at work: what the glue sends goes to a simulated ILI9341. Bytes
 * that DMA sends are taken when it has finished, and must be as they were when it began. After
 * three frames: status 0 if the controller has no complaint and its display shows a picture.
 */
#include "hardware/dma.h"
#include "hardware/spi.h"

#include <panels/controllers.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PIN_DC = 20, PIN_RESET = 21, FRAME_BYTES = 320 * 240 * 2 };

uint8_t spi0_hw_address[1];

static lcd display;
static spi_hw_t registers;
static bool is_data;
static const uint8_t *sending;
static uint8_t sent[FRAME_BYTES];
static uint sending_bytes;
static unsigned long pixels;

static void stop(int status, const char *why)
{
    printf("pico: %s\n", why);
    exit(status);
}

static void end_of_frames(void)
{
    unsigned long drawn = 0;
    if (display.chip.error[0] != '\0') {
        stop(1, display.chip.error);
    }
    for (int y = 0; y < 320; y++) {
        for (int x = 0; x < 240; x++) {
            drawn += chip_pixel(&display.chip, x, y) != chip_pixel(&display.chip, 0, 0);
        }
    }
    stop(drawn > 5000 ? 0 : 1, "three frames");
}

void gpio_init(uint gpio)
{
    (void)gpio;
}

void gpio_set_dir(uint gpio, bool out)
{
    (void)gpio;
    (void)out;
}

void gpio_set_function(uint gpio, enum gpio_function fn)
{
    (void)gpio;
    (void)fn;
}

void gpio_put(uint gpio, bool value)
{
    if (sending != NULL) {
        stop(1, "a pin changes while DMA runs");
    }
    if (gpio == PIN_DC) {
        is_data = value;
    } else if (gpio == PIN_RESET) {
        chip_reset_pin(&display.chip, !value);
    }
}

void sleep_ms(uint32_t ms)
{
    chip_wait(&display.chip, ms);
}

uint spi_init(spi_inst_t *spi, uint baudrate)
{
    (void)spi;
    ili9341_init(&display);
    return baudrate;
}

int spi_write_blocking(spi_inst_t *spi, const uint8_t *src, size_t len)
{
    (void)spi;
    chip_send(&display.chip, is_data, src, len);
    return (int)len;
}

bool spi_is_busy(const spi_inst_t *spi)
{
    (void)spi;
    return false;
}

uint spi_get_dreq(spi_inst_t *spi, bool is_tx)
{
    (void)spi;
    return is_tx ? 16 : 17;
}

spi_hw_t *spi_get_hw(spi_inst_t *spi)
{
    (void)spi;
    return &registers;
}

int dma_claim_unused_channel(bool required)
{
    (void)required;
    return 3;
}

dma_channel_config dma_channel_get_default_config(uint channel)
{
    dma_channel_config config = {channel};
    return config;
}

void channel_config_set_transfer_data_size(dma_channel_config *c,
                                           enum dma_channel_transfer_size size)
{
    c->ctrl |= (uint32_t)size << 8;
}

void channel_config_set_dreq(dma_channel_config *c, uint dreq)
{
    c->ctrl |= dreq << 16;
}

void dma_channel_configure(uint channel, const dma_channel_config *config,
                           volatile void *write_addr, const volatile void *read_addr,
                           uint transfer_count, bool trigger)
{
    if (channel != 3 || config->ctrl != (16u << 16 | 3) || write_addr != &registers.dr ||
        !trigger || sending != NULL || transfer_count > sizeof sent) {
        stop(1, "DMA is set up otherwise than for SPI 0");
    }
    sending = (const uint8_t *)(uintptr_t)read_addr;
    sending_bytes = transfer_count;
    memcpy(sent, sending, transfer_count);
}

void dma_channel_wait_for_finish_blocking(uint channel)
{
    (void)channel;
    if (memcmp(sending, sent, sending_bytes) != 0) {
        stop(1, "bytes changed while DMA sent them");
    }
    chip_send(&display.chip, true, sent, sending_bytes);
    pixels += sending_bytes / 2;
    sending = NULL;
    if (pixels >= 4ul * 320 * 240) { /* the black of the beginning is one */
        end_of_frames();
    }
}
