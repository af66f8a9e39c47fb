/* SPDX-License-Identifier: MIT */
/*
 * How far blends and fog are from exact arithmetic, at most (qtri/material.h): every colour of a
 * channel, at the fractions that round farthest, over every stored one, with every alpha; and the
 * inputs that are off the most.
 */
#include "support/core.h"
#include "support/steps.h"

#include "qtri/body/color.h"

enum { WIDTH = 256, LEVELS = 256 };

typedef struct farthest {
    double off; /* steps */
    double color, under, share;
} farthest;

static void keep_farthest(farthest *f, double off, double color, double under, double share)
{
    if (fabs(off) > f->off) {
        const farthest is = {fabs(off), color, under, share};
        *f = is;
    }
}

static double mixed(const qtri_blend *blend, double over, double under, double alpha, double most)
{
    if (blend == &qtri_blend_none) {
        return under;
    }
    if (blend == &qtri_blend_multiply) {
        return over * under / most;
    }
    return blend == &qtri_blend_add ? fmin(most, under + over * alpha)
                                    : over * alpha + under * (1 - alpha);
}

/* Pixels each as many steps as its column is, of those that there are. */
static void store_levels(canvas *c)
{
    const int32_t bytes = c->surface.format->pixels->bytes;
    const bool is_swapped = c->surface.format == &qtri_rgb565_swapped;
    for (uint32_t x = 0; x < WIDTH; x++) {
        const uint16_t stored16 = (uint16_t)((x & 31) << 11 | (x & 63) << 5 | (x & 31));
        const uint32_t stored32 = x * 0x010101;
        const uint8_t stored8 = (uint8_t)x;
        const uint16_t swapped = (uint16_t)(stored16 << 8 | stored16 >> 8);
        const void *stored = bytes == 1   ? (const void *)&stored8
                             : bytes == 2 ? (const void *)(is_swapped ? &swapped : &stored16)
                                          : &stored32;
        memcpy(c->surface.pixels + (int32_t)x * bytes, stored, (size_t)bytes);
    }
}

/* A triangle over all of them, whose colours, 16.16 of 255, are `from` where x is -1/2 and `to` 2
   WIDTH further. */
static void draw(canvas *c, const qtri_material *m, const int32_t from[3], const int32_t to[3],
                 uint32_t depth, uint32_t depth_step)
{
    qtri_screen_vertex v[3] = {screen_at(-128, -256), screen_at(-128, 1024),
                               screen_at((2 * WIDTH << 8) - 128, -256)};
    for (int i = 0; i < 3; i++) {
        v[i].depth_16p16 = depth + (i == 2 ? 2 * WIDTH * depth_step : 0);
        memcpy(v[i].color_8p16, i == 2 ? to : from, sizeof v[i].color_8p16);
    }
    qtri_raster_triangle(&c->surface, qtri_pipelines_default, m, v);
}

/* The colour of 255 whose channels are nearest to so many steps. */
static void color_of(int32_t color[3], const qtri_format *format, double steps)
{
    for (int k = 0; k < 3; k++) {
        const double most = most_steps(format, k);
        const double held = fmin(most, fmax(0, steps));
        color[k] = (int32_t)lrint(held * 255 / most * 65536);
    }
}

/* Pixels of the canvas, where those before were store_levels(). */
static void judge(farthest *f, const canvas *c, const qtri_blend *blend, const int32_t color[3],
                  int32_t alpha)
{
    const qtri_format *format = c->surface.format;
    const int32_t levels = (int32_t)most_steps(format, 1) + 1;
    const int channels = format->colors == &qtri_colors_gray ? 1 : 3;
    for (int k = 0; k < channels; k++) {
        const double most = most_steps(format, k);
        const double over = color[k] / 65536.0 * most / 255;
        for (int32_t x = 0; x < levels; x++) {
            const double under = x & (int32_t)most;
            const double off = stored_steps(format, stored_pixel(&c->surface, x, 0), k) -
                               mixed(blend, over, under, alpha / 255.0, most);
            keep_farthest(f, off, over, under, alpha);
        }
    }
}

