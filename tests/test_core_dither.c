/* SPDX-License-Identifier: MIT */
/* Luma, ordered dither and error diffusion: exact ends, kept means, no seams, any arguments. */
#include "support/core.h"

#include <qtri/dither.h>

static const qtri_dither kinds[] = {QTRI_DITHER_NEAREST, QTRI_DITHER_BAYER4, QTRI_DITHER_BAYER8};

/* Every RGB565 and many XRGB8888 pixels, against double: to nearest, of exact ties either way. */
TEST(luma)
{
    uint16_t row[256];
    uint32_t wide[256];
    uint16_t swapped[256];
    uint8_t gray[256];
    uint8_t gray_of_swapped[256];
    uint64_t random = 1;
    double worst = 0;
    for (uint32_t high = 0; high < 256; high++) {
        qtri_surface s = {(uint8_t *)row, 512, NULL, 0, &qtri_rgb565, 256, 1, 0, 1,
                          {0, 0, 256, 1}, NULL};
        for (uint32_t low = 0; low < 256; low++) {
            row[low] = (uint16_t)(high << 8 | low);
            wide[low] = (uint32_t)random64(&random); /* the top byte does not count */
        }
        qtri_surface_gray(&s, 0, 0, 256, gray);
        for (uint32_t i = 0; i < 256; i++) {
            uint32_t c = row[i];
            double y =
                255 * (.299 * (c >> 11) / 31 + .587 * (c >> 5 & 63) / 63 + .114 * (c & 31) / 31);
            worst = fmax(worst, fabs(gray[i] - y));
        }
        for (int i = 0; i < 256; i++) {
            swapped[i] = (uint16_t)(row[i] << 8 | row[i] >> 8);
        }
        s.pixels = (uint8_t *)swapped;
        s.format = &qtri_rgb565_swapped;
        qtri_surface_gray(&s, 0, 0, 256, gray_of_swapped);
        assert_memory_equal(gray, gray_of_swapped, 256);
        s.pixels = (uint8_t *)wide;
        s.format = &qtri_xrgb8888;
        qtri_surface_gray(&s, 0, 0, 256, gray);
        for (uint32_t i = 0; i < 256; i++) {
            uint32_t c = wide[i];
            double y = .299 * (c >> 16 & 255) + .587 * (c >> 8 & 255) + .114 * (c & 255);
            worst = fmax(worst, fabs(gray[i] - y));
        }
    }
    assert_true(worst <= .50001);
}

/* Colours cleared into a GRAY8 surface and converted from the others are the same gray, or a tie.
 */
TEST(luma_of_formats)
{
    static const qtri_format *const formats[] = {&qtri_gray8, &qtri_xrgb8888, &qtri_rgb888,
                                                 &qtri_bgr888};
    uint64_t random = 2;
    for (int n = 0; n < 2000; n++) {
        uint32_t bits = (uint32_t)random64(&random);
        qtri_rgb color = {(uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16)};
        if ((299 * color.r + 587 * color.g + 114 * color.b) % 1000 == 500) {
            continue;
        }
        uint8_t gray[4];
        for (int i = 0; i < 4; i++) {
            canvas c = canvas_new(formats[i], 1, 1);
            qtri_surface_clear(&c.surface, color);
            qtri_surface_gray(&c.surface, 0, 0, 1, &gray[i]);
            canvas_free(&c);
            assert_int_equal(gray[0], gray[i]);
        }
    }
}

/* Black where a surface holds nothing; nothing else is read or written. */
TEST(luma_outside)
{
    static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_xrgb8888,
                                                 &qtri_bgr888, &qtri_rgb888,         &qtri_gray8};
    for (size_t n = 0; n < LENGTH_OF(formats); n++) {
        canvas c = canvas_band(formats[n], 5, 9, 3, 2);
        qtri_rgb white = {255, 255, 255};
        qtri_surface_clear(&c.surface, white);
        for (int32_t y = -1; y < 10; y++) {
            uint8_t gray[12];
            memset(gray, 7, sizeof gray);
            qtri_surface_gray(&c.surface, -3, y, 11, gray);
            for (int i = 0; i < 12; i++) {
                bool held = i >= 3 && i < 8 && y >= 3 && y < 5;
                assert_int_equal(gray[i], i == 11 ? 7 : (held ? 255 : 0));
            }
        }
        uint8_t far[4] = {1, 1, 1, 1};
        qtri_surface_gray(&c.surface, INT32_MAX - 1, 3, 4, far);
        qtri_surface_gray(&c.surface, INT32_MIN, INT32_MIN, 4, far);
        qtri_surface_gray(&c.surface, 0, INT32_MAX, 4, far);
        assert_int_equal(far[0] | far[1] | far[2] | far[3], 0);
        qtri_surface_gray(&c.surface, 0, 3, -5, NULL);
        canvas_free(&c);
    }
}

