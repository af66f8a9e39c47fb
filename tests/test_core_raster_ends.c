/* SPDX-License-Identifier: MIT */
/*
 * Pixels by ways that few pictures take, against the same ones by another: alpha that is full,
 * fog that is none, samples that are all alike, texels and levels of any size.
 */
#include "support/cube.h"

#include <qtri/material.h>
#include <qtri/paint.h>
#include <qtri/pipeline_make.h>
#include <qtri/antialias.h>
#include <qtri/stroke.h>

enum { WIDTH = 48, HEIGHT = 40, SIDE = 8 };

static const qtri_rgb sky = {24, 40, 88};
static const qtri_format *const plain[6] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_xrgb8888,
                                            &qtri_rgb888, &qtri_gray8,          &qtri_bgr888};
static const qtri_format *const four[5] = {&qtri_rgb565_x4, &qtri_rgb565_swapped_x4,
                                           &qtri_xrgb8888_x4, &qtri_rgb888_x4, &qtri_gray8_x4};

static uint32_t opaque[SIDE * SIDE], xrgb[SIDE * SIDE];
static uint16_t rgb565[SIDE * SIDE];
static uint8_t alpha8[SIDE * SIDE];

static int make_texels(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int i = 0; i < SIDE * SIDE; i++) {
        xrgb[i] = (uint32_t)random64(&seed) & 0xFFFFFF;
        opaque[i] = xrgb[i] | 0xFF000000u;
        rgb565[i] = (uint16_t)random64(&seed);
        alpha8[i] = 255;
    }
    return 0;
}

static qtri_texture texture_of(const qtri_texel_format *format, const void *texels)
{
    const qtri_texture texture = {
        .format = format, .texels = texels, .width_log2 = 3, .height_log2 = 3};
    return texture;
}

static canvas new_canvas(const qtri_format *format)
{
    canvas c = canvas_new(format, WIDTH, HEIGHT);
    qtri_surface_clear(&c.surface, sky);
    return c;
}

/* A fan of triangles, and many small ones, of one light or of three colours. */
static void draw_triangles(const qtri_surface *s, const qtri_material *material, bool has_colors,
                           uint64_t seed)
{
    for (int n = 0; n < 40; n++) {
        const int32_t reach = n < 4 ? 9000 : 900;
        const int32_t x = random_in(&seed, 0, WIDTH * 256), y = random_in(&seed, 0, HEIGHT * 256);
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] =
                screen_at(x + random_in(&seed, -reach, reach), y + random_in(&seed, -reach, reach));
            v[i].depth_16p16 = (uint32_t)random_in(&seed, 0, 60000) << 16;
            v[i].inv_w_q31 = (uint32_t)random_in(&seed, 1 << 29, INT32_MAX);
            v[i].u_q32 = (int64_t)random_in(&seed, -3000, 3000) * (1 << 20);
            v[i].v_q32 = (int64_t)random_in(&seed, -3000, 3000) * (1 << 20);
            const int32_t gray = random_in(&seed, 0, 255 << 16);
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = has_colors ? random_in(&seed, 0, 255 << 16) : gray;
            }
        }
        qtri_raster_triangle(s, qtri_pipelines_default, material, v);
    }
}

/* A lit cube, whose faces are small triangles and large ones. */
static void draw_cube(const qtri_surface *s, const qtri_material *material, double distance)
{
    const qtri_mesh cube = cube_mesh();
    qtri_vertex vertices[CUBE_VERTICES];
    qtri_transform pose;
    const qtri_view view = cube_view(WIDTH, HEIGHT, distance, vertices, LENGTH_OF(vertices), &pose);
    qtri_draw_mesh(s, &view, &pose, &cube, material);
}

/* Both, in all ways of shading and of light on a texture. */
static void draw_all(const qtri_surface *s, qtri_material material)
{
    for (int n = 0; n < 6; n++) {
        material.shading = shading_of(n % 3);
        material.texture_mode = n < 3 ? QTRI_MODULATE : QTRI_REPLACE;
        const uint8_t less = (uint8_t)(n == 0 ? 255 : 130 + 10 * n); /* white, and colours */
        material.color = (qtri_rgb){255, less, (uint8_t)(n == 0 ? 255 : 200)};
        material.cull = QTRI_CULL_NONE;
        draw_triangles(s, &material, n % 2 == 0, 77 + (uint64_t)n);
        material.cull = QTRI_CULL_BACK;
        draw_cube(s, &material, n & 1 ? 20 : 4);
        draw_cube(s, &material, n & 1 ? 4 : 20);
    }
}

