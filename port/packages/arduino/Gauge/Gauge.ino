// SPDX-License-Identifier: MIT
// A dial whose needle follows an analog input, on a 240x320 ILI9341 display. After the first frame only the rectangle
// is drawn and sent that the needle leaves and enters.
#include <SPI.h>
#include <qtri.h>
#include <qtri_port/ili9341.h>
#include <qtri_port/screen.h>

const int PIN_CS = 10, PIN_DC = 9, PIN_RESET = 8, PIN_INPUT = A0;

// Chip select is low while the bus is the display's: from setup on.
static bool sendBytes(const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        SPI.transfer(bytes[i]);
    }
    return true;
}

static bool sendCommand(void *, const uint8_t *bytes, size_t count)
{
    digitalWrite(PIN_DC, LOW);
    return sendBytes(bytes, count);
}

static bool sendData(void *, const uint8_t *bytes, size_t count)
{
    digitalWrite(PIN_DC, HIGH);
    return sendBytes(bytes, count);
}

static void waitMs(void *, uint32_t ms)
{
    delay(ms);
}

static void resetDisplay(void *, bool active)
{
    digitalWrite(PIN_RESET, active ? LOW : HIGH);
}

static const qtri_bus bus = {NULL, sendCommand, sendData, NULL, NULL, waitMs, resetDisplay, NULL, 0};

static uint8_t screenMemory[QTRI_SCREEN_BYTES(240, 16, QTRI_RGB565_BYTES)];
static qtri_screen screen;

const int X = 120, Y = 160, RADIUS = 100; // of the dial

// A point of it; 24.8 is what the functions that paint take.
static qtri_point at(q16 part, int radius)
{
    const q16 degrees = Q16(225) - q16_mul(Q16(270), part);
    qtri_point p;
    p.x_24p8 = X * 256 + (int32_t)(((int64_t)q16_cos_deg(degrees) * radius) >> 8);
    p.y_24p8 = Y * 256 - (int32_t)(((int64_t)q16_sin_deg(degrees) * radius) >> 8);
    return p;
}

// The pixels that the needle may touch.
static qtri_rect boxOf(q16 part)
{
    const qtri_point tip = at(part, RADIUS - 20);
    const int x = tip.x_24p8 / 256, y = tip.y_24p8 / 256;
    qtri_rect box = {x < X ? x : X, y < Y ? y : Y, x < X ? X : x, y < Y ? Y : y};
    box.x0 -= 12;
    box.y0 -= 12;
    box.x1 += 12;
    box.y1 += 12;
    return box;
}

void setup()
{
    pinMode(PIN_CS, OUTPUT);
    pinMode(PIN_DC, OUTPUT);
    pinMode(PIN_RESET, OUTPUT);
    digitalWrite(PIN_CS, LOW);
    SPI.begin();
    SPI.beginTransaction(SPISettings(24000000, MSBFIRST, SPI_MODE0));
    qtri_screen_init(&screen, &qtri_ili9341, &bus, QTRI_ROTATE_0, &qtri_rgb565, 16, screenMemory, sizeof screenMemory);
    screen.background = {18, 20, 26};
}

void loop()
{
    static q16 value = 0, before = 0;
    const qtri_brush white = qtri_brush_of({235, 235, 235}), red = qtri_brush_of({225, 50, 40}), green = qtri_brush_of({60, 170, 90});
    value += q16_mul(q16_from_ratio(analogRead(PIN_INPUT), 1023) - value, Q16(0.3)); // the needle is slow
    value = value < 0 ? 0 : value > Q16(1) ? Q16(1) : value;

    const qtri_rect left = boxOf(before), entered = boxOf(value);
    qtri_frame_mark(&screen.frame, &left);
    qtri_frame_mark(&screen.frame, &entered);
    qtri_frame_only_changes(&screen.frame);
    before = value;

    qtri_surface band;
    while (qtri_screen_next(&screen, &band)) {
        for (int i = 0; i <= 20; i++) {
            const qtri_point outer = at(q16_from_ratio(i, 20), RADIUS), inner = at(q16_from_ratio(i, 20), RADIUS - (i % 5 == 0 ? 18 : 9));
            qtri_paint_stroke(&band, &inner, &outer, 2 * 256, i < 15 ? &green : &red);
        }
        const qtri_point tip = at(value, RADIUS - 20), hub = {X * 256, Y * 256};
        qtri_paint_stroke(&band, &hub, &tip, 5 * 256, &red);
        qtri_paint_circle(&band, &hub, 9 * 256, &white);
    }
}
