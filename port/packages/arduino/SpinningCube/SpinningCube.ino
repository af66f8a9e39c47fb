// SPDX-License-Identifier: MIT
// A cube that turns on a 240x320 ILI9341 display, 16 rows at a time, lit from the front.
#include <SPI.h>
#include <qtri.h>
#include <qtri_port/ili9341.h>
#include <qtri_port/screen.h>

const int PIN_CS = 10, PIN_DC = 9, PIN_RESET = 8;

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

static const qtri_vec3 corners[8] = {
    {-Q16(1), -Q16(1), -Q16(1)}, {Q16(1), -Q16(1), -Q16(1)}, {-Q16(1), Q16(1), -Q16(1)}, {Q16(1), Q16(1), -Q16(1)},
    {-Q16(1), -Q16(1), Q16(1)},  {Q16(1), -Q16(1), Q16(1)},  {-Q16(1), Q16(1), Q16(1)},  {Q16(1), Q16(1), Q16(1)}};
// Counter-clockwise, as seen from outside.
static const uint16_t faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

static uint8_t screenMemory[QTRI_SCREEN_BYTES(240, 16, QTRI_RGB565_BYTES)];
static qtri_vertex vertices[8];

static qtri_screen screen;
static qtri_view view;
static qtri_mesh cube;
static qtri_material material;
static const qtri_light light = {.towards = {Q16(0.4), Q16(0.6), Q16(0.7)}, .ambient = Q16(0.2), .diffuse = Q16(0.8)};

void setup()
{
    pinMode(PIN_CS, OUTPUT);
    pinMode(PIN_DC, OUTPUT);
    pinMode(PIN_RESET, OUTPUT);
    digitalWrite(PIN_CS, LOW);
    SPI.begin();
    SPI.beginTransaction(SPISettings(24000000, MSBFIRST, SPI_MODE0));

    cube.positions = corners;
    cube.vertex_count = 8;
    cube.triangles = faces;
    cube.triangle_count = 12;
    material = qtri_material_default();
    material.color = {240, 150, 40};

    const qtri_vec3 eye = {0, 0, Q16(5)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    qtri_view_init(&view, 240, 320);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(60), Q16(0.1), Q16(100));
    view.light = &light;
    view.vertices = vertices;
    view.vertex_count = 8;

    qtri_screen_init(&screen, &qtri_ili9341, &bus, QTRI_ROTATE_0, &qtri_rgb565, 16, screenMemory, sizeof screenMemory);
    screen.background = {24, 32, 48};
}

void loop()
{
    static q16 angle = 0;
    angle = q16_mod(angle + Q16(2), Q16(360));
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_x(&pose, Q16(25));
    qtri_transform_rotate_y(&pose, angle);
    qtri_surface band;
    while (qtri_screen_next(&screen, &band)) {
        qtri_draw_mesh(&band, &view, &pose, &cube, &material);
    }
}
