/* SPDX-License-Identifier: MIT */
/*
 * Filters of finished pixels: 2x2 samples, FXAA, sums of frames; and jittered views.
 */
#include "support/core.h"
#include "support/layouts.h"
#include "support/filters_narrow.h"

enum { WIDTH = 70, HEIGHT = 50, FORMATS = 5 };

/* RGB565 as any other format. */
static void encode_any(uint32_t *color, int32_t count)
{
    (void)color;
    (void)count;
}

static const qtri_format any_565 = {.pixels = &qtri_pixels_16,
                                    .colors = &qtri_colors_565,
                                    .encode = encode_any,
                                    .decode = qtri_decode_rgb565};

static const qtri_format *const formats[FORMATS] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8,
                                                    &qtri_rgb565_swapped, &qtri_rgb888};
static uint32_t memory[2 * QTRI_BAND_BYTES(WIDTH, HEIGHT + 20, 4) / 4];
static uint32_t copy[2 * QTRI_BAND_BYTES(WIDTH, HEIGHT + 20, 4) / 4];
static uint32_t words[QTRI_SUM_WORDS(WIDTH, HEIGHT)];

/* Edges of all kinds on a ground that is plain in most places. */
static void draw_picture(const qtri_surface *surface, uint64_t seed)
{
    const qtri_rgb sky = {24, 32, 48};
    qtri_material material = qtri_material_default();
    material.depth_compare = QTRI_DEPTH_OFF;
    material.cull = QTRI_CULL_NONE;
    qtri_surface_clear(surface, sky);
    for (int i = 0; i < 6; i++) {
        qtri_screen_vertex v[3];
        memset(v, 0, sizeof v);
        for (int k = 0; k < 3; k++) {
            v[k].x_24p8 = random_in(&seed, -10 * 256, (WIDTH + 10) * 256);
            v[k].y_24p8 = random_in(&seed, -10 * 256, (HEIGHT + 10) * 256);
            v[k].inv_w_q31 = 1u << 30;
            for (int c = 0; c < 3; c++) {
                v[k].color_8p16[c] = random_in(&seed, 0, 255 << 16);
            }
        }
        qtri_raster_triangle(surface, qtri_pipelines_default, &material, v);
    }
}

static void begin(qtri_surface *surface, const qtri_format *format, uint64_t seed)
{
    assert_ok(qtri_surface_init(surface, format, WIDTH, HEIGHT, 0, HEIGHT, memory, sizeof memory));
    draw_picture(surface, seed);
}

