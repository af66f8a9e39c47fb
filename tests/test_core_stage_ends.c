/* SPDX-License-Identifier: MIT */
/*
 * Ends of what becomes of pixels: formats of depth where there is none, comparisons that are
 * none, samples that only test, fog that is none, alpha of vertices at one distance.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "raster/samples.h"

#include <qtri/material.h>
#include <qtri/format.h>
#include <qtri/antialias.h>
#include <qtri/stroke.h>

enum { WIDTH = 64, HEIGHT = 48 };

static const qtri_rgb sky = {24, 32, 48};
static qtri_vec3 positions[QTRI_SPHERE_VERTICES(10, 6)];
static qtri_normal normals[LENGTH_OF(positions)];
static qtri_vec2 uvs[LENGTH_OF(positions)];
static uint16_t triangles[QTRI_SPHERE_TRIANGLES(10, 6)][3];
static qtri_mesh ball;

static int set_up(void **state)
{
    (void)state;
    const qtri_shape_memory memory = {
        positions, normals, uvs, triangles, LENGTH_OF(positions), LENGTH_OF(triangles)};
    return qtri_shape_sphere(&ball, &memory, Q16(1), 10, 6) == QTRI_OK ? 0 : -1;
}

/* A surface of up to 32 bytes a pixel. */
typedef struct board {
    qtri_surface surface;
    uint32_t memory[WIDTH * HEIGHT * 8 + 8];
} board;

static void board_init(board *b, const qtri_format *format, const qtri_depth_format *depth)
{
    memset(b, 0, sizeof *b);
    assert_ok(surface_with_depth(&b->surface, format, depth, WIDTH, HEIGHT, 0, HEIGHT, b->memory,
                                 sizeof b->memory));
    if (format == &qtri_rgb565_x4) {
        qtri_samples_clear(&b->surface, sky);
    } else {
        qtri_surface_clear(&b->surface, sky);
    }
}

static void assert_same_memory(const board *a, const board *b)
{
    assert_memory_equal(a->memory, b->memory, sizeof a->memory);
}

static void draw_mesh(const qtri_surface *surface, const qtri_material *material,
                      const qtri_mesh *mesh, double distance)
{
    qtri_vertex vertices[LENGTH_OF(positions)];
    qtri_transform pose;
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(1.33), Q16(.5), Q16(20));
    give_vertices(&view, vertices, LENGTH_OF(vertices));
    qtri_transform_identity(&pose);
    qtri_transform_translate(&pose, vec3_of(0, 0, -distance));
    qtri_draw_mesh(surface, &view, &pose, mesh, material);
}

static void draw_ball(const qtri_surface *surface, const qtri_material *material)
{
    draw_mesh(surface, material, &ball, 3);
}

static void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, int32_t reach)
{
    for (int i = 0; i < 3; i++) {
        v[i] = screen_at(random_in(seed, -reach, reach) + WIDTH * 128,
                         random_in(seed, -reach, reach) + HEIGHT * 128);
        v[i].depth_16p16 = (uint32_t)random64(seed);
        for (int k = 0; k < 3; k++) {
            v[i].color_8p16[k] = random_in(seed, 0, 255 << 16);
        }
    }
}

/* ---- Depth ---- */

/* Depths of one byte or five are of no format that can be stored. */
TEST(formats_that_do_not_fit)
{
    static uint8_t memory[QTRI_FRAME_BYTES_DEPTH(WIDTH, 8 + 2 * 2, QTRI_RGB565_BYTES, 4)];
    for (uint8_t bytes = 1; bytes <= 5; bytes++) {
        qtri_depth_format own = qtri_depth_linear32;
        qtri_surface s;
        own.bytes = bytes;
        assert_int_equal(
            surface_with_depth(&s, &qtri_rgb565, &own, WIDTH, 8, 0, 8, memory, sizeof memory),
            bytes < 2 || bytes > 4 ? QTRI_ERROR_FORMAT : QTRI_OK);
        assert_true((s.pixels != NULL) == (bytes >= 2 && bytes <= 4));
    }
    qtri_surface none;
    assert_int_equal(qtri_surface_init(&none, NULL, WIDTH, 8, 0, 8, memory, sizeof memory),
                     QTRI_ERROR_FORMAT);
    assert_int_equal(qtri_surface_set_depth(&none, &qtri_depth_linear32, sizeof memory),
                     QTRI_ERROR_FORMAT);
    static const struct {
        int32_t rows;
        size_t bytes;
        enum qtri_error error;
    } tries[] = {{8, sizeof memory, QTRI_OK},
                 {0, sizeof memory, QTRI_ERROR_SIZE},
                 {8, QTRI_FRAME_BYTES(WIDTH, 8 + 2 * 2, QTRI_RGB565_BYTES), QTRI_ERROR_MEMORY}};
    for (size_t i = 0; i < LENGTH_OF(tries); i++) {
        qtri_frame frame;
        qtri_surface band, shown;
        (void)frame_with_overlap(&frame, &qtri_rgb565, WIDTH, HEIGHT, tries[i].rows, 2, memory,
                                 tries[i].bytes);
        assert_int_equal(qtri_frame_set_depth(&frame, &qtri_depth_linear32), tries[i].error);
        int bands = 0;
        while (next_shown(&frame, &band, &shown)) {
            bands++;
        }
        assert_int_equal(bands, i == 0 ? HEIGHT / 8 : 0);
    }
}

