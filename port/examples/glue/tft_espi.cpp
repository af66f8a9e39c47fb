/* SPDX-License-Identifier: MIT */
/*
 * The examples into a display that Bodmer's TFT_eSPI drives: its User_Setup.h says which one, and
 * on which pins. For who has that running already, or a display that qtri has no description of.
 * Files as arduino.cpp says.
 *
 * The panel is one of qtri's own making: its window is setAddrWindow, its pixels are pushPixels.
 * RGB565 with the high byte first, as qtri_rgb565_swapped surfaces have it, goes out as it is.
 */
#include <TFT_eSPI.h>

#include "../example.h"

static TFT_eSPI tft;
/* pushPixels takes pixels of 16 bits: on an RP2040 its DMA and PIO read them so. */
alignas(4) static uint8_t lineMemory[QTRI_PANEL_LINE_BYTES(320)];

static enum qtri_error openWindow(const qtri_panel *, const qtri_rect *window)
{
    tft.setAddrWindow(window->x0, window->y0, window->x1 - window->x0, window->y1 - window->y0);
    return QTRI_OK;
}

static bool sendPixels(void *, const uint8_t *bytes, size_t count)
{
    tft.pushPixels(bytes, (uint32_t)(count / 2));
    return true;
}

/* There are no commands: TFT_eSPI has sent them. */
static bool sendNothing(void *, const uint8_t *, size_t)
{
    return false;
}

static void waitMs(void *, uint32_t ms)
{
    delay(ms);
}

static const qtri_bus bus = {NULL, sendNothing, sendPixels, NULL, NULL, waitMs, NULL, NULL, 0};

enum qtri_error example_display(qtri_panel *panel)
{
    static qtri_panel_description screen;
    tft.init();
    tft.setRotation(1);
    tft.setSwapBytes(false);
    tft.startWrite(); /* chip select stays low: the display is alone on its bus */
    screen.width = screen.memory_width = (uint16_t)tft.width();
    screen.height = screen.memory_height = (uint16_t)tft.height();
    screen.format = QTRI_PANEL_RGB565;
    screen.order = QTRI_ORDER_BIG;
    screen.window = openWindow;
    screen.write = qtri_panel_write_565;
    return qtri_panel_init(panel, &screen, &bus, QTRI_ROTATE_0, lineMemory, sizeof lineMemory);
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
