/* SPDX-License-Identifier: MIT */
/*
 * Modules that differ from the description of their display: where the glass lies in the memory,
 * how it is mounted and wired; what a bus and a step may be; how much of a transfer drawing hides.
 */
#include "support/panel.h"

#include <qtri_port/completion.h>
#include <qtri_port/tearing.h>

static enum qtri_error start_module(setup *s, const qtri_module *module, qtri_rotation rotation,
                                    bool most)
{
    size_t bytes = memory_bytes(s->description, most);
    s->memory = (uint8_t *)malloc(bytes);
    assert_non_null(s->memory);
    return qtri_panel_init_module(&s->panel, s->description, module, &s->wire.bus, rotation,
                                  s->memory, bytes);
}

static void assert_shows(setup *s, int32_t rows)
{
    int32_t w = qtri_panel_width(&s->panel);
    int32_t h = qtri_panel_height(&s->panel);
    canvas whole = canvas_new(&qtri_rgb565, w, h);
    draw_picture(&whole.surface, 5);
    uint32_t *expected = picture_expected(&whole.surface, &s->panel);
    for (int32_t first = 0; first < h; first += rows) {
        canvas band = canvas_band(&qtri_rgb565, w, h, first, rows);
        draw_picture(&band.surface, 5);
        assert_ok(qtri_panel_write(&s->panel, &band.surface));
        assert_ok(qtri_panel_finish(&s->panel));
        canvas_free(&band);
    }
    assert_ok(qtri_panel_refresh(&s->panel));
    assert_seen(s, expected);
    free(expected);
    canvas_free(&whole);
}

/* Glass that does not begin with the memory, at a place that the description or the module says. */
TEST(offsets)
{
    static setup s;
    for (int n = 0; n < 4 * 3 * 2; n++) {
        qtri_module module = {false, false, false, false, 0, 0};
        bool by_module = n % 2 != 0;
        qtri_rotation rotation = (qtri_rotation)(n / 2 % 4);
        static const int numbers[3] = {17, 4, 6}; /* SSD1306, SSD0323, SSD1680 */
        static const int16_t columns[3] = {28, 0, 16};
        static const int16_t rows[3] = {0, 16, 40};
        int which = n / 8;
        setup_init(&s, numbers[which]);
        qtri_panel_description d = *s.description;
        d.first_column = (uint16_t)(by_module ? 0 : columns[which]);
        d.first_row = (uint16_t)(by_module ? 0 : rows[which]);
        module.column = (int16_t)(by_module ? columns[which] : 0);
        module.row = (int16_t)(by_module ? rows[which] : 0);
        s.description = &d;
        if (which == 1) { /* the chip shows those rows where it begins with them */
            s.sim.ssd0323.first_row = 16;
        } else if (which == 2) {
            s.sim.ssd1680.first_column = 16;
            s.sim.ssd1680.first_row = 40;
        }
        assert_ok(start_module(&s, &module, rotation, true));
        assert_shows(&s, qtri_panel_height(&s.panel));
        assert_shows(&s, 7);
        setup_end(&s);
    }
}

/* Outside the memory, or inside of a byte: refused, and nothing is sent. */
TEST(bad_offsets)
{
    static const struct {
        int setup;
        int16_t column, row;
    } cases[] = {{17, 29, 0}, {17, -29, 0}, {0, 1, 0},   {0, 0, 1},   {3, 0, 4},  {4, 1, 0},
                 {4, 0, 17},  {6, 4, 0},    {6, 56, 0},  {6, 0, 47},  {18, 3, 0}, {18, -3, 0},
                 {18, 0, -8}, {9, 1, 0},    {11, 54, 0}, {11, 0, -41}};
    static setup s;
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        setup_init(&s, cases[i].setup);
        qtri_module module = {false, false, false, false, cases[i].column, cases[i].row};
        assert_int_equal(start_module(&s, &module, QTRI_ROTATE_0, true), QTRI_ERROR_SIZE);
        assert_int_equal(s.wire.calls, 0);
        setup_end(&s);
    }
}

