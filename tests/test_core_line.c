/*
 * Lines: the rule of raster.h exactly, both directions, chains, pictures, values along them.
 */
#include "support_core.h"
#include "support_line_narrow.h"

#include "raster/line_path.h"

enum { WIDTH = 44, HEIGHT = 38 };

typedef struct point {
    int32_t x, y;
} point;

static void draw(const qtri_surface *s, point a, point b)
{
    qtri_material material = plain_material();
    qtri_screen_vertex v[2] = {screen_at(a.x, a.y), screen_at(b.x, b.y)};
    qtri_raster_line(s, &material, v);
}

static int32_t distance(int32_t a, int32_t b)
{
    return a > b ? a - b : b - a;
}

/* The pixel is the one that the line passes through at the centre of its column (row). */
static bool on_line(point a, point b, int32_t x, int32_t y)
{
    bool steep = distance(a.y, b.y) > distance(a.x, b.x);
    int32_t from = steep ? a.y : a.x;
    int32_t to = steep ? b.y : b.x;
    int32_t centre = (steep ? y : x) * 256 + 128;
    if (!(from < to ? centre >= from && centre < to : centre >= to && centre < from)) {
        return false;
    }
    int32_t other = steep ? a.x : a.y;
    int32_t change = steep ? b.x - a.x : b.y - a.y;
    int128 position = floor_div((int128)other * (to - from) + (int128)change * (centre - from),
                                (int128)256 * (to - from));
    if (from > to) {
        position = floor_div((int128)other * (from - to) - (int128)change * (centre - from),
                             (int128)256 * (from - to));
    }
    return position == (steep ? x : y);
}

static point random_point(uint64_t *seed, int32_t reach)
{
    point p = {random_in(seed, WIDTH * 128 - reach, WIDTH * 128 + reach),
               random_in(seed, HEIGHT * 128 - reach, HEIGHT * 128 + reach)};
    if (random_in(seed, 0, 3) == 0) {
        p.x &= ~127;
        p.y &= ~127;
    }
    return p;
}

static void check_line(canvas *c, point a, point b)
{
    for (int turn = 0; turn < 2; turn++) {
        canvas_clear(c);
        draw(&c->surface, turn ? b : a, turn ? a : b);
        for (int32_t y = 0; y < HEIGHT; y++) {
            for (int32_t x = 0; x < WIDTH; x++) {
                bool is = stored_pixel(&c->surface, x, y) != 0;
                if (is != on_line(a, b, x, y)) {
                    fail_msg("%d,%d %d,%d: pixel %d,%d %s", (int)a.x, (int)a.y, (int)b.x, (int)b.y,
                             (int)x, (int)y, is ? "covered" : "missing");
                }
            }
        }
    }
}

static void rule(void **state)
{
    (void)state;
    static const int32_t reach[] = {300, 3000, 8000, 17000, 33000, 1 << 19, 4000000};
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 71;
    for (int n = 0; n < 14000; n++) {
        point a = random_point(&seed, reach[n % 7]);
        point b = random_point(&seed, random_in(&seed, 0, 2) == 0 ? 5000 : reach[n % 7]);
        if (n % 11 == 0) { /* diagonals, where the major axis changes */
            b.x = a.x + (b.y - a.y) * (random_flag(&seed) ? 1 : -1);
        }
        check_line(&c, a, b);
    }
    point far_out[2] = {{-(1 << 22), -(1 << 22)}, {1 << 22, 1 << 22}};
    check_line(&c, far_out[0], far_out[1]);
    canvas_free(&c);
}

