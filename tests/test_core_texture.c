/* SPDX-License-Identifier: MIT */
/*
 * Texture fetch: the texel under each pixel against double arithmetic, for every size, repeated and
 * clamped, near and far from the origin; nothing is read beside the texture; textures that are
 * none.
 */
#include "support/texture.h"

enum { SIDE = 1024 };

/* Every texel is its own address. */
static uint32_t address_texels[SIDE * SIDE];

static qtri_texture address_texture(int width_log2, int height_log2)
{
    qtri_texture t = {
        .texels = address_texels,
        .format = &qtri_texel_xrgb8888,
        .width_log2 = (uint8_t)width_log2,
        .height_log2 = (uint8_t)height_log2,
    };
    for (uint32_t i = 0; i < 1u << (width_log2 + height_log2); i++) {
        address_texels[i] = i;
    }
    return t;
}

/* How far a coordinate, in texels, is outside of texel `index` of a side that repeats. */
static double outside(double coordinate, int index, int side)
{
    double offset = coordinate - index;
    offset -= floor(offset / side) * side; /* 0..side */
    if (offset <= 1) {
        return 0;
    }
    return fmin(offset - 1, side - offset);
}

/* How far a coordinate, in texels, is outside of texel `index` of a side that ends. */
static double outside_clamped(double coordinate, int index, int side)
{
    double low = index == 0 ? -HUGE_VAL : index;
    double high = index == side - 1 ? HUGE_VAL : index + 1;
    return fmax(fmax(low - coordinate, coordinate - high), 0);
}

/* What random triangles show of their textures. */
typedef struct sample {
    uint64_t seed;
    int count;
    int32_t reach;     /* of positions, 24.8 */
    int32_t uv_reach;  /* Q16.16 */
    int32_t uv_offset; /* Q16.16, to one side or the other */
    int size_log2;     /* of both sides, or -1: any */
    qtri_wrap wrap;
} sample;

/* How far along `side` a coordinate is from the texel that was fetched for it, of the bound. */
static double off(const sample *s, const qtri_screen_vertex v[3], const int32_t at[2],
                  bool perspective, bool second, int side, int index)
{
    const double is = perspective_sum(v, at[0], at[1], perspective, second) * side;
    const double by =
        s->wrap == QTRI_CLAMP ? outside_clamped(is, index, side) : outside(is, index, side);
    return by / coordinate_unit(v, at[0], at[1], perspective, second, side);
}

/* Largest distance between a coordinate and the texel that was fetched for it, of the bound. */
static double worst_texel(sample s)
{
    double worst = 0;
    int pixels = 0;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < s.count; n++) {
        const int width_log2 = s.size_log2 >= 0 ? s.size_log2 : random_in(&s.seed, 0, 10);
        const int height_log2 = s.size_log2 >= 0 ? s.size_log2 : random_in(&s.seed, 0, 10);
        qtri_texture texture = address_texture(width_log2, height_log2);
        texture.wrap_u = texture.wrap_v = s.wrap;
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        m.texture = &texture;
        m.texture_mode = QTRI_REPLACE;
        m.interpolation = (qtri_interpolation)(n % 2);
        m.shading = shading_of(n / 2 % 3);
        m.depth_compare = QTRI_LESS;
        random_triangle(v, &s.seed, s.reach, s.uv_reach);
        const int64_t offset = (int64_t)(random_flag(&s.seed) ? s.uv_offset : -s.uv_offset) * 65536;
        for (int i = 0; i < 3; i++) {
            v[i].color_8p16[i] = 7 << 16; /* does not matter */
            v[i].u_q32 += offset;
            v[i].v_q32 -= offset;
        }
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t at[2] = {i % WIDTH, i / WIDTH};
            if (stored_depth(&c.surface, at[0], at[1]) == 65535) {
                continue;
            }
            const uint32_t texel = stored_pixel(&c.surface, at[0], at[1]);
            const int width = 1 << width_log2;
            const int column = (int)(texel & (uint32_t)(width - 1));
            const int row = (int)(texel >> width_log2);
            worst = fmax(worst, off(&s, v, at, n % 2 == 0, false, width, column));
            worst = fmax(worst, off(&s, v, at, n % 2 == 0, true, 1 << height_log2, row));
            pixels++;
        }
    }
    canvas_free(&c);
    assert_true(pixels > 1000);
    return worst;
}