/* A module that is mirrored, wired blue first or normally white shows the picture all the same. */
TEST(mounted_otherwise)
{
    static setup s;
    for (int n = 0; n < SETUPS * 4; n++) {
        for (int how = 0; how < 4; how++) {
            setup_init(&s, n / 4);
            qtri_module module = {false, false, false, false, 0, 0};
            bool is_lcd = s.description->orientation_command != 0;
            module.mirror_columns = (how & 1) != 0;
            module.mirror_rows = (how & 2) != 0;
            module.swap_red_blue = is_lcd && how == 1;
            module.invert = is_lcd && how == 2;
            assert_ok(start_module(&s, &module, (qtri_rotation)(n % 4), true));
            if (is_lcd) {
                lcd_glass *g = setup_glass(&s);
                g->blue_first ^= module.swap_red_blue;
                g->normally_black ^= module.invert;
                g->columns_from_right ^= module.mirror_columns;
                g->rows_from_bottom ^= module.mirror_rows;
                assert_shows(&s, 33);
            } else { /* the glass of the simulated chip stays: what it shows is mirrored */
                int32_t w = qtri_panel_width(&s.panel);
                int32_t h = qtri_panel_height(&s.panel);
                bool turned = n % 2 != 0;
                canvas whole = canvas_new(&qtri_rgb565, w, h);
                draw_picture(&whole.surface, 5);
                uint32_t *expected = picture_expected(&whole.surface, &s.panel);
                assert_ok(qtri_panel_write(&s.panel, &whole.surface));
                assert_ok(qtri_panel_finish(&s.panel));
                assert_ok(qtri_panel_refresh(&s.panel));
                assert_chip_content(&s.sim.chip);
                bool across = turned ? module.mirror_rows : module.mirror_columns;
                bool down = turned ? module.mirror_columns : module.mirror_rows;
                for (int32_t i = 0; i < w * h; i++) {
                    int32_t x = across ? w - 1 - i % w : i % w;
                    int32_t y = down ? h - 1 - i / w : i / w;
                    assert_int_equal(seen_at(&s, s.panel.rotation, x, y), expected[i]);
                }
                free(expected);
                canvas_free(&whole);
            }
            setup_end(&s);
        }
    }
}

/* Rectangles of a mirrored panel whose memory holds a row only: from_glass is to_glass's inverse.
 */
TEST(mirrored_rows)
{
    static setup s;
    static const int numbers[3] = {0, 4, 18};
    for (int n = 0; n < 3 * 16; n++) {
        setup_init(&s, numbers[n / 16]);
        qtri_module module = {false, false, (n & 1) != 0, (n & 2) != 0, 0, 0};
        assert_ok(start_module(&s, &module, (qtri_rotation)(n / 4 % 4), false));
        qtri_module none = {false, false, false, false, 0, 0};
        int32_t w = qtri_panel_width(&s.panel);
        int32_t h = qtri_panel_height(&s.panel);
        canvas whole = canvas_new(&qtri_rgb565, w, h);
        draw_picture(&whole.surface, 9);
        qtri_rect rect = {8, 16, 40, 32};
        assert_ok(qtri_panel_write_rect(&s.panel, &whole.surface, rect));
        assert_chip_content(&s.sim.chip);
        uint32_t *few = (uint32_t *)malloc((size_t)w * (size_t)h * sizeof *few);
        assert_non_null(few);
        for (int32_t i = 0; i < w * h; i++) {
            few[i] = seen_at(&s, s.panel.rotation, i % w, i / w);
        }
        setup_end(&s);
        setup_init(&s, numbers[n / 16]);
        assert_ok(
            start_module(&s, (n & 3) != 0 ? &module : &none, (qtri_rotation)(n / 4 % 4), true));
        assert_ok(qtri_panel_write_rect(&s.panel, &whole.surface, rect));
        assert_seen(&s, few);
        free(few);
        canvas_free(&whole);
        setup_end(&s);
    }
}

/* What a display cannot do for a module is said, not left out. */
TEST(cannot)
{
    static setup s;
    qtri_module red = {true, false, false, false, 0, 0};
    qtri_module white = {false, true, false, false, 0, 0};
    setup_init(&s, 0);
    assert_int_equal(start_module(&s, &red, QTRI_ROTATE_0, true), QTRI_ERROR_SIZE);
    setup_end(&s);
    setup_init(&s, 6);
    assert_int_equal(start_module(&s, &white, QTRI_ROTATE_0, true), QTRI_ERROR_SIZE);
    setup_end(&s);
    setup_init(&s, 0);
    assert_ok(start_module(&s, &white, QTRI_ROTATE_0, true));
    assert_true(s.sim.ssd1306.drive.inverse);
    setup_end(&s);
}