/* [0]: of any colours, [1]: of whole ones of 255. */
static void sweep(farthest f[2], const qtri_format *format, const qtri_blend *blend, bool is_smooth)
{
    canvas c = canvas_new(format, WIDTH, 1);
    const bool has_alpha = blend == &qtri_blend_alpha || blend == &qtri_blend_add;
    const bool is_other = is_smooth || format == &qtri_rgb565_swapped ||
                          format->pixels->bytes == 3; /* as others, or as flat ones */
    const int32_t most = (int32_t)most_steps(format, 1);
    qtri_material m = plain_material();
    m.cull = QTRI_CULL_NONE;
    m.shading = is_smooth ? QTRI_SMOOTH : QTRI_FLAT_FIRST;
    m.depth_compare = QTRI_DEPTH_OFF;
    m.blend = blend;
    memset(f, 0, 2 * sizeof *f);
    for (int32_t alpha = has_alpha ? 0 : 255; alpha < LEVELS;
         alpha += IS_SANITIZED || is_other ? 5 : 1) {
        m.alpha = (uint8_t)alpha;
        for (int32_t n = 0; n < 3 * (most + 1); n++) {
            int32_t color[3], to[3];
            color_of(color, format, n / 3 + (n % 3 - 1) * .49999);
            memcpy(to, color, sizeof to);
            to[1] ^= is_smooth; /* by a pipeline of colours that vary */
            store_levels(&c);
            draw(&c, &m, color, to, 0, 0);
            judge(&f[0], &c, blend, color, alpha);
            if (n % 3 == 1 && most == 255) {
                judge(&f[1], &c, blend, color, alpha);
            }
        }
    }
    canvas_free(&c);
}

TEST(blends)
{
    static const qtri_blend *const all[] = {&qtri_blend_alpha, &qtri_blend_add,
                                            &qtri_blend_multiply, &qtri_blend_none};
    /* Where they are reached: alpha 135, which is 136 of 256; of RGB565 alpha 251. */
    static const double most[2][4] = {{1.20588, 1.20588, .99610, 0}, {.99414, .99414, .99210, 0}};
    for (int n = 0; n < 48; n++) {
        const qtri_format *format = drawn_format(n / 8);
        const bool is_smooth = n % 2 == 1;
        const double bound = most[format->colors == &qtri_colors_565][n / 2 % 4];
        farthest f[2];
        sweep(f, format, all[n / 2 % 4], is_smooth);
        print_message("format %d blend %d: %.5f of a step: %.3f over %.0f, alpha %.0f; %.5f\n",
                      n / 8, n / 2 % 4, f[0].off, f[0].color, f[0].under, f[0].share, f[1].off);
        assert_true(f[0].off <= bound && f[1].off <= .9412);
        assert_true(IS_SANITIZED || is_smooth || n / 8 > 2 || f[0].off >= bound - .001);
    }
}

/* How fog falls, and what falls in it. */
typedef struct foggy {
    int kind; /* linear, exp, exp2; 3: no fog */
    double near_z, far_z, start, end, density;
    bool orthographic;
    uint8_t gray;
    int32_t alpha;
    int32_t color[2];           /* at the left of the row and at the right of 2 WIDTH */
    uint32_t depth, depth_step; /* before the row's first pixel's centre, and a pixel */
} foggy;

static double share_at(const foggy *g, double depth)
{
    const double far_less = g->far_z - g->near_z;
    const double z = g->orthographic ? g->near_z + depth * far_less
                                     : g->near_z * g->far_z / (g->far_z - depth * far_less);
    if (g->kind == 3) {
        return 1;
    }
    if (g->kind == 0) {
        return fmin(1, fmax(0, (g->end - z) / (g->end - g->start)));
    }
    return exp(g->kind == 1 ? -g->density * z : -(g->density * z) * (g->density * z));
}