/* ---- Alpha ---- */

/* Texels that are opaque, blended: as those without alpha, lit and not, with fog, through a door.
 */
TEST(opaque_texels_are_texels)
{
    qtri_fog fog;
    const qtri_fog_range range = {Q16(.5), Q16(40), false};
    qtri_fog_linear(&fog, (qtri_rgb){200, 190, 170}, range, Q16(.6), Q16(10));
    for (int f = 0; f < 6; f++) {
        for (int n = 0; n < 8; n++) {
            qtri_texture without = texture_of(&qtri_texel_xrgb8888, xrgb);
            qtri_texture with = texture_of(&qtri_texel_argb8888, opaque);
            canvas c[2] = {new_canvas(plain[f]), new_canvas(plain[f])};
            qtri_material material = qtri_material_default();
            const bool door = (n & 2) != 0;
            material.fog = n & 1 ? &fog : NULL;
            material.alpha = door ? 150 : 255;
            material.blend = door ? &qtri_blend_screen_door : NULL;
            without.filter = with.filter = n & 4 ? &qtri_bilinear : NULL;
            material.texture = &without;
            draw_all(&c[0].surface, material);
            material.blend = door ? &qtri_blend_screen_door : &qtri_blend_alpha;
            material.texture = &with;
            draw_all(&c[1].surface, material);
            /* Mixed as 8 bits a channel, and rounded to the format's once more. */
            assert_close(&c[0].surface, &c[1].surface,
                         plain[f]->colors == &qtri_colors_565 ? 9 : 2);
            for (int32_t y = 0; y < HEIGHT; y++) {
                assert_memory_equal(c[0].surface.depth + y * WIDTH, c[1].surface.depth + y * WIDTH,
                                    2 * WIDTH);
            }
            canvas_free(&c[0]);
            canvas_free(&c[1]);
        }
    }
}

/* What is all key leaves the surface as it was, whatever is done to its pixels. */
TEST(a_key_is_not_drawn)
{
    static uint32_t ones[SIDE * SIDE]; /* opaque, in any format */
    static const qtri_rgb palette[256] = {[255] = {200, 100, 50}};
    static const qtri_texel_format *const keyed[] = {
        &qtri_texel_rgb565,   &qtri_texel_xrgb8888, &qtri_texel_argb4444, &qtri_texel_argb1555,
        &qtri_texel_argb8888, &qtri_texel_alpha8,   &qtri_texel_gray8,    &qtri_texel_palette8};
    static const int bits[] = {16, 24, 16, 16, 32, 8, 8, 8};
    static const qtri_blend *const blends[] = {NULL, &qtri_blend_alpha, &qtri_blend_add,
                                               &qtri_blend_multiply};
    static const uint8_t compares[] = {QTRI_DEPTH_OFF, QTRI_LESS, QTRI_LESS_EQUAL};
    qtri_fog fog;
    const qtri_fog_range range = {Q16(.5), Q16(40), false};
    qtri_fog_linear(&fog, (qtri_rgb){200, 190, 170}, range, Q16(.6), Q16(10));
    memset(ones, 0xFF, sizeof ones);
    for (int n = 0; n < 8 * 4 * 3 * 4; n++) {
        const int format = n % 8, blend = n / 8 % 4, compare = n / 32 % 3, effect = n / 96;
        qtri_texture texture = texture_of(keyed[format], ones);
        texture.has_key = true;
        texture.key = UINT32_MAX >> (32 - bits[format]);
        texture.palette = palette;
        texture.filter = effect & 1 ? &qtri_bilinear : NULL;
        qtri_material material = qtri_material_default();
        material.texture = &texture;
        material.texture_mode = QTRI_REPLACE;
        material.depth_compare = compares[compare];
        material.blend = blends[blend];
        material.fog = effect & 2 ? &fog : NULL;
        for (int f = 0; f < 6; f++) {
            canvas c = new_canvas(plain[f]), empty = new_canvas(plain[f]);
            draw_cube(&c.surface, &material, 4);
            draw_triangles(&c.surface, &material, false, 5);
            assert_int_equal(count_different(&c.surface, &empty.surface), 0);
            canvas_free(&c);
            canvas_free(&empty);
        }
    }
}

