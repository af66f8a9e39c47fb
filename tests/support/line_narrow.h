/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_SUPPORT_LINE_NARROW_H
#define QTRI_TESTS_SUPPORT_LINE_NARROW_H

#include <qtri.h>

#include "raster/line.h"

/* raster/line.c without long multiply and divide: qtri_raster_line and qtri_line_job_init. */
void narrow_raster_line(const qtri_surface *surface, const qtri_material *material,
                        const qtri_screen_vertex v[2]);
void narrow_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                          const qtri_material *material, qtri_stroke_target *to);

/* Of a line shorter than 2^16, as qtri_divider has it. */
uint32_t narrow_line_reciprocal(uint32_t length);

#endif
