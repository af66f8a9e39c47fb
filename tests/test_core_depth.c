/* SPDX-License-Identifier: MIT */
/*
 * Formats of depth: what they store, which pixels pass, and that nothing else changes.
 */
#include "support/core.h"
#include "support/layouts.h"

#include "frame/depth_format.h"
#include "frame/pixel.h"
#include "qtri/body/large.h"

enum { WIDTH = 70, HEIGHT = 52, FORMATS = 3, GUARD = 16 };

#define FARTHEST 0xFFFF0000u

static const qtri_depth_format *const formats[FORMATS] = {&qtri_depth_float16, &qtri_depth_linear24,
                                                          &qtri_depth_linear32};

/* What linear16 stores, as a format of the application's own. */
static void encode_twin(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] = (depth[i] + 0x8000) >> 16;
    }
}

static void decode_twin(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] <<= 16;
    }
}

static const qtri_depth_format twin = {2, &qtri_depth_words, encode_twin, decode_twin, 0, NULL};

/* ---- Surfaces in guarded memory ---- */

typedef struct board {
    qtri_surface surface;
    uint8_t *memory;
    size_t bytes;
} board;

static board board_band(const qtri_format *format, const qtri_depth_format *depth, int32_t first,
                        int32_t rows)
{
    board b;
    b.bytes = QTRI_BAND_BYTES_DEPTH(WIDTH, rows, format->pixels->bytes,
                                    depth != NULL ? depth->bytes : QTRI_DEPTH_LINEAR16_BYTES);
    b.memory = malloc(b.bytes + 2 * GUARD);
    assert_non_null(b.memory);
    memset(b.memory, 0xA5, b.bytes + 2 * GUARD);
    assert_ok(surface_with_depth(&b.surface, format, depth, WIDTH, HEIGHT, first, rows,
                                 b.memory + GUARD, b.bytes));
    qtri_surface_clear(&b.surface, (qtri_rgb){24, 32, 48});
    return b;
}

static board board_new(const qtri_format *format, const qtri_depth_format *depth)
{
    return board_band(format, depth, 0, HEIGHT);
}

static void board_free(board *b)
{
    for (size_t i = 0; i < GUARD; i++) {
        assert_int_equal(b->memory[i], 0xA5);
        assert_int_equal(b->memory[GUARD + b->bytes + i], 0xA5);
    }
    free(b->memory);
}

static int32_t bytes_of(const qtri_surface *s)
{
    return s->depth_format != NULL ? s->depth_format->bytes : 2;
}

static uint32_t code_at(const qtri_surface *s, int32_t x, int32_t y)
{
    const int32_t bytes = bytes_of(s);
    const uint8_t *at =
        (const uint8_t *)s->depth + bytes * ((ptrdiff_t)(y - s->first_row) * s->depth_pitch + x);
    uint16_t half;
    uint32_t word;
    switch (bytes) {
    case 2:
        memcpy(&half, at, 2);
        return half;
    case 3:
        return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    default:
        memcpy(&word, at, 4);
        return word;
    }
}

static void assert_same(const qtri_surface *a, const qtri_surface *b)
{
    const int32_t first = b->first_row;
    for (int32_t y = first; y < first + b->rows; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            assert_int_equal(stored_pixel(a, x, y), stored_pixel(b, x, y));
            assert_int_equal(code_at(a, x, y), code_at(b, x, y));
        }
    }
}

static uint32_t encoded(const qtri_depth_format *format, uint32_t depth)
{
    format->encode(&depth, 1);
    return depth;
}

static uint32_t decoded(const qtri_depth_format *format, uint32_t code)
{
    format->decode(&code, 1);
    return code;
}

/* ---- Scenes of everything that has depth ---- */

static uint16_t texels[16 * 16];
static qtri_vec3 positions[QTRI_SPHERE_VERTICES(12, 8)];
static qtri_normal normals[QTRI_SPHERE_VERTICES(12, 8)];
static uint16_t triangles[QTRI_SPHERE_TRIANGLES(12, 8)][3];
static qtri_mesh ball;

static int set_up(void **state)
{
    (void)state;
    uint64_t seed = 4;
    const qtri_shape_memory memory = {
        positions, normals, NULL, triangles, LENGTH_OF(positions), LENGTH_OF(triangles)};
    for (size_t i = 0; i < LENGTH_OF(texels); i++) {
        texels[i] = (uint16_t)random_in(&seed, 0, 5);
    }
    return qtri_shape_sphere(&ball, &memory, Q16(1), 12, 8) == QTRI_OK ? 0 : -1;
}