/* White with alpha is white, and least_alpha of what has no alpha is nothing. */
TEST(white_texels_and_none)
{
    static uint32_t white[SIDE * SIDE];
    memset(white, 0xFF, sizeof white);
    for (int f = 0; f < 6; f++) {
        for (int n = 0; n < 2; n++) {
            const qtri_texture of[2] = {texture_of(n ? &qtri_texel_rgb565 : &qtri_texel_argb8888,
                                                   n ? (void *)rgb565 : (void *)white),
                                        texture_of(n ? &qtri_texel_rgb565 : &qtri_texel_alpha8,
                                                   n ? (void *)rgb565 : (void *)alpha8)};
            canvas c[2] = {new_canvas(plain[f]), new_canvas(plain[f])};
            for (int i = 0; i < 2; i++) {
                qtri_material material = qtri_material_default();
                material.texture = &of[i];
                material.blend = n ? NULL : &qtri_blend_alpha;
                material.alpha = 200;
                material.least_alpha = n && i ? 99 : 0;
                draw_all(&c[i].surface, material);
            }
            assert_same_picture(&c[0].surface, &c[1].surface);
            canvas_free(&c[0]);
            canvas_free(&c[1]);
        }
    }
}

/* ---- Fog and blends that are not there ---- */

static void draw_lines(const qtri_surface *s, const qtri_material *material)
{
    uint64_t seed = 3;
    for (int n = 0; n < 30; n++) {
        qtri_screen_vertex v[2];
        for (int i = 0; i < 2; i++) {
            v[i] = screen_at(random_in(&seed, -2000, WIDTH * 256 + 2000),
                             random_in(&seed, -2000, HEIGHT * 256 + 2000));
            v[i].depth_16p16 = (uint32_t)random_in(&seed, 0, 60000) << 16;
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = random_in(&seed, 0, 255 << 16);
            }
        }
        qtri_raster_line(s, material, v);
    }
}

/* A fog that was never made is none; a blend that replaces is none either. */
TEST(effects_that_change_nothing)
{
    const qtri_fog none = {0};
    for (int f = 0; f < 6; f++) {
        for (int n = 0; n < 8; n++) {
            canvas c[2] = {new_canvas(plain[f]), new_canvas(plain[f])};
            for (int i = 0; i < 2; i++) {
                qtri_material material = qtri_material_default();
                material.cull = QTRI_CULL_NONE;
                material.depth_read_only = (n & 4) != 0;
                material.fog = i == 1 ? &none : NULL;
                if (i == 1 && (n & 3) == 1) {
                    material.blend = &qtri_blend_replace;
                } else if (i == 1 && (n & 3) >= 2) {
                    material.blend = n & 1 ? &qtri_blend_alpha : &qtri_blend_screen_door;
                    material.alpha = 255;
                }
                draw_triangles(&c[i].surface, &material, true, 5);
                draw_lines(&c[i].surface, &material);
            }
            assert_same_picture(&c[0].surface, &c[1].surface);
            canvas_free(&c[0]);
            canvas_free(&c[1]);
        }
    }
}

/* At the far plane, where depth is a step from the farthest, fog is that of its distance. */
TEST(fog_at_the_far_plane)
{
    qtri_fog fog;
    const qtri_fog_range range = {Q16(.001), Q16(30000), false};
    const qtri_rgb gray = {128, 128, 128};
    for (int n = 0; n < 2; n++) {
        if (n == 0) {
            qtri_fog_exp(&fog, gray, range, Q16(2));
        } else {
            qtri_fog_linear(&fog, gray, range, Q16(.5), Q16(2));
        }
        canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_material material = plain_material();
        material.fog = &fog;
        qtri_screen_vertex v[3] = {screen_at(-3000, -3000), screen_at(-3000, 40000),
                                   screen_at(40000, -3000)};
        for (int i = 0; i < 3; i++) { /* the last 65536 of 2^32 */
            v[i].depth_16p16 = 0xFFFF8000u;
        }
        material.depth_compare = QTRI_ALWAYS;
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &material, v);
        for (int32_t i = 0; i < 100; i++) { /* all of it is fog */
            assert_int_equal(stored_pixel(&c.surface, i % 20, i / 20), 0x808080);
        }
        canvas_free(&c);
    }
}

/* ---- Samples ---- */

