/* SPDX-License-Identifier: MIT */
/* Pipelines of light by pixel. Internal. */
#ifndef QTRI_DRAW_PER_PIXEL_H
#define QTRI_DRAW_PER_PIXEL_H

#include "qtri/pipeline.h"

extern const qtri_pipeline qtri_pipeline_by_pixel, qtri_pipeline_texture_by_pixel;
extern const qtri_pipeline *const qtri_pipelines_by_pixel[];

#endif
