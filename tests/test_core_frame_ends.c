/* SPDX-License-Identifier: MIT */
/*
 * Bands, dithering and filters where there is nothing to do, or no room to do it.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "frame/pixel.h"

#include <qtri/dither.h>
#include <qtri/antialias.h>
#include <qtri/frame.h>

enum { WIDTH = 24, HEIGHT = 20 };

static const qtri_rgb sky = {40, 80, 160}, red = {250, 10, 30};

TEST(overlap_that_does_not_fit)
{
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, 4 + 2 * 2, QTRI_RGB565_BYTES)];
    static const struct {
        int32_t rows, overlap;
        enum qtri_error error;
    } tries[] = {{4, 2, QTRI_OK},
                 {4, -1, QTRI_ERROR_SIZE},
                 {4, QTRI_OVERLAP_MAX + 1, QTRI_ERROR_SIZE},
                 {0, 2, QTRI_ERROR_SIZE},
                 {INT32_MIN, 2, QTRI_ERROR_SIZE},
                 {QTRI_SURFACE_MAX - 3, 2, QTRI_ERROR_MEMORY},
                 {QTRI_SURFACE_MAX - 4, 2, QTRI_ERROR_MEMORY},
                 {QTRI_SURFACE_MAX, 0, QTRI_ERROR_MEMORY},
                 {QTRI_SURFACE_MAX + 1, 0, QTRI_ERROR_SIZE},
                 {INT32_MAX, 2, QTRI_ERROR_SIZE},
                 {5, 2, QTRI_ERROR_MEMORY}};
    for (size_t i = 0; i < LENGTH_OF(tries); i++) {
        qtri_frame frame;
        qtri_surface band;
        qtri_surface shown;
        memset(&frame, 0x5A, sizeof frame);
        assert_int_equal(frame_with_overlap(&frame, &qtri_rgb565, WIDTH, HEIGHT, tries[i].rows,
                                            tries[i].overlap, memory, sizeof memory),
                         tries[i].error);
        int bands = 0;
        while (next_shown(&frame, &band, &shown)) {
            bands++;
        }
        assert_int_equal(bands, i == 0 ? HEIGHT / 4 : 0);
    }
}

/* What a frame cannot have leaves it without bands, and so does what is asked of such a frame. */
TEST(refused_frames_have_no_bands)
{
    static uint8_t memory[QTRI_FRAME_BYTES(1, QTRI_SURFACE_MAX, QTRI_RGB565_BYTES)];
    for (int32_t spare = 3; spare <= 4; spare++) {
        qtri_frame frame;
        assert_ok(qtri_frame_init(&frame, &qtri_rgb565, 1, HEIGHT, QTRI_SURFACE_MAX - spare, memory,
                                  sizeof memory));
        assert_int_equal(qtri_frame_set_overlap(&frame, 2, NULL, 0),
                         spare == 4 ? QTRI_OK : QTRI_ERROR_SIZE);
        assert_int_equal(frame.height, spare == 4 ? HEIGHT : 0);
    }
    for (int asks = 0; asks < 3; asks++) {
        qtri_frame frame;
        qtri_surface band;
        const enum qtri_error begun = qtri_frame_init(&frame, &qtri_xrgb8888_x4, 2, HEIGHT,
                                                      asks == 0 ? 0 : 4, memory, sizeof memory);
        assert_int_equal(begun, asks == 0 ? QTRI_ERROR_SIZE : QTRI_OK);
        if (asks == 0) {
            assert_int_equal(qtri_frame_set_overlap(&frame, 0, NULL, 0), QTRI_ERROR_SIZE);
        }
        if (asks == 1) { /* records of samples have linear16 alone */
            assert_int_equal(qtri_frame_set_depth(&frame, &qtri_depth_float16), QTRI_ERROR_FORMAT);
        }
        assert_int_equal(qtri_frame_next_band(&frame, &band), asks == 2);
    }
}