/* What samples have in common is a pixel: shapes, lines, text, triangles that cover all of it. */
TEST(samples_that_are_alike)
{
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_XRGB8888_X4_BYTES) / 4];
    for (int f = 0; f < 5; f++) {
        for (int n = 0; n < 4; n++) {
            canvas want = new_canvas(plain[f]);
            qtri_surface s;
            assert_ok(
                qtri_surface_init(&s, four[f], WIDTH, HEIGHT, 0, HEIGHT, memory, sizeof memory));
            qtri_samples_clear(&s, sky);
            qtri_texture texture = texture_of(&qtri_texel_rgb565, rgb565);
            texture.has_key = n == 1;
            texture.key = rgb565[9];
            texture.filter = n == 3 ? &qtri_mipmapped : NULL; /* their first level is drawn */
            const qtri_surface *const on[2] = {&want.surface, &s};
            for (int i = 0; i < 2; i++) {
                qtri_material material = plain_material();
                const qtri_brush brush = qtri_brush_of((qtri_rgb){200, 90, 30});
                const qtri_area box = {300, 500, 5000, 3000};
                qtri_screen_vertex v[3] = {screen_at(-9000, -9000), screen_at(-9000, 60000),
                                           screen_at(60000, -9000)};
                for (int k = 0; k < 3; k++) {
                    v[k].u_q32 = (int64_t)(k == 2 ? 5 : 0) << 32;
                    v[k].v_q32 = (int64_t)(k == 1 ? 5 : 0) << 32;
                    v[k].color_8p16[1] = 99 << 16;
                }
                material.texture = n == 1 || n == 3 ? &texture : NULL;
                material.blend = n == 2 ? &qtri_blend_screen_door : NULL;
                material.alpha = 140;
                if (n > 0) {
                    qtri_raster_triangle(on[i], qtri_pipelines_default, &material, v);
                }
                material.blend = NULL;
                material.texture = NULL;
                if (n == 0) {
                    draw_lines(on[i], &material);
                }
                qtri_paint_rect(on[i], &box, &brush);
                const qtri_image image = {xrgb, 4 * SIDE, &qtri_xrgb8888, SIDE,
                                          SIDE, true,     xrgb[3]};
                (void)qtri_text_paint(on[i], &qtri_font_small, 3, 30, "alike", &brush);
                qtri_image_paint(on[i], &image, 30, 3);
            }
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) { /* read as the pixels that they are */
                const qtri_rgb a = qtri_surface_pixel(&want.surface, i % WIDTH, i / WIDTH);
                const qtri_rgb b = qtri_surface_pixel(&s, i % WIDTH, i / WIDTH);
                assert_memory_equal(&a, &b, sizeof a);
            }
            assert_ok(qtri_samples_resolve(&s, &s));
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
                assert_int_equal(stored_pixel(&want.surface, i % WIDTH, i / WIDTH),
                                 stored_pixel(&s, i % WIDTH, i / WIDTH));
            }
            canvas_free(&want);
        }
    }
}

/* Read, samples that differ are what resolving makes of them. Depth compares as it is asked. */
TEST(samples_that_differ)
{
    static uint32_t memory[2][QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_XRGB8888_X4_BYTES) / 4];
    static const qtri_compare compares[2][4] = {
        {QTRI_LESS, QTRI_LESS_EQUAL, QTRI_EQUAL, QTRI_NOT_EQUAL},
        {QTRI_GREATER, QTRI_GREATER_EQUAL, QTRI_EQUAL, QTRI_NOT_EQUAL}};
    for (int f = 0; f < 5; f++) {
        for (int n = 0; n < 4; n++) {
            qtri_surface s[2];
            qtri_surface out;
            for (int i = 0; i < 2; i++) {
                uint64_t seed = 31;
                qtri_material material = plain_material();
                material.shading = QTRI_SMOOTH;
                assert_ok(qtri_surface_init(&s[i], four[f], WIDTH, HEIGHT, 0, HEIGHT, memory[i],
                                            sizeof memory[i]));
                qtri_samples_clear(&s[i], sky);
                qtri_samples_clear_depth(&s[i], depth_of(i == 0 ? 40000 : 25535));
                material.depth_compare = compares[i][n];
                for (int k = 0; k < 20; k++) { /* flat in depth, or the other way round */
                    qtri_screen_vertex v[3];
                    const uint32_t depth =
                        k % 5 == 0 ? 40000 : (uint32_t)random_in(&seed, 0, 65535);
                    for (int j = 0; j < 3; j++) {
                        v[j] = screen_at(random_in(&seed, -2000, 14000),
                                         random_in(&seed, -2000, 12000));
                        v[j].depth_16p16 = (i == 0 ? depth : 65535 - depth) << 16;
                        v[j].color_8p16[k % 3] = random_in(&seed, 0, 255 << 16);
                    }
                    qtri_raster_triangle(&s[i], qtri_pipelines_default, &material, v);
                }
            }
            const qtri_surface before = s[0];
            static qtri_rgb read[WIDTH * HEIGHT];
            for (int32_t k = 0; k < WIDTH * HEIGHT; k++) {
                read[k] = qtri_surface_pixel(&before, k % WIDTH, k / WIDTH);
            }
            assert_ok(qtri_samples_resolve(&s[1], &s[1]));
            assert_ok(qtri_samples_resolve(&s[0], &out));
            for (int32_t k = 0; k < WIDTH * HEIGHT; k++) {
                const qtri_rgb a = qtri_surface_pixel(&out, k % WIDTH, k / WIDTH);
                assert_memory_equal(&a, &read[k], sizeof a);
                assert_int_equal(stored_pixel(&out, k % WIDTH, k / WIDTH),
                                 stored_pixel(&s[1], k % WIDTH, k / WIDTH));
            }
        }
    }
}

