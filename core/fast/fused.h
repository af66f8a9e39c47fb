/* SPDX-License-Identifier: MIT */
/*
 * Fused loops of surfaces of 16 bits with depth "less" and written: whole rows of one colour, of
 * linear colours in RGB565, runs of texels that become pixels as they are, and small triangles in
 * shares of a tint. Internal.
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
bool qtri_tint_less(const qtri_raster *raster, const void *indices, qtri_vertex *a, qtri_vertex *b,
                    qtri_vertex *c);

#endif
