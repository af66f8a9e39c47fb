/* SPDX-License-Identifier: MIT */
/*
 * Flat shapes, text and pictures in scene files: statements that paint onto the picture where they
 * stand, in pixels, in the colour and with the edges that were chosen last.
 */
#ifndef QTRI_HOST_IO_SCENE_PAINT_H
#define QTRI_HOST_IO_SCENE_PAINT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "bdf.h"
#include "picture.h"

enum scene_paint_kind {
    SCENE_PAINT_RECT,      /* x0 y0 x1 y1 [width] */
    SCENE_PAINT_ROUNDRECT, /* x0 y0 x1 y1 radius [width] */
    SCENE_PAINT_CIRCLE,    /* x y radius [width] */
    SCENE_PAINT_ARC,       /* x y radius width from sweep */
    SCENE_PAINT_AREA,      /* (x y) x3..8 */
    SCENE_PAINT_STROKE,    /* x0 y0 x1 y1 width */
    SCENE_PAINT_TEXT,      /* x y; font, text */
    SCENE_PAINT_IMAGE      /* x y [degrees scale]; image */
};

enum { SCENE_PAINT_NUMBERS = 16 };

struct scene_paint {
    enum scene_paint_kind kind;
    int32_t number[SCENE_PAINT_NUMBERS]; /* Q16.16, pixels and degrees */
    int count;                           /* of numbers given */
    int32_t color[3], alpha;             /* 0..1 */
    bool is_smooth;
    uint8_t has_key, key[3]; /* IMAGE: pixels of this colour are not painted */
    uint16_t font, image;    /* TEXT: in fonts; IMAGE: in images */
    uint32_t text;           /* TEXT: in texts */
};

struct scene_paints {
    struct bdf_font *fonts;
    struct picture *images;
    char **texts;
    size_t font_count, image_count, text_count;
};

void scene_paints_free(struct scene_paints *paints);

#endif
