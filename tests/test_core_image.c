/* SPDX-License-Identifier: MIT */
/*
 * Pictures on surfaces: against pixels placed one by one, in all pairs of formats.
 */
#include "support/core.h"

#include <qtri/paint.h>
#include <qtri/antialias.h>

enum { SIDE = 40, MEMORY = 40 * 40 };

/* Memory of a picture somewhere in a buffer, so that it is aligned for its format and no more. */
typedef struct picture {
    qtri_image image;
    uint32_t memory[MEMORY];
} picture;

static void random_picture(picture *p, uint64_t *seed, const qtri_format *format)
{
    const int32_t bytes = format->pixels->bytes;
    const int32_t width = random_in(seed, 1, 37);
    const int32_t height = random_in(seed, 1, 20);
    const int32_t units = random_in(seed, 0, 3);
    const uint32_t levels[3] = {(uint32_t)random64(seed), (uint32_t)random64(seed), 0};
    for (size_t i = 0; i < LENGTH_OF(p->memory); i++) {
        p->memory[i] = (uint32_t)random64(seed);
    }
    ptrdiff_t pitch = (width + random_in(seed, 0, 2)) * bytes;
    uint8_t *first = (uint8_t *)p->memory + (bytes == 3 ? 1 : bytes) * units;
    const bool is_upwards = random_flag(seed);
    first += is_upwards ? (height - 1) * pitch : 0;
    p->image.pixels = first;
    p->image.pitch = is_upwards ? -pitch : pitch;
    p->image.format = format;
    p->image.width = width;
    p->image.height = height;
    p->image.has_key = random_flag(seed);
    p->image.key = levels[0] & (bytes == 4 ? 0xFFFFFFFFu : (1u << 8 * bytes) - 1);
    for (int32_t y = 0; y < height; y++) { /* often the key */
        for (int32_t x = 0; x < width; x++) {
            if (random_flag(seed)) {
                uint32_t stored = levels[random_in(seed, 0, 1)];
                stored ^= bytes == 4 ? (uint32_t)random_in(seed, 0, 3) << 24 : 0; /* of no colour */
                uint8_t *at = first + y * p->image.pitch + x * bytes;
                format->pixels->fill(at, stored, 1, 1);
            }
        }
    }
}

static uint32_t stored_in(const qtri_image *image, int32_t x, int32_t y)
{
    return image->format->pixels->load((const uint8_t *)image->pixels + y * image->pitch +
                                       x * image->format->pixels->bytes);
}

static bool is_key(const qtri_image *image, uint32_t stored)
{
    const uint32_t mask = image->format == &qtri_xrgb8888 ? 0xFFFFFF : UINT32_MAX;
    return image->has_key && (stored & mask) == (image->key & mask);
}

static void background(qtri_surface *s)
{
    for (int32_t y = s->first_row; y < s->first_row + s->rows; y++) {
        for (int32_t x = 0; x < SIDE; x++) {
            const qtri_rgb color = {(uint8_t)(x * 6), (uint8_t)(y * 5), (uint8_t)(x * y)};
            qtri_surface one = *s;
            one.scissor.x0 = x;
            one.scissor.x1 = x + 1;
            one.scissor.y0 = y;
            one.scissor.y1 = y + 1;
            clear_to(&one, color, 500);
        }
    }
}

/* A pixel of the picture on what was there before, of 255; 3/4 of a step of RGB565. */
static void assert_pixel(const qtri_surface *before, const qtri_surface *after,
                         const qtri_image *image, int32_t x, int32_t y, int32_t u, int32_t v,
                         uint8_t alpha)
{
    const bool is_there = u >= 0 && u < image->width && v >= 0 && v < image->height;
    const uint32_t stored = is_there ? stored_in(image, u, v) : 0;
    if (!is_there || is_key(image, stored) || alpha == 0) {
        assert_int_equal(stored_pixel(before, x, y), stored_pixel(after, x, y));
        return;
    }
    if (alpha == 255 && image->format == after->format) {
        assert_int_equal(stored_pixel(after, x, y), stored);
        return;
    }
    const uint32_t color = image->format->decode(stored);
    const qtri_rgb d = qtri_surface_pixel(before, x, y);
    const qtri_rgb is = qtri_surface_pixel(after, x, y);
    double s[3] = {color >> 16 & 255, color >> 8 & 255, color & 255};
    if (after->format == &qtri_gray8) {
        s[0] = s[1] = s[2] = .299 * s[0] + .587 * s[1] + .114 * s[2];
    }
    const double from[3] = {d.r, d.g, d.b};
    const double got[3] = {is.r, is.g, is.b};
    const bool is_same = image->format->colors == after->format->colors &&
                         (after->format != &qtri_rgb565_exact || image->format == after->format);
    for (int i = 0; i < 3; i++) {
        const double step = after->format->pixels->bytes != 2 ? 1 : 255 / (i == 1 ? 63. : 31.);
        const double wanted = from[i] + alpha / 255.0 * (s[i] - from[i]);
        /* Converted, then mixed: both round. */
        const double most = is_same || alpha == 255 ? .76 : 1.2;
        if (fabs(got[i] - wanted) > fmax(most * step, alpha == 255 ? .51 : 1.5)) {
            fail_msg("pixel %d,%d channel %d: %g, not %g", (int)x, (int)y, i, got[i], wanted);
        }
    }
}

