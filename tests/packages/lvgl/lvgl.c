/* SPDX-License-Identifier: MIT */
/* The stand-ins of LVGL at work: its display gets what the canvas holds when it was invalidated. */
#include "lvgl.h"

#include "../glue/display.h"

struct lv_obj {
    const void *buffer;
    int32_t width, height;
    int is_invalid;
};

static lv_obj_t screen, canvas;

lv_obj_t *lv_screen_active(void)
{
    return &screen;
}

lv_obj_t *lv_canvas_create(lv_obj_t *parent)
{
    return parent == &screen ? &canvas : NULL;
}

void lv_canvas_set_buffer(lv_obj_t *obj, void *buf, int32_t w, int32_t h, lv_color_format_t cf)
{
    obj->buffer = cf == LV_COLOR_FORMAT_RGB565 ? buf : NULL;
    obj->width = w;
    obj->height = h;
}

void lv_obj_center(lv_obj_t *obj)
{
    (void)obj;
}

void lv_obj_invalidate(const lv_obj_t *obj)
{
    canvas.is_invalid = obj == &canvas;
}

uint32_t lv_timer_handler(void)
{
    if (!canvas.is_invalid || canvas.buffer == NULL) {
        glue_stop(1, "nothing to show");
    }
    glue_window(0, 0, canvas.width, canvas.height);
    glue_pixels(canvas.buffer, (size_t)canvas.width * (size_t)canvas.height);
    canvas.is_invalid = 0;
    return 5;
}

void lv_delay_ms(uint32_t ms)
{
    (void)ms;
}

void lv_init(void)
{
}

void lv_tick_set_cb(uint32_t (*cb)(void))
{
    (void)cb;
}

lv_display_t *lv_tft_espi_create(uint32_t hor_res, uint32_t ver_res, void *buf,
                                 uint32_t buf_size_bytes)
{
    (void)hor_res;
    (void)ver_res;
    return buf_size_bytes > 0 ? buf : NULL;
}
