/* SPDX-License-Identifier: MIT */
/*
 * Texels with alpha, filtered: against double precision, in every format of theirs.
 */
#include "support/texture.h"

enum { SIDE_LOG2 = 3, SIDE = 1 << SIDE_LOG2 };

static uint32_t texels[SIDE * SIDE]; /* in the format's own size */

/* A texel as alpha, red, green, blue of 255. */
static void texel_at(const qtri_texture *t, int column, int row, double argb[4])
{
    const int i = (row & (SIDE - 1)) * SIDE + (column & (SIDE - 1));
    uint32_t x = t->format == &qtri_texel_argb8888 ? texels[i]
                 : t->format == &qtri_texel_alpha8 ? ((const uint8_t *)texels)[i]
                                                   : ((const uint16_t *)texels)[i];
    for (int k = 0; k < 4; k++) {
        if (t->format == &qtri_texel_argb8888) {
            argb[k] = x >> (24 - 8 * k) & 255;
        } else if (t->format == &qtri_texel_argb4444) {
            argb[k] = (x >> (12 - 4 * k) & 15) * 17;
        } else if (t->format == &qtri_texel_argb1555) {
            argb[k] = k == 0 ? (x >> 15) * 255.0 : floor((x >> (15 - 5 * k) & 31) * 255 / 31. + .5);
        } else {
            argb[k] = k == 0 ? x : 255;
        }
    }
}

/* Alpha by the weights alone, colours by them times alpha. */
static void filtered(const qtri_texture *t, double column, double row, double argb[4])
{
    const double along = column - floor(column), across = row - floor(row);
    memset(argb, 0, 4 * sizeof *argb);
    for (int i = 0; i < 4; i++) {
        double tap[4];
        texel_at(t, (int)floor(column) + i % 2, (int)floor(row) + i / 2, tap);
        const double weight =
            (i % 2 ? along : 1 - along) * (i / 2 ? across : 1 - across) * tap[0] / 255;
        argb[0] += weight * 255;
        for (int k = 1; k < 4; k++) {
            argb[k] += weight * tap[k];
        }
    }
    for (int k = 1; k < 4 && argb[0] > 0; k++) {
        argb[k] *= 255 / argb[0];
    }
}

static void random_texels(uint64_t *seed, int n)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        texels[i] = (uint32_t)random64(seed);
        if (n % 3 == 0) { /* as cut-outs have it */
            texels[i] |= random_flag(seed) ? 0xFF000000u : 0;
            texels[i] &= texels[i] >> 24 == 255 ? UINT32_MAX : 0x00FFFFFFu;
        }
    }
}

/* The whole canvas, u and v from 0 to 1, in parts x parts quads: of two each is small. */
static void draw_parts(const canvas *c, const qtri_material *m, int parts)
{
    for (int i = 0; i < parts * parts; i++) {
        qtri_screen_vertex q[4];
        for (int k = 0; k < 4; k++) {
            const int column = i % parts + (k == 1 || k == 2), row = i / parts + k / 2;
            q[k] = screen_at(column * WIDTH * 256 / parts, row * HEIGHT * 256 / parts);
            q[k].u_q32 = ((int64_t)1 << 32) * column / parts;
            q[k].v_q32 = ((int64_t)1 << 32) * row / parts;
        }
        qtri_screen_vertex second[3] = {q[0], q[2], q[3]};
        qtri_raster_triangle(&c->surface, qtri_pipelines_default, m, q);
        qtri_raster_triangle(&c->surface, qtri_pipelines_default, m, second);
    }
}

static const qtri_texel_format *const formats[4] = {&qtri_texel_argb8888, &qtri_texel_argb4444,
                                                    &qtri_texel_argb1555, &qtri_texel_alpha8};