/* ---- Textures ---- */

static bool has_texels(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static void fetch_own(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        texel[i] = ((const uint16_t *)texture->texels)[texel[i]];
    }
}

static void fetch_reversed(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    fetch_own(texel, texture, count);
    for (int32_t i = 0; i < count; i++) {
        texel[i] ^= 0xFFFF;
    }
}

static void reverse(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    for (int32_t i = 0; i < count; i++) {
        texel[i] ^= 0xFFFF;
    }
}

/* Texels of one's own that are RGB565 in the end: read by a function, or made so by another. Their
   colours have 8 bits until they are stored. */
TEST(own_texels_of_565)
{
    static uint16_t reversed[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        reversed[i] = rgb565[i] ^ 0xFFFF;
    }
    const qtri_texel_format own[3] = {
        {&qtri_colors_565, 0xFFFF, has_texels, fetch_own, NULL, 0},
        {&qtri_colors_565, 0xFFFF, has_texels, fetch_own, reverse, 0},
        {&qtri_colors_565, 0xFFFF, has_texels, fetch_reversed, NULL, 0}};
    for (int f = 0; f < 6; f++) {
        canvas want = new_canvas(plain[f]);
        const qtri_texture known = texture_of(&qtri_texel_rgb565, rgb565);
        qtri_material material = qtri_material_default();
        material.texture = &known;
        draw_all(&want.surface, material);
        for (int n = 0; n < 3; n++) {
            canvas c = new_canvas(plain[f]);
            const qtri_texture texture = texture_of(&own[n], n == 0 ? rgb565 : reversed);
            material.texture = &texture;
            draw_all(&c.surface, material);
            assert_close(&want.surface, &c.surface, plain[f]->colors == &qtri_colors_565 ? 9 : 1);
            canvas_free(&c);
        }
        canvas_free(&want);
    }
}

static int fetched;

static uint32_t fetch_counted(const qtri_texture *texture, uint32_t number)
{
    fetched++;
    return ((const uint16_t *)texture->texels)[number];
}

static const qtri_texel_format counted = {&qtri_colors_565, 0xFFFF, has_texels, fetch_own, NULL, 0};

QTRI_PIPELINE(counting, .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_ANY,
              .texel = QTRI_OTHER_TEXEL, .own_texel = &counted, .fetch = fetch_counted)

/* A format that reads the same texels is another one. */
TEST(a_pipeline_draws_its_own_texels_alone)
{
    static const qtri_pipeline *const list[] = {&counting, &qtri_pipeline_any, NULL};
    const qtri_texel_format same = counted;
    for (int n = 0; n < 2; n++) {
        canvas c = new_canvas(&qtri_rgb565);
        const qtri_texture texture = texture_of(n == 0 ? &counted : &same, rgb565);
        qtri_material material = qtri_material_default();
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = screen_at(i == 1 ? 9000 : 300, i == 2 ? 9000 : 300);
            v[i].depth_16p16 = (uint32_t)1 << 30;
        }
        material.texture = &texture;
        material.texture_mode = QTRI_REPLACE;
        material.cull = QTRI_CULL_NONE;
        fetched = 0;
        qtri_raster_triangle(&c.surface, list, &material, v);
        assert_true(stored_pixel(&c.surface, 3, 3) != stored_pixel(&c.surface, WIDTH - 1, 3));
        assert_int_equal(fetched > 0, n == 0);
        canvas_free(&c);
    }
}

