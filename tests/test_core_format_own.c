/* SPDX-License-Identifier: MIT */
/*
 * Formats of an application's own: the library's colours in pixels of another size, which no loop
 * for a known format may take for its own. Pictures are those of the library's format.
 */
#include "support/cube.h"

#include <qtri/material.h>
#include <qtri/dither.h>
#include <qtri/antialias.h>
#include <qtri/paint.h>
#include <qtri/pipeline_make.h>
#include <qtri/stroke.h>

enum { WIDTH = 44, HEIGHT = 40, SIDE = 16 };

static const qtri_rgb sky = {24, 40, 88}, red = {224, 24, 16}, sand = {200, 180, 90};

static const qtri_format *const known[5] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_gray8,
                                            &qtri_xrgb8888, &qtri_rgb888};

/* The same stored pixels in the next size, of three bytes in four and of four in three. */
static qtri_format other_size(const qtri_format *of)
{
    static const qtri_pixels *const next[5] = {NULL, &qtri_pixels_16, &qtri_pixels_32,
                                               &qtri_pixels_32, &qtri_pixels_24};
    qtri_format own = *of;
    own.pixels = next[of->pixels->bytes];
    own.kind = QTRI_OTHER_FORMAT;
    return own;
}

static uint16_t texels[SIDE * SIDE];

static void make_texels(void)
{
    uint64_t seed = 5;
    for (int i = 0; i < SIDE * SIDE; i++) {
        texels[i] = (uint16_t)random64(&seed);
    }
}

static void draw_cube(const qtri_surface *s, qtri_material material)
{
    qtri_mesh cube = cube_mesh();
    qtri_vertex vertices[CUBE_VERTICES];
    qtri_transform pose;
    const qtri_view view = cube_view(WIDTH, HEIGHT, 5, vertices, LENGTH_OF(vertices), &pose);
    cube.normals = NULL;
    qtri_draw_mesh(s, &view, &pose, &cube, &material);
}

/* What is stored and not mixed: triangles in all ways of shading, lines, shapes and text. */
static void draw_here(const qtri_surface *s)
{
    const qtri_texture texture = {
        .format = &qtri_texel_rgb565, .texels = texels, .width_log2 = 4, .height_log2 = 4};
    const qtri_brush solid = qtri_brush_of(sand);
    const qtri_area box = {QTRI_PX(2), QTRI_PX(2), QTRI_PX(17), QTRI_PX(9)};
    qtri_material material = qtri_material_default();
    qtri_surface_clear(s, sky);
    material.color = red;
    draw_cube(s, material);
    material.shading = QTRI_FLAT_LAST;
    material.depth_compare = QTRI_LESS_EQUAL;
    material.texture = &texture;
    draw_cube(s, material);
    material.texture_mode = QTRI_MODULATE;
    material.shading = QTRI_SMOOTH;
    material.depth_bias = -Q16(.01);
    draw_cube(s, material);
    material.fill = &qtri_wireframe;
    material.texture = NULL;
    material.color = sand;
    material.depth_bias = -Q16(.02);
    draw_cube(s, material);
    material.fill = NULL; /* a floor, whose rows have one distance */
    material.texture = &texture;
    material.texture_mode = QTRI_REPLACE;
    material.depth_compare = QTRI_LESS;
    material.cull = QTRI_CULL_NONE;
    qtri_screen_vertex floor[3] = {screen_at(-5000, 7000), screen_at(30000, 7000),
                                   screen_at(5000, 20000)};
    for (int i = 0; i < 3; i++) {
        floor[i].depth_16p16 = (uint32_t)(i < 2 ? 65000 : 60000) << 16;
        floor[i].inv_w_q31 = i < 2 ? 0x10000000u : 0x80000000u;
        floor[i].u_q32 = (int64_t)(i == 1 ? 9 : 0) << 32;
        floor[i].v_q32 = (int64_t)(i == 2 ? 9 : 0) << 32;
    }
    qtri_raster_triangle(s, qtri_pipelines_default, &material, floor);
    qtri_paint_rect(s, &box, &solid);
    (void)qtri_text_paint(s, &qtri_font_small, 3, 38, "own: 42", &solid);
}

