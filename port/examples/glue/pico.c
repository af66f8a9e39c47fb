/* SPDX-License-Identifier: MIT */
/*
 * The examples on a Raspberry Pi Pico (Pico SDK) with an ILI9341 on SPI 0, pixels by DMA:
 *
 *   display   Pico
 *   SCK       GP18        DC      GP20
 *   MOSI      GP19        RESET   GP21
 *   CS        GP17        LED     3V3, by the module's resistor
 *
 *   add_subdirectory(qtri)          # behind pico_sdk_init()
 *   add_executable(mesh qtri/port/examples/mesh/mesh.c qtri/port/examples/glue/pico.c)
 *   target_link_libraries(mesh qtri::qtri pico_stdlib hardware_spi hardware_dma)
 *   pico_add_extra_outputs(mesh)
 */
#include "hardware/dma.h"
#include "hardware/spi.h"
#include "pico/stdlib.h"

#include "../example.h"
#include "qtri_port/ili9341.h"

enum { PIN_CS = 17, PIN_CLOCK = 18, PIN_DATA = 19, PIN_DC = 20, PIN_RESET = 21 };
enum { SPI_HZ = 40000000 };

static uint channel;
static uint8_t line_memory[QTRI_PANEL_LINE_BYTES(320)];

/* Returns after the last bit: spi_write_blocking waits for it. */
static bool command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    gpio_put(PIN_DC, false);
    return spi_write_blocking(spi0, bytes, count) == (int)count;
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    gpio_put(PIN_DC, true);
    return spi_write_blocking(spi0, bytes, count) == (int)count;
}

static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    gpio_put(PIN_DC, true);
    dma_channel_config config = dma_channel_get_default_config(channel);
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(spi0, true));
    dma_channel_configure(channel, &config, &spi_get_hw(spi0)->dr, bytes, (uint)count, true);
    return true;
}

/* The DMA is done when the last byte is in the SPI's FIFO; the SPI when it has been sent. */
static bool data_finish(void *context)
{
    (void)context;
    dma_channel_wait_for_finish_blocking(channel);
    while (spi_is_busy(spi0)) {
    }
    return true;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    sleep_ms(ms);
}

static void reset(void *context, bool active)
{
    (void)context;
    gpio_put(PIN_RESET, !active);
}

static const qtri_bus bus = {.command = command,
                             .data = data,
                             .data_start = data_start,
                             .data_finish = data_finish,
                             .wait_ms = wait_ms,
                             .reset = reset};

static void output(uint pin, bool value)
{
    gpio_init(pin);
    gpio_put(pin, value);
    gpio_set_dir(pin, GPIO_OUT);
}

enum qtri_error example_display(qtri_panel *panel)
{
    output(PIN_CS, false); /* the display is alone on its bus */
    output(PIN_DC, true);
    output(PIN_RESET, true);
    (void)spi_init(spi0, SPI_HZ); /* mode 0, 8 bits, the high one first */
    gpio_set_function(PIN_CLOCK, GPIO_FUNC_SPI);
    gpio_set_function(PIN_DATA, GPIO_FUNC_SPI);
    channel = (uint)dma_claim_unused_channel(true);
    return qtri_panel_init(panel, &qtri_ili9341, &bus, QTRI_ROTATE_90, line_memory,
                           sizeof line_memory);
}

/* As fast as it goes: the last band may be on its way while the next frame begins. */
bool example_next_frame(qtri_panel *panel)
{
    (void)panel;
    return true;
}

int main(void)
{
    return example_run();
}
