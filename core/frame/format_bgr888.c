/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

/* 0x00RRGGBB as it is: of three bytes the lowest is first, blue. */
const qtri_format qtri_bgr888 = {
    &qtri_pixels_24, &qtri_colors_888, NULL, qtri_decode_xrgb8888, NULL, QTRI_BGR888};
