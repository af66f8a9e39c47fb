/* SPDX-License-Identifier: MIT */
/*
 * Text: glyphs against their bits, pens, UTF-8, and that the library's font is its BDF file.
 */
#include "support/core.h"

#include <qtri/paint.h>
#include <qtri/antialias.h>

#include "io/bdf.h"
#include "tools/font_build.h"

enum { WIDTH = 90, HEIGHT = 30 };

/* Three wide glyphs with bits of their own, one of them missing. */
static const uint8_t rows[] = {0xFF, 0x80, 0x81, 0x00, 0xA5, 0x80, 0x18, 0x3C, 0xFF, 0x40, 0x20};
static const qtri_glyph glyphs[] = {
    {0, 9, 3, -1, 2, 10}, {6, 8, 3, 2, 7, 9}, {0, 0, 0, 0, 0, 4}, {9, 3, 2, 0, -1, 4}};
static const qtri_glyph_range ranges[] = {{'A', 2, 0}, {0x20AC, 1, 2}};
static const qtri_font font = {rows, glyphs, ranges, 2, 3, 8, 3};

static void place(const qtri_surface *s, const qtri_glyph *g, int32_t pen, int32_t y,
                  uint8_t *model)
{
    for (int32_t j = 0; j < g->height; j++) {
        for (int32_t i = 0; i < g->width; i++) {
            const int32_t px = pen + g->left + i;
            const int32_t py = y - g->top + j;
            const uint8_t byte = font.rows[g->first + j * ((g->width + 7) / 8) + i / 8];
            if ((byte >> (7 - i % 8) & 1) != 0 && px >= 0 && px < s->width && py >= 0 &&
                py < s->height) {
                model[py * WIDTH + px] = 1;
            }
        }
    }
}

TEST(glyphs_and_pens)
{
    static const qtri_ink *const inks[] = {NULL, &qtri_ink_blend, &qtri_ink_smooth};
    static const uint8_t alphas[] = {255, 255, 128};
    uint64_t seed = 21;
    for (int n = 0; n < 900; n++) {
        uint8_t model[WIDTH * HEIGHT] = {0};
        canvas c = canvas_new(drawn_format(n), WIDTH, HEIGHT);
        canvas band = canvas_band(drawn_format(n), WIDTH, HEIGHT, random_in(&seed, 0, 20), 5);
        const qtri_rgb white = {255, 255, 255};
        const qtri_brush brush = {white, alphas[n / 6 % 3], inks[n / 6 % 3]};
        const int32_t x = random_in(&seed, -25, WIDTH);
        const int32_t y = random_in(&seed, -10, HEIGHT + 10);
        const char *text = "AB\xE2\x82\xAC"
                           "A?\nB";
        place(&c.surface, &glyphs[0], x, y, model);
        place(&c.surface, &glyphs[1], x + 10, y, model);
        place(&c.surface, &glyphs[0], x + 23, y, model);
        place(&c.surface, &glyphs[3], x + 33, y, model);
        place(&c.surface, &glyphs[1], x, y + 11, model);
        assert_int_equal(qtri_text_paint(&c.surface, &font, x, y, text, &brush), x + 9);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const bool is = stored_pixel(&c.surface, i % WIDTH, i / WIDTH) != 0;
            assert_int_equal(is, model[i]);
        }
        qtri_surface left = band.surface;
        qtri_surface right = band.surface;
        left.scissor.x1 = right.scissor.x0 = random_in(&seed, 0, WIDTH);
        qtri_text_paint(&left, &font, x, y, text, &brush);
        qtri_text_paint(&right, &font, x, y, text, &brush);
        assert_same_picture(&c.surface, &band.surface);
        canvas_free(&c);
        canvas_free(&band);
    }
    assert_int_equal(qtri_text_width(&font, "AB\nBBB\n"), 27);
    assert_int_equal(qtri_text_width(&font, ""), 0);
}

/*
 * A glyph of any width, clipped anywhere, mixed or not, in pixels of any size: each of its bits is
 * a pixel like that of a dot. Its rows end where their memory does, and have bits behind the last.
 */
TEST(clipped_glyphs)
{
    static const qtri_ink *const inks[] = {NULL, &qtri_ink_blend, &qtri_ink_smooth};
    static const uint8_t dot_rows[] = {0x80};
    static const qtri_glyph dot_glyph[] = {{0, 1, 1, 0, 0, 1}};
    static const qtri_glyph_range one[] = {{'A', 1, 0}};
    static const qtri_font dot = {dot_rows, dot_glyph, one, 1, 0, 1, 0};
    uint64_t seed = 22;
    for (int n = 0; n < 3000; n++) {
        const qtri_format *format = n % 7 == 6 ? &qtri_rgb565_x4 : drawn_format(n % 7);
        const qtri_brush brush = {{255, 255, 255}, n / 7 % 3 == 0 ? 255 : 130, inks[n / 7 % 3]};
        const int32_t width = random_in(&seed, 1, n % 2 == 0 ? 9 : 40);
        const int32_t height = random_in(&seed, 1, 3);
        const int32_t stride = (width + 7) / 8;
        uint8_t *bits = malloc((size_t)(height * stride));
        assert_non_null(bits);
        for (int32_t i = 0; i < height * stride; i++) {
            bits[i] = (uint8_t)random64(&seed);
        }
        const qtri_glyph glyph[] = {{0, (uint8_t)width, (uint8_t)height, 0, 0, 1}};
        const qtri_font wide = {bits, glyph, one, 1, 0, 1, 0};
        canvas c = canvas_new(format, 24, 5);
        qtri_text_paint(&c.surface, &dot, 0, 0, "A", &brush);
        const int32_t bytes = format->pixels->bytes;
        uint8_t painted[16], empty[16];
        memcpy(painted, c.surface.pixels, (size_t)bytes);
        canvas_clear(&c);
        memcpy(empty, c.surface.pixels, (size_t)bytes);
        assert_memory_not_equal(painted, empty, (size_t)bytes);
        qtri_rect scissor = {random_in(&seed, 0, 12), random_in(&seed, 0, 1),
                             random_in(&seed, 13, 24), random_in(&seed, 2, 5)};
        if (n % 5 == 0) {
            scissor = c.surface.scissor;
        }
        const int32_t x = random_in(&seed, -width, 24);
        const int32_t y = random_in(&seed, -height, 5);
        c.surface.scissor = scissor;
        qtri_text_paint(&c.surface, &wide, x, y, "A", &brush);
        for (int32_t i = 0; i < 24 * 5; i++) {
            const int32_t px = i % 24, py = i / 24, u = px - x, v = py - y;
            const bool inside = u >= 0 && u < width && v >= 0 && v < height && px >= scissor.x0 &&
                                px < scissor.x1 && py >= scissor.y0 && py < scissor.y1;
            const bool is = inside && (bits[v * stride + u / 8] >> (7 - u % 8) & 1) != 0;
            const uint8_t *at = c.surface.pixels + py * c.surface.pitch + px * bytes;
            assert_memory_equal(at, is ? painted : empty, (size_t)bytes);
        }
        canvas_free(&c);
        free(bits);
    }
}

