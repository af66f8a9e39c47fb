/* SPDX-License-Identifier: MIT */
/*
 * Colour and depth of covered pixels against double barycentrics of the snapped vertices;
 * stored formats.
 */
#include "support/core.h"
#include "support/shares.h"
#include "support/steps.h"

enum { WIDTH = 40, HEIGHT = 36 };

static const double max_565[3] = {31, 63, 31};

/* From a pixel to a whole guard band, slivers too. */
static void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, int kind)
{
    static const int32_t reach[] = {1200, 6000, 12000, 60000, 1 << 19, 4100000, 300};
    int32_t r = reach[kind % 7];
    double near_w = pow(2, random_in(seed, 0, 8) / 2.);
    for (int i = 0; i < 3; i++) {
        v[i] = screen_at(random_in(seed, WIDTH * 128 - r, WIDTH * 128 + r),
                         random_in(seed, HEIGHT * 128 - r, HEIGHT * 128 + r));
        v[i].depth_16p16 = (uint32_t)random_in(seed, 0, 65535 * 32768) * 2;
        double inv_w = 1 / (1 + (near_w - 1) * random_in(seed, 0, 1000) / 1000.);
        v[i].inv_w_q31 = (uint32_t)(inv_w * 2147483648.);
        int up = v[i].inv_w_q31 < 1u << 30 ? random_in(seed, 0, 1) : 0;
        v[i].inv_w_q31 <<= up;
        v[i].inv_w_exponent = 5 - up;
        for (int channel = 0; channel < 3; channel++) {
            v[i].color_8p16[channel] =
                kind % 4 == 0 ? random_in(seed, 0, 1) * (255 << 16) : random_in(seed, 0, 255 << 16);
        }
    }
    if (kind % 5 == 4) { /* a sliver */
        v[2].x_24p8 = v[0].x_24p8 + (v[1].x_24p8 - v[0].x_24p8) / 3 + random_in(seed, -9, 9);
        v[2].y_24p8 = v[0].y_24p8 + (v[1].y_24p8 - v[0].y_24p8) / 3 + random_in(seed, -9, 9);
    }
}

typedef struct worst {
    double color, depth;
    int pixels;
} worst;

static void check_pixel(const canvas *c, const qtri_material *m, const qtri_screen_vertex v[3],
                        int32_t x, int32_t y, worst *w)
{
    double linear[3];
    double b[3];
    double color[3];
    shares_at(linear, v, x, y, false);
    shares_at(b, v, x, y, m->interpolation == QTRI_PERSPECTIVE);
    double depth = 0;
    for (int i = 0; i < 3; i++) {
        depth += linear[i] * v[i].depth_16p16;
    }
    w->depth = fmax(w->depth, fabs(stored_depth(&c->surface, x, y) - depth / 65536));
    for (int channel = 0; channel < 3; channel++) {
        int provoking = m->shading == QTRI_FLAT_FIRST ? 0 : 2;
        double sum = v[provoking].color_8p16[channel];
        double low = 1e9;
        double high = 0;
        if (m->shading == QTRI_SMOOTH) {
            sum = 0;
            for (int i = 0; i < 3; i++) {
                sum += b[i] * v[i].color_8p16[channel];
                low = fmin(low, v[i].color_8p16[channel]);
                high = fmax(high, v[i].color_8p16[channel]);
            }
            assert_true(sum >= low - 1 && sum <= high + 1);
        }
        color[channel] = sum / 65536;
        if (m->shading == QTRI_SMOOTH && c->surface.format == &qtri_xrgb8888) {
            double is = stored_pixel(&c->surface, x, y) >> (16 - 8 * channel) & 255;
            assert_true(is >= floor(low / 65536 + .5) && is <= floor(high / 65536 + .5));
        }
    }
    const qtri_format *format = c->surface.format;
    const uint32_t pixel = stored_pixel(&c->surface, x, y);
    for (int i = 0; i < 3; i++) {
        w->color =
            fmax(w->color, fabs(stored_steps(format, pixel, i) - steps_of(format, color, i)));
    }
    w->pixels++;
}