TEST(placed)
{
    uint64_t seed = 11;
    static picture p;
    for (int n = 0; n < 1800; n++) {
        const qtri_format *format = drawn_format(n);
        random_picture(&p, &seed, drawn_format(n % 5 < 2 ? n : n / 6));
        const uint8_t alpha = (uint8_t)(random_flag(&seed) ? 255 : random64(&seed));
        const int32_t x = random_in(&seed, -40, SIDE + 2);
        const int32_t y = random_in(&seed, -22, SIDE + 2);
        canvas before = canvas_new(format, SIDE, SIDE);
        canvas after = canvas_new(format, SIDE, SIDE);
        background(&before.surface);
        background(&after.surface);
        if (alpha == 255 && random_flag(&seed)) {
            qtri_image_paint(&after.surface, &p.image, x, y);
        } else {
            qtri_image_blend(&after.surface, &p.image, x, y, alpha);
        }
        for (int32_t j = 0; j < SIDE; j++) {
            for (int32_t i = 0; i < SIDE; i++) {
                assert_pixel(&before.surface, &after.surface, &p.image, i, j, i - x, j - y, alpha);
                assert_int_equal(stored_depth(&after.surface, i, j), 500);
            }
        }
        canvas_free(&before);
        canvas_free(&after);
    }
}

/* Turned and scaled: the picture's pixel at the centre, unless that is close to another. */
TEST(turned)
{
    uint64_t seed = 12;
    static picture p;
    int checked = 0;
    for (int n = 0; n < 1200; n++) {
        const qtri_format *format = drawn_format(n);
        random_picture(&p, &seed, drawn_format(n % 5 < 2 ? n : n / 6));
        const uint8_t alpha = (uint8_t)(random_flag(&seed) ? 255 : random64(&seed));
        const bool is_quarter = n % 4 == 3; /* rows are rows of the picture, or its columns */
        const double degrees = is_quarter ? 90 * random_in(&seed, -4, 4)
                                          : random_in(&seed, -720, 720) / (n % 3 ? 1.7 : 1.0);
        const double unit = n % 8 == 7 ? 1 : 100; /* whole factors, flips */
        const double scale[2] = {random_in(&seed, -4 * (int)unit, 4 * (int)unit) / unit,
                                 random_in(&seed, (int)unit / 10 + (unit == 1), 4 * (int)unit) /
                                     unit};
        const double pivot[2] = {random_in(&seed, 0, 30) / 2.0, random_in(&seed, 0, 30) / 2.0};
        const double place[2] = {random_in(&seed, -20, 100) / 2.0,
                                 random_in(&seed, -20, 100) / 2.0};
        qtri_affine m;
        qtri_affine_place(&m, fixed(pivot[0]), fixed(pivot[1]), fixed(place[0]), fixed(place[1]),
                          fixed(scale[0]), fixed(scale[1]), fixed(degrees));
        canvas before = canvas_new(format, SIDE, SIDE);
        canvas after = canvas_new(format, SIDE, SIDE);
        background(&before.surface);
        background(&after.surface);
        qtri_image_paint_affine(&after.surface, &p.image, &m, alpha);
        const double c = cos(degrees * acos(-1) / 180);
        const double s = sin(degrees * acos(-1) / 180);
        for (int32_t j = 0; j < SIDE && fabs(scale[0]) > .05; j++) {
            for (int32_t i = 0; i < SIDE; i++) {
                const double dx = i + .5 - place[0];
                const double dy = j + .5 - place[1];
                const double u = pivot[0] + (c * dx + s * dy) / scale[0];
                const double v = pivot[1] + (-s * dx + c * dy) / scale[1];
                const double margin = .02;
                if (fabs(u - floor(u + .5)) < margin || fabs(v - floor(v + .5)) < margin) {
                    continue;
                }
                checked++;
                assert_pixel(&before.surface, &after.surface, &p.image, i, j, (int32_t)floor(u),
                             (int32_t)floor(v), alpha);
            }
        }
        canvas_free(&before);
        canvas_free(&after);
    }
    assert_true(checked > 1000000);
}

