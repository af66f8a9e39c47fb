/* SPDX-License-Identifier: MIT */
/* What panels say on the bus: call by call, when something fails, and when there is too little
 * memory. */
#include "support/panel.h"

static void assert_log(wire *w, const char *expected)
{
    assert_string_equal(w->log, expected);
    w->log[0] = '\0';
    w->log_length = 0;
}

/* Black, as the log shows many bytes. */
#define ZEROS "d0000000000000000000000000000000000"

static void clear_log(wire *w)
{
    w->log[0] = '\0';
    w->log_length = 0;
}

static void assert_log_ends(wire *w, const char *first, const char *last)
{
    size_t length = strlen(last);
    assert_true(strlen(first) <= w->log_length && length <= w->log_length);
    assert_string_equal(w->log + w->log_length - length, last);
    w->log[strlen(first)] = '\0';
    assert_string_equal(w->log, first);
    clear_log(w);
}

/* Two rows of four pixels at (3, 5), in the frame of the panel. */
static qtri_rect small_rect(void)
{
    qtri_rect rect = {3, 5, 7, 7};
    return rect;
}

static void send_white(setup *s, qtri_rect rect, int32_t first, int32_t rows)
{
    canvas band = canvas_band(&qtri_rgb565, qtri_panel_width(&s->panel),
                              qtri_panel_height(&s->panel), first, rows);
    qtri_rgb white = {255, 255, 255};
    qtri_surface_clear(&band.surface, white);
    assert_ok(qtri_panel_write_rect(&s->panel, &band.surface, rect));
    assert_ok(qtri_panel_finish(&s->panel));
    canvas_free(&band);
}

TEST(ssd1306_sequence)
{
    static setup s;
    setup_init(&s, 0);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    assert_log(&s.wire, "r1 w1 r0 w100 cAE cD580 cA83F cD300 c40 c8D14 c2000 cA1 cC8 cDA12 c81CF "
                        "cD9F1 cDB20 c2E cA4 cA6 c21007F c220007 " ZEROS "..(1024) cAF");
    send_white(&s, small_rect(), 0, 16);
    assert_log(&s.wire, "c210306 c220000 d60606060"); /* rows 5 and 6 are bits 5 and 6 of page 0 */
    qtri_rect rect = {0, 6, 128, 9};
    send_white(&s, rect, 0, 16);
    assert_log(&s.wire, "c21007F c220001 dC0C0C0E0E0E0E0C0C0C0C0C0C0C0C0C0C0..(256)");
    qtri_panel_step contrast = {0x81, 1, {0x10}, 3};
    assert_ok(qtri_panel_send(&s.panel, &contrast, 1));
    assert_log(&s.wire, "c8110 w3");
    assert_chip_content(&s.sim.chip);
    setup_end(&s);
}

/* Control byte 0x00 before commands, 0x40 before data; at most 32 bytes at a time. */
TEST(i2c_sequence)
{
    static setup s;
    setup_init(&s, 2);
    assert_ok(setup_start(&s, QTRI_ROTATE_180, true));
    clear_log(&s.wire);
    qtri_rect rect = {0, 0, 40, 8};
    send_white(&s, rect, 0, 16); /* turned: columns 88..127, page 7 */
    assert_log(&s.wire,
               "i0021587F i00220707 i40FFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF..(32) i40FFFFFFFFFF"
               "FFFFFFFF");
    assert_chip_content(&s.sim.chip);
    s.wire.i2c.bytes = QTRI_I2C_BYTES - 1;
    assert_int_equal(qtri_i2c_bus(&s.wire.bus, &s.wire.i2c), QTRI_ERROR_MEMORY);
    setup_end(&s);
}

/* Parameters with D/C low, as command bytes. */
TEST(ssd0323_sequence)
{
    static setup s;
    setup_init(&s, 4);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, false));
    assert_log_ends(&s.wire,
                    "r1 w1 r0 w1 cAE c8132 c85 cA052 cA100 cA24C cA83F cB122 cB246 cB3F1 "
                    "cBF0D cBE02 cBC10 cB80111223243546576 cAD03 cA4 c15003F c75003F " ZEROS
                    "..(64)",
                    ZEROS "..(64) cAF");
    send_white(&s, small_rect(), 5, 2); /* pixels 2 and 7 complete the bytes, from the surface */
    assert_log(&s.wire, "c150103 c750506 dFFFFFFFFFFFF");
    setup_end(&s);

    setup_init(&s, 5);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    clear_log(&s.wire);
    send_white(&s, small_rect(), 5,
               2); /* from the image, row by row; pixels 2 and 7 are black yet */
    assert_log(&s.wire, "c150103 c750506 s0FFFF0 f3 s0FFFF0 f3");
    setup_end(&s);
}