TEST(far_away)
{
    static const int32_t places[] = {INT32_MIN, INT32_MIN + 3, -17000,
                                     17000,     INT32_MAX - 3, INT32_MAX};
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    const qtri_rgb white = {255, 255, 255};
    const qtri_brush brush = qtri_brush_of(white);
    for (size_t i = 0; i < LENGTH_OF(places); i++) {
        qtri_text_paint(&c.surface, &font, places[i], 10, "AAA\nB", &brush);
        qtri_text_paint(&c.surface, &font, 10, places[i], "AAA\nB", &brush);
    }
    assert_int_equal(qtri_text_paint(&c.surface, &font, INT32_MAX - 3, 10, "A", &brush), INT32_MAX);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        assert_int_equal(stored_pixel(&c.surface, i % WIDTH, i / WIDTH), 0);
    }
    canvas_free(&c);
}

TEST(utf8)
{
    for (uint32_t c = 1; c <= 0x10FFFF; c += c < 0x3000 ? 1 : 37) {
        char text[5] = {0};
        if (c < 0x80) {
            text[0] = (char)c;
        } else if (c < 0x800) {
            text[0] = (char)(0xC0 | c >> 6);
            text[1] = (char)(0x80 | (c & 63));
        } else if (c < 0x10000) {
            text[0] = (char)(0xE0 | c >> 12);
            text[1] = (char)(0x80 | (c >> 6 & 63));
            text[2] = (char)(0x80 | (c & 63));
        } else {
            text[0] = (char)(0xF0 | c >> 18);
            text[1] = (char)(0x80 | (c >> 12 & 63));
            text[2] = (char)(0x80 | (c >> 6 & 63));
            text[3] = (char)(0x80 | (c & 63));
        }
        const char *at = text;
        const bool is_surrogate = c >= 0xD800 && c <= 0xDFFF;
        assert_int_equal(qtri_text_next(&at), is_surrogate ? 0xFFFD : c);
        assert_ptr_equal(at, text + (is_surrogate ? 1 : strlen(text)));
    }
    static const char *const wrong[] = {"\x80",
                                        "\xC0\x80",
                                        "\xC1\xBF",
                                        "\xE0\x9F\xBF",
                                        "\xF0\x8F\xBF\xBF",
                                        "\xF4\x90\x80\x80",
                                        "\xFF",
                                        "\xE2\x82",
                                        "\xF8\x88\x80\x80\x80",
                                        "\xC3(",
                                        "\xBF"};
    for (size_t i = 0; i < LENGTH_OF(wrong); i++) {
        const char *at = wrong[i];
        assert_int_equal(qtri_text_next(&at), 0xFFFD);
        assert_ptr_equal(at, wrong[i] + 1);
    }
    const char *end = "";
    assert_int_equal(qtri_text_next(&end), 0);
    assert_int_equal(*end, 0);
}

/* core/paint/font_small.c is what `qtri font` makes of its source. */
TEST(small_font)
{
    struct bdf_font bdf;
    struct font_build build;
    struct text_error error;
    if (!bdf_read("host/fonts/small.bdf", &bdf, &error)) {
        print_message("skipped: run from the project's folder: %s\n", error.message);
        skip();
    }
    font_build_create(&build, &bdf);
    const qtri_font *is = &qtri_font_small;
    assert_int_equal(is->range_count, build.font.range_count);
    assert_int_equal(is->missing, build.font.missing);
    assert_int_equal(is->ascent, build.font.ascent);
    assert_int_equal(is->descent, build.font.descent);
    assert_memory_equal(is->rows, bdf.rows, bdf.row_bytes);
    assert_memory_equal(is->glyphs, build.glyphs, build.glyph_count * sizeof *build.glyphs);
    assert_memory_equal(is->ranges, build.ranges, build.font.range_count * sizeof *build.ranges);
    for (uint32_t c = ' '; c <= '~'; c++) {
        assert_true(qtri_font_glyph(is, c) != &is->glyphs[is->missing]);
    }
    assert_ptr_equal(qtri_font_glyph(is, 0x263A), &is->glyphs[is->missing]);
    font_build_free(&build);
    bdf_free(&bdf);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
