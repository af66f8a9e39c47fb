/* SPDX-License-Identifier: MIT */
/*
 * The functions of pairs.h in both ways to decide which pixels pass, whatever the host.
 */
#ifndef SUPPORT_FILL_H
#define SUPPORT_FILL_H

#include "fast/pairs.h"

void selected_flat_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void selected_smooth_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void selected_copy_pairs(const qtri_job *job, const qtri_run *run);

void selected_flat_pairs_lequal(const qtri_job *job, const qtri_span *spans, int32_t row,
                                int32_t count);
void selected_smooth_pairs_lequal(const qtri_job *job, const qtri_span *spans, int32_t row,
                                  int32_t count);
void selected_copy_pairs_lequal(const qtri_job *job, const qtri_run *run);

#endif
