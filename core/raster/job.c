/* SPDX-License-Identifier: MIT */
#include "job.h"

#include "setup.h"
#include "tint.h"

void qtri_job_color(uint32_t f[3], const qtri_job *job, const qtri_attributes v[3], int i)
{
    const bool share = job->tinted && job->raster->texture != NULL;
    for (int k = 0; k < 3; k++) {
        const int32_t c = v[k].color[job->tinted ? 0 : i];
        f[k] = (uint32_t)(job->tinted && !share ? qtri_raster_shade(job->raster, c, i) : c);
    }
}