/* A format of depth says nothing where no depth is stored. */
TEST(formats_without_depth)
{
    static board b[2];
    static uint32_t words[2][QTRI_EDGES_WORDS_WITHOUT_DEPTH(WIDTH, HEIGHT, QTRI_RGB565_BYTES)];
    for (int i = 0; i < 2; i++) {
        uint64_t seed = 3;
        qtri_edges edges;
        board_init(&b[i], &qtri_rgb565, i == 0 ? NULL : &qtri_depth_linear32);
        b[i].surface.depth = NULL;
        memset(b[i].memory, 0, sizeof b[i].memory);
        for (int n = 0; n < 20; n++) {
            qtri_material m = qtri_material_default();
            qtri_screen_vertex v[3];
            m.depth_compare = QTRI_LESS;
            random_triangle(v, &seed, 9000);
            qtri_raster_line(&b[i].surface, &m, v);
        }
        memset(words[i], 0xA5, sizeof words[i]);
        assert_ok(qtri_edges_begin(&edges, &b[i].surface, words[i], (uint32_t)LENGTH_OF(words[i])));
        qtri_edges_blend(&edges);
    }
    assert_same_memory(&b[0], &b[1]);
    assert_memory_equal(words[0], words[1], sizeof words[0]);
}

/* Comparisons that do not exist always pass, in all formats of depth and in samples. */
TEST(comparisons_that_are_none)
{
    static board b[2];
    for (int n = 0; n < 3; n++) {
        for (int i = 0; i < 2; i++) {
            uint64_t seed = 5;
            board_init(&b[i], n == 2 ? &qtri_rgb565_x4 : &qtri_rgb565,
                       n == 0 ? &qtri_depth_linear32 : (n == 1 ? &qtri_depth_float16 : NULL));
            qtri_material m = qtri_material_default();
            for (int k = 0; k < 6; k++) {
                qtri_screen_vertex v[3];
                m.cull = QTRI_CULL_NONE;
                m.depth_compare = i == 0 ? QTRI_ALWAYS : (qtri_compare)(QTRI_ALWAYS + 1 + k);
                random_triangle(v, &seed, 9000);
                qtri_raster_triangle(&b[i].surface, qtri_pipelines_default, &m, v);
                draw_ball(&b[i].surface, &m);
            }
        }
        assert_same_memory(&b[0], &b[1]);
    }
}

/* Depths of 0 at pixels' centres, of steep triangles: rounding leaves none of them far away. */
TEST(depths_of_nothing)
{
    uint64_t seed = 8;
    static board b;
    for (int n = 0; n < 300; n++) {
        board_init(&b, &qtri_rgb565, &qtri_depth_linear32);
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        m.depth_compare = QTRI_LESS;
        random_triangle(v, &seed, 4000);
        for (int i = 0; i < 2; i++) { /* an edge of depth 0 through centres */
            v[i].depth_16p16 = 0;
            v[i].x_24p8 = (v[i].x_24p8 & ~255) + 128;
            v[i].y_24p8 = (v[i].y_24p8 & ~255) + 128;
        }
        const int32_t dx = (v[1].x_24p8 - v[0].x_24p8) / 2, dy = (v[1].y_24p8 - v[0].y_24p8) / 2;
        if (n % 2 == 0) { /* beside the edge's middle */
            v[2].x_24p8 = v[0].x_24p8 + dx + random_in(&seed, -60, 60);
            v[2].y_24p8 = v[0].y_24p8 + dy + random_in(&seed, -60, 60);
        }
        qtri_raster_triangle(&b.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            uint32_t depth;
            memcpy(&depth, (const uint8_t *)b.surface.depth + 4 * (size_t)i, 4);
            assert_true(depth == 0xFFFF0000u || depth <= v[2].depth_16p16 + 0x10000u);
        }
    }
}

