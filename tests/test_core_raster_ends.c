/* SPDX-License-Identifier: MIT */
/*
 * Pixels by ways that few pictures take, against the same ones by another: alpha that is full,
 * fog that is none, samples that are all alike, memory without depth or with rows far apart.
 */
#include "support/core.h"

#include "raster/gradient.h"

#include <qtri/blend.h>
#include <qtri/font.h>
#include <qtri/image.h>
#include <qtri/paint.h>
#include <qtri/samples.h>
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
    qtri_surface_clear(&c.surface, sky, 65535);
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
            v[i] = screen_at(x + random_in(&seed, -reach, reach),
                             y + random_in(&seed, -reach, reach));
            v[i].depth_16p16 = (uint32_t)random_in(&seed, 0, 60000) << 16;
            v[i].inv_w_q31 = (uint32_t)random_in(&seed, 1 << 29, INT32_MAX);
            v[i].u_q32 = (int64_t)random_in(&seed, -3000, 3000) << 20;
            v[i].v_q32 = (int64_t)random_in(&seed, -3000, 3000) << 20;
            const int32_t gray = random_in(&seed, 0, 255 << 16);
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = has_colors ? random_in(&seed, 0, 255 << 16) : gray;
            }
        }
        qtri_raster_triangle(s, material, v);
    }
}

/* A lit cube, whose faces are small triangles and large ones. */
static void draw_cube(const qtri_surface *s, const qtri_material *material, double distance)
{
    static const qtri_vec3 positions[8] = {
        {Q16(-1), Q16(-1), Q16(-1)}, {Q16(1), Q16(-1), Q16(-1)}, {Q16(-1), Q16(1), Q16(-1)},
        {Q16(1), Q16(1), Q16(-1)},   {Q16(-1), Q16(-1), Q16(1)}, {Q16(1), Q16(-1), Q16(1)},
        {Q16(-1), Q16(1), Q16(1)},   {Q16(1), Q16(1), Q16(1)}};
    static const qtri_normal normals[8] = {
        {-9459, -9459, -9459}, {9459, -9459, -9459}, {-9459, 9459, -9459}, {9459, 9459, -9459},
        {-9459, -9459, 9459},  {9459, -9459, 9459},  {-9459, 9459, 9459},  {9459, 9459, 9459}};
    static const qtri_vec2 uvs[8] = {{0, 0},      {Q16(1), 0},      {0, Q16(1)}, {Q16(1), Q16(1)},
                                     {Q16(1), 0}, {0, 0},           {Q16(1), Q16(1)},
                                     {0, Q16(1)}};
    static const uint16_t triangles[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                              {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5},
                                              {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}};
    static const qtri_light sun = {{Q16(.3), Q16(.5), Q16(.8)}, Q16(.2), Q16(.8)};
    const qtri_mesh cube = {.positions = positions,
                            .normals = normals,
                            .uvs = uvs,
                            .triangles = triangles,
                            .vertex_count = 8,
                            .triangle_count = 12};
    qtri_vertex vertices[QTRI_MESH_VERTICES(8)];
    qtri_transform pose;
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_perspective(&view.projection, Q16(50), Q16(1.2), Q16(.5), Q16(40));
    view.light = &sun;
    view.vertices = vertices;
    view.vertex_count = LENGTH_OF(vertices);
    qtri_transform_identity(&pose);
    qtri_transform_translate(&pose, vec3_of(.2, .1, -distance));
    qtri_transform_rotate_y(&pose, Q16(33));
    qtri_transform_rotate_x(&pose, Q16(21));
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

static void assert_near_pixels(const canvas *a, const canvas *b, int steps)
{
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const qtri_rgb p = qtri_surface_pixel(&a->surface, i % WIDTH, i / WIDTH);
        const qtri_rgb q = qtri_surface_pixel(&b->surface, i % WIDTH, i / WIDTH);
        if (abs(p.r - q.r) > steps || abs(p.g - q.g) > steps || abs(p.b - q.b) > steps) {
            fail_msg("pixel %d,%d: %d %d %d and %d %d %d", (int)(i % WIDTH), (int)(i / WIDTH), p.r,
                     p.g, p.b, q.r, q.g, q.b);
        }
    }
}

