/* SPDX-License-Identifier: MIT */
/*
 * What stands at the other end of the glue of port/examples/glue: a simulated ILI9341 on a bus. The
 * stand-ins of vendors' functions send there.
 */
#ifndef QTRI_TESTS_GLUE_DISPLAY_H
#define QTRI_TESTS_GLUE_DISPLAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Pins and time. Nothing may change while DMA runs. */
void glue_data_pin(bool is_data);
void glue_reset_pin(bool is_low);
void glue_wait(uint32_t ms);

/* Bytes, at once or by DMA: taken when it finishes, and then they must be as they were. */
void glue_send(const void *bytes, size_t count);
void glue_start(const void *bytes, size_t count);
bool glue_is_sending(void);

/* After three frames it ends the program: status 0 if the controller has no complaint and shows
   something, as it does with a picture. */
void glue_finish(void);

/* For displays that other libraries drive: pixels of 320x240 in RGB565, high byte first, into a
   window, and the same end. */
void glue_window(int x, int y, int width, int height);
void glue_pixels(const void *bytes, size_t count);

/* Ends the program at once. */
void glue_stop(int status, const char *why);

#ifdef __cplusplus
}
#endif

#endif