/* Parameters with D/C high, windows in the frame's directions, line buffers in turn. */
TEST(lcd_sequence)
{
    static setup s;
    setup_init(&s, 8);
    assert_ok(setup_start(&s, QTRI_ROTATE_90, true));
    assert_log_ends(&s.wire,
                    "r1 w1 r0 w120 c01 w120 cCB d392C003402 cCF d00C130 cE8 d850078 cEA d0000 "
                    "cED d64031281 cF7 d20 cC0 d23 cC1 d10 cC5 d3E28 cC7 d86 c3A d55 cB1 d0018 "
                    "cF2 d00 c26 d01 cE0 d0F312B0C0E084EF1370710030E0900 "
                    "cE1 d000E1403110731C148080F0C31360F c11 w120 c36 d28 c20 "
                    "c2A d0000013F c2B d000000EF c2C s",
                    "..(960) f960 c29");
    assert_ok(setup_start(&s, QTRI_ROTATE_90, false));
    clear_log(&s.wire);
    qtri_rect two = {300, 5, 302, 6};
    send_white(&s, two, 0, 16);
    assert_log(&s.wire, "c2A d012C012D c2B d00050005 c2C sFFFF f2 sFFFF f2");
    setup_end(&s);

    setup_init(&s, 8);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    clear_log(&s.wire);
    send_white(&s, small_rect(), 0, 16);
    assert_log(&s.wire, "c2A d00030006 c2B d00050006 c2C sFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF f16");
    setup_end(&s);

    setup_init(&s, 8);
    uint8_t three_pixels[15]; /* twice three pixels and some bytes */
    assert_ok(qtri_panel_init(&s.panel, &qtri_ili9341, &s.wire.bus, QTRI_ROTATE_0, three_pixels,
                              sizeof three_pixels));
    clear_log(&s.wire);
    send_white(&s, small_rect(), 0, 16);
    assert_log(&s.wire,
               "c2A d00030006 c2B d00050006 c2C sFFFFFFFFFFFF f6 sFFFFFFFFFFFF f6 sFFFFFFFF f4");

    /* The glass begins at column 52, row 40; turned, the memory is counted from its other ends:
       240 - 135 - 52 = 53 and 320 - 240 - 40 = 40. */
    static const char *const windows[4] = {"c2A d00370039 c2B d002D002D c2C dFFFFFFFFFFFF",
                                           "c2A d002B002D c2B d003A003A c2C dFFFFFFFFFFFF",
                                           "c2A d0038003A c2B d002D002D c2C dFFFFFFFFFFFF",
                                           "c2A d002B002D c2B d00390039 c2C dFFFFFFFFFFFF"};
    for (int rotation = 0; rotation < 4; rotation++) {
        setup_init(&s, 11);
        assert_ok(setup_start(&s, (qtri_rotation)rotation, true));
        clear_log(&s.wire);
        qtri_rect three = {3, 5, 6, 6};
        send_white(&s, three, 0, 16);
        assert_log(&s.wire, windows[rotation]);
        setup_end(&s);
    }
}

/* A frame of the bus is one of the display's: the line's number, its pixels, the last clocks. */
TEST(memory_lcd_sequence)
{
    static setup s;
    setup_init(&s, 35);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    assert_log(&s.wire, "r1 w1 r0 w1 c00 d2000 c00");
    for (int n = 0; n < 3; n++) { /* rows 5 and 6 are lines 6 and 7; VCOM each second time */
        send_white(&s, small_rect(), 0, 16);
        assert_log(&s.wire, n % 2 == 0 ? "c00 dC060 d1E0000000000000000000000 dC0E0 "
                                         "d1E0000000000000000000000 d0000 c00"
                                       : "c00 d8060 d1E0000000000000000000000 d80E0 "
                                         "d1E0000000000000000000000 d0000 c00");
    }
    assert_int_equal(s.sim.sharp.vcom_changes, 3);
    s.wire.fail_at = s.wire.calls + 3; /* within a line: the next transfer begins anew */
    canvas band = canvas_band(&qtri_rgb565, 96, 96, 0, 16);
    assert_int_equal(qtri_panel_write(&s.panel, &band.surface), QTRI_ERROR_BUS);
    canvas_free(&band);
    assert_chip_content(&s.sim.chip);
    setup_end(&s);
}