static uint32_t pixel_at(const qtri_surface *surface, int32_t x, int32_t y)
{
    const qtri_rgb c = qtri_surface_pixel(surface, x, y);
    return (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
}

struct picture {
    uint32_t pixel[HEIGHT][WIDTH];
};

static void keep(struct picture *out, const qtri_surface *s, qtri_rect r)
{
    for (int32_t y = r.y0; y < r.y1; y++) {
        for (int32_t x = r.x0; x < r.x1; x++) {
            out->pixel[y][x] = pixel_at(s, x, y);
        }
    }
}

static const qtri_rect all = {0, 0, WIDTH, HEIGHT};

#define assert_same(a, b) assert_memory_equal(&(a), &(b), sizeof(struct picture))

/* ---- 2x2 samples ---- */

/* Full channels of a kind's steps. */
static void levels_of(const qtri_format *format, double levels[3])
{
    const bool is_565 = format == &qtri_rgb565 || format == &qtri_rgb565_swapped;
    levels[0] = is_565 ? 31 : 255;
    levels[1] = is_565 ? 63 : 255;
    levels[2] = levels[0];
}

TEST(halves_are_means)
{
    for (uint64_t seed = 0; seed < 60; seed++) {
        qtri_surface large, half;
        static struct picture before;
        const qtri_format *format = formats[seed % FORMATS];
        double levels[3];
        levels_of(format, levels);
        begin(&large, format, seed);
        keep(&before, &large, all);
        assert_ok(qtri_halve(&large, &half));
        assert_int_equal(half.width, WIDTH / 2);
        assert_int_equal(half.rows, HEIGHT / 2);
        for (int y = 0; y < HEIGHT / 2; y++) {
            for (int x = 0; x < WIDTH / 2; x++) {
                const uint32_t got = pixel_at(&half, x, y);
                for (int c = 0; c < 3; c++) {
                    double sum = 0;
                    for (int i = 0; i < 4; i++) {
                        sum += round((before.pixel[2 * y + i / 2][2 * x + i % 2] >> 8 * c & 255) *
                                     levels[c] / 255);
                    }
                    const double want = floor(sum / 4 + .5);
                    assert_int_equal((int)round((got >> 8 * c & 255) * levels[c] / 255), (int)want);
                }
            }
        }
        if (format == &qtri_rgb565) { /* the quick way makes the same */
            static struct picture one, other;
            memset(&one, 0, sizeof one);
            memset(&other, 0, sizeof other);
            const qtri_rect quarter = {0, 0, WIDTH / 2, HEIGHT / 2};
            keep(&one, &half, quarter);
            begin(&large, format, seed);
            large.format = &any_565;
            assert_ok(qtri_halve(&large, &half));
            keep(&other, &half, quarter);
            assert_same(one, other);
        }
    }
}

/* What becomes of a band has half of each of its measures; a scissor keeps what it only touches. */
TEST(halves_are_measured)
{
    uint64_t seed = 7;
    for (int round = 0; round < 200; round++) {
        qtri_surface large, half;
        begin(&large, formats[round % FORMATS], (uint64_t)round);
        large.width = 2 * random_in(&seed, 1, WIDTH / 2);
        large.rows = 2 * random_in(&seed, 1, HEIGHT / 2);
        large.height = 2 * random_in(&seed, large.rows / 2, HEIGHT);
        large.first_row = 2 * random_in(&seed, 0, (large.height - large.rows) / 2);
        large.scissor.x0 = random_in(&seed, 0, large.width - 1);
        large.scissor.x1 = random_in(&seed, large.scissor.x0 + 1, large.width);
        large.scissor.y0 = random_in(&seed, large.first_row, large.first_row + large.rows - 1);
        large.scissor.y1 = random_in(&seed, large.scissor.y0 + 1, large.first_row + large.rows);
        assert_ok(qtri_halve(&large, &half));
        assert_int_equal(2 * half.width, large.width);
        assert_int_equal(2 * half.height, large.height);
        assert_int_equal(2 * half.first_row, large.first_row);
        assert_int_equal(2 * half.rows, large.rows);
        assert_int_equal(half.scissor.x0, large.scissor.x0 >> 1);
        assert_int_equal(half.scissor.y0, large.scissor.y0 >> 1);
        assert_int_equal(half.scissor.x1, large.scissor.x1 - large.scissor.x1 / 2);
        assert_int_equal(half.scissor.y1, large.scissor.y1 - large.scissor.y1 / 2);
        assert_null(half.depth);
    }
}

TEST(halves_of_bands)
{
    uint64_t seed = 1;
    for (int round = 0; round < 100; round++) {
        qtri_surface large, half, band, part;
        static struct picture whole, banded;
        const qtri_format *format = formats[round % FORMATS];
        memset(&whole, 0, sizeof whole);
        memset(&banded, 0, sizeof banded);
        begin(&large, format, (uint64_t)round);
        assert_ok(qtri_halve(&large, &half));
        const qtri_rect quarter = {0, 0, WIDTH / 2, HEIGHT / 2};
        keep(&whole, &half, quarter);
        const int32_t rows = 2 * random_in(&seed, 1, 14);
        for (int32_t first = 0; first < HEIGHT; first += rows) {
            (void)qtri_surface_init(&band, format, WIDTH, HEIGHT, first, rows, copy, sizeof copy);
            draw_picture(&band, (uint64_t)round);
            assert_ok(qtri_halve(&band, &part));
            const qtri_rect r = {0, first / 2, WIDTH / 2, first / 2 + part.rows};
            keep(&banded, &part, r);
        }
        assert_same(whole, banded);
        /* A scissor: what has all its samples inside. */
        begin(&large, format, (uint64_t)round);
        const qtri_rect scissor = {random_in(&seed, 0, 20), random_in(&seed, 0, 20),
                                   random_in(&seed, 40, WIDTH), random_in(&seed, 30, HEIGHT)};
        large.scissor = scissor;
        if (round % 2 == 0 && format == &qtri_rgb565) {
            large.format = &any_565;
        }
        assert_ok(qtri_halve(&large, &half));
        for (int y = (scissor.y0 + 1) / 2; y < scissor.y1 / 2; y++) {
            for (int x = (scissor.x0 + 1) / 2; x < scissor.x1 / 2; x++) {
                assert_int_equal(pixel_at(&half, x, y), whole.pixel[y][x]);
            }
        }
    }
    qtri_surface odd, out;
    begin(&odd, &qtri_gray8, 0);
    odd.width--;
    assert_int_equal(qtri_halve(&odd, &out), QTRI_ERROR_SIZE);
    odd.width++;
    odd.format = NULL;
    assert_int_equal(qtri_halve(&odd, &out), QTRI_ERROR_FORMAT);
}

/* ---- FXAA ---- */

enum way { ANY_FORMAT, PAIRS, ONE_BY_ONE };

static void smooth(const qtri_surface *surface, enum way way)
{
    const bool is_565 = surface->format == &qtri_rgb565;
    qtri_surface s = *surface;
    if (is_565 && way == ANY_FORMAT) {
        s.format = &any_565;
    }
    const uint32_t count =
        s.format == &qtri_rgb565 ? QTRI_FXAA_565_WORDS(WIDTH) : QTRI_FXAA_WORDS(WIDTH);
    assert_ok((way == ONE_BY_ONE ? narrow_fxaa : qtri_fxaa)(&s, words, count));
}

TEST(fxaa_bands_and_scissors)
{
    uint64_t seed = 2;
    int changed = 0;
    for (int round = 0; round < 200; round++) {
        qtri_surface surface, band, shown;
        qtri_frame frame;
        static struct picture plain, whole, part;
        const qtri_format *format = formats[round % 2 == 0 ? 0 : round / 2 % FORMATS];
        begin(&surface, format, (uint64_t)round);
        keep(&plain, &surface, all);
        smooth(&surface, ANY_FORMAT);
        keep(&whole, &surface, all);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                changed += whole.pixel[y][x] != plain.pixel[y][x];
            }
        }
        assert_ok(frame_with_overlap(&frame, format, WIDTH, HEIGHT, random_in(&seed, 1, 30),
                                     QTRI_FXAA_OVERLAP + random_in(&seed, 0, 1), copy,
                                     sizeof copy));
        while (next_shown(&frame, &band, &shown)) {
            draw_picture(&band, (uint64_t)round);
            smooth(&band, round % 3 == 0 ? ONE_BY_ONE : PAIRS);
            const qtri_rect r = {0, shown.first_row, WIDTH, shown.first_row + shown.rows};
            keep(&part, &shown, r);
        }
        assert_same(whole, part);
        begin(&surface, format, (uint64_t)round);
        const qtri_rect r = {random_in(&seed, 0, 30), random_in(&seed, 0, 20),
                             random_in(&seed, 31, WIDTH), random_in(&seed, 21, HEIGHT)};
        const qtri_rect wide = {r.x0 - QTRI_FXAA_REACH, r.y0 - QTRI_FXAA_OVERLAP,
                                r.x1 + QTRI_FXAA_REACH, r.y1 + QTRI_FXAA_OVERLAP};
        surface.scissor = wide;
        if (round % 4 == 0) { /* bottom up; rows of no whole words, or that begin within one */
            memcpy(copy, memory, sizeof copy);
            const bool is_short = format->pixels->bytes == 2;
            const ptrdiff_t pitch = surface.pitch;
            const ptrdiff_t bytes = pitch + (is_short ? 2 + round / 4 % 2 * 2 : 12);
            uint8_t *const first = (uint8_t *)memory + (is_short ? round / 8 % 2 * 2 : 0);
            for (int y = 0; y < HEIGHT; y++) {
                memcpy(first + (HEIGHT - 1 - y) * bytes,
                       (uint8_t *)copy + (surface.pixels - (uint8_t *)memory) + y * pitch,
                       (size_t)pitch);
            }
            surface.pixels = first + (HEIGHT - 1) * bytes;
            surface.pitch = -bytes;
        }
        smooth(&surface, round % 3 == 1 ? ONE_BY_ONE : PAIRS);
        part = whole;
        keep(&part, &surface, r);
        assert_same(whole, part);
    }
    assert_true(changed > 10000);
}