/* ---- Alpha ---- */

/* Texels that are opaque, blended: as those without alpha, lit and not, with fog, through a door. */
static void opaque_texels_are_texels(void **state)
{
    (void)state;
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
            assert_near_pixels(&c[0], &c[1], plain[f]->colors == &qtri_colors_565 ? 9 : 2);
            for (int32_t y = 0; y < HEIGHT; y++) {
                assert_memory_equal(c[0].surface.depth + y * WIDTH, c[1].surface.depth + y * WIDTH,
                                    2 * WIDTH);
            }
            canvas_free(&c[0]);
            canvas_free(&c[1]);
        }
    }
}

/* White with alpha is white, and least_alpha of what has no alpha is nothing. */
static void white_texels_and_none(void **state)
{
    (void)state;
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
static void effects_that_change_nothing(void **state)
{
    (void)state;
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
static void fog_at_the_far_plane(void **state)
{
    (void)state;
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
        qtri_raster_triangle(&c.surface, &material, v);
        for (int32_t i = 0; i < 100; i++) { /* all of it is fog */
            assert_int_equal(stored_pixel(&c.surface, i % 20, i / 20), 0x808080);
        }
        canvas_free(&c);
    }
}

/* ---- Samples ---- */

/* What samples have in common is a pixel: shapes, lines, text, triangles that cover all of it. */
static void samples_that_are_alike(void **state)
{
    (void)state;
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_XRGB8888_X4_BYTES) / 4];
    for (int f = 0; f < 5; f++) {
        for (int n = 0; n < 4; n++) {
            canvas want = new_canvas(plain[f]);
            qtri_surface s;
            assert_int_equal(qtri_surface_init(&s, four[f], WIDTH, HEIGHT, 0, HEIGHT, memory,
                                               sizeof memory),
                             QTRI_OK);
            qtri_samples_clear(&s, sky, 65535);
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
                    qtri_raster_triangle(on[i], &material, v);
                }
                material.blend = NULL;
                material.texture = NULL;
                if (n == 0) {
                    draw_lines(on[i], &material);
                }
                qtri_paint_rect(on[i], &box, &brush);
                const qtri_image image = {xrgb, 4 * SIDE, &qtri_xrgb8888, SIDE, SIDE, true, xrgb[3]};
                (void)qtri_text_paint(on[i], &qtri_font_small, 3, 30, "alike", &brush);
                qtri_image_paint(on[i], &image, 30, 3);
            }
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) { /* read as the pixels that they are */
                const qtri_rgb a = qtri_surface_pixel(&want.surface, i % WIDTH, i / WIDTH);
                const qtri_rgb b = qtri_surface_pixel(&s, i % WIDTH, i / WIDTH);
                assert_memory_equal(&a, &b, sizeof a);
            }
            assert_int_equal(qtri_samples_resolve(&s, &s), QTRI_OK);
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
                assert_int_equal(stored_pixel(&want.surface, i % WIDTH, i / WIDTH),
                                 stored_pixel(&s, i % WIDTH, i / WIDTH));
            }
            canvas_free(&want);
        }
    }
}

