/* SPDX-License-Identifier: MIT */
/*
 * Panels at their ends: calls that fail in the middle of what they send, descriptions that name
 * little, buses without all pins, surfaces of formats that no panel knows, glass of any size.
 */
#include "support/panel.h"

#include <qtri_port/completion.h>
#include <qtri_port/tearing.h>

/* ---- A bus that keeps the data that was sent ---- */

typedef struct recorder {
    uint8_t data[40000];
    size_t count;
    int commands, waits;
} recorder;

static bool record_command(void *context, const uint8_t *bytes, size_t count)
{
    recorder *r = (recorder *)context;
    (void)bytes;
    (void)count;
    r->commands++;
    return true;
}

static bool record_data(void *context, const uint8_t *bytes, size_t count)
{
    recorder *r = (recorder *)context;
    assert_true(r->count + count <= sizeof r->data);
    memcpy(r->data + r->count, bytes, count);
    r->count += count;
    return true;
}

static void record_wait(void *context, uint32_t ms)
{
    (void)ms;
    ((recorder *)context)->waits++;
}

static enum qtri_error any_window(const qtri_panel *panel, const qtri_rect *window)
{
    (void)panel;
    (void)window;
    return QTRI_OK;
}

static qtri_bus recording(recorder *r)
{
    const qtri_bus bus = {r, record_command, record_data, NULL, NULL, record_wait, NULL, NULL, 0};
    memset(r, 0, sizeof *r);
    return bus;
}

/* A description that names nothing but its size, its format and a window. */
static qtri_panel_description plain(int w, int h, qtri_panel_format format, qtri_byte_order order)
{
    const qtri_panel_description d = {.width = (uint16_t)w,
                                      .height = (uint16_t)h,
                                      .format = format,
                                      .order = order,
                                      .memory_width = (uint16_t)w,
                                      .memory_height = (uint16_t)h,
                                      .window = any_window,
                                      .write = format == QTRI_PANEL_RGB565 ? qtri_panel_write_565
                                                                           : qtri_panel_write_gray};
    return d;
}

/* ---- Failures ---- */

/* Writes three rows of bytes in pieces, shows them, writes and shows once more. */
static enum qtri_error use(setup *s)
{
    const int32_t w = qtri_panel_width(&s->panel), h = qtri_panel_height(&s->panel);
    const qtri_rect rect = {1, 0, w - 1, 24};
    canvas band = canvas_band(&qtri_rgb565, w, h, 0, 24);
    draw_picture(&band.surface, 3);
    enum qtri_error error = qtri_panel_write_rect(&s->panel, &band.surface, rect);
    error = error == QTRI_OK ? qtri_panel_write(&s->panel, &band.surface) : error;
    error = error == QTRI_OK ? qtri_panel_refresh(&s->panel) : error;
    error = error == QTRI_OK ? qtri_panel_write_rect(&s->panel, &band.surface, rect) : error;
    error = error == QTRI_OK ? qtri_panel_refresh_changes(&s->panel) : error;
    error = error == QTRI_OK ? qtri_panel_write_rect(&s->panel, &band.surface, rect) : error;
    error = error == QTRI_OK ? qtri_panel_refresh(&s->panel) : error;
    error = error == QTRI_OK ? qtri_panel_finish(&s->panel) : error;
    canvas_free(&band);
    return error;
}

/* Whichever call fails, it is the last one, with DMA and memory for little or for all. */
TEST(failures_in_the_middle)
{
    static const struct {
        int number;
        wiring how;
        bool most;
    } of[] = {{1, WIRE_DMA, false}, {5, WIRE_DMA, false}, {6, WIRE_DMA, true},
              {6, WIRE_SPI, true},  {15, WIRE_DMA, true}, {19, WIRE_DMA, false}};
    static setup s;
    for (size_t n = 0; n < LENGTH_OF(of); n++) {
        for (int fail = 0, calls = 1; fail < calls; fail += of[n].number == 6 ? 1 : 1 + fail / 90) {
            setup_init(&s, of[n].number);
            wire_init(&s.wire, &s.sim.chip, of[n].how);
            s.description = of[n].number == 6 ? &qtri_ssd1680_partial : s.description;
            s.wire.fail_at = fail; /* 0: none */
            enum qtri_error error = setup_start(&s, QTRI_ROTATE_0, of[n].most);
            error = error == QTRI_OK ? use(&s) : error;
            const bool reached = fail > 0 && s.wire.calls >= fail;
            assert_int_equal(error, reached ? QTRI_ERROR_BUS : QTRI_OK);
            assert_int_equal(reached ? fail : s.wire.calls, s.wire.calls);
            calls = fail == 0 ? s.wire.calls + 1 : calls;
            setup_end(&s);
        }
    }
}

