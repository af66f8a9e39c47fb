/* SPDX-License-Identifier: MIT */
/*
 * Pixels over pixels: blends and fog against exact arithmetic, once for each pixel, in order.
 */
#include "support/core.h"
#include "support/steps.h"

#include "qtri/body/state.h"

enum { WIDTH = 96, HEIGHT = 80 };

static const qtri_blend *const blends[] = {&qtri_blend_alpha, &qtri_blend_add, &qtri_blend_multiply,
                                           &qtri_blend_none};

static qtri_material blended(const qtri_blend *blend, int32_t alpha)
{
    qtri_material m = qtri_material_default();
    m.cull = QTRI_CULL_NONE;
    m.shading = QTRI_FLAT_FIRST;
    m.blend = blend;
    m.alpha = (uint8_t)alpha;
    return m;
}

static void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, const uint8_t rgb[3])
{
    const int32_t x = random_in(seed, 0, WIDTH * 256);
    const int32_t y = random_in(seed, 0, HEIGHT * 256);
    const int32_t reach = random_flag(seed) ? 2000 : 30000;
    for (int i = 0; i < 3; i++) {
        const int32_t dx = random_in(seed, -reach, reach);
        v[i] = screen_at(x + dx, y + random_in(seed, -reach, reach));
        v[i].depth_16p16 = (uint32_t)random_in(seed, 0, 65000) << 16;
        for (int k = 0; k < 3; k++) {
            v[i].color_8p16[k] = (int32_t)rgb[k] << 16;
        }
    }
}

static double mixed(const qtri_blend *blend, double over, double under, double alpha, double most)
{
    return blend == &qtri_blend_alpha ? over * alpha + under * (1 - alpha)
                                      : fmin(most, under + over * alpha);
}

/* Pixels of `drawn` against the mixture of `before` and a colour where `covered` is not black. */
static double compare(const canvas *drawn, const canvas *before, const canvas *covered,
                      const qtri_blend *blend, const double rgb[3], double alpha)
{
    const qtri_format *format = drawn->surface.format;
    double worst = 0;
    for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const int32_t x = i % WIDTH;
        const int32_t y = i / WIDTH;
        const uint32_t is = stored_pixel(&drawn->surface, x, y);
        const uint32_t was = stored_pixel(&before->surface, x, y);
        if (stored_pixel(&covered->surface, x, y) == 0) {
            assert_int_equal(is, was);
            continue;
        }
        for (int k = 0; k < 3; k++) {
            const double should = mixed(blend, steps_of(format, rgb, k),
                                        stored_steps(format, was, k), alpha, most_steps(format, k));
            worst = fmax(worst, fabs(stored_steps(format, is, k) - should));
        }
    }
    return worst;
}

