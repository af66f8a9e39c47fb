/* SPDX-License-Identifier: MIT */
#include "bdf.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "file.h"
#include "lines.h"
#include "number.h"

#define MAX_CHARACTER 0x10FFFF
#define MAX_ARGUMENTS 4

struct parser {
    const char *name;
    struct text_error *error;
    struct bdf_font *font;
    size_t glyph_capacity, row_capacity;
    int line;
    char keyword[24];
    struct token argument[MAX_ARGUMENTS];
    int argument_count;
    int64_t default_character; /* -1: none */
    bool begun, ended, has_ascent, has_descent;
    bool in_glyph, has_encoding, has_advance, has_box;
    bool is_kept;  /* the glyph has a number */
    int rows_left; /* of BITMAP */
    int row_bytes;
    struct bdf_glyph glyph;
};

static bool fail(struct parser *p, const char *sentence)
{
    return text_error_set(p->error, p->name, p->line, "%s%s%s", p->keyword,
                          p->keyword[0] != '\0' ? ": " : "", sentence);
}

static bool integer(struct parser *p, int argument, int minimum, int maximum, int *value)
{
    int64_t parsed;
    char quoted[TOKEN_QUOTE_SIZE];
    if (argument >= p->argument_count) {
        return fail(p, "a number is missing");
    }
    const struct token *token = &p->argument[argument];
    if (number_parse_integer(token->text, token->length, minimum, maximum, &parsed) != NUMBER_OK) {
        return text_error_set(p->error, p->name, p->line,
                              "%s: '%s' is not a whole number in %d..%d", p->keyword,
                              token_quote(token, quoted), minimum, maximum);
    }
    *value = (int)parsed;
    return true;
}

/* ---- Rows of a glyph ---- */

static bool append(struct parser *p, uint8_t byte)
{
    struct bdf_font *font = p->font;
    if (font->row_bytes == UINT16_MAX) {
        return fail(p, "the font has more than 65535 bytes of rows");
    }
    uint8_t *added = array_add(&font->rows, &font->row_bytes, &p->row_capacity, 1);
    *added = byte;
    return true;
}

static int digit(char c)
{
    static const char digits[] = "0123456789abcdef";
    const char *at = strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c);
    return c == '\0' || at == NULL ? -1 : (int)(at - digits);
}

/* Two digits a byte; what lies behind the box's width is not part of it. */
static bool take_row(struct parser *p, const struct token *token)
{
    p->keyword[0] = '\0';
    if (token->length < 2 * (size_t)p->row_bytes || token->length % 2 != 0) {
        return fail(p, "a row of BITMAP has not the hexadecimal digits of its width");
    }
    for (size_t i = 0; i < token->length; i += 2) {
        const int high = digit(token->text[i]);
        const int low = digit(token->text[i + 1]);
        if (high < 0 || low < 0) {
            return fail(p, "a row of BITMAP is not hexadecimal");
        }
        const int end = 8 * ((int)(i / 2) + 1) - p->glyph.width;
        if (!p->is_kept || i / 2 >= (size_t)p->row_bytes) {
            continue;
        }
        const int unused = end > 0 ? end : 0;
        if (!append(p, (uint8_t)((high << 4 | low) >> unused << unused))) {
            return false;
        }
    }
    p->rows_left--;
    return true;
}

/* ---- Statements ---- */

static bool start_glyph(struct parser *p)
{
    if (p->in_glyph) {
        return fail(p, "the glyph before has no ENDCHAR");
    }
    memset(&p->glyph, 0, sizeof p->glyph);
    p->glyph.line = p->line;
    p->glyph.first = p->font->row_bytes;
    p->in_glyph = true;
    p->has_encoding = p->has_advance = p->has_box = false;
    return true;
}

static bool take_encoding(struct parser *p)
{
    int character;
    p->has_encoding = true;
    if (!integer(p, 0, -1, MAX_CHARACTER, &character)) {
        return false;
    }
    p->is_kept = character > 0;
    p->glyph.character = p->is_kept ? (uint32_t)character : 0;
    return true;
}

static bool take_box(struct parser *p)
{
    struct bdf_glyph *glyph = &p->glyph;
    int bottom;
    p->has_box = true;
    if (!integer(p, 0, 0, 255, &glyph->width) || !integer(p, 1, 0, 255, &glyph->height) ||
        !integer(p, 2, -128, 127, &glyph->left) || !integer(p, 3, -255, 127, &bottom)) {
        return false;
    }
    glyph->top = bottom + glyph->height;
    return (glyph->top >= -128 && glyph->top <= 127) ||
           fail(p, "the box reaches more than 127 pixels above or 128 below the baseline");
}

static bool begin_bitmap(struct parser *p)
{
    if (!p->has_encoding || !p->has_advance || !p->has_box) {
        return fail(p, "ENCODING, DWIDTH and BBX must come before it");
    }
    p->rows_left = p->glyph.height;
    p->row_bytes = (p->glyph.width + 7) / 8;
    if (p->row_bytes == 0) {
        p->rows_left = 0;
    }
    return true;
}

static bool end_glyph(struct parser *p)
{
    struct bdf_font *font = p->font;
    if (!p->has_encoding || !p->has_advance || !p->has_box) {
        return fail(p, "the glyph lacks ENCODING, DWIDTH or BBX");
    }
    p->in_glyph = false;
    if (!p->is_kept) {
        return true;
    }
    if (p->glyph.width == 0 || p->glyph.height == 0) {
        p->glyph.width = p->glyph.height = 0;
    }
    if (font->glyph_count == UINT16_MAX) {
        return fail(p, "the font has more than 65535 glyphs");
    }
    struct bdf_glyph *glyph =
        array_add(&font->glyphs, &font->glyph_count, &p->glyph_capacity, sizeof *glyph);
    *glyph = p->glyph;
    return true;
}