/* RGB565 in its display's order, in rows that do not touch: each is a transfer that may fail, and
   so is each pixel of RGB666 where the memory has room for two. */
TEST(failures_between_rows)
{
    enum { ILI9488 = 26 };
    static setup s;
    for (int n = 0; n < 3; n++) {
        const qtri_format *const format = n == 0 ? &qtri_rgb565_swapped : &qtri_xrgb8888;
        for (int fail = 1, reached = 1; reached; fail++) {
            setup_init(&s, n < 2 ? 15 : ILI9488);
            assert_ok(setup_start(&s, QTRI_ROTATE_0, false));
            canvas band =
                canvas_band(format, qtri_panel_width(&s.panel), qtri_panel_height(&s.panel), 0, 4);
            const qtri_rect rect = {3, 0, 7, 4};
            const int before = s.wire.calls;
            s.wire.fail_at = before + fail;
            const enum qtri_error error = qtri_panel_write_rect(&s.panel, &band.surface, rect);
            reached = s.wire.calls >= s.wire.fail_at;
            assert_int_equal(error, reached ? QTRI_ERROR_BUS : QTRI_OK);
            assert_true(!reached || s.wire.calls == s.wire.fail_at);
            canvas_free(&band);
            setup_end(&s);
        }
    }
}

/* A display that lost its bus' end of a transfer does not wait for its line. */
TEST(tearing_after_a_failure)
{
    static setup s;
    setup_init(&s, 8);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    canvas whole = canvas_new(&qtri_rgb565_swapped, 240, 320);
    assert_ok(qtri_panel_write(&s.panel, &whole.surface));
    s.wire.fail_at = s.wire.calls + 1; /* what ends it */
    assert_int_equal(qtri_tearing_wait(&s.panel, NULL, 100), QTRI_ERROR_BUS);
    canvas_free(&whole);
    setup_end(&s);
}

/* ---- Descriptions ---- */

static bool rises(void *context)
{
    static int reads;
    assert_null(context);
    return ++reads % 2 == 0;
}

/* Bytes that are not there are too few, of every kind of display. */
TEST(no_panel_without_memory)
{
    static recorder r;
    const qtri_bus bus = recording(&r);
    const qtri_panel_description mapped =
        QTRI_FRAMEBUFFER(8, 8, QTRI_PANEL_RGB565, QTRI_ORDER_NATIVE);
    const qtri_panel_description *const all[] = {&mapped, &qtri_ssd1306, &qtri_ili9341,
                                                 &qtri_ssd1680};
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        qtri_panel panel;
        assert_int_equal(qtri_panel_init(&panel, all[i], &bus, QTRI_ROTATE_0, NULL, 1 << 20),
                         QTRI_ERROR_MEMORY);
        assert_int_equal(r.commands, 0);
        assert_int_equal(r.count, 0);
        canvas c = canvas_new(&qtri_rgb565, 8, 8);
        assert_int_equal(qtri_panel_write(&panel, &c.surface), QTRI_ERROR_SIZE);
        canvas_free(&c);
    }
}

