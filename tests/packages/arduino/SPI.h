/* SPDX-License-Identifier: MIT */
/* A stand-in for Arduino's SPI library. */
#ifndef QTRI_TESTS_SPI_H
#define QTRI_TESTS_SPI_H

#include "Arduino.h"

#define SPI_MODE0 0x00

struct SPISettings {
    SPISettings(uint32_t clock, uint8_t order, uint8_t mode);
};

struct SPIClass {
    void begin();
    void beginTransaction(SPISettings settings);
    uint8_t transfer(uint8_t byte);
};

extern SPIClass SPI;

#endif