static qtri_screen_vertex random_vertex(uint64_t *seed, int32_t x, int32_t y, int32_t reach)
{
    qtri_screen_vertex v = {.x_24p8 = x + random_in(seed, -reach, reach),
                            .y_24p8 = y + random_in(seed, -reach, reach),
                            .inv_w_q31 = (uint32_t)random_in(seed, 1 << 29, INT32_MAX),
                            .inv_w_exponent = 3,
                            .u_q32 = random_in(seed, -65536, 65536) * INT64_C(65536),
                            .v_q32 = random_in(seed, -65536, 65536) * INT64_C(65536)};
    /* In a slab, or anywhere, or beside the planes. */
    const uint32_t far = (uint32_t)random64(seed) & ~0xFFu;
    v.depth_16p16 = random_in(seed, 0, 3) != 0 ? 0x80000000u + (far >> 8 & ~0xFFu) : far;
    if (random_in(seed, 0, 9) == 0) {
        v.depth_16p16 = random_flag(seed) ? 0 : FARTHEST;
    }
    for (int i = 0; i < 3; i++) {
        v.color_8p16[i] = random_in(seed, 0, 255 << 16);
    }
    return v;
}

static qtri_material random_material(uint64_t *seed, const qtri_texture *texture,
                                     const qtri_fog *fog)
{
    static const qtri_blend *const blends[] = {&qtri_blend_alpha, &qtri_blend_add,
                                               &qtri_blend_screen_door};
    qtri_material m = qtri_material_default();
    m.color = (qtri_rgb){(uint8_t)random_in(seed, 0, 255), 200, 90};
    m.cull = QTRI_CULL_NONE;
    m.shading = random_flag(seed) ? QTRI_SMOOTH : QTRI_FLAT_FIRST;
    m.depth_compare = random_flag(seed) ? QTRI_LESS : (qtri_compare)random_in(seed, 0, 8);
    m.depth_read_only = random_in(seed, 0, 4) == 0;
    m.texture = random_in(seed, 0, 2) == 0 ? texture : NULL;
    m.fog = random_in(seed, 0, 5) == 0 ? fog : NULL;
    m.alpha = 150;
    if (random_in(seed, 0, 4) == 0) {
        m.blend = blends[random_in(seed, 0, 2)];
    }
    return m;
}

/* `smooth`: also lines whose depth linear16 has in fewer bits than others. */
static void draw_scene(const qtri_surface *s, uint64_t seed, bool smooth)
{
    const qtri_texture texture = {.texels = texels,
                                  .format = &qtri_texel_rgb565,
                                  .width_log2 = 4,
                                  .height_log2 = 4,
                                  .has_key = (seed & 1) != 0,
                                  .key = 2,
                                  .filter = (seed & 2) != 0 ? &qtri_bilinear : NULL};
    const qtri_fog_range range = {Q16(1), Q16(9), false};
    qtri_fog fog;
    qtri_fog_linear(&fog, (qtri_rgb){90, 90, 120}, range, Q16(2), Q16(8));
    qtri_vertex vertices[LENGTH_OF(positions)];
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_perspective(&view.projection, Q16(60), Q16(1.3), Q16(1), Q16(9));
    give_vertices(&view, vertices, LENGTH_OF(vertices));
    for (int n = 0; n < 9; n++) {
        const qtri_material m = random_material(&seed, &texture, &fog);
        qtri_stroke stroke = qtri_stroke_default();
        qtri_screen_vertex v[5];
        const int32_t reach = random_flag(&seed) ? 1500 : 20000;
        const int32_t x = random_in(&seed, 0, WIDTH * 256);
        const int32_t y = random_in(&seed, 0, HEIGHT * 256);
        const int what = random_in(&seed, 0, 9);
        for (size_t i = 0; i < LENGTH_OF(v); i++) {
            v[i] = random_vertex(&seed, x, y, reach);
        }
        stroke.width = random_in(&seed, 0, Q16(7));
        stroke.edges = random_flag(&seed) ? NULL : stroke.edges;
        if (what < 4) {
            qtri_raster_triangle(s, qtri_pipelines_default, &m, v);
        } else if (what == 4) {
            qtri_raster_line(s, &m, v);
        } else if (what == 5) {
            qtri_raster_polyline(s, &m, &stroke, v, LENGTH_OF(v));
        } else if (what == 6) {
            qtri_raster_point(s, &m, &stroke, v);
        } else {
            qtri_transform pose;
            qtri_material of_mesh = m;
            of_mesh.texture = NULL;
            of_mesh.fill = what == 8 ? &qtri_wireframe : NULL;
            if (what == 9 && smooth) {
                of_mesh.fill = &qtri_smooth_wireframe;
            }
            qtri_transform_identity(&pose);
            const qtri_vec3 at = {random_in(&seed, -Q16(2), Q16(2)),
                                  random_in(&seed, -Q16(1), Q16(1)),
                                  random_in(&seed, -Q16(9), -Q16(1))};
            qtri_transform_translate(&pose, at);
            qtri_draw_mesh(s, &view, &pose, &ball, &of_mesh);
        }
    }
}

