/* SPDX-License-Identifier: MIT */
/*
 * Properties of a pipeline that follow from its options: constants where the options are. Internal,
 * part of the pipelines' body (pipeline_make.h).
 */
#ifndef QTRI_BODY_OPTIONS_H
#define QTRI_BODY_OPTIONS_H

#include "state.h"

/* Bits of qtri_options.asks: results of the functions below, for the generic pipeline, which would
   compute them for every pixel. The two lowest are qtri_kind_of(). */
enum {
    QTRI_ASK_KIND,
    QTRI_ASK_565 = 2,
    QTRI_ASK_ALPHA,
    QTRI_ASK_ALPHA_USED,
    QTRI_ASK_TWO_WORDS,
    QTRI_ASK_PACKED,
    QTRI_ASK_TABLE,
    QTRI_ASK_TEST,
    QTRI_ASK_WRITE,
    QTRI_ASK_DEPTH,
    QTRI_ASK_PLACE,
    QTRI_ASK_DISCARD,
    QTRI_ASK_READ,
    QTRI_ASK_PLAIN
};

#if defined(QTRI_PIPELINE_IS_ANY_BY_ASKS)
#define QTRI_ASKS(o, bit, answer) (((o)->asks >> (bit)&1) != 0)
#else
#define QTRI_ASKS(o, bit, answer) (answer)
#endif

QTRI_BODY bool qtri_stores_565(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_565, o->format == QTRI_RGB565 || o->format == QTRI_RGB565_SWAPPED);
}

/* Four samples a pixel. The generic pipeline is made twice, so that only programs whose surfaces
   have samples link what draws them. */
QTRI_BODY bool qtri_has_samples(const qtri_options *o)
{
#if defined(QTRI_PIPELINE_IS_ANY_X4)
    (void)o;
    return true;
#elif defined(QTRI_PIPELINE_IS_ANY)
    (void)o;
    return false;
#else
    return o->samples != 0;
#endif
}

QTRI_BODY bool qtri_is_textured(const qtri_options *o)
{
    return o->texel != QTRI_NO_TEXEL;
}

QTRI_BODY bool qtri_has_alpha(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_ALPHA,
                     (o->texel >= QTRI_TEXEL_ARGB8888 && o->texel <= QTRI_TEXEL_ALPHA8) ||
                         (o->texel == QTRI_OTHER_TEXEL && o->fetch != NULL));
}

/* Texels are filtered with their alpha, which a test or a blend uses. */
QTRI_BODY bool qtri_uses_alpha(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_ALPHA_USED,
                     qtri_has_alpha(o) && (o->alpha_test || o->blend != QTRI_STORE));
}

/* The sides of the texture, or of the level that is drawn, as powers of two. */
QTRI_BODY uint32_t qtri_texture_width_log2(const qtri_options *o, const qtri_draw_state *state)
{
    return o->mipmapped ? state->level_texture.width_log2 : state->width_log2;
}

QTRI_BODY uint32_t qtri_texture_height_log2(const qtri_options *o, const qtri_draw_state *state)
{
    return o->mipmapped ? state->level_texture.height_log2 : state->height_log2;
}

/* The last that is done to a colour is a mixture: by coverage, alpha, or fog. */
QTRI_BODY bool qtri_mixes_last(const qtri_options *o)
{
    return o->blend != QTRI_ADD && o->blend != QTRI_MULTIPLY && !o->keep &&
           (o->covered || o->blend == QTRI_ALPHA || o->fog);
}

/* The format that pixels are computed in. RGB565: its own where texels have it and nothing rounds
   colours before the last step; fine where that mixes, from which they are rounded once. Gray with
   a texture needs equal light in all channels, and no QTRI_ADD, which saturates each by itself. */
