/* SPDX-License-Identifier: MIT */
/*
 * Stand-ins for what port/examples/glue/tft_espi.cpp calls, declared as Bodmer's TFT_eSPI 2.5
 * (TFT_eSPI.h, class TFT_eSPI) documents them.
 */
#ifndef QTRI_TESTS_TFT_ESPI_H
#define QTRI_TESTS_TFT_ESPI_H

#include <Arduino.h>

class TFT_eSPI
{
  public:
    void init(uint8_t tc = 0);
    void setRotation(uint8_t r);
    void setSwapBytes(bool swap);
    void startWrite();
    void setAddrWindow(int32_t xs, int32_t ys, int32_t w, int32_t h);
    void pushPixels(const void *data_in, uint32_t len);
    int16_t width();
    int16_t height();
};

#endif