/* More parameters than a step holds: an error, and not a command that lacks some. */
TEST(too_many_parameters)
{
    static setup s;
    static const qtri_panel_step counted[] = {
        QTRI_STEP_ALONE(0x11, 5), QTRI_STEP(0x3A, 7, 0x55), QTRI_STEP(0x2A, 0, 0, 0, 0, 239),
        QTRI_STEP(0xE0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15)};
    assert_int_equal(counted[0].count, 0);
    assert_int_equal(counted[0].wait_ms, 5);
    assert_int_equal(counted[1].count, 1);
    assert_int_equal(counted[1].wait_ms, 7);
    assert_int_equal(counted[2].count, 4);
    assert_int_equal(counted[2].parameters[3], 239);
    assert_int_equal(counted[3].count, 15);
    setup_init(&s, 7);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    int calls = s.wire.calls;
    qtri_panel_step step = {0xE0, QTRI_STEP_PARAMETERS + 1, {0}, 0};
    assert_int_equal(qtri_panel_send(&s.panel, &step, 1), QTRI_ERROR_SIZE);
    assert_int_equal(s.wire.calls, calls);
    setup_end(&s);
}

/* A bus that takes so many bytes at once: the same pixels, in pieces. */
TEST(split_transfers)
{
    static setup s;
    for (int n = 0; n < SETUPS; n++) {
        setup_init(&s, n);
        s.wire.bus.most_bytes = 62;
        s.wire.most_bytes = 62;
        assert_ok(setup_start(&s, QTRI_ROTATE_90, true));
        assert_shows(&s, qtri_panel_height(&s.panel));
        setup_end(&s);
    }
}

/* A bus with a clock: a byte takes a tick, and waiting for its end is what drawing does not hide.
 */
typedef struct clocked {
    uint64_t now, end, waited, sent;
    const uint8_t *bytes;
} clocked;

static bool clocked_send(void *context, const uint8_t *bytes, size_t count)
{
    clocked *c = (clocked *)context;
    (void)bytes;
    c->now += count;
    c->waited += count;
    c->sent += count;
    return true;
}

static bool clocked_start(void *context, const uint8_t *bytes, size_t count)
{
    clocked *c = (clocked *)context;
    assert_true(c->end <= c->now);
    c->bytes = bytes;
    c->end = c->now + count;
    c->sent += count;
    return true;
}

static bool clocked_finish(void *context)
{
    clocked *c = (clocked *)context;
    c->waited += c->end > c->now ? c->end - c->now : 0;
    c->now = c->end > c->now ? c->end : c->now;
    c->bytes = NULL;
    return true;
}

static void clocked_wait(void *context, uint32_t ms)
{
    (void)context;
    (void)ms;
}

/*
 * Two bands in turn of the display's own byte order: where drawing a band takes as long as sending
 * it, at least 95 % of the transfers are hidden. Bands in native order are copied into line
 * buffers.
 */
TEST(hidden)
{
    enum { W = 320, H = 240, ROWS = 16 };
    static uint8_t memory[QTRI_FRAME_BYTES_DOUBLE(W, ROWS, QTRI_RGB565_BYTES)];
    static uint8_t line[QTRI_PANEL_LINE_BYTES(W)];
    clocked clock = {0, 0, 0, 0, NULL};
    qtri_bus bus = {&clock,        clocked_send,   clocked_send,
                    clocked_start, clocked_finish, clocked_wait,
                    NULL,          NULL,           0};
    qtri_panel panel;
    qtri_frame frame;
    qtri_surface band;
    assert_ok(qtri_panel_init(&panel, &qtri_ili9341, &bus, QTRI_ROTATE_90, line, sizeof line));
    assert_ok(qtri_frame_init(&frame, &qtri_rgb565_swapped, W, H, ROWS, memory, sizeof memory));
    clock.waited = clock.sent = 0;
    for (int i = 0; i < 3; i++) {
        while (qtri_frame_next_band(&frame, &band)) {
            /* What is on its way is the other band. */
            assert_true(clock.bytes == NULL ||
                        clock.bytes + band.width * 2 * band.rows <= band.pixels ||
                        clock.bytes >= band.pixels + band.width * 2 * band.rows);
            clock.now += (uint64_t)band.width * 2 * (uint64_t)band.rows; /* drawing */
            assert_ok(qtri_panel_write(&panel, &band));
        }
    }
    assert_int_equal(clock.sent / 3, W * H * 2 + H / ROWS * 11);
    print_message("hidden: %.2f %% of %d bytes\n",
                  100.0 * (1.0 - (double)clock.waited / (double)clock.sent), (int)clock.sent);
    assert_true((double)clock.waited <= .05 * (double)clock.sent);
    assert_ok(qtri_panel_finish(&panel));
}

