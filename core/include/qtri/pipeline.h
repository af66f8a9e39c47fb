/* SPDX-License-Identifier: MIT */
/*
 * Pipelines: what draws the pixels of triangles, one function for each set of options.
 *
 * A pixel is written once, as inline C whose options are a parameter (body/pixel.h). A pipeline is
 * a set of options and the functions that the compiler made of that body for them, where every
 * option is a constant. An application makes one of its own in a C file:
 *
 *     #include <qtri/pipeline_make.h>
 *
 *     QTRI_PIPELINE(lit_crate, .format = QTRI_RGB565, .depth = QTRI_LINEAR16,
 *                   .compare = QTRI_LESS, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_LIGHT)
 *
 * and lists it, before those of the library if it wants these as well:
 *
 *     static const qtri_pipeline *const pipelines[] = {&lit_crate, &qtri_pipeline_any, NULL};
 *     qtri_view_init_pipelines(&view, 320, 240, pipelines);
 *
 * A draw call takes the first pipeline of its view's list whose options are those that surface,
 * material and mesh ask for. &qtri_pipeline_any fits everything: the same body with options that
 * are read for each pixel draws the same bits in 4 to 8 times the instructions a pixel on long
 * rows. Blends, fog, filters and formats of depth bring pipelines for RGB565 with "less", which are
 * taken where &qtri_pipeline_brought stands in the list (config.h leaves them out). On a surface
 * with samples (antialias.h) the formats' own pipelines take the place of the generic one. For
 * another format or comparison QTRI_PIPELINES (pipeline_make.h) makes the usual ones in a line.
 * Where the list has none, or is NULL, nothing is drawn; a checked build (error.h) stops there, and
 * says which options the list lacks. `qtri pipelines` prints those of a scene. Lines, strokes and
 * points need none.
 */
#ifndef QTRI_PIPELINE_H
#define QTRI_PIPELINE_H

#include <stdbool.h>
#include <stdint.h>

#include "material.h"
#include "surface.h"
#include "texture.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of .format: every pixel of every draw; of .read_only: both. */
enum { QTRI_ANY = 255, QTRI_BROUGHT = 254 };

/* Where colours come from, and what texels are multiplied by. */
enum {
    QTRI_FLAT,        /* one colour a triangle; a texel as it is (QTRI_REPLACE) */
    QTRI_TINT,        /* a texel times one colour a triangle */
    QTRI_LIGHT,       /* material.color times light that varies; a texel times that */
    QTRI_WHITE_LIGHT, /* QTRI_LIGHT with a white material: faster with texels, the same pixels */
    QTRI_COLORS       /* colours that vary; a texel times these */
};

/* What a pixel function of the application's own is given, and gives. */
struct qtri_fragment {
    int32_t x, y;         /* pixel of the frame */
    uint32_t depth_16p16; /* window z times 65535 */
    uint32_t u, v;        /* of a texture: 2^-32 of a repeat, whole repeats dropped */
    uint32_t light_q8;    /* 0..256 with QTRI_LIGHT, else 256 */
    uint32_t color;       /* 0x00RRGGBB: what would be drawn; out: what is */
};

