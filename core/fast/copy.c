/* SPDX-License-Identifier: MIT */
#include "../raster/loop.h"
#include "../raster/texel_copy.h"
#include "fused.h"

QTRI_IN_PLACE void copy(const qtri_job *job, const qtri_run *run, bool equal)
{
    const qtri_raster *raster = job->raster;
    const uint8_t *texels = raster->texture->texels;
    uint32_t cut = raster->texel_cut;
    uint16_t *pixel = (uint16_t *)(void *)run->pixels + run->x;
    uint16_t *depth = run->depths + run->x;
    uint32_t z = run->z;
    uint32_t u = run->value[0];
    uint32_t v = run->value[1];
    uint32_t depth_step = job->depth.dx;
    uint32_t u_step = run->step[0];
    uint32_t v_step = run->step[1];
    int32_t count = run->count;
#define ONE(i)                                                                                     \
    if (qtri_passes(z >> 16, depth[i], equal)) {                                                   \
        QTRI_BRANCH                                                                                \
        depth[i] = (uint16_t)(z >> 16);                                                            \
        uint32_t at = qtri_texel_index(u, v, cut) * 2;                                             \
        pixel[i] = *(const uint16_t *)(const void *)(texels + at);                                 \
    }                                                                                              \
    z += depth_step;                                                                               \
    u += u_step;                                                                                   \
    v += v_step;                                                                                   \
    QTRI_OPAQUE(z)                                                                                 \
    QTRI_OPAQUE(u)                                                                                 \
    QTRI_OPAQUE(v)                                                                                 \
    QTRI_ASIDE(depth_step)                                                                         \
    QTRI_ASIDE(u_step)                                                                             \
    QTRI_ASIDE(v_step)                                                                             \
    QTRI_ASIDE(texels)                                                                             \
    QTRI_ASIDE(cut)
    QTRI_PIXELS(count)
#undef ONE
}

void qtri_copy_less(const qtri_job *job, const qtri_run *run)
{
    copy(job, run, false);
}

#ifndef __OPTIMIZE_SIZE__
void qtri_copy_lequal(const qtri_job *job, const qtri_run *run)
{
    copy(job, run, true);
}
#endif
