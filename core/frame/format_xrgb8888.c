/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

const qtri_format qtri_xrgb8888 = {
    &qtri_pixels_32, &qtri_colors_888, NULL, qtri_decode_xrgb8888, NULL, QTRI_XRGB8888};
