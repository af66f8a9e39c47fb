/* SPDX-License-Identifier: MIT */
#include "effect.h"
#include "line.h"

/* Only what fog and a blend ask for. */
static void set_raster(qtri_raster *raster, const qtri_line_job *job)
{
    const qtri_material *material = job->material;
    const bool has_fog = material->fog != NULL && material->fog->stages != NULL;
    raster->surface = job->surface;
    raster->format = job->surface->format;
    raster->wide = false;
    raster->alpha = material->alpha;
    raster->keep = material->keep;
    raster->blend = material->blend;
    raster->fog = has_fog ? material->fog : NULL;
}

void qtri_line_effects(const qtri_line_job *job, const qtri_ramp *depth)
{
    qtri_batch *batch = job->batch;
    const qtri_format *format = job->surface->format;
    const int32_t count = batch->count;
    if (count == 0) {
        return;
    }
    if (batch->kind == QTRI_LINE_SHARES) {
        qtri_line_tint(batch->color, job, count);
    }
    qtri_raster raster;
    set_raster(&raster, job);
    const qtri_fragments at = {batch->place, batch->place[0], depth};
    const uint32_t mask = qtri_effect_stages_of(job->material)
                              ->fragments(&raster, batch->color, &at, qtri_mask_of(count), count);
    if (job->writes_early != job->depth_write) { /* it is written now */
        batch->count =
            (uint8_t)qtri_batch_keep(batch, job->surface, depth, mask, count, job->has_depth);
    }
    if (batch->count != 0) {
        if (format->encode != NULL) {
            format->encode(batch->color, batch->count);
        }
        format->pixels->scatter(job->surface->pixels, job->surface->pitch, batch->place,
                                batch->color, batch->count);
    }
    batch->count = 0;
}
