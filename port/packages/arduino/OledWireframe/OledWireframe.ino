// SPDX-License-Identifier: MIT
// A cube of lines without hidden ones, on an SSD1306 of 128x64 over I2C, at address 0x3C.
#include <Wire.h>
#include <qtri.h>
#include <qtri_port/i2c.h>
#include <qtri_port/screen.h>
#include <qtri_port/ssd1306.h>

const uint8_t ADDRESS = 0x3C;

// A transfer of Wire holds 32 bytes on many boards.
static bool writeBytes(void *, const uint8_t *bytes, size_t count)
{
    Wire.beginTransmission(ADDRESS);
    Wire.write(bytes, count);
    return Wire.endTransmission() == 0;
}

static void waitMs(void *, uint32_t ms)
{
    delay(ms);
}

static uint8_t transferMemory[32];
static qtri_i2c i2c = {NULL, writeBytes, waitMs, NULL, transferMemory, sizeof transferMemory};

static uint8_t imageMemory[QTRI_SSD1306_BYTES];
static uint8_t bandMemory[QTRI_FRAME_BYTES(128, 64, QTRI_GRAY8_BYTES)];
static qtri_vec3 positions[QTRI_BOX_VERTICES];
static uint16_t triangles[QTRI_BOX_TRIANGLES][3];
static qtri_vertex vertices[QTRI_BOX_VERTICES];

static qtri_bus bus;
static qtri_screen screen;
static qtri_view view;
static qtri_mesh cube;
static qtri_material solid, edges;

void setup()
{
    Wire.begin();
    Wire.setClock(400000);

    const qtri_shape_memory memory = {positions, NULL, NULL, triangles, QTRI_BOX_VERTICES, QTRI_BOX_TRIANGLES};
    const qtri_vec3 half = {Q16(1), Q16(1), Q16(1)};
    qtri_shape_box(&cube, &memory, half);

    // First its faces in black, which hide what lies behind, then its edges.
    solid = edges = qtri_material_default();
    solid.color = {0, 0, 0};
    edges.fill = &qtri_wireframe;

    const qtri_vec3 eye = {0, 0, Q16(4)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    qtri_view_init(&view, 128, 64);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(50), Q16(0.1), Q16(100));
    view.vertices = vertices;
    view.vertex_count = QTRI_BOX_VERTICES;

    qtri_i2c_bus(&bus, &i2c);
    qtri_panel_init(&screen.panel, &qtri_ssd1306, &bus, QTRI_ROTATE_0, imageMemory, sizeof imageMemory);
    qtri_screen_begin(&screen, &qtri_gray8, 64, bandMemory, sizeof bandMemory);
}

void loop()
{
    static q16 angle = 0;
    angle = q16_mod(angle + Q16(3), Q16(360));
    qtri_transform pose;
    qtri_transform_identity(&pose);
    qtri_transform_rotate_x(&pose, Q16(25));
    qtri_transform_rotate_y(&pose, angle);
    qtri_surface band;
    while (qtri_screen_next(&screen, &band)) {
        qtri_draw_mesh(&band, &view, &pose, &cube, &solid);
        qtri_draw_mesh(&band, &view, &pose, &cube, &edges);
    }
}