/*
 * E-paper that refreshes changes alone: it shows what a refresh of everything would, in a fifth of
 * the time, and the first refresh of all is one of everything, whatever was asked for. The
 * simulated controller compares what it is told with what it shows.
 */
TEST(changes_alone)
{
    static setup s;
    for (int rotation = 0; rotation < 4; rotation++) {
        setup_init(&s, 6);
        s.description = &qtri_ssd1680_partial;
        assert_int_equal(setup_start(&s, (qtri_rotation)rotation, false), QTRI_ERROR_MEMORY);
        assert_ok(setup_start(&s, (qtri_rotation)rotation, true));
        int32_t w = qtri_panel_width(&s.panel), h = qtri_panel_height(&s.panel);
        canvas whole = canvas_new(&qtri_gray8, w, h);
        draw_picture(&whole.surface, 3);
        assert_ok(qtri_panel_write(&s.panel, &whole.surface));
        assert_ok(qtri_panel_refresh_changes(&s.panel));
        assert_int_equal(s.sim.ssd1680.refreshes, 1);
        for (int i = 0; i < 3; i++) {
            qtri_rect rect = {8 + 9 * i, 16, 40 + 9 * i, 33};
            whole.surface.scissor = rect;
            qtri_rgb gray = {(uint8_t)(70 * i), 0, 90};
            qtri_surface_clear(&whole.surface, gray);
            assert_ok(qtri_panel_write_rect(&s.panel, &whole.surface, rect));
            uint64_t before = s.sim.chip.now_ms;
            assert_ok(qtri_panel_refresh_changes(&s.panel));
            assert_true(s.sim.chip.now_ms - before <= 400);
            uint32_t *expected = picture_expected(&whole.surface, &s.panel);
            assert_seen(&s, expected);
            free(expected);
        }
        assert_int_equal(s.sim.ssd1680.refreshes, 1);
        assert_int_equal(s.sim.ssd1680.partial_refreshes, 3);
        assert_ok(qtri_panel_refresh(&s.panel));
        assert_int_equal(s.sim.ssd1680.refreshes, 2);
        assert_ok(qtri_panel_refresh_changes(&s.panel));
        assert_int_equal(s.sim.ssd1680.partial_refreshes, 4);
        assert_chip_content(&s.sim.chip);

        /* After one that failed the controller may show anything: everything again. */
        s.wire.fail_at = s.wire.calls + 3;
        assert_int_equal(qtri_panel_refresh_changes(&s.panel), QTRI_ERROR_BUS);
        s.wire.fail_at = 0;
        assert_ok(qtri_panel_refresh_changes(&s.panel));
        assert_int_equal(s.sim.ssd1680.refreshes, 3);
        canvas_free(&whole);
        setup_end(&s);
    }
    /* Displays without it: as a refresh, here of nothing. */
    setup_init(&s, 7);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    int calls = s.wire.calls;
    assert_ok(qtri_panel_refresh_changes(&s.panel));
    assert_int_equal(s.wire.calls, calls);
    setup_end(&s);
}

/* A DMA whose interrupt comes at the n-th access to the bus, counted from its start. */
typedef struct interrupted {
    qtri_completion completion;
    qtri_bus bus;
    int calls, due, done, starts;
    bool flying;
} interrupted;

static void interrupt_if_due(interrupted *it)
{
    if (it->flying && it->calls++ >= it->due) {
        it->flying = false;
        qtri_completion_sent(&it->completion);
    }
}

static bool interrupted_send(void *context, const uint8_t *bytes, size_t count)
{
    interrupted *it = (interrupted *)context;
    (void)bytes;
    (void)count;
    assert_false(it->flying);
    return true;
}

static bool interrupted_start(void *context, const uint8_t *bytes, size_t count)
{
    interrupted *it = (interrupted *)context;
    (void)bytes;
    (void)count;
    assert_false(it->flying);
    it->flying = true;
    it->calls = 0;
    it->starts++;
    interrupt_if_due(it);
    return true;
}

