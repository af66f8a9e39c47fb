/* SPDX-License-Identifier: MIT */
/*
 * The matrix: every product of surface format, depth test, source of colour, texture and geometry,
 * so that no combination is slow while its neighbours are fast. Freestanding.
 *
 * A case takes one entry of each table below. A new format, filter or geometry is a line in its
 * table; the first entry of a table is the one that cases have unless its axis is varied.
 */
#ifndef MATRIX_H
#define MATRIX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "bench_world.h"
#include "qtri.h"

typedef struct matrix_surface {
    const char *name;
    const qtri_format *format;
} matrix_surface;

typedef struct matrix_depth {
    const char *name;
    qtri_compare compare;
    q16 cleared; /* a depth, so that what is drawn passes */
    bool read_only;
    bool is_there; /* the geometry's own depth was drawn before, without colour */
} matrix_depth;

/* Of the corners of a quad. Of a mesh: the material's colour, white or not, or its vertex colours,
   each times light. */
typedef enum matrix_colors {
    MATRIX_ONE,  /* one colour for all */
    MATRIX_GREY, /* white in different light */
    MATRIX_TINT, /* one colour in different light */
    MATRIX_RGB   /* a different colour for each */
} matrix_colors;

typedef struct matrix_source {
    const char *name;
    matrix_colors colors;
    const qtri_shading *shading;
    qtri_texture_mode mode; /* where textured */
    bool textured;
} matrix_source;

typedef struct matrix_texel {
    const char *name;
    size_t texels; /* where matrix_frame has them */
    const qtri_texel_format *format;
    uint32_t key;
} matrix_texel;

typedef struct matrix_filter {
    const char *name;
    const qtri_filter *filter;
} matrix_filter;

typedef struct matrix_wrap {
    const char *name;
    qtri_wrap wrap;
    bool has_key;
} matrix_wrap;

/* A quad or a mesh, in a window of a larger picture. */
typedef struct matrix_geometry {
    const char *name;
    const bench_quad *quad;
    const qtri_mesh *mesh;
    const qtri_rgb *colors; /* of the mesh's vertices */
    q16 repeats;            /* of the texture, over the quad */
    q16 turn;               /* the mesh, about y */
    qtri_rect window;       /* of a picture 320x240, or half that size for quads */
} matrix_geometry;

enum matrix_axis {
    MATRIX_SURFACE,
    MATRIX_DEPTH,
    MATRIX_WRAP,
    MATRIX_TEXEL,
    MATRIX_FILTER,
    MATRIX_SOURCE,
    MATRIX_GEOMETRY,
    MATRIX_AXES
};

typedef struct matrix_case {
    uint8_t at[MATRIX_AXES]; /* index in the table of each axis: what follows */
    const matrix_surface *surface;
    const matrix_depth *depth;
    const matrix_source *source;
    const matrix_texel *texel;
    const matrix_filter *filter;
    const matrix_wrap *wrap;
    const matrix_geometry *geometry;
} matrix_case;

#define MATRIX_PIXELS_MAX (128 * 184) /* of a window */
#define MATRIX_TEXELS     (BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE)

/* The texels that are not drawn where there is a key: squares of a colour that no other has, and
   one of the two colours of a checkerboard. */
#define MATRIX_KEY_COLOR                                                                           \
    {                                                                                              \
        255, 0, 255                                                                                \
    }
#define MATRIX_KEY_RGB565   0xF81F
#define MATRIX_KEY_XRGB8888 0xFF00FF
#define MATRIX_KEY_PALETTE8 17
#define MATRIX_KEY_GRAY8    105
#define MATRIX_KEY_CHECKER  1

/* All that drawing a case needs. */
typedef struct matrix_frame {
    qtri_surface surface;
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
    qtri_texture texture;
    qtri_mesh mesh;
    qtri_corner corners[6];
    qtri_vertex vertices[BENCH_VERTICES_MAX];
    qtri_rgb palette[256];
    uint32_t xrgb8888[MATRIX_TEXELS];
    uint16_t rgb565[MATRIX_TEXELS];
    uint8_t palette8[MATRIX_TEXELS], gray8[MATRIX_TEXELS];
    uint32_t memory[QTRI_BAND_BYTES(MATRIX_PIXELS_MAX, 1, QTRI_XRGB8888_BYTES) / sizeof(uint32_t)];
} matrix_frame;

/* ---- Which cases there are: matrix_cases.c ---- */

#define MATRIX_NAME_MAX 96

/*
 * The first case, and the one after *now: false behind the last. `full`: the whole product.
 * Otherwise, for every source and geometry, those that have a pipeline of their own: of surface,
 * depth, wrap and texel at most one is not the table's first; filtered is every texel.
 */
void matrix_first(matrix_case *first);
bool matrix_next(matrix_case *now, bool full);

/* SURFACE/DEPTH/SOURCE/TEXEL/FILTER/WRAP/GEOMETRY; without a texture SURFACE/DEPTH/SOURCE/GEOMETRY.
 */
void matrix_name(const matrix_case *now, char name[MATRIX_NAME_MAX]);

/* Whether one of the patterns, separated by spaces, is the name; `*` is any text. No pattern: yes.
 */
bool matrix_matches(const char *patterns, const char *name);

/* ---- What they draw: matrix_draw.c ---- */

/* The texture in all its formats: once, before anything else. */
void matrix_set_textures(matrix_frame *frame);

/* Everything up to the draw call, with a cleared surface. False: there is no such mesh or format.
 */
bool matrix_prepare(matrix_frame *frame, const matrix_case *now);

/* What is measured: one draw call. */
void matrix_draw(matrix_frame *frame, const matrix_case *now);

/* How many pixels the geometry covers. Draws it: what was prepared is gone. */
uint32_t matrix_pixels(matrix_frame *frame, const matrix_geometry *geometry);

#endif