/*
 * Slivers of any slope from the nearest depth to the farthest: there is no room to move them, and
 * they are drawn as without a bias.
 */
TEST(slopes_without_bounds)
{
    static board b[2];
    uint64_t seed = 10;
    int drawn = 0;
    board_init(&b[0], &qtri_rgb565, NULL);
    board_init(&b[1], &qtri_rgb565, NULL);
    for (int n = 0; n < 3000; n++) {
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        const int32_t column = random_in(&seed, 8, WIDTH - 8),
                      row = random_in(&seed, 8, HEIGHT - 8);
        const int32_t dx = random_in(&seed, -2000000, 2000000), dy = random_in(&seed, 1, 8);
        const uint16_t centre = (uint16_t)random_in(&seed, 0, 65535);
        random_triangle(v, &seed, 1);
        v[0].x_24p8 = column * 256 + 128 - dx; /* a left edge through a centre */
        v[0].y_24p8 = row * 256 + 128 - dy;
        v[1].x_24p8 = column * 256 + 128 + dx;
        v[1].y_24p8 = row * 256 + 128 + dy;
        v[2].x_24p8 = column * 256 + 129;
        v[2].y_24p8 = row * 256 + 128;
        v[0].depth_16p16 = n % 8 < 4 ? 0 : 65535u << 16;
        v[1].depth_16p16 = (65535u << 16) - v[0].depth_16p16;
        m.depth_compare = QTRI_ALWAYS;
        m.depth_slope = n % 2 == 0 ? Q16(-1) : Q16(1);
        for (int i = 0; i < 2; i++) {
            m.depth_shift = i == 0 ? NULL : &qtri_slope_bias;
            b[i].surface.depth[row * WIDTH + column] = centre;
            qtri_raster_triangle(&b[i].surface, qtri_pipelines_default, &m, v);
        }
        drawn += stored_depth(&b[0].surface, column, row) != centre;
    }
    assert_same_memory(&b[0], &b[1]);
    assert_true(drawn > 2900);
}

/* A bias by slope that is 0 moves nothing, of a mesh of one colour in light either. */
TEST(slopes_of_nothing)
{
    static board b[2];
    qtri_material m = qtri_material_default();
    for (int i = 0; i < 2; i++) {
        board_init(&b[i], &qtri_rgb565, NULL);
        m.depth_shift = i == 0 ? NULL : &qtri_slope_bias;
        draw_mesh(&b[i].surface, &m, &ball, 9);
    }
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) { /* one way rounds as the other but for a step */
        const qtri_rgb p = qtri_surface_pixel(&b[0].surface, i % WIDTH, i / WIDTH);
        const qtri_rgb q = qtri_surface_pixel(&b[1].surface, i % WIDTH, i / WIDTH);
        assert_true(abs(p.r - q.r) <= 9 && abs(p.g - q.g) <= 9 && abs(p.b - q.b) <= 9);
    }
}

/* ---- Samples ---- */

/* What only tests depth stores none; triangles without an area draw nothing. */
TEST(samples_that_only_test)
{
    static board b[2];
    static const qtri_vec3 line[3] = {{-65536, 0, 0}, {0, 0, 0}, {65536, 0, 0}};
    static const uint16_t one[1][3] = {{0, 1, 2}};
    const qtri_mesh flat = {
        .positions = line, .triangles = one, .vertex_count = 3, .triangle_count = 1};
    for (int i = 0; i < 2; i++) {
        board_init(&b[i], &qtri_rgb565_x4, NULL);
        qtri_material m = qtri_material_default();
        m.cull = QTRI_CULL_NONE;
        draw_mesh(&b[i].surface, &m, &flat, 6);
        m.color = (qtri_rgb){250, 30, 20};
        m.depth_read_only = true;
        draw_ball(&b[i].surface, &m);
        m.color = (qtri_rgb){20, 250, 30};
        m.depth_read_only = false;
        m.depth_compare = i == 0 ? QTRI_LESS : QTRI_DEPTH_OFF; /* as nothing was stored */
        m.cull = QTRI_CULL_BACK;
        draw_ball(&b[i].surface, &m);
    }
    const int32_t size = qtri_rgb565_x4.pixels->bytes;
    for (ptrdiff_t i = 0; i < WIDTH * HEIGHT; i++) {
        for (int k = 0; k < 4; k++) {
            assert_int_equal(
                qtri_sample_color(b[0].surface.pixels + i * size, qtri_sample_bytes(size), k),
                qtri_sample_color(b[1].surface.pixels + i * size, qtri_sample_bytes(size), k));
        }
    }
}

