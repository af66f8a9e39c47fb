/*
 * Lines compiled for a core without long multiply and divide.
 */
#define QTRI_LONG_MULTIPLY 0
#define QTRI_DIVIDE        0

#define qtri_line_channels narrow_line_channels
#define qtri_line_draw     narrow_line_draw
#define qtri_line_draw_any narrow_line_draw_any
#define qtri_line_end      narrow_line_end
#define qtri_line_job_init narrow_line_job_init
#define qtri_raster_line   narrow_raster_line

#include "raster/line.c"
#include "raster/line_fast.c"

#include "support_line_narrow.h"

int32_t narrow_line_channel(int32_t color_8p16, uint32_t steps)
{
    return qtri_line_channel_565(color_8p16, steps);
}