/* ---- Tests ---- */

/* Codes keep the order of depths, and come back within half a step, or a step, of them. */
TEST(codes)
{
    uint64_t seed = 1;
    for (int f = 0; f < FORMATS; f++) {
        const qtri_depth_format *format = formats[f];
        const uint32_t most = format->bytes == 4 ? UINT32_MAX : (1u << 8 * format->bytes) - 1;
        assert_int_equal(encoded(format, 0), 0);
        assert_true(encoded(format, FARTHEST) <= most);
        assert_true(decoded(format, encoded(format, FARTHEST)) == FARTHEST);
        for (int n = 0; n < random_cases(60000); n++) {
            const uint32_t t = (uint32_t)random64(&seed) >> random_in(&seed, 0, 31);
            const uint32_t depth = t > FARTHEST ? 0 : FARTHEST - t;
            const uint64_t more = (uint64_t)random_in(&seed, 0, 1 << random_in(&seed, 0, 20));
            const uint32_t next = depth + more > FARTHEST ? FARTHEST : (uint32_t)(depth + more);
            const uint32_t code = encoded(format, depth);
            assert_true(code <= most);
            assert_true(encoded(format, next) >= code);
            assert_int_equal(encoded(format, decoded(format, code)), code);
            const double off = fabs((double)decoded(format, code) - depth);
            /* The ends of float16 stand for themselves, whose halves are 2^4 and 2^18. */
            const double half = f == 0 ? fmax(16, (FARTHEST - depth) / 8192.0) : (f == 1 ? 128 : 0);
            const bool is_end = f == 0 && (code == 0 || code == most);
            assert_true(off <= (is_end ? 2 * half : half));
        }
    }
    for (uint32_t code = 0; code < 65536; code++) { /* all are used */
        assert_int_equal(encoded(&qtri_depth_float16, decoded(&qtri_depth_float16, code)), code);
        assert_int_equal(encoded(&qtri_depth_linear16, decoded(&qtri_depth_linear16, code)), code);
    }
}

/* As many are encoded and decoded as there are, each as alone; what lies behind them stays. */
TEST(counts)
{
    static const qtri_depth_format *const all[] = {&qtri_depth_linear16, &qtri_depth_float16,
                                                   &qtri_depth_linear24, &qtri_depth_linear32};
    enum { BEHIND = 4, MOST = 32 };
    uint64_t seed = 14;
    for (size_t f = 0; f < sizeof all / sizeof *all; f++) {
        for (int32_t count = 1; count <= MOST; count++) {
            uint32_t depth[MOST + BEHIND], code[MOST + BEHIND];
            uint32_t back[MOST + BEHIND];
            for (int32_t i = 0; i < MOST + BEHIND; i++) {
                depth[i] = (uint32_t)random64(&seed) % FARTHEST | 1; /* no format's code or step */
            }
            memcpy(code, depth, sizeof code);
            all[f]->encode(code, count);
            memcpy(back, code, sizeof back);
            all[f]->decode(back, count);
            for (int32_t i = 0; i < MOST + BEHIND; i++) {
                const bool in = i < count;
                assert_int_equal(code[i], in ? encoded(all[f], depth[i]) : depth[i]);
                assert_int_equal(back[i], in ? decoded(all[f], code[i]) : depth[i]);
            }
        }
    }
}

/* The codes of linear16, as a format of the application's own, draw and leave what linear16 does,
   bit for bit. */
TEST(twins)
{
    for (uint64_t n = 0; n < (uint64_t)random_cases(500); n++) {
        board with = board_new(drawn_format((int32_t)n), NULL);
        board same = board_new(drawn_format((int32_t)n), &twin);
        draw_scene(&with.surface, n * 7919 + 3, false);
        draw_scene(&same.surface, n * 7919 + 3, false);
        assert_same(&with.surface, &same.surface);
        board_free(&with);
        board_free(&same);
    }
}

/* Loops over rows draw and leave what depths do that are encoded one by one, bit for bit. */
TEST(loops)
{
    for (uint64_t n = 0; n < (uint64_t)random_cases(450); n++) {
        const qtri_depth_format *format = formats[n % FORMATS];
        qtri_depth_format plain = *format;
        plain.kind = QTRI_OTHER_DEPTH;
        board with = board_new(drawn_format((int32_t)(n / FORMATS)), format);
        board same = board_new(drawn_format((int32_t)(n / FORMATS)), &plain);
        draw_scene(&with.surface, n * 7919 + 5, true);
        draw_scene(&same.surface, n * 7919 + 5, true);
        assert_same(&with.surface, &same.surface);
        board_free(&with);
        board_free(&same);
    }
}

