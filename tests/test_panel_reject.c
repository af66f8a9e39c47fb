/* SPDX-License-Identifier: MIT */
/* The simulated controllers refuse what the chips would not do as meant: streams, and broken
 * drivers. */
#include "support/panel.h"

typedef struct stream {
    const char *bytes; /* "c2A d0003" as in the log of a wire; "w120" waits, "r" resets */
    const char *error; /* part of the complaint, or NULL: none */
} stream;

static uint8_t digit(char c)
{
    return (uint8_t)(c <= '9' ? c - '0' : c - 'A' + 10);
}

static void play(chip *c, const char *text)
{
    while (*text != '\0') {
        char what = *text++;
        if (what == 'r') {
            chip_reset_pin(c, true);
            chip_reset_pin(c, false);
            chip_wait(c, 120);
        } else if (what == 'w') {
            uint32_t ms = 0;
            for (; *text >= '0' && *text <= '9'; text++) {
                ms = ms * 10 + digit(*text);
            }
            chip_wait(c, ms);
        } else if (what == 'c' || what == 'd' || what == 'i') {
            uint8_t bytes[64];
            size_t count = 0;
            for (; *text != '\0' && *text != ' '; text += 2) {
                bytes[count++] = (uint8_t)(digit(text[0]) << 4 | digit(text[1]));
            }
            if (what == 'i') {
                chip_i2c(c, bytes, count);
            } else {
                chip_send(c, what == 'd', bytes, count);
            }
        }
    }
}

static void assert_streams(int n, const stream *streams, size_t count)
{
    static setup s;
    for (size_t i = 0; i < count; i++) {
        setup_init(&s, n);
        play(&s.sim.chip, streams[i].bytes);
        const char *error = s.sim.chip.error;
        bool as_expected =
            streams[i].error == NULL ? error[0] == '\0' : strstr(error, streams[i].error) != NULL;
        if (!as_expected) {
            fail_msg("%s: \"%s\", not \"%s\"", streams[i].bytes, error,
                     streams[i].error == NULL ? "" : streams[i].error);
        }
    }
}

TEST(ssd1306_streams)
{
    static const stream streams[] = {
        {"r cAE c2000 c210001 c220000 dA55A", NULL},
        {"r c20 c00 c21 c00 c01 c22 c00 c00 dA55A", NULL},
        {"cAE", "command 0xAE without a reset"},
        {"r c23", "unknown command 0x23"},
        {"r dFF", "data without a window"},
        {"r c210001 c220000 dFF", "data without a window"}, /* page addressing mode */
        {"r c2000 c210001 c220000 dA55A00", "data past the end of the window"},
        {"r c2000 c210001 c220001 dA55AA55A d00", "data past the end of the window"},
        {"r c2000 c21000180", "unknown command 0x80"}, /* a third parameter is a command */
        {"r c2000 c2100 d01", "command 0x21 has 2 parameters, not 1"},
        {"r c2003", "command 0x20: parameter 0x03"},
        {"r c210080", "command 0x21: range 0..128"},
        {"r c210500", "command 0x21: range 5..0"},
        {"r c220008", "command 0x22: range 0..8"},
        {"r cA80E", "command 0xA8: parameter 0x0E"},
        {"r cDA13", "command 0xDA: parameter 0x13"},
        {"r cD900", "command 0xD9: parameter 0x00"},
        {"r i00AE i00A83F i002000 i00210001 i00220000 i40A55A", NULL},
        {"r i80AE80A8803F00AF", NULL},
        {"r i20AE", "control byte 0x20"},
        {"r i80", "control byte 0x80 and nothing after it"},
        {"r iAE", "control byte 0xAE"},
    };
    assert_streams(2, streams, LENGTH_OF(streams));
}

TEST(ssd0323_streams)
{
    static const stream streams[] = {
        {"r c150001 c750000 dA55A", NULL},
        {"r cA056 c150001 c750001 dA55AA55A", NULL},
        {"c15", "without a reset"},
        {"r dA5", "data without a window"},
        {"r c15 d0001", "command 0x15 has 2 parameters, not 0"}, /* D/C is low for parameters */
        {"r c150001 c750000 dA55A00", "data past the end of the window"},
        {"r c150040", "command 0x15: range 0..64"},
        {"r c750050", "command 0x75: range 0..80"},
        {"r c150302", "command 0x15: range 3..2"},
        {"r cA008", "command 0xA0: parameter 0x08"},
        {"r cA250", "command 0xA2: parameter 0x50"},
        {"r cA80E", "command 0xA8: parameter 0x0E"},
        {"r c8180", "command 0x81: parameter 0x80"},
        {"r cB801020304050607 dA5", "command 0xB8 has 8 parameters, not 7"},
        {"r c21", "unknown command 0x21"},
    };
    assert_streams(4, streams, LENGTH_OF(streams));
}

