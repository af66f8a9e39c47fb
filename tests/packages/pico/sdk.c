/* SPDX-License-Identifier: MIT */
/*
 * The stand-ins of the Pico SDK at work: what the glue sends goes to the display of
 * tests/packages/glue.
 */
#include "hardware/dma.h"
#include "hardware/spi.h"

#include "../glue/display.h"

enum { PIN_DC = 20, PIN_RESET = 21, CHANNEL = 3, SPI_TX_REQUEST = 16 };

uint8_t spi0_hw_address[1];

static spi_hw_t registers;

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
    if (gpio == PIN_DC) {
        glue_data_pin(value);
    } else if (gpio == PIN_RESET) {
        glue_reset_pin(!value);
    }
}

void sleep_ms(uint32_t ms)
{
    glue_wait(ms);
}

uint spi_init(spi_inst_t *spi, uint baudrate)
{
    (void)spi;
    return baudrate;
}

int spi_write_blocking(spi_inst_t *spi, const uint8_t *src, size_t len)
{
    (void)spi;
    glue_send(src, len);
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
    return is_tx ? SPI_TX_REQUEST : SPI_TX_REQUEST + 1;
}

spi_hw_t *spi_get_hw(spi_inst_t *spi)
{
    (void)spi;
    return &registers;
}

int dma_claim_unused_channel(bool required)
{
    (void)required;
    return CHANNEL;
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
    if (channel != CHANNEL || config->ctrl != ((uint32_t)SPI_TX_REQUEST << 16 | CHANNEL) ||
        write_addr != &registers.dr || !trigger) {
        glue_stop(1, "DMA is set up otherwise than for SPI 0");
    }
    glue_start((const void *)(uintptr_t)read_addr, transfer_count);
}

void dma_channel_wait_for_finish_blocking(uint channel)
{
    (void)channel;
    glue_finish();
}
