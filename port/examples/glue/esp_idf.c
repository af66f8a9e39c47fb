/* SPDX-License-Identifier: MIT */
/*
 * The examples on an ESP32 (ESP-IDF 4.4 and later) with an ILI9341 on SPI 2, pixels by DMA:
 *
 *   display   ESP32
 *   SCK       GPIO18      DC      GPIO2
 *   MOSI      GPIO23      RESET   GPIO4
 *   CS        GPIO5       LED     3V3, by the module's resistor
 *
 * The whole project is port/packages/esp_idf. In one of your own, with qtri as a component
 * (port/packages/README.md), main/CMakeLists.txt has these two files and REQUIRES qtri driver; from
 * ESP-IDF 5.3 on qtri esp_driver_spi esp_driver_gpio.
 *
 * The watchdog of the idle task looks on: example_next_frame() gives it a tick.
 */
#include <driver/gpio.h>
#include <driver/spi_master.h>
#include <freertos/FreeRTOS.h>
#include <freertos/task.h>

#include "../example.h"
#include "qtri_port/ili9341.h"

enum { PIN_CS = 5, PIN_CLOCK = 18, PIN_DATA = 23, PIN_DC = 2, PIN_RESET = 4 };
enum { SPI_HZ = 40000000, MOST_BYTES = 320 * 16 * 2 }; /* a band */

void app_main(void); /* ESP-IDF's main task calls it */

static spi_device_handle_t device;
static spi_transaction_t pixels; /* stays until the transfer is over */
static uint8_t line_memory[QTRI_PANEL_LINE_BYTES(320)];

/* Returns after the last bit. */
static bool send(uint32_t data_pin, const uint8_t *bytes, size_t count)
{
    spi_transaction_t transaction = {.length = 8 * count, .tx_buffer = bytes};
    return gpio_set_level(PIN_DC, data_pin) == ESP_OK &&
           spi_device_polling_transmit(device, &transaction) == ESP_OK;
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    return send(0, bytes, count);
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    return send(1, bytes, count);
}

static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    const spi_transaction_t transaction = {.length = 8 * count, .tx_buffer = bytes};
    pixels = transaction;
    return gpio_set_level(PIN_DC, 1) == ESP_OK &&
           spi_device_queue_trans(device, &pixels, portMAX_DELAY) == ESP_OK;
}

/* The task sleeps until the last bit is out. */
static bool data_finish(void *context)
{
    (void)context;
    spi_transaction_t *finished = NULL;
    return spi_device_get_trans_result(device, &finished, portMAX_DELAY) == ESP_OK;
}

/* Ticks are 10 ms where nobody has changed that: rounded up, and one more, as one has begun. */
static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    vTaskDelay(pdMS_TO_TICKS(ms + portTICK_PERIOD_MS - 1) + 1);
}

static void reset(void *context, bool active)
{
    (void)context;
    (void)gpio_set_level(PIN_RESET, active ? 0 : 1);
}

static const qtri_bus bus = {.command = command,
                             .data = data,
                             .data_start = data_start,
                             .data_finish = data_finish,
                             .wait_ms = wait_ms,
                             .reset = reset,
                             .most_bytes = MOST_BYTES};

static bool open_bus(void)
{
    const spi_bus_config_t wires = {.mosi_io_num = PIN_DATA,
                                    .miso_io_num = -1,
                                    .sclk_io_num = PIN_CLOCK,
                                    .quadwp_io_num = -1,
                                    .quadhd_io_num = -1,
                                    .max_transfer_sz = MOST_BYTES};
    const spi_device_interface_config_t display = {
        .mode = 0, .clock_speed_hz = SPI_HZ, .spics_io_num = PIN_CS, .queue_size = 1};
    return gpio_set_direction(PIN_DC, GPIO_MODE_OUTPUT) == ESP_OK &&
           gpio_set_direction(PIN_RESET, GPIO_MODE_OUTPUT) == ESP_OK &&
           spi_bus_initialize(SPI2_HOST, &wires, SPI_DMA_CH_AUTO) == ESP_OK &&
           spi_bus_add_device(SPI2_HOST, &display, &device) == ESP_OK;
}

enum qtri_error example_display(qtri_panel *panel)
{
    if (!open_bus()) {
        return QTRI_ERROR_BUS;
    }
    return qtri_panel_init(panel, &qtri_ili9341, &bus, QTRI_ROTATE_90, line_memory,
                           sizeof line_memory);
}

bool example_next_frame(qtri_panel *panel)
{
    (void)panel;
    vTaskDelay(1);
    return true;
}

void app_main(void)
{
    (void)example_run();
}
