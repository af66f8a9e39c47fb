// SPDX-License-Identifier: MIT
// A textured, lit torus that turns on a 240x320 ILI9341 display, 16 rows at a time. A model of your own takes its
// place: `qtri model car.glb -o car.h`.
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

enum { SLICES = 24, RINGS = 12, VERTICES = QTRI_TORUS_VERTICES(SLICES, RINGS), TRIANGLES = QTRI_TORUS_TRIANGLES(SLICES, RINGS) };
static qtri_vec3 positions[VERTICES];
static qtri_normal normals[VERTICES];
static qtri_vec2 uvs[VERTICES];
static uint16_t triangles[TRIANGLES][3];
static qtri_vertex vertices[VERTICES];

// Bricks of 8 x 8 texels, red and mortar.
#define R 0xB2A6
#define M 0xCE59
static const uint16_t bricks[64] = {R, R, R, M, R, R, R, R, R, R, R, M, R, R, R, R, R, R, R, M, R, R,
                                    R, R, M, M, M, M, M, M, M, M, R, R, R, R, R, R, R, M, R, R, R, R,
                                    R, R, R, M, R, R, R, R, R, R, R, M, M, M, M, M, M, M, M, M};

static uint8_t screenMemory[QTRI_SCREEN_BYTES(240, 16, QTRI_RGB565_BYTES)];
static qtri_screen screen;
static qtri_view view;
static qtri_mesh torus;
static qtri_texture texture;
static qtri_material material;
static qtri_light light;

void setup()
{
    pinMode(PIN_CS, OUTPUT);
    pinMode(PIN_DC, OUTPUT);
    pinMode(PIN_RESET, OUTPUT);
    digitalWrite(PIN_CS, LOW);
    SPI.begin();
    SPI.beginTransaction(SPISettings(24000000, MSBFIRST, SPI_MODE0));

    const qtri_shape_memory memory = {positions, normals, uvs, triangles, VERTICES, TRIANGLES};
    qtri_shape_torus(&torus, &memory, Q16(1), Q16(0.45), SLICES, RINGS);
    for (int i = 0; i < VERTICES; i++) { // the texture eight times around
        uvs[i].x *= 8;
        uvs[i].y *= 4;
    }
    texture.texels = bricks;
    texture.format = &qtri_texel_rgb565;
    texture.width_log2 = texture.height_log2 = 3;
    material = qtri_material_default();
    material.texture = &texture;

    const qtri_vec3 eye = {0, Q16(1.4), Q16(3)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    const qtri_vec3 towardsLight = {Q16(0.4), Q16(0.6), Q16(0.7)};
    qtri_view_init(&view, 240, 320);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(60), Q16(0.1), Q16(100));
    light.towards = towardsLight;
    light.ambient = Q16(0.2);
    light.diffuse = Q16(0.8);
    view.light = &light;
    view.vertices = vertices;
    view.vertex_count = VERTICES;

    qtri_screen_init(&screen, &qtri_ili9341, &bus, QTRI_ROTATE_0, &qtri_rgb565, 16, screenMemory, sizeof screenMemory);
    screen.background = {24, 32, 48};
}

void loop()
{
    static q16 angle = 0;
    angle = q16_mod(angle + Q16(2), Q16(360));
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_x(&pose, angle);
    qtri_transform_rotate_y(&pose, angle);
    qtri_surface band;
    while (qtri_screen_next(&screen, &band)) {
        qtri_draw_mesh(&band, &view, &pose, &torus, &material);
    }
}