/* A chain along one axis has one pixel in every column, joints included. */
static void chains(void **state)
{
    (void)state;
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 72;
    for (int n = 0; n < 2000; n++) {
        int count[WIDTH] = {0};
        bool steep = n % 2 != 0;
        point a = {-500, 5000};
        while (a.x < WIDTH * 256) {
            int32_t along = random_in(&seed, 1, 1200);
            int32_t across = random_in(&seed, -along, along);
            point b = {a.x + (n % 3 ? along : (along + 127) & ~127), a.y + across};
            b.y = b.y < 0 ? a.y : (b.y >= HEIGHT * 256 ? a.y : b.y);
            point p = {steep ? a.y : a.x, steep ? a.x : a.y};
            point q = {steep ? b.y : b.x, steep ? b.x : b.y};
            bool turned = random_flag(&seed);
            if (steep && distance(p.x, q.x) == distance(p.y, q.y)) {
                q.x = p.x; /* a diagonal counts columns */
                b.y = a.y;
            }
            canvas_clear(&c);
            draw(&c.surface, turned ? q : p, turned ? p : q);
            for (int32_t y = 0; y < HEIGHT; y++) {
                for (int32_t x = 0; x < WIDTH; x++) {
                    count[steep ? y : x] += stored_pixel(&c.surface, x, y) != 0;
                }
            }
            a = b;
        }
        for (int i = 0; i < (steep ? HEIGHT : WIDTH); i++) {
            if (count[i] != 1) {
                fail_msg("chain %d: %d pixels at %d", n, count[i], i);
            }
        }
    }
    canvas_free(&c);
}

static point at(double x, double y)
{
    point p = {(int32_t)(x * 256), (int32_t)(y * 256)};
    return p;
}

static void pictures(void **state)
{
    (void)state;
    canvas c = canvas_new(&qtri_rgb565, 6, 4);
    const qtri_surface *s = &c.surface;
    draw(s, at(1.5, 1.5), at(4.5, 1.5));
    assert_raster(s, "......", ".###..", "......");
    draw(s, at(5.5, .5), at(5.5, 2.5));
    assert_raster(s, ".....#", ".###.#", "......");
    canvas_clear(&c);
    draw(s, at(.5, .5), at(4.5, 4.5));
    assert_raster(s, "#.....", ".#....", "..#...", "...#..");
    canvas_clear(&c);
    draw(s, at(0, 3), at(6, 1)); /* the lower of two rows where it passes between them */
    assert_raster(s, "......", "...###", "###...", "......");
    canvas_clear(&c);
    draw(s, at(2.2, 2.2), at(2.2, 2.2));
    draw(s, at(2.6, 2.2), at(3.4, 2.2));
    assert_raster(s, "......", "......", "......", "......");
    canvas_free(&c);
}

/* Stored channels as the format has them, and 255 in its steps. */
static void channels_of(const qtri_format *format, uint32_t pixel, double channel[3],
                        double steps[3])
{
    static const int shift[2][3] = {{11, 5, 0}, {16, 8, 0}};
    static const int bits[2][3] = {{5, 6, 5}, {8, 8, 8}};
    const int wide = format == &qtri_xrgb8888;
    for (int i = 0; i < 3; i++) {
        uint32_t most = (1u << bits[wide][i]) - 1;
        steps[i] = most;
        channel[i] = pixel >> shift[wide][i] & most;
    }
}

/* Where the line is at the pixel: 0 at v[0], 1 at v[1]. */
static double along_line(const qtri_screen_vertex v[2], int32_t x, int32_t y)
{
    bool steep = distance(v[0].y_24p8, v[1].y_24p8) > distance(v[0].x_24p8, v[1].x_24p8);
    int32_t from = steep ? v[0].y_24p8 : v[0].x_24p8;
    int32_t to = steep ? v[1].y_24p8 : v[1].x_24p8;
    return (double)((steep ? y : x) * 256 + 128 - from) / (to - from);
}

static void measure(const qtri_surface *s, const qtri_screen_vertex v[2], double *color,
                    double *depth)
{
    for (int32_t i = 0; i < s->width * s->height; i++) {
        int32_t x = i % s->width;
        int32_t y = i / s->width;
        if (stored_depth(s, x, y) == 65535) {
            continue;
        }
        double t = along_line(v, x, y);
        double channel[3];
        double steps[3];
        channels_of(s->format, stored_pixel(s, x, y), channel, steps);
        for (int c = 0; c < 3; c++) {
            double exact =
                v[0].color_8p16[c] + t * ((double)v[1].color_8p16[c] - v[0].color_8p16[c]);
            *color = fmax(*color, fabs(channel[c] - exact / 65536 * steps[c] / 255));
        }
        double exact = v[0].depth_16p16 + t * ((double)v[1].depth_16p16 - (double)v[0].depth_16p16);
        *depth = fmax(*depth, fabs(stored_depth(s, x, y) - exact / 65536));
    }
}