static void copy(const qtri_surface *to, const qtri_surface *from)
{
    const qtri_image image = qtri_image_of(from);
    qtri_image_paint(to, &image, 0, 0);
}

/* That picture in a format of one's own: of the library's that is stored alike, converted. */
static void draw_stored(const qtri_surface *s)
{
    const qtri_format *twin = &qtri_rgb565;
    if (s->format->kind != QTRI_OTHER_FORMAT) {
        draw_here(s);
        return;
    }
    for (size_t f = 0; f < LENGTH_OF(known); f++) {
        twin = s->format->decode == known[f]->decode ? known[f] : twin;
    }
    canvas c = canvas_new(twin, WIDTH, HEIGHT);
    draw_here(&c.surface);
    copy(s, &c.surface);
    canvas_free(&c);
}

static void blend_cubes(const qtri_surface *s)
{
    static const qtri_blend *const blends[3] = {&qtri_blend_alpha, &qtri_blend_add,
                                                &qtri_blend_multiply};
    for (int i = 0; i < 3; i++) {
        qtri_material material = qtri_material_default();
        material.color = sand;
        material.blend = blends[i];
        material.alpha = (uint8_t)(90 + 60 * i);
        material.depth_bias = -Q16(.01) * (i + 1);
        draw_cube(s, material);
    }
}

static void assert_same_stored(const qtri_surface *a, const qtri_surface *b, uint32_t mask)
{
    for (int32_t y = a->first_row; y < a->first_row + a->rows; y++) {
        for (int32_t x = 0; x < a->width; x++) {
            const uint32_t of_a = a->format->pixels->load(
                a->pixels + (y - a->first_row) * a->pitch + a->format->pixels->bytes * x);
            const uint32_t of_b = b->format->pixels->load(
                b->pixels + (y - b->first_row) * b->pitch + b->format->pixels->bytes * x);
            if ((of_a ^ of_b) & mask) {
                fail_msg("pixel %d,%d: %x and %x", (int)x, (int)y, (unsigned)of_a, (unsigned)of_b);
            }
        }
    }
}

/* Colours have 8 bits until they are stored: within a step of the format, two with three blends. */
TEST(drawing_is_a_step_off)
{
    make_texels();
    for (size_t f = 0; f < LENGTH_OF(known); f++) {
        const qtri_format own = other_size(known[f]);
        const int step = known[f]->colors == &qtri_colors_565 ? 9 : 1; /* of 255 */
        canvas a = canvas_new(known[f], WIDTH, HEIGHT);
        canvas b = canvas_new(&own, WIDTH, HEIGHT);
        draw_here(&a.surface);
        draw_here(&b.surface);
        assert_close(&a.surface, &b.surface, step);
        blend_cubes(&a.surface);
        blend_cubes(&b.surface);
        assert_close(&a.surface, &b.surface, 2 * step);
        canvas_free(&a);
        canvas_free(&b);
    }
}

TEST(another_size_has_the_same_picture)
{
    make_texels();
    for (size_t f = 0; f < LENGTH_OF(known); f++) {
        const qtri_format own = other_size(known[f]);
        canvas a = canvas_new(known[f], WIDTH, HEIGHT);
        canvas b = canvas_new(&own, WIDTH, HEIGHT);
        draw_stored(&a.surface);
        draw_stored(&b.surface);
        assert_same_stored(&a.surface, &b.surface, 0x00FFFFFF);
        /* Read, as gray and as colours. */
        for (int32_t y = 0; y < HEIGHT; y++) {
            uint8_t gray[2][WIDTH];
            qtri_surface_gray(&a.surface, 0, y, WIDTH, gray[0]);
            qtri_surface_gray(&b.surface, 0, y, WIDTH, gray[1]);
            assert_memory_equal(gray[0], gray[1], WIDTH);
        }
        canvas_free(&a);
        canvas_free(&b);
    }
}

