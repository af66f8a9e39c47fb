/* SPDX-License-Identifier: MIT */
/*
 * Bitmap fonts in Adobe's Glyph Bitmap Distribution Format, version 2.1.
 */
#ifndef QTRI_HOST_IO_BDF_H
#define QTRI_HOST_IO_BDF_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "text_error.h"

struct bdf_glyph {
    uint32_t character; /* its number, the font's encoding being taken for Unicode */
    int width, height;  /* of the box that is stored, 0..255 */
    int left, top;      /* of the box: to the right of the pen, above the baseline; -128..127 */
    int advance;        /* 0..255 */
    size_t first;       /* of its bytes: rows from the top, (width + 7) / 8 bytes each, the
                           leftmost pixel in the highest bit, 0 behind the last */
    int line;           /* of its STARTCHAR */
};

struct bdf_font {
    struct bdf_glyph *glyphs; /* by character, growing */
    size_t glyph_count;       /* 1..65535 */
    uint8_t *rows;
    size_t row_bytes;    /* 0..65535 */
    int ascent, descent; /* 0..255 */
    size_t missing;      /* the glyph of DEFAULT_CHAR; without one, U+FFFD, `?`, or the first */
};

/*
 * Parses `length` bytes of any content; `name` is what messages call the file. Glyphs without a
 * number are passed over. True, and bdf_free() it, or false with *error set and nothing to free.
 */
bool bdf_parse(const char *name, const char *text, size_t length, struct bdf_font *font,
               struct text_error *error);

/* Reads a file and parses it. */
bool bdf_read(const char *path, struct bdf_font *font, struct text_error *error);

/* The glyph of a character, or the one of what is missing. */
const struct bdf_glyph *bdf_find(const struct bdf_font *font, uint32_t character);

void bdf_free(struct bdf_font *font);

#endif
