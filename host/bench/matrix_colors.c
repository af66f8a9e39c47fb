/* SPDX-License-Identifier: MIT */
#include "matrix_pipelines.h"

MATRIX_PLAIN(colors, .shade = QTRI_COLORS)
