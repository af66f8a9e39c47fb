/* SPDX-License-Identifier: MIT */
/*
 * Stand-ins for what port/examples/glue/lvgl.c and the sketch call, declared as LVGL 9's
 * documentation describes them (API: lv_canvas.h, lv_obj_pos.h, lv_timer.h, lv_display.h,
 * lv_tick.h).
 */
#ifndef QTRI_TESTS_LVGL_H
#define QTRI_TESTS_LVGL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lv_obj lv_obj_t;
typedef void lv_display_t;
typedef enum { LV_COLOR_FORMAT_RGB565 = 0x12 } lv_color_format_t;

lv_obj_t *lv_screen_active(void);
lv_obj_t *lv_canvas_create(lv_obj_t *parent);
void lv_canvas_set_buffer(lv_obj_t *obj, void *buf, int32_t w, int32_t h, lv_color_format_t cf);
void lv_obj_center(lv_obj_t *obj);
void lv_obj_invalidate(const lv_obj_t *obj);
uint32_t lv_timer_handler(void);
void lv_delay_ms(uint32_t ms);
void lv_init(void);
void lv_tick_set_cb(uint32_t (*cb)(void));
lv_display_t *lv_tft_espi_create(uint32_t hor_res, uint32_t ver_res, void *buf,
                                 uint32_t buf_size_bytes);

#ifdef __cplusplus
}
#endif

#endif