/* Smooth lines one by one, of even depth: linear16 has that of others in fewer bits. */
TEST(smooth_lines)
{
    static const uint16_t two[2][3] = {{0, 1, 2}, {0, 2, 3}};
    qtri_vertex vertices[4];
    for (int n = 0; n < 40; n++) {
        uint64_t seed = (uint64_t)n;
        qtri_vec3 corner[4];
        for (int i = 0; i < 4; i++) {
            corner[i].x = random_in(&seed, -Q16(1), Q16(1));
            corner[i].y = random_in(&seed, -Q16(1), Q16(1));
            corner[i].z = 0;
        }
        const qtri_mesh mesh = {
            .positions = corner, .triangles = two, .vertex_count = 4, .triangle_count = 2};
        const qtri_format *format = drawn_format(n);
        board b[2] = {board_new(format, NULL), board_new(format, &twin)};
        qtri_view view;
        qtri_transform pose;
        qtri_stroke stroke = qtri_stroke_default();
        qtri_material m = qtri_material_default();
        stroke.cap = n % 2 != 0 ? QTRI_CAP_BUTT : QTRI_CAP_SQUARE;
        stroke.width = random_in(&seed, Q16(.3), Q16(2));
        m.cull = QTRI_CULL_NONE;
        m.depth_read_only = n % 5 == 0;
        start_view(&view, &pose, WIDTH, HEIGHT);
        give_vertices(&view, vertices, LENGTH_OF(vertices));
        for (int i = 0; i < 2; i++) {
            qtri_draw_wide_wireframe(&b[i].surface, &view, &pose, &mesh, &stroke, &m);
        }
        assert_same(&b[0].surface, &b[1].surface);
        board_free(&b[0]);
        board_free(&b[1]);
    }
}

static bool model_passes(qtri_compare compare, uint32_t depth, uint32_t stored)
{
    switch (compare) {
    case QTRI_NEVER:
        return false;
    case QTRI_LESS:
        return depth < stored;
    case QTRI_EQUAL:
        return depth == stored;
    case QTRI_LESS_EQUAL:
        return depth <= stored;
    case QTRI_GREATER:
        return depth > stored;
    case QTRI_NOT_EQUAL:
        return depth != stored;
    case QTRI_GREATER_EQUAL:
        return depth >= stored;
    default:
        return true;
    }
}

/* Where pixels find the comparison: of depths of 24 bits, and of more. */
TEST(any_comparison_of_stored_depths)
{
    static const uint32_t ends[] = {0,        1,         0x7FFF,     0x8000,
                                    0xFFFE,   0xFFFF,    0x800000,   0xFFFFFE,
                                    0xFFFFFF, 0x1000000, 0x80000000, UINT32_MAX};
    for (uint32_t number = QTRI_NEVER; number <= QTRI_ALWAYS; number++) {
        const qtri_compare compare = (qtri_compare)number;
        for (size_t i = 0; i < LENGTH_OF(ends) * LENGTH_OF(ends); i++) {
            const uint32_t z = ends[i / LENGTH_OF(ends)], stored = ends[i % LENGTH_OF(ends)];
            const uint8_t depth = (z | stored) >> 24 == 0 ? QTRI_LINEAR24 : QTRI_LINEAR32;
            const qtri_options o = {.depth = depth, .compare = QTRI_ANY};
            qtri_pixel_walk walk = {.pixel = NULL};
            qtri_walk_set_compare(&o, &walk, number - QTRI_NEVER);
            assert_int_equal(qtri_depth_passes(&o, &walk, z, stored),
                             model_passes(compare, z, stored));
        }
    }
}

/* What is level, over what was there, by every comparison, numbers that are none among them: shapes
   over the pixel in the middle. */