TEST(texels_that_repeat)
{
    const double usual = worst_texel((sample){91, 600, 6000, Q16(2), 0, 6, QTRI_REPEAT});
    const double sizes = worst_texel((sample){92, 600, 12000, Q16(4), 0, -1, QTRI_REPEAT});
    const double large = worst_texel((sample){93, 300, 1 << 19, Q16(20), 0, 8, QTRI_REPEAT});
    const double guard = worst_texel((sample){94, 300, 4100000, Q16(100), 0, 8, QTRI_REPEAT});
    const double far_out = worst_texel((sample){95, 600, 6000, Q16(30000), 0, 8, QTRI_REPEAT});
    print_message(
        "off, of the bound: 64 on screen %.6f, any size %.6f, 2048 px %.6f, guard band %.6f, "
        "coordinates of 30000 %.4f\n",
        usual, sizes, large, guard, far_out);
    assert_true(usual <= 1);
    assert_true(sizes <= 1);
    assert_true(large <= 1);
    assert_true(guard <= .02 * 256);
    assert_true(far_out <= 1);
}

TEST(texels_that_are_clamped)
{
    const double usual = worst_texel((sample){701, 300, 12000, Q16(2), 0, -1, QTRI_CLAMP});
    const double large = worst_texel((sample){702, 300, 1 << 19, Q16(16), Q16(3), -1, QTRI_CLAMP});
    const double beyond = worst_texel((sample){703, 300, 12000, Q16(2), Q16(5), -1, QTRI_CLAMP});
    const double far_beyond =
        worst_texel((sample){704, 300, 12000, Q16(1), Q16(32766), -1, QTRI_CLAMP});
    const double far_out = worst_texel((sample){705, 300, 12000, Q16(30000), 0, -1, QTRI_CLAMP});
    print_message("clamped, off, of the bound: %.6f, 2048 px %.6f, outside %.6f, far outside %.6f, "
                  "coordinates of 30000 %.4f\n",
                  usual, large, beyond, far_beyond, far_out);
    assert_true(usual <= 1);
    assert_true(large <= 1);
    assert_true(beyond == 0);
    assert_true(far_beyond == 0);
    assert_true(far_out <= 1);
}

/* A quad drawn one texel a pixel, anywhere in the repeats: texel boundaries on pixel edges. */
TEST(pixel_for_texel)
{
    static const int32_t origins[] = {0, 1, -1, 100, -100, 29990, -30010, 32767 - 2, -32768};
    canvas c = canvas_new(&qtri_xrgb8888, 32, 32);
    for (size_t n = 0; n < LENGTH_OF(origins); n++) {
        for (int log2 = 0; log2 <= 5; log2++) {
            qtri_texture texture = address_texture(log2, log2);
            qtri_material m = plain_material();
            m.texture = &texture;
            m.texture_mode = QTRI_REPLACE;
            qtri_screen_vertex q[4] = {screen_at(0, 0), screen_at(32 * 256, 0),
                                       screen_at(32 * 256, 32 * 256), screen_at(0, 32 * 256)};
            for (int i = 0; i < 4; i++) {
                int64_t base = (int64_t)origins[n] * 65536 * 65536;
                int64_t span = (int64_t)(32 >> log2) << 32;
                q[i].u_q32 = base + (i == 1 || i == 2 ? span : 0);
                q[i].v_q32 = base + (i >= 2 ? span : 0);
            }
            qtri_screen_vertex second[3] = {q[0], q[2], q[3]};
            qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, q);
            qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, second);
            for (int32_t i = 0; i < 32 * 32; i++) {
                uint32_t mask = (1u << log2) - 1;
                uint32_t expected =
                    ((uint32_t)(i / 32) & mask) << log2 | ((uint32_t)(i % 32) & mask);
                assert_int_equal(stored_pixel(&c.surface, i % 32, i / 32), expected);
            }
        }
    }
    canvas_free(&c);
}