/* Mixed in steps of 8 bits and stored again: a step of the format off where they are coarse. */
TEST(mixes_are_a_step_off)
{
    static const qtri_ink *const inks[2] = {&qtri_ink_blend, &qtri_ink_smooth};
    for (size_t f = 0; f < LENGTH_OF(known); f++) {
        const qtri_format own = other_size(known[f]);
        const int steps = known[f]->colors == &qtri_colors_565 ? 9 : 1; /* of 255 */
        for (int n = 0; n < 2; n++) {
            canvas c[2] = {canvas_new(known[f], WIDTH, HEIGHT), canvas_new(&own, WIDTH, HEIGHT)};
            for (int i = 0; i < 2; i++) {
                const qtri_brush brush = {red, 150, inks[n]};
                const qtri_point center = {QTRI_PX(20), QTRI_PX(17.3)};
                const qtri_area box = {300, 400, QTRI_PX(30.4), QTRI_PX(12.7)};
                qtri_surface_clear(&c[i].surface, sky);
                qtri_paint_circle(&c[i].surface, &center, QTRI_PX(13.6), &brush);
                qtri_paint_rect(&c[i].surface, &box, &brush);
                (void)qtri_text_paint(&c[i].surface, &qtri_font_small, 2, 36, "mixed", &brush);
            }
            for (int32_t y = 0; y < HEIGHT; y++) {
                for (int32_t x = 0; x < WIDTH; x++) {
                    const qtri_rgb a = qtri_surface_pixel(&c[0].surface, x, y);
                    const qtri_rgb b = qtri_surface_pixel(&c[1].surface, x, y);
                    assert_true(abs(a.r - b.r) <= steps && abs(a.g - b.g) <= steps &&
                                abs(a.b - b.b) <= steps);
                }
            }
            canvas_free(&c[0]);
            canvas_free(&c[1]);
        }
    }
}

/* Pictures of one's own formats, and onto them: with a key, and without. */
TEST(pictures_are_converted)
{
    make_texels();
    for (size_t f = 0; f < LENGTH_OF(known); f++) {
        const qtri_format own = other_size(known[f]);
        const qtri_format alike = {
            known[f]->pixels, known[f]->colors, known[f]->encode, known[f]->decode, NULL, 0};
        const qtri_format *const of[3] = {known[f], &own, &alike};
        canvas from = canvas_new(known[f], WIDTH, HEIGHT);
        draw_stored(&from.surface);
        canvas want = canvas_new(known[f], WIDTH, HEIGHT);
        clear_to(&want.surface, red, 0);
        qtri_image image = qtri_image_of(&from.surface);
        image.has_key = true;
        image.key = from.surface.format->pixels->load(from.surface.pixels);
        qtri_image_paint(&want.surface, &image, 3, 2);
        for (int n = 0; n < 3; n++) {
            canvas source = canvas_new(of[n], WIDTH, HEIGHT);
            draw_stored(&source.surface);
            qtri_image picture = qtri_image_of(&source.surface);
            picture.has_key = true;
            picture.key = image.key;
            for (int k = 0; k < 3; k++) {
                canvas to = canvas_new(of[k], WIDTH, HEIGHT);
                clear_to(&to.surface, red, 0);
                qtri_image_paint(&to.surface, &picture, 3, 2);
                assert_same_stored(&want.surface, &to.surface, 0x00FFFFFF);
                /* Mixed with itself it stays, within a step. */
                qtri_image_blend(&to.surface, &picture, 3, 2, 130);
                for (int32_t x = 0; x < WIDTH; x++) {
                    const qtri_rgb a = qtri_surface_pixel(&want.surface, x, 20);
                    const qtri_rgb b = qtri_surface_pixel(&to.surface, x, 20);
                    assert_true(abs(a.r - b.r) <= 9 && abs(a.g - b.g) <= 9 && abs(a.b - b.b) <= 9);
                }
                canvas_free(&to);
            }
            canvas_free(&source);
        }
        canvas_free(&from);
        canvas_free(&want);
    }
}