/* Read, samples that differ are what resolving makes of them. Depth compares as it is asked. */
static void samples_that_differ(void **state)
{
    (void)state;
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
                assert_int_equal(qtri_surface_init(&s[i], four[f], WIDTH, HEIGHT, 0, HEIGHT,
                                                   memory[i], sizeof memory[i]),
                                 QTRI_OK);
                qtri_samples_clear(&s[i], sky, i == 0 ? 40000 : 25535);
                material.depth_compare = compares[i][n];
                for (int k = 0; k < 20; k++) { /* flat in depth, or the other way round */
                    qtri_screen_vertex v[3];
                    const uint32_t depth = k % 5 == 0 ? 40000 : (uint32_t)random_in(&seed, 0, 65535);
                    for (int j = 0; j < 3; j++) {
                        v[j] = screen_at(random_in(&seed, -2000, 14000),
                                         random_in(&seed, -2000, 12000));
                        v[j].depth_16p16 = (i == 0 ? depth : 65535 - depth) << 16;
                        v[j].color_8p16[k % 3] = random_in(&seed, 0, 255 << 16);
                    }
                    qtri_raster_triangle(&s[i], &material, v);
                }
            }
            const qtri_surface before = s[0];
            static qtri_rgb read[WIDTH * HEIGHT];
            for (int32_t k = 0; k < WIDTH * HEIGHT; k++) {
                read[k] = qtri_surface_pixel(&before, k % WIDTH, k / WIDTH);
            }
            assert_int_equal(qtri_samples_resolve(&s[1], &s[1]), QTRI_OK);
            assert_int_equal(qtri_samples_resolve(&s[0], &out), QTRI_OK);
            for (int32_t k = 0; k < WIDTH * HEIGHT; k++) {
                const qtri_rgb a = qtri_surface_pixel(&out, k % WIDTH, k / WIDTH);
                assert_memory_equal(&a, &read[k], sizeof a);
                assert_int_equal(stored_pixel(&out, k % WIDTH, k / WIDTH),
                                 stored_pixel(&s[1], k % WIDTH, k / WIDTH));
            }
        }
    }
}

/* ---- Strokes ---- */

static void draw_strokes(const qtri_surface *s, qtri_compare compare, uint32_t depth)
{
    for (int n = 0; n < 4; n++) {
        qtri_stroke stroke = qtri_stroke_default();
        qtri_material material = qtri_material_default();
        qtri_screen_vertex v[5];
        uint64_t seed = 19;
        stroke.width = n & 1 ? Q16(4.5) : Q16(1.5);
        stroke.cap = n & 2 ? QTRI_CAP_BUTT : QTRI_CAP_ROUND;
        material.depth_compare = compare;
        for (int i = 0; i < 5; i++) {
            v[i] = screen_at(random_in(&seed, 0, WIDTH * 256), random_in(&seed, 0, HEIGHT * 256));
            v[i].depth_16p16 = depth;
            v[i].color_8p16[n % 3] = 0;
        }
        qtri_raster_polyline(s, &material, &stroke, v, 5);
    }
}

/* Without depth as without a test; beyond the farthest depth as at it. */
static void strokes_without_depth(void **state)
{
    (void)state;
    canvas c[4] = {new_canvas(&qtri_rgb565), new_canvas(&qtri_rgb565), new_canvas(&qtri_rgb565),
                   new_canvas(&qtri_rgb565)};
    qtri_surface without = c[0].surface;
    without.depth = NULL;
    draw_strokes(&without, QTRI_LESS, 1 << 16);
    draw_strokes(&c[1].surface, QTRI_DEPTH_OFF, 1 << 16);
    draw_strokes(&c[2].surface, QTRI_LESS_EQUAL, 65535u << 16);
    draw_strokes(&c[3].surface, QTRI_LESS_EQUAL, UINT32_MAX);
    assert_same_picture(&c[0].surface, &c[1].surface);
    assert_same_picture(&c[2].surface, &c[3].surface);
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        assert_int_equal(stored_pixel(&c[1].surface, i % WIDTH, i / WIDTH),
                         stored_pixel(&c[2].surface, i % WIDTH, i / WIDTH));
    }
    for (int i = 0; i < 4; i++) {
        canvas_free(&c[i]);
    }
}