static bool interrupted_finish(void *context)
{
    interrupted *it = (interrupted *)context;
    while (it->flying) {
        interrupt_if_due(it);
    }
    return true;
}

static void interrupted_wait(void *context, uint32_t ms)
{
    (void)context;
    (void)ms;
}

static void count_done(void *context)
{
    interrupted *it = (interrupted *)context;
    assert_false(it->flying);
    assert_int_equal(it->completion.sent, it->completion.started);
    it->done++;
}

static bool refuse(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    (void)bytes;
    (void)count;
    return false;
}

/* One call for each request, when the last of all transfers is over; none without a request. */
TEST(completion)
{
    enum { W = 24, ROWS = 8 };
    static uint8_t line[QTRI_PANEL_LINE_BYTES(240)];
    for (int n = 0; n < 8; n++) {
        bool by_dma = n % 2 == 0;
        interrupted it;
        memset(&it, 0, sizeof it);
        qtri_bus bus = {&it,
                        interrupted_send,
                        interrupted_send,
                        by_dma ? interrupted_start : NULL,
                        by_dma ? interrupted_finish : NULL,
                        interrupted_wait,
                        NULL,
                        NULL,
                        100};
        it.bus = bus;
        it.due = n / 2;
        const qtri_bus *watched = qtri_completion_init(&it.completion, &it.bus, count_done, &it);
        qtri_panel panel;
        assert_ok(
            qtri_panel_init(&panel, &qtri_ili9341, watched, QTRI_ROTATE_0, line, sizeof line));
        canvas band = canvas_new(&qtri_rgb565, 240, 320);
        int before = it.starts;
        assert_int_equal(it.done, 0);
        for (int i = 1; i <= 3; i++) {
            qtri_rect rect = {0, 0, W * i, ROWS};
            assert_ok(qtri_panel_write_rect(&panel, &band.surface, rect));
            qtri_completion_notify(&it.completion);
            assert_ok(qtri_panel_finish(&panel));
            assert_int_equal(it.done, i);
        }
        assert_true(by_dma ? it.starts >= before + 3 * 4 : it.starts == 0);
        qtri_rect rect = {0, 0, W, ROWS};
        assert_ok(qtri_panel_write_rect(&panel, &band.surface, rect));
        assert_ok(qtri_panel_finish(&panel));
        assert_int_equal(it.done, 3);
        if (by_dma) { /* what did not start is not waited for */
            it.bus.data_start = refuse;
            assert_int_equal(qtri_panel_write_rect(&panel, &band.surface, rect), QTRI_ERROR_BUS);
            qtri_completion_notify(&it.completion);
            assert_int_equal(it.done, 4);
        }
        canvas_free(&band);
    }
}

/* Levels of the pin, one a read; '1' is high. */
typedef struct te_pin {
    const char *levels;
    uint32_t reads;
} te_pin;

static te_pin te;

static bool te_is_high(void *context)
{
    assert_true(context == NULL || ((const wire *)context)->sending == NULL);
    return te.levels[te.reads++] == '1';
}

TEST(tearing)
{
    static const struct {
        const char *levels;
        uint32_t most, reads;
        enum qtri_error error;
    } cases[] = {{"0001", 9, 4, QTRI_OK},         {"1101", 9, 4, QTRI_OK},
                 {"11111", 5, 5, QTRI_ERROR_BUS}, {"00000", 5, 5, QTRI_ERROR_BUS},
                 {"1", 0, 0, QTRI_ERROR_BUS},     {"01", 2, 2, QTRI_OK}};
    static setup s;
    setup_init(&s, 8); /* by DMA */
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    assert_ok(qtri_tearing_on(&s.panel));
    canvas whole = canvas_new(&qtri_rgb565, 240, 320);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_ok(qtri_panel_write(&s.panel, &whole.surface));
        te.levels = cases[i].levels;
        te.reads = 0;
        assert_int_equal(qtri_tearing_wait(&s.panel, te_is_high, cases[i].most), cases[i].error);
        assert_int_equal(te.reads, cases[i].reads);
        assert_null(s.wire.sending);
    }
    assert_chip_content(&s.sim.chip);
    canvas_free(&whole);
    setup_end(&s);
    setup_init(&s, 0);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    int calls = s.wire.calls;
    assert_int_equal(qtri_tearing_on(&s.panel), QTRI_ERROR_SIZE);
    assert_int_equal(s.wire.calls, calls);
    setup_end(&s);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
