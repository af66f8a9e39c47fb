/*
 * How triangles and lines look: colour, shading, texture, and what decides whether a pixel is
 * drawn.
 *
 * A material is constant data that a draw call reads; there is no current state anywhere.
 * A zeroed material is black, smooth, perspective-correct, untextured, culls nothing and ignores
 * depth; qtri_material_default is the one most meshes want.
 */
#ifndef QTRI_MATERIAL_H
#define QTRI_MATERIAL_H

#include <stdbool.h>
#include <stdint.h>

#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum qtri_texel_format {
    QTRI_TEXEL_RGB565,   /* texels: const uint16_t * */
    QTRI_TEXEL_XRGB8888, /* texels: const uint32_t * */
    QTRI_TEXEL_CHECKER,  /* two colours, no memory: see fields */
    QTRI_TEXEL_PALETTE8, /* texels: const uint8_t *, numbers of palette entries */
    QTRI_TEXEL_GRAY8     /* texels: const uint8_t *, white is 255 */
} qtri_texel_format;

/* What lies outside of 0..1. */
typedef enum qtri_wrap {
    QTRI_REPEAT, /* the texture again */
    QTRI_CLAMP   /* its first or last column or row */
} qtri_wrap;

typedef enum qtri_filter {
    QTRI_NEAREST, /* the texel that the coordinates lie in */
    QTRI_BILINEAR /* the four whose centres lie around them, weighted */
} qtri_filter;

/*
 * u = v = 0 is the first texel's first corner, u = 1 and v = 1 one past the last column and row;
 * the first texel's centre is half a texel on. Sides are powers of two. What an initialiser leaves
 * out is zero: repeated, nearest, without a key.
 *
 * Bilinear weights have 8 bits, rounded to nearest, and their sum of colours is rounded once, with
 * the pixel. A weight is off by 1/512 at most, and by what the coordinate is off: the colour by the
 * difference of neighbouring texels times that, in either direction, so by 1 of 255 where black
 * meets white.
 *
 * A texel that equals the key is not drawn, neither its colour nor its depth. Compared is what is
 * stored: 16 bits, the low 24 bits of XRGB8888, the number of a palette entry, a gray level, 0 or 1
 * for CHECKER's colours. So a palette may hold the key's colour once more, opaque. What bilinear
 * filtering draws is decided by the nearest texel: the same pixels as without the filter. There
 * the nearest texel also stands in for those of the four that equal the key, whose colour is seen
 * nowhere.
 *
 * Coordinates are interpolated as they are and clamped at each pixel, so that a clamped texture may
 * lie anywhere on a large triangle. 30 bits hold a triangle's range of coordinates, from the whole
 * repeat below the least: below 16 repeats of 1024 texels in steps of 2^-16 of a texel, below 32768
 * in steps of 1/32.
 */
typedef struct qtri_texture {
    const void *texels; /* row by row without gaps; NULL for CHECKER, elsewhere: no texture */
    qtri_texel_format format;
    uint8_t width_log2, height_log2; /* 0..10: sides 1..1024; more is taken as 10 */
    /* CHECKER: fields x fields fields over the texture, colour[(column + row) & 1]. */
    uint16_t fields;
    qtri_rgb color[2];
    qtri_wrap wrap_u, wrap_v; /* anything but CLAMP repeats */
    qtri_filter filter;       /* anything but BILINEAR is nearest */
    /* PALETTE8: 256 entries; NULL: no texture. 8 bits a channel as all colours, on GRAY8 and
       XRGB8888 surfaces too; 256 bytes more than RGB565, and nothing to widen for a pixel. */
    const qtri_rgb *palette;
    bool has_key;
    uint32_t key; /* the stored texel that is not drawn, if has_key */
} qtri_texture;

typedef enum qtri_shading {
    QTRI_SMOOTH,     /* colours interpolated between the vertices */
    QTRI_FLAT_FIRST, /* the first vertex's colour; light per face */
    QTRI_FLAT_LAST   /* the last vertex's colour; light per face */
} qtri_shading;

typedef enum qtri_interpolation {
    QTRI_PERSPECTIVE,  /* linear on the surface of the triangle */
    QTRI_SCREEN_LINEAR /* linear on the screen: affine textures, Gouraud colours */
} qtri_interpolation;

typedef enum qtri_texture_mode { QTRI_MODULATE, QTRI_REPLACE } qtri_texture_mode;

/* Counter-clockwise, as seen in the picture, is front. */
typedef enum qtri_cull { QTRI_CULL_NONE, QTRI_CULL_BACK, QTRI_CULL_FRONT } qtri_cull;

typedef enum qtri_fill { QTRI_SOLID, QTRI_WIREFRAME } qtri_fill;

/* A fragment is drawn when `its depth COMPARE stored depth`. */
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

typedef struct qtri_material {
    qtri_rgb color; /* of meshes that bring no colours of their own */
    qtri_shading shading;
    qtri_interpolation interpolation;
    const qtri_texture *texture; /* NULL: none */
    qtri_texture_mode texture_mode;
    qtri_cull cull;
    qtri_fill fill;
    qtri_compare depth_compare;
    bool depth_read_only; /* test but do not write */
} qtri_material;

/* White, smooth, perspective, back faces culled, depth "less", written. */
qtri_material qtri_material_default(void);

#ifdef __cplusplus
}
#endif

#endif