/* Thin smooth lines of a mesh, in rows that lie far apart or the other way up. */
static void thin_lines_of_any_pitch(void **state)
{
    (void)state;
    enum { FAR = 140000 };
    static uint16_t pixels[FAR / 2 * HEIGHT], depths[FAR / 2 * HEIGHT];
    for (int n = 0; n < 5; n++) {
        canvas want = new_canvas(&qtri_rgb565);
        qtri_surface s = want.surface;
        s.pixels = (uint8_t *)pixels + (n == 1 ? (HEIGHT - 1) * (ptrdiff_t)FAR : 0);
        s.depth = depths + (n == 3 ? (HEIGHT - 1) * (ptrdiff_t)(FAR / 2) : 0);
        s.pitch = n == 0 ? FAR : (n == 1 ? -FAR : 2 * WIDTH);
        s.depth_pitch = n == 2 ? FAR / 2 : (n == 3 ? -FAR / 2 : WIDTH);
        qtri_surface_clear(&s, sky, 65535);
        qtri_stroke stroke = qtri_stroke_default();
        stroke.width = n == 4 ? 0 : Q16(1.5);
        stroke.cap = QTRI_CAP_BUTT;
        const qtri_surface *const on[2] = {&want.surface, &s};
        for (int i = 0; i < 2; i++) {
            static const qtri_vec3 p[3] = {
                {Q16(-1), Q16(-1), 0}, {Q16(1), Q16(-.5), 0}, {Q16(.2), Q16(1), Q16(.5)}};
            static const uint16_t triangle[1][3] = {{0, 1, 2}};
            const qtri_mesh mesh = {
                .positions = p, .triangles = triangle, .vertex_count = 3, .triangle_count = 1};
            qtri_vertex vertices[QTRI_MESH_VERTICES(3)];
            qtri_transform pose;
            qtri_view view;
            qtri_material material = qtri_material_default();
            material.cull = QTRI_CULL_NONE;
            qtri_view_init(&view, WIDTH, HEIGHT);
            view.vertices = vertices;
            view.vertex_count = LENGTH_OF(vertices);
            qtri_transform_identity(&pose);
            qtri_transform_scale(&pose, vec3_of(.8, .8, .8));
            qtri_draw_wide_wireframe(on[i], &view, &pose, &mesh, &stroke, &material);
        }
        for (int32_t y = 0; y < HEIGHT; y++) {
            assert_memory_equal(s.pixels + y * s.pitch, want.surface.pixels + y * 2 * WIDTH,
                                2 * WIDTH);
        }
        canvas_free(&want);
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

/* Texels of one's own that are RGB565 in the end: read by a function, or made so by another. */
static void own_texels_of_565(void **state)
{
    (void)state;
    static uint16_t reversed[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        reversed[i] = rgb565[i] ^ 0xFFFF;
    }
    const qtri_texel_format own[3] = {
        {&qtri_texturing_stages, &qtri_colors_565, 0xFFFF, 0, has_texels, fetch_own, NULL},
        {&qtri_texturing_stages, &qtri_colors_565, 0xFFFF, 2, has_texels, fetch_own, reverse},
        {&qtri_texturing_stages, &qtri_colors_565, 0xFFFF, 0, has_texels, fetch_reversed, NULL}};
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
            assert_same_picture(&want.surface, &c.surface);
            canvas_free(&c);
        }
        canvas_free(&want);
    }
}

/* Sides of more than 1024 texels are taken as 1024. */
static void sides_above_1024(void **state)
{
    (void)state;
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
            assert_same_picture(&c[0].surface, &c[i].surface);
        }
        for (int i = 0; i < 4; i++) {
            canvas_free(&c[i]);
        }
    }
}

/*
 * Levels of one colour each, on a texture of 512 x 256: as of 256 x 256, across twice as often. The
 * larger one's coordinates do not fit half a word, and it is drawn by other stages.
 */
static void levels_of_large_textures(void **state)
{
    (void)state;
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
            qtri_raster_triangle(&c[i].surface, &material, v);
        }
        int other = 0;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            other += stored_pixel(&c[0].surface, i % WIDTH, i / WIDTH) !=
                     stored_pixel(&c[1].surface, i % WIDTH, i / WIDTH);
        }
        assert_in_range(other, 0, WIDTH * HEIGHT / 50); /* where a level begins */
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* ---- Triangles that no scene has ---- */

