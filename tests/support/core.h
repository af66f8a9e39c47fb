/* SPDX-License-Identifier: MIT */
/*
 * What the tests of core/ share: random numbers that are the same everywhere, values that hurt
 * fixed-point code, surfaces with memory to look at, and pictures a reviewer can read.
 */
#ifndef QTRI_TESTS_SUPPORT_CORE_H
#define QTRI_TESTS_SUPPORT_CORE_H

#include <stdint.h>

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <qtri.h>

#include "test.h"
#include "random.h"

__extension__ typedef __int128 int128;

/* Sweeps over all 2^32 arguments and the like: only when asked for. */
static inline bool long_run(void)
{
    const char *value = getenv("QTRI_TEST_LONG");
    return value != NULL && value[0] != '\0' && strcmp(value, "0") != 0;
}

#if defined(__has_feature)
#define HAS_FEATURE(feature) __has_feature(feature)
#else
#define HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || HAS_FEATURE(address_sanitizer) || HAS_FEATURE(memory_sanitizer)
#define IS_SANITIZED 1
#else
#define IS_SANITIZED 0
#endif

/*
 * Of a loop over random cases: a quarter of them under a sanitizer, where each takes three to ten
 * times as long, and where they are drawn once more to see that nothing undefined happens.
 */
static inline int random_cases(int all)
{
    return IS_SANITIZED ? (all + 3) / 4 : all;
}

/* The same, and 40 times as many in long runs. */
static inline int repeats(int few)
{
    return long_run() ? 40 * few : random_cases(few);
}

enum { STRESS_COUNT = 205 };

/* 0, powers of two and their neighbours, halves, extremes; both signs. Returns how many. */
static inline int stress_values(int32_t value[STRESS_COUNT])
{
    int count = 0;
    value[count++] = 0;
    for (int bit = 0; bit < 31; bit++) {
        for (int32_t near_by = -1; near_by <= 1; near_by++) {
            int32_t v = (int32_t)1 << bit;
            v = bit == 30 && near_by == 1 ? INT32_MAX : v + near_by;
            value[count++] = v;
            value[count++] = -v;
        }
    }
    static const int32_t more[] = {
        INT32_MIN, INT32_MIN + 1,   INT32_MAX - 1, 3 << 15,     -(3 << 15), 3 * 65536,   -3 * 65536,
        360 << 16, (360 << 16) + 1, 45 << 16,      -(45 << 16), 0x5A82799A, -0x5A82799A, 7};
    for (size_t i = 0; i < LENGTH_OF(more); i++) {
        value[count++] = more[i];
    }
    return count;
}

/* Quotient towards minus infinity. */
static inline int128 floor_div(int128 a, int128 b)
{
    int128 quotient = a / b;
    return a % b != 0 && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

static inline int32_t saturated(int128 x)
{
    return x > INT32_MAX ? INT32_MAX : (x < INT32_MIN ? INT32_MIN : (int32_t)x);
}

/* Q32 to Q16, halves up, saturated. */
static inline int32_t q16_of_products(int128 sum)
{
    return saturated(floor_div(sum + 32768, 65536));
}

static inline double real(int32_t x)
{
    return (double)x / 65536.0;
}

static inline q16 fixed(double x)
{
    return (q16)floor(x * 65536.0 + 0.5);
}

static inline qtri_vec3 vec3_of(double x, double y, double z)
{
    qtri_vec3 v = {fixed(x), fixed(y), fixed(z)};
    return v;
}

static inline void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance)) {
        fail_msg("%.12g is not within %g of %.12g", value, tolerance, expected);
    }
}

/* What linear16 stores so: the nearest q16 is within 1/2 of 65535/65536 of a step. */
static inline q16 depth_of(uint16_t stored)
{
    return (q16)(((uint64_t)stored * 65536 + 32767) / 65535);
}

static inline void clear_to(const qtri_surface *surface, qtri_rgb color, uint16_t stored)
{
    qtri_surface_clear(surface, color);
    qtri_surface_clear_depth(surface, depth_of(stored));
}

/* A surface with memory of its own, cleared to black and farthest. */
typedef struct canvas {
    qtri_surface surface;
    void *memory;
    size_t bytes;
} canvas;

static inline canvas canvas_band(const qtri_format *format, int32_t width, int32_t height,
                                 int32_t first, int32_t rows)
{
    canvas c;
    qtri_rgb black = {0, 0, 0};
    c.bytes = QTRI_BAND_BYTES(width, rows, format->pixels->bytes);
    c.memory = calloc(1, c.bytes);
    assert_non_null(c.memory);
    assert_ok(qtri_surface_init(&c.surface, format, width, height, first, rows, c.memory, c.bytes));
    qtri_surface_clear(&c.surface, black);
    return c;
}

