/* SPDX-License-Identifier: MIT */
#include "font_build.h"

#include <stdlib.h>
#include <string.h>

#include "../io/xalloc.h"

static void copy_glyph(qtri_glyph *to, const struct bdf_glyph *from)
{
    to->first = (uint16_t)from->first;
    to->width = (uint8_t)from->width;
    to->height = (uint8_t)from->height;
    to->left = (int8_t)from->left;
    to->top = (int8_t)from->top;
    to->advance = (uint8_t)from->advance;
}

void font_build_create(struct font_build *build, const struct bdf_font *bdf)
{
    memset(build, 0, sizeof *build);
    build->glyphs = xcalloc(bdf->glyph_count, sizeof *build->glyphs);
    build->ranges = xcalloc(bdf->glyph_count, sizeof *build->ranges);
    build->glyph_count = bdf->glyph_count;
    size_t count = 0;
    for (size_t i = 0; i < bdf->glyph_count; i++) {
        const struct bdf_glyph *glyph = &bdf->glyphs[i];
        copy_glyph(&build->glyphs[i], glyph);
        if (i == 0 || glyph->character != bdf->glyphs[i - 1].character + 1) {
            build->ranges[count].first = glyph->character;
            build->ranges[count].glyph = (uint16_t)i;
            count++;
        }
        build->ranges[count - 1].count++;
    }
    build->font.rows = bdf->rows;
    build->font.glyphs = build->glyphs;
    build->font.ranges = build->ranges;
    build->font.range_count = (uint16_t)count;
    build->font.missing = (uint16_t)bdf->missing;
    build->font.ascent = (uint8_t)bdf->ascent;
    build->font.descent = (uint8_t)bdf->descent;
}

void font_build_free(struct font_build *build)
{
    free(build->glyphs);
    free(build->ranges);
    memset(build, 0, sizeof *build);
}