/* From the whole guard band, of any 1/w, steep and flat: in parts as in one. */
static void extremes_in_parts(void **state)
{
    (void)state;
    uint64_t seed = 77;
    const qtri_texture texture = texture_of(&qtri_texel_rgb565, rgb565);
    for (int n = 0; n < 3000; n++) {
        static const int32_t reaches[5] = {300, 9000, 70000, 1 << 20, QTRI_SCREEN_MAX_24P8};
        const int32_t reach = reaches[n % 5];
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = screen_at(random_in(&seed, -reach, reach), random_in(&seed, -reach, reach));
            v[i].x_24p8 = n % 7 == 0 && i == 2 ? v[0].x_24p8 + random_in(&seed, -9, 9) : v[i].x_24p8;
            v[i].depth_16p16 = (uint32_t)random64(&seed) >> random_in(&seed, 0, 24);
            v[i].inv_w_q31 = n % 3 == 0 ? 1u << random_in(&seed, 0, 31)
                                        : (uint32_t)random64(&seed) >> random_in(&seed, 0, 31);
            v[i].inv_w_q31 |= 1;
            v[i].inv_w_exponent = random_in(&seed, 0, n % 2 == 0 ? 3 : 60);
            v[i].u_q32 = (int64_t)random_any(&seed) << random_in(&seed, 0, 16);
            v[i].v_q32 = (int64_t)random_any(&seed) << random_in(&seed, 0, 16);
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = random_in(&seed, 0, 255 << 16);
            }
            if (n % 4 == 3) { /* at the centre of a pixel, where 1/w is a corner's or none */
                v[i].x_24p8 = random_in(&seed, 0, WIDTH - 1) * 256 + 128;
                v[i].y_24p8 = random_in(&seed, 0, HEIGHT - 1) * 256 + 128;
                v[i].inv_w_q31 = random_flag(&seed) ? 0x80000000u : 1;
                v[i].inv_w_exponent = random_flag(&seed) ? 0 : 40;
            }
        }
        if (n % 8 == 7) { /* level */
            v[1].y_24p8 = v[0].y_24p8;
            v[1].inv_w_q31 = v[0].inv_w_q31;
            v[1].inv_w_exponent = v[0].inv_w_exponent;
        }
        qtri_material material = qtri_material_default();
        material.cull = QTRI_CULL_NONE;
        material.texture = n % 16 != 0 ? &texture : NULL;
        material.depth_compare = QTRI_ALWAYS;
        const qtri_format *const format = plain[n % 6];
        canvas whole = new_canvas(format), parts = new_canvas(format);
        qtri_raster_triangle(&whole.surface, &material, v);
        const int32_t column = random_in(&seed, 1, WIDTH - 1), row = random_in(&seed, 1, HEIGHT - 1);
        for (int part = 0; part < 4; part++) {
            qtri_surface s = parts.surface;
            s.scissor.x0 = part & 1 ? column : 0;
            s.scissor.x1 = part & 1 ? WIDTH : column;
            s.scissor.y0 = part & 2 ? row : 0;
            s.scissor.y1 = part & 2 ? HEIGHT : row;
            qtri_raster_triangle(&s, &material, v);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

/* At the end of the screen's numbers samples cannot be moved: such triangles are not seen. */
static void samples_at_the_end(void **state)
{
    (void)state;
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_X4_BYTES) / 4];
    static uint8_t before[sizeof memory];
    qtri_surface s;
    assert_int_equal(qtri_surface_init(&s, &qtri_rgb565_x4, WIDTH, HEIGHT, 0, HEIGHT, memory,
                                       sizeof memory),
                     QTRI_OK);
    qtri_samples_clear(&s, sky, 65535);
    memcpy(before, memory, sizeof memory);
    const qtri_material material = plain_material();
    const int32_t end = QTRI_SCREEN_MAX_24P8;
    for (int n = 0; n < 4; n++) {
        const int32_t sign = n & 1 ? -1 : 1;
        qtri_screen_vertex v[3] = {screen_at(sign * end, -end), screen_at(sign * (end - 20), 3000),
                                   screen_at(sign * (end - 10), end)};
        for (int i = 0; i < 3 && (n & 2); i++) {
            const int32_t x = v[i].x_24p8;
            v[i].x_24p8 = v[i].y_24p8;
            v[i].y_24p8 = x;
        }
        qtri_raster_triangle(&s, &material, v);
    }
    assert_memory_equal(before, memory, sizeof memory);
}

