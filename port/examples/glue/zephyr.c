/* SPDX-License-Identifier: MIT */
/*
 * The examples on Zephyr (3.2 and later) with an ILI9341 on SPI, pixels by DMA where the driver has
 * it. The board's overlay says where the display is:
 *
 *   / {
 *       zephyr,user {
 *           dc-gpios = <&gpio0 20 GPIO_ACTIVE_HIGH>;
 *           reset-gpios = <&gpio0 21 GPIO_ACTIVE_LOW>;
 *       };
 *   };
 *   &spi1 {
 *       status = "okay";
 *       cs-gpios = <&gpio0 17 GPIO_ACTIVE_LOW>;
 *       qtri_display: display@0 {
 *           compatible = "vnd,spi-device";
 *           reg = <0>;
 *           spi-max-frequency = <32000000>;
 *       };
 *   };
 *
 * prj.conf: CONFIG_QTRI=y, CONFIG_GPIO=y, CONFIG_SPI=y, CONFIG_SPI_ASYNC=y, CONFIG_POLL=y and
 * CONFIG_MAIN_STACK_SIZE=8192; the application's CMakeLists.txt adds the example and this file:
 * target_sources(app PRIVATE mesh.c zephyr.c).
 */
#include <zephyr/device.h>
#include <zephyr/drivers/gpio.h>
#include <zephyr/drivers/spi.h>
#include <zephyr/kernel.h>

#include "../example.h"
#include "qtri_port/ili9341.h"

static const struct spi_dt_spec spi =
    SPI_DT_SPEC_GET(DT_NODELABEL(qtri_display), SPI_OP_MODE_MASTER | SPI_WORD_SET(8), 0);
static const struct gpio_dt_spec pin_data = GPIO_DT_SPEC_GET(DT_PATH(zephyr_user), dc_gpios);
static const struct gpio_dt_spec pin_reset = GPIO_DT_SPEC_GET(DT_PATH(zephyr_user), reset_gpios);

static K_SEM_DEFINE(is_sent, 0, 1);
static int result;            /* of the transfer, when is_sent is given */
static struct spi_buf pixels; /* stay until the transfer is over */
static const struct spi_buf_set pixel_set = {&pixels, 1};
static uint8_t line_memory[QTRI_PANEL_LINE_BYTES(320)];

/* spi_buf says nothing of constant memory; what is sent is not written to. */
static struct spi_buf buffer_of(const uint8_t *bytes, size_t count)
{
    struct spi_buf buffer = {(void *)(uintptr_t)bytes, count};
    return buffer;
}

/* Returns after the last bit. */
static bool send(int data_pin, const uint8_t *bytes, size_t count)
{
    const struct spi_buf buffer = buffer_of(bytes, count);
    const struct spi_buf_set set = {&buffer, 1};
    return gpio_pin_set_dt(&pin_data, data_pin) == 0 && spi_write_dt(&spi, &set) == 0;
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

/* From the driver's interrupt. */
static void sent(const struct device *device, int error, void *context)
{
    (void)device;
    (void)context;
    result = error;
    k_sem_give(&is_sent);
}

static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    pixels = buffer_of(bytes, count);
    return gpio_pin_set_dt(&pin_data, 1) == 0 &&
           spi_transceive_cb(spi.bus, &spi.config, &pixel_set, NULL, sent, NULL) == 0;
}

/* The thread sleeps until the last bit is out. */
static bool data_finish(void *context)
{
    (void)context;
    return k_sem_take(&is_sent, K_FOREVER) == 0 && result == 0;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    (void)k_msleep((int32_t)ms);
}

/* Active is low: the devicetree says so. */
static void reset(void *context, bool active)
{
    (void)context;
    (void)gpio_pin_set_dt(&pin_reset, active ? 1 : 0);
}

/* Nordic's EasyDMA counts in 16 bits, as many do. */
static const qtri_bus bus = {.command = command,
                             .data = data,
                             .data_start = data_start,
                             .data_finish = data_finish,
                             .wait_ms = wait_ms,
                             .reset = reset,
                             .most_bytes = 65534};

enum qtri_error example_display(qtri_panel *panel)
{
    if (!spi_is_ready_dt(&spi) || gpio_pin_configure_dt(&pin_data, GPIO_OUTPUT_ACTIVE) != 0 ||
        gpio_pin_configure_dt(&pin_reset, GPIO_OUTPUT_INACTIVE) != 0) {
        return QTRI_ERROR_BUS;
    }
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
    return (int)example_run();
}