/* Thresholds are those of Bayer's matrix, by its recursion, and levels those of exact arithmetic.
 */
static int bayer(int order, int x, int y)
{
    static const int two[2][2] = {{0, 2}, {3, 1}};
    return order == 1 ? 0
                      : 4 * bayer(order / 2, x % (order / 2), y % (order / 2)) +
                            two[y / (order / 2)][x / (order / 2)];
}

TEST(ordered_levels)
{
    static const uint8_t most[] = {1, 2, 3, 15, 16, 254, 255};
    for (size_t m = 0; m < LENGTH_OF(most); m++) {
        for (int k = 0; k < 3; k++) {
            int order = k == 0 ? 1 : 2 << k;
            for (int value = 0; value < 256; value++) {
                int sum = 0;
                for (int y = 0; y < 8; y++) {
                    uint8_t gray[8];
                    memset(gray, value, 8);
                    qtri_dither_row(kinds[k], most[m], 0, y, gray, 8, gray);
                    for (int x = 0; x < 8; x++) {
                        int threshold = 2 * bayer(order, x % order, y % order) + 1;
                        int n = 2 * order * order;
                        int level = (value * most[m] * n + threshold * 255) / (255 * n);
                        assert_int_equal(gray[x], level);
                        sum += level;
                    }
                }
                double mean = sum / 64.0;
                double exact = value * most[m] / 255.0;
                assert_true(fabs(mean - exact) <= .5 / (order * order) + 1e-9);
                if (value * most[m] % 255 == 0) { /* a level, black and white among them: no dots */
                    assert_true(mean == exact);
                }
            }
        }
    }
}

/* A level depends on gray and coordinates alone: pieces, negative and huge coordinates, in place.
 */
TEST(ordered_places)
{
    uint64_t random = 3;
    for (int n = 0; n < 2000; n++) {
        uint8_t gray[40];
        uint8_t whole[40];
        uint8_t piece[40];
        for (size_t i = 0; i < sizeof gray; i++) {
            gray[i] = (uint8_t)random64(&random);
        }
        qtri_dither kind = kinds[n % 3];
        int32_t x = random_in(&random, -100, 100);
        int32_t y = random_any(&random);
        uint8_t most = n % 2 == 0 ? 1 : 15;
        qtri_dither_row(kind, most, x, y, gray, 40, whole);
        int32_t cut = random_in(&random, 0, 40);
        memcpy(piece, gray, sizeof gray);
        qtri_dither_row(kind, most, x, y, piece, cut, piece);
        qtri_dither_row(kind, most, x + cut, y, piece + cut, 40 - cut, piece + cut);
        assert_memory_equal(whole, piece, 40);
        qtri_dither_row(kind, most, x + 8, y ^ 8, gray, 40, piece);
        assert_memory_equal(whole, piece, 40);
    }
    uint8_t one[3] = {128, 128, 128};
    qtri_dither_row((qtri_dither)99, 1, INT32_MAX, INT32_MIN, one, 3, one); /* nearest */
    assert_true(one[0] == 1 && one[1] == 1 && one[2] == 1);
    qtri_dither_row(QTRI_DITHER_BAYER8, 0, 0, 0, one, 3, one);
    assert_true(one[0] == 0 && one[1] == 0 && one[2] == 0);
    qtri_dither_row(QTRI_DITHER_BAYER8, 1, 0, 0, NULL, -1, NULL);
}

