/* SPDX-License-Identifier: MIT */
/*
 * How triangles and lines look: colour, shading, texture, and what decides whether a pixel is
 * drawn.
 *
 * A material is constant data that a draw call reads; there is no current state anywhere.
 * A number that is none of its enum has the result that stands at the enum, in whole frames, bands
 * and scissors alike. A zeroed material is black, flat, perspective-correct, untextured, culls
 * nothing and ignores depth; qtri_material_default is the one most meshes want.
 */
#ifndef QTRI_MATERIAL_H
#define QTRI_MATERIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "format.h"
#include "q16.h"
#include "surface.h"
#include "texture.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Which colour the inside of a triangle has. What interpolates colours is linked by the name of
 * smooth shading alone. NULL: flat, as QTRI_FLAT_LAST.
 */
typedef struct qtri_shading qtri_shading;
extern const qtri_shading qtri_smooth;     /* colours interpolated between the vertices */
extern const qtri_shading qtri_flat_first; /* the first vertex's colour; light per face */
extern const qtri_shading qtri_flat_last;  /* the last vertex's colour; light per face */

/* As smooth; in a view's `lights` large triangles are lit inside as well: by pixel, see light.h. */
extern const qtri_shading qtri_per_pixel;

/* The same, in the spelling of the choices below. */
#define QTRI_PER_PIXEL  (&qtri_per_pixel)
#define QTRI_SMOOTH     (&qtri_smooth)
#define QTRI_FLAT_FIRST (&qtri_flat_first)
#define QTRI_FLAT_LAST  (&qtri_flat_last)

/* Anything else is QTRI_SCREEN_LINEAR. */
typedef enum qtri_interpolation {
    QTRI_PERSPECTIVE,  /* linear on the surface of the triangle */
    QTRI_SCREEN_LINEAR /* linear on the screen: affine textures, Gouraud colours */
} qtri_interpolation;

/* Anything else is QTRI_MODULATE. */
typedef enum qtri_texture_mode { QTRI_MODULATE, QTRI_REPLACE } qtri_texture_mode;

/* Counter-clockwise, as seen in the picture, is front. Anything else is QTRI_CULL_NONE. */
typedef enum qtri_cull { QTRI_CULL_NONE, QTRI_CULL_BACK, QTRI_CULL_FRONT } qtri_cull;

/* How triangles are filled. NULL: solid. */
typedef struct qtri_fill qtri_fill;
extern const qtri_fill qtri_wireframe; /* their edges as lines */

/* What else than its colour it reflects of a view's `lights`: see light.h. */
typedef struct qtri_reflection qtri_reflection;

/* What becomes of a pixel that is drawn over another, and fog: see below. */
typedef struct qtri_blend qtri_blend;
typedef struct qtri_fog qtri_fog;

/* A fragment is drawn when `its depth COMPARE stored depth`. Anything else is QTRI_ALWAYS. */
typedef enum qtri_compare {
    QTRI_DEPTH_OFF, /* always drawn, never written */
    QTRI_NEVER,
    QTRI_LESS,
    QTRI_EQUAL,
    QTRI_LESS_EQUAL,
    QTRI_GREATER,
    QTRI_NOT_EQUAL,
    QTRI_GREATER_EQUAL,
    QTRI_ALWAYS
} qtri_compare;

/* What moves the depths of a triangle as a whole: see material.depth_shift. */
typedef struct qtri_depth_shift qtri_depth_shift;
extern const qtri_depth_shift qtri_slope_bias;

typedef struct qtri_fragment qtri_fragment;

/* Channels that stay as they are. Of GRAY8: only all three. */
enum { QTRI_KEEP_BLUE = 1, QTRI_KEEP_GREEN = 2, QTRI_KEEP_RED = 4 };

/* How a draw call colours, tests and stores the pixels of its triangles. */
typedef struct qtri_material {
    qtri_rgb color;              /* of meshes that bring no colours of their own */
    const qtri_shading *shading; /* NULL: flat */
    qtri_interpolation interpolation;
    const qtri_texture *texture; /* NULL: none */
    qtri_texture_mode texture_mode;
    qtri_cull cull;
    const qtri_fill *fill;
    qtri_compare depth_compare;
    bool depth_read_only; /* test but do not write */
    q16 depth_bias; /* is added to the viewport's depths, which are held to 0..1: negative draws
                       nearer, what lies on a surface over it. All of it counts where the viewport
                       leaves room, and else at the far plane, and in proportion before it */
    const qtri_blend *blend; /* NULL: pixels are stored as they are */
    uint8_t alpha;           /* for the blend: 255 is all of it */
    uint8_t keep;            /* QTRI_KEEP_RED and others: channels that a blend does not write */
    uint8_t least_alpha;     /* texels of less are not drawn, nor their depth; 0: all are */
    const qtri_fog *fog;     /* NULL: none */
    const qtri_reflection *reflection; /* NULL: no highlights, no emission, one side */
    const uint8_t *alphas; /* of the mesh's vertices or the call's corners, for blends by vertex;
                              NULL: 255 */
    /*
     * NULL: depth_bias alone. &qtri_slope_bias: depths of triangles are moved by depth_slope times
     * what depth changes by a pixel to the right or down, whichever is more, as well: negative
     * draws steep faces nearer. It is held so that no vertex leaves 0..1, of a clipped triangle
     * those of each piece. Lines and strokes are not moved.
     */
    const qtri_depth_shift *depth_shift;
    q16 depth_slope;
    /* NULL, or a pixel function of the application's own: see pipeline.h. */
    bool (*fragment)(qtri_fragment *fragment);
} qtri_material;

