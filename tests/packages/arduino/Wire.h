/* SPDX-License-Identifier: MIT */
/* A stand-in for Arduino's Wire library. */
#ifndef QTRI_TESTS_WIRE_H
#define QTRI_TESTS_WIRE_H

#include "Arduino.h"

struct WireClass {
    void begin();
    void setClock(uint32_t clock);
    void beginTransmission(uint8_t address);
    size_t write(const uint8_t *bytes, size_t count);
    uint8_t endTransmission();
};

extern WireClass Wire;

#endif