/* Bands and scissors show the whole frame's pixels; without turning, it is the plain way. */
TEST(bands)
{
    uint64_t seed = 13;
    static picture p;
    for (int n = 0; n < 600; n++) {
        const qtri_format *format = drawn_format(n);
        random_picture(&p, &seed, drawn_format(n / 6));
        qtri_affine m;
        const int32_t x = random_in(&seed, -30, SIDE);
        const int32_t y = random_in(&seed, -30, SIDE);
        const bool is_plain = n % 3 == 0;
        const uint8_t alpha = (uint8_t)(random_flag(&seed) ? 255 : random64(&seed));
        qtri_affine_place(&m, 0, 0, x * 65536, y * 65536, is_plain ? Q16_ONE : random_any(&seed),
                          is_plain ? Q16_ONE : random_in(&seed, 10000, 300000),
                          is_plain ? 0 : random_any(&seed));
        canvas whole = canvas_new(format, SIDE, SIDE);
        background(&whole.surface);
        qtri_image_paint_affine(&whole.surface, &p.image, &m, alpha);
        canvas band = canvas_band(format, SIDE, SIDE, random_in(&seed, 0, SIDE - 1), 7);
        background(&band.surface);
        qtri_surface left = band.surface;
        qtri_surface right = band.surface;
        left.scissor.x1 = right.scissor.x0 = random_in(&seed, 0, SIDE);
        if (is_plain) {
            qtri_image_blend(&left, &p.image, x, y, alpha);
            qtri_image_blend(&right, &p.image, x, y, alpha);
        } else {
            qtri_image_paint_affine(&left, &p.image, &m, alpha);
            qtri_image_paint_affine(&right, &p.image, &m, alpha);
        }
        assert_same_picture(&whole.surface, &band.surface);
        canvas_free(&whole);
        canvas_free(&band);
    }
}

/* Any numbers at all; what is no picture paints nothing. */
TEST(any_arguments)
{
    uint64_t seed = 14;
    static picture p;
    canvas c = canvas_new(&qtri_rgb565, SIDE, SIDE);
    canvas other = canvas_new(&qtri_rgb565, SIDE, SIDE);
    for (int n = 0; n < 20000; n++) {
        random_picture(&p, &seed, drawn_format(n));
        qtri_affine m = {random_any(&seed), random_any(&seed), random_any(&seed),
                         random_any(&seed), random_any(&seed), random_any(&seed)};
        qtri_image_paint_affine(&c.surface, &p.image, &m, (uint8_t)random64(&seed));
        qtri_image_paint(&c.surface, &p.image, random_any(&seed), random_any(&seed));
        qtri_image_blend(&c.surface, &p.image, random_any(&seed), random_any(&seed), 77);
        qtri_affine_place(&m, random_any(&seed), random_any(&seed), random_any(&seed),
                          random_any(&seed), random_any(&seed), random_any(&seed),
                          random_any(&seed));
        qtri_image_paint_affine(&c.surface, &p.image, &m, 255);
    }
    canvas_clear(&c);
    const qtri_affine same = {Q16_ONE, 0, 0, 0, Q16_ONE, 0};
    for (int n = 0; n < 6; n++) {
        random_picture(&p, &seed, drawn_format(n));
        p.image.has_key = false;
        p.image.pixels = n == 0 ? NULL : p.image.pixels;
        p.image.format = n == 1 ? NULL : p.image.format;
        p.image.width = n == 2 ? 0 : (n == 3 ? 8193 : p.image.width);
        p.image.height = n == 4 ? -1 : (n == 5 ? 8193 : p.image.height);
        qtri_image_paint(&c.surface, &p.image, 0, 0);
        qtri_image_blend(&c.surface, &p.image, 0, 0, 99);
        qtri_image_paint_affine(&c.surface, &p.image, &same, 255);
    }
    assert_same_picture(&other.surface, &c.surface);
    canvas_free(&other);
    canvas_free(&c);
}