/* A texture of one texel, which brings alpha. */
TEST(texels)
{
    uint64_t seed = 2;
    static const qtri_texel_format *const formats[3] = {&qtri_texel_argb4444, &qtri_texel_argb1555,
                                                        &qtri_texel_argb8888};
    for (int f = 0; f < 6; f++) {
        const qtri_format *format = drawn_format(f);
        canvas drawn = canvas_new(format, WIDTH, HEIGHT);
        canvas before = canvas_new(format, WIDTH, HEIGHT);
        canvas covered = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
        double worst = 0;
        for (int n = 0; n < random_cases(1500); n++) {
            const int kind = n % 3;
            const int which = n / 3 % 2;
            const uint32_t digits = (uint32_t)random_bits32(&seed);
            const uint16_t texel16 = (uint16_t)digits;
            const uint32_t texel32 = digits;
            const uint8_t white[3] = {255, 255, 255};
            double argb[4];
            qtri_texture texture = {.texels = kind == 2 ? (const void *)&texel32 : &texel16,
                                    .format = formats[kind]};
            for (int i = 0; i < 4; i++) {
                argb[i] = kind == 2   ? digits >> (24 - 8 * i) & 255
                          : kind == 0 ? 17 * (digits >> (12 - 4 * i) & 15)
                                      : (digits >> (15 - 5 * i) & 31) * 255.0 / 31;
            }
            if (kind == 1) {
                argb[0] = (digits & 0x8000) != 0 ? 255 : 0;
            }
            qtri_screen_vertex v[3];
            const int32_t alpha = random_in(&seed, 0, 255);
            qtri_material m = blended(n % 7 == 0 ? NULL : blends[which], alpha);
            m.texture = &texture;
            m.texture_mode = n % 2 == 0 ? QTRI_MODULATE : QTRI_REPLACE;
            m.least_alpha = n % 5 == 0 ? (uint8_t)random_in(&seed, 0, 255) : 0;
            const qtri_material solid = blended(NULL, 0);
            canvas_clear(&drawn);
            canvas_clear(&before);
            canvas_clear(&covered);
            random_triangle(v, &seed, white);
            qtri_raster_triangle(&drawn.surface, qtri_pipelines_default, &m, v);
            if (argb[0] >= m.least_alpha) {
                qtri_raster_triangle(&covered.surface, qtri_pipelines_default, &solid, v);
            }
            worst = fmax(worst, compare(&drawn, &before, &covered, blends[which], argb + 1,
                                        m.blend == NULL ? 1 : argb[0] * alpha / 255 / 255));
        }
        print_message("format %d: %.3f of a step\n", f, worst);
        assert_true(worst <= 1.5);
        canvas_free(&drawn);
        canvas_free(&before);
        canvas_free(&covered);
    }
}

/* A wavy grid over the whole frame, cells of any size: each pixel belongs to one triangle. */
enum { COLUMNS = 9, ROWS = 7, CORNERS = (COLUMNS + 1) * (ROWS + 1), CELLS = COLUMNS * ROWS };
static qtri_vec3 grid_positions[CORNERS];
static uint16_t grid_triangles[2 * CELLS][3];

static qtri_mesh wavy_grid(uint64_t *seed)
{
    qtri_mesh mesh = {.positions = grid_positions,
                      .triangles = (const uint16_t(*)[3])grid_triangles,
                      .vertex_count = CORNERS,
                      .triangle_count = 2 * CELLS};
    for (int i = 0; i < CORNERS; i++) {
        const int column = i % (COLUMNS + 1);
        const int row = i / (COLUMNS + 1);
        const bool edge = column == 0 || row == 0 || column == COLUMNS || row == ROWS;
        grid_positions[i].x =
            fixed(2.2 * column / COLUMNS - 1.1) + (edge ? 0 : random_in(seed, -3000, 3000));
        grid_positions[i].y =
            fixed(2.2 * row / ROWS - 1.1) + (edge ? 0 : random_in(seed, -3000, 3000));
        grid_positions[i].z = 0;
    }
    for (int i = 0; i < CELLS; i++) {
        const uint16_t corner = (uint16_t)(i / COLUMNS * (COLUMNS + 1) + i % COLUMNS);
        const uint16_t below = (uint16_t)(corner + COLUMNS + 1);
        const uint16_t indices[2][3] = {{corner, (uint16_t)(corner + 1), below},
                                        {(uint16_t)(corner + 1), (uint16_t)(below + 1), below}};
        memcpy(grid_triangles[2 * i], indices, sizeof indices);
    }
    return mesh;
}

static void set_view(qtri_view *view)
{
    qtri_view_init(view, WIDTH, HEIGHT);
    qtri_transform_identity(&view->camera);
    qtri_transform_ortho(&view->projection, Q16(-1), Q16(1), Q16(-1), Q16(1), Q16(-2), Q16(2));
}