static foggy random_foggy(uint64_t *seed, bool is_smooth, bool is_opaque)
{
    foggy g;
    g.kind = random_in(seed, 0, 2);
    g.near_z = random_in(seed, 6553, 65536) / 65536.0;
    g.far_z = g.near_z + random_in(seed, 65536, 100 * 65536) / 65536.0;
    g.start = random_in(seed, 0, 65536 * 4) / 65536.0;
    g.end = g.start + random_in(seed, 65536, 60 * 65536) / 65536.0;
    g.density = random_in(seed, 0, 32768) / 65536.0;
    g.orthographic = random_flag(seed);
    g.gray = (uint8_t)random_in(seed, 0, 255);
    g.alpha = is_opaque ? 255 : random_in(seed, 0, 255);
    g.color[0] = random_in(seed, 0, 255 << 16);
    g.color[1] = is_smooth ? random_in(seed, 0, 255 << 16) : g.color[0];
    g.depth = (uint32_t)random_in(seed, 0, 65535) << random_in(seed, 5, 15);
    g.depth_step = (uint32_t)random_in(seed, 0, 1 << random_in(seed, 0, 22));
    return g;
}

static void draw_foggy(canvas *c, const foggy *g)
{
    const qtri_fog_range range = {fixed(g->near_z), fixed(g->far_z), g->orthographic};
    const qtri_rgb gray = {g->gray, g->gray, g->gray};
    qtri_fog fog;
    qtri_material m = plain_material();
    m.cull = QTRI_CULL_NONE;
    m.shading = g->color[0] == g->color[1] ? QTRI_FLAT_FIRST : QTRI_SMOOTH;
    m.depth_compare = QTRI_ALWAYS;
    m.fog = g->kind == 3 ? NULL : &fog;
    m.blend = g->alpha == 255 ? NULL : &qtri_blend_alpha;
    m.alpha = (uint8_t)g->alpha;
    if (g->kind == 0) {
        qtri_fog_linear(&fog, gray, range, fixed(g->start), fixed(g->end));
    } else {
        (g->kind == 1 ? qtri_fog_exp : qtri_fog_exp2)(&fog, gray, range, fixed(g->density));
    }
    const int32_t from[3] = {g->color[0], g->color[0], g->color[0]};
    const int32_t to[3] = {g->color[1], g->color[1], g->color[1]};
    draw(c, &m, from, to, g->depth, g->depth_step);
}

static void judge_fog(farthest *f, const canvas *c, const foggy *g)
{
    const qtri_format *format = c->surface.format;
    const int channels = format->colors == &qtri_colors_gray ? 1 : 3;
    for (int32_t x = 0; x <= most_steps(format, 1); x++) {
        const double depth = (g->depth + (double)g->depth_step * (x + 1)) / 65536 / 65535;
        if (depth > 1) {
            break;
        }
        const double share = share_at(g, depth);
        const double color =
            (g->color[0] + (g->color[1] - g->color[0]) * (x + 1.) / (2 * WIDTH)) / 65536;
        for (int k = 0; k < channels; k++) {
            const double most = most_steps(format, k);
            const double over = (share * color + (1 - share) * g->gray) * most / 255;
            const double under = x & (int32_t)most;
            const double should = over * g->alpha / 255 + under * (255 - g->alpha) / 255;
            const double off = stored_steps(format, stored_pixel(&c->surface, x, 0), k) - should;
            keep_farthest(f, off, color, g->gray, share);
        }
    }
}

