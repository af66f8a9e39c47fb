/* SPDX-License-Identifier: MIT */
#include "qtri/stroke.h"

/*
 * The constant has a name because it holds an address: in a file of the whole library, a linker
 * that keeps one constant without a name keeps them all, and here the smooth edges with them.
 */
static const qtri_stroke smooth_line = {
    .width = Q16_ONE,
    .cap = QTRI_CAP_ROUND,
    .edges = &qtri_stroke_smooth,
    .alpha = 255,
    .closed = false,
    .in_space = false,
};

qtri_stroke qtri_stroke_default(void)
{
    return smooth_line;
}
