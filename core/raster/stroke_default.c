/* SPDX-License-Identifier: MIT */
#include "qtri/stroke.h"

qtri_stroke qtri_stroke_default(void)
{
    qtri_stroke stroke = {
        .width = Q16_ONE,
        .cap = QTRI_CAP_ROUND,
        .edges = &qtri_stroke_smooth,
        .alpha = 255,
        .closed = false,
        .in_space = false,
    };
    return stroke;
}
