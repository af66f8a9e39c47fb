/* SPDX-License-Identifier: MIT */
#include "../frame/depth_format.h"
#include "effect.h"
#include "line.h"

/* Only what fog and a blend ask for. */
static void set_raster(qtri_raster *raster, const qtri_line_job *job)
{
    const qtri_material *material = job->material;
    const bool has_fog = material->fog != NULL && material->fog->stages != NULL;
    raster->surface = job->surface;
    raster->format = job->surface->format;
    raster->finer = false;
    raster->wide = false;
    raster->of.planes = NULL;
    raster->alpha = material->alpha;
    raster->keep = material->keep;
    raster->blend = material->blend;
    raster->fog = has_fog ? material->fog : NULL;
}

void qtri_line_effects(const qtri_line_job *job, const qtri_ramp *depth)
{
    qtri_batch *batch = job->batch;
    const int32_t count = batch->count;
    if (count == 0) {
        return;
    }
    if (batch->kind == QTRI_LINE_SHARES) {
        qtri_line_tint(batch->color, job, count);
    }
    qtri_raster raster;
    set_raster(&raster, job);
    const qtri_effect_stages *stages = qtri_effect_stages_of(job->material);
    const qtri_fragments at = {batch->place, batch->place[0], depth, NULL};
    uint32_t mask = qtri_mask_of(count);
    if (job->testing != NULL) {
        raster.late_compare = qtri_compare_of(job->material);
        raster.late_write = stages == NULL && job->depth_write;
        mask = job->testing->test(&raster, &at, mask, count);
    }
    if (stages != NULL && mask != 0) {
        mask = stages->fragments(&raster, batch->color, &at, mask, count);
        if (job->testing != NULL && job->depth_write && mask != 0) {
            raster.late_compare = QTRI_ALWAYS;
            raster.late_write = true;
            (void)job->testing->test(&raster, &at, mask, count);
        }
    }
    const bool writes_late = job->has_depth && job->depth_write && !job->writes_early;
    if (writes_late || mask != qtri_mask_of(count)) {
        batch->count =
            (uint8_t)qtri_batch_keep(batch, job->surface, depth, mask, count, writes_late);
    }
    if (batch->count != 0) {
        const qtri_format *format = job->surface->format;
        if (format->encode != NULL) {
            format->encode(batch->color, batch->count);
        }
        format->pixels->scatter(job->surface->pixels, job->surface->pitch, batch->place,
                                batch->color, batch->count);
    }
    batch->count = 0;
}
