/* SPDX-License-Identifier: MIT */
/*
 * What the triangles of a draw call share: where they are drawn, and the stages that their pixels
 * go through, chosen once. Internal.
 */
#ifndef QTRI_RASTER_RASTER_H
#define QTRI_RASTER_RASTER_H

#include "qtri/material.h"
#include "qtri/view.h"

#include "../bits/bits.h"
#include "../frame/pixel.h"
#include "batch.h"
#include "gradient.h"
#include "stage_depth.h"
#include "texel_axis.h"

typedef struct qtri_job qtri_job;
typedef struct qtri_list_values qtri_list_values; /* see list_values.h */
typedef struct qtri_raster qtri_raster;
typedef struct qtri_varying qtri_varying;             /* see shading.h */
typedef struct qtri_effect_stages qtri_effect_stages; /* see effect.h */
typedef struct qtri_list_late qtri_list_late;         /* see list_late.h */
typedef struct qtri_vertex_blend qtri_vertex_blend;   /* see effect.h */
typedef struct qtri_alpha_planes qtri_alpha_planes;
typedef struct qtri_pixel_light qtri_pixel_light; /* see pixel_light.h */

/* Pixels left..right-1 of a row, before any scissor: within 2^14 of 0. Empty when right <= left. */
typedef struct qtri_span {
    int16_t left, right;
} qtri_span;

/* Fills `count` rows from `row` on. */
typedef void (*qtri_fill_rows)(const qtri_job *job, const qtri_span *spans, int32_t row,
                               int32_t count);

/* Part of a row that copies texels. */
typedef struct qtri_run qtri_run;
typedef void (*qtri_draw_run)(const qtri_job *job, const qtri_run *run);

/*
 * The same along curves that begin `skip` pixels before x: up to QTRI_BATCH pixels with these. From
 * the run only pixels, depths, x, count and z.
 */
typedef void (*qtri_draw_bent)(const qtri_job *job, const qtri_run *run, const qtri_curve uv[2],
                               int32_t skip);

/*
 * Draws a small triangle in shares of the tint, in the light that its vertices have or that the
 * raster's lamp finds for it. False when it is not that simple: then nothing was drawn.
 */
typedef bool (*qtri_draw_small)(const qtri_raster *raster, const void *indices, qtri_vertex *a,
                                qtri_vertex *b, qtri_vertex *c);

/* Draws `count` waiting fragments, whose texels are lit: of the batch's numbers and shades. */
typedef void (*qtri_draw_list)(const qtri_raster *raster, int32_t count);

/* Of `count` fragments of the batch, which have colours, encodes and stores those of the mask. */
typedef void (*qtri_draw_masked)(const qtri_raster *raster, uint32_t mask, int32_t count);

/*
 * Where light comes from when a triangle touches a pixel: that of all its pixels, or
 * QTRI_VERTEX_UNLIT for that of its vertices, which then have theirs.
 */
typedef struct qtri_lamp {
    uint32_t (*find)(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                     qtri_vertex *c);
    const void *from;
    bool by_vertex; /* and need not find it where vertices have it */
} qtri_lamp;

struct qtri_sampling;

/*
 * Draws a triangle of any size and area that is not culled, in place of the ways of the pipeline:
 * p, area, tinted and what qtri_triangle_begin sets are there.
 */
struct qtri_triangle;
struct qtri_attributes;
typedef void (*qtri_route)(const qtri_raster *raster, struct qtri_triangle *triangle,
                           const struct qtri_attributes *v);

/* Loops that stand in for the stages where depth is "less" and written; NULL: none. */
struct qtri_fused {
    qtri_fill_rows flat, smooth;
    qtri_draw_run copy;
    qtri_draw_bent copy_bent;
    qtri_draw_list lit;
    const qtri_fused *less_equal;        /* where depth is that */
    const struct qtri_sampling *samples; /* several a pixel, see samples.h; NULL: one */
};

typedef void (*qtri_words_stage)(uint32_t *color, int32_t count);
typedef void (*qtri_modulate_stage)(uint32_t *color, const uint32_t *shade, int32_t count);
typedef void (*qtri_curves_stage)(uint32_t *color, const qtri_curve channel[3], int32_t count);
/* Colours from four texels each and the shares of the second column, of 2048, and the second row
   << 16. */
typedef void (*qtri_taps_stage)(uint32_t *color, const uint32_t *tap, const uint32_t *weight,
                                int32_t count);
typedef void (*qtri_tint_stage)(uint32_t *color, const uint32_t *light, const uint32_t tint_q10[3],
                                int32_t count);

/* See effect.h. */
typedef struct qtri_fragments qtri_fragments;
typedef uint32_t (*qtri_effect)(const qtri_raster *raster, uint32_t *color,
                                const qtri_fragments *at, uint32_t mask, int32_t count);
/* The same for all of `count` neighbours of depths z on, 16.16; their pixels are stored at once. */
typedef void (*qtri_effect_row)(uint8_t *pixels, const uint32_t *color, int32_t count,
                                const qtri_raster *raster, uint32_t z, uint32_t z_step);

