/* SPDX-License-Identifier: MIT */
/*
 * Surfaces: what they accept, what lies inside; clearing exactly the rectangle, whatever the
 * format, the alignment and the pitch.
 */
#include "support/core.h"

enum { SIDE = 90, MARGIN = 70, BYTES = SIDE * (SIDE + 9) * 4 + 2 * MARGIN };

static const qtri_rgb color = {200, 100, 50};

static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_rgb888,
                                             &qtri_bgr888, &qtri_xrgb8888,       &qtri_gray8};

static uint32_t expected_pixel(const qtri_format *format)
{
    if (format == &qtri_rgb565) {
        return 24u << 11 | 25u << 5 | 6u;
    }
    if (format == &qtri_rgb565_swapped) {
        return 0x26C3; /* 24 << 11 | 25 << 5 | 6 is 0xC326 */
    }
    if (format == &qtri_rgb888) {
        return 0x3264C8;
    }
    return format == &qtri_gray8 ? 124 : 0xC86432;
}

/* A frame in the middle of memory whose every other byte must stay what it was. */
TEST(clears_rectangles)
{
    static uint32_t pixels[BYTES / 4];
    static uint16_t depths[BYTES / 2];
    static uint32_t pixels_before[BYTES / 4];
    static uint16_t depths_before[BYTES / 2];
    uint64_t seed = 81;
    for (int n = 0; n < 6000; n++) {
        const qtri_format *format = formats[random_in(&seed, 0, LENGTH_OF(formats) - 1)];
        int32_t bytes = (int32_t)format->pixels->bytes;
        qtri_surface s = {0};
        s.format = format;
        s.width = random_in(&seed, 1, n % 2 ? SIDE : 9);
        s.height = random_in(&seed, 1, n % 5 ? 9 : SIDE);
        s.first_row = random_in(&seed, 0, 5);
        s.rows = random_in(&seed, 1, s.height);
        int32_t gap = random_in(&seed, 0, 1) * random_in(&seed, 0, 9);
        s.pitch = (s.width + gap) * bytes;
        s.depth_pitch = s.width + random_in(&seed, 0, 1) * random_in(&seed, 0, 9);
        uint8_t *first = (uint8_t *)pixels + MARGIN / 4 * 4 + random_in(&seed, 0, 3) * bytes;
        s.pixels = first;
        s.depth = n % 10 ? depths + MARGIN + random_in(&seed, 0, 3) : NULL;
        uint16_t *first_depth = s.depth;
        if (random_in(&seed, 0, 3) == 0) { /* bottom-up */
            s.pixels += (s.rows - 1) * s.pitch;
            s.pitch = -s.pitch;
        }
        qtri_rect part = {random_in(&seed, -3, s.width), random_in(&seed, -3, s.height),
                          random_in(&seed, 0, s.width + 3), random_in(&seed, 0, s.height + 3)};
        qtri_rect all = {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX};
        qtri_rect none = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
        s.scissor = n % 4 == 0 ? part : (n % 40 == 1 ? none : all);
        uint16_t depth = (uint16_t)random_in(&seed, 0, 65535);
        for (size_t i = 0; i < LENGTH_OF(pixels); i++) {
            pixels[i] = 0x12345678u * (uint32_t)(i + 1);
            depths[2 * i] = depths[2 * i + 1] = (uint16_t)(i * 40503u);
        }
        memcpy(pixels_before, pixels, sizeof pixels);
        memcpy(depths_before, depths, sizeof depths);

        clear_to(&s, color, depth);

        qtri_rect r = qtri_surface_bounds(&s);
        for (int32_t y = r.y0; y < r.y1; y++) {
            for (int32_t x = r.x0; x < r.x1; x++) {
                ptrdiff_t row = y - s.first_row;
                assert_int_equal(stored_pixel(&s, x, y), expected_pixel(format));
                ptrdiff_t at = s.pixels + row * s.pitch + x * bytes - (uint8_t *)pixels;
                memcpy((uint8_t *)pixels + at, (uint8_t *)pixels_before + at, (size_t)bytes);
                if (first_depth != NULL) {
                    assert_int_equal(stored_depth(&s, x, y), depth);
                    at = first_depth - depths + row * s.depth_pitch + x;
                    depths[at] = depths_before[at];
                }
            }
        }
        assert_memory_equal(pixels, pixels_before, sizeof pixels);
        assert_memory_equal(depths, depths_before, sizeof depths);
    }
}

