/* SPDX-License-Identifier: MIT */
/*
 * Alpha that varies between vertices, against exact arithmetic, and in pieces; depths moved by
 * the slope of a triangle.
 */
#include "support/core.h"

enum { WIDTH = 120, HEIGHT = 90 };

/* Of a colour 0..255 in steps of the format's channel. */
static double steps_of(const qtri_format *format, const double rgb[3], int channel)
{
    if (format->colors == &qtri_colors_gray) {
        return .299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2];
    }
    return format->colors == &qtri_colors_565 ? rgb[channel] * (channel == 1 ? 63 : 31) / 255
                                              : rgb[channel];
}

/* A stored pixel's channel in those steps. */
static double stored_steps(const qtri_format *format, uint32_t stored, int channel)
{
    const uint32_t decoded = format->decode(stored);
    const double value = decoded >> (16 - 8 * channel) & 255;
    return format->colors == &qtri_colors_565 ? round(value * (channel == 1 ? 63 : 31) / 255)
                                              : value;
}

static double w_of(const qtri_screen_vertex *v)
{
    return ldexp(v->inv_w_q31, v->inv_w_exponent - 31);
}

/* Weights of the vertices at a pixel's centre, on the surface of the triangle. */
static void weights_at(double b[3], const qtri_screen_vertex v[3], bool perspective, int32_t x,
                       int32_t y)
{
    const double px = x * 256 + 128;
    const double py = y * 256 + 128;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *p = &v[(i + 1) % 3];
        const qtri_screen_vertex *q = &v[(i + 2) % 3];
        b[i] = (p->x_24p8 - px) * (q->y_24p8 - py) - (q->x_24p8 - px) * (p->y_24p8 - py);
        b[i] *= perspective ? w_of(&v[i]) : 1;
        sum += b[i];
    }
    for (int i = 0; i < 3; i++) {
        b[i] /= sum;
    }
}

/* One triangle over one colour. */
typedef struct trial {
    qtri_screen_vertex v[3];
    uint8_t alphas[3];
    qtri_rgb sky;
    qtri_material material;
} trial;

static void random_trial(trial *t, uint64_t *seed)
{
    t->material = plain_material();
    t->material.shading = random_flag(seed) ? QTRI_SMOOTH : QTRI_FLAT_FIRST;
    t->material.blend = random_flag(seed) ? &qtri_blend_vertex_alpha : &qtri_blend_vertex_add;
    t->material.alpha = random_flag(seed) ? 255 : (uint8_t)random_in(seed, 0, 255);
    t->material.interpolation = random_flag(seed) ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
    t->material.alphas = t->alphas;
    const int32_t x = random_in(seed, 0, WIDTH * 256);
    const int32_t y = random_in(seed, 0, HEIGHT * 256);
    const int32_t reach = random_flag(seed) ? 4000 : 60000;
    const int32_t far = random_in(seed, 0, 6);
    for (int i = 0; i < 3; i++) {
        t->v[i] = screen_at(x + random_in(seed, -reach, reach), y + random_in(seed, -reach, reach));
        t->v[i].inv_w_q31 = 0x80000000u + (uint32_t)random_in(seed, 0, 0x7FFFFFFF);
        t->v[i].inv_w_exponent = random_in(seed, -far, 0);
        for (int k = 0; k < 3; k++) {
            t->v[i].color_8p16[k] = random_in(seed, 0, 255 << 16);
        }
        t->alphas[i] = random_in(seed, 0, 3) == 0 ? 255 : (uint8_t)random_in(seed, 0, 255);
    }
    t->sky.r = (uint8_t)random_in(seed, 0, 255);
    t->sky.g = (uint8_t)random_in(seed, 0, 255);
    t->sky.b = (uint8_t)random_in(seed, 0, 255);
}

/* What a channel, in steps, is to be. */
static double expected(const trial *t, const qtri_format *format, uint32_t before,
                       const double b[3], int channel)
{
    const bool smooth = t->material.shading == QTRI_SMOOTH;
    const double white[3] = {255, 255, 255};
    double color[3] = {0};
    double alpha = 0;
    for (int i = 0; i < 3; i++) {
        alpha += b[i] * t->alphas[i] / 255.0;
        for (int k = 0; k < 3; k++) {
            color[k] += (smooth ? b[i] : i == 0) * t->v[i].color_8p16[k] / 65536.0;
        }
    }
    alpha *= t->material.alpha / 255.0;
    const double over = steps_of(format, color, channel);
    const double under = stored_steps(format, before, channel);
    return t->material.blend == &qtri_blend_vertex_alpha
               ? over * alpha + under * (1 - alpha)
               : fmin(steps_of(format, white, channel), under + over * alpha);
}

/* The greatest difference, in steps, of a format's pixels. */
static double worst_of(const qtri_format *format)
{
    uint64_t seed = 7;
    canvas drawn = canvas_new(format, WIDTH, HEIGHT);
    canvas before = canvas_new(format, WIDTH, HEIGHT);
    canvas covered = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    double worst = 0;
    for (int n = 0; n < (long_run() ? 5000 : 150); n++) {
        trial t;
        random_trial(&t, &seed);
        const bool perspective = t.material.interpolation == QTRI_PERSPECTIVE;
        qtri_screen_vertex solid[3] = {t.v[0], t.v[1], t.v[2]};
        solid[0].color_8p16[0] = solid[0].color_8p16[1] = solid[0].color_8p16[2] = 255 << 16;
        const qtri_material plain = plain_material();
        qtri_surface_clear(&drawn.surface, t.sky, 65535);
        qtri_surface_clear(&before.surface, t.sky, 65535);
        canvas_clear(&covered);
        qtri_raster_triangle(&drawn.surface, &t.material, t.v);
        qtri_raster_triangle(&covered.surface, &plain, solid);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH;
            const int32_t y = i / WIDTH;
            const uint32_t is = stored_pixel(&drawn.surface, x, y);
            const uint32_t was = stored_pixel(&before.surface, x, y);
            if (stored_pixel(&covered.surface, x, y) == 0) {
                assert_int_equal(is, was);
                continue;
            }
            double b[3];
            weights_at(b, t.v, perspective, x, y);
            for (int k = 0; k < 3; k++) {
                const double d =
                    fabs(stored_steps(format, is, k) - expected(&t, format, was, b, k));
                worst = fmax(worst, d);
            }
        }
    }
    canvas_free(&drawn);
    canvas_free(&before);
    canvas_free(&covered);
    return worst;
}

static void is_exact(void **state)
{
    (void)state;
    for (int f = 0; f < 6; f++) {
        const qtri_format *format = drawn_format(f);
        const double worst = worst_of(format);
        /* Colours of gray are rounded once more. */
        const double most = format->colors == &qtri_colors_565 ? .75 : 1.05;
        assert_true(worst <= (format->colors == &qtri_colors_gray ? 1.3 : most));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
