/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

const qtri_format qtri_gray8 = {&qtri_pixels_8, &qtri_colors_gray, NULL, qtri_decode_gray8,
                                NULL,           QTRI_GRAY8};
