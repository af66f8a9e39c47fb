/* SPDX-License-Identifier: MIT */
/*
 * BDF files: what is read, and a message with the line for what is wrong.
 */
#define _POSIX_C_SOURCE 200809L

#include "support/io.h"

#include "io/bdf.h"

#define HEAD "STARTFONT 2.1\nFONT_ASCENT 8\nFONT_DESCENT 2\n"
#define GLYPH(code, box, rows)                                                                     \
    "STARTCHAR x\nENCODING " code "\nDWIDTH 6 0\nBBX " box "\nBITMAP\n" rows "ENDCHAR\n"
#define TAIL "ENDFONT\n"

static struct bdf_font font;
static struct text_error error;

static bool parse(const char *text)
{
    char *copy = exact_copy(text, strlen(text));
    bool ok = bdf_parse("f.bdf", copy, strlen(text), &font, &error);
    free(copy);
    return ok;
}

TEST(reads)
{
    assert_true(parse(HEAD "DEFAULT_CHAR 66\n" GLYPH("66", "9 2 -1 -2", "FFFF\n80ab\n")
                          GLYPH("-1", "8 1 0 0", "FF\n") GLYPH("65", "3 1 1 4", "FF\n")
                              GLYPH("32", "0 0 0 0", "") TAIL "ENCODING nonsense behind the end"));
    assert_int_equal(font.glyph_count, 3);
    assert_int_equal(font.ascent, 8);
    assert_int_equal(font.descent, 2);
    assert_int_equal(font.missing, 2);
    const struct bdf_glyph *b = bdf_find(&font, 66);
    assert_int_equal(b->width, 9);
    assert_int_equal(b->height, 2);
    assert_int_equal(b->left, -1);
    assert_int_equal(b->top, 0);
    assert_int_equal(b->advance, 6);
    static const uint8_t rows[4] = {0xFF, 0x80, 0x80, 0x80}; /* nothing behind column 9 */
    assert_memory_equal(font.rows + b->first, rows, 4);
    assert_int_equal(font.rows[bdf_find(&font, 65)->first], 0xE0);
    assert_ptr_equal(bdf_find(&font, 'z'), b);
    bdf_free(&font);
}

TEST(refuses)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        {"", "f.bdf"},
        {"hello\n", "f.bdf:1: is not a BDF font"},
        {HEAD GLYPH("65", "3 1 0 0", "FF\n"), "cut off"},
        {"STARTFONT 2.1\n" GLYPH("65", "3 1 0 0", "FF\n") TAIL, "FONT_ASCENT"},
        {HEAD TAIL, "no glyphs"},
        {HEAD GLYPH("65", "300 1 0 0", "FF\n") TAIL, "f.bdf:7: BBX: '300' is not a whole number"},
        {HEAD GLYPH("65", "3 1 0", "FF\n") TAIL, "f.bdf:7: BBX: a number is missing"},
        {HEAD GLYPH("65", "8 100 0 100", "FF\n") TAIL, "f.bdf:7: BBX: the box reaches"},
        {HEAD GLYPH("1114112", "3 1 0 0", "FF\n") TAIL, "f.bdf:5: ENCODING"},
        {HEAD GLYPH("65", "9 1 0 0", "FF\n") TAIL, "f.bdf:9: a row of BITMAP"},
        {HEAD GLYPH("65", "3 2 0 0", "FF\n") TAIL, "f.bdf:10: a row of BITMAP"},
        {HEAD GLYPH("65", "3 1 0 0", "FG\n") TAIL, "f.bdf:9: a row of BITMAP is not hexadecimal"},
        {HEAD GLYPH("65", "3 1 0 0", "FF\n") GLYPH("65", "3 1 0 0", "FF\n") TAIL,
         "f.bdf:11: a second glyph"},
        {HEAD "ENCODING 5\n" TAIL, "f.bdf:4: ENCODING: stands outside"},
        {HEAD "STARTCHAR a\nSTARTCHAR b\n" TAIL, "f.bdf:5: STARTCHAR: the glyph before"},
        {HEAD "STARTCHAR a\nENDCHAR\n" TAIL, "f.bdf:5: ENDCHAR: the glyph lacks"},
        {HEAD "STARTCHAR a\nBITMAP\n" TAIL, "f.bdf:5: BITMAP: ENCODING"},
        {HEAD "STARTCHAR a\n" TAIL, "f.bdf:5: ENDFONT: the last glyph"},
    };
    for (size_t i = 0; i < ARRAY_LENGTH(cases); i++) {
        assert_false(parse(cases[i].text));
        if (strstr(error.message, cases[i].message) == NULL) {
            fail_msg("case %d: \"%s\", not \"%s\"", (int)i, error.message, cases[i].message);
        }
        assert_null(font.glyphs);
        assert_null(font.rows);
    }
    assert_false(bdf_read("/nonexistent/f.bdf", &font, &error));
}

/* Every prefix, and every byte exchanged for some others: read or refused, never more. */
TEST(damaged)
{
    static const char text[] = HEAD "DEFAULT_CHAR 66\n" GLYPH("66", "9 2 -1 -2", "FFFF\n80ab\n")
        GLYPH("65", "3 1 1 4", "FF\n") TAIL;
    for (size_t length = 0; length < sizeof text; length++) {
        char *copy = exact_copy(text, length);
        if (bdf_parse("f.bdf", copy, length, &font, &error)) {
            bdf_free(&font);
        }
        free(copy);
    }
    static const char other[] = {'\0', '\n', ' ', '-', '0', '9', 'F', 'z', (char)0xFF};
    for (size_t i = 0; i + 1 < sizeof text; i++) {
        for (size_t k = 0; k < sizeof other; k++) {
            char *copy = exact_copy(text, sizeof text - 1);
            copy[i] = other[k];
            if (bdf_parse("f.bdf", copy, sizeof text - 1, &font, &error)) {
                bdf_free(&font);
            }
            free(copy);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