static void random_attributes(uint64_t *seed, qtri_screen_vertex v[2])
{
    for (int i = 0; i < 2; i++) {
        v[i].depth_16p16 = (uint32_t)random_in(seed, 0, 65534 * 32768) * 2;
        for (int c = 0; c < 3; c++) {
            v[i].color_8p16[c] = random_in(seed, 0, 255 << 16);
        }
    }
    if (random_in(seed, 0, 3) == 0) {
        v[0].depth_16p16 = 0;
        v[1].depth_16p16 = (uint32_t)65534 << 16;
    }
    if (random_in(seed, 0, 3) == 0) {
        memcpy(v[1].color_8p16, v[0].color_8p16, sizeof v[1].color_8p16);
    }
}

static void values(void **state)
{
    (void)state;
    static const struct {
        const qtri_format *format;
        int32_t width, height;
    } sizes[] = {{&qtri_xrgb8888, WIDTH, HEIGHT},
                 {&qtri_rgb565, WIDTH, HEIGHT},
                 {&qtri_xrgb8888, 5000, 3},
                 {&qtri_rgb565, 2, 3000},
                 {&qtri_rgb565, 127, 4}};
    uint64_t seed = 73;
    for (size_t i = 0; i < LENGTH_OF(sizes); i++) {
        double color = 0;
        double depth = 0;
        canvas c = canvas_new(sizes[i].format, sizes[i].width, sizes[i].height);
        int lines = sizes[i].width == WIDTH ? 4000 : 100;
        for (int n = 0; n < lines; n++) {
            qtri_material material = plain_material();
            material.depth_compare = QTRI_LESS;
            qtri_screen_vertex v[2];
            for (int end = 0; end < 2; end++) {
                point p = {random_in(&seed, 0, sizes[i].width * 256),
                           random_in(&seed, 0, sizes[i].height * 256)};
                p = lines == 100 ? p : random_point(&seed, n % 2 ? 5000 : 4000000);
                v[end] = screen_at(p.x, p.y);
            }
            random_attributes(&seed, v);
            canvas_clear(&c);
            qtri_raster_line(&c.surface, &material, v);
            measure(&c.surface, v, &color, &depth);
        }
        print_message("%d x %d, %s: colour %.4f of a step, depth %.4f of 65535\n",
                      (int)sizes[i].width, (int)sizes[i].height,
                      sizes[i].format == &qtri_rgb565 ? "RGB565" : "XRGB8888", color, depth);
        assert_true(color > .4 && color <= .504);
        assert_true(depth > .4 && depth <= .505);
        canvas_free(&c);
    }
}

static void turn_over(qtri_surface *s)
{
    s->pixels += (s->rows - 1) * s->pitch;
    s->depth += (s->rows - 1) * s->depth_pitch;
    s->pitch = -s->pitch;
    s->depth_pitch = -s->depth_pitch;
}

/*
 * The fast path needs a pixel and its depth equally far from the first ones, and a line inside the
 * bounds: without the one or the other the pixels are the same.
 */
