/* SPDX-License-Identifier: MIT */
/*
 * Alpha that varies between vertices, against exact arithmetic, and in pieces.
 */
#include "support/core.h"
#include "support/layouts.h"
#include "support/shares.h"
#include "support/steps.h"

enum { WIDTH = 120, HEIGHT = 90 };

static double w_of(const qtri_screen_vertex *v)
{
    return ldexp(v->inv_w_q31, v->inv_w_exponent - 31);
}

/* One triangle over one colour. */
typedef struct trial {
    qtri_screen_vertex v[3];
    uint8_t alphas[3];
    qtri_rgb sky;
    qtri_material material;
} trial;

static void random_trial(trial *t, uint64_t *seed)
{
    t->material = plain_material();
    t->material.shading = random_flag(seed) ? QTRI_SMOOTH : QTRI_FLAT_FIRST;
    t->material.blend = random_flag(seed) ? &qtri_blend_vertex_alpha : &qtri_blend_vertex_add;
    t->material.alpha = random_flag(seed) ? 255 : (uint8_t)random_in(seed, 0, 255);
    t->material.interpolation = random_flag(seed) ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
    t->material.alphas = t->alphas;
    const int32_t x = random_in(seed, 0, WIDTH * 256);
    const int32_t y = random_in(seed, 0, HEIGHT * 256);
    const int32_t reach = random_flag(seed) ? 4000 : 60000;
    const int32_t far = random_in(seed, 0, 6);
    for (int i = 0; i < 3; i++) {
        t->v[i] = screen_at(x + random_in(seed, -reach, reach), y + random_in(seed, -reach, reach));
        t->v[i].inv_w_q31 = 0x80000000u + (uint32_t)random_in(seed, 0, 0x7FFFFFFF);
        t->v[i].inv_w_exponent = random_in(seed, -far, 0);
        for (int k = 0; k < 3; k++) {
            t->v[i].color_8p16[k] = random_in(seed, 0, 255 << 16);
        }
        t->alphas[i] = random_in(seed, 0, 3) == 0 ? 255 : (uint8_t)random_in(seed, 0, 255);
    }
    t->sky.r = (uint8_t)random_in(seed, 0, 255);
    t->sky.g = (uint8_t)random_in(seed, 0, 255);
    t->sky.b = (uint8_t)random_in(seed, 0, 255);
}

/* What a channel, in steps, is to be. */
static double expected(const trial *t, const qtri_format *format, uint32_t before,
                       const double b[3], int channel)
{
    const bool smooth = t->material.shading == QTRI_SMOOTH;
    const double white[3] = {255, 255, 255};
    double color[3] = {0};
    double alpha = 0;
    for (int i = 0; i < 3; i++) {
        alpha += b[i] * t->alphas[i] / 255.0;
        for (int k = 0; k < 3; k++) {
            color[k] += (smooth ? b[i] : i == 0) * t->v[i].color_8p16[k] / 65536.0;
        }
    }
    alpha *= t->material.alpha / 255.0;
    const double over = steps_of(format, color, channel);
    const double under = stored_steps(format, before, channel);
    return t->material.blend == &qtri_blend_vertex_alpha
               ? over * alpha + under * (1 - alpha)
               : fmin(steps_of(format, white, channel), under + over * alpha);
}

/* The greatest difference, in steps, of a format's pixels. */
static double worst_of(const qtri_format *format)
{
    uint64_t seed = 7;
    canvas drawn = canvas_new(format, WIDTH, HEIGHT);
    canvas before = canvas_new(format, WIDTH, HEIGHT);
    canvas covered = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    double worst = 0;
    for (int n = 0; n < (long_run() ? 5000 : 150); n++) {
        trial t;
        random_trial(&t, &seed);
        const bool perspective = t.material.interpolation == QTRI_PERSPECTIVE;
        qtri_screen_vertex solid[3] = {t.v[0], t.v[1], t.v[2]};
        solid[0].color_8p16[0] = solid[0].color_8p16[1] = solid[0].color_8p16[2] = 255 << 16;
        const qtri_material plain = plain_material();
        qtri_surface_clear(&drawn.surface, t.sky);
        qtri_surface_clear(&before.surface, t.sky);
        canvas_clear(&covered);
        qtri_raster_triangle(&drawn.surface, qtri_pipelines_default, &t.material, t.v);
        qtri_raster_triangle(&covered.surface, qtri_pipelines_default, &plain, solid);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH;
            const int32_t y = i / WIDTH;
            const uint32_t is = stored_pixel(&drawn.surface, x, y);
            const uint32_t was = stored_pixel(&before.surface, x, y);
            if (stored_pixel(&covered.surface, x, y) == 0) {
                assert_int_equal(is, was);
                continue;
            }
            double b[3];
            shares_at(b, t.v, x, y, perspective);
            for (int k = 0; k < 3; k++) {
                const double d =
                    fabs(stored_steps(format, is, k) - expected(&t, format, was, b, k));
                worst = fmax(worst, d);
            }
        }
    }
    canvas_free(&drawn);
    canvas_free(&before);
    canvas_free(&covered);
    return worst;
}

