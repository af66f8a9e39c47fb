#include "span.h"

/* The colour at pixel i of the run, textured or not. */
static uint32_t shade(const qtri_span_job *job, const qtri_run *run, uint32_t i)
{
    qtri_channels color = job->color;
    if (job->smooth) {
        for (int channel = 0; channel < 3; channel++) {
            uint32_t value = run->color[channel] + i * run->color_step[channel];
            color.c[channel] = (int32_t)(value - 0x8000u); /* packing adds the half again */
        }
    }
    if (job->texture != NULL) {
        uint32_t column = qtri_texel_index(&job->axis[0], run->uv[0] + i * run->uv_step[0]);
        uint32_t row = qtri_texel_index(&job->axis[1], run->uv[1] + i * run->uv_step[1]);
        color = qtri_texel_modulate(&color, qtri_texel_fetch(job->texture, column, row));
    }
    return qtri_pixel_pack(job->surface->format, &color);
}

void qtri_run_generic(const qtri_span_job *job, const qtri_run *run)
{
    for (int32_t i = 0; i < run->count; i++) {
        int32_t x = run->x + i;
        if (job->compare != QTRI_DEPTH_OFF) {
            uint16_t z = (uint16_t)((run->z + (uint32_t)i * job->depth.dx) >> 16);
            if (!qtri_depth_passes(job->compare, z, run->depths[x])) {
                continue;
            }
            if (job->depth_write) {
                run->depths[x] = z;
            }
        }
        uint32_t pixel = job->paint == QTRI_PAINT_FLAT ? job->pixel : shade(job, run, (uint32_t)i);
        qtri_pixel_store(job->surface->format, run->pixels, x, pixel);
    }
}