TEST(once)
{
    uint64_t seed = 3;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    qtri_view view;
    qtri_transform pose;
    set_view(&view);
    for (int n = 0; n < 40; n++) {
        const qtri_mesh mesh = wavy_grid(&seed);
        qtri_material m = blended(&qtri_blend_add, 255);
        m.color.r = 8;
        m.color.g = 16;
        m.color.b = 24;
        m.depth_compare = n % 2 == 0 ? QTRI_DEPTH_OFF : QTRI_LESS_EQUAL;
        qtri_transform_identity(&pose);
        canvas_clear(&c);
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &m);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            assert_int_equal(stored_pixel(&c.surface, i % WIDTH, i / WIDTH), 0x081018);
        }
    }
    canvas_free(&c);
}

/* A heap of triangles, in one call and each alone. */
TEST(heaps)
{
    enum { COUNT = 60 };
    uint64_t seed = 4;
    static qtri_vec3 positions[3 * COUNT];
    static uint16_t triangles[COUNT][3];
    static qtri_rgb colors[3 * COUNT];
    qtri_view view;
    qtri_transform pose;
    qtri_fog fog;
    const qtri_fog_range range = {Q16(-2) + 1, Q16(2), true};
    const qtri_rgb gray = {90, 100, 110};
    set_view(&view);
    qtri_transform_identity(&pose);
    qtri_fog_linear(&fog, gray, range, Q16(0.1), Q16(3));
    for (int n = 0; n < 48; n++) {
        const qtri_format *format = drawn_format(n);
        for (int i = 0; i < COUNT; i++) {
            const double x = random_in(&seed, -1000, 1000) / 1000.0;
            const double y = random_in(&seed, -1000, 1000) / 1000.0;
            const double size = i % 3 == 0 ? 1 : .12;
            for (int k = 0; k < 3; k++) {
                positions[3 * i + k] = vec3_of(x + size * random_in(&seed, -1000, 1000) / 1000.0,
                                               y + size * random_in(&seed, -1000, 1000) / 1000.0,
                                               random_in(&seed, -1500, 1500) / 1000.0);
                triangles[i][k] = (uint16_t)(3 * i + k);
                colors[3 * i + k].r = (uint8_t)random_in(&seed, 0, 255);
                colors[3 * i + k].g = (uint8_t)random_in(&seed, 0, 255);
                colors[3 * i + k].b = (uint8_t)random_in(&seed, 0, 255);
            }
        }
        qtri_mesh mesh = {.positions = positions,
                          .triangles = (const uint16_t(*)[3])triangles,
                          .colors = colors,
                          .vertex_count = 3 * COUNT,
                          .triangle_count = COUNT};
        qtri_material m = blended(n % 6 == 5 ? &qtri_blend_screen_door : blends[n % 6 % 4],
                                  random_in(&seed, 0, 255));
        m.shading = n % 2 == 0 ? QTRI_SMOOTH : QTRI_FLAT_LAST;
        m.depth_compare = n % 4 == 0 ? QTRI_DEPTH_OFF : (n % 4 == 1 ? QTRI_ALWAYS : QTRI_LESS);
        m.fog = n % 3 == 0 ? &fog : NULL;
        m.blend = n % 9 == 0 ? NULL : m.blend;
        m.fill = n % 5 == 4 ? &qtri_wireframe : NULL;
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        canvas parts = canvas_new(format, WIDTH, HEIGHT);
        qtri_draw_mesh(&whole.surface, &view, &pose, &mesh, &m);
        for (int i = 0; i < COUNT; i++) {
            mesh.triangles = (const uint16_t(*)[3])triangles + i;
            mesh.triangle_count = 1;
            qtri_draw_mesh(&parts.surface, &view, &pose, &mesh, &m);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

static double fog_share(int kind, double z, double a, double b)
{
    if (kind == 0) {
        return z <= a ? 1 : (z >= b ? 0 : (b - z) / (b - a));
    }
    return kind == 1 ? exp(-a * z) : exp(-(a * z) * (a * z));
}

TEST(fogs)
{
    uint64_t seed = 5;
    canvas c = canvas_new(&qtri_xrgb8888, 8, 8);
    double worst[2][3] = {{0}};
    for (int n = 0; n < random_cases(4000); n++) {
        qtri_fog fog;
        const int kind = n % 3;
        const bool flat = n % 2 == 0;
        const double near_z = random_in(&seed, 6553, 65536) / 65536.0;
        const double far_z = near_z + random_in(&seed, 65536, 100 * 65536) / 65536.0;
        const qtri_fog_range range = {fixed(near_z), fixed(far_z), flat};
        const qtri_rgb color = {255, 0, 128};
        double a = random_in(&seed, 0, 65536 * 4) / 65536.0;
        const double b = a + random_in(&seed, 65536, 65536 * 60) / 65536.0;
        if (kind == 0) {
            qtri_fog_linear(&fog, color, range, fixed(a), fixed(b));
        } else if (kind == 1) {
            a /= 16;
            qtri_fog_exp(&fog, color, range, fixed(a));
        } else {
            a /= 16;
            qtri_fog_exp2(&fog, color, range, fixed(a));
        }
        qtri_material m = blended(NULL, 255);
        m.depth_compare = QTRI_ALWAYS;
        m.fog = &fog;
        qtri_screen_vertex v[3] = {screen_at(-2560, -2560), screen_at(-2560, 9999),
                                   screen_at(9999, -2560)};
        const int32_t depth = random_in(&seed, 0, 65535);
        for (int i = 0; i < 3; i++) {
            v[i].depth_16p16 = (uint32_t)depth << 16;
            v[i].color_8p16[0] = 0;
            v[i].color_8p16[2] = 0;
        }
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        const double t = 1 - depth / 65535.0;
        const double z =
            flat ? far_z - t * (far_z - near_z) : near_z * far_z / (near_z + t * (far_z - near_z));
        const double green = stored_pixel(&c.surface, 1, 1) >> 8 & 255;
        const double error = fabs(green - 255 * fog_share(kind, z, a, b));
        worst[flat][kind] = fmax(worst[flat][kind], error);
    }
    print_message("fog: perspective %.2f %.2f %.2f, orthographic %.2f %.2f %.2f of 255\n",
                  worst[0][0], worst[0][1], worst[0][2], worst[1][0], worst[1][1], worst[1][2]);
    for (int i = 0; i < 6; i++) {
        assert_true(worst[i / 3][i % 3] <= 1.25);
    }
    canvas_free(&c);
}

/* Some fog that begins near and is nearly whole far away. */
static void random_fog(qtri_fog *fog, uint64_t *seed)
{
    const qtri_fog_range range = {Q16_ONE / 4, random_in(seed, Q16_ONE, 100 * Q16_ONE),
                                  random_flag(seed)};
    const qtri_rgb color = {(uint8_t)random_in(seed, 0, 255), (uint8_t)random_in(seed, 0, 255),
                            (uint8_t)random_in(seed, 0, 255)};
    if (random_flag(seed)) {
        qtri_fog_linear(fog, color, range, random_in(seed, 0, Q16_ONE),
                        random_in(seed, Q16_ONE, 100 * Q16_ONE));
    } else {
        qtri_fog_exp(fog, color, range, random_in(seed, 0, 2 * Q16_ONE));
    }
}

/*
 * Along rows of any slope, steps of the fog's table and ends of linear fog among their pixels: each
 * has what the table has for its depth.
 */
TEST(fog_along_rows_is_that_of_each_depth)
{
    uint64_t seed = 44;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < random_cases(1500); n++) {
        const uint32_t steep = (uint32_t)1 << random_in(&seed, 12, 24);
        qtri_material m = blended(NULL, 255);
        qtri_screen_vertex v[3] = {screen_at(128, 128), screen_at(128 + 256 * 128, 128),
                                   screen_at(128, 128 + 256 * 128)};
        const int32_t right = random_in(&seed, -(int32_t)steep / 2, (int32_t)steep / 2);
        const int32_t down = random_in(&seed, -(int32_t)steep / 2, (int32_t)steep / 2);
        const uint32_t z0 = 0x80000000u + (uint32_t)random_in(&seed, -(1 << 29), 1 << 29);
        qtri_fog fog;
        const qtri_fog_range range = {Q16_ONE / 4, random_in(&seed, Q16_ONE, 100 * Q16_ONE),
                                      random_flag(&seed)};
        const qtri_rgb black = {0, 0, 0};
        const q16 first = random_in(&seed, Q16_ONE / 4, 2 * Q16_ONE);
        if (random_flag(&seed)) {
            qtri_fog_linear(&fog, black, range, first, first + random_in(&seed, 6000, 2 * Q16_ONE));
        } else {
            qtri_fog_exp2(&fog, black, range, first);
        }
        m.depth_compare = QTRI_ALWAYS;
        m.fog = &fog;
        for (int i = 0; i < 3; i++) {
            v[i].depth_16p16 = z0;
            v[i].color_8p16[0] = v[i].color_8p16[1] = v[i].color_8p16[2] = 255 << 16;
        }
        v[1].depth_16p16 += (uint32_t)right * 128;
        v[2].depth_16p16 += (uint32_t)down * 128;
        c.surface.scissor.x0 = random_in(&seed, 0, WIDTH / 2);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < 64 * 64; i++) {
            const int32_t x = i % 64, y = i / 64;
            const uint32_t z = z0 + (uint32_t)right * (uint32_t)x + (uint32_t)down * (uint32_t)y;
            const uint32_t share = qtri_fog_share(&fog, z + 0x8000u);
            if (x >= c.surface.scissor.x0) {
                const double green = stored_pixel(&c.surface, x, y) >> 8 & 255;
                assert_true(fabs(green - share * 255.0 / (1 << 24)) < 1.02);
            }
        }
    }
    canvas_free(&c);
}

/* What is far off in steps of RGB565: a pixel from channels 0..255. */
static double off_565(uint32_t stored, const double color[3])
{
    const uint32_t got[3] = {stored >> 11, stored >> 5 & 63, stored & 31};
    double worst = 0;
    for (int c = 0; c < 3; c++) {
        worst = fmax(worst, fabs(got[c] - color[c] * (c == 1 ? 63 : 31) / 255));
    }
    return worst;
}

/*
 * Colours, flat and smooth, of large and of small triangles, are rounded to RGB565 when fog and a
 * constant alpha have made of them what is stored, and not before: within 3/4 of a step, and .8
 * where there are both.
 */
TEST(fogs_565)
{
    enum { SIDE = 16 };
    uint64_t seed = 23;
    double worst[2] = {0, 0};
    canvas c[2] = {canvas_new(&qtri_rgb565, SIDE, SIDE),
                   canvas_new(&qtri_rgb565_swapped, SIDE, SIDE)};
    for (int n = 0; n < random_cases(3000); n++) {
        qtri_fog fog;
        const qtri_fog_range range = {Q16_ONE / 4, 60 * Q16_ONE, true};
        const qtri_rgb gray = {(uint8_t)random_in(&seed, 0, 255), (uint8_t)random_in(&seed, 0, 255),
                               (uint8_t)random_in(&seed, 0, 255)};
        const double end = random_in(&seed, 30, 100);
        const int32_t depth = random_in(&seed, 0, 65535);
        const double share = fog_share(0, .25 + depth / 65535.0 * 59.75, 1, end);
        const double fogs[3] = {gray.r, gray.g, gray.b};
        const int32_t size = (n % 2 == 0 ? 2 * SIDE : 500) * 256; /* small ones, and large */
        qtri_material m = blended(n % 3 == 0 ? &qtri_blend_alpha : NULL, random_in(&seed, 0, 255));
        const double alpha = m.blend != NULL ? m.alpha / 255.0 : 1;
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(0, size), screen_at(size, 0)};
        qtri_fog_linear(&fog, gray, range, Q16_ONE, fixed(end));
        m.fog = &fog;
        m.depth_compare = QTRI_ALWAYS;
        m.shading = n % 5 == 0 ? QTRI_FLAT_FIRST : QTRI_SMOOTH;
        for (int i = 0; i < 9; i++) {
            v[i / 3].color_8p16[i % 3] = random_in(&seed, 0, 255 * 65536);
            v[i / 3].depth_16p16 = (uint32_t)depth << 16;
        }
        for (int k = 0; k < 2; k++) {
            canvas_clear(&c[k]);
            qtri_raster_triangle(&c[k].surface, qtri_pipelines_default, &m, v);
        }
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const int32_t x = i % SIDE;
            const int32_t y = i / SIDE;
            const uint32_t stored = stored_pixel(&c[0].surface, x, y);
            const uint32_t swapped = stored_pixel(&c[1].surface, x, y);
            const bool flat = m.shading == QTRI_FLAT_FIRST;
            const double right = flat ? 0 : (x + .5) * 256 / size;
            const double down = flat ? 0 : (y + .5) * 256 / size;
            double color[3];
            for (int k = 0; k < 3; k++) {
                const double first = v[0].color_8p16[k] / 65536.0;
                color[k] = first + down * (v[1].color_8p16[k] / 65536.0 - first) +
                           right * (v[2].color_8p16[k] / 65536.0 - first);
                color[k] = alpha * (share * color[k] + (1 - share) * fogs[k]);
            }
            worst[m.blend != NULL] = fmax(worst[m.blend != NULL], off_565(stored, color));
            assert_int_equal(stored, (swapped << 8 | swapped >> 8) & 0xFFFF);
        }
    }
    print_message("fog on RGB565: %.3f, half transparent %.3f of a step\n", worst[0], worst[1]);
    assert_true(worst[0] <= .85 && worst[1] <= .9);
    canvas_free(&c[0]);
    canvas_free(&c[1]);
}

