/* SPDX-License-Identifier: MIT */
/*
 * The state of a draw call, and of a loop over pixels, its "walk". Internal, part of the pipelines'
 * body (pipeline_make.h).
 */
#ifndef QTRI_BODY_STATE_H
#define QTRI_BODY_STATE_H

#include "../pipeline.h"
#include "color.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { QTRI_TABLE_LOG2 = 7, QTRI_TABLE = (1 << QTRI_TABLE_LOG2) + 1 }; /* colours by light */

/* Traits of a texture, or of its current level; 0: it repeats, and has 2^8 texels or more. */
enum {
    QTRI_CLAMPS_U = 1,
    QTRI_CLAMPS_V = 2,
    QTRI_ONE_WIDE = 4,  /* its width is a texel */
    QTRI_FEW_TEXELS = 8 /* less than 2^8 */
};

struct qtri_pixel_walk;

/* Draws `count` > 0 pixels of a walk. `bent`: steps of u and v grow. */
typedef void qtri_pixels_loop(struct qtri_pixel_walk *w, bool bent, int32_t count);

/* Set once a draw call, by draw_state.c. */
typedef struct qtri_draw_state {
    bool is_linear; /* nothing follows perspective: QTRI_SCREEN_LINEAR */
    bool is_lit;    /* `lit` is set for each triangle */
    bool has_table; /* `table` is set */
    uint8_t traits; /* of the texture: QTRI_CLAMPS_U ... */
    const qtri_pipeline *pipeline;
    qtri_options options; /* what surface, material and mesh ask for; Armv6-M reaches 31 bytes */
    /* Draws a small triangle: the pipeline's, or one that shifts depths first. False: it is large.
     */
    bool (*small)(struct qtri_small *triangle);
    const qtri_surface *surface;
    const qtri_material *material;
    qtri_rect bounds; /* what may be drawn */
    /* 24.8. Where vertex 0 of a small triangle that is not wide is in here, bounds cut nothing. */
    struct {
        uint32_t x, y, width, height;
    } inner;
    ptrdiff_t depth_pitch; /* bytes */

    const qtri_texture *texture;
    uint8_t width_log2, height_log2;     /* of its sides, at most 10 */
    uint8_t level, last_level;           /* mipmapped: the level that `texture` is now, the last */
    uint32_t key, key_mask, alpha_least; /* alpha_least: material.least_alpha << 24 */

    uint32_t color;          /* material.color, 0x00RRGGBB */
    uint32_t weight[3];      /* of its red, green and blue: 256 is 1 */
    uint32_t alpha;          /* material.alpha: 256 is 1 */
    const uint8_t *alphas;   /* of vertices: the material's, or those of a loose triangle */
    uint32_t alpha_index[3]; /* into alphas, of the vertices of a triangle to be clipped */
    uint32_t keep;           /* channel mask: bits that stay as stored, in qtri_kind_of() */
    uint32_t fog_color;      /* in that kind */
    const qtri_fog *fog;

    /* With a view's lights: 0x00RRGGBB of the triangle's vertices, in the order of its indices. */
    uint32_t lit[3];
    struct qtri_light_walk *light_walk; /* with per_pixel: see large.h */
    /* With per_pixel: whether light is linear between the vertices of a small triangle. */
    bool (*has_linear_light)(const struct qtri_small *triangle);
    /* Mipmapped: `texture` is this copy of the material's, with texels and sides of a level. */
    qtri_texture level_texture;
    /* For the generic pipeline: the texture's filter, NULL for nearest; its loop over pixels. */
    uint32_t (*between)(const struct qtri_pixel_walk *w, bool *drawn);
    qtri_pixels_loop *loop;
    void *depth;       /* the surface's, or, */
    uint16_t no_depth; /*   where it has none, this in place of all */

    /* QTRI_LIGHT without texture on RGB565: stored pixels by light. QTRI_TABLE of them, in memory
       of the draw calls that have such light: of meshes. */
    uint16_t *table;
} qtri_draw_state;

/*
 * Depths, with the half that rounds linear16, that &qtri_depth_float16 stores with one exponent:
 * `size` of them from `zero` on are base + ((z - zero) >> down), 0 < down. size 0: none is known.
 */
typedef struct qtri_octave {
    uint32_t zero, size, base, down;
} qtri_octave;

/*
 * What the loop over pixels steps. With n.16 the half that rounds is in the start.
 *
 * Texture coordinates fill 32 bits, so that they wrap by themselves: u 2^32 is a repeat; v 2^(16 +
 * width_log2 + height_log2) is one, so that one mask cuts out a row times the width, or, of a
 * texture of more than 2^16 texels, 2^32. What is clamped was held to the texture before, see
 * large_clamp.c and small_texture.c; u of a texture one texel wide is 0.
 *
 * c and g, by what varies:
 *     light                     c: 8.16, 256.0 is 1
 *     colours, textured         c: red 9.7 in the upper half, blue 9.7 in the lower; g: 9.16;
 *                               256 is 1
 *     colours of 565            c: packed, red 5.6 << 21, blue 5.11 << 11 ..., see pixel.h
 *     colours of 888            c: red 8.8 in the upper half, blue 8.8 in the lower; g: 8.16
 *     gray                      c: luma, 8.16
 */