/* Flat grays and ramps: the picture's mean is kept, ends are exact, levels stay in range. */
TEST(diffusion_means)
{
    enum { W = 64, H = 48 };
    double worst = 0;
    for (int n = 0; n < 2 * 257; n++) {
        uint8_t most = n % 2 == 0 ? 1 : 15;
        int value = n / 2;
        int16_t error[W];
        qtri_diffusion d;
        assert_ok(qtri_diffusion_init(&d, W, error, W));
        double gray_sum = 0;
        double level_sum = 0;
        for (int y = 0; y < H; y++) {
            uint8_t gray[W];
            uint8_t level[W];
            for (int x = 0; x < W; x++) {
                gray[x] = (uint8_t)(value < 256 ? value : 4 * x);
                gray_sum += gray[x];
            }
            qtri_diffuse_row(&d, most, 0, y, gray, W, level);
            for (int x = 0; x < W; x++) {
                assert_true(level[x] <= most);
                level_sum += level[x];
                if (value == 0 || value == 255) {
                    assert_int_equal(level[x], value == 0 ? 0 : most);
                }
            }
        }
        double off = fabs(level_sum / most - gray_sum / 255) * most / W; /* levels per column */
        worst = fmax(worst, off);
    }
    /* What is left is the error that would go to a row more: at most half a level a pixel. */
    if (worst > .5) {
        fail_msg("%g levels per column", worst);
    }
}

/* The weights, on one bright pixel: 7/16 right, 3/16, 5/16 and 1/16 below. */
TEST(diffusion_weights)
{
    int16_t error[5];
    qtri_diffusion d;
    for (int value = 0; value < 256; value++) { /* the nearest level */
        uint8_t level = (uint8_t)value;
        assert_ok(qtri_diffusion_init(&d, 1, error, 5));
        qtri_diffuse_row(&d, 15, 0, 0, &level, 1, &level);
        assert_int_equal(level, (value + 8) / 17);
    }
    assert_ok(qtri_diffusion_init(&d, 5, error, 5));
    uint8_t row[5] = {0, 0, 112, 0, 0};
    qtri_diffuse_row(&d, 1, 0, 0, row, 5, row);
    /* 112: 49 right, 21 35 7 below. 49: 21 right, 9 15 4 below. 21: 9, 3 6 3. 9 stays below. */
    static const int16_t expected[5] = {0, 21, 35 + 9, 7 + 15 + 3, 4 + 6 + 9 + 3};
    for (int i = 0; i < 5; i++) {
        assert_int_equal(row[i], 0);
    }
    assert_int_equal(error[0], expected[0]);
    assert_int_equal(error[1], expected[1]);
    assert_int_equal(error[2], expected[2]);
    assert_int_equal(error[0] + error[1] + error[2] + error[3] + error[4], 112);
}

/* Pieces of rows are the row; out of order begins a new picture; any arguments are safe. */
TEST(diffusion_order)
{
    enum { W = 37, H = 11 };
    uint64_t random = 4;
    uint8_t gray[H][W];
    uint8_t whole[H][W];
    uint8_t pieces[H][W];
    int16_t error[W + 2];
    error[W] = error[W + 1] = 1234;
    for (int y = 0; y < H; y++) {
        for (int x = 0; x < W; x++) {
            gray[y][x] = (uint8_t)random64(&random);
        }
    }
    qtri_diffusion d;
    assert_ok(qtri_diffusion_init(&d, W, error, W));
    for (int y = 0; y < H; y++) {
        qtri_diffuse_row(&d, 15, 0, y, gray[y], W, whole[y]);
    }
    for (int n = 0; n < 20; n++) {
        qtri_diffuse_row(&d, 15, 5, 3, gray[0], 9, pieces[0]); /* something else in between */
        for (int y = 0; y < H; y++) {
            for (int32_t x = 0; x < W;) {
                int32_t count = random_in(&random, 1, W - x);
                qtri_diffuse_row(&d, 15, x, y, gray[y] + x, count, pieces[y] + x);
                x += count;
            }
        }
        assert_memory_equal(whole, pieces, sizeof whole);
    }
    for (int n = 0; n < 20000; n++) { /* the worst input for errors that add up: extremes */
        uint8_t wild[60];
        for (size_t i = 0; i < sizeof wild; i++) {
            wild[i] = (uint8_t)(random_flag(&random) ? 127 * random_in(&random, 0, 2) : 255);
        }
        int32_t x = n % 3 == 0 ? random_any(&random) : random_in(&random, -30, 50);
        int32_t y = n % 2 == 0 ? random_any(&random) : n;
        uint8_t most = (uint8_t)random64(&random);
        qtri_diffuse_row(&d, most, x, y, wild, random_in(&random, -1, 60), wild);
        for (int i = 0; i < W; i++) {
            assert_true(abs(error[i]) < 1024);
        }
    }
    assert_true(error[W] == 1234 && error[W + 1] == 1234);
    assert_int_equal(qtri_diffusion_init(&d, 0, error, W), QTRI_ERROR_SIZE);
    assert_int_equal(qtri_diffusion_init(&d, QTRI_SURFACE_MAX + 1, error, 9999), QTRI_ERROR_SIZE);
    assert_int_equal(qtri_diffusion_init(&d, W + 1, error, W), QTRI_ERROR_MEMORY);
}

