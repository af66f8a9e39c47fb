/* SPDX-License-Identifier: MIT */
/* Pipelines of surfaces with four samples a pixel (qtri/antialias.h). Internal. */
#ifndef QTRI_DRAW_PIPELINE_X4_H
#define QTRI_DRAW_PIPELINE_X4_H

#include "qtri/pipeline.h"

/* Draws whatever is asked for on them. */
extern const qtri_pipeline qtri_pipeline_any_x4;

/* Lists that formats name: of any format, and of RGB565. */
extern const qtri_pipeline *const qtri_pipelines_x4[];
extern const qtri_pipeline *const qtri_pipelines_rgb565_x4[];

#endif