TEST(comparisons)
{
    static const uint32_t depths[] = {0,
                                      1u << 8,
                                      1u << 16,
                                      7u << 20,
                                      0x7FFF0000u,
                                      0x7FFFFF00u,
                                      0x80000000u,
                                      0x80000100u,
                                      FARTHEST - (1u << 16),
                                      FARTHEST - 256,
                                      FARTHEST};
    enum { DEPTHS = LENGTH_OF(depths), COMPARES = QTRI_ALWAYS + 3, SHAPES = 6 };
    static const struct {
        const qtri_format *pixels;
        const qtri_depth_format *depth;
    } surfaces[] = {{&qtri_xrgb8888, &qtri_depth_float16},  {&qtri_xrgb8888, &qtri_depth_linear24},
                    {&qtri_xrgb8888, &qtri_depth_linear32}, {&qtri_xrgb8888, &qtri_depth_linear16},
                    {&qtri_rgb565, &qtri_depth_linear16},   {&qtri_gray8, &qtri_depth_linear16}};
    for (size_t f = 0; f < LENGTH_OF(surfaces); f++) {
        const qtri_depth_format *format = surfaces[f].depth;
        board b = board_new(surfaces[f].pixels, format);
        for (int n = 0; n < DEPTHS * DEPTHS * COMPARES * SHAPES * 2; n++) {
            const uint32_t stored = depths[n % DEPTHS];
            const uint32_t depth = depths[n / DEPTHS % DEPTHS];
            qtri_material m = qtri_material_default();
            m.depth_compare = (qtri_compare)(n / DEPTHS / DEPTHS % COMPARES);
            const int shape = n / DEPTHS / DEPTHS / COMPARES % SHAPES;
            m.depth_read_only = n / DEPTHS / DEPTHS / COMPARES / SHAPES != 0;
            m.cull = QTRI_CULL_NONE;
            qtri_stroke stroke = qtri_stroke_default();
            stroke.width = Q16(6);
            stroke.edges = shape == 4 ? NULL : stroke.edges;
            const int32_t size = shape == 0 ? 4 * 256 : 150 * 256;
            const int32_t x = 30 * 256;
            const int32_t y = 20 * 256 + 128;
            qtri_screen_vertex v[3] = {{.x_24p8 = x - size, .y_24p8 = y - (shape > 1 ? 0 : size)},
                                       {.x_24p8 = x + size, .y_24p8 = y - (shape > 1 ? 0 : size)},
                                       {.x_24p8 = x, .y_24p8 = y + size}};
            for (int pass = 0; pass < 2; pass++) {
                for (int i = 0; i < 3; i++) {
                    v[i].depth_16p16 = pass == 0 ? stored : depth;
                    v[i].inv_w_q31 = 1u << 30;
                    v[i].color_8p16[0] = v[i].color_8p16[1] = v[i].color_8p16[2] =
                        pass * (255 << 16);
                }
                if (pass == 0) { /* everywhere around */
                    qtri_surface around = b.surface;
                    around.scissor = (qtri_rect){28, 18, 33, 23};
                    const qtri_material first = {.depth_compare = QTRI_ALWAYS};
                    const qtri_screen_vertex all[3] = {
                        {-999999, -999999, stored, 1u << 30, 0, {0}, 0, 0},
                        {999999, -999999, stored, 1u << 30, 0, {0}, 0, 0},
                        {0, 999999, stored, 1u << 30, 0, {0}, 0, 0}};
                    qtri_raster_triangle(&around, qtri_pipelines_default, &first, all);
                } else if (shape < 2) {
                    qtri_raster_triangle(&b.surface, qtri_pipelines_default, &m, v);
                } else if (shape == 2) {
                    qtri_raster_line(&b.surface, &m, v);
                } else if (shape == 5) {
                    qtri_raster_point(&b.surface, &m, &stroke, &v[2]);
                } else {
                    qtri_raster_polyline(&b.surface, &m, &stroke, v, 2);
                }
            }
            const int32_t row = shape == 5 ? HEIGHT - 1 : 20;
            if (shape == 5) {
                continue; /* its middle is below: drawn for what it may touch alone */
            }
            const uint32_t below = encoded(format, stored);
            const uint32_t above = encoded(format, depth);
            const bool off = m.depth_compare == QTRI_DEPTH_OFF;
            const bool drawn = off || model_passes(m.depth_compare, above, below);
            const uint32_t left = drawn && !off && !m.depth_read_only ? above : below;
            assert_int_equal(qtri_surface_pixel(&b.surface, 30, row).r, drawn ? 255 : 0);
            assert_int_equal(code_at(&b.surface, 30, row), left);
        }
        board_free(&b);
    }
}

/* How far stored depths are from the triangle's plane, in steps of linear16. */
TEST(planes)
{
    uint64_t seed = 15;
    for (int f = 0; f < FORMATS; f++) {
        board b = board_new(&qtri_gray8, formats[f]);
        double worst = 0;
        int pixels = 0;
        for (int n = 0; n < random_cases(1500); n++) {
            const qtri_material m = {.depth_compare = QTRI_ALWAYS};
            const int32_t reach = n % 2 != 0 ? 2500 : 30000;
            qtri_screen_vertex v[3];
            double x[3];
            double y[3];
            double z[3];
            for (int i = 0; i < 3; i++) {
                v[i] = random_vertex(&seed, 9000, 6000, reach);
                /* Of little range, as what is far away has. */
                v[i].depth_16p16 = 0xF0000000u + ((uint32_t)random_in(&seed, 0, 1 << 13) << 8);
                x[i] = v[i].x_24p8 / 256.0;
                y[i] = v[i].y_24p8 / 256.0;
                z[i] = v[i].depth_16p16 / 65536.0;
            }
            const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
            if (fabs(area) < (reach == 2500 ? 8 : 400)) {
                continue; /* slivers */
            }
            qtri_surface_clear_depth(&b.surface, 0);
            qtri_raster_triangle(&b.surface, qtri_pipelines_default, &m, v);
            for (int i = 0; i < WIDTH * HEIGHT; i += 7) {
                const double dx = i % WIDTH + .5 - x[0];
                const int32_t row = i / WIDTH;
                const double dy = row + .5 - y[0];
                const uint32_t code = code_at(&b.surface, i % WIDTH, i / WIDTH);
                if (code == encoded(formats[f], 0)) {
                    continue;
                }
                const double b1 = (dx * (y[2] - y[0]) - (x[2] - x[0]) * dy) / area;
                const double b2 = ((x[1] - x[0]) * dy - dx * (y[1] - y[0])) / area;
                const double plane = z[0] + b1 * (z[1] - z[0]) + b2 * (z[2] - z[0]);
                worst = fmax(worst, fabs(decoded(formats[f], code) / 65536.0 - plane));
                pixels++;
            }
        }
        assert_true(pixels > 20000);
        print_message("format %d: within %.4f of a step of linear16\n", f, worst);
        /* 1 - z is 2^28 at most: half a step of 2^-12 of it is half of one of linear16. */
        assert_true(worst <= (f == 0 ? .55 : .05));
        board_free(&b);
    }
}