/* A surface is a picture. */
TEST(of_surfaces)
{
    canvas a = canvas_new(&qtri_rgb888, SIDE, SIDE);
    canvas b = canvas_new(&qtri_rgb888, SIDE, SIDE);
    background(&a.surface);
    background(&b.surface);
    canvas_clear(&b);
    const qtri_image image = qtri_image_of(&a.surface);
    qtri_image_paint(&b.surface, &image, 0, 0);
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        assert_int_equal(stored_pixel(&a.surface, i % SIDE, i / SIDE),
                         stored_pixel(&b.surface, i % SIDE, i / SIDE));
    }
    canvas_free(&a);
    canvas_free(&b);
}

/* Q16.16 c 2^32 / determinant, to nearest, as the inverse is rounded. */
static int64_t inverse_of(int64_t c, int128 determinant)
{
    const bool is_negative = (c < 0) != (determinant < 0);
    const int128 size = determinant < 0 ? -determinant : determinant;
    const int64_t twice = (int64_t)(((int128)(c < 0 ? -c : c) << 33) / size);
    return is_negative ? -((twice + 1) / 2) : (twice + 1) / 2;
}

/*
 * Long pictures in steep matrices, where the rounding of the inverse moves them by rows: exactly
 * the pixels are painted whose centres the rounded inverse puts into the picture.
 */
TEST(steep)
{
    static uint8_t texels[8192];
    uint64_t seed = 15;
    int painted = 0;
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = (uint8_t)(1 + i % 251);
    }
    canvas c = canvas_new(&qtri_gray8, SIDE, SIDE);
    for (int n = 0; n < 2000; n++) {
        const bool is_wide = n % 2 == 0;
        const q16 limit = n % 4 < 2 ? Q16(6) : Q16(400);
        const q16 down = random_in(&seed, Q16(1), limit) * (n % 8 < 4 ? 1 : -1);
        const q16 size = down < 0 ? -down : down;
        const int32_t most = Q16(16000) / size; /* no number of the matrix is beyond 16384 */
        const int32_t length = random_in(&seed, 1, most < 8192 ? most : 8192);
        const qtri_image image = {.pixels = texels,
                                  .pitch = is_wide ? length : 1,
                                  .format = &qtri_gray8,
                                  .width = is_wide ? length : 1,
                                  .height = is_wide ? 1 : length};
        const q16 beside = random_in(&seed, -Q16(.02), Q16(.02));
        const q16 wide = random_in(&seed, Q16(1), Q16(20));
        const q16 high = random_in(&seed, -Q16(3.9), Q16(3.9));
        const int32_t end = n % 3 == 0 ? length : 0; /* or the beginning is seen */
        qtri_affine m = {
            is_wide ? beside : wide, is_wide ? wide : beside, random_in(&seed, -Q16(30), Q16(60)),
            is_wide ? down : high,   is_wide ? high : down,   0};
        const int128 det = (int128)m.xx * m.yy - (int128)m.xy * m.yx;
        if (det == 0) {
            continue;
        }
        m.y0 = random_in(&seed, 0, Q16(SIDE)) - down * end;
        const int64_t ux = inverse_of(m.yy, det), uy = inverse_of(-m.xy, det);
        const int64_t vx = inverse_of(-m.yx, det), vy = inverse_of(m.xx, det);
        canvas_clear(&c);
        qtri_image_paint_affine(&c.surface, &image, &m, 255);
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const int64_t x = (i % SIDE) * 65536 + 32768 - m.x0;
            const int64_t y = i / SIDE * 65536 + 32768 - m.y0;
            const int64_t u = x * ux + y * uy;
            const int64_t v = x * vx + y * vy;
            const int64_t column = (int64_t)floor_div(u, (int128)1 << 32);
            const int64_t row = (int64_t)floor_div(v, (int128)1 << 32);
            const bool is = column >= 0 && column < image.width && row >= 0 && row < image.height;
            const uint32_t wanted = is ? texels[row * image.pitch + column] : 0;
            painted += is;
            assert_int_equal(stored_pixel(&c.surface, i % SIDE, i / SIDE), wanted);
        }
    }
    canvas_free(&c);
    print_message("%d pixels\n", painted);
    assert_true(painted > 1000);
}