/*
 * Rows of RGB565 are blended and fogged where they are. With its bytes exchanged they are not: the
 * pixels are the same.
 */
TEST(rows)
{
    uint64_t seed = 17;
    canvas c[2] = {canvas_new(&qtri_rgb565, WIDTH, HEIGHT),
                   canvas_new(&qtri_rgb565_swapped, WIDTH, HEIGHT)};
    for (int n = 0; n < random_cases(3000); n++) {
        static const qtri_blend *const chosen[] = {&qtri_blend_alpha, &qtri_blend_add, NULL};
        const uint8_t rgb[3] = {0, 0, 0};
        qtri_fog fog;
        qtri_material m = blended(chosen[n % 3], random_in(&seed, 0, 255));
        qtri_screen_vertex v[3];
        m.alpha = n % 7 == 0 ? 255 : m.alpha;
        m.shading = random_flag(&seed) ? QTRI_FLAT_FIRST : QTRI_SMOOTH;
        m.depth_compare = random_flag(&seed) ? QTRI_ALWAYS : QTRI_LESS;
        random_triangle(v, &seed, rgb);
        for (int i = 0; i < 9; i++) {
            v[i / 3].color_8p16[i % 3] = random_in(&seed, 0, 255 * 65536);
        }
        if (m.blend == NULL || n % 11 == 0) {
            random_fog(&fog, &seed);
            m.fog = &fog;
        }
        for (int k = 0; k < 2; k++) {
            qtri_raster_triangle(&c[k].surface, qtri_pipelines_default, &m, v);
        }
        if (n % 50 == 49) {
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
                const uint32_t swapped = stored_pixel(&c[1].surface, i % WIDTH, i / WIDTH);
                assert_int_equal(stored_pixel(&c[0].surface, i % WIDTH, i / WIDTH),
                                 (swapped << 8 | swapped >> 8) & 0xFFFF);
            }
            canvas_clear(&c[0]);
            canvas_clear(&c[1]);
        }
    }
    canvas_free(&c[0]);
    canvas_free(&c[1]);
}

