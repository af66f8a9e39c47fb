/* SPDX-License-Identifier: MIT */
/* Arduino's core and SPI at work for port/examples/glue/arduino.cpp: bytes go to the display. */
#include "SPI.h"

#include "../glue/display.h"

SPIClass SPI;

void pinMode(uint8_t, uint8_t)
{
}

void digitalWrite(uint8_t pin, uint8_t value)
{
    if (pin == 9) {
        glue_data_pin(value == HIGH);
    } else if (pin == 8) {
        glue_reset_pin(value == LOW);
    }
}

void delay(unsigned long ms)
{
    glue_wait((uint32_t)ms);
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
    glue_send(&byte, 1);
    return 0;
}

int main()
{
    setup();
    return 1; /* frames end it */
}