TEST(sizes_and_memory)
{
    static uint8_t memory[QTRI_BAND_BYTES(13, 5, QTRI_XRGB8888_BYTES) + 8];
    struct {
        int32_t width, height, first, rows;
        enum qtri_error error;
    } cases[] = {{13, 9, 0, 5, QTRI_OK},
                 {13, 9, 8, 5, QTRI_OK},
                 {0, 9, 0, 5, QTRI_ERROR_SIZE},
                 {13, 0, 0, 5, QTRI_ERROR_SIZE},
                 {QTRI_SURFACE_MAX + 1, 9, 0, 5, QTRI_ERROR_SIZE},
                 {13, QTRI_SURFACE_MAX + 1, 0, 5, QTRI_ERROR_SIZE},
                 {13, 9, -1, 5, QTRI_ERROR_SIZE},
                 {13, 9, 9, 5, QTRI_ERROR_SIZE},
                 {13, 9, 0, 0, QTRI_ERROR_SIZE},
                 {13, 9, 0, INT32_MIN, QTRI_ERROR_SIZE},
                 {INT32_MIN, INT32_MAX, INT32_MAX, INT32_MAX, QTRI_ERROR_SIZE},
                 {14, 9, 0, 5, QTRI_ERROR_MEMORY},
                 {13, 9, 0, 6, QTRI_ERROR_MEMORY},
                 {QTRI_SURFACE_MAX, QTRI_SURFACE_MAX, 0, QTRI_SURFACE_MAX, QTRI_ERROR_MEMORY}};
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        qtri_surface s;
        assert_int_equal(qtri_surface_init(&s, &qtri_xrgb8888, cases[i].width, cases[i].height,
                                           cases[i].first, cases[i].rows, memory,
                                           QTRI_BAND_BYTES(13, 5, QTRI_XRGB8888_BYTES)),
                         cases[i].error);
    }
    static const qtri_format *const aligned[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    for (int n = 0; n < 12; n++) { /* any alignment, any format: aligned and inside */
        const qtri_format *format = aligned[n % 3];
        size_t bytes = QTRI_BAND_BYTES(13, 5, format->pixels->bytes);
        qtri_surface s;
        assert_ok(qtri_surface_init(&s, format, 13, 7, 4, 5, memory + n / 3, bytes));
        assert_int_equal(s.rows, 3);
        assert_int_equal((uintptr_t)s.pixels % format->pixels->bytes, 0);
        assert_int_equal((uintptr_t)s.depth % 2, 0);
        assert_true(s.pixels >= memory + n / 3);
        assert_true((uint8_t *)s.depth >= s.pixels + 5 * s.pitch);
        assert_true((uint8_t *)(s.depth + 5 * s.depth_pitch) <= memory + n / 3 + bytes);
        const qtri_rgb purple = {255, 0, 255};
        clear_to(&s, purple, 7);
        qtri_rgb at = qtri_surface_pixel(&s, 12, 6);
        assert_true(at.r == (format == &qtri_gray8 ? 105 : 255)); /* .413 * 255 */
        qtri_rgb out = qtri_surface_pixel(&s, 12, 7);
        assert_true(out.r == 0 && out.g == 0 && out.b == 0);
        (void)qtri_surface_pixel(&s, INT32_MIN, INT32_MIN);
        (void)qtri_surface_pixel(&s, INT32_MAX, INT32_MAX);
        assert_int_equal(stored_depth(&s, 0, 4), 7);
    }
}

/* Any bits: a rectangle inside the frame and the rows held, or an empty one. */
TEST(bounds_of_any_surface)
{
    uint64_t seed = 65;
    for (int n = 0; n < 100000; n++) {
        qtri_surface s = {NULL, 0, NULL, 0, &qtri_gray8, 0, 0, 0, 0, {0, 0, 0, 0}, NULL};
        int32_t *fields[] = {&s.width,      &s.height,     &s.first_row,  &s.rows,
                             &s.scissor.x0, &s.scissor.y0, &s.scissor.x1, &s.scissor.y1};
        for (size_t i = 0; i < LENGTH_OF(fields); i++) {
            *fields[i] = random_any(&seed);
        }
        qtri_rect r = qtri_surface_bounds(&s);
        if (r.x0 < r.x1 && r.y0 < r.y1) {
            assert_true(r.x0 >= 0 && r.x1 <= s.width && r.y0 >= 0 && r.y1 <= s.height);
            assert_true(r.y0 >= s.first_row);
            assert_true(r.y1 <= (int64_t)s.first_row + s.rows);
        } else {
            assert_true((r.x0 | r.y0 | r.x1 | r.y1) == 0);
        }
        s.rows = s.rows > 0 ? -s.rows : s.rows;
        const int32_t x = random_any(&seed);
        qtri_rgb none = qtri_surface_pixel(&s, x, random_any(&seed));
        assert_true((none.r | none.g | none.b) == 0);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
