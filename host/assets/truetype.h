/* SPDX-License-Identifier: MIT */
/*
 * Bitmap fonts made of scalable ones, by the library FreeType.
 */
#ifndef QTRI_HOST_ASSETS_TRUETYPE_H
#define QTRI_HOST_ASSETS_TRUETYPE_H

#include "../io/bdf.h"

struct truetype_wanted {
    int size;             /* pixels of an em, 4..127 */
    uint32_t first, last; /* characters; last 0: ASCII and Latin 1 */
};

/*
 * Draws those characters that the font has, in black and white. bdf_free() the font, or false with
 * *error set: not a font, none of the characters, glyphs beyond what a font holds, or the library
 * was not there when this was built.
 */
bool truetype_read(const char *path, const struct truetype_wanted *wanted, struct bdf_font *font,
                   struct text_error *error);

#endif
