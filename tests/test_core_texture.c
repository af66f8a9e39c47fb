/* SPDX-License-Identifier: MIT */
/*
 * Texture fetch: the texel under each pixel against double arithmetic, for every size and format,
 * near and far from the origin; replace and modulate; textures that are none.
 */
#include "support_texture.h"

enum { SIDE = 1024 };

/* Every texel is its own address. */
static uint32_t address_texels[SIDE * SIDE];

static qtri_texture address_texture(int width_log2, int height_log2)
{
    qtri_texture t = {
        .texels = address_texels,
        .format = &qtri_texel_xrgb8888,
        .width_log2 = (uint8_t)width_log2,
        .height_log2 = (uint8_t)height_log2,
    };
    for (uint32_t i = 0; i < 1u << (width_log2 + height_log2); i++) {
        address_texels[i] = i;
    }
    return t;
}

/* How far a coordinate, in texels, is outside of texel `index` of a side that repeats. */
static double outside(double coordinate, int index, int side)
{
    double offset = coordinate - index;
    offset -= floor(offset / side) * side; /* 0..side */
    if (offset <= 1) {
        return 0;
    }
    return fmin(offset - 1, side - offset);
}

/* Largest distance between a coordinate and the texel that was fetched for it, of the bound. */
static double worst_texel(uint64_t seed, int count, int32_t reach, int32_t uv_reach, int size_log2)
{
    double worst = 0;
    int pixels = 0;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < count; n++) {
        int width_log2 = size_log2 >= 0 ? size_log2 : random_in(&seed, 0, 10);
        int height_log2 = size_log2 >= 0 ? size_log2 : random_in(&seed, 0, 10);
        qtri_texture texture = address_texture(width_log2, height_log2);
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        m.texture = &texture;
        m.texture_mode = QTRI_REPLACE;
        m.interpolation = (qtri_interpolation)(n % 2);
        m.shading = shading_of(n / 2 % 3);
        m.depth_compare = QTRI_LESS;
        random_triangle(v, &seed, reach, uv_reach);
        for (int i = 0; i < 3; i++) {
            v[i].color_8p16[i] = 7 << 16; /* does not matter */
        }
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int32_t x = i % WIDTH;
            int32_t y = i / WIDTH;
            if (stored_depth(&c.surface, x, y) == 65535) {
                continue;
            }
            uint32_t texel = stored_pixel(&c.surface, x, y);
            double u = perspective_sum(v, x, y, n % 2 == 0, false) * (1 << width_log2);
            double t = perspective_sum(v, x, y, n % 2 == 0, true) * (1 << height_log2);
            worst =
                fmax(worst, outside(u, (int)(texel & ((1u << width_log2) - 1)), 1 << width_log2) /
                                coordinate_unit(v, x, y, n % 2 == 0, false, 1 << width_log2));
            worst = fmax(worst, outside(t, (int)(texel >> width_log2), 1 << height_log2) /
                                    coordinate_unit(v, x, y, n % 2 == 0, true, 1 << height_log2));
            pixels++;
        }
    }
    canvas_free(&c);
    assert_true(pixels > 1000);
    return worst;
}

static void texels(void **state)
{
    (void)state;
    double usual = worst_texel(91, 600, 6000, Q16(2), 6);
    double sizes = worst_texel(92, 600, 12000, Q16(4), -1);
    double large = worst_texel(93, 300, 1 << 19, Q16(20), 8);
    double guard_band = worst_texel(94, 300, 4100000, Q16(100), 8);
    double far_out = worst_texel(95, 600, 6000, Q16(30000), 8);
    print_message(
        "off, of the bound: 64 on screen %.6f, any size %.6f, 2048 px %.6f, guard band %.6f, "
        "coordinates of 30000 %.4f\n",
        usual, sizes, large, guard_band, far_out);
    assert_true(usual <= 1);
    assert_true(sizes <= 1);
    assert_true(large <= 1);
    assert_true(guard_band <= .02 * 256);
    assert_true(far_out <= 1);
}

/* A quad drawn one texel a pixel, anywhere in the repeats: texel boundaries on pixel edges. */
static void pixel_for_texel(void **state)
{
    (void)state;
    static const int32_t origins[] = {0, 1, -1, 100, -100, 29990, -30010, 32767 - 2, -32768};
    canvas c = canvas_new(&qtri_xrgb8888, 32, 32);
    for (size_t n = 0; n < LENGTH_OF(origins); n++) {
        for (int log2 = 0; log2 <= 5; log2++) {
            qtri_texture texture = address_texture(log2, log2);
            qtri_material m = plain_material();
            m.texture = &texture;
            m.texture_mode = QTRI_REPLACE;
            qtri_screen_vertex q[4] = {screen_at(0, 0), screen_at(32 * 256, 0),
                                       screen_at(32 * 256, 32 * 256), screen_at(0, 32 * 256)};
            for (int i = 0; i < 4; i++) {
                int64_t base = (int64_t)origins[n] * 65536 * 65536;
                int64_t span = (int64_t)(32 >> log2) << 32;
                q[i].u_q32 = base + (i == 1 || i == 2 ? span : 0);
                q[i].v_q32 = base + (i >= 2 ? span : 0);
            }
            qtri_screen_vertex second[3] = {q[0], q[2], q[3]};
            qtri_raster_triangle(&c.surface, &m, q);
            qtri_raster_triangle(&c.surface, &m, second);
            for (int32_t i = 0; i < 32 * 32; i++) {
                uint32_t mask = (1u << log2) - 1;
                uint32_t expected =
                    ((uint32_t)(i / 32) & mask) << log2 | ((uint32_t)(i % 32) & mask);
                assert_int_equal(stored_pixel(&c.surface, i % 32, i / 32), expected);
            }
        }
    }
    canvas_free(&c);
}

