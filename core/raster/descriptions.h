/* SPDX-License-Identifier: MIT */
/*
 * The structs that materials, textures and views point to: blend, filter, shading, depth shift; and
 * the pipelines and laws that they bring. Internal.
 */
#ifndef QTRI_RASTER_DESCRIPTIONS_H
#define QTRI_RASTER_DESCRIPTIONS_H

#include "large.h"
#include "qtri/body/large.h"
#include "qtri/body/small_triangle.h"
#include "qtri/config.h"

/* Pipelines, and an effect, that a description brings: see qtri_pipeline_brought. */
#if QTRI_WITH_BROUGHT_PIPELINES
#define QTRI_BROUGHT_LIST(list) list
#define QTRI_EFFECT(effect)     &(effect)
#else
#define QTRI_BROUGHT_LIST(list) (sizeof &(list) != 0 ? NULL : (list)) /* which is not unused */
#define QTRI_EFFECT(effect)     (sizeof(effect) != 0 ? NULL : &(effect))
#endif

/* What draws a blend, fog, a filter or depths of a format faster than the generic pipeline alone.
 */
typedef struct qtri_effect {
    const qtri_pipeline *const *pipelines;
    /* The generic pipeline's loop for these options; NULL: the one for all. */
    qtri_pixels_loop *(*loop_of)(const qtri_options *o);
} qtri_effect;

static inline const qtri_pipeline *const *qtri_effect_pipelines(const qtri_effect *effect)
{
    return effect != NULL ? effect->pipelines : NULL;
}

qtri_pixels_loop *qtri_blended_loop(const qtri_options *o); /* effects_any.c */
qtri_pixels_loop *qtri_fogged_loop(const qtri_options *o);
qtri_pixels_loop *qtri_filtered_loop(const qtri_options *o);
qtri_pixels_loop *qtri_float16_loop(const qtri_options *o);
qtri_pixels_loop *qtri_linear24_loop(const qtri_options *o);
qtri_pixels_loop *qtri_linear32_loop(const qtri_options *o);

struct qtri_blend {
    uint8_t kind;              /* QTRI_ALPHA and the like, of material.h */
    bool by_vertex;            /* alpha varies between the vertices */
    const qtri_effect *effect; /* NULL: none */
    /* Sets its options, and alpha and channel mask of the state. */
    void (*begin)(qtri_draw_state *state, const qtri_material *material);
};

struct qtri_filter {
    /* Bilinear: what the generic pipeline calls for a texel; otherwise NULL. */
    uint32_t (*between)(const qtri_pixel_walk *w, bool *drawn);
    const qtri_effect *effect;           /* NULL: none */
    const struct qtri_level_ops *levels; /* NULL: not mipmapped */
};

/* How mipmapped textures are drawn. */
typedef struct qtri_level_ops {
    void (*begin)(qtri_draw_state *state); /* makes state->texture its first level */
    /* What qtri_small_set_level(), qtri_large_set_levels() and those that follow it call. */
    bool (*set_small)(const qtri_small_place *p, const qtri_small *t);
    void (*set_large)(qtri_large *t);
    int32_t (*next)(qtri_large *t);
} qtri_level_ops;

uint32_t qtri_texel_between(const qtri_pixel_walk *w, bool *drawn);         /* effects_any.c */
extern const qtri_level_ops qtri_levels;                                    /* in mipmap.c */
bool qtri_small_find_level(const qtri_small_place *p, const qtri_small *t); /* small_texture.c */

typedef struct qtri_by_pixel qtri_by_pixel; /* see ../draw/primitive.h */

struct qtri_shading {
    uint8_t provoking; /* the vertex whose colour all have, 0 or 2 */
    bool is_smooth;
    const qtri_by_pixel *by_pixel; /* how draw calls light triangles; NULL: by vertex, by face */
};

/* Depths of a triangle that are moved as a whole. */
struct qtri_depth_shift {
    /* A small triangle, which its state's pipeline draws then. */
    bool (*small)(struct qtri_small *triangle);
    /* What is added to the depths of a triangle's vertices, modulo 2^32. */
    uint32_t (*find)(const qtri_material *material, const qtri_point *const p[3], int64_t area,
                     const uint32_t depth[3]);
};

extern const qtri_pipeline *const qtri_pipelines_fog[];

/* A list of pipelines with these options, for what most draw; by qtri/pipeline_make.h. */
#define QTRI_BROUGHT_PIPELINES(list, ...)                                                          \
    QTRI_PIPELINES_USUAL(list, __VA_ARGS__)                                                        \
    extern const qtri_pipeline *const list[];                                                      \
    const qtri_pipeline *const list[] = {                                                          \
        &list##_flat,          &list##_lit, &list##_colors, &list##_texture, &list##_texture_lit,  \
        &list##_texture_white, NULL};

/* How the share, Q16, that fog leaves follows from the distance and two numbers. */
typedef int64_t (*qtri_fog_law)(q16 z, q16 a, q16 b);

/* Sets the shares of a fog by a law. They change between the distances z0 and z1. */
void qtri_fog_set(qtri_fog *fog, qtri_fog_range range, q16 z0, q16 z1, qtri_fog_law share, q16 a,
                  q16 b);

/* A stretch of t = ~depth, 16.16, along which the share that fog leaves is linear: low + rise part
   / 2^bits, in 1/1024, where t has `part` of it behind, and `ahead` before it. */
typedef struct qtri_fog_stretch {
    uint32_t behind, ahead, bits;
    int32_t low, rise;
} qtri_fog_stretch;

/* The stretch of a depth with the half that rounds. */
void qtri_fog_find_stretch(qtri_fog_stretch *stretch, const qtri_fog *fog, uint32_t depth_16p16);

/* A material's shading, &qtri_flat_last if it names none. */
static inline const qtri_shading *qtri_shading_of(const qtri_material *material)
{
    return material->shading != NULL ? material->shading : &qtri_flat_last;
}

static inline bool qtri_is_smooth(const qtri_material *material)
{
    return qtri_shading_of(material)->is_smooth;
}

static inline int qtri_provoking_of(const qtri_material *material)
{
    return qtri_shading_of(material)->provoking;
}

/* The length of a step from the magnitudes of its components: .97 to 1.07 of it. */
static inline uint32_t qtri_step_length(uint32_t a, uint32_t b)
{
    return a > b ? a + (3 * (b >> 3)) : b + (3 * (a >> 3));
}

/* texture->width_log2 or height_log2, 10 at most. */
static inline uint8_t qtri_side_log2(uint8_t log2)
{
    return log2 > 10 ? 10 : log2;
}

#endif
