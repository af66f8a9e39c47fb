/* SPDX-License-Identifier: MIT */
/*
 * A screen: what its panel shows is what was drawn, whatever the display, the rotation, the height
 * of bands, the number of buffers and how the bus sends.
 */
#include "support/panel.h"

#include <qtri_port/screen.h>

enum { ROWS_MAX = 24, SIDE_MAX = 480 };

static uint8_t memory[QTRI_SCREEN_BYTES(SIDE_MAX, ROWS_MAX, QTRI_XRGB8888_BYTES)];

/* The picture on all of the display at once, and as it should be seen. */
static uint32_t *expected_of(const qtri_screen *screen, const qtri_format *format, uint64_t seed)
{
    canvas whole =
        canvas_new(format, qtri_panel_width(&screen->panel), qtri_panel_height(&screen->panel));
    draw_picture(&whole.surface, seed);
    uint32_t *expected = picture_expected(&whole.surface, &screen->panel);
    canvas_free(&whole);
    return expected;
}

static void assert_shows(setup *s, const qtri_screen *screen, const qtri_format *format,
                         uint64_t seed)
{
    uint32_t *expected = expected_of(screen, format, seed);
    s->panel = screen->panel;
    assert_seen(s, expected);
    free(expected);
}

TEST(every_display_shows_what_is_drawn)
{
    static const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_rgb565_swapped,
                                                  &qtri_xrgb8888};
    uint64_t seed = 1;
    for (int n = 0; n < 4 * SETUPS; n++) {
        static setup s;
        qtri_screen screen;
        qtri_surface band;
        setup_init(&s, n % SETUPS);
        const qtri_rotation rotation =
            is_gray(s.description) ? QTRI_ROTATE_0 : (qtri_rotation)(n % 4);
        const qtri_format *format = formats[random_in(&seed, 0, 2)];
        const int32_t rows = 8 * random_in(&seed, 1, ROWS_MAX / 8);
        const int32_t width = rotation % 2 != 0 ? s.description->height : s.description->width;
        const size_t bytes = random_flag(&seed)
                                 ? QTRI_SCREEN_BYTES(width, rows, format->pixels->bytes)
                                 : QTRI_FRAME_BYTES(width, rows, format->pixels->bytes) +
                                       QTRI_PANEL_LINE_BYTES(width);
        assert_ok(qtri_screen_init(&screen, s.description, &s.wire.bus, rotation, format, rows,
                                   memory, bytes));
        for (uint64_t frame = 0; frame < 2; frame++) {
            while (qtri_screen_next(&screen, &band)) {
                draw_picture(&band, (uint64_t)n + frame);
            }
            assert_ok(screen.error);
            assert_ok(qtri_panel_finish(&screen.panel));
            if (s.description->refresh != NULL) {
                assert_ok(qtri_panel_refresh(&screen.panel));
            }
            assert_shows(&s, &screen, format, (uint64_t)n + frame);
        }
        setup_end(&s);
    }
}

/* Rows that overlap are not sent, whether they are drawn again or kept; nor is what did not change.
 */
TEST(only_what_is_shown_is_sent)
{
    enum { ILI9341_DMA = 8, ROWS = 16, WIDTH = 240 };
    static uint8_t kept[QTRI_FRAME_KEPT_BYTES(WIDTH, 2, QTRI_RGB565_BYTES)];
    for (int keeps = 0; keeps < 2; keeps++) {
        static setup s;
        qtri_screen screen;
        qtri_surface band;
        setup_init(&s, ILI9341_DMA);
        assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
        screen.panel = s.panel;
        assert_ok(qtri_screen_begin(&screen, &qtri_rgb565, ROWS, memory, sizeof memory));
        assert_ok(qtri_frame_set_overlap(&screen.frame, 2, keeps ? kept : NULL, sizeof kept));
        s.wire.data_bytes = 0;
        while (qtri_screen_next(&screen, &band)) {
            draw_picture(&band, 5);
            qtri_frame_join(&screen.frame, &band);
        }
        assert_ok(qtri_panel_finish(&screen.panel));
        assert_in_range(s.wire.data_bytes, 2 * 240 * 320, 2 * 240 * 320 + 20 * 16);
        assert_shows(&s, &screen, &qtri_rgb565, 5);
        if (!keeps) {
            const qtri_rect changed = {100, 100, 110, 130};
            s.wire.data_bytes = 0;
            qtri_frame_mark(&screen.frame, &changed);
            qtri_frame_only_changes(&screen.frame);
            while (qtri_screen_next(&screen, &band)) {
                draw_picture(&band, 5);
            }
            assert_ok(qtri_panel_finish(&screen.panel));
            assert_in_range(s.wire.data_bytes, 2 * 14 * 34, 2 * 14 * 34 + 3 * 16);
            assert_shows(&s, &screen, &qtri_rgb565, 5);
        }
        setup_end(&s);
    }
}

