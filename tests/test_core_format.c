/* SPDX-License-Identifier: MIT */
/*
 * Formats of surfaces: what is stored and what it means, and the loops that store it, against a
 * plain model of memory.
 */
#include "support/core.h"

#include <qtri/dither.h>

#include "frame/pixel.h"

static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_rgb565_exact, &qtri_rgb565_swapped,
                                             &qtri_rgb888, &qtri_bgr888,       &qtri_xrgb8888,
                                             &qtri_gray8};

static uint32_t encoded(const qtri_format *format, uint32_t color)
{
    uint32_t word[4] = {color, 0, 0, 0};
    if (format->encode != NULL) {
        format->encode(word, 1);
    }
    return word[0];
}

/* Of a full channel, n.16. */
static int32_t white_of(const qtri_colors *colors, int i)
{
    return (int32_t)lround(colors->ratio_q30[i] / 1073741824.0 * 255 * 65536);
}

/* 0x00RRGGBB as a colour of the format's kind. */
static uint32_t color_of(const qtri_format *format, uint32_t rgb)
{
    int32_t channel[3];
    for (int i = 0; i < 3; i++) {
        channel[i] =
            (int32_t)lround((rgb >> (16 - 8 * i) & 255) / 255.0 * white_of(format->colors, i));
    }
    return format->colors->pack(channel);
}

/* What is stored means what is stored again. Of 32 bits the high 8 mean nothing. */
TEST(round_trips)
{
    uint64_t seed = 90;
    for (size_t f = 0; f < LENGTH_OF(formats); f++) {
        const uint32_t bytes = formats[f]->pixels->bytes;
        const uint32_t count = bytes == 1 ? 256 : (bytes == 2 ? 65536 : 300000);
        for (uint32_t n = 0; n < count; n++) {
            const uint32_t stored = bytes <= 2 ? n : (uint32_t)random64(&seed) & 0xFFFFFF;
            const uint32_t rgb = formats[f]->decode(stored);
            assert_true(rgb <= 0xFFFFFF);
            assert_int_equal(encoded(formats[f], color_of(formats[f], rgb)), stored);
        }
    }
    assert_int_equal(qtri_xrgb8888.decode(0xFF123456), 0x123456);
}

TEST(meanings)
{
    for (uint32_t n = 0; n < 65536; n++) {
        const uint32_t red = (255 * (n >> 11) + 15) / 31;
        const uint32_t green = (255 * (n >> 5 & 63) + 31) / 63;
        const uint32_t blue = (255 * (n & 31) + 15) / 31;
        const uint32_t swapped = (n & 255) << 8 | n >> 8;
        assert_int_equal(qtri_rgb565.decode(n), red << 16 | green << 8 | blue);
        assert_int_equal(encoded(&qtri_rgb565_swapped, n), swapped);
        assert_int_equal(qtri_rgb565_swapped.decode(swapped), qtri_rgb565.decode(n));
    }
    static const qtri_rgb color = {0x12, 0x34, 0x56};
    for (int bgr = 0; bgr < 2; bgr++) {
        canvas c = canvas_new(bgr ? &qtri_bgr888 : &qtri_rgb888, 3, 2);
        c.surface.scissor.x0 = 1;
        c.surface.scissor.x1 = 2;
        clear_to(&c.surface, color, 0);
        const uint8_t *pixel = c.surface.pixels + 9 + 3;
        assert_int_equal(pixel[bgr ? 2 : 0], 0x12);
        assert_int_equal(pixel[1], 0x34);
        assert_int_equal(pixel[bgr ? 0 : 2], 0x56);
        assert_int_equal(pixel[-1] | pixel[3], 0);
        canvas_free(&c);
    }
}

/* Channels of 8 bits to the nearest step; what is stored stays as it is. */
TEST(exact_565)
{
    for (uint32_t c = 0; c < 256; c++) {
        const uint32_t five = (2 * 31 * c + 255) / 510;
        const uint32_t six = (2 * 63 * c + 255) / 510;
        assert_int_equal(encoded(&qtri_rgb565_exact, c << 16 | (255 - c) << 8),
                         five << 11 | (63 - six) << 5);
        assert_int_equal(encoded(&qtri_rgb565_exact, c << 8 | c), six << 5 | five);
    }
    for (uint32_t n = 0; n < 65536; n++) {
        assert_int_equal(encoded(&qtri_rgb565_exact, qtri_rgb565_exact.decode(n)), n);
    }
}

/* White and its ratio to 255, and that packing rounds. */
TEST(kinds)
{
    static const qtri_colors *const all[] = {&qtri_colors_565, &qtri_colors_888, &qtri_colors_gray};
    static const uint32_t white[] = {0xFFFF, 0xFFFFFF, 255};
    static const int32_t black[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        const int32_t full[3] = {white_of(all[k], 0), white_of(all[k], 1), white_of(all[k], 2)};
        assert_int_equal(all[k]->pack(full), white[k]);
        assert_int_equal(all[k]->pack(black), 0);
        int32_t halves[3] = {0, 0, 0x7FFF};
        assert_int_equal(all[k]->pack(halves), 0);
        halves[2]++;
        assert_int_equal(all[k]->pack(halves), 1);
    }
}

enum { COUNT = 32, MEMORY = 4096 };

static void fill_random(uint32_t *words, size_t count, uint64_t *seed)
{
    for (size_t i = 0; i < count; i++) {
        words[i] = (uint32_t)random64(seed);
    }
}