/* Memory-mapped: nothing is sent, whatever bus there is; all that shows is shown. */
TEST(framebuffers_need_no_bus)
{
    enum { W = 70, H = 9 };
    static recorder r;
    static uint8_t memory[4 * W * H];
    const qtri_bus bus = recording(&r);
    const qtri_panel_description d = QTRI_FRAMEBUFFER(W, H, QTRI_PANEL_XRGB8888, QTRI_ORDER_NATIVE);
    for (int n = 0; n < 2; n++) {
        qtri_panel panel;
        assert_ok(qtri_panel_init(&panel, &d, n == 0 ? NULL : &bus, QTRI_ROTATE_0, memory,
                                  sizeof memory));
        canvas whole = canvas_new(&qtri_rgb565, W, H);
        draw_picture(&whole.surface, 4);
        memset(memory, 0, sizeof memory);
        assert_ok(qtri_panel_write(&panel, &whole.surface));
        for (int32_t i = 0; i < W * H; i++) { /* rows of more than one piece */
            uint32_t pixel;
            memcpy(&pixel, memory + 4 * i, 4);
            const qtri_rgb c = qtri_surface_pixel(&whole.surface, i % W, i / W);
            assert_int_equal(pixel, (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b);
        }
        assert_ok(qtri_panel_refresh(&panel));
        assert_ok(qtri_panel_refresh_changes(&panel));
        if (n == 0) {
            assert_ok(qtri_tearing_wait(&panel, rises, 4));
        }
        whole.surface.height--; /* of another frame */
        assert_int_equal(qtri_panel_write(&panel, &whole.surface), QTRI_ERROR_SIZE);
        canvas_free(&whole);
    }
    assert_int_equal(r.commands, 0);
    assert_int_equal(r.count, 0);
}

/* Without a sequence to begin with the glass is blank and nothing else is sent. */
TEST(descriptions_without_a_sequence)
{
    static recorder r;
    static uint8_t memory[200];
    static const qtri_panel_step steps[] = {QTRI_STEP_ALONE(0x29, 0)};
    for (int n = 0; n < 4; n++) {
        const qtri_bus bus = recording(&r);
        qtri_panel_description d = plain(10, 6, QTRI_PANEL_RGB565, QTRI_ORDER_BIG);
        qtri_panel panel;
        d.init = n & 1 ? steps : NULL;
        d.init_count = n & 2 ? 1 : 0;
        assert_ok(qtri_panel_init(&panel, &d, &bus, QTRI_ROTATE_0, memory, sizeof memory));
        assert_int_equal(r.commands, n == 3);
        assert_int_equal(r.count, 2 * 10 * 6);
    }
}

/* What cannot write is no panel. */
TEST(descriptions_that_do_not_write)
{
    static recorder r;
    static uint8_t memory[200];
    const qtri_bus bus = recording(&r);
    qtri_panel_description d = plain(10, 6, QTRI_PANEL_RGB565, QTRI_ORDER_BIG);
    qtri_panel panel;
    d.write = NULL;
    assert_int_equal(qtri_panel_init(&panel, &d, &bus, QTRI_ROTATE_0, memory, sizeof memory),
                     QTRI_ERROR_SIZE);
}

/* Memory for a pixel, for rows, and for more pixels than are converted at a time: the same bytes.
 */
TEST(any_memory_sends_the_same)
{
    enum { W = 10, H = 6, MOST = 6 * 9000 };
    static recorder r[3];
    static uint8_t memory[MOST];
    static const size_t bytes[3] = {QTRI_PANEL_LINE_BYTES(2), 8 * W, MOST};
    canvas whole = canvas_new(&qtri_xrgb8888, W, H);
    draw_picture(&whole.surface, 8);
    for (int n = 0; n < 3; n++) {
        const qtri_bus bus = recording(&r[n]);
        qtri_panel_description d = plain(W, H, QTRI_PANEL_RGB666, QTRI_ORDER_BIG);
        qtri_panel panel;
        d.write = qtri_panel_write_666;
        assert_ok(qtri_panel_init(&panel, &d, &bus, QTRI_ROTATE_0, memory, bytes[n]));
        assert_ok(qtri_panel_write(&panel, &whole.surface));
        assert_int_equal(r[n].count, 2 * 3 * W * H); /* black, then the picture */
        assert_memory_equal(r[n].data, r[0].data, r[0].count);
    }
    canvas_free(&whole);
}

/* The order of the machine, and of low bytes first, of surfaces that are converted. */
TEST(orders_of_converted_pixels)
{
    enum { W = 50, H = 7 };
    static const qtri_byte_order orders[3] = {QTRI_ORDER_BIG, QTRI_ORDER_LITTLE, QTRI_ORDER_NATIVE};
    static recorder r[3];
    uint8_t memory[44];
    const uint16_t one = 1;
    uint8_t low_first;
    memcpy(&low_first, &one, 1);
    for (int n = 0; n < 3; n++) {
        const qtri_bus bus = recording(&r[n]);
        const qtri_panel_description d = plain(W, H, QTRI_PANEL_RGB565, orders[n]);
        qtri_panel panel;
        assert_ok(qtri_panel_init(&panel, &d, &bus, QTRI_ROTATE_0, memory, sizeof memory));
        r[n].count = 0;
        canvas whole = canvas_new(&qtri_xrgb8888, W, H);
        draw_picture(&whole.surface, 4);
        assert_ok(qtri_panel_write(&panel, &whole.surface));
        assert_int_equal(r[n].count, 2 * W * H);
        canvas_free(&whole);
    }
    for (int i = 0; i < W * H; i++) {
        assert_int_equal(r[0].data[2 * i], r[1].data[2 * i + 1]);
        assert_int_equal(r[0].data[2 * i + 1], r[1].data[2 * i]);
    }
    assert_memory_equal(r[2].data, r[low_first == 1 ? 1 : 0].data, 2 * W * H);
}

/* Colours of 565 in pixels of four bytes: no row of theirs is one of the display's. */
TEST(formats_of_other_sizes)
{
    enum { W = 40, H = 8 };
    static const qtri_format *const of[2] = {&qtri_rgb565, &qtri_rgb565_swapped};
    static recorder r[2];
    static uint8_t memory[2][2 * W * H];
    uint8_t line[100];
    for (int f = 0; f < 2; f++) {
        for (int order = 0; order < 2; order++) {
            for (int n = 0; n < 2; n++) {
                const qtri_byte_order to = order == 0 ? QTRI_ORDER_BIG : QTRI_ORDER_LITTLE;
                const qtri_bus bus = recording(&r[n]);
                const qtri_panel_description d = plain(W, H, QTRI_PANEL_RGB565, to);
                const qtri_panel_description mapped = QTRI_FRAMEBUFFER(W, H, QTRI_PANEL_RGB565, to);
                qtri_format own = *of[f];
                qtri_panel panel;
                own.kind = QTRI_OTHER_FORMAT;
                own.pixels = n == 0 ? own.pixels : &qtri_pixels_32;
                canvas whole = canvas_new(&own, W, H);
                draw_picture(&whole.surface, 9);
                assert_ok(qtri_panel_init(&panel, &d, &bus, QTRI_ROTATE_0, line, sizeof line));
                r[n].count = 0;
                assert_ok(qtri_panel_write(&panel, &whole.surface));
                assert_ok(qtri_panel_init(&panel, &mapped, NULL, QTRI_ROTATE_0, memory[n],
                                          sizeof memory[n]));
                assert_ok(qtri_panel_write(&panel, &whole.surface));
                canvas_free(&whole);
            }
            assert_int_equal(r[0].count, r[1].count);
            assert_memory_equal(r[0].data, r[1].data, 2 * W * H);
            assert_memory_equal(memory[0], memory[1], sizeof memory[0]);
        }
    }
}

/* Formats that are none are no panel's, with any memory; orders that are none send high bytes
   first, of surfaces that are converted or not. */
TEST(numbers_that_are_no_format_or_order)
{
    enum { W = 12, H = 8 };
    static const uint32_t numbers[4] = {6, 66, 255, 0x80000001u};
    static const qtri_panel_step steps[] = {QTRI_STEP_ALONE(0x29, 0)};
    static const qtri_panel_partial partial = {steps, 1, NULL};
    static const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_rgb565_swapped,
                                                  &qtri_xrgb8888};
    static recorder r[2];
    static uint8_t memory[2][4 * W * H], line[4 * W * H];
    for (int n = 0; n < 4 * 3; n++) {
        const qtri_byte_order order = (qtri_byte_order)numbers[n % 4];
        const qtri_panel_format format = (qtri_panel_format)numbers[n % 4];
        const qtri_bus bus = recording(&r[0]);
        qtri_panel panel;
        for (int i = 0; i < 3; i++) {
            qtri_panel_description d = plain(W, H, format, QTRI_ORDER_BIG);
            d.window = i == 0 ? NULL : any_window;
            d.partial = i == 2 ? &partial : NULL;
            assert_int_equal(qtri_panel_init(&panel, &d, &bus, QTRI_ROTATE_0, line, sizeof line),
                             QTRI_ERROR_SIZE);
        }
        canvas whole = canvas_new(formats[n / 4], W, H);
        draw_picture(&whole.surface, 9);
        for (int i = 0; i < 2; i++) {
            const qtri_byte_order to = i == 0 ? QTRI_ORDER_BIG : order;
            const qtri_bus other = recording(&r[i]);
            const qtri_panel_description d = plain(W, H, QTRI_PANEL_RGB565, to);
            const qtri_panel_description mapped = QTRI_FRAMEBUFFER(W, H, QTRI_PANEL_RGB565, to);
            assert_ok(qtri_panel_init(&panel, &d, &other, QTRI_ROTATE_0, line, sizeof line));
            r[i].count = 0;
            assert_ok(qtri_panel_write(&panel, &whole.surface));
            assert_ok(
                qtri_panel_init(&panel, &mapped, NULL, QTRI_ROTATE_0, memory[i], sizeof memory[i]));
            assert_ok(qtri_panel_write(&panel, &whole.surface));
        }
        assert_int_equal(r[0].count, r[1].count);
        assert_memory_equal(r[0].data, r[1].data, 2 * W * H);
        assert_memory_equal(memory[0], memory[1], 2 * W * H);
        canvas_free(&whole);
    }
}