/* Sides of more than 1024 texels are taken as 1024; where two texels meet, either. */
TEST(sides_above_1024)
{
    static uint16_t tall[4 * 1024];
    static const uint8_t log2s[4] = {10, 11, 16, 255};
    for (int i = 0; i < 4 * 1024; i++) {
        tall[i] = (uint16_t)(i * 77);
    }
    for (int side = 0; side < 2; side++) {
        canvas c[4];
        for (int i = 0; i < 4; i++) {
            const qtri_texture texture = {.format = &qtri_texel_rgb565,
                                          .texels = tall,
                                          .width_log2 = side == 0 ? 2 : log2s[i],
                                          .height_log2 = side == 0 ? log2s[i] : 2};
            qtri_material material = qtri_material_default();
            c[i] = new_canvas(&qtri_rgb565);
            material.texture = &texture;
            draw_all(&c[i].surface, material);
            int other = 0;
            other += count_different(&c[0].surface, &c[i].surface);
            assert_in_range(other, 0, WIDTH * HEIGHT / 50);
        }
        for (int i = 0; i < 4; i++) {
            canvas_free(&c[i]);
        }
    }
}

/*
 * Levels of one colour each, on a texture of 512 x 256: as of 256 x 256, across twice as often. The
 * larger one has more than 2^16 texels, and so the option large_texture.
 */
TEST(levels_of_large_textures)
{
    static uint16_t level0[2][512 * 256], texels[2][9][512 * 256 / 4];
    const void *levels[2][9];
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 512 * 256; k++) {
            level0[i][k] = 0xF81F;
        }
        for (int n = 0; n < 9; n++) {
            for (int k = 0; k < 512 * 256 / 4; k++) {
                texels[i][n][k] = (uint16_t)(0x1111 * (n + 2));
            }
            levels[i][n] = texels[i][n];
        }
    }
    for (int n = 0; n < 8; n++) {
        canvas c[2];
        for (int i = 0; i < 2; i++) {
            qtri_texture texture = texture_of(&qtri_texel_rgb565, level0[i]);
            texture.width_log2 = i == 0 ? 9 : 8;
            texture.height_log2 = 8;
            texture.levels = levels[i];
            texture.level_count = 7;
            texture.filter = n & 1 ? &qtri_mipmapped_bilinear : &qtri_mipmapped;
            qtri_material material = plain_material();
            material.texture = &texture;
            c[i] = new_canvas(n & 4 ? &qtri_xrgb8888 : &qtri_rgb565);
            /* A floor, or a wall that is seen straight, from near to far. */
            qtri_screen_vertex v[3] = {screen_at(-6000, 200), screen_at(90000, 200),
                                       screen_at(-6000, 30000)};
            for (int k = 0; k < 3; k++) {
                const int64_t unit = (int64_t)40 << 32;
                v[k].inv_w_q31 = k < 2 && (n & 2) ? 0x04000000u : 0x80000000u;
                v[k].u_q32 = k == 1 ? unit << (i == 1 ? 1 : 0) : 0;
                v[k].v_q32 = k == 2 ? unit : 0;
            }
            qtri_raster_triangle(&c[i].surface, qtri_pipelines_default, &material, v);
        }
        int other = 0;
        other += count_different(&c[0].surface, &c[1].surface);
        assert_in_range(other, 0, WIDTH * HEIGHT / 50); /* where a level begins */
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Smooth wireframes on a surface without a format, and where nothing is to be drawn. */
TEST(smooth_lines_of_nothing)
{
    canvas c = new_canvas(&qtri_rgb565), empty = new_canvas(&qtri_rgb565);
    qtri_material material = qtri_material_default();
    material.fill = &qtri_smooth_wireframe;
    for (int n = 0; n < 2; n++) {
        qtri_surface none = c.surface;
        none.format = n == 0 ? NULL : none.format;
        none.scissor.x1 = n == 1 ? 0 : none.scissor.x1;
        for (int distance = 1; distance < 9; distance++) { /* through the near plane, too */
            draw_cube(&none, &material, distance);
        }
    }
    assert_same_picture(&empty.surface, &c.surface);
    canvas_free(&c);
    canvas_free(&empty);
}

int main(void)
{
    return run_all_tests(make_texels, NULL);
}
