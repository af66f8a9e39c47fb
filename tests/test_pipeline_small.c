/* SPDX-License-Identifier: MIT */
/*
 * Small triangles by the pipelines' body: instances, the generic one, one for a core with narrow
 * products, tiles and bands draw the same bits; coverage is exact, and depth, light and texture
 * coordinates are as near to those in double precision as body/small_triangle.h says.
 */
#include "support/core.h"
#include "support/small_narrow.h"
#include "support/layouts.h"

/* GCC does not see that the generic instance reads only the ramps that its options also set. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <qtri/body/small.h>

enum { WIDTH = 240, HEIGHT = 180, COUNT = 60, VERTICES = 3 * COUNT, TEXELS = 1 << 12 };

/* Instances ------------------------------------------------------------------------------------ */

static bool wave(qtri_fragment *f)
{
    f->color ^= (f->u >> 24) + (f->light_q8 << 3) + ((uint32_t)f->x & 3);
    return ((uint32_t)f->y + (f->depth_16p16 >> 20)) % 7 != 0;
}

#define SMALL_PIPELINE(name, ...)                                                                  \
    static void name##_pixel(qtri_pixel_walk *w, bool bent, uint8_t *pixel, uint8_t *depth)        \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_pixel_at(&options, w, bent, pixel, depth);                                            \
    }                                                                                              \
    static bool name##_small(qtri_small *triangle)                                                 \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        return qtri_small_triangle_draw(&options, name##_pixel, triangle);                         \
    }                                                                                              \
    static const qtri_pipeline name = {{__VA_ARGS__}, NULL, name##_small, NULL, NULL, NULL};

#define LESS_565 .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS

SMALL_PIPELINE(flat, LESS_565)
SMALL_PIPELINE(lit, LESS_565, .shade = QTRI_LIGHT)
SMALL_PIPELINE(colored, LESS_565, .shade = QTRI_COLORS)
SMALL_PIPELINE(crate, LESS_565, .shade = QTRI_LIGHT, .texel = QTRI_TEXEL_RGB565)
SMALL_PIPELINE(white, LESS_565, .shade = QTRI_WHITE_LIGHT, .texel = QTRI_TEXEL_RGB565)
SMALL_PIPELINE(replaced, .format = QTRI_RGB565_SWAPPED, .depth = QTRI_FLOAT16,
               .compare = QTRI_LESS_EQUAL, .texel = QTRI_TEXEL_RGB565, .wrap_u = QTRI_CLAMP)
SMALL_PIPELINE(tinted, .format = QTRI_RGB888, .depth = QTRI_LINEAR24, .compare = QTRI_GREATER,
               .texel = QTRI_TEXEL_XRGB8888, .shade = QTRI_TINT, .bilinear = 1)
SMALL_PIPELINE(weighed, .format = QTRI_XRGB8888, .depth = QTRI_LINEAR32, .compare = QTRI_NOT_EQUAL,
               .texel = QTRI_TEXEL_ARGB8888, .shade = QTRI_COLORS, .blend = QTRI_ALPHA,
               .alpha_test = 1)
SMALL_PIPELINE(weighed_565, LESS_565, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_COLORS,
               .bilinear = 1, .key = 1, .wrap_u = QTRI_CLAMP, .wrap_v = QTRI_CLAMP)
SMALL_PIPELINE(gray, .format = QTRI_GRAY8, .depth = QTRI_LINEAR16, .compare = QTRI_ALWAYS,
               .shade = QTRI_COLORS, .blend = QTRI_ADD)
SMALL_PIPELINE(gray_light, .format = QTRI_GRAY8, .shade = QTRI_LIGHT, .blend = QTRI_MULTIPLY)
SMALL_PIPELINE(clear, .format = QTRI_BGR888, .depth = QTRI_LINEAR16, .compare = QTRI_GREATER_EQUAL,
               .read_only = 1, .shade = QTRI_COLORS, .blend = QTRI_ALPHA, .vertex_alpha = 1,
               .keep = 1)
SMALL_PIPELINE(foggy, LESS_565, .shade = QTRI_LIGHT, .fog = 1)
SMALL_PIPELINE(foggy_texture, LESS_565, .shade = QTRI_LIGHT, .fog = 1, .texel = QTRI_TEXEL_PALETTE8)
SMALL_PIPELINE(doors, .format = QTRI_RGB565_EXACT, .depth = QTRI_LINEAR16, .compare = QTRI_EQUAL,
               .shade = QTRI_LIGHT, .blend = QTRI_SCREEN_DOOR, .vertex_alpha = 1)
SMALL_PIPELINE(waves, LESS_565, .shade = QTRI_LIGHT, .texel = QTRI_TEXEL_GRAY8, .fragment = wave)
SMALL_PIPELINE(affine, LESS_565, .shade = QTRI_COLORS, .texel = QTRI_TEXEL_ARGB4444)
SMALL_PIPELINE(depths, .format = QTRI_DEPTH_ONLY, .depth = QTRI_LINEAR24, .compare = QTRI_LESS)

static const qtri_pipeline *const instances[] = {
    &flat, &lit,   &colored,    &crate, &white,         &replaced, &tinted, &weighed, &weighed_565,
    &gray, &clear, &gray_light, &foggy, &foggy_texture, &doors,    &waves,  &affine,  &depths};

/* As the generic pipeline: options that nothing tells the compiler. */
static void any_pixel(qtri_pixel_walk *w, bool bent, uint8_t *pixel, uint8_t *depth)
{
    qtri_pixel_at(&w->state->options, w, bent, pixel, depth);
}

static bool any_small(qtri_small *triangle)
{
    return qtri_small_triangle_draw(&triangle->state->options, any_pixel, triangle);
}

/* Scenes --------------------------------------------------------------------------------------- */

typedef struct heap {
    uint16_t table[QTRI_TABLE];
    qtri_vertex vertices[VERTICES];
    qtri_rgb colors[VERTICES];
    qtri_vec2 uvs[VERTICES];
    uint8_t alphas[VERTICES];
    uint32_t texels[TEXELS];
    qtri_rgb palette[256];
    uint16_t indices[COUNT][3];
    qtri_mesh mesh;
    qtri_texture texture;
    qtri_material material;
    qtri_fog fog;
} heap;

static heap scene;

static int32_t max_of(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* Of any size up to `reach` 24.8, 1/w within `slope` thousandths, turned to face the eye. */
static void set_triangle(heap *h, int i, uint64_t *seed, int32_t reach, int32_t slope)
{
    const int32_t x = random_in(seed, 0, WIDTH * 256), y = random_in(seed, 0, HEIGHT * 256);
    const int32_t z = random_in(seed, 0, 65535), q = random_in(seed, 0, (1 << 30) - 1);
    const int32_t high = reach <= 15359 ? reach : 15359; /* 120 pixels in all */
    const int32_t steep = random_in(seed, 0, 1100), turn = random_in(seed, 0, 4);
    for (int k = 3 * i; k < 3 * i + 3; k++) {
        qtri_vertex *v = &h->vertices[k];
        v->at.x_24p8 = x + (k % 3 == 0 ? 0 : random_in(seed, -reach, reach));
        v->at.y_24p8 = y + (k % 3 == 0 ? 0 : random_in(seed, -high, high));
        if (turn == 0) { /* on pixels' centres and edges */
            v->at.x_24p8 &= ~127;
            v->at.y_24p8 &= ~127;
        }
        const int64_t depth = (int64_t)z * 256 + (int64_t)random_in(seed, -steep, steep) * 256;
        const int64_t held = depth < 0 ? 0 : depth > 0xFFFF00 ? 0xFFFF00 : depth;
        int64_t w = (int64_t)(1 << 30) + q + (int64_t)q * random_in(seed, -slope, slope) / 1000;
        uint32_t exponent = 8;
        if (w < 1 << 30) {
            w *= 2;
            exponent++;
        }
        w = w > INT32_MAX ? INT32_MAX : w;
        v->depth_16p8 = (uint32_t)held << 8 | exponent;
        v->inv_w = (uint32_t)w;
        v->intensity_q15 = (uint16_t)max_of(0, 32768 - random_in(seed, -9000, 32768));
        v->intensity_q15 = v->intensity_q15 > 32768 ? 32768 : v->intensity_q15;
        h->colors[k].r = (uint8_t)random_in(seed, 0, 255);
        h->colors[k].g = (uint8_t)random_in(seed, 0, 255);
        h->colors[k].b = (uint8_t)random_in(seed, 0, 255);
        h->alphas[k] = (uint8_t)random_in(seed, 0, 255);
        h->uvs[k].x = random_in(seed, -70000, 70000) * (turn == 1 ? 16 : 1);
        h->uvs[k].y = random_in(seed, -70000, 70000);
        h->indices[i][k % 3] = (uint16_t)k;
    }
}

static const qtri_format *format_of(uint8_t kind)
{
    switch (kind) {
    case QTRI_RGB565:
        return &qtri_rgb565;
    case QTRI_RGB565_SWAPPED:
        return &qtri_rgb565_swapped;
    case QTRI_RGB565_EXACT:
        return &qtri_rgb565_exact;
    case QTRI_RGB888:
        return &qtri_rgb888;
    case QTRI_BGR888:
        return &qtri_bgr888;
    case QTRI_XRGB8888:
        return &qtri_xrgb8888;
    case QTRI_GRAY8:
        return &qtri_gray8;
    default:
        return &qtri_depth_only;
    }
}

static const qtri_depth_format *depth_format_of(uint8_t kind)
{
    return kind == QTRI_FLOAT16    ? &qtri_depth_float16
           : kind == QTRI_LINEAR24 ? &qtri_depth_linear24
           : kind == QTRI_LINEAR32 ? &qtri_depth_linear32
                                   : &qtri_depth_linear16;
}

static void set_state(qtri_draw_state *s, heap *h, const qtri_pipeline *pipeline,
                      const qtri_surface *surface)
{
    const qtri_options *o = &pipeline->options;
    const qtri_rect b = qtri_surface_bounds(surface);
    const int32_t reach = 33 * 256; /* as in draw_state.c */
    memset(s, 0, sizeof *s);
    s->table = h->table;
    s->pipeline = pipeline;
    s->options = *o;
    s->surface = surface;
    s->material = &h->material;
    s->alphas = h->alphas;
    s->bounds = b;
    s->inner.x = (uint32_t)(b.x0 * 256 + reach);
    s->inner.y = (uint32_t)(b.y0 * 256 + reach);
    s->inner.width = (uint32_t)max_of(0, (b.x1 - b.x0) * 256 - 2 * reach);
    s->inner.height = (uint32_t)max_of(0, (b.y1 - b.y0) * 256 - 2 * reach);
    s->depth = surface->depth;
    s->depth_pitch = surface->depth_pitch * (ptrdiff_t)qtri_depth_size(o, surface);
    s->color = 0xF0A070;
    s->weight[0] = 0xF1;
    s->weight[1] = 0xA1;
    s->weight[2] = 0x70;
    s->alpha = 200;
    s->keep = 0xFF00;
    s->fog = &h->fog;
    s->fog_color = 0x8090A0;
    s->texture = &h->texture;
    s->width_log2 = h->texture.width_log2;
    s->height_log2 = h->texture.height_log2;
    s->traits = (uint8_t)((o->wrap_u == QTRI_CLAMP ? QTRI_CLAMPS_U : 0) |
                          (o->wrap_v == QTRI_CLAMP && s->height_log2 != 0 ? QTRI_CLAMPS_V : 0) |
                          (s->width_log2 + s->height_log2 < 8 ? QTRI_FEW_TEXELS : 0));
    s->key_mask = UINT32_MAX;
    s->key = 0x1234;
    s->alpha_least = (uint32_t)90 << 24;
}

/* Draws all triangles, or notes which are large. */
static void draw(heap *h, const qtri_pipeline *pipeline, bool (*by)(qtri_small *),
                 const qtri_surface *surface, bool large[COUNT])
{
    qtri_draw_state state;
    set_state(&state, h, pipeline, surface);
    for (int i = 0; i < COUNT; i++) {
        qtri_small t = {.state = &state,
                        .mesh = &h->mesh,
                        .index = {h->indices[i][0], h->indices[i][1], h->indices[i][2]},
                        .indices = h->indices[i],
                        .light_q15 = i % 5 == 0 ? 20000 : 0xFFFF};
        for (int k = 0; k < 3; k++) {
            t.v[k] = &h->vertices[t.index[k]];
        }
        large[i] = !by(&t);
    }
}

static void new_surface(qtri_surface *s, const qtri_options *o, uint8_t *memory, size_t bytes,
                        int32_t first_row, int32_t rows)
{
    memset(memory, 0x5A, bytes);
    assert_ok(surface_with_depth(s, format_of(o->format), depth_format_of(o->depth), WIDTH, HEIGHT,
                                 first_row, rows, memory, bytes));
}

enum { BYTES = WIDTH * HEIGHT * 8 + 8 };

static void set_scene(heap *h, uint64_t *seed, const qtri_options *o)
{
    static const int32_t reaches[] = {256, 1500, 6000, 8191, 15359, 30719};
    static const int32_t slopes[] = {0, 8, 60, 240};
    for (int i = 0; i < COUNT; i++) {
        set_triangle(h, i, seed, reaches[random_in(seed, 0, 5)], slopes[random_in(seed, 0, 3)]);
    }
    h->mesh.colors = o->shade == QTRI_COLORS ? h->colors : NULL;
    h->mesh.uvs = h->uvs;
    h->texture.width_log2 = (uint8_t)random_in(seed, 1, 6);
    h->texture.height_log2 = (uint8_t)random_in(seed, 0, 6);
    h->texture.texels = h->texels;
    h->texture.palette = h->palette;
    h->material = qtri_material_default();
    h->material.cull = random_flag(seed) ? QTRI_CULL_NONE : QTRI_CULL_BACK;
}

static void compare(const uint8_t *a, const uint8_t *b, const bool *large, const bool *other)
{
    assert_memory_equal(a, b, BYTES);
    if (other != NULL) {
        assert_memory_equal(large, other, COUNT * sizeof *large);
    }
}

TEST(instances_draw_the_same_bits)
{
    static uint8_t whole[BYTES], other[BYTES];
    uint64_t seed = 5;
    int drawn = 0;
    for (int n = 0; n < random_cases(400); n++) {
        const qtri_pipeline *pipeline = instances[n % (int)LENGTH_OF(instances)];
        const qtri_options *o = &pipeline->options;
        bool large[COUNT], large_too[COUNT];
        qtri_surface surface;
        set_scene(&scene, &seed, o);
        for (int k = 0; k < VERTICES && n % 4 == 3; k++) { /* 1000 repeats, and more */
            scene.uvs[k].x *= 1000;
            scene.uvs[k].y *= 3500;
        }
        new_surface(&surface, o, whole, BYTES, 0, HEIGHT);
        draw(&scene, pipeline, pipeline->small, &surface, large);
        for (int i = 0; i < COUNT; i++) {
            drawn += !large[i];
        }
        new_surface(&surface, o, other, BYTES, 0, HEIGHT);
        draw(&scene, pipeline, any_small, &surface, large_too);
        compare(whole, other, large, large_too);
        new_surface(&surface, o, other, BYTES, 0, HEIGHT);
        draw(&scene, pipeline, narrow_small_draw, &surface, large_too);
        compare(whole, other, large, large_too);

        new_surface(&surface, o, other, BYTES, 0, HEIGHT);
        for (int32_t y = 0; y < HEIGHT; y += 17) {
            for (int32_t x = 0; x < WIDTH; x += 41) {
                const qtri_rect tile = {x, y, x + 41, y + 17};
                surface.scissor = tile;
                draw(&scene, pipeline, pipeline->small, &surface, large_too);
            }
        }
        compare(whole, other, large, NULL);

        static uint8_t memory[BYTES];
        qtri_surface frame;
        new_surface(&frame, o, other, BYTES, 0, HEIGHT);
        for (int32_t y = 0; y < HEIGHT; y += 11) {
            qtri_surface band;
            const int32_t rows = HEIGHT - y < 11 ? HEIGHT - y : 11;
            new_surface(&band, o, memory, BYTES, y, rows);
            draw(&scene, pipeline, pipeline->small, &band, large_too);
            const size_t pitch = (size_t)band.pitch;
            const size_t depth_pitch = (size_t)band.depth_pitch * depth_format_of(o->depth)->bytes;
            memcpy(frame.pixels + (size_t)y * pitch, band.pixels, (size_t)rows * pitch);
            memcpy((uint8_t *)frame.depth + (size_t)y * depth_pitch, band.depth,
                   (size_t)rows * depth_pitch);
        }
        compare(whole, other, large, NULL);
    }
    assert_true(drawn > random_cases(400) * COUNT / 3);
}

/* Coverage ------------------------------------------------------------------------------------- */

static bool covers(const qtri_vertex *const v[3], int32_t x, int32_t y)
{
    for (int i = 0; i < 3; i++) {
        const qtri_point *a = &v[i]->at;
        const qtri_point *b = &v[(i + 1) % 3]->at;
        const int64_t dx = b->x_24p8 - a->x_24p8, dy = b->y_24p8 - a->y_24p8;
        const int64_t e =
            (int64_t)(x * 256 + 128 - a->x_24p8) * dy - (int64_t)(y * 256 + 128 - a->y_24p8) * dx;
        if (e < 0 || (e == 0 && !(dy > 0 || (dy == 0 && dx < 0)))) {
            return false;
        }
    }
    return true;
}

SMALL_PIPELINE(blank, .format = QTRI_GRAY8)

TEST(coverage_is_exact)
{
    static uint8_t memory[BYTES];
    static const int32_t reaches[] = {100, 256, 600, 1500, 4000, 8000, 15359, 30719};
    uint64_t seed = 7;
    qtri_surface surface;
    qtri_draw_state state;
    int small = 0;
    scene.mesh.colors = NULL; /* of one colour that is not what was there before */
    for (int n = 0; n < random_cases(20000); n++) {
        const int i = n % COUNT;
        set_triangle(&scene, i, &seed, reaches[n % (int)LENGTH_OF(reaches)], 0);
        scene.material = qtri_material_default();
        new_surface(&surface, &blank.options, memory, WIDTH * HEIGHT * 3 + 8, 0, HEIGHT);
        set_state(&state, &scene, &blank, &surface);
        qtri_small t = {.state = &state, .mesh = &scene.mesh, .light_q15 = 0xFFFF};
        for (int k = 0; k < 3; k++) {
            t.v[k] = &scene.vertices[3 * i + k];
        }
        const bool is_small = blank_small(&t);
        small += is_small;
        int32_t left = INT32_MAX, right = INT32_MIN, top = INT32_MAX, bottom = INT32_MIN;
        for (int k = 0; k < 3; k++) {
            const int32_t x = t.v[k]->at.x_24p8 / 256, y = t.v[k]->at.y_24p8 / 256;
            left = x < left ? x : left;
            right = x > right ? x : right;
            top = y < top ? y : top;
            bottom = y > bottom ? y : bottom;
        }
        for (int32_t y = max_of(0, top - 1); y < HEIGHT && y <= bottom + 1 && is_small; y++) {
            for (int32_t x = max_of(0, left - 1); x < WIDTH && x <= right + 1; x++) {
                const bool is_drawn = surface.pixels[y * surface.pitch + x] != 0x5A;
                assert_true(is_drawn == covers((const qtri_vertex *const *)t.v, x, y));
            }
        }
    }
    assert_true(small > random_cases(20000) * 9 / 10);
}

SMALL_PIPELINE(by_pixel, .format = QTRI_GRAY8, .per_pixel = 1)

static bool is_linear(const qtri_small *t)
{
    (void)t;
    return true;
}

static bool is_small_of(const qtri_pipeline *pipeline, const qtri_surface *surface, int32_t x1,
                        int32_t y1, int32_t x2, int32_t y2, int32_t rest)
{
    qtri_draw_state state;
    set_state(&state, &scene, pipeline, surface);
    state.has_linear_light = is_linear;
    qtri_small t = {.state = &state, .mesh = &scene.mesh, .light_q15 = 0xFFFF};
    for (int k = 0; k < 3; k++) {
        t.v[k] = &scene.vertices[k];
        t.v[k]->depth_16p8 = 8;
        t.v[k]->inv_w = (uint32_t)1 << 30;
        t.v[k]->at.x_24p8 = 120 * 256 + (k == 0 ? 0 : k == 1 ? x1 : x2);
        t.v[k]->at.y_24p8 = 60 * 256 + rest + (k == 0 ? 0 : k == 1 ? y1 : y2);
    }
    return pipeline->small(&t);
}

static bool is_small(const qtri_surface *surface, int32_t x1, int32_t y1, int32_t x2, int32_t y2,
                     int32_t rest)
{
    return is_small_of(&blank, surface, x1, y1, x2, y2, rest);
}

/* 120 pixels and their fractions, below which all rows fit a small triangle's spans. */
TEST(small_ones_are_less_than_120_pixels_high_and_to_both_sides)
{
    static uint8_t memory[BYTES];
    const int32_t most = 120 * 256 - 1;
    qtri_surface surface;
    scene.mesh.colors = NULL;
    scene.material = qtri_material_default();
    scene.material.cull = QTRI_CULL_NONE;
    new_surface(&surface, &blank.options, memory, WIDTH * HEIGHT * 3 + 8, 0, HEIGHT);
    for (int32_t rest = 0; rest < 256; rest++) {
        for (int32_t up = 0; up <= most; up += most / 7) {
            assert_true(is_small(&surface, 900, -up, -900, most - up, rest));
            assert_true(is_small(&surface, -900, most - up, 900, -up, rest));
            assert_false(is_small(&surface, 900, -up, -900, most - up + 1, rest));
        }
        assert_true(is_small(&surface, most, 700, -most - 1, 500, rest));
        assert_false(is_small(&surface, most + 1, 700, -most, 500, rest));
        assert_false(is_small(&surface, 700, 500, -most - 2, 600, rest));
    }
}

/* What light is between its vertices is asked in a few places. */
TEST(light_by_pixel_is_linear_within_60_pixels)
{
    static uint8_t memory[BYTES];
    const int32_t most = 60 * 256 - 1;
    qtri_surface surface;
    new_surface(&surface, &by_pixel.options, memory, WIDTH * HEIGHT * 3 + 8, 0, HEIGHT);
    assert_true(is_small_of(&by_pixel, &surface, most, 700, -most - 1, 500, 0));
    assert_true(is_small_of(&by_pixel, &surface, 700, -most - 1, 500, most, 0));
    assert_false(is_small_of(&by_pixel, &surface, most + 1, 700, -most, 500, 0));
    assert_false(is_small_of(&by_pixel, &surface, 700, -most - 2, -500, most, 0));
}

/* Errors --------------------------------------------------------------------------------------- */

/* Of the triangle being drawn, in double precision. */
static struct measured {
    const qtri_small *triangle;
    double side[2];
    double depth, light, texel;
    int small, pixels, far;
} now;

/* Shares of the vertices at a pixel's centre, and those times 1/w. */
static void find_shares(double b[3], double q[3], const qtri_small *t, int32_t column, int32_t row)
{
    double x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = t->v[i]->at.x_24p8 / 256.0 - column - .5;
        y[i] = t->v[i]->at.y_24p8 / 256.0 - row - .5;
        q[i] = ldexp(t->v[i]->inv_w, -(int)(t->v[i]->depth_16p8 & 255));
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    b[1] = (-x[0] * (y[2] - y[0]) + (x[2] - x[0]) * y[0]) / area;
    b[2] = (-(x[1] - x[0]) * y[0] + x[0] * (y[1] - y[0])) / area;
    b[0] = 1 - b[1] - b[2];
}

static bool measure(qtri_fragment *f)
{
    double b[3], q[3], at_q = 0, z = 0, light = 0, uv[2] = {0, 0};
    const qtri_small *t = now.triangle;
    find_shares(b, q, t, f->x, f->y);
    for (int i = 0; i < 3; i++) {
        z += b[i] * (t->v[i]->depth_16p8 >> 8) / 256.0;
        at_q += b[i] * q[i];
        light += b[i] * q[i] * t->v[i]->intensity_q15 / 128.0;
        uv[0] += b[i] * q[i] * t->mesh->uvs[t->index[i]].x / 65536.0;
        uv[1] += b[i] * q[i] * t->mesh->uvs[t->index[i]].y / 65536.0;
    }
    const double u = (double)f->u / 4294967296.0;
    const double v = (double)f->v / 4294967296.0;
    const double du = fabs(remainder(u - uv[0] / at_q, 1.0)) * now.side[0];
    const double dv = fabs(remainder(v - uv[1] / at_q, 1.0)) * now.side[1];
    now.texel = fmax(now.texel, fmax(du, dv));
    now.far += fmax(du, dv) > 1 / 16.0;
    now.depth = fmax(now.depth, fabs((f->depth_16p16 - 32768.0) / 65536 - z));
    now.light = fmax(now.light, fabs(f->light_q8 - light / at_q));
    now.pixels++;
    return true;
}

SMALL_PIPELINE(measured, LESS_565, .shade = QTRI_LIGHT, .texel = QTRI_TEXEL_RGB565,
               .fragment = measure)

/* Coordinates are from 0 to `most` / 2^16 of a texture of 64 x 32. */
static void draw_measured(int i, int32_t reach, int32_t slope, int32_t most, uint64_t *seed)
{
    static uint8_t memory[BYTES];
    qtri_surface surface;
    qtri_draw_state state;
    set_triangle(&scene, i, seed, reach, slope);
    for (int k = 3 * i; k < 3 * i + 3; k++) {
        scene.uvs[k].x %= most;
        scene.uvs[k].y %= most;
    }
    scene.material = qtri_material_default();
    scene.mesh.uvs = scene.uvs;
    scene.texture.texels = scene.texels;
    scene.texture.width_log2 = 6;
    scene.texture.height_log2 = 5;
    now.side[0] = 64;
    now.side[1] = 32;
    new_surface(&surface, &measured.options, memory, BYTES, 0, HEIGHT);
    memset(surface.depth, 0xFF, (size_t)surface.depth_pitch * 2 * HEIGHT);
    set_state(&state, &scene, &measured, &surface);
    qtri_small t = {.state = &state, .mesh = &scene.mesh, .light_q15 = 0xFFFF};
    for (int k = 0; k < 3; k++) {
        t.index[k] = (uint32_t)(3 * i + k);
        t.v[k] = &scene.vertices[3 * i + k];
    }
    now.triangle = &t;
    now.small += measured_small(&t);
}

TEST(values_are_near_those_in_double_precision)
{
    uint64_t seed = 11;
    memset(&now, 0, sizeof now);
    for (int n = 0; n < random_cases(4000); n++) {
        draw_measured(n % COUNT, n % 5 == 4 ? 30719 : 1500 << n % 5,
                      n % 3 == 0   ? 400
                      : n % 3 == 1 ? 60
                                   : 5,
                      20000, &seed); /* a texel a pixel, or fewer */
    }
    printf("%d pixels: depth off by %.3f, light by %.2f of 256, coordinates by %.4f texel, %d by "
           "more than 1/16\n",
           now.pixels, now.depth, now.light, now.texel, now.far);
    assert_true(now.depth < .25);
    assert_true(now.light < 3);
    assert_int_equal(now.far, 0);
}

/* A fifth of those that are small bend by more than a curve over the whole triangle may. */
TEST(textures_are_divided_in_steep_perspective)
{
    uint64_t seed = 12;
    memset(&now, 0, sizeof now);
    for (int n = 0; n < random_cases(3000); n++) {
        draw_measured(n % COUNT, n % 2 == 0 ? 30719 : 18000, 500, 60000, &seed);
    }
    printf("%d small, %d pixels: coordinates off by %.4f texel, light by %.2f of 256\n", now.small,
           now.pixels, now.texel, now.light);
    assert_true(now.small > random_cases(3000) * 17 / 20);
    assert_int_equal(now.far, 0);
    assert_true(now.light < 3);
}

/* Colours: of channels of 0 and 255 as often as of others, so that none may leave its field. */

SMALL_PIPELINE(xrgb_colors, .format = QTRI_XRGB8888, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,
               .shade = QTRI_COLORS)
SMALL_PIPELINE(gray_colors, .format = QTRI_GRAY8, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,
               .shade = QTRI_COLORS)
SMALL_PIPELINE(xrgb_weights, .format = QTRI_XRGB8888, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,
               .texel = QTRI_TEXEL_XRGB8888, .shade = QTRI_COLORS)
SMALL_PIPELINE(weights, LESS_565, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_COLORS)

/* How far a pixel is from what it should be, in steps of its format. */
static double color_error(const qtri_small *t, uint32_t pixel, uint8_t format, int32_t x, int32_t y)
{
    double b[3], q[3], at_q = 0, rgb[3] = {0, 0, 0}, most = 0;
    find_shares(b, q, t, x, y);
    for (int i = 0; i < 3; i++) {
        const qtri_rgb *color = &t->mesh->colors[t->index[i]];
        at_q += b[i] * q[i];
        rgb[0] += b[i] * q[i] * color->r / 255;
        rgb[1] += b[i] * q[i] * color->g / 255;
        rgb[2] += b[i] * q[i] * color->b / 255;
    }
    if (format == QTRI_GRAY8) {
        return fabs(pixel - 255 * (.299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2]) / at_q);
    }
    for (int i = 0; i < 3; i++) {
        const bool is_565 = format == QTRI_RGB565;
        const uint32_t full = !is_565 ? 255 : i == 1 ? 63 : 31;
        const uint32_t at = is_565 ? (i == 0 ? 11 : i == 1 ? 5 : 0) : (uint32_t)(16 - 8 * i);
        most = fmax(most, fabs((pixel >> at & full) - full * rgb[i] / at_q));
    }
    return most;
}

static uint32_t pixel_at(const qtri_surface *s, uint8_t format, int32_t x, int32_t y)
{
    const uint8_t *row = s->pixels + (ptrdiff_t)s->pitch * y;
    if (format == QTRI_GRAY8) {
        return row[x];
    }
    if (format == QTRI_RGB565) {
        uint16_t word;
        memcpy(&word, row + 2 * (size_t)x, sizeof word);
        return word;
    }
    uint32_t word;
    memcpy(&word, row + 4 * (size_t)x, sizeof word);
    return word;
}

/* Triangles of any size; of nearly 32 pixels and channels at one end of their range or at both; or
   large and steep ones with such channels. */
typedef enum kind { ANY, AT_ENDS, STEEP } kind;

static double worst_color(const qtri_pipeline *pipeline, uint64_t *seed, int cases, kind which,
                          int *small)
{
    const bool at_ends = which != ANY;
    static uint8_t memory[BYTES];
    qtri_surface surface;
    qtri_draw_state state;
    double worst = 0;
    for (int n = 0; n < cases; n++) {
        if (which == STEEP) {
            set_triangle(&scene, 0, seed, n % 2 == 0 ? 30719 : 9000, 500);
        } else {
            set_triangle(&scene, 0, seed,
                         at_ends      ? 8191
                         : n % 5 == 4 ? 30719
                                      : 1500 << n % 5,
                         at_ends || n % 3 == 2 ? 30
                         : n % 3 == 0          ? 400
                                               : 120);
        }
        for (int k = 0; k < 3; k++) {
            qtri_rgb *color = &scene.colors[k];
            const int32_t ends = random_in(seed, 0, 63) | (at_ends ? 1 + 4 + 16 : 0);
            const uint8_t low = at_ends && n % 3 == 1 ? 128 : 0;
            const uint8_t high = at_ends && n % 3 == 2 ? 128 : 255;
            color->r = (ends & 1) != 0 ? (ends & 2) != 0 ? high : low : color->r;
            color->g = (ends & 4) != 0 ? (ends & 8) != 0 ? high : low : color->g;
            color->b = (ends & 16) != 0 ? (ends & 32) != 0 ? high : low : color->b;
        }
        new_surface(&surface, &pipeline->options, memory, BYTES, 0, HEIGHT);
        memset(surface.depth, 0xFF, (size_t)surface.depth_pitch * 2 * HEIGHT);
        set_state(&state, &scene, pipeline, &surface);
        qtri_small t = {
            .state = &state, .mesh = &scene.mesh, .index = {0, 1, 2}, .light_q15 = QTRI_SMALL_ONE};
        for (int k = 0; k < 3; k++) {
            t.v[k] = &scene.vertices[k];
        }
        *small += pipeline->small(&t);
        for (int32_t y = 0; y < HEIGHT; y++) {
            const uint16_t *depth = (const uint16_t *)surface.depth + surface.depth_pitch * y;
            for (int32_t x = 0; x < WIDTH; x++) {
                if (depth[x] != 0xFFFF) {
                    const uint8_t format = pipeline->options.format;
                    const uint32_t pixel = pixel_at(&surface, format, x, y);
                    worst = fmax(worst, color_error(&t, pixel, format, x, y));
                }
            }
        }
    }
    return worst;
}

TEST(colors_are_near_those_in_double_precision)
{
    static const struct {
        const qtri_pipeline *pipeline;
        double most;
    } cases[] = {{&colored, 1.3},
                 {&xrgb_colors, 1.1},
                 {&gray_colors, 1.1},
                 {&weights, 1.5},
                 {&xrgb_weights, 1.5}};
    static uint32_t full[64];
    uint64_t seed = 17;
    scene.mesh.colors = scene.colors;
    scene.mesh.uvs = scene.uvs;
    scene.material = qtri_material_default();
    scene.material.cull = QTRI_CULL_NONE;
    memset(full, 0xFF, sizeof full);
    scene.texture.texels = full;
    scene.texture.width_log2 = 3;
    scene.texture.height_log2 = 3;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int small = 0;
        const double worst = worst_color(cases[i].pipeline, &seed, random_cases(1500), ANY, &small);
        printf("%d small: colours off by %.3f of a step\n", small, worst);
        assert_true(worst < cases[i].most);
    }
}