/* A controller of gray that mirrors itself: the same bytes for a mirrored module, with an image
   and without. */
TEST(gray_that_mirrors_itself)
{
    enum { W = 32, H = 16, ROW = W / 2 };
    static recorder r;
    static uint8_t memory[ROW * H], want[ROW * H];
    canvas whole = canvas_new(&qtri_gray8, W, H);
    draw_picture(&whole.surface, 8);
    for (int n = 0; n < 8; n++) {
        const qtri_bus bus = recording(&r);
        qtri_panel_description d = plain(W, H, QTRI_PANEL_GRAY4, QTRI_ORDER_BIG);
        qtri_module module = {0};
        qtri_panel panel;
        d.orientation_command = 0x36;
        module.mirror_columns = (n & 1) != 0;
        module.mirror_rows = (n & 2) != 0;
        assert_ok(qtri_panel_init_module(&panel, &d, &module, &bus, QTRI_ROTATE_0, memory,
                                         n & 4 ? sizeof memory : ROW));
        assert_int_equal(r.commands, 1);
        r.count = 0;
        assert_ok(qtri_panel_write(&panel, &whole.surface));
        assert_int_equal(r.count, sizeof want);
        if (n == 0) {
            memcpy(want, r.data, sizeof want);
        }
        assert_memory_equal(want, r.data, sizeof want);
    }
    canvas_free(&whole);
}

