/* SPDX-License-Identifier: MIT */
/*
 * Lines: the rule of draw.h exactly, both directions, chains, pictures, values along them.
 */
#include "support/core.h"
#include "support/steps.h"
#include "support/line_narrow.h"

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

TEST(rule)
{
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
TEST(chains)
{
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

TEST(pictures)
{
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
        for (int c = 0; c < 3; c++) {
            double exact =
                v[0].color_8p16[c] + t * ((double)v[1].color_8p16[c] - v[0].color_8p16[c]);
            const double should = exact / 65536 * most_steps(s->format, c) / 255;
            *color = fmax(*color, fabs(stored_steps(s->format, stored_pixel(s, x, y), c) - should));
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

TEST(values)
{
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

/* Pixels of 16 bits first. */
static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_xrgb8888,
                                             &qtri_gray8,  &qtri_rgb888,         &qtri_bgr888};

/* Lit ends anywhere around the surface, some near each other. */
static void random_ends(uint64_t *seed, const qtri_surface *s, qtri_vertex end[2])
{
    static const int32_t reach[] = {2, 6, 20, 31, 33, 127, 129, 150, 400};
    const int32_t far_off = reach[random_in(seed, 0, (int32_t)LENGTH_OF(reach) - 1)] * 256;
    end[0].at.x_24p8 = random_in(seed, -2000, s->width * 256 + 2000);
    end[0].at.y_24p8 = random_in(seed, -2000, s->height * 256 + 2000);
    end[1].at.x_24p8 = end[0].at.x_24p8 + random_in(seed, -far_off, far_off);
    end[1].at.y_24p8 = end[0].at.y_24p8 + random_in(seed, -far_off, far_off);
    for (int i = 0; i < 2; i++) {
        end[i].depth_16p8 = (uint32_t)random_in(seed, 0, 65535) << 16;
        end[i].intensity_q15 = (uint16_t)random_in(seed, 0, 1 << 15);
        if (random_in(seed, 0, 3) == 0) {
            end[i].depth_16p8 = (uint32_t)30000 << 16;
            end[i].intensity_q15 = random_flag(seed) ? 1 << 15 : 0;
        }
    }
}

/* The same memory, whatever it holds. */
static void fill_depths(uint64_t seed, const qtri_surface *s)
{
    for (int32_t y = 0; y < s->rows; y++) {
        for (int32_t x = 0; x < s->width; x++) {
            s->depth[y * s->depth_pitch + x] =
                (uint16_t)(random_in(&seed, 0, 3) == 0 ? 30000 : random_in(&seed, 0, 65535));
        }
    }
}

/*
 * Lines of a draw call, by the loops for RGB565 where they serve, by what draws any, and by narrow
 * products: the same pixels, in all formats, for all compares, lit by a table or not.
 */
TEST(ways)
{
    enum { SIDE = 300, WAYS = 4, LINES = 30 };
    static uint16_t own_depth[SIDE * (SIDE + 7)];
    uint64_t seed = 74;
    int by_any = 0;
    for (int n = 0; n < 3000; n++) {
        const qtri_format *format = n % 3 ? formats[random_in(&seed, 0, 1)]
                                          : formats[random_in(&seed, 0, LENGTH_OF(formats) - 1)];
        const bool wide = random_flag(&seed);
        const int32_t height = wide ? 20 : SIDE;
        const int32_t first = random_in(&seed, 0, 3) == 0 ? random_in(&seed, 0, height - 1) : 0;
        const uint64_t depths = random64(&seed);
        const qtri_rect part = {random_in(&seed, -9, 25), random_in(&seed, -9, 25),
                                random_in(&seed, 0, SIDE), random_in(&seed, 0, SIDE)};
        qtri_material material = plain_material();
        material.depth_compare = n % 2 ? QTRI_LESS : (qtri_compare)random_in(&seed, 0, 9);
        material.depth_read_only = n % 7 == 0;
        material.color.r = (uint8_t)random64(&seed);
        material.color.g = (uint8_t)random64(&seed);
        material.color.b = (uint8_t)random64(&seed);
        canvas c[WAYS];
        const uint64_t ends = random64(&seed);
        for (int way = 0; way < WAYS; way++) {
            qtri_stroke_target to;
            qtri_line_job job;
            uint16_t table[QTRI_TABLE];
            to.state.table = table;
            c[way] = canvas_band(format, wide ? SIDE : 20, height, first, height - first);
            qtri_surface *s = &c[way].surface;
            if (way == 1) { /* a pixel and its depth not equally far from the first ones */
                s->depth = own_depth;
                s->depth_pitch = s->width + 7;
            } else if (n % 5 == 0) {
                turn_over(s);
            }
            s->scissor = n % 4 == 0 ? part : s->scissor;
            fill_depths(depths, s);
            if (n % 11 == 0) {
                s->depth = NULL;
            }
            if (way < 3) {
                qtri_line_job_init(&job, s, &material, &to);
            } else {
                narrow_line_job_init(&job, s, &material, &to);
            }
            by_any += way == 0 && job.draw == qtri_line_any.line;
            if (way == 2) {
                job.draw = qtri_line_any.line;
            }
            uint64_t same = ends;
            for (int line = 0; line < LINES; line++) {
                static const qtri_line_color color[2] = {{255 << 16, 0, 40 << 16},
                                                         {0, 255 << 16, 200 << 16}};
                qtri_vertex end[2];
                random_ends(&same, s, end);
                job.draw(&job, &end[0], &end[1], line % 4 == 0 ? color : NULL);
            }
            for (int32_t i = 0; way > 0 && i < s->width * s->rows; i++) {
                const int32_t x = i % s->width;
                const int32_t y = i / s->width + first;
                const qtri_surface *g = &c[0].surface;
                if (stored_pixel(s, x, y) != stored_pixel(g, x, y) ||
                    (s->depth != NULL && stored_depth(s, x, y) != stored_depth(g, x, y))) {
                    fail_msg("%d, way %d: pixel %d,%d: %x and %x", n, way, (int)x, (int)y,
                             (unsigned)stored_pixel(s, x, y), (unsigned)stored_pixel(g, x, y));
                }
            }
        }
        for (int way = 0; way < WAYS; way++) {
            canvas_free(&c[way]);
        }
    }
    assert_true(by_any > 500 && by_any < 2500);
}

/* How far tints are from the share of the colour that is exact at the pixel. */
TEST(tints)
{
    static const struct {
        const qtri_format *format;
        double bound;
    } kinds[] = {{&qtri_rgb565, .75}, {&qtri_xrgb8888, .641}};
    uint64_t seed = 76;
    for (size_t f = 0; f < LENGTH_OF(kinds); f++) {
        double worst = 0;
        canvas c = canvas_new(kinds[f].format, 400, 2);
        for (int n = 0; n < 2000; n++) {
            qtri_material material = plain_material();
            qtri_stroke_target to;
            qtri_line_job job;
            uint16_t table[QTRI_TABLE];
            qtri_vertex end[2];
            to.state.table = table;
            const bool white = n % 2 == 0;
            const uint8_t tint[3] = {white ? 255 : (uint8_t)random64(&seed),
                                     white ? 255 : (uint8_t)random64(&seed),
                                     white ? 255 : (uint8_t)random64(&seed)};
            material.color.r = tint[0];
            material.color.g = tint[1];
            material.color.b = tint[2];
            memset(end, 0, sizeof end);
            end[0].at.x_24p8 = random_in(&seed, 0, 2000);
            end[1].at.x_24p8 = end[0].at.x_24p8 + random_in(&seed, 256, n % 3 ? 20000 : 100000);
            end[0].intensity_q15 = (uint16_t)random_in(&seed, 0, 1 << 15);
            end[1].intensity_q15 = (uint16_t)random_in(&seed, 0, 1 << 15);
            qtri_line_job_init(&job, &c.surface, &material, &to);
            job.draw(&job, &end[0], &end[1], NULL);
            for (int32_t x = (end[0].at.x_24p8 + 127) >> 8; x < (end[1].at.x_24p8 + 127) >> 8;
                 x++) {
                const double t = (x * 256 + 128 - end[0].at.x_24p8) /
                                 (double)(end[1].at.x_24p8 - end[0].at.x_24p8);
                const double share =
                    (end[0].intensity_q15 + t * (end[1].intensity_q15 - end[0].intensity_q15)) /
                    32768;
                if (x >= c.surface.width) {
                    break;
                }
                const uint32_t stored = stored_pixel(&c.surface, x, 0);
                for (int i = 0; i < 3; i++) {
                    const double should = tint[i] * share / 255 * most_steps(kinds[f].format, i);
                    worst = fmax(worst, fabs(stored_steps(kinds[f].format, stored, i) - should));
                }
            }
        }
        print_message("tints of %s: %.4f of a step\n",
                      kinds[f].format == &qtri_rgb565 ? "RGB565" : "XRGB8888", worst);
        assert_true(worst > .49 && worst <= kinds[f].bound);
        canvas_free(&c);
    }
}

/* Reciprocals of short lines: not above 2^32 / length and less than 1.01 below it, all of them. */
TEST(short_lengths)
{
    for (uint32_t length = 1; length < 65536; length++) {
        const double below = 4294967296. / length - narrow_line_reciprocal(length);
        if (below < 0 || below > 1.01) {
            fail_msg("length %u: %g", (unsigned)length, below);
        }
    }
}

/* Cores without long multiply and divide: the same lines. */
TEST(narrow)
{
    uint64_t seed = 75;
    for (int n = 0; n < 20000; n++) {
        static canvas wide, other;
        if (n % 20 == 0) {
            const qtri_format *format = formats[random_in(&seed, 0, LENGTH_OF(formats) - 1)];
            if (n > 0) {
                canvas_free(&wide);
                canvas_free(&other);
            }
            wide = canvas_new(format, WIDTH, HEIGHT);
            other = canvas_new(format, WIDTH, HEIGHT);
        }
        qtri_material material = plain_material();
        qtri_screen_vertex v[2];
        material.depth_compare = n % 4 == 0 ? QTRI_LESS_EQUAL : QTRI_LESS;
        for (int i = 0; i < 2; i++) {
            point p = random_point(&seed, n % 3 == 0 ? 9000 : (n % 5 == 0 ? 4000000 : 4000));
            v[i] = screen_at(p.x, p.y);
        }
        random_attributes(&seed, v);
        if (n % 2 == 0) { /* near each other */
            v[1].depth_16p16 = v[0].depth_16p16 ^ (uint32_t)random_in(&seed, 0, 1 << 24);
        }
        qtri_raster_line(&wide.surface, &material, v);
        narrow_raster_line(&other.surface, &material, v);
        assert_same_picture(&wide.surface, &other.surface);
    }
}

/* Each pipeline of a list is the first that fits what some line or stroke asks for. */
static void assert_all_in_use(const qtri_pipeline *const *list, bool has_smooth)
{
    static const qtri_format *const used[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_gray8,
                                              &qtri_xrgb8888};
    static const qtri_compare compares[] = {QTRI_DEPTH_OFF, QTRI_LESS, QTRI_GREATER};
    uint32_t in_use = 0, count = 0;
    for (int n = 0; n < 4 * 3 * 2; n++) {
        canvas c = canvas_new(used[n % 4], WIDTH, HEIGHT);
        qtri_material material = qtri_material_default();
        qtri_stroke_target to;
        material.depth_compare = compares[n / 4 % 3];
        assert_true(qtri_stroke_target_init(&to, &c.surface, &material, list, 255,
                                            has_smooth && n / 12 != 0));
        for (count = 0; list[count] != NULL; count++) {
            in_use |= (uint32_t)(to.state.pipeline == list[count]) << count;
        }
        canvas_free(&c);
    }
    assert_int_equal(in_use, ((uint32_t)1 << count) - 1);
}

TEST(each_pipeline_is_in_use)
{
    assert_all_in_use(qtri_line_pipelines, false);
    assert_all_in_use(qtri_stroke_pipelines, true);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