/* Pictures of one colour, smooth ones and single steps stay; colours lie between neighbours'. */
TEST(fxaa_leaves_the_rest)
{
    for (uint64_t seed = 0; seed < 50; seed++) {
        qtri_surface surface;
        static struct picture before;
        begin(&surface, formats[seed % FORMATS], seed);
        keep(&before, &surface, all);
        smooth(&surface, seed % 2 == 0);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                const uint32_t now = pixel_at(&surface, x, y);
                for (int c = 0; c < 24; c += 8) {
                    int low = 255, high = 0;
                    for (int i = 0; i < 5; i++) {
                        static const int dx[5] = {0, 1, -1, 0, 0}, dy[5] = {0, 0, 0, 1, -1};
                        const int px = x + dx[i], py = y + dy[i];
                        if (px >= 0 && px < WIDTH && py >= 0 && py < HEIGHT) {
                            const int v = (int)(before.pixel[py][px] >> c & 255);
                            low = v < low ? v : low;
                            high = v > high ? v : high;
                        }
                    }
                    assert_in_range(now >> c & 255, low, high);
                }
            }
        }
    }
    qtri_surface surface;
    begin(&surface, &qtri_gray8, 0);
    assert_int_equal(qtri_fxaa(&surface, words, QTRI_FXAA_WORDS(WIDTH) - 1), QTRI_ERROR_MEMORY);
    begin(&surface, &qtri_rgb565, 0);
    assert_int_equal(qtri_fxaa(&surface, words, QTRI_FXAA_565_WORDS(WIDTH) - 1), QTRI_ERROR_MEMORY);
    surface.scissor.x1 = 0;
    assert_ok(qtri_fxaa(&surface, NULL, 0));
}