/* Of equal steps those that end before the near plane, where fog would be less than none. */
static bool is_before_near(const qtri_fog *fog, int i)
{
    return fog->step_bits != 0 && i > 0 &&
           fog->first + ((uint64_t)(i - 1) << fog->step_bits) > UINT64_C(0xFFFF0000);
}

/* Any parameters; fog that nobody set is none. */
TEST(extremes)
{
    uint64_t seed = 6;
    canvas c = canvas_new(&qtri_rgb565, 16, 16);
    for (int n = 0; n < random_cases(20000); n++) {
        qtri_fog fog = {0};
        const qtri_fog_range range = {random_any(&seed), random_any(&seed), random_flag(&seed)};
        const qtri_rgb color = {1, 2, 3};
        switch (n % 4) {
        case 0:
            qtri_fog_linear(&fog, color, range, random_any(&seed), random_any(&seed));
            break;
        case 1:
            qtri_fog_exp(&fog, color, range, random_any(&seed));
            break;
        case 2:
            qtri_fog_exp2(&fog, color, range, random_any(&seed));
            break;
        default:
            break;
        }
        for (int i = 0; i < QTRI_FOG_STEPS; i++) {
            assert_true(n % 4 == 0 || fog.share[i] <= 1024 || is_before_near(&fog, i));
        }
        qtri_material m = blended(NULL, 0);
        m.fog = &fog;
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(0, 9999), screen_at(9999, 0)};
        v[0].depth_16p16 = (uint32_t)random_bits32(&seed);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
    }
    canvas_free(&c);
}

