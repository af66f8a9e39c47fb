/* SPDX-License-Identifier: MIT */
/*
 * An application, as `make size` measures it: written as a user would, through qtri.h alone.
 */
#ifndef APP_H
#define APP_H

#include "qtri.h"

#define APP_WIDTH     320
#define APP_HEIGHT    240
#define APP_BAND_ROWS 16
#define APP_FRAMES    12

/* Once; then frame 0, 1, ... APP_FRAMES - 1: the object turns and comes nearer, at last so near
   that it is clipped. */
void app_setup(void);
void app_frame(int32_t number);

/* Sends a band to the display; not the application's. */
void display_write(const qtri_surface *band);

#endif
