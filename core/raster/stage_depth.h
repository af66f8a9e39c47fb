/* SPDX-License-Identifier: MIT */
/*
 * The depth test of consecutive pixels. Internal.
 *
 * z: 16.16, at the first pixel; step: from one to the next; count: 1..32. Masks as in batch.h.
 */
#ifndef QTRI_RASTER_STAGE_DEPTH_H
#define QTRI_RASTER_STAGE_DEPTH_H

#include <stdbool.h>

#include "qtri/material.h"

/* Which pixels pass. */
typedef uint32_t (*qtri_depth_test)(uint16_t *depth, uint32_t z, uint32_t step, int32_t count);

/* What a raster does with depths. */
typedef struct qtri_depth {
    qtri_depth_test test; /* NULL: all pass */
    bool inverted;        /* those that `test` does not name pass */
    bool write;           /* those that pass write theirs; false, too, where `test` does so */
} qtri_depth;

/*
 * The stages of a comparison but NEVER. `late`: a later stage may still turn pixels away, so that
 * the test may not write yet.
 */
qtri_depth qtri_depth_stages(qtri_compare compare, bool write, bool late);

/* Writes the depths of those in the mask. */
void qtri_depth_write(uint16_t *depth, uint32_t z, uint32_t step, uint32_t mask, int32_t count);

#endif