/* ---- Buses ---- */

static void count_done(void *context)
{
    ++*(int *)context;
}

/* Pins go through what tells when all was sent: an e-paper is reset and waited for. */
TEST(completion_passes_pins)
{
    static setup s;
    for (int n = 0; n < 2; n++) {
        qtri_completion completion;
        int done = 0;
        setup_init(&s, 6);
        wire_init(&s.wire, &s.sim.chip, n == 0 ? WIRE_SPI : WIRE_DMA);
        const qtri_bus *const bus =
            qtri_completion_init(&completion, &s.wire.bus, count_done, &done);
        const size_t bytes = memory_bytes(s.description, true);
        s.memory = (uint8_t *)malloc(bytes);
        assert_non_null(s.memory);
        assert_ok(qtri_panel_init(&s.panel, s.description, bus, QTRI_ROTATE_0, s.memory, bytes));
        canvas whole =
            canvas_new(&qtri_gray8, qtri_panel_width(&s.panel), qtri_panel_height(&s.panel));
        draw_picture(&whole.surface, 5);
        assert_ok(qtri_panel_write(&s.panel, &whole.surface));
        assert_ok(qtri_panel_refresh(&s.panel));
        uint32_t *expected = picture_expected(&whole.surface, &s.panel);
        assert_seen(&s, expected);
        free(expected);
        s.wire.stuck = true; /* BUSY is asked through it */
        assert_int_equal(qtri_panel_refresh(&s.panel), QTRI_ERROR_BUS);
        canvas_free(&whole);
        setup_end(&s);
    }
}