/* What a pipeline draws: the options of surface, material and mesh that it is made for. */
typedef struct qtri_options {
    uint8_t format;    /* of format.h */
    uint8_t depth;     /* of format.h */
    uint8_t compare;   /* a qtri_compare; QTRI_ANY: the material's, read for each pixel */
    uint8_t read_only; /* material.depth_read_only; QTRI_ANY: as the material says */
    uint8_t texel;     /* of texture.h */
    uint8_t bilinear, mipmapped;
    uint8_t key;        /* texture.has_key */
    uint8_t alpha_test; /* material.least_alpha != 0, of texels with alpha */
    uint8_t shade;
    uint8_t blend;        /* of material.h */
    uint8_t vertex_alpha; /* alpha varies between the vertices */
    uint8_t keep;         /* material.keep != 0 */
    uint8_t fog;
    uint8_t samples;       /* 4: a surface of four samples a pixel */
    uint8_t large_texture; /* of more than 2^16 texels */
    uint8_t per_pixel;     /* &qtri_per_pixel in a view's lights */
    uint8_t covered;       /* internal: strokes, of which pixels are covered in part */
    uint8_t pixel_bytes;   /* of QTRI_OTHER_FORMAT: 1..4 */
    uint8_t depth_bytes;   /* internal: these three of draws by the generic pipeline */
    uint16_t asks;
    uint8_t wrap_u, wrap_v; /* no longer asked for: pipelines repeat and clamp textures alike */

    /* Formats of the application's own that the functions below stand for. */
    const qtri_format *own_format;
    const qtri_texel_format *own_texel;
    /* Such a format, as the functions of qtri_format for one pixel; NULL: those of the surface's
       format are called. */
    uint32_t (*encode)(uint32_t color);  /* 0x00RRGGBB to what is stored */
    uint32_t (*decode)(uint32_t stored); /* and back */
    /* Such texels, by number: 0xAARRGGBB; NULL: those of the texture's format are called. */
    uint32_t (*fetch)(const qtri_texture *texture, uint32_t number);
    /* material.fragment: a pixel function; false discards the pixel, its depth too. */
    bool (*fragment)(qtri_fragment *fragment);
} qtri_options;

struct qtri_draw_state;
struct qtri_large_input;
struct qtri_small;
struct qtri_stroke_span;
struct qtri_line_job;
struct qtri_vertex;

struct qtri_pipeline {
    qtri_options options;
    /* Internal: what draws a large triangle, and a small one of a mesh. */
    void (*large)(const struct qtri_large_input *triangle);
    bool (*small)(struct qtri_small *triangle); /* false: it is large */
    /* Of those that draw no triangles: pixels of a stroke, and a line. */
    void (*span)(const struct qtri_stroke_span *span);
    void (*line)(const struct qtri_line_job *job, const struct qtri_vertex *a,
                 const struct qtri_vertex *b, const int32_t color[][3]);
    /* Where it is not NULL and the options fit: returns what draws, the pipeline or one that it
       stands for; NULL: none. */
    const qtri_pipeline *(*choose)(const qtri_pipeline *pipeline, struct qtri_draw_state *state);
};

/* In a list: here is looked at what blend, fog, filter and depth format bring. */
extern const qtri_pipeline qtri_pipeline_brought;

/* Draws whatever is asked for. */
extern const qtri_pipeline qtri_pipeline_any;

/* On RGB565 with linear16 depth and "less", in perspective. */
extern const qtri_pipeline qtri_pipeline_flat;          /* one colour a triangle */
extern const qtri_pipeline qtri_pipeline_lit;           /* material.color in light by vertex */
extern const qtri_pipeline qtri_pipeline_colors;        /* colours of the vertices */
extern const qtri_pipeline qtri_pipeline_texture;       /* RGB565 texels as they are */
extern const qtri_pipeline qtri_pipeline_texture_tint;  /* times one colour a triangle */
extern const qtri_pipeline qtri_pipeline_texture_lit;   /* times material.color in light */
extern const qtri_pipeline qtri_pipeline_texture_white; /* times light: of a white material */

extern const qtri_pipeline qtri_pipeline_mipmapped; /* with levels, &qtri_mipmapped: as they are */
extern const qtri_pipeline qtri_pipeline_mipmapped_lit;   /* times material.color in light */
extern const qtri_pipeline qtri_pipeline_mipmapped_white; /* times light: of a white material */

/* These but the mipmapped ones, which their filter brings, then &qtri_pipeline_brought and
   &qtri_pipeline_any. NULL ends a list. */
extern const qtri_pipeline *const qtri_pipelines_default[];

/* On RGB565 in the byte order of displays on SPI, &qtri_rgb565_swapped. */
extern const qtri_pipeline qtri_pipeline_swapped_flat, qtri_pipeline_swapped_lit,
    qtri_pipeline_swapped_colors, qtri_pipeline_swapped_texture, qtri_pipeline_swapped_texture_tint,
    qtri_pipeline_swapped_texture_lit, qtri_pipeline_swapped_texture_white;

/* These, then &qtri_pipeline_any. */
extern const qtri_pipeline *const qtri_pipelines_swapped[];

#ifdef __cplusplus
}
#endif

#endif