/* Each pixel of a square shows its texel of 16 x 16, or the border's where the texture clamps. */
static void assert_texel_a_pixel(const qtri_surface *surface, const qtri_texture *texture,
                                 int32_t origin, int32_t side)
{
    for (int32_t i = 0; i < side * side; i++) {
        int32_t at[2] = {origin + i % side, origin + i / side};
        for (int axis = 0; axis < 2; axis++) {
            const bool clamps = (axis == 0 ? texture->wrap_u : texture->wrap_v) == QTRI_CLAMP;
            const int32_t held = at[axis] < 0 ? 0 : (at[axis] > 15 ? 15 : at[axis]);
            at[axis] = clamps ? held : (int32_t)((uint32_t)at[axis] & 15);
        }
        assert_int_equal(stored_pixel(surface, i % side, i / side), at[1] * 16 + at[0]);
    }
}

/* One texel a pixel, begun anywhere, in large triangles. */
TEST(clamps_each_axis)
{
    static const int32_t origins[] = {0, -7, 7, -31, 31, -32, 32, -33, 1000, -1000, 32000, -32000};
    canvas c = canvas_new(&qtri_xrgb8888, 32, 32);
    qtri_texture texture = address_texture(4, 4);
    for (size_t n = 0; n < 4 * LENGTH_OF(origins); n++) {
        int32_t origin = origins[n / 4]; /* in texels */
        texture.wrap_u = n % 2 ? QTRI_CLAMP : QTRI_REPEAT;
        texture.wrap_v = n / 2 % 2 ? QTRI_CLAMP : QTRI_REPEAT;
        qtri_material m = plain_material();
        m.texture = &texture;
        m.texture_mode = QTRI_REPLACE;
        qtri_screen_vertex q[4] = {screen_at(0, 0), screen_at(32 * 256, 0),
                                   screen_at(32 * 256, 32 * 256), screen_at(0, 32 * 256)};
        for (int i = 0; i < 4; i++) {
            q[i].u_q32 = ((int64_t)origin + (i == 1 || i == 2 ? 32 : 0)) * (1 << 28);
            q[i].v_q32 = ((int64_t)origin + (i >= 2 ? 32 : 0)) * (1 << 28);
        }
        qtri_screen_vertex second[3] = {q[0], q[2], q[3]};
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, q);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, second);
        assert_texel_a_pixel(&c.surface, &texture, origin, 32);
    }
    canvas_free(&c);
}

/* A view of pixels whose origin is the middle of a square of so many columns, at z = -5. */
static qtri_view view_of_pixels(int32_t columns)
{
    const q16 half = columns * (Q16_ONE / 2);
    qtri_view view;
    qtri_view_init(&view, columns, columns);
    qtri_transform_ortho(&view.projection, -half, half, -half, half, Q16(1), Q16(9));
    return view;
}

/* Clears the canvas and draws a mesh of at most four vertices. */
static void draw_alone(canvas *c, qtri_view *view, const qtri_mesh *mesh,
                       const qtri_material *material)
{
    qtri_vertex vertices[4];
    qtri_transform pose;
    qtri_transform_identity(&pose);
    give_vertices(view, vertices, 4);
    canvas_clear(c);
    qtri_draw_mesh(&c->surface, view, &pose, mesh, material);
}