/* Rows that are kept are needed by the next band: all come, and whole. */
TEST(nothing_is_left_out_where_rows_are_kept)
{
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, 4 + 2, QTRI_RGB565_BYTES)];
    static uint8_t kept[QTRI_FRAME_KEPT_BYTES(WIDTH, 1, QTRI_RGB565_BYTES)];
    const qtri_rect change = {3, 9, 5, 10};
    qtri_frame frame;
    qtri_surface band, shown;
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565, WIDTH, HEIGHT, 4, memory, sizeof memory));
    assert_ok(qtri_frame_set_overlap(&frame, 1, kept, sizeof kept));
    memset(&band, 0x5A, sizeof band);
    qtri_frame_shown(&frame, &band, &shown); /* no band was taken: it is what is given */
    assert_memory_equal(&shown, &band, sizeof band);
    for (int pass = 0; pass < 2; pass++) {
        int32_t rows = 0;
        if (pass == 1) {
            qtri_frame_mark(&frame, &change);
            qtri_frame_only_changes(&frame);
        }
        while (qtri_frame_next_band(&frame, &band)) {
            static uint8_t before[sizeof memory];
            qtri_surface_clear(&band, rows % 8 == 0 ? sky : red);
            qtri_frame_join(&frame, &band);
            const qtri_surface joined = band;
            memcpy(before, memory, sizeof memory);
            qtri_frame_join(&frame, &band); /* once more: that changes nothing */
            assert_memory_equal(&joined, &band, sizeof band);
            assert_memory_equal(memory, before, sizeof memory);
            qtri_frame_shown(&frame, &band, &shown);
            assert_int_equal(shown.first_row, rows);
            assert_int_equal(shown.scissor.y1 - shown.scissor.y0, HEIGHT);
            assert_int_equal(shown.scissor.x1 - shown.scissor.x0, WIDTH);
            rows += shown.rows;
        }
        assert_int_equal(rows, HEIGHT);
    }
}

/* Marks without an inside change nothing; without a change there is no band. */
TEST(changes_of_nothing)
{
    static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, 4 + 2 * 2, QTRI_RGB565_BYTES)];
    static const qtri_rect empty[] = {{3, 3, 3, 9}, {3, 3, 9, 3},   {9, 3, 3, 9},
                                      {3, 9, 9, 3}, {30, 3, 40, 9}, {3, -9, 9, -2}};
    qtri_frame frame;
    qtri_surface band;
    qtri_surface shown;
    assert_ok(frame_with_overlap(&frame, &qtri_rgb565, WIDTH, HEIGHT, 4, 2, memory, sizeof memory));
    while (next_shown(&frame, &band, &shown)) {
    }
    for (size_t i = 0; i < LENGTH_OF(empty); i++) {
        qtri_frame_mark(&frame, &empty[i]);
        qtri_frame_only_changes(&frame);
        assert_false(next_shown(&frame, &band, &shown));
        const qtri_rect changes = qtri_frame_changes(&frame);
        assert_true(changes.x0 >= changes.x1 || changes.y0 >= changes.y1);
    }
}

static void fill_gray(uint8_t gray[WIDTH], uint64_t *seed)
{
    for (int i = 0; i < WIDTH; i++) {
        gray[i] = (uint8_t)random64(seed);
    }
}

/* The last row that there can be is a row. */
TEST(diffusion_at_the_last_row)
{
    uint64_t seed = 6;
    int16_t errors[2][WIDTH];
    qtri_diffusion d[2];
    for (int i = 0; i < 2; i++) {
        assert_ok(qtri_diffusion_init(&d[i], WIDTH, errors[i], WIDTH));
    }
    for (int32_t row = 0; row < 4; row++) {
        uint8_t gray[WIDTH];
        uint8_t level[2][WIDTH];
        fill_gray(gray, &seed);
        qtri_diffuse_row(&d[0], 1, 0, 100 + row, gray, WIDTH, level[0]);
        qtri_diffuse_row(&d[1], 1, 0, INT32_MAX - 3 + row, gray, WIDTH, level[1]);
        assert_memory_equal(level[0], level[1], WIDTH);
    }
    assert_int_equal(d[1].next_y, INT32_MAX);
}

