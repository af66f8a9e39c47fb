/* SPDX-License-Identifier: MIT */
/*
 * Textures with levels: the one that is drawn, and how it is chosen. Internal.
 */
#ifndef QTRI_RASTER_MIPMAP_H
#define QTRI_RASTER_MIPMAP_H

#include "texel_format.h"
#include "textured.h"

static inline qtri_levels *qtri_levels_of(const qtri_raster *raster)
{
    return &raster->batch->by.textured.levels;
}

/* Makes the raster's texture another level, 0..last. */
void qtri_level_change(qtri_levels *levels, uint32_t level);

static inline void qtri_level_set(qtri_levels *levels, uint32_t level)
{
    if (levels->level != level) {
        qtri_level_change(levels, level);
    }
}

/* An axis whose coordinates do not fill 32 bits, with texels 2^down as large. */
void qtri_axis_move(qtri_texel_axis *axis, int32_t down);

/*
 * Whether rows of the next triangle have more levels than one: of levels->stages the first are for
 * triangles of one level, the second for others.
 */
static inline void qtri_levels_vary(qtri_levels *levels, bool vary)
{
    levels->raster->texturing = &levels->stages[vary];
    levels->axis = NULL;
}

/*
 * Of a copy of a raster, with which a triangle is drawn in place of it: levels change what the copy
 * has. Returns whose they were, NULL without levels, for what comes after the triangle: that has
 * again what belongs to the level that was drawn last.
 */
static inline qtri_raster *qtri_levels_lend(qtri_raster *copy)
{
    qtri_levels *levels = qtri_levels_of(copy);
    if (copy->texture != &levels->texture) {
        return NULL;
    }
    qtri_raster *owner = levels->raster;
    levels->raster = copy;
    return owner;
}

static inline void qtri_levels_return(qtri_raster *owner, const qtri_raster *copy)
{
    if (owner != NULL) {
        qtri_levels_of(copy)->raster = owner;
        owner->texturing = copy->texturing;
        owner->texel_cut = copy->texel_cut;
        owner->coordinate[0] = copy->coordinate[0];
        owner->coordinate[1] = copy->coordinate[1];
    }
}

/* The length of a step, of the magnitudes of both its parts: .97 to 1.07 of it. < 2^31 */
static inline uint32_t qtri_step_length(uint32_t a, uint32_t b)
{
    return a > b ? a + (3 * (b >> 3)) : b + (3 * (a >> 3));
}

/* What levels of a large triangle with perspective are found by; see qtri_mipmap_begin_large. */
void qtri_footprint_init(qtri_footprint *out, const qtri_job *job, const qtri_triangle *t,
                         const uint32_t value[2][3], const uint32_t q[3]);

/* Those of qtri_texturing: of small triangles, and of large ones. */
void qtri_mipmap_set_list(qtri_list_values *v);
uint32_t qtri_mipmap_color_list(const qtri_list_values *v, uint32_t *color, uint32_t *shade,
                                const uint32_t *place, int32_t count);
uint32_t qtri_mipmap_finish_list(const qtri_raster *raster, int32_t count, uint32_t mask);
void qtri_mipmap_axes(qtri_job *job, uint32_t value[2][3], const qtri_attributes v[3]);
qtri_fill_rows qtri_mipmap_begin_large(qtri_job *job, const qtri_triangle *triangle,
                                       const uint32_t value[2][3], const uint32_t q[3]);
uint32_t qtri_mipmap_chunk(qtri_scanline *row, int32_t x, int32_t count, uint32_t mask);

#endif
