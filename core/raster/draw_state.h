/* SPDX-License-Identifier: MIT */
/*
 * Sets up the state of a draw call from surface and material, and chooses its pipeline. Internal.
 */
#ifndef QTRI_RASTER_DRAW_STATE_H
#define QTRI_RASTER_DRAW_STATE_H

#include "qtri/body/state.h"

enum {
    QTRI_BY_PIXEL = QTRI_COLORS + 1,
    QTRI_COVERED = 16 /* or-ed to `shade`: strokes may cover pixels in part */
};

/* A material's comparison; a number that is none is QTRI_ALWAYS. Enums may be signed. */
static inline qtri_compare qtri_compare_of(const qtri_material *material)
{
    const qtri_compare compare = material->depth_compare;
    return (uint32_t)compare > (uint32_t)QTRI_ALWAYS ? QTRI_ALWAYS : compare;
}

/*
 * `shade`: where colours come from, textures aside: QTRI_FLAT, material.color for all triangles;
 * QTRI_TINT, a colour a triangle; QTRI_LIGHT, material.color in light that varies; QTRI_COLORS,
 * vertices; QTRI_BY_PIXEL, vertices in light by pixel. `texture`: the material's, NULL where
 * vertices have no coordinates. Where a list has nothing that fits, or nothing can be drawn,
 * state->pipeline draws nothing; a checked build stops at the former.
 */
void qtri_draw_state_init(qtri_draw_state *state, const qtri_surface *surface,
                          const qtri_pipeline *const *pipelines, const qtri_material *material,
                          const qtri_texture *texture, int shade);

/* qtri_pipeline.choose of generic pipelines: sets options.asks of the state; returns `generic`. */
const qtri_pipeline *qtri_draw_state_ask(const qtri_pipeline *generic, qtri_draw_state *state);

/* Replaces the generic pipeline, if it was chosen, by one of this list that fits, if any does. */
void qtri_draw_state_prefer(qtri_draw_state *state, const qtri_pipeline *const *pipelines);

#endif