/* Small triangles that are next to lines, of steep attributes and flat ones. */
static void small_slivers_in_parts(void **state)
{
    (void)state;
    uint64_t seed = 15;
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    int drawn = 0;
    for (int n = 0; n < 4000; n++) {
        const double x = random_in(&seed, 0, WIDTH), y = random_in(&seed, 0, HEIGHT);
        const double dx = random_in(&seed, -8900, 8900) / 256., dy = random_in(&seed, -8900, 8900) / 256.;
        const double part = random_in(&seed, 1, 9) / 10.;
        const double off = random_in(&seed, 1, 12000) / 1000. / (fabs(dx) + fabs(dy) + 1);
        const double at[3][2] = {
            {x, y}, {x + dx, y + dy}, {x + part * dx - off * (dy > 0 ? 1 : -1), y + part * dy + off * (dx > 0 ? 1 : -1)}};
        qtri_vec3 p[3];
        qtri_rgb colors[3];
        for (int i = 0; i < 3; i++) {
            const double z = random_in(&seed, -65536, 65536) / (n & 1 ? 65536. : 900000.);
            p[i] = vec3_of(2 * at[i][0] / WIDTH - 1, 1 - 2 * at[i][1] / HEIGHT, z);
            colors[i] = (qtri_rgb){(uint8_t)random64(&seed), (uint8_t)random64(&seed), 9};
        }
        const qtri_mesh mesh = {.positions = p,
                                .colors = n & 2 ? colors : NULL,
                                .triangles = triangle,
                                .vertex_count = 3,
                                .triangle_count = 1};
        qtri_material material = qtri_material_default();
        qtri_vertex vertices[QTRI_MESH_VERTICES(3)];
        qtri_transform pose;
        qtri_view view;
        material.cull = QTRI_CULL_NONE;
        qtri_view_init(&view, WIDTH, HEIGHT);
        view.vertices = vertices;
        view.vertex_count = LENGTH_OF(vertices);
        qtri_transform_identity(&pose);
        canvas c[2] = {new_canvas(&qtri_rgb565), new_canvas(&qtri_rgb565)};
        qtri_draw_mesh(&c[0].surface, &view, &pose, &mesh, &material);
        for (int k = 0; k < 2; k++) {
            qtri_surface s = c[1].surface;
            s.scissor.y0 = k == 0 ? 0 : 17;
            s.scissor.y1 = k == 0 ? 17 : HEIGHT;
            qtri_draw_mesh(&s, &view, &pose, &mesh, &material);
        }
        assert_same_picture(&c[0].surface, &c[1].surface);
        const double low = 65535 * (fmin(real(p[0].z), fmin(real(p[1].z), real(p[2].z))) + 1) / 2;
        const double high = 65535 * (fmax(real(p[0].z), fmax(real(p[1].z), real(p[2].z))) + 1) / 2;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint16_t depth = stored_depth(&c[0].surface, i % WIDTH, i / WIDTH);
            if (depth != 65535) { /* never far out of the range of its corners */
                assert_true(depth >= low - 40 && depth <= high + 40);
                drawn++;
            }
        }
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
    assert_true(drawn > 2000);
}