static inline canvas canvas_new(const qtri_format *format, int32_t width, int32_t height)
{
    return canvas_band(format, width, height, 0, height);
}

static inline void canvas_clear(canvas *c)
{
    qtri_rgb black = {0, 0, 0};
    qtri_surface_clear(&c->surface, black);
}

static inline void canvas_free(canvas *c)
{
    free(c->memory);
}

/* The pixels of a row, and its depths, are the same in memory. */
static inline bool same_row(const qtri_surface *a, const qtri_surface *b, int32_t y)
{
    const ptrdiff_t row_a = y - a->first_row;
    const ptrdiff_t row_b = y - b->first_row;
    return memcmp(a->pixels + row_a * a->pitch, b->pixels + row_b * b->pitch,
                  (size_t)b->width * b->format->pixels->bytes) == 0 &&
           memcmp(a->depth + row_a * a->depth_pitch, b->depth + row_b * b->depth_pitch,
                  (size_t)b->width * sizeof(uint16_t)) == 0;
}

/* Rows that both hold have the same pixels and depths. */
static inline void assert_same_picture(const qtri_surface *whole, const qtri_surface *part)
{
    for (int32_t y = part->first_row; y < part->first_row + part->rows; y++) {
        if (same_row(whole, part, y)) {
            continue;
        }
        for (int32_t x = 0; x < part->width; x++) {
            if (stored_pixel(whole, x, y) != stored_pixel(part, x, y)) {
                fail_msg("pixel %d,%d: %x and %x", (int)x, (int)y,
                         (unsigned)stored_pixel(whole, x, y), (unsigned)stored_pixel(part, x, y));
            }
            if (stored_depth(whole, x, y) != stored_depth(part, x, y)) {
                fail_msg("depth %d,%d: %u and %u", (int)x, (int)y, stored_depth(whole, x, y),
                         stored_depth(part, x, y));
            }
        }
    }
}

/* The bands of a frame, cleared to a colour, with what is prepared: the whole's rows. */
static inline void assert_same_bands(const qtri_surface *whole, qtri_frame *frame,
                                     const qtri_prepared *prepared, qtri_rgb sky)
{
    qtri_surface band;
    while (qtri_frame_next_band(frame, &band)) {
        qtri_surface_clear(&band, sky);
        qtri_draw_prepared(&band, prepared);
        assert_same_picture(whole, &band);
    }
}

/* Band by band, below each other in the memory of the whole frame. */
static inline void draw_in_bands_of(const canvas *whole, qtri_frame *frame,
                                    const qtri_prepared *prepared)
{
    const qtri_surface *s = &whole->surface;
    qtri_surface band;
    while (qtri_frame_next_band(frame, &band)) {
        band.pixels = s->pixels + band.first_row * s->pitch;
        band.depth = s->depth + band.first_row * s->depth_pitch;
        band.pitch = s->pitch;
        band.depth_pitch = s->depth_pitch;
        qtri_draw_prepared(&band, prepared);
    }
}

/* A view as it is initialised, and a pose that changes nothing. */
static inline void start_view(qtri_view *view, qtri_transform *pose, int32_t width, int32_t height)
{
    qtri_view_init(view, width, height);
    qtri_transform_identity(pose);
}

/* Memory of the view's for a mesh's vertices. */
static inline void give_vertices(qtri_view *view, qtri_vertex *vertices, uint32_t count)
{
    view->vertices = vertices;
    view->vertex_count = count;
}

/* How many pixels are any colour but black. */
static inline int count_painted(const qtri_surface *s)
{
    int count = 0;
    for (int32_t i = 0; i < s->width * s->rows; i++) {
        count += stored_pixel(s, i % s->width, s->first_row + i / s->width) != 0;
    }
    return count;
}

/* How many are not the same on two surfaces of the same rows. */
static inline int count_different(const qtri_surface *a, const qtri_surface *b)
{
    int count = 0;
    for (int32_t i = 0; i < a->width * a->rows; i++) {
        const int32_t x = i % a->width, y = a->first_row + i / a->width;
        count += stored_pixel(a, x, y) != stored_pixel(b, x, y);
    }
    return count;
}

/* The channel that two colours differ in most. */
static inline int channels_apart(qtri_rgb a, qtri_rgb b)
{
    const int red = abs(a.r - b.r), green = abs(a.g - b.g), blue = abs(a.b - b.b);
    const int most = red > green ? red : green;
    return most > blue ? most : blue;
}

/* How many pixels differ by more than so much in a channel, and in depth. */
static inline int count_apart(const qtri_surface *a, const qtri_surface *b, int most)
{
    int count = 0;
    for (int32_t i = 0; i < a->width * a->rows; i++) {
        const int32_t x = i % a->width, y = a->first_row + i / a->width;
        count += channels_apart(qtri_surface_pixel(a, x, y), qtri_surface_pixel(b, x, y)) > most;
    }
    return count;
}