TEST(paper_sequence)
{
    static setup s;
    setup_init(&s, 6);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, false));
    assert_log(&s.wire,
               "r1 w10 r0 w10 c12 w1 w1 w1 w1 w1 w1 w1 w1 w1 w1 c01 dF90000 c11 d03 c3C d05 "
               "c18 d80 c21 d4080");
    qtri_rect rect = {17, 200, 20, 201};
    send_white(&s, rect, 200, 1);
    assert_log(&s.wire, "c44 d0202 c45 dC800C800 c4E d02 c4F dC800 c24 dFF");
    rect.x0 = 121; /* six bits of the last byte are not on the glass */
    rect.x1 = 122;
    send_white(&s, rect, 200, 1);
    assert_log(&s.wire, "c44 d0F0F c45 dC800C800 c4E d0F c4F dC800 c24 dC0");
    assert_int_equal(s.sim.ssd1680.refreshes, 0);
    s.wire.bus.busy = NULL; /* the pin is not wired: as long as it mostly takes */
    assert_ok(qtri_panel_refresh(&s.panel));
    assert_log(&s.wire, "c22 dF7 c20 w2000");
    assert_int_equal(s.sim.ssd1680.refreshes, 1);
    assert_chip_content(&s.sim.chip);

    s.wire.bus.busy = wire_busy;
    s.wire.stuck = true;
    assert_int_equal(qtri_panel_refresh(&s.panel), QTRI_ERROR_BUS);
    setup_end(&s);
}

/* Whichever call fails, the panel says so and makes no other. */
TEST(failures)
{
    static setup s;
    for (int n = 0; n < SETUPS; n++) {
        bool reached = true;
        for (int fail = 1; reached; fail++) {
            setup_init(&s, n);
            s.wire.fail_at = fail;
            bool most = n > 6 || n % 2 == 0; /* few calls */
            enum qtri_error error = setup_start(&s, QTRI_ROTATE_0, most);
            if (error == QTRI_OK) {
                canvas band = canvas_band(&qtri_rgb565, qtri_panel_width(&s.panel),
                                          qtri_panel_height(&s.panel), 0, 8);
                qtri_rect rect = {0, 0, 9, 8};
                error = qtri_panel_write_rect(&s.panel, &band.surface, rect);
                error = error == QTRI_OK ? qtri_panel_finish(&s.panel) : error;
                error = error == QTRI_OK ? qtri_panel_refresh(&s.panel) : error;
                canvas_free(&band);
            }
            reached = s.wire.calls >= fail;
            assert_int_equal(error, reached ? QTRI_ERROR_BUS : QTRI_OK);
            assert_int_equal(s.wire.calls, reached ? fail : s.wire.calls);
            assert_ok(qtri_panel_finish(&s.panel));
            setup_end(&s);
        }
    }
}

/* A transfer that did not start has no end to wait for; the next one starts as if it had not been.
 */
TEST(failed_starts_have_no_finish)
{
    static setup s;
    int failed_starts = 0;
    int failed_finishes = 0;
    for (int n = 0; n < SETUPS; n++) {
        for (int fail = 1;; fail++) {
            setup_init(&s, n);
            if (s.wire.bus.data_start == NULL || setup_start(&s, QTRI_ROTATE_0, true) != QTRI_OK) {
                setup_end(&s);
                break;
            }
            assert_ok(qtri_panel_finish(&s.panel));
            clear_log(&s.wire);
            s.wire.fail_at = s.wire.calls + fail;
            canvas band = canvas_band(&qtri_rgb565, qtri_panel_width(&s.panel),
                                      qtri_panel_height(&s.panel), 0, 8);
            const qtri_rect rect = {0, 0, 9, 8};
            enum qtri_error error = qtri_panel_write_rect(&s.panel, &band.surface, rect);
            const enum qtri_error end = qtri_panel_finish(&s.panel);
            const bool reached = s.wire.calls >= s.wire.fail_at;
            assert_true(reached == (error != QTRI_OK || end != QTRI_OK));
            int starts = 0;
            int finishes = 0;
            for (const char *c = s.wire.log; *c != '\0'; c++) {
                starts += *c == 's';
                finishes += *c == 'f';
            }
            const bool start_failed = starts > finishes;
            assert_true(starts - finishes <= 1 && (reached || !start_failed));
            failed_starts += start_failed;
            failed_finishes += end != QTRI_OK;
            s.wire.fail_at = 0;
            assert_ok(qtri_panel_write_rect(&s.panel, &band.surface, rect));
            assert_ok(qtri_panel_finish(&s.panel));
            canvas_free(&band);
            setup_end(&s);
            if (!reached) {
                break;
            }
        }
    }
    assert_true(failed_starts > 0 && failed_finishes > 0);
}

