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

#include "blend.h"
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

#ifdef __cplusplus
}
#endif

#endif