TEST(lcd_streams)
{
    static const stream streams[] = {
        {"r c3A d55 c2A d00000001 c2B d00050005 c2C d12345678", NULL},
        {"r c3A d55 c2A d00000001 c2B d00050005 c2C d12 d3456 d78", NULL},
        {"r c36 d20 c3A d55 c2A d0000013F c2B d000000EF c2C d1234", NULL},
        {"c2C", "without a reset"},
        {"r c02", "unknown command 0x02"},
        {"r d12", "command 0x00 has 0 parameters, not more"},
        {"r c2C d1234", "data in pixel format 0x66"},
        {"r c3A d55 c2A d000000 c2B", "command 0x2A has 4 parameters, not 3"},
        {"r c3A d55 c2A d0000000100", "command 0x2A has 4 parameters, not more"},
        {"r c2A00000001", "command 0x2A has 4 parameters, not 0"}, /* D/C is high for parameters */
        {"r c3A d55 c2A d00000001 c2B d00050005 c2C d1234567800", "past the end of the window"},
        {"r c3A d55 c2A d00000001 c2B d00050005 c2C d123456 c00", "in the middle of a pixel"},
        {"r c2A d00020001", "command 0x2A: range 2..1"},
        {"r c3A d55 c2A d000000F0 c2C", "columns 0..240 of 0..239"},
        {"r c36 d20 c3A d55 c2B d000000F0 c2C", "pages 0..240 of 0..239"},
        {"r c36 d02", "address mode 0x02"},
        {"r c26 d03", "gamma curve 0x03"},
        {"r c11 c29", "5 ms too early"},
        {"r c01 w5 c11", "woken 115 ms too early"},
    };
    assert_streams(7, streams, LENGTH_OF(streams));
    static const stream gamma[] = {
        {"r cE0 d0102030405060708090A0B0C0D0E", NULL},
        {"r cE0 d0102030405060708090A0B0C0D0E0F", "command 0xE0 has 14 parameters"},
    };
    assert_streams(9, gamma, LENGTH_OF(gamma));
}

TEST(paper_streams)
{
    static const stream streams[] = {
        {"r c11 d03 c44 d0001 c45 d00000000 c4E d00 c4F d0000 c24 dA55A", NULL},
        {"r c11 d01 c44 d0001 c45 d01000000 c4E d00 c4F d0100 c24 dA55AA55A", NULL},
        {"r c12 c01", "command 0x01 10 ms too early"},
        {"r c24 dA5", "are not set in the window"},
        {"r c44 d0001 c45 d00000000 c24", "are not set in the window"},
        {"r c44 d0101 c45 d00000000 c4E d00 c4F d0000 c24", "are not set in the window"},
        {"r c44 d0016 c45 d00000000 c4E d00 c4F d0000 c24", "x addresses 0..22"},
        {"r c44 d0001 c45 d00002801 c4E d00 c4F d0000 c24", "y addresses 0..296"},
        {"r c44 d0100 c45 d00000000 c4E d00 c4F d0000 c24", "x addresses 1..0 in entry mode 3"},
        {"r c44 d0001 c45 d00000000 c4E d00 c4F d0000 c24 dA55A00", "past the end of the window"},
        {"r c45 d0000 c24", "command 0x45 has 4 parameters, not 2"},
        {"r c13", "unknown command 0x13"},
        {"r c21 d4080 c22 dC7 c20", "update sequence 0xC7"},
        {"r c22 dF7 c20", "the memory of the second colour"},
        {"r c21 d0080 c22 dFF c20", "the second memory is not what is shown in row 0"},
        {"r c21 d4080 c22 dFF c20", "a partial refresh without the second memory"},
        {"r c21 d4080 c22 dF7 c20 w1999 c22", "command 0x22 1 ms too early"},
        {"r c21 d4080 c22 dF7 c20 w2000 c22 dF7", NULL},
        {"r c01 d280100", "297 gates"},
        {"r c11 d08", "entry mode 0x08"},
    };
    assert_streams(6, streams, LENGTH_OF(streams));
}

TEST(memory_lcd_streams)
{
    static const stream streams[] = {
        {"r c00 d2000 c00 d8080 d112233445566778899AABBCC d0000 c00", NULL},
        {"r c00 d8080 d112233445566778899AABBCC d8040 d112233445566778899AABBCC d0000 c00", NULL},
        {"r d80", "has 0 parameters, not more"},
        {"r c00 d8080 d112233445566778899AABBCC c00", "line 1 ends without clocks"},
        {"r c00 d8040 d112233445566778899AABBCC d00 c00", "line 2 ends without clocks"},
        {"r c00 d8080 d1122 c00", "SCS falls in the middle of line 1"},
        {"r c00 d8000", "line 0 of 1..96"},
        {"r c00 d8086", "line 97 of 1..96"},
        {"r c00 d81", "mode 0x81"},
    };
    assert_streams(35, streams, LENGTH_OF(streams));
}

