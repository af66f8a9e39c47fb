/* SPDX-License-Identifier: MIT */
/*
 * What becomes of a pixel that is drawn over another: material.blend, and fog.
 *
 * A blend is chosen by its address; what no material names is not linked. It works on pixels that
 * have passed the depth test, one after the other where triangles overlap, in every format of
 * surface, and draws the same pixels for every band and scissor. Depths are written as without;
 * what is seen through is drawn last, from far to near, with material.depth_read_only.
 *
 * All but the screen door leave channels of stored pixels alone that material.keep names.
 * A pixel's alpha is material.alpha, times that of its texel where the texture's format has one,
 * and times that of the vertices with a blend that asks for it.
 * What is blended is rounded before and after: within 1 1/4 of 255 of what exact colours are
 * together, 1 1/2 with alpha of texels or of vertices; of RGB565 within 1 step, 1 1/4 where colours
 * vary. Fog, with what its share is off, is within 1 3/4 of 255, with a constant alpha 2. Triangles
 * of RGB565 in fog are rounded once, and are within .85 of a step, with a constant alpha .9.
 *
 * Lines and wireframes are blended and fogged as well: each edge of each
 * triangle, so that one that two triangles share is drawn twice where depth does not turn the
 * second away. Of strokes and points (stroke.h) what fog and blend make of a pixel counts as far as
 * it is covered.
 */
#ifndef QTRI_BLEND_H
#define QTRI_BLEND_H

#include <stdbool.h>

#include "format.h"
#include "q16.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What becomes of the pixel under it. */
enum {
    QTRI_STORE,
    QTRI_ALPHA,      /* &qtri_blend_alpha, and by vertex: .vertex_alpha */
    QTRI_ADD,        /* &qtri_blend_add */
    QTRI_MULTIPLY,   /* &qtri_blend_multiply */
    QTRI_KEEP_PIXEL, /* &qtri_blend_none */
    QTRI_SCREEN_DOOR /* &qtri_blend_screen_door */
};

typedef struct qtri_blend qtri_blend;

extern const qtri_blend qtri_blend_alpha;    /* colour alpha + stored (1 - alpha) */
extern const qtri_blend qtri_blend_add;      /* stored + colour alpha, at most full */
extern const qtri_blend qtri_blend_multiply; /* stored times colour, whatever the alpha */
extern const qtri_blend qtri_blend_none;     /* stored: depths alone are written */
extern const qtri_blend qtri_blend_replace;  /* colour, but for the channels of material.keep */

/* A share of alpha of the pixels, in a pattern of 4 by 4: no order, nothing read. */
extern const qtri_blend qtri_blend_screen_door;

/*
 * The first two with alpha that varies between the vertices: material.alphas has that of each
 * vertex of a mesh, of each corner of a call, or of three screen vertices; 255 is all of it, and
 * NULL is 255 for all. It is perspective-correct where colours are, whatever the shading. Colours
 * are within 1 1/2 of 255, and within .9 of a step of RGB565, of exact ones. Lines and strokes have
 * material.alpha alone. With four samples a pixel (samples.h) alpha is that of the pixel's centre,
 * held to that of the vertices.
 */
extern const qtri_blend qtri_blend_vertex_alpha;
extern const qtri_blend qtri_blend_vertex_add;

/*
 * Fog by depth: colour f + fog's colour (1 - f), where f falls with z, the distance from the eye's
 * plane: linear (end - z) / (end - start), held to 0..1, or exp(-density z), or exp(-(density
 * z)^2).
 *
 * z is found from the depth of the pixel, with its fraction, so the projection's near and far are
 * asked for, and the viewport's depths must be 0 and 1. f is within 1/256.
 */
typedef struct qtri_fog qtri_fog;

/* Where depths of 0 and 1 are. near_z is at least 1/65536, far_z more than it: both are held. */
typedef struct qtri_fog_range {
    q16 near_z, far_z;
    bool orthographic; /* depth is linear in z */
} qtri_fog_range;

enum { QTRI_FOG_STEPS = 16 * 8 + 2 };

struct qtri_pipeline;

struct qtri_fog {
    bool is_set;                                  /* by a function below; false: no fog */
    uint32_t color;                               /* 0x00RRGGBB */
    const struct qtri_pipeline *const *pipelines; /* as those of qtri_depth_format */
    /* f, 1024 being 1, and beyond 0..1, held there: by eighths of octaves of how far the depth is
       from the farthest, or, where step_bits is not 0, by steps of 2^that from `first` on. */
    uint32_t first;
    uint8_t step_bits;
    int16_t share[QTRI_FOG_STEPS];
};

/* end <= start: all beyond start is fog. */
void qtri_fog_linear(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 start, q16 end);

/* Negative densities count as 0. */
void qtri_fog_exp(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 density);
void qtri_fog_exp2(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 density);

#ifdef __cplusplus
}
#endif

#endif
