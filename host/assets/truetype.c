/* SPDX-License-Identifier: MIT */
#include "truetype.h"

#include <stdlib.h>
#include <string.h>

#ifndef QTRI_HAVE_FREETYPE

bool truetype_read(const char *path, const struct truetype_wanted *wanted, struct bdf_font *font,
                   struct text_error *error)
{
    (void)wanted;
    memset(font, 0, sizeof *font);
    return text_error_set(error, path, 0,
                          "this qtri was built without libfreetype and reads BDF alone");
}

#else

#include <ft2build.h>
#include FT_FREETYPE_H

#include "../io/file.h"

enum { MOST_GLYPHS = 65535, MOST_BYTES = 65535 };

static bool fits(const struct bdf_glyph *glyph)
{
    return glyph->width <= 255 && glyph->height <= 255 && glyph->left >= -128 &&
           glyph->left <= 127 && glyph->top >= -128 && glyph->top <= 127 && glyph->advance >= 0 &&
           glyph->advance <= 255;
}

/* Appends the rows of a bitmap of one bit a pixel. */
static bool add_rows(struct bdf_font *font, const FT_Bitmap *bitmap)
{
    const size_t row = ((size_t)bitmap->width + 7) / 8;
    uint8_t *rows = realloc(font->rows, font->row_bytes + row * bitmap->rows + 1);
    if (rows == NULL) {
        return false;
    }
    font->rows = rows;
    for (unsigned i = 0; i < bitmap->rows; i++) {
        memcpy(rows + font->row_bytes, bitmap->buffer + (ptrdiff_t)i * bitmap->pitch, row);
        if (bitmap->width % 8 != 0) { /* 0 behind the last pixel */
            rows[font->row_bytes + row - 1] &= (uint8_t)(0xFF00 >> bitmap->width % 8);
        }
        font->row_bytes += row;
    }
    return true;
}

/* A character that the font has not is passed over. */
static bool add_glyph(FT_Face face, uint32_t character, struct bdf_font *font, const char *path,
                      struct text_error *error)
{
    const FT_UInt index = FT_Get_Char_Index(face, character);
    const FT_GlyphSlot slot = face->glyph;
    if (index == 0) {
        return true;
    }
    if (FT_Load_Glyph(face, index, FT_LOAD_RENDER | FT_LOAD_TARGET_MONO) != 0) {
        return text_error_set(error, path, 0, "has a glyph that cannot be drawn");
    }
    const struct bdf_glyph glyph = {.character = character,
                                    .width = (int)slot->bitmap.width,
                                    .height = (int)slot->bitmap.rows,
                                    .left = slot->bitmap_left,
                                    .top = slot->bitmap_top,
                                    .advance = (int)((slot->advance.x + 32) >> 6),
                                    .first = font->row_bytes};
    struct bdf_glyph *glyphs =
        realloc(font->glyphs, (font->glyph_count + 1) * sizeof *font->glyphs);
    if (glyphs == NULL) {
        return text_error_set(error, path, 0, "out of memory");
    }
    font->glyphs = glyphs;
    glyphs[font->glyph_count++] = glyph;
    if (!add_rows(font, &slot->bitmap)) {
        return text_error_set(error, path, 0, "out of memory");
    }
    if (!fits(&glyph) || font->row_bytes > MOST_BYTES || font->glyph_count > MOST_GLYPHS) {
        return text_error_set(error, path, 0,
                              "its glyphs take more than 65535 bytes, or one is larger than a "
                              "font holds: a smaller --size or --range does");
    }
    return true;
}

static bool add_range(FT_Face face, uint32_t first, uint32_t last, struct bdf_font *font,
                      const char *path, struct text_error *error)
{
    bool ok = true;
    for (uint32_t i = first; ok && i <= last; i++) {
        ok = add_glyph(face, i, font, path, error);
    }
    return ok;
}

static void set_missing(struct bdf_font *font)
{
    const uint32_t wanted[2] = {'?', 0xFFFD};
    for (size_t i = 0; i < 2; i++) {
        for (size_t j = 0; j < font->glyph_count; j++) {
            font->missing = font->glyphs[j].character == wanted[i] ? j : font->missing;
        }
    }
}

/* Of a face of the wanted size. */
static bool draw(FT_Face face, const struct truetype_wanted *wanted, struct bdf_font *font,
                 const char *path, struct text_error *error)
{
    const FT_Size_Metrics *metrics = &face->size->metrics;
    const long ascent = (metrics->ascender + 63) >> 6, descent = (63 - metrics->descender) >> 6;
    font->ascent = (int)(ascent < 0 ? 0 : ascent > 255 ? 255 : ascent);
    font->descent = (int)(descent < 0 ? 0 : descent > 255 ? 255 : descent);
    const bool ok = wanted->last > 0
                        ? add_range(face, wanted->first, wanted->last, font, path, error)
                        : add_range(face, 0x20, 0x7E, font, path, error) &&
                              add_range(face, 0xA0, 0xFF, font, path, error);
    set_missing(font);
    return ok && (font->glyph_count > 0 ||
                  text_error_set(error, path, 0, "has none of these characters"));
}

static bool read_face(FT_Library library, const struct file_content *file,
                      const struct truetype_wanted *wanted, struct bdf_font *font, const char *path,
                      struct text_error *error)
{
    FT_Face face;
    if (FT_New_Memory_Face(library, (const FT_Byte *)file->bytes, (FT_Long)file->length, 0,
                           &face) != 0) {
        return text_error_set(error, path, 0, "is not a font that FreeType knows, or incomplete");
    }
    const bool ok = FT_Set_Pixel_Sizes(face, 0, (FT_UInt)wanted->size) == 0
                        ? draw(face, wanted, font, path, error)
                        : text_error_set(error, path, 0, "cannot be drawn at this --size");
    (void)FT_Done_Face(face);
    return ok;
}

bool truetype_read(const char *path, const struct truetype_wanted *wanted, struct bdf_font *font,
                   struct text_error *error)
{
    FT_Library library;
    struct file_content file;
    memset(font, 0, sizeof *font);
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = FT_Init_FreeType(&library) == 0;
    if (!ok) {
        (void)text_error_set(error, path, 0, "out of memory");
    } else {
        ok = read_face(library, &file, wanted, font, path, error);
        (void)FT_Done_FreeType(library);
    }
    free(file.bytes);
    if (!ok) {
        bdf_free(font);
    }
    return ok;
}

#endif