struct qtri_raster {
    const qtri_surface *surface;
    const qtri_format *format;
    const qtri_texture *texture; /* NULL: none */
    qtri_batch *batch;
    const struct qtri_sampling *samples; /* NULL: one a pixel */
    qtri_route route;                    /* of all triangles; NULL: large and small have theirs */
    union {
        const qtri_material *material;   /* of what takes a route */
        const qtri_alpha_planes *planes; /* of a triangle on its way, see blend_vertex.c */
    } of;
    qtri_pixel_light *lit; /* triangles are lit by pixel, see pixel_light.h; NULL: by vertex */
    qtri_rect bounds;      /* empty where nothing is to be drawn */
    struct {
        uint32_t x, y, width, height; /* 24.8 */
    } inner;              /* where vertex 0 of a small triangle is too far inside them to be cut */
    qtri_compare compare; /* QTRI_DEPTH_OFF: depth neither read nor written */
    bool depth_write;
    bool with_depth;  /* depths are needed: for that, or for fog */
    bool apart;       /* fragments of two triangles may not share a batch */
    bool keeps_depth; /* that of fragments of small triangles is kept with them */
    bool reads;       /* effects read what is stored: a fragment needs what those before it made */
    bool rejects;     /* a stage after the depth test may turn fragments away */
    bool wide;        /* colours have 8 bits a channel, and alpha above, for the blend */
    bool finer;       /* colours are finer than the format's, for fog: see fog_565.h */
    uint8_t alpha;
    uint8_t least_alpha;
    uint8_t keep;    /* channels that a blend leaves */
    bool gray;       /* what multiplies gives the format's kind */
    bool white;      /* the tint: light alone is enough */
    bool by_pixel;   /* a triangle on its way: `lit` has the colours of its job */
    bool late_write; /* of depths that are tested as an effect: see depth_testing.c */
    qtri_compare late_compare;
    const qtri_blend *blend; /* NULL: none, see effect.h */
    const qtri_fog *fog;
    const qtri_effect_stages *effects; /* NULL: neither */
    const qtri_list_late *late;        /* fragments are not colours alone; NULL: they are */
    qtri_effect_row effect_row;        /* NULL: there is none for what is drawn */
    qtri_draw_list effect_list;        /* the same for what waits in the batch, see list.h */
    bool perspective;                  /* as the material asks */
    qtri_cull cull;
    uint8_t provoking;           /* the vertex whose colour a flat triangle has */
    bool smooth;                 /* colours vary */
    const qtri_varying *varying; /* NULL: nothing does, nor is there a texture */
    qtri_depth depth;
    /*
     * Units of colours' channels, n.16: those of the format, or, where there is a texture, 8 bits.
     * Where only the sum of the three counts it is in place of blue, and the others are 0.
     */
    const qtri_colors *units;
    qtri_channels tint;  /* what tinted triangles have shares of */
    uint32_t tint_n8[3]; /* the same with 8 bits after the point, cut off */

    /* Texture: see textured.c. */
    const qtri_texturing *texturing;
    const qtri_colors *working; /* texels become colours of this kind */
    /* From the texel's kind to the working one, from that to the format's, where texels are
       multiplied or filtered; from one to the other at once. NULL: they are the same. */
    qtri_words_stage widen, narrow, convert;
    qtri_modulate_stage light, times;
    qtri_curves_stage times_curves;
    qtri_tint_stage tinted;   /* light, and the tint below */
    qtri_taps_stage mix_taps; /* where texels are filtered */
    uint32_t (*seen)(const qtri_raster *raster, const uint32_t *color,
                     int32_t count); /* the mask of texels with enough alpha; NULL: all */
    bool replace;
    bool repeated;      /* coordinates fill 32 bits, see texel_number.h */
    bool fetched;       /* rows of texels are read at once with their numbers */
    bool copied;        /* nearest repeated texels of the format's own kind, without a key */
    uint32_t texel_cut; /* see texel_copy.h; 0 where that does not fit */
    struct {
        uint8_t unit, shift; /* bits of a repeat's and of a texel's fraction */
    } coordinate[2];         /* of repeated ones */
    uint32_t tint_q10[3];

    /* Fused loops, or the stages. */
    qtri_fill_rows fill_flat, fill_smooth;
    qtri_draw_run copy_run;     /* NULL: none */
    qtri_draw_bent copy_bent;   /* NULL: none */
    qtri_draw_small tint_small; /* of meshes of one colour; NULL: none */
    qtri_draw_list lit_list;    /* NULL: none */
    qtri_lamp lamp;             /* where there is one */
};

/* batch: the caller's, used while the raster is. */
void qtri_raster_init(qtri_raster *raster, const qtri_surface *surface,
                      const qtri_material *material, qtri_batch *batch);

/* The same of a colour in light <= 2^15, which is 1. */
void qtri_raster_lit_channels(int32_t channel[3], const qtri_raster *raster, const qtri_rgb *color,
                              uint32_t light_q15);

/* The colour that tinted triangles have shares of. */
void qtri_raster_set_tint(qtri_raster *raster, qtri_rgb color);

/* color_8p16 (0..255.0) as the raster's channels. */
qtri_channels qtri_raster_channels(const qtri_raster *raster, const int32_t color_8p16[3]);

/* A colour of the format's kind as a stored pixel. */
uint32_t qtri_raster_stored(const qtri_raster *raster, uint32_t color);

/* Of a material. */
const qtri_shading *qtri_shading_of(const qtri_material *material);
bool qtri_is_smooth(const qtri_material *material);
int qtri_provoking_of(const qtri_material *material);

#endif
