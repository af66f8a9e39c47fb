/* SPDX-License-Identifier: MIT */
/*
 * The examples in a window of LVGL 9: a canvas on the active screen, among other widgets. LVGL's
 * display is set up before, by whatever the project has for it; then `example_run();`.
 *
 * The canvas's buffer is the framebuffer of a panel, in RGB565 as LV_COLOR_FORMAT_RGB565 has it:
 * 320 x 240 take 150 KB; a smaller canvas takes less. lv_timer_handler() is called after each
 * frame and must not be called elsewhere.
 */
#include <lvgl.h>

#include "../example.h"
#include "qtri_port/framebuffer.h"

enum { WIDTH = 320, HEIGHT = 240 };

static uint32_t pixels[WIDTH * HEIGHT / 2]; /* words: LVGL wants them aligned */
static lv_obj_t *canvas;

enum qtri_error example_display(qtri_panel *panel)
{
    static const qtri_panel_description screen =
        QTRI_FRAMEBUFFER(WIDTH, HEIGHT, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    canvas = lv_canvas_create(lv_screen_active());
    if (canvas == NULL) {
        return QTRI_ERROR_MEMORY;
    }
    lv_canvas_set_buffer(canvas, pixels, WIDTH, HEIGHT, LV_COLOR_FORMAT_RGB565);
    lv_obj_center(canvas);
    return qtri_panel_init(panel, &screen, NULL, QTRI_ROTATE_0, pixels, sizeof pixels);
}

/* LVGL copies the canvas to its display, and tells when it wants to be called again. */
bool example_next_frame(qtri_panel *panel)
{
    (void)panel;
    lv_obj_invalidate(canvas);
    lv_delay_ms(lv_timer_handler() > 0 ? 1 : 0);
    return true;
}
