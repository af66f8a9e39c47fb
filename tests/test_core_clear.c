/* SPDX-License-Identifier: MIT */
/*
 * Clearing: exactly the rectangle, whatever the format, the alignment and the pitch.
 */
#include "support_core.h"

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
static void rectangles(void **state)
{
    (void)state;
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

        qtri_surface_clear(&s, color, depth);

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles),
    };
    return cmocka_run_group_tests_name("core clear", tests, NULL, NULL);
}