/* Steps that are rounded add up over 31 pixels each way. */
TEST(channels_of_565_stay_in_their_fields)
{
    uint64_t seed = 5;
    int small = 0;
    scene.mesh.colors = scene.colors;
    scene.material = qtri_material_default();
    scene.material.cull = QTRI_CULL_NONE;
    assert_true(worst_color(&colored, &seed, random_cases(12000), AT_ENDS, &small) < 1.3);
    assert_true(small > random_cases(12000) / 2);
}

/* Of those that bend by more than a curve over the whole triangle may most are small as well. */
TEST(colors_are_divided_in_steep_perspective)
{
    static const qtri_pipeline *const pipelines[] = {&colored, &xrgb_colors, &gray_colors};
    uint64_t seed = 23;
    scene.mesh.colors = scene.colors;
    scene.material = qtri_material_default();
    scene.material.cull = QTRI_CULL_NONE;
    for (int i = 0; i < 3; i++) {
        int small = 0;
        const double worst = worst_color(pipelines[i], &seed, random_cases(2000), STEEP, &small);
        printf("%d small: steep colours off by %.3f of a step\n", small, worst);
        assert_true(worst < 1.3);
        assert_true(small > random_cases(2000) * 3 / 4);
    }
}

int main(void)
{
    uint64_t seed = 3;
    const qtri_fog_range range = {Q16(1), Q16(100), false};
    const qtri_rgb haze = {0x80, 0x90, 0xA0};
    for (int i = 0; i < TEXELS; i++) {
        scene.texels[i] = (uint32_t)random64(&seed);
    }
    for (int i = 0; i < 256; i++) {
        scene.palette[i].r = (uint8_t)random64(&seed);
        scene.palette[i].g = (uint8_t)i;
    }
    qtri_fog_linear(&scene.fog, haze, range, Q16(2), Q16(60));
    return run_all_tests(NULL, NULL);
}
