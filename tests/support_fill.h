/*
 * The functions of fill_pairs.h in both ways to decide which pixels pass, whatever the host.
 */
#ifndef SUPPORT_FILL_H
#define SUPPORT_FILL_H

#include "raster/fill_pairs.h"

void selected_fill_flat_pairs(const qtri_job *job, const qtri_span *spans, int32_t row,
                              int32_t count);
void selected_fill_packed_pairs(const qtri_job *job, const qtri_span *spans, int32_t row,
                                int32_t count);
void selected_run_copy_pairs(const qtri_job *job, const qtri_run *run);

#endif