/* A comb of more lines in one strip than are told apart: none of them is lost. */
static void more_lines_than_spans(void **state)
{
    (void)state;
    enum { TEETH = 16 };
    qtri_screen_vertex v[2 * TEETH];
    for (int i = 0; i < 2 * TEETH; i++) {
        v[i] = screen_at(512 + i / 2 * 512 + 128, (i + 1) / 2 % 2 == 0 ? -3000 : HEIGHT * 256 + 3000);
        for (int k = 0; k < 3; k++) {
            v[i].color_8p16[k] = 0;
        }
    }
    for (int n = 0; n < 4; n++) {
        qtri_stroke stroke = qtri_stroke_default();
        qtri_material material = qtri_material_default();
        canvas c = new_canvas(&qtri_xrgb8888);
        stroke.width = n % 2 == 0 ? Q16(1) : Q16(.5);
        for (int i = 0; i < TEETH && n == 2; i++) { /* from the right */
            const qtri_screen_vertex other = v[i];
            v[i] = v[2 * TEETH - 1 - i];
            v[2 * TEETH - 1 - i] = other;
        }
        material.depth_compare = QTRI_DEPTH_OFF;
        qtri_raster_polyline(&c.surface, &material, &stroke, v, 2 * TEETH);
        for (int i = 0; i < TEETH; i++) {
            const uint32_t sky888 = (uint32_t)sky.r << 16 | (uint32_t)sky.g << 8 | sky.b;
            assert_true((stored_pixel(&c.surface, 2 + 2 * i, 20) & 255) <= (sky888 & 255) * (1 + n % 2) / 2);
        }
        canvas_free(&c);
    }
}

/* Diagonals of 257 pixels, of all lengths around the one whose slope is rounded up to 1: as seen
   from the other side of the diagonal. */
static void diagonals(void **state)
{
    (void)state;
    enum { PIXELS = 48 };
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    int drawn = 0;
    for (int32_t length = 65790; length < 65840; length++) { /* 1/256 pixel, of 24 to a unit */
        const q16 end = (q16)lrint(length * 65536. / (24 * 256));
        const qtri_vec3 p[3] = {{-32768, 32768, 0}, {end - 32768, 32768 - end, 0}, {0, 0, 0}};
        const qtri_mesh mesh = {
            .positions = p, .triangles = triangle, .vertex_count = 3, .triangle_count = 1};
        qtri_material material = qtri_material_default();
        qtri_stroke stroke = qtri_stroke_default();
        qtri_vertex vertices[QTRI_MESH_VERTICES(3)];
        qtri_transform pose;
        qtri_view view;
        canvas c = canvas_new(&qtri_xrgb8888, PIXELS, PIXELS);
        stroke.cap = QTRI_CAP_BUTT;
        material.cull = QTRI_CULL_NONE;
        qtri_view_init(&view, PIXELS, PIXELS);
        view.vertices = vertices;
        view.vertex_count = LENGTH_OF(vertices);
        qtri_transform_identity(&pose);
        qtri_draw_wide_wireframe(&c.surface, &view, &pose, &mesh, &stroke, &material);
        for (int32_t y = 14; y < PIXELS; y++) { /* behind its end */
            for (int32_t x = 14; x < PIXELS; x++) {
                const int a = (int)(stored_pixel(&c.surface, x, y) & 255);
                const int b = (int)(stored_pixel(&c.surface, y, x) & 255);
                assert_true(abs(a - b) <= 16);
                drawn += a != 0;
            }
        }
        canvas_free(&c);
    }
    assert_true(drawn > 50 * 34);
}