TEST(small_triangles_clamp_each_axis)
{
    enum { COLUMNS = 32, CELL = 8 };
    static const uint16_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
    static uint16_t texels[256]; /* of a format for which a pipeline is named */
    canvas c = canvas_new(&qtri_rgb565, COLUMNS, COLUMNS);
    qtri_texture texture = {
        .texels = texels, .format = &qtri_texel_rgb565, .width_log2 = 4, .height_log2 = 4};
    qtri_material m = plain_material();
    qtri_view view = view_of_pixels(COLUMNS);
    m.texture = &texture;
    m.texture_mode = QTRI_REPLACE;
    m.depth_compare = QTRI_LESS;
    for (uint16_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = i;
    }
    for (int32_t n = 0; n < 4 * 80; n++) {
        const int32_t origin = n / 4 - 40; /* in texels */
        texture.wrap_u = n % 2 ? QTRI_CLAMP : QTRI_REPEAT;
        texture.wrap_v = n / 2 % 2 ? QTRI_CLAMP : QTRI_REPEAT;
        qtri_vec3 at[4];
        qtri_vec2 uvs[4];
        for (int i = 0; i < 4; i++) {
            const int32_t x = i == 1 || i == 2 ? CELL : 0, y = i >= 2 ? CELL : 0;
            at[i] = vec3_of(x - COLUMNS / 2, COLUMNS / 2 - y, -5);
            uvs[i].x = (origin + x) * (Q16_ONE / 16);
            uvs[i].y = (origin + y) * (Q16_ONE / 16);
        }
        const qtri_mesh mesh = {.positions = at,
                                .uvs = uvs,
                                .triangles = triangles,
                                .vertex_count = 4,
                                .triangle_count = 2};
        draw_alone(&c, &view, &mesh, &m);
        assert_texel_a_pixel(&c.surface, &texture, origin, CELL);
    }
    canvas_free(&c);
}

/* Memory of exactly the texture's size: the sanitizer watches its ends. */
TEST(stays_inside)
{
    static const struct {
        const qtri_texel_format *format;
        uint8_t size;
    } texels_of[] = {{&qtri_texel_rgb565, 2},     {&qtri_texel_xrgb8888, 4},
                     {&qtri_texel_checker, 0},    {&qtri_texel_palette8, 1},
                     {&qtri_texel_palette565, 1}, {&qtri_texel_gray8, 1}};
    static const int8_t sides[] = {0, 1, 5, 10};
    static const uint16_t palette[256 * sizeof(qtri_rgb) / sizeof(uint16_t)];
    uint64_t seed = 730;
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < 6 * 16 * 20; n++) {
        qtri_texture texture = {.format = texels_of[n % 6].format,
                                .width_log2 = (uint8_t)sides[n / 6 % 4],
                                .height_log2 = (uint8_t)sides[n / 24 % 4],
                                .wrap_u = (qtri_wrap)random_in(&seed, 0, 1),
                                .wrap_v = (qtri_wrap)random_in(&seed, 0, 1),
                                .filter = &qtri_bilinear,
                                .palette = palette,
                                .has_key = random_flag(&seed),
                                .key = 1};
        size_t count = (size_t)1 << (texture.width_log2 + texture.height_log2);
        void *texels = texels_of[n % 6].size ? calloc(count, texels_of[n % 6].size) : NULL;
        texture.texels = texels;
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        m.texture = &texture;
        m.interpolation = (qtri_interpolation)random_in(&seed, 0, 1);
        random_triangle(v, &seed, 6000, Q16(2));
        for (int i = 0; i < 3 && n % 3 != 0; i++) { /* any number whatever */
            v[i].u_q32 = (int64_t)random64(&seed) >> random_in(&seed, 0, 40);
            v[i].v_q32 = (int64_t)random64(&seed) >> random_in(&seed, 0, 40);
            v[i].inv_w_q31 = (uint32_t)random64(&seed) >> random_in(&seed, 0, 31);
        }
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        free(texels);
    }
    canvas_free(&c);
}

/* No texels, no format, sides too large: untextured or held to 1024. */
TEST(textures_that_are_none)
{
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    static const qtri_texture zeroed;
    qtri_texture none = {.format = &qtri_texel_xrgb8888, .width_log2 = 3, .height_log2 = 3};
    qtri_material m = plain_material();
    const int level[3] = {10, 20, 30};
    m.texture = &zeroed;
    draw_quad(&c, &m, level);
    assert_int_equal(stored_pixel(&c.surface, 3, 3), 0x0A141E);
    m.texture = &none;
    m.texture_mode = QTRI_REPLACE;
    draw_quad(&c, &m, level);
    assert_int_equal(stored_pixel(&c.surface, 3, 3), 0x0A141E);
    qtri_texture huge = address_texture(10, 10);
    qtri_texture same = huge;
    huge.width_log2 = 255;
    huge.height_log2 = 11;
    canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    m.texture = &huge;
    draw_quad(&c, &m, level);
    m.texture = &same;
    draw_quad(&d, &m, level);
    assert_same_picture(&c.surface, &d.surface);
    canvas_free(&c);
    canvas_free(&d);
}