/*
 * A slope of few of the finest steps, rounded to a whole one, leads beyond the last vertex's depth,
 * and that is the farthest, or 0: depths are clamped to it, in one colour as in many, by the row as
 * one by one, and stray from the plane by half a step a pixel.
 */
TEST(ends_of_depths)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    qtri_depth_format one_by_one = qtri_depth_linear32;
    one_by_one.kind = QTRI_OTHER_DEPTH;
    board b = board_new(&qtri_gray8, &qtri_depth_linear32);
    const qtri_material m = {.depth_compare = QTRI_ALWAYS};
    int held = 0;
    for (uint32_t range = 1; range < 3000; range += 9) {
        const bool is_near = range % 2 == 0;
        const int32_t other = (range & 4) != 0 ? 9 : 255;
        const uint32_t to = is_near ? 0 : farthest;
        const uint32_t from = is_near ? range : farthest - range;
        qtri_screen_vertex v[3] = {screen_at(128, 128), screen_at(WIDTH * 256, 128),
                                   screen_at(WIDTH * 256, 128 + 40 * 256)};
        v[0].depth_16p16 = from;
        v[1].depth_16p16 = v[2].depth_16p16 = to;
        v[1].color_8p16[0] = other * 65536;
        b.surface.depth_format = (range & 8) != 0 ? &qtri_depth_linear32 : &one_by_one;
        qtri_surface_clear_depth(&b.surface, Q16(.5));
        const uint32_t clear = code_at(&b.surface, 0, HEIGHT - 1);
        qtri_raster_triangle(&b.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t depth = code_at(&b.surface, i % WIDTH, i / WIDTH);
            if (depth == clear) {
                continue;
            }
            const double off = fabs((double)depth - from);
            assert_near(off, (double)range * (i % WIDTH) / (WIDTH - .5), WIDTH / 2 + 1);
            assert_true(depth <= farthest);
            held += depth == to;
        }
    }
    assert_true(held > 10000);
    board_free(&b);
}