/* Means of samples and of frames, and smoothed edges: as of the library's format. */
TEST(filters_are_the_same)
{
    static uint32_t words[QTRI_SUM_WORDS(WIDTH, HEIGHT) + QTRI_FXAA_WORDS(WIDTH)];
    make_texels();
    for (size_t f = 0; f < LENGTH_OF(known); f++) {
        const qtri_format own = other_size(known[f]);
        canvas c[2] = {canvas_new(known[f], WIDTH, HEIGHT), canvas_new(&own, WIDTH, HEIGHT)};
        qtri_surface half[2];
        for (int i = 0; i < 2; i++) {
            qtri_sum_clear(words, LENGTH_OF(words));
            draw_stored(&c[i].surface);
            assert_ok(qtri_fxaa(&c[i].surface, words, LENGTH_OF(words)));
            qtri_sum_clear(words, LENGTH_OF(words));
            assert_ok(qtri_sum_add(words, LENGTH_OF(words), &c[i].surface));
            assert_ok(qtri_sum_add(words, LENGTH_OF(words), &c[i].surface));
            clear_to(&c[i].surface, sky, 0);
            assert_ok(qtri_sum_store(&c[i].surface, words, LENGTH_OF(words), 1));
        }
        assert_same_stored(&c[0].surface, &c[1].surface, 0x00FFFFFF);
        assert_ok(qtri_halve(&c[0].surface, &half[0]));
        assert_ok(qtri_halve(&c[1].surface, &half[1]));
        assert_same_stored(&half[0], &half[1], 0x00FFFFFF);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* ---- Other meanings in the same size ---- */

/* Red and blue exchanged: colours of 565 that are not stored as they are. */
static void encode_bgr565(uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        color[i] = color[i] >> 11 | (color[i] & 0x07E0) | (color[i] & 31) << 11;
    }
}

static uint32_t decode_bgr565(uint32_t stored)
{
    encode_bgr565(&stored, 1);
    return qtri_decode_rgb565(stored);
}

static const qtri_format bgr565 = {
    &qtri_pixels_16, &qtri_colors_565, encode_bgr565, decode_bgr565, NULL, 0};

TEST(exchanged_channels_have_the_same_picture)
{
    make_texels();
    canvas a = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas b = canvas_new(&bgr565, WIDTH, HEIGHT);
    draw_stored(&a.surface);
    draw_stored(&b.surface);
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            uint32_t is = stored_pixel(&b.surface, x, y);
            encode_bgr565(&is, 1);
            assert_int_equal(is, stored_pixel(&a.surface, x, y));
        }
    }
    draw_here(&b.surface);
    assert_close(&a.surface, &b.surface, 9);
    /* Decoded alike, encoded otherwise: no picture may be copied from one to the other. */
    const qtri_format odd = {
        &qtri_pixels_16, &qtri_colors_565, encode_bgr565, qtri_decode_rgb565, NULL, 0};
    canvas c = canvas_new(&odd, WIDTH, HEIGHT);
    const qtri_image image = qtri_image_of(&a.surface);
    qtri_image_paint(&c.surface, &image, 0, 0);
    for (int32_t x = 0; x < WIDTH; x++) {
        uint32_t is = stored_pixel(&c.surface, x, 20);
        encode_bgr565(&is, 1);
        assert_int_equal(is, stored_pixel(&a.surface, x, 20));
    }
    canvas_free(&a);
    canvas_free(&b);
    canvas_free(&c);
}

/* ---- A pipeline of one's own ---- */

static int encoded;

static uint32_t encode_counted(uint32_t color)
{
    uint32_t stored = qtri_pixel_888_to_565(color);
    encode_bgr565(&stored, 1);
    encoded++;
    return stored;
}

QTRI_PIPELINE(bgr565_flat, .format = QTRI_OTHER_FORMAT, .pixel_bytes = 2, .own_format = &bgr565,
              .encode = encode_counted, .depth = QTRI_LINEAR16, .compare = QTRI_LESS)

/* How often the pipeline has stored a colour. */
static int draw_by_own(const qtri_surface *s)
{
    const qtri_pipeline *const list[] = {&bgr565_flat, &qtri_pipeline_any, NULL};
    const qtri_material material = qtri_material_default();
    qtri_mesh cube = cube_mesh();
    qtri_vertex vertices[CUBE_VERTICES];
    qtri_transform pose;
    qtri_view view = cube_view(WIDTH, HEIGHT, 5, vertices, LENGTH_OF(vertices), &pose);
    view.pipelines = list;
    view.light = NULL;
    cube.colors = NULL;
    encoded = 0;
    qtri_surface_clear(s, sky);
    qtri_draw_mesh(s, &view, &pose, &cube, &material);
    return encoded;
}