/*
 * A level begins at 181/128 of its texels a pixel, which stand in for the square root of two: a
 * small triangle that steps by these is drawn with it, one that steps by a little less is not.
 */
TEST(levels_begin_at_their_step)
{
    enum { COLUMNS = 64, LOG2 = 7, LEVELS = 4 };
    static uint8_t texels8[LEVELS][1 << 2 * LOG2];
    static const void *const levels[LEVELS - 1] = {texels8[1], texels8[2], texels8[3]};
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    const qtri_texture texture = {.format = &qtri_texel_gray8,
                                  .texels = texels8[0],
                                  .width_log2 = LOG2,
                                  .height_log2 = LOG2,
                                  .filter = &qtri_mipmapped,
                                  .levels = levels,
                                  .level_count = LEVELS - 1};
    qtri_material material = plain_material();
    canvas c = canvas_new(&qtri_gray8, COLUMNS, COLUMNS);
    qtri_view view = view_of_pixels(COLUMNS);
    material.texture = &texture;
    material.texture_mode = QTRI_REPLACE;
    for (int level = 0; level < LEVELS; level++) {
        memset(texels8[level], 10 + level, sizeof texels8[level]);
    }
    for (int32_t n = 3; n < 60; n++) {
        /* Along x, along y; of a repeat, 2^-16. */
        for (int32_t step = 724 * n, level = 0; step < 65536 && level + 1 < LEVELS;
             step *= 2, level++) {
            for (int turn = 0; turn < 4; turn++) {
                const int32_t by = turn & 1 ? step : step - 4;
                const qtri_vec3 at[3] = {vec3_of(-32, 32, -5), vec3_of(n - 32, 32, -5),
                                         vec3_of(-32, 32 - n, -5)};
                const qtri_vec2 uvs[3] = {{0, 0}, {turn & 2 ? 0 : by, 0}, {0, turn & 2 ? by : 0}};
                const qtri_mesh mesh = {.positions = at,
                                        .uvs = uvs,
                                        .triangles = triangle,
                                        .vertex_count = 3,
                                        .triangle_count = 1};
                draw_alone(&c, &view, &mesh, &material);
                const int32_t drawn = (int32_t)stored_pixel(&c.surface, 0, 0) - 10;
                if (drawn != level + (turn & 1)) {
                    fail_msg("%d pixels, %d: level %d", (int)n, (int)by, (int)drawn);
                }
            }
        }
    }
    canvas_free(&c);
}

/*
 * A ground of 600 repeats, of which a clamped texture has one: coordinates are left with fewer bits
 * of a texel than a filter's weights have. Between its edges it is filtered where it is to 1/8 of a
 * texel.
 */