static inline int count_depths_apart(const qtri_surface *a, const qtri_surface *b, int most)
{
    int count = 0;
    for (int32_t i = 0; i < a->width * a->rows; i++) {
        const int32_t x = i % a->width, y = a->first_row + i / a->width;
        count += abs(stored_depth(a, x, y) - stored_depth(b, x, y)) > most;
    }
    return count;
}

static inline void assert_close(const qtri_surface *a, const qtri_surface *b, int most)
{
    for (int32_t i = 0; i < a->width * a->rows; i++) {
        const int32_t x = i % a->width, y = a->first_row + i / a->width;
        const qtri_rgb p = qtri_surface_pixel(a, x, y), q = qtri_surface_pixel(b, x, y);
        if (channels_apart(p, q) > most) {
            fail_msg("pixel %d,%d: %d %d %d and %d %d %d", (int)x, (int)y, p.r, p.g, p.b, q.r, q.g,
                     q.b);
        }
    }
}

/* The pixels that a triangle may cover, and at least one more on each side, within the surface. */
static inline qtri_rect pixels_around(const qtri_surface *s, const qtri_screen_vertex v[3])
{
    qtri_rect r = {s->width, s->height, 0, 0};
    for (int i = 0; i < 3; i++) {
        const int32_t x = v[i].x_24p8 / 256; /* towards zero: one too many or too few */
        const int32_t y = v[i].y_24p8 / 256;
        r.x0 = x - 2 < r.x0 ? x - 2 : r.x0;
        r.y0 = y - 2 < r.y0 ? y - 2 : r.y0;
        r.x1 = x + 3 > r.x1 ? x + 3 : r.x1;
        r.y1 = y + 3 > r.y1 ? y + 3 : r.y1;
    }
    r.x0 = r.x0 < 0 ? 0 : r.x0;
    r.y0 = r.y0 < 0 ? 0 : r.y0;
    r.x1 = r.x1 > s->width ? s->width : r.x1;
    r.y1 = r.y1 > s->height ? s->height : r.y1;
    return r;
}

/* The pixels of a rectangle, row by row: for (at = first_pixel(r); at.y < r.y1; at = next_pixel(at,
 * r)). */
typedef struct screen_pixel {
    int32_t x, y;
} screen_pixel;

static inline screen_pixel first_pixel(qtri_rect r)
{
    const screen_pixel at = {r.x0, r.x0 < r.x1 ? r.y0 : r.y1};
    return at;
}

static inline screen_pixel next_pixel(screen_pixel at, qtri_rect r)
{
    at.x++;
    if (at.x == r.x1) {
        at.x = r.x0;
        at.y++;
    }
    return at;
}

/* Nothing but these pixels differs from a canvas as it is cleared; clears them. */
static inline void erase_and_check(canvas *c, qtri_rect drawn, const canvas *cleared)
{
    c->surface.scissor = drawn;
    canvas_clear(c);
    c->surface.scissor = cleared->surface.scissor;
    assert_same_picture(&cleared->surface, &c->surface);
}

/* Rows of the surface from the top: '#' is any colour but black. Ends with NULL. */
static inline void assert_rows(const qtri_surface *s, const char *const rows[])
{
    for (int32_t y = 0; rows[y] != NULL; y++) {
        for (int32_t x = 0; rows[y][x] != '\0'; x++) {
            char is = stored_pixel(s, x, y) != 0 ? '#' : '.';
            if (is != rows[y][x]) {
                fail_msg("row %d \"%s\": pixel %d is '%c'", (int)y, rows[y], (int)x, is);
            }
        }
    }
}

#define assert_raster(surface, ...) assert_rows(surface, (const char *const[]){__VA_ARGS__, NULL})

/* A white vertex at a distance of 1, coordinates in 1/256 pixel. */
static inline qtri_screen_vertex screen_at(int32_t x_24p8, int32_t y_24p8)
{
    qtri_screen_vertex v = {0};
    v.x_24p8 = x_24p8;
    v.y_24p8 = y_24p8;
    v.inv_w_q31 = 0x80000000u;
    for (int i = 0; i < 3; i++) {
        v.color_8p16[i] = 255 << 16;
    }
    return v;
}

/* Flat, untextured, both sides, no depth. */
/* 0: smooth, 1 and 2: flat. */
static inline const qtri_shading *shading_of(int n)
{
    const qtri_shading *const all[3] = {QTRI_SMOOTH, QTRI_FLAT_FIRST, QTRI_FLAT_LAST};
    return all[n];
}

static inline qtri_material plain_material(void)
{
    qtri_material material = qtri_material_default();
    material.shading = QTRI_FLAT_FIRST;
    material.cull = QTRI_CULL_NONE;
    material.depth_compare = QTRI_DEPTH_OFF;
    return material;
}

#endif
