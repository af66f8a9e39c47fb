/* SPDX-License-Identifier: MIT */
/*
 * Runs a sketch for three frames. What it sends goes to a simulated controller, an ILI9341 on SPI
 * or an SSD1306 on I2C, which must show something and have no complaint.
 */
#include "SPI.h"
#include "Wire.h"

#include <stdio.h>

extern "C" {
#include <panels/controllers.h>
}

SPIClass SPI;
WireClass Wire;
static lcd spiDisplay;
static ssd1306 wireDisplay;
static bool isData;
static uint8_t transfer[32];
static size_t transferBytes;
static unsigned long spiBytes, wireBytes;

void pinMode(uint8_t, uint8_t)
{
}

void delay(unsigned long ms)
{
    chip_wait(&spiDisplay.chip, (uint32_t)ms);
    chip_wait(&wireDisplay.chip, (uint32_t)ms);
}

int analogRead(uint8_t)
{
    return 700;
}

void digitalWrite(uint8_t pin, uint8_t value)
{
    if (pin == 9) {
        isData = value == HIGH;
    } else if (pin == 8) {
        chip_reset_pin(&spiDisplay.chip, value == LOW);
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
    chip_send(&spiDisplay.chip, isData, &byte, 1);
    spiBytes++;
    return 0;
}

void WireClass::begin()
{
}
void WireClass::setClock(uint32_t)
{
}

void WireClass::beginTransmission(uint8_t address)
{
    transferBytes = address == 0x3C ? 0 : sizeof transfer;
}

size_t WireClass::write(const uint8_t *bytes, size_t count)
{
    size_t taken = 0;
    for (; taken < count && transferBytes < sizeof transfer; taken++) {
        transfer[transferBytes++] = bytes[taken];
    }
    return taken;
}

uint8_t WireClass::endTransmission()
{
    chip_i2c(&wireDisplay.chip, transfer, transferBytes);
    wireBytes += transferBytes;
    return 0;
}

static unsigned long drawn(const chip *display, int width, int height)
{
    unsigned long count = 0;
    for (int i = 0; i < width * height; i++) {
        count += chip_pixel(display, i % width, i / width) != chip_pixel(display, 0, 0);
    }
    return count;
}

int main()
{
    ili9341_init(&spiDisplay);
    ssd1306_init(&wireDisplay, 64);
    chip_reset_pin(&wireDisplay.chip, true); /* power on */
    chip_reset_pin(&wireDisplay.chip, false);
    setup();
    for (int i = 0; i < 3; i++) {
        loop();
    }
    const bool isSpi = spiBytes > 0;
    const chip *display = isSpi ? &spiDisplay.chip : &wireDisplay.chip;
    const unsigned long pixels = isSpi ? drawn(display, 240, 320) : drawn(display, 128, 64);
    printf("%lu bytes, %lu pixels drawn%s%s\n", isSpi ? spiBytes : wireBytes, pixels,
           display->error[0] != '\0' ? ", " : "", display->error);
    return pixels > 150 && display->error[0] == '\0' ? 0 : 1;
}
