/* SPDX-License-Identifier: MIT */
/*
 * The examples in the Arduino IDE, with an ILI9341 on the board's SPI:
 *
 *   display   board
 *   SCK       SCK         CS      10
 *   MOSI      MOSI        DC      9
 *   LED       3V3         RESET   8
 *
 * A sketch's folder, with the library that `make dist` makes installed:
 *
 *   mesh/mesh.ino                    empty: setup() and loop() are here
 *   mesh/src/example.h
 *   mesh/src/mesh/mesh.c, ring.h     the folder as it is
 *   mesh/src/glue/arduino.cpp        this file; tft_espi.cpp or lovyangfx.cpp in its place
 *
 * SPI.transfer works on every board. Where a core has SPI.transfer with a buffer that it does not
 * overwrite, or DMA, `send` is the place for it.
 */
#include <Arduino.h>
#include <SPI.h>

#include "../example.h"
#include "qtri_port/ili9341.h"

static const uint8_t PIN_CS = 10, PIN_DC = 9, PIN_RESET = 8;
static uint8_t lineMemory[QTRI_PANEL_LINE_BYTES(320)];

static bool send(uint8_t dataPin, const uint8_t *bytes, size_t count)
{
    digitalWrite(PIN_DC, dataPin);
    for (size_t i = 0; i < count; i++) {
        SPI.transfer(bytes[i]);
    }
    return true;
}

static bool sendCommand(void *, const uint8_t *bytes, size_t count)
{
    return send(LOW, bytes, count);
}

static bool sendData(void *, const uint8_t *bytes, size_t count)
{
    return send(HIGH, bytes, count);
}

static void waitMs(void *, uint32_t ms)
{
    delay(ms);
}

static void resetDisplay(void *, bool active)
{
    digitalWrite(PIN_RESET, active ? LOW : HIGH);
}

static const qtri_bus bus = {NULL,   sendCommand,  sendData, NULL, NULL,
                             waitMs, resetDisplay, NULL,     0};

enum qtri_error example_display(qtri_panel *panel)
{
    pinMode(PIN_CS, OUTPUT);
    pinMode(PIN_DC, OUTPUT);
    pinMode(PIN_RESET, OUTPUT);
    digitalWrite(PIN_CS, LOW); /* the display is alone on its bus */
    SPI.begin();
    SPI.beginTransaction(SPISettings(24000000, MSBFIRST, SPI_MODE0));
    return qtri_panel_init(panel, &qtri_ili9341, &bus, QTRI_ROTATE_90, lineMemory,
                           sizeof lineMemory);
}

/* As fast as it goes. */
bool example_next_frame(qtri_panel *panel)
{
    return qtri_panel_finish(panel) == QTRI_OK;
}

void setup()
{
    (void)example_run();
}

void loop()
{
}
