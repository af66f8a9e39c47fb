/* SPDX-License-Identifier: MIT */
/*
 * Fonts as the core has them, from BDF files.
 */
#ifndef QTRI_HOST_TOOLS_FONT_BUILD_H
#define QTRI_HOST_TOOLS_FONT_BUILD_H

#include <stdbool.h>

#include <qtri.h>

#include "../io/bdf.h"

struct font_build {
    qtri_font font;
    qtri_glyph *glyphs;
    qtri_glyph_range *ranges;
    size_t glyph_count;
};

/* The bytes of rows stay the BDF font's, which must outlive this. */
void font_build_create(struct font_build *build, const struct bdf_font *bdf);
void font_build_free(struct font_build *build);

#endif
