/* SPDX-License-Identifier: MIT */
/* Every panel shows pictures as they are: rotations, bands, formats, memory, rectangles. */
#include "support/panel.h"

static const qtri_format *const formats[] = {&qtri_rgb565,         &qtri_xrgb8888, &qtri_gray8,
                                             &qtri_rgb565_swapped, &qtri_rgb888,   &qtri_bgr888};

/* Draws bands of `rows` rows and sends each; a band that DMA may still read is left alone. */
static void send_bands(setup *s, const qtri_format *format, int32_t rows, uint64_t seed)
{
    int32_t w = qtri_panel_width(&s->panel);
    int32_t h = qtri_panel_height(&s->panel);
    for (int32_t first = 0; first < h; first += rows) {
        canvas band = canvas_band(format, w, h, first, rows);
        draw_picture(&band.surface, seed);
        assert_ok(qtri_panel_write(&s->panel, &band.surface));
        if (format == &qtri_rgb565_swapped) { /* may go out without a copy */
            assert_ok(qtri_panel_finish(&s->panel));
        }
        canvas_clear(&band); /* nothing of it is on its way */
        canvas_free(&band);
    }
    assert_ok(qtri_panel_finish(&s->panel));
    assert_ok(qtri_panel_refresh(&s->panel));
}

/* On and dark after init, turned any way, with any memory; e-paper keeps what it showed. */
TEST(dark)
{
    static setup s;
    for (int n = 0; n < SETUPS * 8; n++) {
        setup_init(&s, n / 8);
        assert_ok(setup_start(&s, (qtri_rotation)(n % 4), n % 8 < 4));
        size_t count = (size_t)s.description->width * s.description->height;
        uint32_t *black = (uint32_t *)calloc(count, sizeof *black);
        assert_non_null(black);
        if (s.controller == SHARP_CHIP) { /* cleared: white */
            memset(black, 0xFF, count * sizeof *black);
            for (size_t i = 0; i < count; i++) {
                black[i] &= 0xFFFFFF;
            }
        }
        if (!is_paper(&s)) {
            assert_seen(&s, black);
        } else {
            assert_int_equal(
                s.controller == UC8151_CHIP ? s.sim.uc8151.refreshes : s.sim.ssd1680.refreshes, 0);
        }
        free(black);
        setup_end(&s);
    }
}

/* Bands of any height come out as the whole frame, whatever the rotation and the format. */
TEST(bands)
{
    static setup s;
    for (int n = 0; n < SETUPS; n++) {
        for (int rotation = 0; rotation < 4; rotation++) {
            setup_init(&s, n);
            assert_ok(setup_start(&s, (qtri_rotation)rotation, true));
            int32_t w = qtri_panel_width(&s.panel);
            int32_t h = qtri_panel_height(&s.panel);
            const int32_t heights[] = {h, 16, 7, 1};
            for (size_t i = 0; i < LENGTH_OF(heights); i++) {
                const qtri_format *format =
                    formats[(i + (size_t)n + (size_t)rotation) % LENGTH_OF(formats)];
                uint64_t seed = 7 + i;
                canvas whole = canvas_new(format, w, h);
                draw_picture(&whole.surface, seed);
                s.panel.dither = (qtri_dither)(i % 3);
                uint32_t *expected = picture_expected(&whole.surface, &s.panel);
                send_bands(&s, format, heights[i], seed);
                assert_seen(&s, expected);
                free(expected);
                canvas_free(&whole);
            }
            setup_end(&s);
        }
    }
}

/* With the least memory: any band unrotated where bytes lie along rows; whole bytes elsewhere. */
TEST(least_memory)
{
    static setup s;
    for (int n = 0; n < SETUPS; n++) {
        for (int rotation = 0; rotation < 4; rotation++) {
            setup_init(&s, n);
            assert_ok(setup_start(&s, (qtri_rotation)rotation, false));
            int32_t w = qtri_panel_width(&s.panel);
            int32_t h = qtri_panel_height(&s.panel);
            bool pages = s.description->format == QTRI_PANEL_GRAY1_PAGE;
            bool any_height = !is_gray(s.description) || pages == (rotation % 2 != 0);
            /* Frames are not a whole number of bytes across: the SSD1680's are counted from there.
             */
            bool from_end = s.description->format == QTRI_PANEL_GRAY1 && rotation == 1;
            const bool whole_rows = s.description->window_mask == 255;
            int32_t rows = any_height ? 5 : (from_end || whole_rows ? h : 8);
            canvas whole = canvas_new(&qtri_rgb565, w, h);
            draw_picture(&whole.surface, 3);
            uint32_t *expected = picture_expected(&whole.surface, &s.panel);
            send_bands(&s, &qtri_rgb565, rows, 3);
            assert_seen(&s, expected);

            canvas band = canvas_band(&qtri_rgb565, w, h, 8, 5); /* 8..12 cut bytes of 8 rows */
            enum qtri_error error = qtri_panel_write(&s.panel, &band.surface);
            bool cuts = !any_height;
            assert_int_equal(error, cuts ? QTRI_ERROR_MEMORY : QTRI_OK);
            canvas_free(&band);
            if (is_gray(s.description)) { /* diffusion asks for an image */
                qtri_diffusion d = {NULL, w, 0, 0, 0, 0, 0};
                s.panel.diffusion = &d;
                assert_int_equal(qtri_panel_write(&s.panel, &whole.surface), QTRI_ERROR_MEMORY);
            }
            free(expected);
            canvas_free(&whole);
            setup_end(&s);
        }
    }
}

