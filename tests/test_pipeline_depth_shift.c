/* SPDX-License-Identifier: MIT */
/* Depths moved by slope (material.depth_shift) by pipelines, of small and of large triangles. */
#include "support/by_pipeline.h"
#include "support/texture.h"

/* What is added to depths, in steps of 16 bits. */
static double shift_of(const qtri_screen_vertex v[3], q16 depth_slope)
{
    const double x1 = v[1].x_24p8 - v[0].x_24p8, y1 = v[1].y_24p8 - v[0].y_24p8;
    const double x2 = v[2].x_24p8 - v[0].x_24p8, y2 = v[2].y_24p8 - v[0].y_24p8;
    const double z0 = v[0].depth_16p16 / 65536.0, z1 = v[1].depth_16p16 / 65536.0;
    const double z2 = v[2].depth_16p16 / 65536.0;
    const double area = x1 * y2 - x2 * y1;
    const double right = ((z1 - z0) * y2 - (z2 - z0) * y1) / area * 256;
    const double down = ((z2 - z0) * x1 - (z1 - z0) * x2) / area * 256;
    double by = depth_slope / 65536.0 * fmax(fabs(right), fabs(down));
    by = fmax(by, -fmin(z0, fmin(z1, z2)));
    return fmin(by, 65535 - fmax(z0, fmax(z1, z2)));
}

TEST(every_pixel_is_moved_by_the_slope)
{
    uint64_t seed = 41;
    double most = 0;
    int pixels = 0;
    canvas moved = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas plain = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < 1200; n++) {
        qtri_screen_vertex v[3];
        qtri_material m = plain_material();
        const int32_t reach = n % 2 == 0 ? 9000 : 0, depth = random_in(&seed, 0, 65535);
        m.depth_compare = QTRI_ALWAYS;
        m.depth_slope =
            random_in(&seed, 0, 9) == 0 ? random_any(&seed) : random_in(&seed, -300000, 300000);
        for (int i = 0; i < 3; i++) {
            v[i] = screen_at(random_in(&seed, -reach, WIDTH * 256 + reach),
                             random_in(&seed, -reach, HEIGHT * 256 + reach));
            v[i].depth_16p16 = (uint32_t)random_in(&seed, 0, 65535) << 16;
            if (n % 4 == 1) { /* as meshes have them: small triangles are drawn as such */
                const int32_t z = depth + random_in(&seed, -900, 900);
                v[i].depth_16p16 = (uint32_t)(z < 0 ? 0 : z > 65535 ? 65535 : z) << 16;
            }
        }
        canvas_clear(&moved);
        canvas_clear(&plain);
        draw_by_pipeline(&plain.surface, &m, v);
        m.depth_shift = &qtri_slope_bias;
        draw_by_pipeline(&moved.surface, &m, v);
        const double by = shift_of(v, m.depth_slope);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            const uint32_t color = stored_pixel(&plain.surface, x, y);
            assert_int_equal(stored_pixel(&moved.surface, x, y), color);
            if (color != 0) {
                const double off =
                    stored_depth(&moved.surface, x, y) - (stored_depth(&plain.surface, x, y) + by);
                most = fmax(most, fabs(off));
                pixels++;
            }
        }
    }
    canvas_free(&moved);
    canvas_free(&plain);
    print_message("%d pixels, off by %.3f steps at most\n", pixels, most);
    assert_true(pixels > 100000 && most < 1.01);
}

/* The steepest triangles, of an area of half a unit and sides of up to 8192 pixels, whose shift is
   held to the greatest depth; the first vertex is the one pixel's centre. */
TEST(the_steepest_are_held_to_the_range)
{
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int log2 = 0; log2 < 22; log2++) {
        const int32_t x = 3 * 256 + 128, y = 5 * 256 + 128;
        qtri_screen_vertex v[3] = {screen_at(x, y), screen_at(x + 1, y),
                                   screen_at(x + (1 << log2), y + 1)};
        qtri_material m = plain_material();
        m.depth_compare = QTRI_ALWAYS;
        m.depth_slope = Q16_ONE;
        m.depth_shift = &qtri_slope_bias;
        v[0].depth_16p16 = 1000 << 16;
        v[1].depth_16p16 = 60000u << 16;
        v[2].depth_16p16 = 60000u << 16;
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        assert_int_not_equal(stored_pixel(&c.surface, 3, 5), 0);
        assert_int_equal(stored_depth(&c.surface, 3, 5), 1000 + 65535 - 60000);
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
