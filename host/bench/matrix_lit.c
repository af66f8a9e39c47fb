/* SPDX-License-Identifier: MIT */
#include "matrix_pipelines.h"

MATRIX_PLAIN(lit, .shade = QTRI_LIGHT)
