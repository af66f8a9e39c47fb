/* SPDX-License-Identifier: MIT */
/* The stand-ins of LovyanGFX at work. */
#define LGFX_AUTODETECT
#include "LovyanGFX.hpp"

#include "../glue/display.h"

static bool isWriting, isTurned;
static const void *flying;
static size_t flyingPixels;

void lgfx::delay(unsigned long)
{
}

bool LGFX::init()
{
    return true;
}

void LGFX::setRotation(uint_fast8_t rotation)
{
    isTurned = rotation % 2 == 1;
}

void LGFX::startWrite(bool)
{
    isWriting = true;
}

void LGFX::setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h)
{
    if (flying != NULL || !isWriting) {
        glue_stop(1, "a window while DMA runs, or without chip select");
    }
    glue_window(x, y, w, h);
}

template <>
void LGFX::writePixels(const lgfx::swap565_t *data, int32_t len)
{
    glue_pixels(data, (size_t)len);
}

template <>
void LGFX::writePixelsDMA(const lgfx::swap565_t *data, int32_t len)
{
    flying = data;
    flyingPixels = (size_t)len;
}

/* The pixels are looked at when DMA ends: who has drawn over them is seen. */
void LGFX::waitDMA()
{
    glue_pixels(flying, flyingPixels);
    flying = NULL;
}

int32_t LGFX::width() const
{
    return isTurned ? 320 : 240;
}

int32_t LGFX::height() const
{
    return isTurned ? 240 : 320;
}

int main()
{
    setup();
    return 1; /* frames end it */
}