TEST(is_exact)
{
    for (int f = 0; f < 6; f++) {
        const qtri_format *format = drawn_format(f);
        const double worst = worst_of(format);
        const double most = format->colors == &qtri_colors_565 ? .9 : 1.5;
        assert_true(worst <= most);
    }
}

/* ---- Vertices near and far ---- */

/* White over black, whose pixels are alpha itself; centres of pixels lie on vertices and sides. */
static void far_trial(trial *t, uint64_t *seed)
{
    static const int32_t reaches[3] = {2000, 20000, 1000000};
    const int32_t depth = random_in(seed, 16, 31);
    const int32_t reach = reaches[random_in(seed, 0, 2)];
    const int32_t x = random_in(seed, 0, WIDTH * 256);
    const int32_t y = random_in(seed, 0, HEIGHT * 256);
    const bool is_near = random_flag(seed);
    t->material = plain_material();
    t->material.blend = &qtri_blend_vertex_alpha;
    t->material.interpolation = QTRI_PERSPECTIVE;
    t->material.alphas = t->alphas;
    for (int i = 0; i < 3; i++) {
        t->v[i] = screen_at(((x + random_in(seed, -reach, reach)) & ~255) + 128,
                            ((y + random_in(seed, -reach, reach)) & ~255) + 128);
        t->v[i].inv_w_q31 = 0x80000000u + (uint32_t)random_in(seed, 0, 0x7FFFFFFF);
        t->v[i].inv_w_exponent = random_in(seed, 0, 2) == 0 ? 0 : -random_in(seed, 0, depth);
        t->v[i].color_8p16[0] = t->v[i].color_8p16[1] = t->v[i].color_8p16[2] = 255 << 16;
        t->alphas[i] = (uint8_t)random_in(seed, is_near ? 120 : 0, is_near ? 125 : 255);
    }
    if (random_flag(seed)) {
        t->v[1].y_24p8 = t->v[0].y_24p8;
    }
}

/*
 * Where one vertex is up to 2^31 times as far away as another: alpha is between those of the
 * vertices, and what planes lack, which counts where 1/w is small, is all that it is off by.
 */
TEST(near_and_far)
{
    uint64_t seed = 61;
    const qtri_material plain = plain_material();
    canvas drawn = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    canvas covered = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    double lack = 0;
    for (int n = 0; n < (long_run() ? 50000 : 1500); n++) {
        trial t;
        far_trial(&t, &seed);
        const int32_t least = q16_min(t.alphas[0], q16_min(t.alphas[1], t.alphas[2]));
        const int32_t most = q16_max(t.alphas[0], q16_max(t.alphas[1], t.alphas[2]));
        const double nearest = fmax(w_of(&t.v[0]), fmax(w_of(&t.v[1]), w_of(&t.v[2])));
        canvas_clear(&drawn);
        canvas_clear(&covered);
        qtri_raster_triangle(&drawn.surface, qtri_pipelines_default, &t.material, t.v);
        qtri_raster_triangle(&covered.surface, qtri_pipelines_default, &plain, t.v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH;
            const int32_t y = i / WIDTH;
            if (stored_pixel(&covered.surface, x, y) == 0) {
                continue;
            }
            const int32_t is = (int32_t)(stored_pixel(&drawn.surface, x, y) & 255);
            double b[3];
            double expected = 0;
            double far = 0;
            shares_at(b, t.v, x, y, true);
            for (int k = 0; k < 3; k++) {
                expected += b[k] * t.alphas[k];
                far += b[k] * nearest / w_of(&t.v[k]); /* of the pixel: w is what is linear */
            }
            assert_in_range(is, least, most);
            lack = fmax(lack, (fabs(is - expected) - 1.5) / far);
        }
    }
    assert_true(lack <= ldexp(8 * 255, -31)); /* 8 units of the planes; 4.4 was found */
    canvas_free(&drawn);
    canvas_free(&covered);
}

