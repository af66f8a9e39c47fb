/* SPDX-License-Identifier: MIT */
/*
 * Triangles and lines that no scene has: from the whole guard band, next to nothing, of any 1/w, in
 * memory without depth or with rows far apart. In parts they are what they are as a whole.
 */
#include <math.h>

#include "support/core.h"

#include "raster/large_setup.h"

#include <qtri/antialias.h>
#include <qtri/stroke.h>

enum { WIDTH = 48, HEIGHT = 40, SIDE = 8 };

static const qtri_rgb sky = {24, 40, 88};
static const qtri_format *const plain[6] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_xrgb8888,
                                            &qtri_rgb888, &qtri_gray8,          &qtri_bgr888};
static uint16_t texels[SIDE * SIDE];
static const qtri_texture texture = {
    .format = &qtri_texel_rgb565, .texels = texels, .width_log2 = 3, .height_log2 = 3};

static int make_texels(void **state)
{
    (void)state;
    uint64_t seed = 4;
    for (int i = 0; i < SIDE * SIDE; i++) {
        texels[i] = (uint16_t)random64(&seed);
    }
    return 0;
}

static canvas new_canvas(const qtri_format *format)
{
    canvas c = canvas_new(format, WIDTH, HEIGHT);
    qtri_surface_clear(&c.surface, sky);
    return c;
}