/* ---- Sums ---- */

TEST(means_are_exact)
{
    uint64_t seed = 3;
    for (int turn = 0; turn < 60; turn++) {
        const qtri_format *format = formats[turn % FORMATS];
        const int32_t log2 = random_in(&seed, 0, 5);
        static double sum[HEIGHT][WIDTH][3];
        double levels[3];
        qtri_surface surface;
        const bool quick = format == &qtri_rgb565 && turn % 2 == 0;
        levels_of(format, levels);
        memset(sum, 0, sizeof sum);
        qtri_sum_clear(words, LENGTH_OF(words));
        for (int frame = 0; frame < 1 << log2; frame++) {
            begin(&surface, format, random64(&seed));
            if (format == &qtri_rgb565 && !quick) {
                surface.format = &any_565;
            }
            assert_ok(qtri_sum_add(
                words, quick ? QTRI_SUM_565_WORDS(WIDTH, HEIGHT) : QTRI_SUM_WORDS(WIDTH, HEIGHT),
                &surface));
            for (int y = 0; y < HEIGHT; y++) {
                for (int x = 0; x < WIDTH; x++) {
                    for (int c = 0; c < 3; c++) {
                        sum[y][x][c] +=
                            round((pixel_at(&surface, x, y) >> 8 * c & 255) * levels[c] / 255);
                    }
                }
            }
        }
        surface.scissor.x0 = 1;
        surface.scissor.y1 = HEIGHT - 1;
        const uint32_t corner = pixel_at(&surface, 0, HEIGHT - 1);
        assert_ok(qtri_sum_store(&surface, words, LENGTH_OF(words), log2));
        assert_int_equal(pixel_at(&surface, 0, HEIGHT - 1), corner);
        for (int y = 0; y < HEIGHT - 1; y++) {
            for (int x = 1; x < WIDTH; x++) {
                for (int c = 0; c < 3; c++) {
                    const double mean = floor(sum[y][x][c] / (1 << log2) + .5);
                    const double got = (pixel_at(&surface, x, y) >> 8 * c & 255) * levels[c] / 255;
                    assert_int_equal((int)round(got), (int)mean);
                }
            }
        }
    }
    qtri_surface surface;
    begin(&surface, &qtri_rgb565, 0);
    assert_int_equal(qtri_sum_add(words, QTRI_SUM_565_WORDS(WIDTH, HEIGHT) - 1, &surface),
                     QTRI_ERROR_MEMORY);
    begin(&surface, &qtri_gray8, 0);
    assert_int_equal(qtri_sum_store(&surface, words, QTRI_SUM_WORDS(WIDTH, HEIGHT) - 1, 99),
                     QTRI_ERROR_MEMORY);
}