static void modulates(void **state)
{
    (void)state;
    double worst = 0;
    uint64_t seed = 96;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < 3000; n++) {
        uint32_t one_texel = (uint32_t)random64(&seed) & 0xFFFFFFu;
        uint16_t one_565 = (uint16_t)random64(&seed);
        bool narrow = n % 2 != 0;
        if (n % 7 == 0) {
            one_texel = 0xFFFFFFu;
            one_565 = 0xFFFF;
        }
        qtri_texture texture = {.texels = &one_texel, .format = &qtri_texel_xrgb8888};
        if (narrow) {
            texture.texels = &one_565;
            texture.format = &qtri_texel_rgb565;
        }
        qtri_material m = plain_material();
        m.texture = &texture;
        int level[3] = {random_in(&seed, 0, 255), random_in(&seed, 0, 255), n % 256};
        draw_quad(&c, &m, level);
        uint32_t drawn = stored_pixel(&c.surface, 7, 9);
        int texel[3] = {(int)(one_texel >> 16), (int)(one_texel >> 8 & 255),
                        (int)(one_texel & 255)};
        if (narrow) {
            texel[0] = ((one_565 >> 11) * 255 + 15) / 31;
            texel[1] = ((one_565 >> 5 & 63) * 255 + 31) / 63;
            texel[2] = ((one_565 & 31) * 255 + 15) / 31;
        }
        for (int i = 0; i < 3; i++) {
            double is = drawn >> (16 - 8 * i) & 255;
            worst = fmax(worst, fabs(is - level[i] * texel[i] / 255.));
            assert_true(texel[i] != 255 || is == level[i]); /* white changes nothing */
        }
        m.texture_mode = QTRI_REPLACE;
        draw_quad(&c, &m, level);
        assert_int_equal(stored_pixel(&c.surface, 7, 9),
                         (uint32_t)(texel[0] << 16 | texel[1] << 8 | texel[2]));
    }
    print_message("modulate: %.4f of 255\n", worst);
    assert_true(worst <= .75); /* see stage_color.h */
    canvas_free(&c);
}

static void checkers(void **state)
{
    (void)state;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    static const int fields[] = {0, 1, 2, 8, 3, 64, 65535};
    for (size_t n = 0; n < LENGTH_OF(fields); n++) {
        qtri_texture texture = {
            .format = &qtri_texel_checker,
            .width_log2 = 6,
            .height_log2 = 5,
            .fields = (uint16_t)fields[n],
            .color = {{255, 0, 1}, {2, 255, 3}},
        };
        qtri_material m = plain_material();
        const int white[3] = {255, 255, 255};
        m.texture = &texture;
        draw_quad(&c, &m, white);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            int x = i % WIDTH;
            int y = i / WIDTH;
            /* texel under the centre, never on a boundary here */
            int column = (2 * x + 1) * 64 / (2 * WIDTH);
            int row = (2 * y + 1) * 32 / (2 * HEIGHT);
            int field = column * fields[n] / 64 + row * fields[n] / 32;
            assert_int_equal(stored_pixel(&c.surface, x, y), field % 2 ? 0x02FF03 : 0xFF0001);
        }
    }
    canvas_free(&c);
}

/* No texels, no format, sides too large: untextured or held to 1024. */
static void odd_textures(void **state)
{
    (void)state;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    static const qtri_texture zeroed;
    qtri_texture none = {.format = &qtri_texel_xrgb8888, .width_log2 = 3, .height_log2 = 3};
    qtri_material m = plain_material();
    const int level[3] = {10, 20, 30};
    m.texture = &zeroed;
    draw_quad(&c, &m, level);
    assert_int_equal(stored_pixel(&c.surface, 3, 3), 0x0A141E);
    m.texture = &none;
    m.texture_mode = QTRI_REPLACE;
    draw_quad(&c, &m, level);
    assert_int_equal(stored_pixel(&c.surface, 3, 3), 0x0A141E);
    qtri_texture huge = address_texture(10, 10);
    qtri_texture same = huge;
    huge.width_log2 = 255;
    huge.height_log2 = 11;
    canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    m.texture = &huge;
    draw_quad(&c, &m, level);
    m.texture = &same;
    draw_quad(&d, &m, level);
    assert_same_picture(&c.surface, &d.surface);
    canvas_free(&c);
    canvas_free(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(texels),   cmocka_unit_test(pixel_for_texel), cmocka_unit_test(modulates),
        cmocka_unit_test(checkers), cmocka_unit_test(odd_textures),
    };
    return cmocka_run_group_tests_name("core texture", tests, NULL, NULL);
}