typedef struct qtri_pixel_walk {
    uint8_t *pixel, *depth;
    uintptr_t apart;    /* from a depth to its pixel, where one pointer serves both */
    uint32_t z, z_step; /* 16.16, with QTRI_DEPTH_HALF, less octave.zero */
    qtri_octave octave; /* of rows whose depths are stored by it; otherwise zeros */
    uint32_t u, v, u_step, v_step, u_bend, v_bend; /* bend: what a step grows by each pixel */
    uint32_t c, c_step, g, g_step;
    uint32_t c_other;           /* packed colours of 565: every second step */
    uint32_t alpha, alpha_step; /* alpha of the vertices: 8.16, 256.0 is 1 */
    uint32_t fog, fog_step;     /* what fog leaves of the colour: 8.16, 256.0 is 1 */
    int32_t x, y;               /* of the frame; x only where options ask for it */
    uint32_t cover;             /* coverage by a stroke: 256 is all of the pixel */
    bool cover_writes;          /* depth, as half of the pixel or more is covered */
    bool keeps_depth;           /* the material's depths are read only; see qtri_pixel_writes() */
    /* Where options are for any comparison, see qtri_walk_set_compare(). */
    uint8_t passes;
    uint32_t pass_first, pass_count;

    /* Four samples a pixel, see samples.h: which of them are drawn; depths at samples 3 and 1, and
       where the pixel takes its colour, less that at the centre. */
    uint32_t samples;
    uint32_t z_p, z_q, z_place;
    const struct qtri_samples_row *sample_row; /* of a large triangle */

    /* Constant along a row. */
    const qtri_draw_state *state;
    const void *texels, *palette;
    /* rows: mask of v; its low byte: where a column begins in u. v_shift: where a row does in v. */
    uint32_t rows, v_shift, width_log2;
    uint32_t color; /* of the triangle: of the kind; where nothing else is done, as it is stored */
    uint32_t opacity, fog_color; /* the state's alpha; its fog_color */
    /* Lit texture: weights of the state, of 565 green's also << 16 in red; the half that rounds. */
    uint32_t red, green, blue, half;
    const uint16_t *table;
} qtri_pixel_walk;

/* What fog leaves of a colour at a depth with the half that rounds: 8.16, 256.0 is 1, off by 1/2 at
   most. In fog.c. */
uint32_t qtri_fog_share(const qtri_fog *fog, uint32_t depth_16p16);

/* Fog along `count` >= 1 pixels, linear between its shares at the first and the last: a pixel's
   step, and the first, with the half that rounds. */
uint32_t qtri_fog_along(uint32_t *step, const qtri_fog *fog, uint32_t z, uint32_t z_step,
                        uint32_t count);

/* Makes state->level_texture another mipmap level, 0..state->last_level. */
void qtri_draw_state_set_level(qtri_draw_state *state, uint32_t level);

/* Fills state->table from state->color, when a triangle first needs it. */
void qtri_draw_state_set_table(qtri_draw_state *state);

/* A pixel, depth or texel by the callbacks of a user-defined format, in own_formats.c. */
uint32_t qtri_encode_other(const qtri_format *format, uint32_t color_888);
uint32_t qtri_depth_encode_other(const qtri_depth_format *format, uint32_t z_16p16);
uint32_t qtri_texel_other(const qtri_texture *texture, uint32_t stored);
uint32_t qtri_fetch_other(const qtri_texture *texture, uint32_t number);

/* The mean of four texels with alpha, weights of 11 bits, in texel_filter.c. */
uint32_t qtri_alpha_mean(const uint32_t texel[4], uint32_t along, uint32_t across);

/* depth_16p16, 65535.0 at most, as &qtri_depth_float16 stores it. */
uint32_t qtri_depth_encode_float16(uint32_t z_16p16);

/* The octave of a depth with the half that rounds linear16. */
qtri_octave qtri_depth_octave(uint32_t z);

/* A vertex of a large triangle but for its place on the screen; what options do not ask for need
 * not be set. */
typedef struct qtri_large_vertex {
    uint32_t depth_16p16; /* <= 65535.0 */
    uint32_t inv_w_q31;   /* 2^30..2^31 */
    int32_t inv_w_exponent;
    uint32_t light_q15;    /* with QTRI_LIGHT */
    int32_t color_8p16[3]; /* with QTRI_COLORS */
    int64_t u_q32, v_q32;  /* 2^32 is a repeat */
    int16_t rest[2];       /* of x and y: the true place less the snapped one, 2^-24 pixel */
    uint32_t alpha_q16;    /* with vertex_alpha */
} qtri_large_vertex;

#ifdef __cplusplus
}
#endif

#endif
