/* SPDX-License-Identifier: MIT */
#include "matrix_pipelines.h"

MATRIX_ALL_TEXELS(texture_colors, .shade = QTRI_COLORS)