/* ---- Fog, alpha, texels ---- */

/* Fog that no function made is none, of blended strokes too. */
TEST(fog_of_nothing)
{
    static const qtri_fog nothing;
    static board b[2];
    for (int i = 0; i < 2; i++) {
        uint64_t seed = 4;
        board_init(&b[i], &qtri_rgb565, NULL);
        for (int n = 0; n < 12; n++) {
            qtri_material m = qtri_material_default();
            qtri_stroke stroke = qtri_stroke_default();
            qtri_screen_vertex v[3];
            stroke.width = Q16(5);
            m.blend = &qtri_blend_add;
            m.fog = i == 0 ? NULL : &nothing;
            random_triangle(v, &seed, 9000);
            qtri_raster_polyline(&b[i].surface, &m, &stroke, v, 3);
        }
    }
    assert_same_memory(&b[0], &b[1]);
}

/* Stored in 32 bits a pixel, with colours of RGB565. */
static uint32_t decode_wide(uint32_t stored)
{
    return qtri_rgb565.decode(stored & 0xFFFF);
}

/* Alpha of vertices that are equally far away is linear on the screen. */
TEST(alpha_at_one_distance)
{
    static board b[2];
    static const uint8_t alphas[3] = {20, 130, 250};
    const qtri_format wide = {&qtri_pixels_32, &qtri_colors_565, NULL, decode_wide, NULL, 0};
    const qtri_format *const formats[3] = {&qtri_rgb565, &qtri_xrgb8888, &wide};
    for (int f = 0; f < 3; f++) {
        for (int i = 0; i < 2; i++) {
            uint64_t seed = 6;
            board_init(&b[i], formats[f], NULL);
            for (int n = 0; n < 12; n++) {
                qtri_material m = plain_material();
                qtri_screen_vertex v[3];
                m.shading = QTRI_SMOOTH;
                m.blend = &qtri_blend_vertex_alpha;
                m.alphas = alphas;
                m.interpolation = i == 0 ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
                random_triangle(v, &seed, 9000);
                qtri_raster_triangle(&b[i].surface, qtri_pipelines_default, &m, v);
            }
        }
        assert_same_memory(&b[0], &b[1]);
    }
}

/*
 * Alpha stays between that of the vertices, red over black, where they are up to 4096 times as far
 * away as each other; and anywhere in parts it is what it is as a whole.
 */
TEST(alpha_of_far_vertices)
{
    uint64_t seed = 12;
    static board b[2];
    for (int n = 0; n < 300; n++) {
        const uint8_t least = (uint8_t)random_in(&seed, 1, 120);
        const uint8_t alphas[3] = {(uint8_t)(least + 80), least, (uint8_t)(least + 130)};
        const bool far = n % 4 == 3;
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        m.blend = &qtri_blend_vertex_alpha;
        m.alphas = alphas;
        random_triangle(v, &seed, n % 2 == 0 ? 9000 : 90000);
        for (int i = 0; i < 3; i++) {
            v[i].inv_w_exponent = -random_in(&seed, 0, 12);
            v[i].color_8p16[0] = 255 << 16;
        }
        if (far) { /* a side through the centres of a row, or nearly */
            v[0].y_24p8 = random_in(&seed, 2, HEIGHT / 2) * 256 + 128;
            v[1].y_24p8 = v[0].y_24p8 + (n % 16 == 7 ? random_in(&seed, -2, 2) : 0);
            v[2].y_24p8 = random_in(&seed, HEIGHT / 2, 300) * 256;
            v[1].inv_w_exponent = v[0].inv_w_exponent = -random_in(&seed, 23, 29);
            v[2].inv_w_exponent = 0;
        }
        for (int i = 0; i < 2; i++) {
            board_init(&b[i], &qtri_xrgb8888, NULL);
            qtri_surface_clear(&b[i].surface, (qtri_rgb){0, 0, 0});
        }
        qtri_raster_triangle(&b[0].surface, qtri_pipelines_default, &m, v);
        for (int part = 0; part < 3; part++) {
            qtri_surface s = b[1].surface;
            s.scissor.x0 = part * 21;
            s.scissor.x1 = part * 21 + (part == 2 ? 22 : 21);
            qtri_raster_triangle(&s, qtri_pipelines_default, &m, v);
        }
        assert_same_memory(&b[0], &b[1]);
        for (int32_t i = 0; !far && i < WIDTH * HEIGHT; i++) {
            const uint32_t red = stored_pixel(&b[0].surface, i % WIDTH, i / WIDTH) >> 16 & 255;
            assert_true(red == 0 || (red + 1 >= least && red <= (uint32_t)least + 131));
        }
    }
}