/* Rows of a few bytes, which end before they are aligned: nothing beside them is written. */
TEST(narrow)
{
    const uint8_t memory[] = {10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21};
    for (int32_t n = 0; n < 8 * 4 * 4; n++) {
        const int32_t x = n / 16;
        const qtri_image image = {.pixels = memory + n % 4,
                                  .pitch = 4,
                                  .format = &qtri_gray8,
                                  .width = 1 + n / 4 % 4,
                                  .height = 1};
        canvas c = canvas_new(&qtri_gray8, 12, 2);
        qtri_image_paint(&c.surface, &image, x, 0);
        for (int32_t i = 0; i < 24; i++) {
            const bool is_there = i >= x && i < x + image.width;
            const uint32_t wanted = is_there ? memory[n % 4 + i - x] : 0;
            assert_int_equal(stored_pixel(&c.surface, i % 12, i / 12), wanted);
        }
        canvas_free(&c);
    }
}

/* A picture of four samples a pixel, all of one colour, is the picture of those colours. */
TEST(of_samples)
{
    enum { WIDTH = 11, HEIGHT = 7 };
    static uint16_t memory[HEIGHT][WIDTH];
    canvas records = canvas_new(&qtri_rgb565_x4, WIDTH, HEIGHT);
    canvas plain = canvas_new(&qtri_rgb565, SIDE, SIDE);
    canvas four = canvas_new(&qtri_rgb565_x4, SIDE, SIDE);
    const qtri_surface *pixels = &records.surface;
    const qtri_image image = {.pixels = memory,
                              .pitch = sizeof memory[0],
                              .format = &qtri_rgb565,
                              .width = WIDTH,
                              .height = HEIGHT};
    qtri_image sampled = image;
    sampled.pixels = pixels->pixels;
    sampled.format = &qtri_rgb565_x4;
    sampled.pitch = pixels->pitch;
    uint64_t seed = 17;
    for (int n = 0; n < 60; n++) {
        const uint8_t alpha = (uint8_t)(n % 2 != 0 ? 255 : random_in(&seed, 0, 255));
        qtri_affine m;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t color = (uint32_t)random64(&seed) & 0xFFFF;
            memory[i / WIDTH][i % WIDTH] = (uint16_t)color;
            pixels->format->pixels->fill(pixels->pixels + (i / WIDTH) * pixels->pitch +
                                             (ptrdiff_t)(i % WIDTH) * QTRI_RGB565_X4_BYTES,
                                         color, 1, 1);
        }
        qtri_affine_place(&m, 0, 0, random_in(&seed, 0, SIDE * 65536),
                          random_in(&seed, 0, SIDE * 65536), random_in(&seed, 20000, 300000),
                          random_in(&seed, 20000, 300000), n % 3 == 0 ? 0 : random_any(&seed));
        canvas_clear(&plain);
        qtri_samples_clear(&four.surface, (qtri_rgb){0, 0, 0});
        qtri_image_paint_affine(&plain.surface, &image, &m, alpha);
        qtri_image_paint_affine(&four.surface, &sampled, &m, alpha);
        qtri_surface resolved;
        assert_ok(qtri_samples_resolve(&four.surface, &resolved));
        for (int32_t i = 0; i < SIDE * SIDE; i++) { /* mixed, they are rounded once more */
            const qtri_rgb x = qtri_surface_pixel(&plain.surface, i % SIDE, i / SIDE);
            const qtri_rgb y = qtri_surface_pixel(&resolved, i % SIDE, i / SIDE);
            assert_near(x.r, y.r, alpha == 255 ? 0 : 9);
            assert_near(x.g, y.g, alpha == 255 ? 0 : 5);
            assert_near(x.b, y.b, alpha == 255 ? 0 : 9);
        }
    }
    canvas_free(&records);
    canvas_free(&plain);
    canvas_free(&four);
}

/* A picture of no bytes a pixel, turned or not, changes no surface of its own format. */
TEST(without_pixels)
{
    static const uint8_t nothing[4];
    const qtri_image image = {
        .pixels = nothing, .pitch = 0, .format = &qtri_depth_only, .width = 9, .height = 5};
    canvas c = canvas_new(&qtri_depth_only, SIDE, SIDE);
    canvas same = canvas_new(&qtri_depth_only, SIDE, SIDE);
    clear_to(&c.surface, (qtri_rgb){1, 2, 3}, 1234);
    clear_to(&same.surface, (qtri_rgb){1, 2, 3}, 1234);
    for (int n = 0; n < 8; n++) {
        qtri_affine m;
        qtri_affine_place(&m, 0, 0, Q16(5), Q16(6), Q16(2), Q16(1.5), n % 2 == 0 ? 0 : Q16(30));
        qtri_image_paint_affine(&c.surface, &image, &m, n < 4 ? 255 : 100);
        assert_memory_equal(c.memory, same.memory, c.bytes);
    }
    canvas_free(&c);
    canvas_free(&same);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
