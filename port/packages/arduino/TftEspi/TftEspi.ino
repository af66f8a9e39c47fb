// SPDX-License-Identifier: MIT
// A cube on any display that Bodmer's TFT_eSPI drives: its User_Setup.h says which one and on which pins. The panel is
// one of the sketch's own making: its window is setAddrWindow, its pixels go to pushPixels.
#include <TFT_eSPI.h>
#include <qtri.h>
#include <qtri_port/screen.h>

const int WIDTH = 320, HEIGHT = 240; // in landscape; of a display of another size change these

static TFT_eSPI tft;

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

// There are no commands: TFT_eSPI has sent them.
static bool sendNothing(void *, const uint8_t *, size_t)
{
    return false;
}

static void waitMs(void *, uint32_t ms)
{
    delay(ms);
}

static const qtri_bus bus = {NULL, sendNothing, sendPixels, NULL, NULL, waitMs, NULL, NULL, 0};

alignas(4) static uint8_t screenMemory[QTRI_SCREEN_BYTES(WIDTH, 16, QTRI_RGB565_BYTES)];
static qtri_vec3 positions[QTRI_BOX_VERTICES];
static qtri_normal normals[QTRI_BOX_VERTICES];
static uint16_t triangles[QTRI_BOX_TRIANGLES][3];
static qtri_vertex vertices[QTRI_BOX_VERTICES];

static qtri_panel_description display;
static qtri_screen screen;
static qtri_view view;
static qtri_mesh cube;
static qtri_material material;
static qtri_light light;

void setup()
{
    tft.init();
    tft.setRotation(1);
    tft.setSwapBytes(false);
    tft.startWrite(); // chip select stays low: the display is alone on its bus
    display.width = display.memory_width = WIDTH;
    display.height = display.memory_height = HEIGHT;
    display.format = QTRI_PANEL_RGB565;
    display.order = QTRI_ORDER_BIG;
    display.window = openWindow;
    display.write = qtri_panel_write_565;

    const qtri_shape_memory memory = {positions, normals, NULL, triangles, QTRI_BOX_VERTICES, QTRI_BOX_TRIANGLES};
    const qtri_vec3 half = {Q16(1), Q16(1), Q16(1)};
    qtri_shape_box(&cube, &memory, half);
    material = qtri_material_default();
    material.color = {240, 150, 40};

    const qtri_vec3 eye = {0, 0, Q16(4)}, center = {0, 0, 0}, up = {0, Q16(1), 0};
    const qtri_vec3 towardsLight = {Q16(0.4), Q16(0.6), Q16(0.7)};
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_view_look_at(&view, eye, center, up);
    qtri_view_perspective(&view, Q16(60), Q16(0.1), Q16(100));
    light.towards = towardsLight;
    light.ambient = Q16(0.2);
    light.diffuse = Q16(0.8);
    view.light = &light;
    view.vertices = vertices;
    view.vertex_count = QTRI_BOX_VERTICES;
    qtri_screen_init(&screen, &display, &bus, QTRI_ROTATE_0, &qtri_rgb565, 16, screenMemory, sizeof screenMemory);
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
