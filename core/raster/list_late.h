/* SPDX-License-Identifier: MIT */
/*
 * What comes after the colours of small triangles whose fragments are not colours alone: fog and
 * blends follow, or stages may turn them away. Effects and textures bring it, so that an
 * application without them has none of it. Internal.
 */
#ifndef QTRI_RASTER_LIST_LATE_H
#define QTRI_RASTER_LIST_LATE_H

#include "raster.h"

struct qtri_list_late {
    /*
     * Of the last `count` fragments that wait: which of them are drawn, and their depths where the
     * raster keeps them.
     */
    void (*note)(const qtri_raster *raster, const qtri_ramp *depth, uint32_t mask, int32_t count);
    qtri_draw_masked store;
};
extern const qtri_list_late qtri_list_late_texels;

void qtri_list_note(const qtri_raster *raster, const qtri_ramp *depth, uint32_t mask,
                    int32_t count);

/*
 * Leaves those out of `count` fragments of the batch, from `first` on, that are not in the mask;
 * and where the raster writes depths, those that fail the test by now. The depths of the others are
 * written. Returns how many are left, which follow each other from `first` on.
 */
int32_t qtri_list_keep(const qtri_raster *raster, int32_t first, uint32_t mask, int32_t count);

/* Stores `count` pixels of the batch, one at least, from `first` on. */
void qtri_list_store(const qtri_raster *raster, int32_t first, int32_t count);

#endif