/* A triangle in clip space: whole, and cut in two. */
static void draw_both(canvas c[2], const qtri_mesh *mesh, const qtri_material *material)
{
    qtri_vertex vertices[3];
    qtri_transform pose;
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    give_vertices(&view, vertices, LENGTH_OF(vertices));
    qtri_transform_identity(&pose);
    qtri_draw_mesh(&c[0].surface, &view, &pose, mesh, material);
    for (int part = 0; part < 2; part++) {
        qtri_surface s = c[1].surface;
        s.scissor.y0 = part == 0 ? 0 : 17;
        s.scissor.y1 = part == 0 ? 17 : HEIGHT;
        qtri_draw_mesh(&s, &view, &pose, mesh, material);
    }
    assert_same_picture(&c[0].surface, &c[1].surface);
}

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
TEST(strokes_without_depth)
{
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
TEST(thin_lines_of_any_pitch)
{
    enum { FAR = 140000 };
    static uint16_t pixels[FAR / 2 * HEIGHT], depths[FAR / 2 * HEIGHT];
    for (int n = 0; n < 5; n++) {
        canvas want = new_canvas(&qtri_rgb565);
        qtri_surface s = want.surface;
        s.pixels = (uint8_t *)pixels + (n == 1 ? (HEIGHT - 1) * (ptrdiff_t)FAR : 0);
        s.depth = depths + (n == 3 ? (HEIGHT - 1) * (ptrdiff_t)(FAR / 2) : 0);
        s.pitch = n == 0 ? FAR : (n == 1 ? -FAR : 2 * WIDTH);
        s.depth_pitch = n == 2 ? FAR / 2 : (n == 3 ? -FAR / 2 : WIDTH);
        qtri_surface_clear(&s, sky);
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
            qtri_vertex vertices[3];
            qtri_transform pose;
            qtri_view view;
            qtri_material material = qtri_material_default();
            material.cull = QTRI_CULL_NONE;
            qtri_view_init(&view, WIDTH, HEIGHT);
            give_vertices(&view, vertices, LENGTH_OF(vertices));
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

/* From the whole guard band, of any 1/w, steep and flat: in parts as in one. */
TEST(extremes_in_parts)
{
    uint64_t seed = 77;
    for (int n = 0; n < 3000; n++) {
        static const int32_t reaches[5] = {300, 9000, 70000, 1 << 20, QTRI_SCREEN_MAX_24P8};
        const int32_t reach = reaches[n % 5];
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = screen_at(random_in(&seed, -reach, reach), random_in(&seed, -reach, reach));
            v[i].x_24p8 =
                n % 7 == 0 && i == 2 ? v[0].x_24p8 + random_in(&seed, -9, 9) : v[i].x_24p8;
            v[i].depth_16p16 = (uint32_t)random64(&seed) >> random_in(&seed, 0, 24);
            v[i].inv_w_q31 = n % 3 == 0 ? 1u << random_in(&seed, 0, 31)
                                        : (uint32_t)random64(&seed) >> random_in(&seed, 0, 31);
            v[i].inv_w_q31 |= 1;
            v[i].inv_w_exponent = random_in(&seed, 0, n % 2 == 0 ? 3 : 60);
            v[i].u_q32 = (int64_t)random_any(&seed) * ((int64_t)1 << random_in(&seed, 0, 16));
            v[i].v_q32 = (int64_t)random_any(&seed) * ((int64_t)1 << random_in(&seed, 0, 16));
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
        qtri_raster_triangle(&whole.surface, qtri_pipelines_default, &material, v);
        const int32_t column = random_in(&seed, 1, WIDTH - 1),
                      row = random_in(&seed, 1, HEIGHT - 1);
        for (int part = 0; part < 4; part++) {
            qtri_surface s = parts.surface;
            s.scissor.x0 = part & 1 ? column : 0;
            s.scissor.x1 = part & 1 ? WIDTH : column;
            s.scissor.y0 = part & 2 ? row : 0;
            s.scissor.y1 = part & 2 ? HEIGHT : row;
            qtri_raster_triangle(&s, qtri_pipelines_default, &material, v);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

/* At the end of the screen's numbers samples cannot be moved: such triangles are not seen. */
TEST(samples_at_the_end)
{
    static uint32_t memory[QTRI_BAND_BYTES(WIDTH, HEIGHT, QTRI_RGB565_X4_BYTES) / 4];
    static uint8_t before[sizeof memory];
    qtri_surface s;
    assert_ok(
        qtri_surface_init(&s, &qtri_rgb565_x4, WIDTH, HEIGHT, 0, HEIGHT, memory, sizeof memory));
    qtri_samples_clear(&s, sky);
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
        qtri_raster_triangle(&s, qtri_pipelines_default, &material, v);
    }
    assert_memory_equal(before, memory, sizeof memory);
}

/* Small triangles that are next to lines, of steep attributes and flat ones. */
TEST(small_slivers_in_parts)
{
    uint64_t seed = 15;
    static const uint16_t triangle[1][3] = {{0, 1, 2}};
    int drawn = 0;
    for (int n = 0; n < 4000; n++) {
        const double x = random_in(&seed, 0, WIDTH), y = random_in(&seed, 0, HEIGHT);
        const double dx = random_in(&seed, -8900, 8900) / 256.,
                     dy = random_in(&seed, -8900, 8900) / 256.;
        const double part = random_in(&seed, 1, 9) / 10.;
        const double off = random_in(&seed, 1, 12000) / 1000. / (fabs(dx) + fabs(dy) + 1);
        const double at[3][2] = {
            {x, y},
            {x + dx, y + dy},
            {x + part * dx - off * (dy > 0 ? 1 : -1), y + part * dy + off * (dx > 0 ? 1 : -1)}};
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
        material.cull = QTRI_CULL_NONE;
        canvas c[2] = {new_canvas(&qtri_rgb565), new_canvas(&qtri_rgb565)};
        draw_both(c, &mesh, &material);
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
TEST(more_lines_than_spans)
{
    enum { TEETH = 16 };
    qtri_screen_vertex v[2 * TEETH];
    for (int i = 0; i < 2 * TEETH; i++) {
        v[i] =
            screen_at(512 + i / 2 * 512 + 128, (i + 1) / 2 % 2 == 0 ? -3000 : HEIGHT * 256 + 3000);
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
            assert_true((stored_pixel(&c.surface, 2 + 2 * i, 20) & 255) <=
                        (sky888 & 255) * (uint32_t)(1 + n % 2) / 2);
        }
        canvas_free(&c);
    }
}

/* Diagonals of 257 pixels, of all lengths around the one whose slope is rounded up to 1: as seen
   from the other side of the diagonal. */
TEST(diagonals)
{
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
        qtri_vertex vertices[3];
        qtri_transform pose;
        qtri_view view;
        canvas c = canvas_new(&qtri_xrgb8888, PIXELS, PIXELS);
        stroke.cap = QTRI_CAP_BUTT;
        material.cull = QTRI_CULL_NONE;
        qtri_view_init(&view, PIXELS, PIXELS);
        give_vertices(&view, vertices, LENGTH_OF(vertices));
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
TEST(triangles_that_are_lines)
{
    uint64_t seed = 9;
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
        material.cull = QTRI_CULL_NONE;
        material.texture = &texture;
        canvas c[2] = {new_canvas(&qtri_rgb565), new_canvas(&qtri_rgb565)};
        draw_both(c, &mesh, &material);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* Areas of a few units: at the vertices the plane is what it goes through, to 2^-8 of a unit in 16
   bits of it, as steps are off by 2^-30 of their products. */
TEST(planes_of_slivers)
{
    uint64_t seed = 21;
    int thin = 0;
    while (thin < 3000) {
        qtri_large_vertex v[3];
        qtri_large job;
        qtri_large_input in;
        memset(v, 0, sizeof v);
        memset(&job, 0, sizeof job);
        job.in = &in;
        in.v = v;
        job.corner_x[0] = 128;
        job.corner_y[0] = 128;
        const int32_t dx1 = random_in(&seed, -128, 127) * 256;
        const int32_t dy1 = random_in(&seed, -128, 127) * 256;
        const int32_t part = 1 << random_in(&seed, 0, 3);
        const int32_t dx2 = dx1 / part / 256 * 256 + random_in(&seed, -1, 1) * 256;
        const int32_t dy2 = dy1 / part / 256 * 256 + random_in(&seed, -1, 1) * 256;
        job.corner_x[1] = 128 + dx1;
        job.corner_y[1] = 128 + dy1;
        job.corner_x[2] = 128 + dx2;
        job.corner_y[2] = 128 + dy2;
        job.area = (int64_t)dx1 * dy2 - (int64_t)dx2 * dy1;
        if (job.area == 0) {
            continue;
        }
        thin++;
        uint32_t f[3];
        for (int i = 0; i < 3; i++) {
            f[i] = (uint32_t)random64(&seed) >> random_in(&seed, 1, 20);
        }
        qtri_large_plane plane;
        qtri_large_set_weights(&job);
        qtri_large_plane_of(&plane, &job, f);
        for (int i = 0; i < 3; i++) {
            const uint64_t at = plane.row + plane.dx * (uint64_t)(int64_t)(job.corner_x[i] >> 8) +
                                plane.dy * (uint64_t)(int64_t)(job.corner_y[i] >> 8);
            const int64_t off = (int64_t)(at - ((uint64_t)f[i] << 32));
            assert_true(llabs(off) <= (int64_t)1 << 24);
        }
    }
}

/* The smallest triangle there is has its first vertex in a pixel's centre: one pixel, by the way of
   points with w = 1 and by that of others. */
TEST(half_a_unit_of_area)
{
    qtri_view view;
    qtri_transform pose;
    qtri_view_init(&view, WIDTH, HEIGHT);
    view.viewport = qtri_viewport_top(0, 0, 512, 512); /* 2^-16 of clip space is 1/256 pixel */
    qtri_transform_identity(&pose);
    for (int32_t w = 1; w <= 3; w++) {
        canvas c = new_canvas(&qtri_rgb565);
        const int32_t at[3][2] = {{5 * 256 + 128, 7 * 256 + 128},
                                  {5 * 256 + 129, 7 * 256 + 128},
                                  {5 * 256 + 128, 7 * 256 + 129}};
        qtri_material material = qtri_material_default();
        qtri_corner corner[3];
        memset(corner, 0, sizeof corner);
        material.cull = QTRI_CULL_NONE;
        for (int i = 0; i < 3; i++) {
            corner[i].position =
                (qtri_vec4){w * (at[i][0] - 65536), w * (65536 - at[i][1]), 0, w * Q16_ONE};
            corner[i].color = (qtri_rgb){255, 255, 255};
        }
        qtri_draw_triangles(&c.surface, &view, &pose, corner, 3, &material);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const bool is_it = i == 7 * WIDTH + 5;
            assert_int_equal(stored_pixel(&c.surface, i % WIDTH, i / WIDTH) == 0xFFFF, is_it);
        }
        canvas_free(&c);
    }
}

/* Long ones in perspective, 16 pixels wide. Colour and 1/w are of one vertex, across or along. */
TEST(long_ones_in_perspective)
{
    enum { LENGTH = 1024, BREADTH = 16 };
    qtri_material m = plain_material();
    m.shading = QTRI_SMOOTH;
    for (int n = 0; n < 8; n++) {
        const bool is_flat = n & 1, swapped = n & 2;
        const int32_t end_x = (is_flat ? LENGTH : BREADTH) * 256 - 128;
        const int32_t end_y = (is_flat ? BREADTH : LENGTH) * 256 - 128;
        const int other = n & 4 ? 1 : 2;
        qtri_screen_vertex v[3] = {screen_at(0, 0),
                                   screen_at(swapped ? 0 : end_x, swapped ? end_y : 0),
                                   screen_at(swapped ? end_x : 0, swapped ? 0 : end_y)};
        canvas c =
            canvas_new(&qtri_xrgb8888, is_flat ? LENGTH : BREADTH, is_flat ? BREADTH : LENGTH);
        int seen = 0;
        for (int i = 0; i < 3; i++) {
            v[i].inv_w_q31 = i == other ? 0x70000000u : 0x7FFFFFFFu;
            for (int k = 0; k < 3; k++) {
                v[i].color_8p16[k] = i == other ? 0 : 255 << 16;
            }
        }
        m.cull = QTRI_CULL_NONE;
        canvas_clear(&c);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, v);
        for (int32_t i = 0; i < LENGTH * BREADTH; i++) {
            const int32_t x = i % c.surface.width, y = i / c.surface.width;
            const double along_x = (x * 256 + 128.0) / end_x, along_y = (y * 256 + 128.0) / end_y;
            const double b = (other == 1) != swapped ? along_x : along_y;
            const double is = stored_pixel(&c.surface, x, y) & 255;
            if (along_x + along_y < 0.999) {
                const double q = 0x70000000 / (double)0x7FFFFFFF;
                const double of_others = (1 - b) / (1 - b + b * q);
                assert_true(fabs(is - 255 * of_others) < 1.2);
                seen++;
            }
        }
        assert_true(seen > LENGTH * BREADTH / 3);
        canvas_free(&c);
    }
}

int main(void)
{
    return run_all_tests(make_texels, NULL);
}