static bool take_default(struct parser *p)
{
    int character;
    if (!integer(p, 0, 0, MAX_CHARACTER, &character)) {
        return false;
    }
    p->default_character = character;
    return true;
}

static bool is(const struct parser *p, const char *keyword)
{
    return strcmp(p->keyword, keyword) == 0;
}

static bool glyph_statement(struct parser *p)
{
    if (is(p, "STARTCHAR")) {
        return start_glyph(p);
    }
    if (!p->in_glyph) {
        return !(is(p, "ENCODING") || is(p, "BBX") || is(p, "BITMAP") || is(p, "ENDCHAR")) ||
               fail(p, "stands outside of a glyph");
    }
    if (is(p, "ENCODING")) {
        return take_encoding(p);
    }
    if (is(p, "DWIDTH")) {
        p->has_advance = true;
        return integer(p, 0, 0, 255, &p->glyph.advance);
    }
    if (is(p, "BBX")) {
        return take_box(p);
    }
    if (is(p, "BITMAP")) {
        return begin_bitmap(p);
    }
    return !is(p, "ENDCHAR") || end_glyph(p);
}

/* What is not known is passed over, as the format wants it. */
static bool statement(struct parser *p)
{
    if (!p->begun) {
        p->begun = is(p, "STARTFONT");
        p->keyword[0] = '\0';
        return p->begun || fail(p, "is not a BDF font: STARTFONT must come first");
    }
    if (is(p, "FONT_ASCENT")) {
        p->has_ascent = true;
        return integer(p, 0, 0, 255, &p->font->ascent);
    }
    if (is(p, "FONT_DESCENT")) {
        p->has_descent = true;
        return integer(p, 0, 0, 255, &p->font->descent);
    }
    if (is(p, "DEFAULT_CHAR")) {
        return take_default(p);
    }
    if (is(p, "ENDFONT")) {
        p->ended = true;
        return !p->in_glyph || fail(p, "the last glyph has no ENDCHAR");
    }
    return glyph_statement(p);
}

static bool parse_line(struct parser *p, struct line *line)
{
    struct token token;
    p->line = line->number;
    if (p->ended || !line_token(line, &token)) {
        return true;
    }
    if (p->rows_left > 0) {
        return take_row(p, &token);
    }
    const size_t length = token.length < sizeof p->keyword - 1 ? token.length : 0;
    memcpy(p->keyword, token.text, length);
    p->keyword[length] = '\0';
    for (p->argument_count = 0; p->argument_count < MAX_ARGUMENTS; p->argument_count++) {
        if (!line_token(line, &p->argument[p->argument_count])) {
            break;
        }
    }
    return statement(p);
}

/* ---- The whole font ---- */

static int compare_glyphs(const void *a, const void *b)
{
    const struct bdf_glyph *x = a;
    const struct bdf_glyph *y = b;
    if (x->character != y->character) {
        return x->character < y->character ? -1 : 1;
    }
    return x->line < y->line ? -1 : x->line > y->line;
}

static bool find(const struct bdf_font *font, uint32_t character, size_t *glyph)
{
    for (size_t i = 0; i < font->glyph_count; i++) {
        if (font->glyphs[i].character == character) {
            *glyph = i;
            return true;
        }
    }
    return false;
}

const struct bdf_glyph *bdf_find(const struct bdf_font *font, uint32_t character)
{
    size_t glyph = font->missing;
    (void)find(font, character, &glyph);
    return &font->glyphs[glyph];
}

static bool finish(struct parser *p)
{
    struct bdf_font *font = p->font;
    p->keyword[0] = '\0';
    if (!p->ended) {
        return fail(p, p->begun ? "ENDFONT is missing: the file is cut off"
                                : "is not a BDF font: STARTFONT is missing");
    }
    if (!p->has_ascent || !p->has_descent) {
        return fail(p, "FONT_ASCENT or FONT_DESCENT is missing");
    }
    if (font->glyph_count == 0) {
        return fail(p, "the font has no glyphs");
    }
    qsort(font->glyphs, font->glyph_count, sizeof *font->glyphs, compare_glyphs);
    for (size_t i = 1; i < font->glyph_count; i++) {
        if (font->glyphs[i].character == font->glyphs[i - 1].character) {
            p->line = font->glyphs[i].line;
            return fail(p, "a second glyph for the same ENCODING");
        }
    }
    font->missing = 0;
    if (p->default_character < 0 || !find(font, (uint32_t)p->default_character, &font->missing)) {
        (void)(find(font, 0xFFFD, &font->missing) || find(font, '?', &font->missing));
    }
    return true;
}

bool bdf_parse(const char *name, const char *text, size_t length, struct bdf_font *font,
               struct text_error *error)
{
    struct parser p;
    struct line_reader reader;
    struct line line;
    memset(&p, 0, sizeof p);
    memset(font, 0, sizeof *font);
    p.name = name;
    p.error = error;
    p.font = font;
    p.default_character = -1;
    bool ok = true;
    lines_begin(&reader, text, length, false);
    while (ok && lines_next(&reader, &line)) {
        ok = parse_line(&p, &line);
    }
    ok = ok && finish(&p);
    if (!ok) {
        bdf_free(font);
    }
    return ok;
}

bool bdf_read(const char *path, struct bdf_font *font, struct text_error *error)
{
    struct file_content file;
    memset(font, 0, sizeof *font);
    if (!file_read(path, &file, error)) {
        return false;
    }
    bool ok = bdf_parse(path, file.bytes, file.length, font, error);
    free(file.bytes);
    return ok;
}

void bdf_free(struct bdf_font *font)
{
    free(font->glyphs);
    free(font->rows);
    memset(font, 0, sizeof *font);
}