/* Displays that show nothing keep all of what they should have shown: it is held, and no more. */
TEST(errors_are_held)
{
    for (int sign = 0; sign < 2; sign++) {
        int16_t errors[WIDTH];
        qtri_diffusion d;
        assert_ok(qtri_diffusion_init(&d, WIDTH, errors, WIDTH));
        for (int32_t y = 0; y < 60; y++) {
            const bool ends = y >= 30;
            for (int32_t x = 0; x < WIDTH; x++) { /* half of a level, so that all go one way */
                const int32_t due =
                    (sign ? 128 : 127) - d.right - (x == 0 && y == 0 ? 0 : errors[x]);
                const uint8_t gray = (uint8_t)(due < 0 ? 0 : (due > 255 ? 255 : due));
                uint8_t level;
                qtri_diffuse_row(&d, ends ? 0 : 1, x, y, &gray, 1, &level);
                assert_in_range(level, 0, ends ? 0 : 1);
                assert_in_range(d.right + 1000, 1000 - 112, 1000 + 112); /* 7/16 of 255 */
            }
        }
        int32_t sum = 0;
        for (int32_t x = 0; x < WIDTH; x++) {
            sum += errors[x];
        }
        assert_true(sign ? sum < -400 : sum > 400);
    }
}

/* ---- Filters ---- */

static void paint_test(const qtri_surface *s)
{
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            qtri_surface pixel = *s;
            pixel.scissor = (qtri_rect){x, y, x + 1, y + 1};
            clear_to(&pixel, (x * 5 + y * 3) % 7 < 3 ? sky : red, 9);
        }
    }
}

static const qtri_format *const of[2] = {&qtri_xrgb8888, &qtri_rgb565};

/* All filters of a format: the sum of what they return. */
static int filter_all(const qtri_surface *s, uint32_t *words, uint32_t count)
{
    int errors = 0;
    errors |= qtri_fxaa(s, words, count);
    errors |= qtri_sum_add(words, count, s);
    errors |= qtri_sum_store(s, words, count, 0);
    return errors;
}

/* A scissor without pixels needs no memory, and leaves all as it is. */
TEST(nothing_to_filter)
{
    static const qtri_rect empty[3] = {{5, 5, 5, 9}, {5, 9, 9, 9}, {40, 0, 50, 9}};
    for (int f = 0; f < 2; f++) {
        canvas c = canvas_new(of[f], WIDTH, HEIGHT);
        canvas same = canvas_new(of[f], WIDTH, HEIGHT);
        paint_test(&c.surface);
        paint_test(&same.surface);
        for (int i = 0; i < 3; i++) {
            qtri_edges edges;
            c.surface.scissor = empty[i];
            assert_ok(filter_all(&c.surface, NULL, 0));
            uint32_t word = 0;
            assert_ok(qtri_edges_begin(&edges, &c.surface, &word, 1));
            qtri_edges_blend(&edges);
        }
        c.surface.scissor = same.surface.scissor;
        assert_same_picture(&same.surface, &c.surface);
        canvas_free(&c);
        canvas_free(&same);
    }
}

TEST(too_little_memory_changes_nothing)
{
    static uint32_t words[QTRI_SUM_WORDS(WIDTH, HEIGHT)];
    for (int f = 0; f < 2; f++) {
        canvas c = canvas_new(of[f], WIDTH, HEIGHT);
        canvas same = canvas_new(of[f], WIDTH, HEIGHT);
        paint_test(&c.surface);
        paint_test(&same.surface);
        memset(words, 0, sizeof words);
        const bool is_565 = of[f] == &qtri_rgb565;
        const uint32_t few =
            (is_565 ? QTRI_SUM_565_WORDS(WIDTH, HEIGHT) : QTRI_SUM_WORDS(WIDTH, HEIGHT)) - 1;
        const uint32_t rows = is_565 ? QTRI_FXAA_565_WORDS(WIDTH) : QTRI_FXAA_WORDS(WIDTH);
        assert_int_equal(qtri_sum_add(words, few, &c.surface), QTRI_ERROR_MEMORY);
        assert_int_equal(qtri_sum_store(&c.surface, words, few, 3), QTRI_ERROR_MEMORY);
        assert_int_equal(qtri_fxaa(&c.surface, words, rows - 1), QTRI_ERROR_MEMORY);
        for (size_t i = 0; i < LENGTH_OF(words); i++) {
            assert_int_equal(words[i], 0);
        }
        assert_same_picture(&same.surface, &c.surface);
        canvas_free(&c);
        canvas_free(&same);
    }
}

