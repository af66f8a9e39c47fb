/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

#include "barrier.h"

/* Of three bytes the lowest is first: red. */
static void encode(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_reversed(c) >> 8)
}

const qtri_format qtri_rgb888 = {
    &qtri_pixels_24, &qtri_colors_888, encode, qtri_decode_rgb888, NULL, QTRI_RGB888};