/* Sizes and memory that do not fit are refused; surfaces of another frame too. */
TEST(errors)
{
    static setup s;
    for (int n = 0; n < SETUPS; n++) {
        setup_init(&s, n);
        size_t least = memory_bytes(s.description, false);
        uint8_t memory[512];
        const struct {
            qtri_panel_description change;
            const qtri_bus *bus;
            int rotation;
            size_t bytes;
            enum qtri_error error;
        } cases[] = {{*s.description, &s.wire.bus, 4, least, QTRI_ERROR_SIZE},
                     {*s.description, &s.wire.bus, -1, least, QTRI_ERROR_SIZE},
                     {*s.description, NULL, 0, least, QTRI_ERROR_SIZE},
                     {*s.description, &s.wire.bus, 0, least - 1, QTRI_ERROR_MEMORY},
                     {*s.description, &s.wire.bus, 0, least, QTRI_OK}};
        for (size_t i = 0; i < LENGTH_OF(cases); i++) {
            assert_int_equal(qtri_panel_init(&s.panel, &cases[i].change, cases[i].bus,
                                             (qtri_rotation)cases[i].rotation, memory,
                                             cases[i].bytes),
                             cases[i].error);
        }
        qtri_panel_description odd[7];
        for (int i = 0; i < 7; i++) {
            odd[i] = *s.description;
        }
        odd[0].width = 0;
        odd[1].height = 0;
        odd[2].width = QTRI_SURFACE_MAX + 1;
        odd[3].height = 65535;
        odd[4].format = QTRI_PANEL_XRGB8888;
        odd[5].first_column = (uint16_t)(odd[5].memory_width - odd[5].width + 1);
        odd[6].memory_height = (uint16_t)(odd[6].height - 1);
        for (int i = 0; i < 7; i++) {
            assert_int_equal(qtri_panel_init(&s.panel, &odd[i], &s.wire.bus, QTRI_ROTATE_0, memory,
                                             sizeof memory),
                             QTRI_ERROR_SIZE);
        }
        assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
        clear_log(&s.wire);
        canvas none = canvas_new(&qtri_rgb565, 9, 9);
        none.surface.format = NULL;
        none.surface.width = s.description->width;
        none.surface.height = s.description->height;
        assert_int_equal(qtri_panel_write(&s.panel, &none.surface), QTRI_ERROR_FORMAT);
        canvas_free(&none);
        canvas other = canvas_new(&qtri_rgb565, s.description->width + 1, s.description->height);
        assert_int_equal(qtri_panel_write(&s.panel, &other.surface), QTRI_ERROR_SIZE);
        canvas_free(&other);
        setup_end(&s);
    }
    qtri_panel_description gray = QTRI_FRAMEBUFFER(8, 8, QTRI_PANEL_GRAY1, QTRI_ORDER_NATIVE);
    qtri_panel_description narrow = QTRI_FRAMEBUFFER(8, 8, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    narrow.pitch = 15;
    uint8_t memory[256];
    qtri_panel panel;
    assert_int_equal(qtri_panel_init(&panel, &gray, NULL, QTRI_ROTATE_0, memory, 256),
                     QTRI_ERROR_SIZE);
    assert_int_equal(qtri_panel_init(&panel, &narrow, NULL, QTRI_ROTATE_0, memory, 256),
                     QTRI_ERROR_SIZE);
}

/* Rectangles of any bits, surfaces that hold any rows: only what exists is read and sent. */
TEST(any_rectangle)
{
    static setup s;
    uint64_t random = 5;
    for (int n = 0; n < SETUPS; n++) {
        setup_init(&s, n);
        assert_ok(setup_start(&s, (qtri_rotation)(n % 4), true));
        int32_t w = qtri_panel_width(&s.panel);
        int32_t h = qtri_panel_height(&s.panel);
        canvas band = canvas_band(&qtri_gray8, w, h, h / 2, 3);
        for (int i = 0; i < 300; i++) {
            qtri_rect rect = {random_any(&random), random_any(&random), random_any(&random),
                              random_any(&random)};
            assert_ok(qtri_panel_write_rect(&s.panel, &band.surface, rect));
        }
        assert_ok(qtri_panel_finish(&s.panel));
        clear_log(&s.wire);
        const qtri_rect nothing[] = {{5, h / 2, 5, h / 2 + 1},     {5, 0, 9, h / 2},
                                     {5, h / 2 + 3, 9, h},         {w, 0, w + 1, h},
                                     {INT32_MAX, 0, INT32_MIN, h}, {-9, 0, 0, h},
                                     {0, INT32_MAX, w, INT32_MIN}};
        for (size_t i = 0; i < LENGTH_OF(nothing); i++) {
            assert_ok(qtri_panel_write_rect(&s.panel, &band.surface, nothing[i]));
        }
        qtri_surface odd = band.surface;
        odd.rows = INT32_MAX;
        odd.first_row = INT32_MAX;
        assert_ok(qtri_panel_write(&s.panel, &odd));
        odd.rows = INT32_MIN;
        odd.first_row = INT32_MIN;
        assert_ok(qtri_panel_write(&s.panel, &odd));
        assert_log(&s.wire, "");
        assert_chip_content(&s.sim.chip);
        canvas_free(&band);
        setup_end(&s);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
