/* SPDX-License-Identifier: MIT */
/*
 * What follows the colour of a fragment: fog, and a blend with the pixel under it. Internal.
 *
 * Both are reached through descriptions, so that an application without them has neither. They
 * work on fragments that lie on different pixels: of a row, or of small triangles, as many of a
 * batch as do (effect_list.c).
 */
#ifndef QTRI_RASTER_EFFECT_H
#define QTRI_RASTER_EFFECT_H

#include "qtri/blend.h"

#include "line.h"

/* Where fragments are: row << 16 | column, from the surface's first pixel. */
struct qtri_fragments {
    const uint32_t *place;  /* of each; NULL: neighbours of a row */
    uint32_t first;         /* of the first */
    const qtri_ramp *depth; /* 16.16 with the half that rounds, from place 0 on */
    const uint32_t *depths; /* the same of each, where they have places; NULL: as the ramp has it */
};

/*
 * What both come with, &qtri_effects. Lines: fog and blend for what is in a job's batch, fragments
 * of one chunk of one line with its depths; then they are stored.
 */
struct qtri_effect_stages {
    /* Both, for `count` fragments, of which the mask's are drawn. Returns the new mask. */
    qtri_effect fragments;
    qtri_line_effect line;
    qtri_fill_rows fill;                 /* rows of large triangles, of one colour too */
    void (*choose)(qtri_raster *raster); /* sets loops that do it at once; NULL: there are none */
    const qtri_list_late *late;          /* of small triangles */
};
extern const qtri_effect_stages qtri_effects;

void qtri_line_effects(const qtri_line_job *job, const qtri_ramp *depth);

/*
 * Small triangles in shares of the tint, which wait in the batch for the raster's effect_list: what
 * that asks of a raster, and the loop, see qtri_draw_small in raster.h.
 */
bool qtri_list_tint_fits(const qtri_raster *raster);
bool qtri_list_tint(const qtri_raster *raster, const void *indices, qtri_vertex *a, qtri_vertex *b,
                    qtri_vertex *c);

extern const qtri_list_late qtri_list_late_effects;

struct qtri_fog_stages {
    const qtri_effect_stages *effects;
    void (*begin)(qtri_raster *raster); /* chooses the colours that it takes */
    /* Colours, of the format's kind, or finer and then of it, or `wide`, in place. */
    void (*apply)(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                  int32_t count);
    qtri_effect_row row; /* where fog is all, of plain pixels: see effect.c */
    qtri_draw_list list;
    /* Finer colours, which apply() leaves to a blend that takes them, over stored ones as 565. */
    void (*over)(uint32_t *color, const uint16_t *under, int32_t count, uint32_t alpha);
};
typedef struct qtri_fog_stages qtri_fog_stages;

/*
 * Alpha that varies between the vertices of a triangle, blend_vertex.c: such a blend gives its
 * raster a route (raster.h). Alphas are those of the material, of the vertices with these numbers.
 */
struct qtri_vertex_blend {
    /* Sets the route, and units and format for the stages that are chosen next. */
    void (*begin)(qtri_raster *raster);
    qtri_route draw;
    /* Of the three vertices of a triangle that is not clipped. */
    void (*set)(struct qtri_attributes *v, const qtri_raster *raster, const uint32_t index[3]);
    /* Of one that may be: are kept in the batch. Then alpha at a point of it, as clip.h has it. */
    void (*note)(const qtri_raster *raster, const uint32_t index[3]);
    uint32_t (*at)(const qtri_raster *raster, int32_t b1_q30, int32_t b2_q30);
};

struct qtri_blend {
    const qtri_effect_stages *effects;
    /*
     * Colours, of the format's kind or `wide`, become what is stored there, of the format's kind,
     * in place. mask: as in batch.h; returns that of those that are drawn.
     */
    uint32_t (*apply)(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                      uint32_t mask, int32_t count);
    qtri_effect_row row; /* where the blend is all, of plain pixels; NULL: none */
    qtri_draw_list list;
    bool rejects;                       /* the mask may lose some */
    const qtri_vertex_blend *by_vertex; /* alpha varies; NULL: it does not */
    bool takes_finer;                   /* colours that fog leaves so: see fog_565.h */
    uint8_t kind;                       /* QTRI_ALPHA and the like: see pipeline.h */
};

/* That of a raster; NULL: alpha does not vary. */
static inline const qtri_vertex_blend *qtri_by_vertex(const qtri_raster *raster)
{
    return raster->blend != NULL ? raster->blend->by_vertex : NULL;
}

/* Of a material with fog or a blend; NULL: neither. */
static inline const qtri_effect_stages *qtri_effect_stages_of(const qtri_material *material)
{
    if (material->fog != NULL && material->fog->stages != NULL) {
        return material->fog->stages->effects;
    }
    return material->blend != NULL ? material->blend->effects : NULL;
}

#endif
