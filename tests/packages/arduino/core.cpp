/* SPDX-License-Identifier: MIT */
/* Runs a sketch for two frames; prints how many bytes of pixels it sent and how many were not sky.
 */
#include "SPI.h"

#include <stdio.h>

SPIClass SPI;
static unsigned long bytes, drawn;
static bool isData;
static uint8_t high;

void pinMode(uint8_t, uint8_t)
{
}
void delay(unsigned long)
{
}

void digitalWrite(uint8_t pin, uint8_t value)
{
    if (pin == 9) {
        isData = value == HIGH;
    }
}

SPISettings::SPISettings(uint32_t, uint8_t, uint8_t)
{
}
void SPIClass::begin()
{
}
void SPIClass::beginTransaction(SPISettings)
{
}

uint8_t SPIClass::transfer(uint8_t byte)
{
    if (isData && bytes++ % 2 != 0) {
        drawn += (high << 8 | byte) != 0x1906; /* sky: 24, 32, 48 */
    } else {
        high = byte;
    }
    return 0;
}

int main()
{
    setup();
    bytes = drawn = 0;
    loop();
    loop();
    printf("%lu bytes, %lu pixels drawn\n", bytes, drawn);
    return bytes > 2UL * 240 * 320 * 2 && drawn > 2UL * 3000 ? 0 : 1;
}