/* The least and the greatest numbers, all with all: products with a depth saturate on either side.
 */
TEST(fog_of_extreme_numbers)
{
    static const q16 numbers[] = {INT32_MIN, INT32_MIN + 1, -1, 0, 1, INT32_MAX};
    enum { NUMBERS = sizeof numbers / sizeof *numbers };
    const qtri_rgb color = {1, 2, 3};
    for (int n = 0; n < 2 * NUMBERS * NUMBERS * NUMBERS; n++) {
        const qtri_fog_range range = {numbers[n / 2 % NUMBERS], numbers[n / 2 / NUMBERS % NUMBERS],
                                      n % 2 == 0};
        const q16 density = numbers[n / 2 / NUMBERS / NUMBERS];
        qtri_fog fog;
        qtri_fog_exp(&fog, color, range, density);
        for (int i = 0; i < QTRI_FOG_STEPS; i++) {
            assert_true(fog.share[i] <= 1024 || is_before_near(&fog, i));
        }
        qtri_fog_exp2(&fog, color, range, density);
        for (int i = 0; i < QTRI_FOG_STEPS; i++) {
            assert_true(fog.share[i] <= 1024);
        }
    }
}

/* More alpha, more pixels, none of which goes; 0 none, 255 all. */
TEST(doors)
{
    canvas c = canvas_new(&qtri_rgb565, 16, 16);
    bool before[256] = {false};
    for (int32_t alpha = 0; alpha <= 255; alpha++) {
        qtri_material m = blended(&qtri_blend_screen_door, alpha);
        qtri_screen_vertex v[3] = {screen_at(-256, -256), screen_at(-256, 9999),
                                   screen_at(9999, -256)};
        int drawn = 0;
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < 256; i++) {
            const bool is = stored_pixel(&c.surface, i % 16, i / 16) != 0;
            assert_int_equal(is, stored_depth(&c.surface, i % 16, i / 16) != 65535);
            assert_true(is || !before[i]);
            before[i] = is;
            drawn += is;
        }
        assert_near(drawn, alpha * 256 / 255.0, 9);
        assert_true((alpha == 0) <= (drawn == 0) && (alpha == 255) <= (drawn == 256));
    }
    canvas_free(&c);
}

