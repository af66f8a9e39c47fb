/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_ZEPHYR_SPI_H
#define QTRI_TESTS_ZEPHYR_SPI_H

#include <zephyr/device.h>

#define SPI_OP_MODE_MASTER 0u
#define SPI_WORD_SET(bits) ((bits) << 5)

struct spi_config {
    uint32_t frequency;
    uint16_t operation, slave;
};

struct spi_dt_spec {
    const struct device *bus;
    struct spi_config config;
};

struct spi_buf {
    void *buf;
    size_t len;
};

struct spi_buf_set {
    const struct spi_buf *buffers;
    size_t count;
};

typedef void (*spi_callback_t)(const struct device *dev, int result, void *data);

#define SPI_DT_SPEC_GET(node, operation, delay)                                                    \
    {                                                                                              \
        &stand_in_spi,                                                                             \
        {                                                                                          \
            STAND_IN_HZ(node), (operation), (delay)                                                \
        }                                                                                          \
    }
#define STAND_IN_HZ(node)        STAND_IN_HZ_OF(node)
#define STAND_IN_HZ_OF(node)     STAND_IN_HZ_##node
#define STAND_IN_HZ_qtri_display 32000000

bool spi_is_ready_dt(const struct spi_dt_spec *spec);
int spi_write_dt(const struct spi_dt_spec *spec, const struct spi_buf_set *tx_bufs);
int spi_transceive_cb(const struct device *dev, const struct spi_config *config,
                      const struct spi_buf_set *tx_bufs, const struct spi_buf_set *rx_bufs,
                      spi_callback_t callback, void *userdata);

#endif