/* ---- Meshes and corners ---- */

enum { COLUMNS = 7, ROWS = 6, POINTS = COLUMNS * ROWS, TRIANGLES = (COLUMNS - 1) * (ROWS - 1) * 2 };

/* A bent sheet that reaches through the near plane. */
typedef struct sheet {
    qtri_vec3 position[POINTS];
    qtri_rgb color[POINTS];
    qtri_vec2 uv[POINTS];
    uint8_t alpha[POINTS];
    uint16_t triangle[TRIANGLES][3];
    qtri_mesh mesh;
    qtri_corner corner[3 * TRIANGLES];
    uint8_t corner_alpha[3 * TRIANGLES];
} sheet;

static void random_sheet(sheet *s, uint64_t *seed)
{
    static const uint8_t step[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
    const bool colored = random_flag(seed);
    for (int i = 0; i < POINTS; i++) {
        const int32_t x = i % COLUMNS;
        const int32_t y = i / COLUMNS;
        const qtri_vec3 p = {x * 30000 - 90000 + random_in(seed, -20000, 20000),
                             y * 30000 - 75000 + random_in(seed, -20000, 20000),
                             random_in(seed, -90000, 90000)};
        const qtri_rgb c = {(uint8_t)random_in(seed, 0, 255), (uint8_t)random_in(seed, 0, 255),
                            (uint8_t)random_in(seed, 0, 255)};
        const qtri_vec2 uv = {x * 20000, y * 20000};
        s->position[i] = p;
        s->color[i] = c;
        s->uv[i] = uv;
        s->alpha[i] = (uint8_t)random_in(seed, 0, 255);
    }
    for (int i = 0; i < TRIANGLES; i++) {
        const int cell = i / 2;
        for (int k = 0; k < 3; k++) {
            const int x = cell % (COLUMNS - 1) + step[i % 2][k][0];
            const int y = cell / (COLUMNS - 1) + step[i % 2][k][1];
            const uint16_t v = (uint16_t)(y * COLUMNS + x);
            const qtri_rgb white = {255, 255, 255};
            const qtri_corner corner = {
                {s->position[v].x, s->position[v].y, s->position[v].z, Q16_ONE},
                colored ? s->color[v] : white,
                s->uv[v]};
            s->triangle[i][k] = v;
            s->corner[3 * i + k] = corner;
            s->corner_alpha[3 * i + k] = s->alpha[v];
        }
    }
    const qtri_mesh mesh = {.positions = s->position,
                            .uvs = s->uv,
                            .colors = colored ? s->color : NULL,
                            .triangles = (const uint16_t(*)[3])s->triangle,
                            .vertex_count = POINTS,
                            .triangle_count = TRIANGLES};
    s->mesh = mesh;
}

static void random_space(qtri_view *view, qtri_transform *pose, uint64_t *seed)
{
    const qtri_vec3 eye = {random_in(seed, -40000, 40000), random_in(seed, -40000, 40000),
                           random_in(seed, 60000, 260000)};
    const qtri_vec3 center = {0, 0, 0};
    const qtri_vec3 up = {0, Q16_ONE, 0};
    qtri_view_init(view, WIDTH, HEIGHT);
    qtri_transform_look_at(&view->camera, eye, center, up);
    qtri_transform_perspective(&view->projection, Q16(70), Q16(1.33), Q16(.3), Q16(20));
    qtri_transform_identity(pose);
}

/* Of what triangles may be besides. `texels`: 64 of ARGB4444, or of RGB565. */
static void random_material(qtri_material *m, qtri_texture *texture, const uint16_t texels[64],
                            qtri_fog *fog, uint64_t *seed)
{
    const qtri_fog_range range = {Q16(.3), Q16(20), false};
    const qtri_rgb gray = {120, 130, 150};
    const qtri_texture plain = {.texels = texels,
                                .format =
                                    random_flag(seed) ? &qtri_texel_rgb565 : &qtri_texel_argb4444,
                                .width_log2 = 3,
                                .height_log2 = 3};
    *texture = plain;
    texture->filter = random_flag(seed) ? &qtri_bilinear : NULL;
    qtri_fog_exp(fog, gray, range, Q16(.3));
    *m = qtri_material_default();
    m->cull = QTRI_CULL_NONE;
    m->shading = random_flag(seed) ? QTRI_SMOOTH : QTRI_FLAT_LAST;
    m->blend = random_flag(seed) ? &qtri_blend_vertex_alpha : &qtri_blend_vertex_add;
    m->alpha = random_flag(seed) ? 255 : (uint8_t)random_in(seed, 0, 255);
    m->keep = random_in(seed, 0, 3) == 0 ? (uint8_t)random_in(seed, 0, 7) : 0;
    m->interpolation = random_flag(seed) ? QTRI_PERSPECTIVE : QTRI_SCREEN_LINEAR;
    m->texture = random_flag(seed) ? texture : NULL;
    m->texture_mode = random_flag(seed) ? QTRI_MODULATE : QTRI_REPLACE;
    m->fog = random_flag(seed) ? fog : NULL;
    m->depth_compare = random_flag(seed) ? QTRI_LESS : QTRI_DEPTH_OFF;
    m->least_alpha = random_in(seed, 0, 3) == 0 ? 100 : 0;
    m->depth_shift = random_in(seed, 0, 2) == 0 ? &qtri_slope_bias : NULL;
    m->depth_slope = random_in(seed, -200000, 200000);
}

/* A mesh, its triangles, and the prepared mesh in bands. */
TEST(meshes)
{
    static sheet s;
    static qtri_vertex vertices[POINTS];
    static uint16_t lists[QTRI_PREPARED_LISTS(TRIANGLES, HEIGHT, 13)];
    const qtri_rgb sky = {40, 90, 160};
    uint64_t seed = 11;
    for (int n = 0; n < 90; n++) {
        const qtri_format *format = drawn_format(n);
        qtri_view view;
        qtri_transform pose;
        qtri_material m;
        qtri_texture texture;
        qtri_fog fog;
        uint16_t texels[64];
        for (int i = 0; i < 64; i++) {
            texels[i] = (uint16_t)random_in(&seed, 0, 65535);
        }
        random_sheet(&s, &seed);
        random_space(&view, &pose, &seed);
        random_material(&m, &texture, texels, &fog, &seed);
        qtri_material of_corners = m;
        const bool opaque = random_in(&seed, 0, 5) == 0;
        m.alphas = opaque ? NULL : s.alpha;
        of_corners.alphas = opaque ? NULL : s.corner_alpha;
        if (s.mesh.colors == NULL) { /* coordinates beside what varies are found otherwise */
            of_corners.shading = QTRI_FLAT_LAST;
        }
        if (random_flag(&seed)) {
            give_vertices(&view, vertices, POINTS);
        }
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        qtri_surface_clear(&whole.surface, sky);
        qtri_draw_mesh(&whole.surface, &view, &pose, &s.mesh, &m);
        canvas corners = canvas_new(format, WIDTH, HEIGHT);
        qtri_surface_clear(&corners.surface, sky);
        qtri_draw_triangles(&corners.surface, &view, &pose, s.corner, 3 * TRIANGLES, &of_corners);
        assert_same_picture(&whole.surface, &corners.surface);
        canvas_free(&corners);
        static uint8_t memory[QTRI_FRAME_BYTES(WIDTH, 13, QTRI_XRGB8888_BYTES)];
        qtri_frame frame;
        qtri_prepared prepared;
        assert_ok(qtri_frame_init(&frame, format, WIDTH, HEIGHT, 13, memory, sizeof memory));
        prepared_init_with(&prepared, vertices, POINTS, lists, sizeof lists / sizeof lists[0]);
        qtri_prepare_mesh(&prepared, &frame, &view, &pose, &s.mesh, &m);
        assert_same_bands(&whole.surface, &frame, &prepared, sky);
        canvas_free(&whole);
    }
}

/* Alpha that is the same everywhere, and lines, are as with the blends that know one alpha. */
TEST(as_constant)
{
    static sheet s;
    uint64_t seed = 21;
    for (int n = 0; n < 40; n++) {
        const qtri_rgb sky = {40, 90, 160};
        const bool lines = n % 4 == 3;
        const uint8_t alpha = (uint8_t)random_in(&seed, 0, 255);
        qtri_view view;
        qtri_transform pose;
        random_sheet(&s, &seed);
        random_space(&view, &pose, &seed);
        memset(s.alpha, lines ? 255 : alpha, sizeof s.alpha);
        qtri_material m = qtri_material_default();
        m.cull = QTRI_CULL_NONE;
        m.fill = lines ? &qtri_wireframe : NULL;
        m.alpha = alpha;
        m.blend = n % 2 != 0 ? &qtri_blend_alpha : &qtri_blend_add;
        canvas one = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas other = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        qtri_surface_clear(&one.surface, sky);
        qtri_surface_clear(&other.surface, sky);
        qtri_draw_mesh(&one.surface, &view, &pose, &s.mesh, &m);
        m.blend = n % 2 != 0 ? &qtri_blend_vertex_alpha : &qtri_blend_vertex_add;
        m.alpha = lines ? alpha : 255;
        m.alphas = s.alpha;
        qtri_draw_mesh(&other.surface, &view, &pose, &s.mesh, &m);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t a = stored_pixel(&one.surface, i % WIDTH, i / WIDTH);
            const uint32_t b = stored_pixel(&other.surface, i % WIDTH, i / WIDTH);
            /* Small triangles are drawn as large ones, of which the true places count. */
            assert_near(stored_depth(&one.surface, i % WIDTH, i / WIDTH),
                        stored_depth(&other.surface, i % WIDTH, i / WIDTH), lines ? 0 : 16);
            for (int k = 0; k < 24; k += 8) { /* each of the two rounds, and twice where they lie
                                                 over each other */
                assert_near(a >> k & 255, b >> k & 255, lines ? 0 : 3);
            }
        }
        canvas_free(&one);
        canvas_free(&other);
    }
}