TEST(clamped_textures_of_wide_grounds_are_filtered)
{
    enum { COLUMNS = 64, ROWS = 64, LOG2 = 10 };
    static uint8_t texels8[1 << LOG2];
    const int32_t reach = 16000;
    const double step = 300.0 / reach; /* repeats a pixel in row 0 */
    uint64_t seed = 92;
    int32_t inside = 0;
    double worst = 0;
    qtri_screen_vertex v[3];
    for (int32_t i = 0; i < 1 << LOG2; i++) {
        texels8[i] = (uint8_t)random_in(&seed, 0, 255);
    }
    for (int i = 0; i < 3; i++) {
        const int32_t x = i == 0 ? 32 - reach : i == 1 ? 32 + reach : 32;
        const int32_t y = i == 2 ? 6 * ROWS : 0;
        v[i] = screen_at(x * 256, y * 256);
        v[i].inv_w_q31 = (uint32_t)((y + 1) * (2147483647.0 / (6 * ROWS + 1)));
        v[i].u_q32 = (int64_t)((.5 + (x - 32) * step / (y + 1)) * 4294967296.0);
    }
    const qtri_texture texture = {.format = &qtri_texel_gray8,
                                  .texels = texels8,
                                  .width_log2 = LOG2,
                                  .filter = &qtri_bilinear,
                                  .wrap_u = QTRI_CLAMP};
    qtri_material material = plain_material();
    canvas c = canvas_new(&qtri_gray8, COLUMNS, ROWS);
    material.texture = &texture;
    material.texture_mode = QTRI_REPLACE;
    canvas_clear(&c);
    qtri_raster_triangle(&c.surface, qtri_pipelines_default, &material, v);
    for (int32_t y = 0; y < ROWS; y++) {
        for (int32_t x = 0; x < COLUMNS; x++) {
            const double u = .5 + (x + .5 - 32) * step / (y + 1.5);
            if (u > 2.0 / (1 << LOG2) && u < 1 - 2.0 / (1 << LOG2)) {
                const double at = u * (1 << LOG2) - .5;
                const int32_t left = (int32_t)at;
                const double expected =
                    texels8[left] + (texels8[left + 1] - texels8[left]) * (at - left);
                worst = fmax(worst, fabs(stored_pixel(&c.surface, x, y) - expected));
                inside++;
            }
        }
    }
    print_message("%d pixels of a wide ground, off by %.1f of 255 at most\n", (int)inside, worst);
    assert_true(inside > 3000 && worst <= 255 / 8.0);
    canvas_free(&c);
}

enum { LEFT = 10, LEG = 10 }; /* of a small triangle: its corner, both sides from there */

/* One whose coordinates at the corner, right and below are these. */
static void draw_small(canvas *c, const qtri_texture *texture, const qtri_vec2 uvs[3],
                       qtri_interpolation interpolation)
{
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    const double to = LEFT + LEG;
    const double at[3][2] = {{LEFT, LEFT}, {to, LEFT}, {LEFT, to}};
    qtri_vec3 positions[3];
    qtri_vertex vertices[3];
    qtri_view view;
    qtri_transform pose;
    qtri_material m = qtri_material_default();
    for (int i = 0; i < 3; i++) {
        positions[i].x = (q16)lrint((2 * at[i][0] / WIDTH - 1) * 65536);
        positions[i].y = (q16)lrint((1 - 2 * at[i][1] / HEIGHT) * 65536);
        positions[i].z = 0;
    }
    const qtri_mesh mesh = {.positions = positions,
                            .triangles = triangle,
                            .vertex_count = 3,
                            .triangle_count = 1,
                            .uvs = uvs};
    m.cull = QTRI_CULL_NONE;
    m.texture = texture;
    m.texture_mode = QTRI_REPLACE;
    m.interpolation = interpolation;
    qtri_view_init(&view, WIDTH, HEIGHT);
    give_vertices(&view, vertices, 3);
    qtri_transform_identity(&pose);
    canvas_clear(c);
    qtri_draw_mesh(&c->surface, &view, &pose, &mesh, &m);
}

/* A small triangle that lies beside a clamped texture, however far, has its first or its last
   column and row. */
TEST(small_triangles_beside_their_texture)
{
    static const uint32_t places[4] = {0x10000, 0x10001, 0x10002, 0x10003};
    static const double beyond[] = {1.01, 1.5, 2, 3.99, 4, 7.9, 8, 9, 100, 20000, 32766};
    const qtri_texture t = {.texels = places,
                            .format = &qtri_texel_xrgb8888,
                            .width_log2 = 1,
                            .height_log2 = 1,
                            .wrap_u = QTRI_CLAMP,
                            .wrap_v = QTRI_CLAMP};
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (size_t n = 0; n < 4 * LENGTH_OF(beyond); n++) {
        const double by = beyond[n / 4];
        const double u = n & 1 ? by : -by, v = n & 2 ? by : -by;
        qtri_vec2 uvs[3];
        for (int i = 0; i < 3; i++) {
            uvs[i].x = (q16)(u * 65536) + (i == 1 ? 6000 : 0);
            uvs[i].y = (q16)(v * 65536) + (i == 2 ? 6000 : 0);
        }
        draw_small(&c, &t, uvs, n % 3 ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR);
        for (int32_t y = LEFT; y < LEFT + LEG; y++) {
            for (int32_t x = LEFT; x + y < 2 * LEFT + LEG - 1; x++) {
                assert_int_equal(stored_pixel(&c.surface, x, y) & 0xFFFFFF, 0x10000u + (n & 3));
            }
        }
    }
    canvas_free(&c);
}

