/* SPDX-License-Identifier: MIT */
/* Those of pipelines_rgb565.c in the byte order of displays on SPI. */
#include "qtri/pipeline_make.h"

QTRI_PIPELINES(qtri_pipelines_swapped, qtri_pipeline_swapped, .format = QTRI_RGB565_SWAPPED,
               .depth = QTRI_LINEAR16, .compare = QTRI_LESS)
