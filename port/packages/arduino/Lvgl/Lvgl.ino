// SPDX-License-Identifier: MIT
// A cube in a canvas of LVGL 9, among whatever other widgets there are. LVGL's display is one that TFT_eSPI drives:
// LV_USE_TFT_ESPI in lv_conf.h.
#include <lvgl.h>
#include <qtri.h>
#include <qtri_port/framebuffer.h>
#include <qtri_port/screen.h>

enum { WIDTH = 160, HEIGHT = 120 }; // of the canvas: 38 KB

static uint32_t lvglMemory[320 * 24 / 2];       // what LVGL draws into
static uint32_t pixels[WIDTH * HEIGHT / 2];     // of the canvas; words, as LVGL wants them aligned
static uint8_t bandMemory[QTRI_FRAME_BYTES(WIDTH, 24, QTRI_RGB565_BYTES)];
static qtri_vec3 positions[QTRI_BOX_VERTICES];
static qtri_normal normals[QTRI_BOX_VERTICES];
static uint16_t triangles[QTRI_BOX_TRIANGLES][3];
static qtri_vertex vertices[QTRI_BOX_VERTICES];

static const qtri_panel_description framebuffer = QTRI_FRAMEBUFFER(WIDTH, HEIGHT, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
static lv_obj_t *canvas;
static qtri_screen screen;
static qtri_view view;
static qtri_mesh cube;
static qtri_material material;
static qtri_light light;

static uint32_t milliseconds()
{
    return millis();
}

void setup()
{
    lv_init();
    lv_tick_set_cb(milliseconds);
    lv_tft_espi_create(320, 240, lvglMemory, sizeof lvglMemory);
    canvas = lv_canvas_create(lv_screen_active());
    lv_canvas_set_buffer(canvas, pixels, WIDTH, HEIGHT, LV_COLOR_FORMAT_RGB565);
    lv_obj_center(canvas);

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
    qtri_panel_init(&screen.panel, &framebuffer, NULL, QTRI_ROTATE_0, pixels, sizeof pixels);
    qtri_screen_begin(&screen, &qtri_rgb565, 24, bandMemory, sizeof bandMemory);
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
    lv_obj_invalidate(canvas);
    lv_timer_handler();
}
