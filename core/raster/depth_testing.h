/* SPDX-License-Identifier: MIT */
/*
 * Depths of another format than linear16. Internal.
 *
 * They are tested as an effect is applied (effect.h): after the colours of a batch, which holds
 * fragments of one triangle or of a piece of one line, before fog and blend, and written after
 * those. To all stages before it the surface is one without depth. So nothing but this file knows
 * of such formats, no loop for linear16 asks for them, and triangles of all sizes, textures and
 * blends have them alike. The price is that colours are made of fragments that are hidden.
 */
#ifndef QTRI_RASTER_DEPTH_TESTING_H
#define QTRI_RASTER_DEPTH_TESTING_H

#include "effect.h"

struct qtri_depth_testing {
    qtri_effect_stages effects;
    /* Triangles: puts the test before the raster's effects. It has a depth comparison. */
    void (*begin)(qtri_raster *raster);
    /* Lines: the raster that `effects` ask for; its surface and what fog and blend want are set. */
    void (*begin_line)(qtri_raster *raster, const qtri_line_job *job);
    /*
     * One fragment at a place, of strokes: whether it passes. `write`: then its depth is stored.
     */
    bool (*passes)(const qtri_surface *surface, qtri_compare compare, uint32_t place,
                   uint32_t depth_16p16, bool write);
    /*
     * Turns all depths into linear16, in place: the first in memory is returned, and the others
     * follow in the order of the formerly stored ones. |depth_pitch| >= width.
     */
    uint16_t *(*flatten)(const qtri_surface *surface);
};

/* NULL: the surface's depths are linear16, or there are none, or they do not count. */
static inline const qtri_depth_testing *qtri_depth_testing_of(const qtri_surface *surface,
                                                              qtri_compare compare)
{
    if (surface->depth_format == NULL || surface->depth == NULL || compare == QTRI_DEPTH_OFF) {
        return NULL;
    }
    return surface->depth_format->testing;
}

#endif