/* Corners on one line in space: what snapping makes of them draws nothing wrong, or nothing. */
static void triangles_that_are_lines(void **state)
{
    (void)state;
    uint64_t seed = 9;
    const qtri_texture texture = texture_of(&qtri_texel_rgb565, rgb565);
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    for (int n = 0; n < 1500; n++) {
        const q16 x = random_in(&seed, -60000, 60000), y = random_in(&seed, -60000, 60000);
        const q16 dx = random_in(&seed, -30000, 30000), dy = random_in(&seed, -30000, 30000);
        const qtri_vec3 p[3] = {{x - dx, y - dy, 0}, {x, y, 0}, {x + dx, y + dy, 0}};
        const qtri_vec2 uv[3] = {{0, 0}, {Q16(3), 0}, {0, Q16(3)}};
        const qtri_mesh mesh = {.positions = p,
                                .uvs = uv,
                                .triangles = triangle,
                                .vertex_count = 3,
                                .triangle_count = 1};
        qtri_material material = qtri_material_default();
        qtri_vertex vertices[QTRI_MESH_VERTICES(3)];
        qtri_transform pose;
        qtri_view view;
        material.cull = QTRI_CULL_NONE;
        material.texture = &texture;
        qtri_view_init(&view, WIDTH, HEIGHT);
        view.vertices = vertices;
        view.vertex_count = LENGTH_OF(vertices);
        qtri_transform_identity(&pose);
        canvas c[2] = {new_canvas(&qtri_rgb565), new_canvas(&qtri_rgb565)};
        qtri_draw_mesh(&c[0].surface, &view, &pose, &mesh, &material);
        for (int part = 0; part < 2; part++) {
            qtri_surface s = c[1].surface;
            s.scissor.y0 = part == 0 ? 0 : 17;
            s.scissor.y1 = part == 0 ? 17 : HEIGHT;
            qtri_draw_mesh(&s, &view, &pose, &mesh, &material);
        }
        assert_same_picture(&c[0].surface, &c[1].surface);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Smooth wireframes on a surface without a format, and where nothing is to be drawn. */
static void smooth_lines_of_nothing(void **state)
{
    (void)state;
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

/* ---- Slopes of slivers ---- */

/* Areas of a few units: the plane is that of exact division, within what gradient.c says of a step. */
static void planes_of_slivers(void **state)
{
    (void)state;
    uint64_t seed = 21;
    int thin = 0;
    while (thin < 3000) {
        qtri_gradient g = {0};
        g.dx1 = random_in(&seed, -32768, 32767);
        g.dy1 = random_in(&seed, -32768, 32767);
        const int32_t part = random_in(&seed, 1, 7);
        g.dx2 = g.dx1 / part + random_in(&seed, -1, 1);
        g.dy2 = g.dy1 / part + random_in(&seed, -1, 1);
        g.area = (int64_t)g.dx1 * g.dy2 - (int64_t)g.dx2 * g.dy1;
        if (g.area == 0 || llabs(g.area) > 200) {
            continue;
        }
        thin++;
        qtri_gradient_init(&g, abs(g.dx1) + abs(g.dy1));
        uint32_t f[3];
        for (int i = 0; i < 3; i++) {
            f[i] = (uint32_t)random64(&seed) >> random_in(&seed, 1, 20);
        }
        qtri_plane plane;
        qtri_plane_init(&plane, &g, f);
        const int128 n = ((int128)f[1] - f[0]) * g.dy2 - ((int128)f[2] - f[0]) * g.dy1;
        const int128 step = floor_div(n * 65536 * 2 + g.area, 2 * (int128)g.area);
        const int64_t off = (int64_t)(plane.dx - ((uint64_t)step << 8));
        assert_true(llabs(off) <= 256 * (2 + 256 / llabs(g.area)));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opaque_texels_are_texels),
        cmocka_unit_test(white_texels_and_none),
        cmocka_unit_test(effects_that_change_nothing),
        cmocka_unit_test(fog_at_the_far_plane),
        cmocka_unit_test(samples_that_are_alike),
        cmocka_unit_test(samples_that_differ),
        cmocka_unit_test(strokes_without_depth),
        cmocka_unit_test(thin_lines_of_any_pitch),
        cmocka_unit_test(own_texels_of_565),
        cmocka_unit_test(sides_above_1024),
        cmocka_unit_test(levels_of_large_textures),
        cmocka_unit_test(extremes_in_parts),
        cmocka_unit_test(samples_at_the_end),
        cmocka_unit_test(triangles_that_are_lines),
        cmocka_unit_test(smooth_lines_of_nothing),
        cmocka_unit_test(small_slivers_in_parts),
        cmocka_unit_test(more_lines_than_spans),
        cmocka_unit_test(diagonals),
        cmocka_unit_test(planes_of_slivers),
    };
    return cmocka_run_group_tests_name("core raster ends", tests, make_texels, NULL);
}