static bool take_command(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    (void)bytes;
    (void)count;
    return true;
}

typedef struct taken {
    uint8_t data[4000];
    size_t count;
} taken;

static bool take_data(void *context, const uint8_t *bytes, size_t count)
{
    taken *t = (taken *)context;
    assert_true(t->count + count <= sizeof t->data);
    memcpy(t->data + t->count, bytes, count);
    t->count += count;
    return true;
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)context;
    (void)ms;
}

static enum qtri_error any_window(const qtri_panel *panel, const qtri_rect *window)
{
    (void)panel;
    (void)window;
    return QTRI_OK;
}

/* Bands of any number of pixels, from any column of a word on, in the order of bytes that the
   display has, with one buffer and with two; and a display that is memory. */
TEST(pixels_have_the_order_of_the_display)
{
    enum { W = 9, H = 7 };
    static const qtri_byte_order orders[3] = {QTRI_ORDER_BIG, QTRI_ORDER_LITTLE, QTRI_ORDER_NATIVE};
    static uint8_t shown_memory[2 * W * H + QTRI_PANEL_LINE_BYTES(W)];
    static uint32_t words[QTRI_SCREEN_BYTES(W, H + 2, QTRI_RGB565_BYTES) / 4 + 1];
    canvas whole = canvas_new(&qtri_rgb565, W, H);
    draw_picture(&whole.surface, 6);
    for (int n = 0; n < 3 * 2 * 4 * 3; n++) {
        static taken t;
        const int32_t rows = 1 + n / 6 % 4, overlap = n / 24;
        const bool has_two = n / 3 % 2 == 0;
        const qtri_bus bus = {&t, take_command, take_data, NULL, NULL, wait_ms, NULL, NULL, 0};
        const qtri_panel_description d = {.width = W,
                                          .height = H,
                                          .format = QTRI_PANEL_RGB565,
                                          .order = orders[n % 3],
                                          .memory_width = W,
                                          .memory_height = H,
                                          .window = any_window,
                                          .write = qtri_panel_write_565};
        qtri_screen screen;
        qtri_surface band;
        const size_t bytes = has_two ? QTRI_SCREEN_BYTES(W, rows + 2 * overlap, QTRI_RGB565_BYTES)
                                     : QTRI_FRAME_BYTES(W, rows + 2 * overlap, QTRI_RGB565_BYTES) +
                                           QTRI_PANEL_LINE_BYTES(W);
        assert_ok(
            qtri_screen_init(&screen, &d, &bus, QTRI_ROTATE_0, &qtri_rgb565, rows, words, bytes));
        assert_ok(qtri_frame_set_overlap(&screen.frame, overlap, NULL, 0));
        assert_int_equal(screen.frame.other_pixels != NULL, has_two);
        t.count = 0;
        while (qtri_screen_next(&screen, &band)) {
            draw_picture(&band, 6);
        }
        assert_ok(screen.error);
        assert_int_equal(t.count, 2 * W * H);
        for (int32_t i = 0; i < W * H; i++) {
            const uint32_t pixel = stored_pixel(&whole.surface, i % W, i / W);
            uint16_t native;
            memcpy(&native, t.data + 2 * i, 2);
            const uint32_t is = n % 3 == 0   ? (uint32_t)t.data[2 * i] << 8 | t.data[2 * i + 1]
                                : n % 3 == 1 ? (uint32_t)t.data[2 * i + 1] << 8 | t.data[2 * i]
                                             : native;
            assert_int_equal(is, pixel);
        }
    }
    const qtri_panel_description mapped =
        QTRI_FRAMEBUFFER(W, H, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    qtri_screen screen;
    qtri_surface band;
    assert_ok(qtri_panel_init(&screen.panel, &mapped, NULL, QTRI_ROTATE_0, shown_memory,
                              sizeof shown_memory));
    assert_ok(qtri_screen_begin(&screen, &qtri_rgb565, 2, words, sizeof words));
    while (qtri_screen_next(&screen, &band)) {
        draw_picture(&band, 6);
    }
    assert_memory_equal(shown_memory, whole.surface.pixels, 2 * W * H);
    canvas_free(&whole);
}

/* Bands are black where nothing is drawn, or of the colour that the user sets. */
TEST(bands_are_cleared)
{
    static setup s;
    qtri_screen screen;
    qtri_surface band;
    setup_init(&s, 7);
    assert_ok(qtri_screen_init(&screen, s.description, &s.wire.bus, QTRI_ROTATE_0, &qtri_xrgb8888,
                               16, memory, sizeof memory));
    for (int i = 0; i < 2; i++) {
        while (qtri_screen_next(&screen, &band)) {
            const qtri_rgb is = qtri_surface_pixel(&band, 3, band.first_row);
            assert_memory_equal(&is, &screen.background, sizeof is);
            assert_int_equal(band.depth[9], 65535);
        }
        screen.background = (qtri_rgb){10, 200, 30};
    }
    setup_end(&s);
}

TEST(errors_end_the_frame)
{
    static setup s;
    qtri_screen screen;
    qtri_surface band;
    setup_init(&s, 7);
    assert_int_equal(qtri_screen_init(&screen, s.description, &s.wire.bus, QTRI_ROTATE_0,
                                      &qtri_rgb565, 16, memory, 1000),
                     QTRI_ERROR_MEMORY);
    assert_false(qtri_screen_next(&screen, &band));
    assert_int_equal(screen.error, QTRI_ERROR_MEMORY);
    assert_int_equal(qtri_screen_init(&screen, s.description, &s.wire.bus, QTRI_ROTATE_0,
                                      &qtri_rgb565, 16, memory, 100),
                     QTRI_ERROR_MEMORY); /* not even for a line */
    assert_int_equal(qtri_screen_init(&screen, s.description, &s.wire.bus, QTRI_ROTATE_0,
                                      &qtri_rgb565, 16, NULL, sizeof memory),
                     QTRI_ERROR_MEMORY);
    assert_int_equal(qtri_screen_init(&screen, s.description, &s.wire.bus, (qtri_rotation)9,
                                      &qtri_rgb565, 16, memory, sizeof memory),
                     QTRI_ERROR_SIZE);
    assert_false(qtri_screen_next(&screen, &band));
    s.wire.fail_at = s.wire.calls + 3;
    assert_int_equal(qtri_screen_init(&screen, s.description, &s.wire.bus, QTRI_ROTATE_0,
                                      &qtri_rgb565, 16, memory, sizeof memory),
                     QTRI_ERROR_BUS);
    assert_false(qtri_screen_next(&screen, &band));
    assert_int_equal(screen.error, QTRI_ERROR_BUS);
    setup_end(&s);
    /* While it shows: the frame ends, and the next one is whole again. */
    setup_init(&s, 7);
    assert_ok(qtri_screen_init(&screen, s.description, &s.wire.bus, QTRI_ROTATE_0, &qtri_rgb565, 16,
                               memory, sizeof memory));
    s.wire.fail_at = s.wire.calls + 9;
    int bands = 0;
    while (qtri_screen_next(&screen, &band)) {
        bands++;
    }
    assert_in_range(bands, 1, 19);
    assert_int_equal(screen.error, QTRI_ERROR_BUS);
    while (qtri_screen_next(&screen, &band)) {
        draw_picture(&band, 7);
    }
    assert_ok(screen.error);
    assert_shows(&s, &screen, &qtri_rgb565, 7);
    setup_end(&s);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