/* A rectangle changes, the rest stays. Whole frames and bands hold it. */
TEST(rectangles)
{
    static setup s;
    uint64_t random = 99;
    for (int n = 0; n < SETUPS; n++) {
        for (int rotation = 0; rotation < 4; rotation++) {
            setup_init(&s, n);
            assert_ok(setup_start(&s, (qtri_rotation)rotation, true));
            int32_t w = qtri_panel_width(&s.panel);
            int32_t h = qtri_panel_height(&s.panel);
            canvas before = canvas_new(&qtri_rgb565, w, h);
            canvas after = canvas_new(&qtri_rgb565, w, h);
            draw_picture(&before.surface, 1);
            draw_picture(&after.surface, 2);
            uint32_t *expected = picture_expected(&before.surface, &s.panel);
            uint32_t *changed = picture_expected(&after.surface, &s.panel);
            assert_ok(qtri_panel_write(&s.panel, &before.surface));
            for (int i = 0; i < 6; i++) {
                int32_t x = random_in(&random, -9, w - 1);
                int32_t y = random_in(&random, -9, h - 1);
                qtri_rect rect = {x, y, x + random_in(&random, 0, w), y + random_in(&random, 0, h)};
                int32_t first = i % 2 == 0 ? 0 : random_in(&random, 0, h - 1);
                int32_t rows = i % 2 == 0 ? h : random_in(&random, 1, 40);
                canvas band = canvas_band(&qtri_rgb565, w, h, first, rows);
                draw_picture(&band.surface, 2);
                assert_ok(qtri_panel_write_rect(&s.panel, &band.surface, rect));
                for (int32_t j = 0; j < w * h; j++) {
                    bool inside = j % w >= rect.x0 && j % w < rect.x1 && j / w >= rect.y0 &&
                                  j / w < rect.y1 && j / w >= first && j / w < first + rows;
                    expected[j] = inside ? changed[j] : expected[j];
                }
                assert_ok(qtri_panel_refresh(&s.panel));
                canvas_free(&band);
            }
            assert_seen(&s, expected);
            free(expected);
            free(changed);
            canvas_free(&before);
            canvas_free(&after);
            setup_end(&s);
        }
    }
}

/* Error diffusion over bands is that of the whole frame. */
TEST(diffusion)
{
    static setup s;
    const int setups[] = {0, 4, 6};
    for (size_t n = 0; n < LENGTH_OF(setups); n++) {
        for (int rotation = 0; rotation < 4; rotation++) {
            setup_init(&s, setups[n]);
            assert_ok(setup_start(&s, (qtri_rotation)rotation, true));
            int32_t w = qtri_panel_width(&s.panel);
            int32_t h = qtri_panel_height(&s.panel);
            int16_t errors[256];
            uint8_t max_level = s.description->format == QTRI_PANEL_GRAY4 ? 15 : 1;
            canvas whole = canvas_new(&qtri_gray8, w, h);
            draw_picture(&whole.surface, 4);
            uint32_t *expected = picture_expected(&whole.surface, &s.panel);
            uint8_t *levels = (uint8_t *)malloc((size_t)w);
            assert_non_null(levels);
            qtri_diffusion d;
            assert_ok(qtri_diffusion_init(&d, w, errors, 256));
            for (int32_t y = 0; y < h; y++) {
                qtri_surface_gray(&whole.surface, 0, y, w, levels);
                qtri_diffuse_row(&d, max_level, 0, y, levels, w, levels);
                for (int32_t x = 0; x < w; x++) {
                    expected[y * w + x] = levels[x] * (0xFFFFFFu / max_level);
                }
            }
            s.panel.diffusion = &d;
            const int32_t heights[] = {h, 16, 7, 1};
            for (size_t i = 0; i < LENGTH_OF(heights); i++) {
                send_bands(&s, &qtri_gray8, heights[i], 4);
                assert_seen(&s, expected);
            }
            free(levels);
            free(expected);
            canvas_free(&whole);
            setup_end(&s);
        }
    }
}

