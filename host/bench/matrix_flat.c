/* SPDX-License-Identifier: MIT */
#include "matrix_pipelines.h"

MATRIX_PLAIN(flat, .shade = QTRI_FLAT)