/* Channels that are kept stay, the others are as without; depths are as without a blend. */
TEST(channels)
{
    static const qtri_blend *const with[] = {&qtri_blend_replace, &qtri_blend_alpha,
                                             &qtri_blend_add, &qtri_blend_multiply};
    uint64_t seed = 7;
    for (int n = 0; n < random_cases(240); n++) {
        const qtri_format *format = drawn_format(n);
        canvas all = canvas_new(format, WIDTH, HEIGHT);
        canvas some = canvas_new(format, WIDTH, HEIGHT);
        canvas covered = canvas_new(format, WIDTH, HEIGHT);
        const qtri_material solid = blended(NULL, 0);
        const qtri_rgb sky = {40, 90, 200};
        const uint8_t rgb[3] = {(uint8_t)random_in(&seed, 0, 255), 130, 20};
        const uint32_t keep = (uint32_t)n / 6 % 8;
        const bool is_gray = format->colors == &qtri_colors_gray;
        const uint32_t kept = is_gray ? (keep == 7 ? 0xFFFFFF : 0)
                                      : (keep & 4 ? 0xFF0000u : 0) | (keep & 2 ? 0xFF00u : 0) |
                                            (keep & 1 ? 0xFFu : 0);
        qtri_material m = blended(with[n % 4], random_in(&seed, 0, 255));
        qtri_screen_vertex v[3];
        qtri_surface_clear(&all.surface, sky);
        qtri_surface_clear(&some.surface, sky);
        const uint32_t was = format->decode(stored_pixel(&all.surface, 0, 0));
        random_triangle(v, &seed, rgb);
        qtri_raster_triangle(&covered.surface, qtri_pipelines_default, &solid, v);
        qtri_raster_triangle(&all.surface, qtri_pipelines_default, &m, v);
        m.keep = (uint8_t)keep;
        qtri_raster_triangle(&some.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t a = format->decode(stored_pixel(&all.surface, i % WIDTH, i / WIDTH));
            const uint32_t b = format->decode(stored_pixel(&some.surface, i % WIDTH, i / WIDTH));
            assert_int_equal(b, (a & ~kept) | (was & kept));
            const uint16_t depth = stored_depth(&covered.surface, i % WIDTH, i / WIDTH);
            assert_int_equal(stored_depth(&all.surface, i % WIDTH, i / WIDTH), depth);
            assert_int_equal(stored_depth(&some.surface, i % WIDTH, i / WIDTH), depth);
        }
        canvas_free(&all);
        canvas_free(&some);
        canvas_free(&covered);
    }
}

