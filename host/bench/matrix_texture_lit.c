/* SPDX-License-Identifier: MIT */
#include "matrix_pipelines.h"

MATRIX_ALL_TEXELS(texture_lit, .shade = QTRI_WHITE_LIGHT)
