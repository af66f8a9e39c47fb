/* SPDX-License-Identifier: MIT */
#include "matrix_pipelines.h"

MATRIX_ALL_TEXELS(texture, .shade = QTRI_FLAT)