/* ---- Jitter ---- */

/* Pixels of a triangle that fills the picture below a slope of 1 in 3.19. */
static int count_below_slope(const qtri_view *view)
{
    static uint32_t rows[QTRI_BAND_BYTES(320, 240, 1) / 4];
    qtri_surface s;
    (void)qtri_surface_init(&s, &qtri_gray8, 320, 240, 0, 240, rows, sizeof rows);
    const qtri_rgb black = {0, 0, 0}, white = {255, 255, 255};
    const q16 far = Q16(-10);
    const qtri_corner corner[3] = {{{Q16(-20), Q16(3.1), far, Q16_ONE}, white, {0, 0}},
                                   {{Q16(20), Q16(-9.436), far, Q16_ONE}, white, {0, 0}},
                                   {{0, Q16(-40), far, Q16_ONE}, white, {0, 0}}};
    qtri_transform pose;
    qtri_material material = qtri_material_default();
    material.cull = QTRI_CULL_NONE;
    qtri_transform_identity(&pose);
    qtri_surface_clear(&s, black);
    qtri_draw_triangles(&s, view, &pose, corner, 3, &material);
    int count = 0;
    for (int y = 0; y < 240; y++) {
        for (int x = 0; x < 320; x++) {
            count += qtri_surface_pixel(&s, x, y).g != 0;
        }
    }
    return count;
}

/* Places are one in each part of a pixel, across and down, and the picture moves by them. */
TEST(jittered_views)
{
    qtri_view view, moved;
    qtri_view_init(&view, 320, 240);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(1.3333), Q16(.1), Q16(100));
    const int still = count_below_slope(&view);
    for (int32_t log2 = 0; log2 <= QTRI_JITTER_LOG2_MAX; log2++) {
        const int parts = 1 << log2;
        double sum = 0;
        for (int n = 0; n < parts; n++) {
            int row = 0;
            for (int bit = 0; bit < log2; bit++) {
                row |= (n >> bit & 1) << (log2 - 1 - bit);
            }
            row ^= log2 > 0;
            const double x = (n + .5) / parts - .5, y = (row + .5) / parts - .5;
            qtri_view_jitter(&moved, &view, (uint32_t)(n + 3 * parts), log2);
            const double up = (count_below_slope(&moved) - still) / 320.0;
            assert_true(fabs(up - y - .3134 * x) < .02);
            sum += up / parts;
        }
        assert_true(fabs(sum) < .005);
    }
    qtri_view_init(&view, 0, -5);
    qtri_view_jitter(&view, &view, UINT32_MAX, INT32_MIN);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
