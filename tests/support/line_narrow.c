/* SPDX-License-Identifier: MIT */
/*
 * Lines compiled for a core without long multiply and divide.
 */
#define QTRI_LONG_MULTIPLY 0
#define QTRI_DIVIDE        0

#define qtri_line_clip_short  narrow_line_clip_short
#define qtri_line_draw        narrow_line_draw
#define qtri_line_end         narrow_line_end
#define qtri_line_job_init    narrow_line_job_init
#define qtri_line_has_table   narrow_line_has_table
#define qtri_stroke_any       narrow_stroke_any
#define qtri_raster_line      narrow_raster_line
#define qtri_line_look        narrow_line_look
#define qtri_line_any         narrow_line_any
#define qtri_line_pipelines   narrow_line_pipelines
#define qtri_stroke_pipelines narrow_stroke_pipelines

#include "raster/line.c"
#include "raster/line_pipelines.c"

#include "raster/lines_any.c"

#include "line_narrow.h"

uint32_t narrow_line_reciprocal(uint32_t length)
{
    qtri_divider by;
    qtri_divider_init_short(&by, length);
    return by.reciprocal_q32;
}