TEST(interpolation)
{
    static const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8};
    static const char *const names[3] = {"RGB565", "XRGB8888", "GRAY8"};
    uint64_t seed = 81;
    for (int f = 0; f < 3; f++) {
        canvas c = canvas_new(formats[f], WIDTH, HEIGHT);
        worst w[3][2] = {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
        for (int n = 0; n < 9000; n++) {
            qtri_screen_vertex v[3];
            qtri_material m = plain_material();
            const int shading = n % 4 == 1 ? 1 : n % 4 == 2 ? 2 : 0;
            m.shading = shading_of(shading);
            m.interpolation = (qtri_interpolation)random_in(&seed, 0, 1);
            m.depth_compare = QTRI_LESS;
            random_triangle(v, &seed, n);
            /* Every drawn depth stays below the cleared one, which so marks what was not. */
            canvas_clear(&c);
            for (int i = 0; i < 3; i++) {
                v[i].depth_16p16 = v[i].depth_16p16 > (uint32_t)65534 << 16 ? (uint32_t)65534 << 16
                                                                            : v[i].depth_16p16;
            }
            qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
                if (stored_depth(&c.surface, i % WIDTH, i / WIDTH) != 65535) {
                    check_pixel(&c, &m, v, i % WIDTH, i / WIDTH, &w[shading][m.interpolation]);
                }
            }
        }
        print_message("%s: smooth perspective %.4f, linear %.4f, flat %.4f steps; depth %.4f\n",
                      names[f], w[0][0].color, w[0][1].color, w[1][0].color,
                      fmax(w[0][0].depth, w[0][1].depth));
        for (int i = 0; i < 6; i++) {
            assert_true(w[i / 2][i % 2].pixels > 1000);
            /*
             * With perspective, a colour may stray by 1/4 of a step where it is taken as linear.
             * RGB565 adds the short fractions of colours in one word (body/pixel.h).
             */
            double between = i > 0 ? 0 : 1 / 4.0;
            double packed = i < 2 && formats[f] == &qtri_rgb565 ? 7 / 32.0 : 0;
            const double whole = /* colours of triangles are rounded to 8 bits first */
                formats[f] == &qtri_gray8    ? 1
                : formats[f] == &qtri_rgb565 ? .63
                                             : .6;
            assert_true(w[i / 2][i % 2].color <= whole + between + packed);
            assert_true(w[i / 2][i % 2].depth <= .54); /* steps of small triangles: 2^-5 */
        }
        canvas_free(&c);
    }
}

/* One plane through the eye's neighbourhood and the horizon: 1/w over a ratio of 2^20. */
TEST(steep_perspective)
{
    uint64_t seed = 82;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    worst w = {0, 0, 0};
    for (int n = 0; n < 4000; n++) {
        qtri_screen_vertex v[3];
        qtri_material m = plain_material();
        m.shading = QTRI_SMOOTH;
        m.depth_compare = QTRI_LESS;
        random_triangle(v, &seed, n % 3);
        for (int i = 0; i < 3; i++) {
            v[i].inv_w_q31 = 0x80000000u >> random_in(&seed, 0, 20);
            v[i].inv_w_exponent = 0;
            v[i].depth_16p16 = 0;
        }
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            if (stored_depth(&c.surface, i % WIDTH, i / WIDTH) != 65535) {
                check_pixel(&c, &m, v, i % WIDTH, i / WIDTH, &w);
            }
        }
    }
    print_message("1/w over 2^20: %.4f of 255\n", w.color);
    assert_true(w.color <= 1);
    canvas_free(&c);
}

TEST(beyond_the_farthest_is_the_farthest)
{
    canvas c = canvas_new(&qtri_gray8, 8, 8);
    qtri_material m = plain_material();
    m.depth_compare = QTRI_ALWAYS;
    qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(2048, 0), screen_at(0, 2048)};
    for (int i = 0; i < 3; i++) {
        v[i].depth_16p16 = UINT32_MAX - (uint32_t)i;
    }
    qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
    assert_int_equal(stored_depth(&c.surface, 2, 3), 65535);
    canvas_free(&c);
}

