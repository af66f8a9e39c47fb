/* SPDX-License-Identifier: MIT */
/*
 * Text on a surface: proportional bitmap fonts, UTF-8.
 *
 * A font is constant data: what is not named is not linked. `qtri font IN.bdf -o NAME.h` makes one
 * of a BDF file; qtri_font_small is the library's own.
 *
 *     qtri_text_paint(&band, &qtri_font_small, 10, 20, "42 km/h", &brush);
 */
#ifndef QTRI_FONT_H
#define QTRI_FONT_H

#include <stdint.h>

#include "paint.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Rows of a glyph begin with a byte each, the leftmost pixel in the highest bit; there are
 * (width + 7) / 8 bytes a row.
 */
typedef struct qtri_glyph {
    uint16_t first;        /* of its bytes in the font's `rows` */
    uint8_t width, height; /* of the box that is stored; 0 where there is nothing to see */
    int8_t left, top;      /* of the box: to the right of the pen, and above the baseline */
    uint8_t advance;       /* how far the pen goes on */
} qtri_glyph;

/* Characters `first` .. first + count - 1 are the glyphs from `glyph` on. */
typedef struct qtri_glyph_range {
    uint32_t first;
    uint16_t count, glyph;
} qtri_glyph_range;

typedef struct qtri_font {
    const uint8_t *rows;
    const qtri_glyph *glyphs;
    const qtri_glyph_range *ranges; /* growing */
    uint16_t range_count;
    uint16_t missing;        /* the glyph of what the ranges do not have */
    uint8_t ascent, descent; /* pixels of a line above and below the baseline */
} qtri_font;

/* ASCII, proportional, capitals of 7 pixels, lines of 10. */
extern const qtri_font qtri_font_small;

/*
 * Paints text from pen position x (the left side of the first character's cell) on the baseline
 * above row `y`: whole pixels. Returns the pen's position behind it, saturated. A newline goes back
 * to x and down by ascent + descent rows. Bytes that are not UTF-8 are a missing character each.
 * Hard edges; alpha counts with an ink.
 */
int32_t qtri_text_paint(const qtri_surface *surface, const qtri_font *font, int32_t x, int32_t y,
                        const char *text, const qtri_brush *brush);

/* How far the pen goes in the widest line of the text, pixels, saturated. */
int32_t qtri_text_width(const qtri_font *font, const char *text);

/* The glyph of a character, never NULL. */
const qtri_glyph *qtri_font_glyph(const qtri_font *font, uint32_t character);

/*
 * The character that begins at *text, which moves on behind it; 0 at the end, where it stays.
 * 0xFFFD for a byte that does not begin a character: overlong, a surrogate, beyond 10FFFF, cut off.
 */
uint32_t qtri_text_next(const char **text);

#ifdef __cplusplus
}
#endif

#endif
