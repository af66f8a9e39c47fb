/* SPDX-License-Identifier: MIT */
/* The stand-ins of ESP-IDF at work. A delay may end up to a tick early. */
#include <driver/gpio.h>
#include <driver/spi_master.h>
#include <freertos/task.h>

#include "../glue/display.h"

enum { PIN_DC = 2, PIN_RESET = 4 };

void app_main(void);

static int most_bytes;
static spi_transaction_t *queued;

esp_err_t gpio_set_direction(gpio_num_t gpio_num, gpio_mode_t mode)
{
    return gpio_num >= 0 && mode == GPIO_MODE_OUTPUT ? ESP_OK : -1;
}

esp_err_t gpio_set_level(gpio_num_t gpio_num, uint32_t level)
{
    if (gpio_num == PIN_DC) {
        glue_data_pin(level != 0);
    } else if (gpio_num == PIN_RESET) {
        glue_reset_pin(level == 0);
    }
    return ESP_OK;
}

esp_err_t spi_bus_initialize(spi_host_device_t host_id, const spi_bus_config_t *bus_config,
                             spi_dma_chan_t dma_chan)
{
    most_bytes = bus_config->max_transfer_sz;
    return host_id == SPI2_HOST && dma_chan == SPI_DMA_CH_AUTO ? ESP_OK : -1;
}

esp_err_t spi_bus_add_device(spi_host_device_t host_id,
                             const spi_device_interface_config_t *dev_config,
                             spi_device_handle_t *handle)
{
    *handle = (spi_device_handle_t)(void *)&most_bytes;
    return host_id == SPI2_HOST && dev_config->queue_size > 0 ? ESP_OK : -1;
}

static size_t bytes_of(const spi_transaction_t *transaction)
{
    size_t bytes = transaction->length / 8;
    if (transaction->length % 8 != 0 || bytes > (size_t)most_bytes) {
        glue_stop(1, "a transfer of too many bits, or of parts of bytes");
    }
    return bytes;
}

esp_err_t spi_device_polling_transmit(spi_device_handle_t handle, spi_transaction_t *trans_desc)
{
    (void)handle;
    glue_send(trans_desc->tx_buffer, bytes_of(trans_desc));
    return ESP_OK;
}

esp_err_t spi_device_queue_trans(spi_device_handle_t handle, spi_transaction_t *trans_desc,
                                 TickType_t ticks_to_wait)
{
    (void)handle;
    (void)ticks_to_wait;
    glue_start(trans_desc->tx_buffer, bytes_of(trans_desc));
    queued = trans_desc;
    return ESP_OK;
}

esp_err_t spi_device_get_trans_result(spi_device_handle_t handle, spi_transaction_t **trans_desc,
                                      TickType_t ticks_to_wait)
{
    (void)handle;
    (void)ticks_to_wait;
    *trans_desc = queued;
    (void)bytes_of(queued);
    glue_finish();
    return ESP_OK;
}

void vTaskDelay(TickType_t ticks)
{
    glue_wait(ticks > 0 ? (ticks - 1) * portTICK_PERIOD_MS : 0);
}

int main(void)
{
    app_main();
    return 1; /* frames end it */
}