/* Texels with alpha that no blend asks for are lit as those without. */
TEST(alpha_that_is_not_asked_for)
{
    static board b[2];
    static uint32_t texels[64];
    uint64_t seed = 3;
    for (int i = 0; i < 64; i++) {
        texels[i] = (uint32_t)random64(&seed);
    }
    for (int n = 0; n < 4; n++) {
        for (int i = 0; i < 2; i++) {
            const qtri_texture texture = {.format =
                                              i == 0 ? &qtri_texel_xrgb8888 : &qtri_texel_argb8888,
                                          .texels = texels,
                                          .width_log2 = 3,
                                          .height_log2 = 3};
            qtri_material m = qtri_material_default();
            board_init(&b[i], n & 1 ? &qtri_xrgb8888 : &qtri_rgb565, NULL);
            m.texture = &texture;
            m.shading = n & 2 ? QTRI_FLAT_FIRST : QTRI_SMOOTH;
            m.color = (qtri_rgb){200, 150, 255};
            draw_mesh(&b[i].surface, &m, &ball, 5);
        }
        assert_same_memory(&b[0], &b[1]);
    }
}

/* Texels that are opaque, blended: times colours of vertices what those without alpha are. */
TEST(opaque_texels_times_colors)
{
    static board b[2];
    static uint32_t texels[64];
    static qtri_rgb colors[LENGTH_OF(positions)];
    uint64_t seed = 5;
    for (int i = 0; i < 64; i++) {
        texels[i] = (uint32_t)random64(&seed) | 0xFF000000u;
    }
    for (size_t i = 0; i < LENGTH_OF(colors); i++) {
        colors[i] = (qtri_rgb){(uint8_t)random64(&seed), (uint8_t)random64(&seed), 99};
    }
    qtri_mesh colored = ball;
    colored.colors = colors;
    for (int i = 0; i < 2; i++) {
        const qtri_texture texture = {.format =
                                          i == 0 ? &qtri_texel_xrgb8888 : &qtri_texel_argb8888,
                                      .texels = texels,
                                      .width_log2 = 3,
                                      .height_log2 = 3};
        qtri_material m = qtri_material_default();
        board_init(&b[i], &qtri_xrgb8888, NULL);
        m.texture = &texture;
        m.blend = i == 0 ? NULL : &qtri_blend_alpha;
        draw_mesh(&b[i].surface, &m, &colored, 5);
    }
    assert_same_memory(&b[0], &b[1]);
}

/* Small clamped triangles take sides of more than 1024 texels as 1024. */
TEST(clamped_sides_above_1024)
{
    static board b[2];
    static uint16_t texels[1024 * 4];
    for (int i = 0; i < 1024 * 4; i++) {
        texels[i] = (uint16_t)(i * 77);
    }
    for (int i = 0; i < 2; i++) {
        const qtri_texture texture = {.format = &qtri_texel_rgb565,
                                      .texels = texels,
                                      .width_log2 = i == 0 ? 10 : 12,
                                      .height_log2 = 2,
                                      .wrap_u = QTRI_CLAMP,
                                      .wrap_v = QTRI_CLAMP};
        qtri_material m = qtri_material_default();
        board_init(&b[i], &qtri_rgb565, NULL);
        m.texture = &texture;
        draw_mesh(&b[i].surface, &m, &ball, 5);
    }
    assert_same_memory(&b[0], &b[1]);
}

int main(void)
{
    return run_all_tests(set_up, NULL);
}
