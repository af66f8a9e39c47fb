/* SPDX-License-Identifier: MIT */
/* The stand-ins of TFT_eSPI at work. */
#include "TFT_eSPI.h"

#include "../glue/display.h"

static bool isWriting, isTurned, isSwapped = true;

void TFT_eSPI::init(uint8_t)
{
}

void TFT_eSPI::setRotation(uint8_t r)
{
    isTurned = r % 2 == 1;
}

void TFT_eSPI::setSwapBytes(bool swap)
{
    isSwapped = swap;
}

void TFT_eSPI::startWrite()
{
    isWriting = true;
}

void TFT_eSPI::setAddrWindow(int32_t xs, int32_t ys, int32_t w, int32_t h)
{
    glue_window(xs, ys, w, h);
}

void TFT_eSPI::pushPixels(const void *data_in, uint32_t len)
{
    if (!isWriting || isSwapped) {
        glue_stop(1, "pixels in the wrong order, or without chip select");
    }
    glue_pixels(data_in, len);
}

int16_t TFT_eSPI::width()
{
    return isTurned ? 320 : 240;
}

int16_t TFT_eSPI::height()
{
    return isTurned ? 240 : 320;
}

void delay(unsigned long)
{
}

int main()
{
    setup();
    for (;;) { /* frames end it */
        loop();
    }
}