TEST(uc8151_streams)
{
    static const stream streams[] = {
        {"r w10 c91 c90 d08170000000001 c13 d1234", NULL},
        {"r w10 c91 c90 d080E0000000001 c13", "window 8..14, 0..0"},
        {"r w10 c12", "a refresh without power"},
        {"r w10 c04 w40 c91 c12", "a refresh of a part"},
        {"r w10 c04 c12", "40 ms too early"},
    };
    assert_streams(34, streams, LENGTH_OF(streams));
}

/* One step of a sequence, or a field, goes wrong: the simulated chip complains, or the picture is.
 */
typedef struct fault {
    int setup;
    int step;           /* replaced; -1: the field */
    qtri_panel_step by; /* command 0: left out */
    const char *error;  /* NULL: a wrong picture */
} fault;

static bool shows(setup *s)
{
    int32_t w = qtri_panel_width(&s->panel);
    int32_t h = qtri_panel_height(&s->panel);
    canvas whole = canvas_new(&qtri_rgb565, w, h);
    draw_picture(&whole.surface, 1);
    uint32_t *expected = picture_expected(&whole.surface, &s->panel);
    assert_ok(qtri_panel_write(&s->panel, &whole.surface));
    assert_ok(qtri_panel_finish(&s->panel));
    assert_ok(qtri_panel_refresh(&s->panel));
    bool same = true;
    for (int32_t i = 0; i < w * h && s->sim.chip.error[0] == '\0'; i++) {
        same = same && seen_at(s, s->panel.rotation, i % w, i / w) == expected[i];
    }
    free(expected);
    canvas_free(&whole);
    return same;
}

