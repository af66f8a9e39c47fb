/* SPDX-License-Identifier: MIT */
/*
 * Stand-ins for what port/examples/glue/lovyangfx.cpp calls, declared as LovyanGFX 1.1 documents
 * them (doc/, class LGFXBase): the functions of pixels are templates over the kind of colour.
 */
#ifndef QTRI_TESTS_LOVYANGFX_HPP
#define QTRI_TESTS_LOVYANGFX_HPP

#include <stddef.h>
#include <stdint.h>

#ifndef LGFX_AUTODETECT
#error "LGFX is the detected board's"
#endif

void setup();
void loop();

namespace lgfx
{
struct swap565_t {
    uint16_t raw;
};

void delay(unsigned long ms);
} // namespace lgfx

class LGFX
{
  public:
    bool init();
    void setRotation(uint_fast8_t rotation);
    void startWrite(bool transaction = true);
    void setAddrWindow(int32_t x, int32_t y, int32_t w, int32_t h);
    template <typename T>
    void writePixels(const T *data, int32_t len);
    template <typename T>
    void writePixelsDMA(const T *data, int32_t len);
    void waitDMA();
    int32_t width() const;
    int32_t height() const;
};

#endif