/* White, smooth, perspective, back faces culled, depth "less", written. */
qtri_material qtri_material_default(void);

/* Blending and fog
 * ---------------------------------------------------------------------------------------------- */

/*
 * A blend is chosen by its address; what no material names is not linked. It works on pixels that
 * have passed the depth test, one after the other where triangles overlap, in every format of
 * surface. Depths are written as without; what is seen through is drawn last, from far to near,
 * with material.depth_read_only.
 *
 * All but the screen door leave channels of stored pixels alone that material.keep names. A pixel's
 * alpha is material.alpha, times that of its texel where the texture's format has one, and times
 * that of the vertices with a blend that asks for it. What is blended is rounded before and after:
 * within 1 1/4 of 255 of what exact colours are together, 1 1/2 with alpha of texels or of
 * vertices; of RGB565 within 1 step, 1 1/4 where colours vary. Fog, with what its share is off, is
 * within 1 3/4 of 255, with a constant alpha 2. Triangles of RGB565 in fog are rounded once, and
 * are within .85 of a step, with a constant alpha .9.
 *
 * Each edge of a wireframe's triangles is blended, so that one that two triangles share is drawn
 * twice where depth does not turn the second away. Of strokes and points (stroke.h) what fog and
 * blend make of a pixel counts as far as it is covered.
 */

/* What becomes of the pixel under it. */
enum {
    QTRI_STORE,
    QTRI_ALPHA,      /* &qtri_blend_alpha, and by vertex: .vertex_alpha */
    QTRI_ADD,        /* &qtri_blend_add */
    QTRI_MULTIPLY,   /* &qtri_blend_multiply */
    QTRI_KEEP_PIXEL, /* &qtri_blend_none */
    QTRI_SCREEN_DOOR /* &qtri_blend_screen_door */
};

extern const qtri_blend qtri_blend_alpha;    /* colour alpha + stored (1 - alpha) */
extern const qtri_blend qtri_blend_add;      /* stored + colour alpha, at most full */
extern const qtri_blend qtri_blend_multiply; /* stored times colour, whatever the alpha */
extern const qtri_blend qtri_blend_none;     /* stored: depths alone are written */
extern const qtri_blend qtri_blend_replace;  /* colour, but for the channels of material.keep */

/* A share of alpha of the pixels, in a pattern of 4 by 4: no order, nothing read. */
extern const qtri_blend qtri_blend_screen_door;

/*
 * The first two with alpha that varies between the vertices, material.alphas, perspective-correct
 * where colours are, whatever the shading. Colours are within 1 1/2 of 255, and within .9 of a step
 * of RGB565, of exact ones. Lines and strokes have material.alpha alone. With four samples a pixel
 * (antialias.h) alpha is that of the pixel's centre, held to that of the vertices.
 */
extern const qtri_blend qtri_blend_vertex_alpha;
extern const qtri_blend qtri_blend_vertex_add;

/*
 * Fog by depth: colour f + fog's colour (1 - f), where f falls with z, the distance from the eye's
 * plane: linear (end - z) / (end - start), held to 0..1, or exp(-density z), or exp(-(density
 * z)^2). z is found from the depth of the pixel, with its fraction, by the projection's near and
 * far; the viewport's depths must be 0 and 1. f is within 1/256.
 */

/* Where depths of 0 and 1 are. near_z is at least 1/65536, far_z more than it: both are held. */
typedef struct qtri_fog_range {
    q16 near_z, far_z;
    bool orthographic; /* depth is linear in z */
} qtri_fog_range;

enum { QTRI_FOG_STEPS = 16 * 8 + 3 };

struct qtri_effect;

/* Fog, as functions of depth: filled in by the functions below. */
struct qtri_fog {
    bool is_set;                      /* by a function below; false: no fog */
    uint32_t color;                   /* 0x00RRGGBB */
    const struct qtri_effect *effect; /* what draws it; internal */
    /* f, 1024 being 1, and beyond 0..1, held there: by eighths of octaves of how far the depth is
       from the farthest, or, where step_bits is not 0, by steps of 2^that from `first` on, f of
       which is share[0], too. */
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
