/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

const qtri_format qtri_rgb565 = {&qtri_pixels_16, &qtri_colors_565, NULL, qtri_decode_rgb565, NULL,
                                 QTRI_RGB565};
