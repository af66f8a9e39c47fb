#include "job.h"
#include "packed.h"
#include "texel_copy.h"

/* The colour at pixel i of the run, textured or not. False where the colour key shows through. */
static bool shade(const qtri_job *job, const qtri_run *run, uint32_t i, uint32_t *pixel)
{
    const qtri_raster *raster = job->raster;
    if (qtri_job_is_packed(job)) {
        *pixel = qtri_packed_pixel(run->value[0] + qtri_packed_skip(job, run->phase + (int32_t)i));
        return true;
    }
    uint32_t u = run->value[QTRI_U] + i * run->step[QTRI_U];
    uint32_t v = run->value[QTRI_U + 1] + i * run->step[QTRI_U + 1];
    if (qtri_job_copies_texels(job)) {
        *pixel = qtri_texel_copied(raster, u, v);
        return true;
    }
    qtri_channels color;
    for (int k = 0; k < 3; k++) {
        color.c[k] = qtri_job_is_smooth(job) /* packing adds the half again */
                         ? (int32_t)(run->value[k] + i * run->step[k] - 0x8000u)
                         : job->color.constant.c[k];
    }
    if (qtri_raster_texture(raster) != NULL &&
        !qtri_texel_apply(raster->texture, job->axis, u, v, &color)) {
        return false;
    }
    *pixel = qtri_pixel_pack(qtri_kind_of(raster->surface), &color);
    return true;
}

void qtri_run_generic(const qtri_job *job, const qtri_run *run)
{
    const qtri_raster *raster = job->raster;
    bool tested = raster->compare != QTRI_DEPTH_OFF;
    uint16_t z = 0;
    for (int32_t i = 0; i < run->count; i++) {
        int32_t x = run->x + i;
        if (tested) {
            z = (uint16_t)((run->z + (uint32_t)i * job->depth.dx) >> 16);
            if (!qtri_depth_passes(raster->compare, z, run->depths[x])) {
                continue;
            }
        }
        uint32_t pixel = 0;
        if (qtri_job_is_flat(job)) {
            pixel = job->pixel;
        } else if (!shade(job, run, (uint32_t)i, &pixel)) {
            continue;
        }
        if (tested && raster->depth_write) {
            run->depths[x] = z;
        }
        qtri_pixel_store(qtri_kind_of(raster->surface), run->pixels, x, pixel);
    }
}