/* A format with the same colours in pixels of the same size is another one. */
TEST(a_pipeline_draws_on_its_own_format_alone)
{
    const qtri_format same = bgr565;
    const qtri_format wide = other_size(&bgr565);
    canvas a = canvas_new(&bgr565, WIDTH, HEIGHT);
    canvas b = canvas_new(&same, WIDTH, HEIGHT);
    canvas c = canvas_new(&wide, WIDTH, HEIGHT);
    assert_true(draw_by_own(&a.surface) > 0);
    assert_int_equal(draw_by_own(&b.surface), 0);
    assert_int_equal(draw_by_own(&c.surface), 0);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const uint32_t is = stored_pixel(&a.surface, i % WIDTH, i / WIDTH);
        assert_int_equal(stored_pixel(&b.surface, i % WIDTH, i / WIDTH), is);
        assert_int_equal(stored_pixel(&c.surface, i % WIDTH, i / WIDTH), is);
    }
    canvas_free(&a);
    canvas_free(&b);
    canvas_free(&c);
}

/* Colours of 565 in a byte: what is stored is that of RGB565, encoded. */
static void encode_332(uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        color[i] = (color[i] >> 8 & 0xE0) | (color[i] >> 6 & 0x1C) | (color[i] >> 3 & 3);
    }
}

static uint32_t decode_332(uint32_t stored)
{
    return qtri_decode_rgb565((stored & 0xE0) << 8 | (stored & 0x1C) << 6 | (stored & 3) << 3);
}

TEST(a_byte_of_565)
{
    static const qtri_format rgb332 = {
        &qtri_pixels_8, &qtri_colors_565, encode_332, decode_332, NULL, 0};
    make_texels();
    canvas a = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas b = canvas_new(&rgb332, WIDTH, HEIGHT);
    draw_stored(&a.surface);
    draw_stored(&b.surface);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        uint32_t want = stored_pixel(&a.surface, i % WIDTH, i / WIDTH);
        encode_332(&want, 1);
        assert_int_equal(stored_pixel(&b.surface, i % WIDTH, i / WIDTH), want);
    }
    canvas_free(&a);
    canvas_free(&b);
}

/* On depth alone nothing is painted: there are no pixels. */
TEST(depth_alone_has_no_pixels)
{
    static uint8_t before[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_BYTES)];
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas all = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    draw_stored(&all.surface);
    memset(c.surface.pixels, 0x5A, (size_t)c.surface.pitch * HEIGHT);
    memcpy(before, c.surface.pixels, (size_t)c.surface.pitch * HEIGHT);
    qtri_surface depth = c.surface;
    depth.format = &qtri_depth_only;
    draw_stored(&depth);
    blend_cubes(&depth);
    const qtri_brush brushes[3] = {
        qtri_brush_of(red), {red, 99, &qtri_ink_blend}, {red, 200, &qtri_ink_smooth}};
    const qtri_area box = {300, 400, QTRI_PX(30.4), QTRI_PX(12.7)};
    const qtri_point center = {QTRI_PX(20), QTRI_PX(17.3)};
    const qtri_image image = qtri_image_of(&all.surface);
    const qtri_image none = qtri_image_of(&depth);
    for (int i = 0; i < 3; i++) {
        qtri_paint_rect(&depth, &box, &brushes[i]);
        qtri_paint_circle(&depth, &center, QTRI_PX(9), &brushes[i]);
        (void)qtri_text_paint(&depth, &qtri_font_small, 2, 36, "none", &brushes[i]);
    }
    qtri_image_paint(&depth, &image, 1, 1);
    qtri_image_paint(&depth, &none, 1, 1);
    assert_memory_equal(before, c.surface.pixels, sizeof(uint16_t) * WIDTH * HEIGHT);
    const qtri_rgb black = qtri_surface_pixel(&depth, 3, 3);
    assert_int_equal(black.r | black.g | black.b, 0);
    /* Depths are those of the picture. */
    blend_cubes(&all.surface);
    for (int32_t y = 0; y < HEIGHT; y++) {
        assert_memory_equal(c.surface.depth + y * c.surface.depth_pitch,
                            all.surface.depth + y * all.surface.depth_pitch,
                            WIDTH * sizeof(uint16_t));
    }
    canvas_free(&c);
    canvas_free(&all);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