/*
 * A small triangle from -repeats to repeats of a clamped texture, with and without perspective:
 * where a coordinate is below 0 or above 1 its texel is the first or the last. Such a triangle is
 * drawn as a large one, whose coordinates lose 13 bits and more of 16000 repeats.
 */
TEST(thousands_of_clamped_repeats)
{
    enum { SIDE_LOG2_MAX = 6 };
    static uint32_t places[1 << (2 * SIDE_LOG2_MAX)];
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (uint32_t i = 0; i < LENGTH_OF(places); i++) {
        places[i] = 0x10000 + i;
    }
    for (int n = 0; n < 40; n++) {
        static const uint8_t sides_log2[4] = {0, 1, 4, SIDE_LOG2_MAX};
        const uint8_t side_log2 = sides_log2[n % 4];
        const int32_t repeats = 1000 << n / 8, last = (1 << side_log2) - 1;
        qtri_texture t = {.texels = places,
                          .format = &qtri_texel_xrgb8888,
                          .width_log2 = side_log2,
                          .height_log2 = side_log2,
                          .wrap_u = QTRI_CLAMP,
                          .wrap_v = QTRI_CLAMP};
        qtri_vec2 uvs[3];
        for (int i = 0; i < 3; i++) {
            uvs[i].x = (i == 1 ? repeats : -repeats) * Q16_ONE;
            uvs[i].y = (i == 2 ? repeats : -repeats) * Q16_ONE;
        }
        draw_small(&c, &t, uvs, n / 4 % 2 == 0 ? QTRI_SCREEN_LINEAR : QTRI_PERSPECTIVE);
        for (int32_t y = LEFT; y < LEFT + LEG; y++) {
            for (int32_t x = LEFT; x + y < 2 * LEFT + LEG - 1; x++) {
                const int32_t index =
                    (int32_t)(stored_pixel(&c.surface, x, y) & 0xFFFFFF) - 0x10000;
                const int32_t middle = LEFT + LEG / 2; /* coordinates are 0 there */
                assert_int_equal(index & last, x < middle ? 0 : last);
                assert_int_equal(index >> side_log2, y < middle ? 0 : last);
            }
        }
    }
    canvas_free(&c);
}

enum { ENDED_PIXELS = 160 };

/* A triangle of a mesh in a view of 90 degrees: on the screen, with 1/w and u in texels. */
typedef struct ended {
    qtri_vec3 positions[3];
    qtri_vec2 uvs[3];
    double x[3], y[3], q[3], u[3];
} ended;

/* A random number from 0 to 1. */
static double random_part(uint64_t *seed)
{
    return random_in(seed, 0, 1 << 20) / (double)(1 << 20);
}

/* Within `reach` pixels; w from 2 to 2 and `steep` of that; vertices mostly at ends in u. */
static void random_ended(ended *t, uint64_t *seed, double reach, double steep, int texels)
{
    const double middle = ENDED_PIXELS / 2.;
    for (int i = 0; i < 3; i++) {
        const double w = 2 * (1 + steep * random_part(seed));
        const double x = reach * (random_part(seed) - .5), y = reach * (random_part(seed) - .5);
        const int32_t end = random_in(seed, 0, 3);
        qtri_vec3 *p = &t->positions[i];
        p->x = (q16)floor(x * w / middle * 65536);
        p->y = (q16)floor(y * w / middle * 65536);
        p->z = (q16)-floor(w * 65536);
        t->uvs[i].x = end < 2 ? end << 16 : random_in(seed, 0, 65536);
        t->uvs[i].y = random_in(seed, 0, 65536);
        t->q[i] = -65536. / p->z;
        t->x[i] = middle + p->x / 65536. * t->q[i] * middle;
        t->y[i] = middle - p->y / 65536. * t->q[i] * middle;
        t->u[i] = t->uvs[i].x / 65536. * texels;
    }
}