/* Largest difference of a channel, of 255; wrongly drawn or left out. */
static double worst_of(const qtri_texel_format *format, const qtri_filter *filter, bool blended,
                       int parts, int *wrong)
{
    uint64_t seed = 5001;
    double worst = 0;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    const qtri_rgb sky = {40, 90, 200};
    const double under[3] = {40, 90, 200};
    for (int n = 0; n < 40; n++) {
        qtri_texture t = {.texels = texels,
                          .format = format,
                          .width_log2 = SIDE_LOG2,
                          .height_log2 = SIDE_LOG2,
                          .filter = filter};
        qtri_material m = plain_material();
        random_texels(&seed, n);
        m.texture = &t;
        m.texture_mode = n % 2 == 0 ? QTRI_REPLACE : QTRI_MODULATE; /* by white */
        m.blend = blended ? &qtri_blend_alpha : NULL;
        m.alpha = 255;
        m.least_alpha = (uint8_t)(blended && n % 4 != 1 ? 0 : random_in(&seed, 1, 255));
        qtri_surface_clear(&c.surface, sky);
        draw_parts(&c, &m, parts);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            const qtri_rgb is = qtri_surface_pixel(&c.surface, x, y);
            const double got[3] = {is.r, is.g, is.b};
            double argb[4];
            double off = 0, off_without = 0;
            filtered(&t, (x + .5) / WIDTH * SIDE - .5, (y + .5) / HEIGHT * SIDE - .5, argb);
            for (int k = 0; k < 3; k++) {
                const double share = blended ? argb[0] / 255 : 1;
                const double expected = argb[k + 1] * share + under[k] * (1 - share);
                off = fmax(off, fabs(got[k] - expected));
                off_without = fmax(off_without, fabs(got[k] - under[k]));
            }
            if (fabs(argb[0] - m.least_alpha) < 1) { /* either: by rounding */
                off = fmin(off, off_without);
            } else if (argb[0] < m.least_alpha) {
                *wrong += off_without > 0;
                continue;
            }
            worst = fmax(worst, off);
        }
    }
    canvas_free(&c);
    return worst;
}

TEST(filters_alpha)
{
    for (int f = 0; f < 4; f++) {
        for (int blended = 0; blended < 2; blended++) {
            int wrong = 0;
            const double large = worst_of(formats[f], &qtri_bilinear, blended, 1, &wrong);
            const double small = worst_of(formats[f], &qtri_bilinear, blended, 2, &wrong);
            print_message("format %d, %s: off by %.3f of 255, small %.3f, %d wrong\n", f,
                          blended ? "blended" : "cut out", large, small, wrong);
            assert_true(large < (blended ? 1.6 : 1.2));
            assert_true(small <
                        (blended ? 2.2 : 4)); /* 1/256 of a texel more, from black to white */
            assert_int_equal(wrong, 0);
        }
    }
}

/* As a level of a texture: the whole quad shows fewer texels than there are pixels. */
TEST(filters_alpha_of_levels)
{
    int wrong = 0;
    const double worst = worst_of(&qtri_texel_argb8888, &qtri_mipmapped_bilinear, true, 1, &wrong);
    assert_true(worst < 1.6);
    assert_int_equal(wrong, 0);
}

/* Where nothing asks for alpha it is not looked at. */
TEST(is_opaque_without)
{
    uint64_t seed = 5002;
    canvas a = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas b = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    static const int grays[3] = {200, 100, 50};
    random_texels(&seed, 0);
    qtri_texture t = {.texels = texels,
                      .format = &qtri_texel_argb8888,
                      .width_log2 = SIDE_LOG2,
                      .height_log2 = SIDE_LOG2,
                      .filter = &qtri_bilinear};
    qtri_material m = plain_material();
    m.texture = &t;
    draw_quad(&a, &m, grays);
    t.format = &qtri_texel_xrgb8888;
    draw_quad(&b, &m, grays);
    assert_memory_equal(a.memory, b.memory, a.bytes);
    canvas_free(&a);
    canvas_free(&b);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