/* Framebuffers: every rotation, format and byte order, with gaps between rows, and nothing outside.
 */
TEST(framebuffers)
{
    enum { W = 21, H = 13, GAP = 10 };
    static const qtri_byte_order orders[] = {QTRI_ORDER_BIG, QTRI_ORDER_LITTLE, QTRI_ORDER_NATIVE};
    for (int n = 0; n < 4 * 3 * 2 * 6 * 2; n++) {
        qtri_rotation rotation = (qtri_rotation)(n % 4);
        qtri_byte_order order = orders[n / 4 % 3];
        bool wide = n / 12 % 2 != 0;
        const qtri_format *format = formats[n / 24 % 6];
        bool gaps = n / 144 % 2 != 0;
        size_t bytes = wide ? 4 : 2;
        qtri_panel_description d =
            QTRI_FRAMEBUFFER(W, H, wide ? QTRI_PANEL_XRGB8888 : QTRI_PANEL_RGB565, order);
        d.pitch = gaps ? (uint32_t)(W * bytes + GAP) : 0;
        size_t pitch = gaps ? d.pitch : W * bytes;
        size_t size = pitch * (H - 1) + W * bytes;
        uint8_t *memory = (uint8_t *)malloc(size);
        uint8_t *touched = (uint8_t *)calloc(size, 1);
        assert_true(memory != NULL && touched != NULL);
        memset(memory, 0xEE, size);
        qtri_panel panel;
        assert_int_equal(qtri_panel_init(&panel, &d, NULL, rotation, memory, size - 1),
                         QTRI_ERROR_MEMORY);
        assert_ok(qtri_panel_init(&panel, &d, NULL, rotation, memory, size));
        int32_t w = qtri_panel_width(&panel);
        int32_t h = qtri_panel_height(&panel);
        canvas whole = canvas_new(format, w, h);
        draw_picture(&whole.surface, 11);
        for (int32_t first = 0; first < h; first += 5) {
            canvas band = canvas_band(format, w, h, first, 5);
            draw_picture(&band.surface, 11);
            assert_ok(qtri_panel_write(&panel, &band.surface));
            canvas_free(&band);
        }
        uint32_t *expected = picture_expected(&whole.surface, &panel);
        for (int32_t y = 0; y < h; y++) {
            for (int32_t x = 0; x < w; x++) {
                int32_t gx = rotation == 0
                                 ? x
                                 : (rotation == 1 ? W - 1 - y : (rotation == 2 ? W - 1 - x : y));
                int32_t gy = rotation == 0
                                 ? y
                                 : (rotation == 1 ? x : (rotation == 2 ? H - 1 - y : H - 1 - x));
                size_t at = (size_t)gy * pitch + (size_t)gx * bytes;
                uint32_t value = 0;
                uint16_t value16;
                if (order == QTRI_ORDER_NATIVE && wide) {
                    memcpy(&value, memory + at, 4);
                } else if (order == QTRI_ORDER_NATIVE) {
                    memcpy(&value16, memory + at, 2);
                    value = value16;
                } else {
                    for (size_t i = 0; i < bytes; i++) {
                        size_t place = order == QTRI_ORDER_LITTLE ? bytes - 1 - i : i;
                        value = value << 8 | memory[at + place];
                    }
                }
                memset(touched + at, 1, bytes);
                qtri_rgb c = qtri_surface_pixel(&whole.surface, x, y);
                uint32_t e = expected[y * w + x];
                uint32_t want = wide ? ((uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b)
                                     : ((e >> 16 & 255) * 31 + 127) / 255 << 11 |
                                           ((e >> 8 & 255) * 63 + 127) / 255 << 5 |
                                           ((e & 255) * 31 + 127) / 255;
                assert_int_equal(value, want);
            }
        }
        for (size_t i = 0; i < size; i++) {
            assert_true(touched[i] != 0 || memory[i] == 0xEE);
        }
        free(expected);
        free(memory);
        free(touched);
        canvas_free(&whole);
    }
}

/* Surfaces of more bits, dithered: bands of any height and rectangles are the whole frame. */
TEST(dithered_colors)
{
    static setup s;
    static const qtri_format *const wide[2] = {&qtri_xrgb8888, &qtri_rgb888};
    for (int rotation = 0; rotation < 4; rotation++) {
        setup_init(&s, 15);
        assert_ok(setup_start(&s, (qtri_rotation)rotation, true));
        s.panel.dither_565 = qtri_dither_row_565;
        const int32_t w = qtri_panel_width(&s.panel), h = qtri_panel_height(&s.panel);
        canvas whole = canvas_new(wide[rotation % 2], w, h);
        draw_picture(&whole.surface, 4);
        uint32_t *expected = (uint32_t *)malloc((size_t)w * (size_t)h * sizeof *expected);
        assert_non_null(expected);
        long dots = 0;
        for (int32_t i = 0; i < w * h; i++) {
            const qtri_rgb c = qtri_surface_pixel(&whole.surface, i % w, i / w);
            const uint32_t rgb = (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
            uint16_t pixel, nearest;
            qtri_dither_row_565(QTRI_DITHER_BAYER8, i % w, i / w, &rgb, 1, &pixel);
            qtri_dither_row_565(QTRI_DITHER_NEAREST, i % w, i / w, &rgb, 1, &nearest);
            expected[i] = qtri_decode_rgb565(pixel);
            dots += pixel != nearest;
        }
        assert_true(dots > w * h / 4);
        const int32_t heights[] = {h, 16, 7, 1};
        for (size_t i = 0; i < LENGTH_OF(heights); i++) {
            send_bands(&s, wide[rotation % 2], heights[i], 4);
            assert_seen(&s, expected);
        }
        const qtri_rect rect = {3, 5, 50, 60};
        assert_ok(qtri_panel_write_rect(&s.panel, &whole.surface, rect));
        assert_seen(&s, expected);
        free(expected);
        canvas_free(&whole);
        setup_end(&s);
    }
}

/* Native order sends RGB565 from the surface itself: a bus of 16-bit words. */
TEST(native_order)
{
    static setup s;
    setup_init(&s, 8);
    const uint16_t one = 1;
    bool little = *(const uint8_t *)&one == 1;
    qtri_panel_description d = qtri_ili9341;
    d.order = little ? QTRI_ORDER_NATIVE : QTRI_ORDER_LITTLE;
    s.description = &d;
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    canvas whole = canvas_new(&qtri_rgb565, 240, 320);
    draw_picture(&whole.surface, 5);
    uint8_t *copy = (uint8_t *)malloc(240 * 320 * 2);
    assert_non_null(copy);
    memcpy(copy, whole.surface.pixels, 240 * 320 * 2);
    assert_ok(qtri_panel_write(&s.panel, &whole.surface));
    if (little) {
        assert_ptr_equal(s.wire.sending, whole.surface.pixels);
        assert_int_equal(s.wire.sending_bytes, 240 * 320 * 2);
    }
    qtri_rect rect = {10, 20, 30, 40};
    assert_ok(qtri_panel_write_rect(&s.panel, &whole.surface, rect));
    assert_ok(qtri_panel_finish(&s.panel));
    assert_ok(qtri_panel_finish(&s.panel)); /* once more: nothing to do */
    assert_chip_content(&s.sim.chip);
    for (int32_t y = 0; y < 320; y++) { /* the memory holds the bytes as they came */
        for (int32_t x = 0; x < 240; x++) {
            size_t at = ((size_t)y * 240 + (size_t)x) * 2;
            uint32_t swapped = (uint32_t)(copy[at] << 8 | copy[at + 1]);
            assert_int_equal(s.sim.lcd.memory[y][239 - x], swapped);
        }
    }
    free(copy);
    canvas_free(&whole);
    setup_end(&s);
}

/* What lies as the display wants it is sent from the surface itself: bytes exchanged. */
TEST(swapped)
{
    static setup s;
    setup_init(&s, 8);
    const uint16_t one = 1;
    bool little = *(const uint8_t *)&one == 1;
    qtri_panel_description d = qtri_ili9341;
    d.order = little ? QTRI_ORDER_BIG : QTRI_ORDER_LITTLE;
    s.description = &d;
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    canvas whole = canvas_new(&qtri_rgb565_swapped, 240, 320);
    uint16_t *pixels = (uint16_t *)(void *)whole.surface.pixels;
    uint64_t seed = 9;
    for (size_t i = 0; i < 240 * 320; i++) {
        pixels[i] = (uint16_t)random64(&seed);
    }
    assert_ok(qtri_panel_write(&s.panel, &whole.surface));
    assert_ptr_equal(s.wire.sending, whole.surface.pixels);
    assert_int_equal(s.wire.sending_bytes, 240 * 320 * 2);
    assert_ok(qtri_panel_finish(&s.panel));
    for (int32_t y = 0; y < 320; y++) {
        for (int32_t x = 0; x < 240; x++) {
            uint16_t stored = pixels[y * 240 + x];
            uint16_t shown = little ? (uint16_t)(stored << 8 | stored >> 8) : stored;
            assert_int_equal(s.sim.lcd.memory[y][239 - x], shown);
        }
    }
    canvas_free(&whole);
    setup_end(&s);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