static void dither_565(qtri_dither kind, int32_t x, int32_t y, const uint32_t *rgb, int32_t count,
                       uint16_t *pixels)
{
    memset(pixels, 0xAA, (size_t)count * sizeof *pixels);
    qtri_dither_row_565(kind, x, y, rgb, count, pixels);
}

/* Colours of RGB565 come out as they are at every pixel of a field. */
TEST(colors_of_565_stay)
{
    static uint32_t rgb[65536];
    static uint16_t pixels[65536];
    for (uint32_t c = 0; c < 65536; c++) {
        rgb[c] = qtri_decode_rgb565(c) | 0xA5000000u; /* the top byte does not count */
    }
    for (size_t kind = 0; kind < LENGTH_OF(kinds); kind++) {
        for (int32_t n = 0; n < 64; n++) {
            dither_565(kinds[kind], n % 8, n / 8 - 8, rgb, 65536, pixels);
            for (uint32_t c = 0; c < 65536; c++) {
                assert_int_equal(pixels[c], c);
            }
        }
    }
}

/* Means of the three channels over a field, against double; a channel looks at itself alone. */
TEST(means_of_565)
{
    double worst = 0, worst_nearest = 0;
    for (size_t kind = 0; kind < LENGTH_OF(kinds); kind++) {
        for (uint32_t c = 0; c < 256; c++) {
            const uint32_t values[3] = {c, 255 - c, (c * 7) & 255};
            uint32_t rgb[8];
            double sum[3] = {0, 0, 0};
            for (int i = 0; i < 8; i++) {
                rgb[i] = values[0] << 16 | values[1] << 8 | values[2];
            }
            for (int32_t y = 0; y < 8; y++) {
                uint16_t pixels[8];
                dither_565(kinds[kind], INT32_MAX - 3, INT32_MIN + y, rgb, 8, pixels);
                for (int i = 0; i < 8; i++) {
                    sum[0] += (pixels[i] >> 11) * 255.0 / 31;
                    sum[1] += (pixels[i] >> 5 & 63) * 255.0 / 63;
                    sum[2] += (pixels[i] & 31) * 255.0 / 31;
                }
            }
            for (int i = 0; i < 3; i++) {
                const double error = fabs(sum[i] / 64 - values[i]);
                double *most = kinds[kind] == QTRI_DITHER_NEAREST ? &worst_nearest : &worst;
                *most = fmax(*most, error);
            }
        }
    }
    print_message("565: mean within %.3f of 255, to nearest %.3f\n", worst, worst_nearest);
    assert_true(worst < 0.78 && worst_nearest < 4.13);
}

/* Pieces of a row, in any order, are the row. */
TEST(pieces_of_565)
{
    uint64_t random = 8;
    uint32_t rgb[64];
    uint16_t whole[64], pieces[64];
    for (int n = 0; n < 300; n++) {
        const int32_t y = random_in(&random, -20, 20);
        const qtri_dither kind = (qtri_dither)(n % 5);
        for (int i = 0; i < 64; i++) {
            rgb[i] = (uint32_t)random64(&random);
        }
        dither_565(kind, -5, y, rgb, 64, whole);
        for (int32_t at = 0; at < 64;) {
            const int32_t length = random_in(&random, 0, 64 - at);
            qtri_dither_row_565(kind, at - 5, y, rgb + at, length, pieces + at);
            at += length;
        }
        assert_memory_equal(whole, pieces, sizeof whole);
        if (n % 5 > 2) { /* no dither: to nearest */
            qtri_dither_row_565(QTRI_DITHER_NEAREST, -5, y, rgb, 64, pieces);
            assert_memory_equal(whole, pieces, sizeof whole);
        }
    }
    qtri_dither_row_565(QTRI_DITHER_BAYER8, 0, 0, NULL, -1, NULL);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