/* Bytes of `stored` at `at`, as an integer of the machine, or the lowest of three first. */
static void put(uint8_t *at, uint32_t bytes, uint32_t stored)
{
    const uint8_t stored8 = (uint8_t)stored;
    const uint16_t stored16 = (uint16_t)stored;
    const uint8_t stored24[3] = {(uint8_t)stored, (uint8_t)(stored >> 8), (uint8_t)(stored >> 16)};
    memcpy(at,
           bytes == 1   ? (const void *)&stored8
           : bytes == 2 ? (const void *)&stored16
           : bytes == 3 ? (const void *)stored24
                        : (const void *)&stored,
           bytes);
}

TEST(loops)
{
    static const qtri_pixels *const sizes[4] = {&qtri_pixels_8, &qtri_pixels_16, &qtri_pixels_24,
                                                &qtri_pixels_32};
    static uint32_t is[MEMORY / 4];
    static uint32_t wanted[MEMORY / 4];
    uint64_t seed = 91;
    for (int n = 0; n < 40000; n++) {
        const qtri_pixels *pixels = sizes[n % 4];
        const uint32_t bytes = pixels->bytes;
        assert_int_equal(bytes, n % 4 + 1);
        const int32_t count = random_in(&seed, 1, COUNT);
        uint32_t mask = n % 3 == 0 ? UINT32_MAX : (uint32_t)random64(&seed);
        mask &= n % 5 == 0 ? (uint32_t)random64(&seed) & (uint32_t)random64(&seed) : UINT32_MAX;
        mask &= UINT32_MAX >> (32 - count);
        uint32_t stored[COUNT];
        fill_random(stored, LENGTH_OF(stored), &seed);
        fill_random(is, LENGTH_OF(is), &seed);
        memcpy(wanted, is, sizeof is);
        const ptrdiff_t start = (ptrdiff_t)bytes * random_in(&seed, 4, 40);
        uint8_t *at = (uint8_t *)is + start;
        uint8_t *model = (uint8_t *)wanted + start;
        const bool one = n / 4 % 2 == 1;
        for (int32_t i = 0; i < count; i++) {
            if (mask >> (count - 1 - i) & 1) {
                put(model + i * (ptrdiff_t)bytes, bytes, stored[one ? 0 : i]);
            }
        }
        if (one) {
            pixels->fill(at, stored[0], mask, count);
        } else {
            pixels->store(at, stored, mask, count);
        }
        assert_memory_equal(is, wanted, sizeof is);
        put(at, bytes, stored[0]);
        assert_int_equal(pixels->load(at),
                         bytes == 4 ? stored[0] : stored[0] & ((1u << 8 * bytes) - 1));
    }
}

/* A format of one's own, four bits a channel, can be cleared and read. */
static void encode_444(uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        color[i] = (color[i] >> 12 & 0xF00) | (color[i] >> 8 & 0xF0) | (color[i] >> 4 & 0xF);
    }
}

static uint32_t decode_444(uint32_t stored)
{
    return (stored & 0xF00) * 0x1100 | (stored & 0xF0) * 0x110 | (stored & 0xF) * 0x11;
}

static const qtri_format rgb444 = {
    &qtri_pixels_16, &qtri_colors_888, encode_444, decode_444, NULL, 0};

TEST(surfaces)
{
    static const qtri_rgb color = {0xCC, 0x33, 0x88};
    for (size_t f = 0; f <= LENGTH_OF(formats); f++) {
        const qtri_format *format = f < LENGTH_OF(formats) ? formats[f] : &rgb444;
        canvas c = canvas_new(format, 70, 3);
        clear_to(&c.surface, color, 0);
        const qtri_rgb is = qtri_surface_pixel(&c.surface, 69, 2);
        if (format == &qtri_gray8) {
            assert_true(is.r == 106 && is.g == is.r && is.b == is.r); /* 106.45 */
        } else {
            const int off =
                format->decode(UINT16_MAX) == 0xFFFFFF && format->pixels->bytes == 2 ? 4 : 0;
            assert_true(abs(is.r - color.r) <= off && abs(is.g - color.g) <= off / 2 &&
                        abs(is.b - color.b) <= off);
        }
        assert_int_equal(stored_depth(&c.surface, 69, 2), 0);
        canvas_free(&c);
    }
}

/* Without a format nothing is drawn; nothing is written beyond the pixels of any. */
TEST(nothing)
{
    qtri_surface s = {0};
    static uint8_t memory[QTRI_BAND_BYTES(8, 8, QTRI_XRGB8888_BYTES)];
    static uint8_t before[sizeof memory];
    assert_int_equal(qtri_surface_init(&s, NULL, 8, 8, 0, 8, memory, sizeof memory),
                     QTRI_ERROR_FORMAT);
    assert_int_equal(qtri_surface_init(&s, &qtri_rgb888, 8, 8, 0, 8, memory, 8 * 8 * 5 + 7),
                     QTRI_ERROR_MEMORY);
    assert_ok(qtri_surface_init(&s, &qtri_rgb888, 8, 8, 0, 8, memory, 8 * 8 * 5 + 8));
    const qtri_rgb white = {255, 255, 255};
    qtri_material material = qtri_material_default();
    qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(0, 8 * 256), screen_at(8 * 256, 0)};
    s.format = NULL;
    memset(memory, 0xA5, sizeof memory);
    memcpy(before, memory, sizeof memory);
    clear_to(&s, white, 0);
    qtri_raster_triangle(&s, qtri_pipelines_default, &material, v);
    qtri_raster_line(&s, &material, v);
    assert_memory_equal(memory, before, sizeof memory);
    const qtri_rgb is = qtri_surface_pixel(&s, 1, 1);
    assert_true(is.r == 0 && is.g == 0 && is.b == 0);
    uint8_t gray[2] = {9, 9};
    qtri_surface_gray(&s, 1, 1, 2, gray);
    assert_int_equal(gray[0] | gray[1], 0);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
