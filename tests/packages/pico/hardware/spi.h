/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_PICO_SPI_H
#define QTRI_TESTS_PICO_SPI_H

#include "pico/stdlib.h"

typedef struct spi_inst spi_inst_t;
typedef struct {
    volatile uint32_t cr0, cr1, dr, sr;
} spi_hw_t;

#define spi0 ((spi_inst_t *)spi0_hw_address)
extern uint8_t spi0_hw_address[];

uint spi_init(spi_inst_t *spi, uint baudrate);
int spi_write_blocking(spi_inst_t *spi, const uint8_t *src, size_t len);
bool spi_is_busy(const spi_inst_t *spi);
uint spi_get_dreq(spi_inst_t *spi, bool is_tx);
spi_hw_t *spi_get_hw(spi_inst_t *spi);

#endif
