/* SPDX-License-Identifier: MIT */
#include "qtri_port/screen.h"

#include "internal.h"

/* A screen without bands. */
static enum qtri_error refuse(qtri_screen *screen, enum qtri_error error)
{
    (void)qtri_frame_init(&screen->frame, NULL, 0, 0, 0, NULL, 0);
    screen->error = error;
    return error;
}

enum qtri_error qtri_screen_begin(qtri_screen *screen, const qtri_format *format, int32_t rows,
                                  void *memory, size_t bytes)
{
    QTRI_ASSERT(screen != NULL);
    const qtri_rgb black = {0, 0, 0};
    screen->background = black;
    screen->is_drawing = false;
    screen->error = qtri_frame_init(&screen->frame, format, qtri_panel_width(&screen->panel),
                                    qtri_panel_height(&screen->panel), rows, memory, bytes);
    return screen->error;
}

enum qtri_error qtri_screen_init(qtri_screen *screen, const qtri_panel_description *description,
                                 const qtri_bus *bus, qtri_rotation rotation,
                                 const qtri_format *format, int32_t rows, void *memory,
                                 size_t bytes)
{
    QTRI_ASSERT(screen != NULL && description != NULL);
    const bool is_turned = rotation == QTRI_ROTATE_90 || rotation == QTRI_ROTATE_270;
    const size_t wanted =
        QTRI_PANEL_LINE_BYTES(is_turned ? description->height : description->width);
    const size_t line = memory == NULL ? 0 : bytes < wanted ? bytes : wanted;
    const enum qtri_error error =
        qtri_panel_init(&screen->panel, description, bus, rotation, memory, line);
    const enum qtri_error begun = qtri_screen_begin(
        screen, format, rows, memory == NULL ? NULL : (uint8_t *)memory + line, bytes - line);
    return error == QTRI_OK ? begun : refuse(screen, error);
}

/* Two pixels of a word, read and written as other types elsewhere. */
#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) two_pixels;
#else
typedef uint32_t two_pixels;
#endif

/* Exchanges the bytes of each of `count` > 0 pixels of 16 bits. */
static void swap_bytes(uint8_t *pixels, size_t count)
{
    uint16_t *pixel = (uint16_t *)(void *)pixels;
    if (((uintptr_t)pixels & 3) != 0) {
        *pixel = (uint16_t)(*pixel << 8 | *pixel >> 8);
        pixel++;
        count--;
    }
    two_pixels *two = (two_pixels *)(void *)pixel;
    for (; count >= 2; count -= 2, two++) {
        *two = (*two & 0x00FF00FFu) << 8 | (*two >> 8 & 0x00FF00FFu);
    }
    if (count > 0) {
        pixel = (uint16_t *)(void *)two;
        *pixel = (uint16_t)(*pixel << 8 | *pixel >> 8);
    }
}

/* The rows of the band that are shown. They are not drawn on again: their bytes may change. */
static enum qtri_error send_band(qtri_screen *screen)
{
    const qtri_panel_description *description = screen->panel.description;
    qtri_surface shown;
    qtri_frame_shown(&screen->frame, &screen->band, &shown);
    const bool streams = description->window != NULL && description->format == QTRI_PANEL_RGB565;
    if (streams && screen->frame.other_pixels != NULL && qtri_panel_is_565(&shown) &&
        !qtri_panel_is_native(description->order)) {
        swap_bytes(shown.pixels, (size_t)shown.width * (size_t)shown.rows);
        shown.format = &qtri_rgb565_swapped;
    }
    enum qtri_error error = qtri_panel_write_rect(&screen->panel, &shown, shown.scissor);
    if (error == QTRI_OK && streams && screen->frame.other_pixels == NULL &&
        qtri_panel_is_in_place(&shown, description->order)) {
        error = qtri_panel_finish(&screen->panel); /* the next band is drawn where this one lies */
    }
    return error;
}

bool qtri_screen_next(qtri_screen *screen, qtri_surface *band)
{
    QTRI_ASSERT(screen != NULL && band != NULL);
    if (screen->is_drawing) {
        screen->is_drawing = false;
        screen->error = send_band(screen);
        if (screen->error != QTRI_OK) {
            qtri_frame_begin(&screen->frame);
            return false;
        }
    }
    if (!qtri_frame_next_band(&screen->frame, &screen->band)) {
        return false;
    }
    screen->error = QTRI_OK;
    screen->is_drawing = true;
    qtri_surface_clear(&screen->band, screen->background);
    *band = screen->band;
    return true;
}