/* Two crossing triangles: each pixel shows the nearer one. */
TEST(crossing)
{
    canvas c = canvas_new(&qtri_gray8, 64, 64);
    qtri_material m = plain_material();
    m.depth_compare = QTRI_LESS;
    for (int n = 0; n < 2; n++) {
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(64 * 256, 0),
                                   screen_at(0, 64 * 256 * 8)};
        static const uint32_t z[2][3] = {{100, 900, 100}, {900, 100, 900}};
        for (int i = 0; i < 3; i++) {
            v[i].depth_16p16 = z[n][i] << 16;
            v[i].color_8p16[0] = v[i].color_8p16[1] = v[i].color_8p16[2] = (n + 1) * 100 << 16;
        }
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
    }
    for (int32_t y = 0; y < 60; y++) {
        for (int32_t x = 0; x < 50; x++) {
            if (x != 31 && x != 32) {
                assert_int_equal(stored_pixel(&c.surface, x, y), x < 32 ? 100 : 200);
            }
        }
    }
    canvas_free(&c);
}

/* All 8-bit levels as stored pixels: flat, cleared and read back. */
TEST(formats_round)
{
    canvas c[3] = {canvas_new(&qtri_rgb565, 4, 4), canvas_new(&qtri_xrgb8888, 4, 4),
                   canvas_new(&qtri_gray8, 4, 4)};
    uint64_t seed = 83;
    for (int n = 0; n < 20000; n++) {
        int level[3] = {n % 256, (n * 7 + n / 256) % 256, random_in(&seed, 0, 255)};
        if (n < 256) {
            level[1] = level[2] = n;
        }
        qtri_rgb rgb = {(uint8_t)level[0], (uint8_t)level[1], (uint8_t)level[2]};
        uint32_t expected[3] = {0, (uint32_t)(level[0] << 16 | level[1] << 8 | level[2]), 0};
        for (int i = 0; i < 3; i++) { /* round(level max / 255): no ties */
            int max = (int)max_565[i];
            expected[0] =
                expected[0] << (i == 1 ? 6 : 5) | (uint32_t)((2 * level[i] * max + 255) / 510);
        }
        double gray = .299 * level[0] + .587 * level[1] + .114 * level[2];
        expected[2] = (uint32_t)floor(gray + .5);
        bool tie = fabs(gray - floor(gray) - .5) < 4e-3; /* weights have 16 bits */
        qtri_material m = plain_material();
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(1024, 0), screen_at(0, 1024)};
        for (int i = 0; i < 9; i++) {
            v[i / 3].color_8p16[i % 3] = level[i % 3] << 16;
        }
        for (int f = 0; f < 3; f++) {
            clear_to(&c[f].surface, rgb, 0);
            qtri_raster_triangle(&c[f].surface, qtri_pipelines_default, &m, v);
            uint32_t drawn = stored_pixel(&c[f].surface, 0, 0);
            const uint32_t cleared = stored_pixel(&c[f].surface, 3, 3);
            if (f == 2 && tie) {
                assert_true(fabs(drawn - gray) <= .504 && fabs(cleared - gray) <= .504);
            } else {
                assert_int_equal(drawn, expected[f]);
                assert_int_equal(cleared, expected[f]);
            }
        }
        qtri_rgb back = qtri_surface_pixel(&c[0].surface, 0, 0);
        assert_true(abs(back.r - level[0]) <= 4 && abs(back.g - level[1]) <= 2);
        assert_true(level[0] % 255 != 0 || back.r == level[0]);
    }
    for (int f = 0; f < 3; f++) {
        canvas_free(&c[f]);
    }
}

/* Three vertices of one colour, whose luma lies halfway between two steps: the upper one. */
TEST(halves_of_luma_go_up)
{
    static const qtri_rgb half[5] = {
        {2, 189, 140}, {6, 186, 145}, {11, 165, 240}, {15, 195, 75}, {24, 171, 175}};
    const qtri_material material = qtri_material_default();
    qtri_transform pose;
    qtri_view view;
    start_view(&view, &pose, WIDTH, HEIGHT);
    for (int n = 0; n < 5; n++) {
        canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
        const qtri_corner corner[3] = {
            {.position = {-Q16_ONE / 2, -Q16_ONE / 2, 0, Q16_ONE}, .color = half[n]},
            {.position = {Q16_ONE / 2, -Q16_ONE / 2, 0, Q16_ONE}, .color = half[n]},
            {.position = {0, Q16_ONE / 2, 0, Q16_ONE}, .color = half[n]}};
        qtri_draw_triangles(&c.surface, &view, &pose, corner, 3, &material);
        assert_int_equal(stored_pixel(&c.surface, WIDTH / 2, HEIGHT / 2), 128);
        canvas_free(&c);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