TEST(broken_sequences)
{
    static const fault faults[] = {
        {0, 2, {0xA8, 1, {31}, 0}, NULL}, /* half the rows */
        {0,
         2,
         {0xA8, 0, {0}, 0},
         "command 0xA8: parameter 0xD3"},                /* the next command is its parameter */
        {0, 3, {0xD3, 1, {8}, 0}, NULL},                 /* shifted */
        {0, 4, {0x48, 0, {0}, 0}, NULL},                 /* another start line */
        {0, 5, {0x8D, 1, {0x10}, 0}, NULL},              /* no charge pump: dark */
        {0, 6, {0, 0, {0}, 0}, "data without a window"}, /* page addressing */
        {0, 6, {0x20, 1, {1}, 0}, NULL},                 /* vertical addressing */
        {0, 7, {0xA0, 0, {0}, 0}, NULL},                 /* mirrored */
        {0, 8, {0xC0, 0, {0}, 0}, NULL},                 /* upside down */
        {0, 9, {0xDA, 1, {0x02}, 0}, NULL},              /* rows in another order */
        {0, 15, {0, 0, {0}, 0}, NULL},                   /* off */
        {0, 15, {0xFE, 0, {0}, 0}, "unknown command 0xFE"},
        {4, 3, {0xA0, 1, {0x50}, 0}, NULL}, /* halves of bytes swapped */
        {4, 3, {0xA0, 1, {0x42}, 0}, NULL}, /* upside down */
        {4, 3, {0xA0, 1, {0x53}, 0}, NULL}, /* mirrored */
        {4, 3, {0xA0, 1, {0x56}, 0}, NULL}, /* downwards */
        {4, 3, {0xA0, 1, {0x12}, 0}, NULL}, /* rows not split */
        {4, 5, {0xA2, 1, {0}, 0}, NULL},    /* shifted */
        {4, 13, {0xB8, 7, {0}, 0}, "unknown command 0x03"},
        {7, 11, {0, 0, {0}, 0}, "data in pixel format 0x66"},
        {7, 11, {0x3A, 2, {0x55, 0}, 0}, "command 0x3A has 1 parameters, not more"},
        {7, 11, {0x3A, 0, {0}, 0}, "command 0x3A has 1 parameters, not 0"},
        {7, 0, {0x01, 0, {0}, 10}, "woken 110 ms too early"},
        {7, 17, {0x11, 0, {0}, 0}, "5 ms too early"},
        {7, 17, {0, 0, {0}, 0}, NULL},                /* asleep */
        {7, 18, {0, 0, {0}, 0}, NULL},                /* off */
        {6, 0, {0x12, 0, {0}, 0}, "10 ms too early"}, /* does not wait */
        {6, 1, {0x01, 2, {249, 0}, 0}, "command 0x01 has 3 parameters, not 2"},
        {6, 1, {0x01, 3, {199, 0, 0}, 0}, NULL}, /* 200 rows */
        {6, 2, {0x11, 1, {0x01}, 0}, "y addresses 0..249 in entry mode 1"},
        {6, 2, {0x11, 1, {0x07}, 0}, NULL}, /* downwards */
        {6, 5, {0, 0, {0}, 0}, "the memory of the second colour"},
        {25, 2, {0, 0, {0}, 0}, "command 0xB4 is locked"},
        {26, 6, {0x3A, 1, {0x55}, 0}, "data in pixel format 0x55, only 18 bits"},
        {27, 1, {0, 0, {0}, 0}, "command 0xC0 is locked"},
        {28, 1, {0, 0, {0}, 0}, "command 0xB3 is locked"},
        {29, 4, {0x8D, 1, {0x14}, 0}, "there is no charge pump"},
        {30, 3, {0xA0, 1, {0x41}, 0}, NULL},       /* upside down */
        {30, 3, {0xA0, 1, {0x50}, 0}, NULL},       /* mirrored */
        {30, 3, {0xA0, 1, {0x53}, 0}, NULL},       /* halves of bytes swapped */
        {32, 6, {0xA0, 2, {0x10, 0x11}, 0}, NULL}, /* four pixels the other way round */
        {32, 6, {0xA0, 2, {0x04, 0x11}, 0}, NULL}, /* upside down */
        {32, 6, {0xA0, 2, {0x14, 0x01}, 0}, NULL}, /* one COM a row */
        {33, 1, {0x01, 3, {249, 0, 0}, 0}, "250 gates"},
        {34, 0, {0x00, 1, {0x1F}, QTRI_STEP_UNTIL_READY}, NULL}, /* 96 columns */
        {34, 2, {0x50, 1, {0x87}, 0}, NULL},                     /* negative */
        {36, 0, {0x01, 2, {0x21, 0}, 0}, "mode 0x21"},
        {39, 1, {0x80, 0, {0}, 0}, NULL}, /* no contrast */
        {39, 3, {0x12, 0, {0}, 0}, NULL}, /* another bias */
        {39, 4, {0x25, 0, {0}, 0}, "extended command 0x0D"},
        {39, 5, {0x24, 0, {0}, 0}, NULL}, /* asleep */
    };
    static setup s;
    for (size_t i = 0; i < LENGTH_OF(faults); i++) {
        setup_init(&s, faults[i].setup);
        qtri_panel_step steps[24];
        qtri_panel_description d = *s.description;
        size_t count = 0;
        for (size_t j = 0; j < d.init_count; j++) {
            bool here = (int)j == faults[i].step;
            if (!here || faults[i].by.command != 0) {
                steps[count++] = here ? faults[i].by : d.init[j];
            }
        }
        d.init = steps;
        d.init_count = count;
        s.description = &d;
        assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
        bool same = shows(&s);
        const char *error = s.sim.chip.error;
        if (faults[i].error == NULL ? error[0] != '\0' || same
                                    : strstr(error, faults[i].error) == NULL) {
            fail_msg("fault %d: \"%s\", %s picture", (int)i, error, same ? "right" : "wrong");
        }
        setup_end(&s);
    }
}

TEST(broken_fields)
{
    static setup s;
    for (int n = 0; n < 9; n++) {
        static const int setups[9] = {7, 7, 7, 7, 0, 4, 11, 6, 9};
        static const char *const errors[9] = {"command 0xCB has 5 parameters, not 0",
                                              NULL,
                                              NULL,
                                              "columns",
                                              "has 1 parameters, not 0",
                                              "has 1 parameters, not 0",
                                              NULL,
                                              "command 0x01 has 3 parameters, not 0",
                                              NULL};
        setup_init(&s, setups[n]);
        qtri_panel_description d = *s.description;
        switch (n) {
        case 1:
            d.orientation[0] = 0x08; /* mirrored */
            break;
        case 2:
            d.order = QTRI_ORDER_LITTLE;
            break;
        case 3:
            d.width = d.memory_width = 241;
            break;
        case 6:
            d.first_column = 0;
            break;
        case 8:
            d.inverted = false;
            break;
        default:
            d.parameters_are_data = !d.parameters_are_data;
            break;
        }
        s.description = &d;
        assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
        bool same = n == 3 ? false : true;
        if (n == 3) { /* the glass of the simulation is narrower than that */
            canvas whole = canvas_new(&qtri_rgb565, 241, 320);
            assert_ok(qtri_panel_write(&s.panel, &whole.surface));
            canvas_free(&whole);
        } else {
            same = shows(&s);
        }
        const char *error = s.sim.chip.error;
        if (errors[n] == NULL ? error[0] != '\0' || same : strstr(error, errors[n]) == NULL) {
            fail_msg("field %d: \"%s\", %s picture", n, error, same ? "right" : "wrong");
        }
        setup_end(&s);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