/* A mesh over itself: drawn again only where its bias brings it nearer; any bias is defined. */
TEST(biases)
{
    uint64_t seed = 8;
    qtri_view view;
    qtri_transform pose;
    const qtri_mesh mesh = wavy_grid(&seed);
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    set_view(&view);
    qtri_transform_identity(&pose);
    for (int n = 0; n < 60; n++) {
        qtri_material m = blended(NULL, 255);
        const q16 bias = n % 4 == 0 ? random_any(&seed) : random_in(&seed, -20000, 20000);
        canvas_clear(&c);
        m.color.g = 0;
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &m);
        m.color.g = 255;
        m.depth_bias = bias;
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &m);
        /* The grid lies in the middle of the range. */
        const double near_z = fmin(1, fmax(0, bias / 65536.0));
        const double far_z = fmin(1, fmax(0, 1 + bias / 65536.0));
        const double depth = 65535 * (near_z + far_z) / 2;
        const bool nearer = depth < 32767;
        if (fabs(depth - 32767.5) < 1.5) {
            continue; /* a matter of rounding */
        }
        for (int32_t i = 0; i < WIDTH * HEIGHT; i += 7) {
            const uint32_t green = stored_pixel(&c.surface, i % WIDTH, i / WIDTH) >> 8 & 255;
            assert_int_equal(green, nearer ? 255 : 0);
            assert_near(stored_depth(&c.surface, i % WIDTH, i / WIDTH), nearer ? depth : 32767.5,
                        1);
        }
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