/* Rows that do not begin at words, and bands of odd size. */
TEST(halves_of_odd_memory)
{
    static uint32_t memory[2][(WIDTH + 3) * HEIGHT];
    qtri_surface half[2];
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    paint_test(&c.surface);
    for (int i = 0; i < 2; i++) { /* in words and beside them; pairs of one colour and of two */
        qtri_surface s = c.surface;
        s.pixels = (uint8_t *)memory[i] + 2 * i;
        s.pitch = i == 0 ? 2 * WIDTH : 2 * WIDTH + 2;
        s.depth = NULL;
        for (int32_t y = 0; y < HEIGHT; y++) {
            memcpy(s.pixels + y * s.pitch, c.surface.pixels + (y | 1) * c.surface.pitch, 2 * WIDTH);
            for (int32_t x = 0; x < 8; x++) { /* the same two colours in all four words */
                const uint16_t pair[2] = {0x1234, 0xF0F1};
                memcpy(s.pixels + y * s.pitch + 2 * x, &pair[x & 1], 2);
            }
        }
        assert_ok(qtri_halve(&s, &half[i]));
    }
    for (int32_t y = 0; y < HEIGHT / 2; y++) {
        for (int32_t x = 0; x < WIDTH / 2; x++) {
            assert_int_equal(stored_pixel(&half[0], x, y), stored_pixel(&half[1], x, y));
        }
    }
    for (int32_t odd = 0; odd < 4; odd++) {
        qtri_surface s = c.surface;
        qtri_surface before = half[0];
        s.width += odd == 0;
        s.height += odd == 1;
        s.first_row += odd == 2;
        s.rows -= odd == 3;
        assert_int_equal(qtri_halve(&s, &half[0]), QTRI_ERROR_SIZE);
        assert_memory_equal(&before, &half[0], sizeof before);
    }
    canvas_free(&c);
}

/* Rows of an odd number of pixels that begin at words: the pixels of a blend of any format. */
static void encode_any(uint32_t *color, int32_t count)
{
    (void)color;
    (void)count;
}

static const qtri_format any_565 = {.pixels = &qtri_pixels_16,
                                    .colors = &qtri_colors_565,
                                    .encode = encode_any,
                                    .decode = qtri_decode_rgb565};

TEST(fxaa_of_odd_rows)
{
    static uint32_t words[QTRI_FXAA_WORDS(WIDTH)];
    canvas c[2] = {canvas_new(&qtri_rgb565, WIDTH, HEIGHT),
                   canvas_new(&qtri_rgb565, WIDTH, HEIGHT)};
    for (int i = 0; i < 2; i++) {
        paint_test(&c[i].surface);
        qtri_surface odd = c[i].surface;
        odd.width--;
        odd.scissor.x1--;
        odd.format = i == 0 ? &any_565 : &qtri_rgb565;
        assert_ok(qtri_fxaa(&odd, words, LENGTH_OF(words)));
    }
    assert_same_picture(&c[0].surface, &c[1].surface);
    canvas_free(&c[0]);
    canvas_free(&c[1]);
}

/* Pixels of five bytes, whose contract has 1 to 32 of them in a call. */
static void fill_40(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count)
{
    assert_true(count >= 1 && count <= 32);
    assert_int_equal(mask << (32 - count) >> (32 - count), UINT32_MAX >> (32 - count));
    for (; count > 0; count--, pixel += 5) {
        assert_int_equal(pixel[0], 0); /* each is filled once */
        memset(pixel, (int)stored, 5);
    }
}

TEST(pixels_of_any_size_are_filled)
{
    enum { MOST = 100 };
    static const qtri_pixels pixels = {5, NULL, fill_40, NULL};
    qtri_format format = qtri_rgb565;
    format.pixels = &pixels;
    static uint8_t memory[2][5 * (MOST + 2)];
    for (int32_t columns = 0; columns <= MOST; columns++) {
        memset(memory, 0, sizeof memory);
        const qtri_surface surface = {.format = &format,
                                      .pixels = memory[0],
                                      .pitch = (ptrdiff_t)sizeof memory[0],
                                      .width = MOST + 2,
                                      .height = 2,
                                      .rows = 2};
        const qtri_rect rect = {1, 0, 1 + columns, 2};
        qtri_fill_rect(&surface, &rect, 0xA5);
        for (int32_t at = 0; at < 5 * (MOST + 2); at++) {
            const bool inside = at >= 5 && at < 5 * (1 + columns);
            assert_int_equal(memory[0][at], inside ? 0xA5 : 0);
            assert_int_equal(memory[1][at], inside ? 0xA5 : 0);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