/* I2C modules without a reset pin. */
TEST(i2c_without_reset)
{
    static setup s;
    setup_init(&s, 2);
    s.wire.i2c.reset = NULL;
    assert_ok(qtri_i2c_bus(&s.wire.bus, &s.wire.i2c));
    assert_null(s.wire.bus.reset);
    chip_reset_pin(&s.sim.chip, true); /* what the module does when it gets its supply */
    chip_reset_pin(&s.sim.chip, false);
    assert_ok(setup_start(&s, QTRI_ROTATE_0, true));
    assert_chip_content(&s.sim.chip);
    setup_end(&s);
}

/*
 * Glass of other sizes behind the same controller. Its memory is exactly the image, so the address
 * sanitizer sees a byte too many that is read; every row is told, or the controller complains.
 */
TEST(changes_alone_of_any_size)
{
    static const struct {
        uint16_t width, height, column, row;
    } glass[] = {{104, 212, 0, 0}, {128, 296, 0, 0},  {176, 296, 0, 0}, {80, 128, 8, 40},
                 {1, 1, 0, 0},     {121, 255, 48, 9}, {9, 296, 16, 0},  {176, 2, 0, 294}};
    static setup s;
    for (size_t n = 0; n < LENGTH_OF(glass) * 8; n++) {
        const int i = (int)n / 8;
        const int32_t w = glass[i].width, h = glass[i].height;
        qtri_panel_description d = qtri_ssd1680_partial;
        qtri_panel_step init[8];
        assert_true(d.init_count <= LENGTH_OF(init) && d.init[1].command == 0x01);
        memcpy(init, d.init, d.init_count * sizeof init[0]);
        init[1].parameters[0] = (uint8_t)(h - 1);
        init[1].parameters[1] = (uint8_t)((h - 1) >> 8);
        d.init = init;
        d.width = glass[i].width;
        d.height = glass[i].height;
        d.first_column = glass[i].column;
        d.first_row = glass[i].row;

        setup_init(&s, 6);
        wire_init(&s.wire, &s.sim.chip, n % 8 < 4 ? WIRE_SPI : WIRE_DMA);
        s.description = &d;
        s.sim.ssd1680.width = w;
        s.sim.ssd1680.height = h;
        s.sim.ssd1680.first_column = glass[i].column;
        s.sim.ssd1680.first_row = glass[i].row;
        assert_ok(setup_start(&s, (qtri_rotation)(n % 4), true));
        const size_t bytes = QTRI_PANEL_IMAGE_BYTES(w, h, QTRI_PANEL_GRAY1);
        for (uint64_t k = 0; k < 3; k++) {
            canvas whole =
                canvas_new(&qtri_gray8, qtri_panel_width(&s.panel), qtri_panel_height(&s.panel));
            draw_picture(&whole.surface, 3 + k);
            uint32_t *expected = picture_expected(&whole.surface, &s.panel);
            assert_ok(qtri_panel_write(&s.panel, &whole.surface));
            assert_ok(qtri_panel_finish(&s.panel));
            const size_t before = s.wire.data_bytes;
            assert_ok(qtri_panel_refresh_changes(&s.panel));
            /* Parameters besides: one byte of a refresh or seven of one of changes, nine of the
               window. */
            assert_int_equal(s.wire.data_bytes - before, bytes + 9 + (k == 0 ? 1 : 7));
            assert_seen(&s, expected);
            free(expected);
            canvas_free(&whole);
        }
        assert_int_equal(s.sim.ssd1680.refreshes, 1);
        assert_int_equal(s.sim.ssd1680.partial_refreshes, 2);
        setup_end(&s);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