/* With four samples a pixel, inside of a triangle, the same; nothing else on its edges. */
TEST(samples)
{
    uint64_t seed = 31;
    for (int n = 0; n < 30; n++) {
        trial t;
        random_trial(&t, &seed);
        canvas plain = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas many = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
        canvas inside = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
        const qtri_rgb black = {0, 0, 0};
        qtri_surface resolved;
        qtri_surface whole;
        const qtri_material white = plain_material();
        t.material.shading = QTRI_FLAT_FIRST;
        qtri_surface_clear(&plain.surface, t.sky);
        qtri_samples_clear(&many.surface, t.sky);
        qtri_samples_clear(&inside.surface, black);
        qtri_raster_triangle(&plain.surface, qtri_pipelines_default, &t.material, t.v);
        qtri_raster_triangle(&many.surface, qtri_pipelines_default, &t.material, t.v);
        t.v[0].color_8p16[0] = t.v[0].color_8p16[1] = t.v[0].color_8p16[2] = 255 << 16;
        qtri_raster_triangle(&inside.surface, qtri_pipelines_default, &white, t.v);
        assert_ok(qtri_samples_resolve(&many.surface, &resolved));
        assert_ok(qtri_samples_resolve(&inside.surface, &whole));
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t cover = stored_pixel(&whole, i % WIDTH, i / WIDTH) & 0xFFFFFF;
            const uint32_t is = stored_pixel(&resolved, i % WIDTH, i / WIDTH);
            const uint32_t should = stored_pixel(&plain.surface, i % WIDTH, i / WIDTH);
            if (cover == 0xFFFFFF) {
                assert_int_equal(is & 0xFFFFFF, should & 0xFFFFFF);
            } else if (cover == 0) {
                assert_int_equal(is & 0xFFFFFF,
                                 (uint32_t)t.sky.r << 16 | (uint32_t)t.sky.g << 8 | t.sky.b);
            }
        }
        canvas_free(&plain);
        canvas_free(&many);
        canvas_free(&inside);
    }
}

/* Any numbers: nothing is drawn outside of the surface, and the sanitizers find nothing. */
TEST(anything)
{
    uint64_t seed = 51;
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < 300; n++) {
        trial t;
        random_trial(&t, &seed);
        for (int i = 0; i < 3; i++) {
            t.v[i].x_24p8 = random_flag(&seed) ? random_any(&seed) : t.v[i].x_24p8;
            t.v[i].y_24p8 = random_flag(&seed) ? random_any(&seed) : t.v[i].y_24p8;
            t.v[i].depth_16p16 = (uint32_t)random_any(&seed);
            t.v[i].inv_w_q31 = (uint32_t)random_any(&seed);
            t.v[i].inv_w_exponent = random_any(&seed);
            t.v[i].color_8p16[i] = random_any(&seed);
        }
        t.material.keep = (uint8_t)random_any(&seed);
        t.material.depth_compare = QTRI_LESS;
        t.material.depth_shift = random_flag(&seed) ? &qtri_slope_bias : NULL;
        t.material.depth_slope = random_any(&seed);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &t.material, t.v);
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