/* Sizes, errors, clearing: inside of the scissor alone, of any pitch. */
TEST(layouts)
{
    static uint8_t memory[QTRI_BAND_BYTES_DEPTH(WIDTH, HEIGHT, 4, 4)];
    qtri_surface s;
    for (int f = 0; f < FORMATS; f++) {
        const size_t bytes = QTRI_BAND_BYTES_DEPTH(9, 5, 2, formats[f]->bytes);
        assert_int_equal(
            surface_with_depth(&s, &qtri_rgb565, formats[f], 9, 9, 0, 5, memory, bytes - 6),
            QTRI_ERROR_MEMORY);
        assert_null(s.format);
        assert_int_equal(
            surface_with_depth(&s, &qtri_rgb565_x4, formats[f], 9, 9, 0, 5, memory, 9999),
            QTRI_ERROR_FORMAT);
        assert_int_equal(surface_with_depth(&s, NULL, formats[f], 9, 9, 0, 5, memory, 9999),
                         QTRI_ERROR_FORMAT);
        for (int pitch = 9; pitch >= -12; pitch -= 21) {
            static const q16 depths[] = {0, Q16(.25), Q16_ONE, INT32_MAX, INT32_MIN};
            assert_ok(surface_with_depth(&s, &qtri_rgb565, formats[f], 9, 9, 0, 5, memory,
                                         sizeof memory));
            if (pitch < 0) {
                s.depth = (uint16_t *)(void *)(memory + sizeof memory / 2);
                s.depth_pitch = pitch;
            }
            for (size_t d = 0; d < LENGTH_OF(depths); d++) {
                const qtri_rect part = {2, 1, 7, 4};
                const qtri_rect all = {0, 0, 9, 9};
                s.scissor = all;
                qtri_surface_clear(&s, (qtri_rgb){1, 2, 3});
                s.scissor = part;
                qtri_surface_clear_depth(&s, depths[d]);
                const uint32_t held =
                    (uint32_t)(depths[d] < 0 ? 0 : (depths[d] > Q16_ONE ? Q16_ONE : depths[d]));
                for (int i = 0; i < 45; i++) {
                    const bool in = i % 9 >= 2 && i % 9 < 7 && i / 9 >= 1 && i / 9 < 4;
                    assert_int_equal(code_at(&s, i % 9, i / 9),
                                     encoded(formats[f], in ? held * 65535u : FARTHEST));
                }
            }
        }
        /* Samples keep linear16: by hand put together, nothing is drawn. */
        assert_ok(qtri_surface_init(&s, &qtri_rgb565_x4, 9, 9, 0, 9, memory, sizeof memory));
        qtri_samples_clear(&s, (qtri_rgb){0, 0, 0});
        s.depth_format = formats[f];
        uint64_t seed = 3;
        const qtri_material m = qtri_material_default();
        for (int n = 0; n < 20; n++) {
            const qtri_screen_vertex v[3] = {random_vertex(&seed, 999, 999, 3000),
                                             random_vertex(&seed, 999, 999, 3000),
                                             random_vertex(&seed, 999, 999, 3000)};
            qtri_raster_triangle(&s, qtri_pipelines_default, &m, v);
        }
        for (int i = 0; i < 81 * QTRI_RGB565_X4_BYTES; i += QTRI_RGB565_X4_BYTES) {
            assert_int_equal(s.pixels[i], 0);
        }
    }
    const qtri_depth_format one_byte = {1, &qtri_depth_words, encode_twin, decode_twin, 0, NULL};
    assert_int_equal(surface_with_depth(&s, &qtri_rgb565, &one_byte, 9, 9, 0, 5, memory, 9999),
                     QTRI_ERROR_FORMAT);
    assert_ok(surface_with_depth(&s, &qtri_rgb565, &qtri_depth_linear16, 9, 9, 0, 5, memory,
                                 sizeof memory));
    qtri_surface_clear(&s, (qtri_rgb){0, 0, 0});
    assert_int_equal(s.depth[44], UINT16_MAX);
}

/* Frames lay out bands with depth of any format, in one buffer and in two. */
TEST(frames)
{
    enum { ROWS = 12, OVERLAP = 2 };
    static uint8_t memory[QTRI_FRAME_BYTES_DOUBLE_DEPTH(WIDTH, ROWS + 2 * OVERLAP, 4, 4)];
    for (int n = 0; n < FORMATS * 8; n++) {
        const qtri_format *format = drawn_format(n);
        const qtri_depth_format *depth = formats[n % FORMATS];
        const int32_t bytes = format->pixels->bytes;
        const bool twice = n % 2 != 0;
        const bool overlaps = n % 4 > 1;
        const int32_t rows = overlaps ? ROWS + 2 * OVERLAP : ROWS;
        const size_t size = twice ? QTRI_FRAME_BYTES_DOUBLE_DEPTH(WIDTH, rows, bytes, depth->bytes)
                                  : QTRI_FRAME_BYTES_DEPTH(WIDTH, rows, bytes, depth->bytes);
        board whole = board_new(format, depth);
        draw_scene(&whole.surface, (uint64_t)n, true);
        qtri_frame frame;
        uint8_t *end = memory + size;
        *end = 0x5A;
        for (size_t less = 2; less-- > 0;) {
            const int32_t overlap = overlaps ? OVERLAP : 0;
            const enum qtri_error error = less > 0 && !twice ? QTRI_ERROR_MEMORY : QTRI_OK;
            enum qtri_error is = frame_with_overlap(&frame, format, WIDTH, HEIGHT, ROWS, overlap,
                                                    memory, size - less);
            is = is == QTRI_OK ? qtri_frame_set_depth(&frame, depth) : is;
            assert_int_equal(is, error);
        }
        assert_true((frame.other_pixels != NULL) == twice);
        qtri_surface band;
        qtri_surface shown;
        while (next_shown(&frame, &band, &shown)) {
            qtri_surface_clear(&band, (qtri_rgb){24, 32, 48});
            draw_scene(&band, (uint64_t)n, true);
            assert_same(&whole.surface, &shown);
        }
        assert_int_equal(*end, 0x5A);
        board_free(&whole);
    }
}