QTRI_BODY qtri_color_kind qtri_find_kind(const qtri_options *o)
{
    if (o->fragment != NULL) {
        return QTRI_IN_888;
    }
    if (qtri_stores_565(o)) {
        if (!o->fog && !o->vertex_alpha && (!o->covered || o->blend == QTRI_STORE) &&
            (o->texel == QTRI_NO_TEXEL || o->texel == QTRI_TEXEL_RGB565 ||
             o->texel == QTRI_TEXEL_PALETTE565)) {
            return QTRI_IN_565;
        }
        return qtri_mixes_last(o) && !o->per_pixel ? QTRI_IN_FINE_565 : QTRI_IN_888;
    }
    return o->format == QTRI_GRAY8 && (o->texel == QTRI_NO_TEXEL ||
                                       (o->texel <= QTRI_TEXEL_CHECKER && o->blend != QTRI_ADD &&
                                        (o->shade == QTRI_FLAT || o->shade == QTRI_WHITE_LIGHT)))
               ? QTRI_IN_GRAY
               : QTRI_IN_888;
}

/* That, or where options are read at run time what they say of it. */
QTRI_BODY qtri_color_kind qtri_kind_of(const qtri_options *o)
{
#if defined(QTRI_PIPELINE_IS_ANY_BY_ASKS) || defined(QTRI_PIPELINE_IS_ANY_BY_KIND)
    return (qtri_color_kind)(o->asks & 3);
#else
    return qtri_find_kind(o);
#endif
}

QTRI_BODY bool qtri_is_lit(const qtri_options *o)
{
    return o->shade == QTRI_LIGHT || o->shade == QTRI_WHITE_LIGHT;
}

/* Light or colours vary over a triangle. */
QTRI_BODY bool qtri_varies(const qtri_options *o)
{
    return o->shade >= QTRI_LIGHT;
}

/* Vertex colours are stepped in two words, c and g of qtri_pixel_walk. */
QTRI_BODY bool qtri_has_two_words(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_TWO_WORDS,
                     o->shade == QTRI_COLORS &&
                         (qtri_is_textured(o) || qtri_kind_of(o) == QTRI_IN_888 ||
                          qtri_kind_of(o) == QTRI_IN_FINE_565));
}

/* Vertex colours are stepped in one word, all channels of 565. */
QTRI_BODY bool qtri_is_packed_565(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_PACKED,
                     o->shade == QTRI_COLORS && !qtri_is_textured(o) &&
                         qtri_kind_of(o) == QTRI_IN_565);
}

/* Pixels are read by their light from the state's table. */
QTRI_BODY bool qtri_uses_table(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_TABLE,
                     qtri_is_lit(o) && !qtri_is_textured(o) && qtri_kind_of(o) == QTRI_IN_565);
}

QTRI_BODY bool qtri_tests_depth(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_TEST, o->depth != QTRI_NO_DEPTH && o->compare != QTRI_DEPTH_OFF);
}

/* The comparison is read from the material for each pixel. */
QTRI_BODY bool qtri_compares_by_any(const qtri_options *o)
{
#ifdef QTRI_PIPELINE_IS_ANY
    (void)o;
    return true;
#else
    return o->compare == QTRI_ANY;
#endif
}

/* Depth may be written; with QTRI_ANY the walk's keeps_depth tells. */
QTRI_BODY bool qtri_writes_depth(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_WRITE,
                     qtri_tests_depth(o) && (!o->read_only || o->read_only == QTRI_ANY));
}

QTRI_BODY bool qtri_needs_depth(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_DEPTH, qtri_tests_depth(o) || o->fog || o->fragment != NULL);
}

/* Pixels use x and y of the walk. */
QTRI_BODY bool qtri_needs_place(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_PLACE,
                     o->blend == QTRI_SCREEN_DOOR || o->fragment != NULL || qtri_has_samples(o));
}

/* A pixel may be discarded after the depth test. */
QTRI_BODY bool qtri_discards(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_DISCARD,
                     o->key || o->alpha_test || o->blend == QTRI_SCREEN_DOOR ||
                         o->fragment != NULL);
}

/* The destination pixel is read. */
QTRI_BODY bool qtri_reads_pixel(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_READ,
                     o->blend == QTRI_ALPHA || o->blend == QTRI_ADD || o->blend == QTRI_MULTIPLY ||
                         o->keep || o->covered);
}

/* All pixels of a triangle that are drawn get one colour, which is encoded once. */
QTRI_BODY bool qtri_has_constant_color(const qtri_options *o)
{
    return QTRI_ASKS(o, QTRI_ASK_PLAIN,
                     !qtri_is_textured(o) && !qtri_varies(o) && !o->fog && !qtri_reads_pixel(o) &&
                         o->fragment == NULL);
}

#endif
