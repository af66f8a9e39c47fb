/* SPDX-License-Identifier: MIT */
/*
 * Fused loops of surfaces of 16 bits with depth "less", or "less or equal", and written: whole rows
 * of one colour, of linear colours in RGB565, runs of texels that become pixels as they are, and
 * small triangles in shares of a tint. Internal.
 *
 * They save time and nothing else: the stages draw the same pixels to the bit.
 */
#ifndef QTRI_FAST_FUSED_H
#define QTRI_FAST_FUSED_H

#include "../raster/job.h"

void qtri_flat_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_smooth_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_copy_less(const qtri_job *job, const qtri_run *run);
void qtri_copy_bent_less(const qtri_job *job, const qtri_run *run, const qtri_curve uv[2],
                         int32_t skip);

#ifndef __OPTIMIZE_SIZE__ /* where each would be a copy */
void qtri_flat_lequal(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_smooth_lequal(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_copy_lequal(const qtri_job *job, const qtri_run *run);
void qtri_copy_bent_lequal(const qtri_job *job, const qtri_run *run, const qtri_curve uv[2],
                           int32_t skip);
#endif

/* Whether a fragment with 16 bits of depth is drawn. */
static inline bool qtri_passes(uint32_t top, uint32_t stored, bool equal)
{
    return equal ? top <= stored : top < stored;
}

void qtri_lit_list(const qtri_raster *raster, int32_t count);

/*
 * Small triangles of a mesh of one colour, in any format of 16 bits: what a raster asks of them,
 * and the loop, see raster.h.
 */
bool qtri_tint_fits(const qtri_raster *raster);
bool qtri_tint_draw(const qtri_raster *raster, const void *indices, qtri_vertex *a, qtri_vertex *b,
                    qtri_vertex *c);

#endif
