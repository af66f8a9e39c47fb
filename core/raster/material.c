/* SPDX-License-Identifier: MIT */
#include "descriptions.h"

qtri_material qtri_material_default(void)
{
    qtri_material material = {
        .color = {255, 255, 255},
        .shading = QTRI_SMOOTH,
        .interpolation = QTRI_PERSPECTIVE,
        .texture = NULL,
        .texture_mode = QTRI_MODULATE,
        .cull = QTRI_CULL_BACK,
        .fill = NULL,
        .depth_compare = QTRI_LESS,
        .depth_read_only = false,
        .alpha = 255,
        .reflection = NULL,
    };
    return material;
}

const qtri_shading qtri_smooth = {2, true, NULL};
const qtri_shading qtri_flat_first = {0, false, NULL};
const qtri_shading qtri_flat_last = {2, false, NULL};