/* The coordinate at a point of the screen. */
static double ended_u(const ended *t, double x, double y)
{
    double above = 0, below = 0;
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        const double weight = (t->x[a] - x) * (t->y[b] - y) - (t->x[b] - x) * (t->y[a] - y);
        above += weight * t->q[i] * t->u[i];
        below += weight * t->q[i];
    }
    return above / below;
}

/* Where vertices are snapped to changes what it shows. */
static bool is_needle(const ended *t)
{
    return fabs((t->x[1] - t->x[0]) * (t->y[2] - t->y[0]) -
                (t->x[2] - t->x[0]) * (t->y[1] - t->y[0])) < 1;
}

/* How many texels a pixel's texel is off, less 1/64 of what a pixel steps. */
static double ended_off(const ended *t, double x, double y, int index, int texels)
{
    const double u = ended_u(t, x, y);
    const double slope = fmax(fabs(ended_u(t, x + 1, y) - u), fabs(ended_u(t, x, y + 1) - u));
    const double off = outside_clamped(u, index, texels);
    assert_true(off < texels / 2.);
    return is_needle(t) ? 0 : off - slope / 64;
}

/*
 * Triangles of a clamped texture, most of whose vertices lie at its ends: no pixel shows the other
 * end, and but for needles each is near its texel. Small and large, level and steep.
 */
TEST(pixels_at_an_end_show_it)
{
    static uint8_t columns[3][128 * 128]; /* number + 1 */
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    canvas c = canvas_new(&qtri_gray8, ENDED_PIXELS, ENDED_PIXELS);
    uint64_t seed = 913;
    double worst = 0;
    qtri_material material = plain_material();
    qtri_view view;
    qtri_transform pose;
    for (int i = 0; i < 3 * 128 * 128; i++) {
        const int k = i / (128 * 128);
        columns[k][i % (128 * 128)] = (uint8_t)(1 + i % (8 << 2 * k));
    }
    qtri_view_init(&view, ENDED_PIXELS, ENDED_PIXELS);
    qtri_transform_perspective(&view.projection, Q16(90), Q16(1), Q16(.5), Q16(50));
    qtri_transform_identity(&pose);
    material.texture_mode = QTRI_REPLACE;
    for (int n = 0; n < 12000; n++) {
        const int log2 = 3 + 2 * (n % 3);
        const qtri_texture texture = {.texels = columns[n % 3],
                                      .format = &qtri_texel_gray8,
                                      .width_log2 = (uint8_t)log2,
                                      .height_log2 = (uint8_t)log2,
                                      .wrap_u = QTRI_CLAMP,
                                      .wrap_v = (qtri_wrap)(n & 1)};
        ended t;
        random_ended(&t, &seed, pow(2, 1 + 6.3 * random_part(&seed)),
                     n % 5 == 0 ? 0 : random_part(&seed), 1 << log2);
        const qtri_mesh mesh = {.positions = t.positions,
                                .uvs = t.uvs,
                                .triangles = triangle,
                                .vertex_count = 3,
                                .triangle_count = 1};
        material.texture = &texture;
        canvas_clear(&c);
        qtri_draw_mesh(&c.surface, &view, &pose, &mesh, &material);
        for (int32_t i = 0; i < ENDED_PIXELS * ENDED_PIXELS; i++) {
            const int32_t x = i % ENDED_PIXELS, y = i / ENDED_PIXELS;
            const int shown = (int)stored_pixel(&c.surface, x, y);
            if (shown != 0) {
                worst = fmax(worst, ended_off(&t, x + .5, y + .5, shown - 1, 1 << log2));
            }
        }
    }
    print_message("at ends off by %.3f texel and 1/64 of a step\n", worst);
    assert_true(worst < .1);
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