/* Fog of every kind along rows, into which colours vary that are opaque or not. */
TEST(fogs)
{
    static const qtri_format *const formats[] = {&qtri_xrgb8888, &qtri_gray8, &qtri_rgb565};
    static const double most[3][2] = {{1.75, 2}, {1.75, 2}, {.85, .9}}; /* opaque, and alpha */
    uint64_t seed = 1;
    for (int n = 0; n < 12; n++) {
        canvas c = canvas_new(formats[n / 4], WIDTH, 1);
        farthest f = {0, 0, 0, 0};
        for (int i = 0; i < repeats(10000); i++) {
            const foggy g = random_foggy(&seed, n % 2 == 1, n / 2 % 2 == 0);
            store_levels(&c);
            draw_foggy(&c, &g);
            judge_fog(&f, &c, &g);
        }
        print_message("fog, format %d, %s, %s: %.4f of a step: %.3f in %.0f, share %.6f\n", n / 4,
                      n % 2 == 0 ? "flat" : "smooth", n / 2 % 2 == 0 ? "opaque" : "alpha", f.off,
                      f.color, f.under, f.share);
        assert_true(f.off <= most[n / 4][n / 2 % 2]);
        canvas_free(&c);
    }
}

/* Colours that vary along a row, which themselves are off by more than half a step. */
TEST(smooth_blends)
{
    static const qtri_format *const formats[] = {&qtri_xrgb8888, &qtri_gray8, &qtri_rgb565};
    static const double most[] = {1.25, 1.25, 1.25};
    uint64_t seed = 2;
    for (int n = 0; n < 3; n++) {
        canvas c = canvas_new(formats[n], WIDTH, 1);
        farthest f = {0, 0, 0, 0};
        for (int i = 0; i < repeats(20000); i++) {
            foggy g = random_foggy(&seed, true, false);
            g.kind = 3;
            store_levels(&c);
            draw_foggy(&c, &g);
            judge_fog(&f, &c, &g);
        }
        print_message("smooth, format %d: %.4f of a step\n", n, f.off);
        assert_true(f.off <= most[n]);
        canvas_free(&c);
    }
}

static uint16_t stored_fine(uint32_t color, uint32_t share, uint32_t under)
{
    return (uint16_t)qtri_color_fade_fine(color, share, under);
}

/* Fine colours: of all of RGB565 exactly, of 888 but for .86, green .54, alpha kept; their mixtures
   to nearest. */
TEST(fine_colors_are_rounded_once)
{
    for (uint32_t c = 0; c < 65536; c++) {
        const uint32_t fine = qtri_pixel_565_to_fine(c);
        assert_int_equal(fine, (c >> 11) << 19 | (c >> 5 & 63) << 10 | (c & 31) << 3);
        assert_int_equal(stored_fine(fine, 256, ~fine & 0xF8FCF8), c);
        assert_int_equal(stored_fine(~fine & 0xF8FCF8, 0, fine), c);
    }
    for (uint32_t c = 0; c < 256; c++) {
        const uint32_t fine = qtri_pixel_888_to_fine(c << 24 | c << 16 | (255 - c) << 8 | c);
        assert_int_equal(fine >> 24, c);
        assert_true(fabs((fine >> 16 & 255) - c * 248 / 255.) < .86);
        assert_true(fabs((fine >> 8 & 255) - (255 - c) * 252 / 255.) < .54);
        assert_true(fabs((fine & 255) - c * 248 / 255.) < .86);
    }
    for (uint32_t n = 0; n < 249 * 257; n += 13) {
        const uint32_t over = n % 249, share = n / 249;
        for (uint32_t under = 0; under <= 252; under++) {
            const uint32_t lane = under > 248 ? 248 : under, top = under < 252 - over ? over : 252;
            const uint32_t mix = stored_fine(over << 16 | top << 8 | (248 - over), share,
                                             lane << 16 | under << 8 | (248 - lane));
            assert_int_equal(mix >> 11, (over * share + lane * (256 - share) + 1024) / 2048);
            assert_int_equal(mix >> 5 & 63, (top * share + under * (256 - share) + 512) / 1024);
            assert_int_equal(mix & 31,
                             ((248 - over) * share + (248 - lane) * (256 - share) + 1024) / 2048);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