/* The edge pass takes linear16 from any format; the twin's edges are those of linear16. */
TEST(edges)
{
    static uint32_t outline_memory[2048];
    static uint32_t words[4096];
    static uint16_t neighbours[LENGTH_OF(triangles)][3];
    for (size_t i = 0; i < LENGTH_OF(triangles); i++) { /* a border all around: all edges count */
        neighbours[i][0] = neighbours[i][1] = neighbours[i][2] = LENGTH_OF(triangles);
    }
    for (int n = 0; n < 40; n++) {
        const qtri_format *format = drawn_format(n / 8);
        const qtri_depth_format *of[2] = {n % 8 < 4 ? NULL : formats[n % FORMATS], &twin};
        board b[2];
        for (int i = 0; i < 2; i++) {
            qtri_vertex vertices[LENGTH_OF(positions)];
            qtri_outline outline;
            qtri_edges pass;
            qtri_view view;
            qtri_transform pose;
            qtri_mesh mesh = ball;
            const qtri_material m = qtri_material_default();
            mesh.neighbours = (const uint16_t(*)[3])neighbours;
            b[i] = board_new(format, of[i]);
            qtri_view_init(&view, WIDTH, HEIGHT);
            qtri_transform_perspective(&view.projection, Q16(60), Q16(1.3), Q16(1), Q16(9));
            give_vertices(&view, vertices, LENGTH_OF(vertices));
            qtri_transform_identity(&pose);
            qtri_transform_translate(&pose, (qtri_vec3){0, 0, -Q16(3)});
            qtri_transform_rotate_x(&pose, Q16(17) * n);
            assert_ok(
                qtri_outline_init(&outline, &mesh, outline_memory, LENGTH_OF(outline_memory)));
            assert_ok(qtri_draw_mesh_outlined(&b[i].surface, &view, &pose, &m, &outline));
            if (n % 4 == 3) { /* from the last row on in memory */
                const int32_t bytes = bytes_of(&b[i].surface);
                uint8_t *depth = (uint8_t *)b[i].surface.depth;
                uint8_t row[4 * WIDTH];
                const int32_t length = bytes * WIDTH;
                for (int32_t y = 0; y < HEIGHT / 2; y++) {
                    memcpy(row, depth + y * length, (size_t)length);
                    memcpy(depth + y * length, depth + (HEIGHT - 1 - y) * length, (size_t)length);
                    memcpy(depth + (HEIGHT - 1 - y) * length, row, (size_t)length);
                }
                b[i].surface.depth = (uint16_t *)(void *)(depth + (HEIGHT - 1) * length);
                b[i].surface.depth_pitch = -WIDTH;
            }
            assert_ok(qtri_edges_begin(&pass, &b[i].surface, words, LENGTH_OF(words)));
            qtri_edges_note(&pass, &outline);
            qtri_edges_blend(&pass);
        }
        int differ = 0;
        differ += count_different(&b[0].surface, &b[1].surface);
        assert_true(n % 8 < 4 ? differ == 0 : differ < WIDTH * HEIGHT / 100);
        board_free(&b[0]);
        board_free(&b[1]);
    }
}

/* What float16 stores by a shift is what it stores of each depth; a row's runs have one exponent
   each, whichever way it goes, and together all of its pixels. */
TEST(octaves)
{
    uint64_t seed = 31;
    for (int n = 0; n < 400000; n++) {
        const uint32_t random = (uint32_t)random_in(&seed, INT32_MIN, INT32_MAX);
        const uint32_t near = random >> (n % 32), at = n % 2 == 0 ? near : ~near;
        const qtri_octave o = qtri_depth_octave(at);
        assert_true(at - o.zero < o.size && o.down != 0);
        assert_int_equal(o.base + ((at - o.zero) >> o.down),
                         qtri_depth_encode_float16(qtri_depth_of(at)));
    }
    for (int n = 0; n < 4000; n++) {
        const uint32_t from = (uint32_t)random_in(&seed, INT32_MIN, INT32_MAX) >> (n % 8);
        const uint32_t to = ~((uint32_t)random_in(&seed, INT32_MIN, INT32_MAX) >> (n / 8 % 32));
        const int32_t width = 1 + n % 97;
        const int32_t step = (int32_t)(((int64_t)to - from) / width) * (n % 2 == 0 ? 1 : -1);
        qtri_pixel_walk walk = {.z = step < 0 ? to : from, .z_step = (uint32_t)step};
        uint32_t z = walk.z;
        for (int32_t left = width; left > 0;) {
            const int32_t count = qtri_large_next_octave(&walk, left);
            assert_in_range(count, 1, left);
            for (int32_t i = 0; i < count; i++) {
                assert_int_equal(walk.octave.base + (walk.z >> walk.octave.down),
                                 qtri_depth_encode_float16(qtri_depth_of(z)));
                walk.z += walk.z_step;
                z += (uint32_t)step;
            }
            left -= count;
        }
    }
}

int main(void)
{
    return run_all_tests(set_up, NULL);
}
