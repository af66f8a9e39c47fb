/* SPDX-License-Identifier: MIT */
/*
 * Memory-mapped displays: an LCD controller (STM32's LTDC, Arm's PL110) shows a framebuffer that
 * the board has set up. No bus, no commands; qtri_panel_write converts, rotates and stores.
 *
 * A frame that need not be rotated or converted can be drawn in place instead: a surface whose
 * pixels are the framebuffer. Bands in fast memory are often the quicker way all the same.
 */
#ifndef QTRI_PORT_FRAMEBUFFER_H
#define QTRI_PORT_FRAMEBUFFER_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * A description: static const qtri_panel_description lcd =
 *     QTRI_FRAMEBUFFER(320, 240, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
 * format: RGB565 or XRGB8888. The framebuffer is the memory of qtri_panel_init, aligned as it may
 * be.
 */
#define QTRI_FRAMEBUFFER(width, height, format, order)                                             \
    {                                                                                              \
        width, height, format, order, NULL, 0, NULL, 0, false, 0, 0, 0, 0, 0, {0, 0, 0, 0}, 0, 0,  \
            0, width, height, 0, 0, NULL, qtri_panel_write_mapped, 0, false, 0, false, {0, 0},     \
            NULL                                                                                   \
    }

#ifdef __cplusplus
}
#endif

#endif