static void fast_path(void **state)
{
    (void)state;
    enum { SIDE = 300, DEPTH_PITCH = SIDE + 7 };
    static uint16_t depth[SIDE * DEPTH_PITCH];
    static const int32_t reach[] = {2, 6, 20, 127, 129, 150, 400};
    uint64_t seed = 74;
    for (int n = 0; n < 3000; n++) {
        const qtri_format *format = n % 3 ? &qtri_rgb565 : drawn_format(random_in(&seed, 0, 2));
        qtri_material material = plain_material();
        material.depth_compare = n % 2 ? QTRI_LESS : (qtri_compare)random_in(&seed, 0, 8);
        material.depth_read_only = n % 7 == 0;
        bool wide = random_flag(&seed);
        canvas fast = canvas_new(format, wide ? SIDE : 20, wide ? 20 : SIDE);
        canvas generic = canvas_new(format, wide ? SIDE : 20, wide ? 20 : SIDE);
        qtri_surface *f = &fast.surface;
        qtri_surface *g = &generic.surface;
        g->depth = depth;
        g->depth_pitch = DEPTH_PITCH;
        if (n % 5 == 0) {
            turn_over(f);
        }
        for (int32_t i = 0; i < f->width * f->height; i++) {
            uint16_t z = (uint16_t)(random_in(&seed, 0, 3) == 0 ? 30000 : 65535);
            f->depth[i / f->width * f->depth_pitch + i % f->width] = z;
            depth[i / f->width * DEPTH_PITCH + i % f->width] = z;
        }
        if (n % 4 == 0) {
            qtri_rect part = {random_in(&seed, -9, 25), random_in(&seed, -9, 25),
                              random_in(&seed, 0, SIDE), random_in(&seed, 0, SIDE)};
            f->scissor = part;
        }
        for (int line = 0; line < 12; line++) {
            int32_t far_off = reach[random_in(&seed, 0, 6)] * 256;
            qtri_screen_vertex v[2];
            point p = {random_in(&seed, 0, f->width * 256), random_in(&seed, 0, f->height * 256)};
            v[0] = screen_at(p.x, p.y);
            v[1] = screen_at(p.x + random_in(&seed, -far_off, far_off),
                             p.y + random_in(&seed, -far_off, far_off));
            random_attributes(&seed, v);
            qtri_raster_line(f, &material, v);
            qtri_raster_line(g, &material, v);
        }
        qtri_rect bounds = qtri_surface_bounds(f);
        for (int32_t i = 0; i < f->width * f->height; i++) {
            int32_t x = i % f->width;
            int32_t y = i / f->width;
            bool inside = x >= bounds.x0 && x < bounds.x1 && y >= bounds.y0 && y < bounds.y1;
            uint32_t expected = inside ? stored_pixel(g, x, y) : 0;
            if (stored_pixel(f, x, y) != expected ||
                (inside && stored_depth(f, x, y) != stored_depth(g, x, y))) {
                fail_msg("%d: pixel %d,%d: %x and %x, depth %u and %u", n, (int)x, (int)y,
                         (unsigned)stored_pixel(f, x, y), (unsigned)expected, stored_depth(f, x, y),
                         stored_depth(g, x, y));
            }
        }
        canvas_free(&fast);
        canvas_free(&generic);
    }
}

/* Cores without long multiply and divide: the same colours, all of them, and lines. */
static void narrow(void **state)
{
    (void)state;
    for (int32_t color = 0; color <= 255 << 16; color++) {
        if (narrow_line_channel(color, 31) != qtri_line_channel_565(color, 31) ||
            narrow_line_channel(color, 63) != qtri_line_channel_565(color, 63)) {
            fail_msg("colour %x", (unsigned)color);
        }
    }
    uint64_t seed = 75;
    canvas wide = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas other = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_material material = plain_material();
    for (int n = 0; n < 20000; n++) {
        qtri_screen_vertex v[2];
        material.depth_compare = n % 4 == 0 ? QTRI_LESS_EQUAL : QTRI_LESS;
        for (int i = 0; i < 2; i++) {
            point p = random_point(&seed, n % 3 == 0 ? 9000 : 4000);
            v[i] = screen_at(p.x, p.y);
        }
        random_attributes(&seed, v);
        if (n % 2 == 0) { /* near each other */
            v[1].depth_16p16 = v[0].depth_16p16 ^ (uint32_t)random_in(&seed, 0, 1 << 24);
        }
        if (n % 10 == 0) {
            canvas_clear(&wide);
            canvas_clear(&other);
        }
        qtri_raster_line(&wide.surface, &material, v);
        narrow_raster_line(&other.surface, &material, v);
        assert_same_picture(&wide.surface, &other.surface);
    }
    canvas_free(&wide);
    canvas_free(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rule),   cmocka_unit_test(chains),    cmocka_unit_test(pictures),
        cmocka_unit_test(values), cmocka_unit_test(fast_path), cmocka_unit_test(narrow),
    };
    return cmocka_run_group_tests_name("core line", tests, NULL, NULL);
}
