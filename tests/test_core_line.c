/*
 * Lines: the rule of raster.h exactly, both directions, chains, pictures, values along them.
 */
#include "support_core.h"

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
    canvas c = canvas_new(QTRI_GRAY8, WIDTH, HEIGHT);
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
    canvas c = canvas_new(QTRI_GRAY8, WIDTH, HEIGHT);
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
    canvas c = canvas_new(QTRI_RGB565, 6, 4);
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

static void values(void **state)
{
    (void)state;
    double worst_color = 0;
    double worst_depth = 0;
    canvas c = canvas_new(QTRI_XRGB8888, WIDTH, HEIGHT);
    uint64_t seed = 73;
    for (int n = 0; n < 4000; n++) {
        qtri_material material = plain_material();
        material.depth_compare = QTRI_ALWAYS;
        qtri_screen_vertex v[2];
        for (int i = 0; i < 2; i++) {
            point p = random_point(&seed, n % 2 ? 6000 : 4000000);
            v[i] = screen_at(p.x, p.y);
            v[i].depth_16p16 = (uint32_t)random_in(&seed, 0, 65535 * 32768) * 2;
            v[i].color_8p16[0] = random_in(&seed, 0, 255 << 16);
        }
        canvas_clear(&c);
        qtri_raster_line(&c.surface, &material, v);
        bool steep = distance(v[0].y_24p8, v[1].y_24p8) > distance(v[0].x_24p8, v[1].x_24p8);
        int32_t from = steep ? v[0].y_24p8 : v[0].x_24p8;
        int32_t to = steep ? v[1].y_24p8 : v[1].x_24p8;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int32_t x = i % WIDTH;
            int32_t y = i / WIDTH;
            if (stored_pixel(&c.surface, x, y) == 0) {
                continue;
            }
            double t = (double)((steep ? y : x) * 256 + 128 - from) / (to - from);
            double color = v[0].color_8p16[0] + t * (v[1].color_8p16[0] - v[0].color_8p16[0]);
            double depth =
                v[0].depth_16p16 + t * ((double)v[1].depth_16p16 - (double)v[0].depth_16p16);
            double is = stored_pixel(&c.surface, x, y) >> 16;
            worst_color = fmax(worst_color, fabs(is - color / 65536));
            worst_depth = fmax(worst_depth, fabs(stored_depth(&c.surface, x, y) - depth / 65536));
        }
    }
    print_message("along lines: colour %.4f of 255, depth %.4f of 65535\n", worst_color,
                  worst_depth);
    assert_true(worst_color <= .51);
    assert_true(worst_depth <= .51);
    canvas_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rule),
        cmocka_unit_test(chains),
        cmocka_unit_test(pictures),
        cmocka_unit_test(values),
    };
    return cmocka_run_group_tests_name("core line", tests, NULL, NULL);
}
