/* SPDX-License-Identifier: MIT */
/*
 * The examples into a display that lovyan03's LovyanGFX drives, by DMA where it has it. Files as
 * arduino.cpp says; here for a board that LovyanGFX knows by itself (LGFX_AUTODETECT), else its own
 * configuration takes the place of the two lines below.
 *
 * The panel is one of qtri's own making: its window is setAddrWindow, its pixels are
 * writePixelsDMA. RGB565 with the high byte first is what LovyanGFX calls swap565_t, and goes out
 * as it is.
 */
#define LGFX_AUTODETECT
#include <LovyanGFX.hpp>

#include "../example.h"

static LGFX lcd;
alignas(4) static uint8_t lineMemory[QTRI_PANEL_LINE_BYTES(320)]; /* of pixels, by DMA */

static enum qtri_error openWindow(const qtri_panel *, const qtri_rect *window)
{
    lcd.setAddrWindow(window->x0, window->y0, window->x1 - window->x0, window->y1 - window->y0);
    return QTRI_OK;
}

static bool sendPixels(void *, const uint8_t *bytes, size_t count)
{
    lcd.writePixels(reinterpret_cast<const lgfx::swap565_t *>(bytes), (int32_t)(count / 2));
    return true;
}

static bool startPixels(void *, const uint8_t *bytes, size_t count)
{
    lcd.writePixelsDMA(reinterpret_cast<const lgfx::swap565_t *>(bytes), (int32_t)(count / 2));
    return true;
}

static bool finishPixels(void *)
{
    lcd.waitDMA();
    return true;
}

/* There are no commands: LovyanGFX has sent them. */
static bool sendNothing(void *, const uint8_t *, size_t)
{
    return false;
}

static void waitMs(void *, uint32_t ms)
{
    lgfx::delay(ms);
}

static const qtri_bus bus = {NULL, sendNothing, sendPixels, startPixels, finishPixels, waitMs,
                             NULL, NULL,        0};

enum qtri_error example_display(qtri_panel *panel)
{
    static qtri_panel_description screen;
    if (!lcd.init()) {
        return QTRI_ERROR_BUS;
    }
    lcd.setRotation(1);
    lcd.startWrite(); /* chip select stays low: the display is alone on its bus */
    screen.width = screen.memory_width = (uint16_t)lcd.width();
    screen.height = screen.memory_height = (uint16_t)lcd.height();
    screen.format = QTRI_PANEL_RGB565;
    screen.order = QTRI_ORDER_BIG;
    screen.window = openWindow;
    screen.write = qtri_panel_write_565;
    return qtri_panel_init(panel, &screen, &bus, QTRI_ROTATE_0, lineMemory, sizeof lineMemory);
}

/* As fast as it goes: the last band may be on its way while the next frame begins. */
bool example_next_frame(qtri_panel *panel)
{
    (void)panel;
    return true;
}

void setup()
{
    (void)example_run();
}

void loop()
{
}
