/* SPDX-License-Identifier: MIT */
/*
 * The same pixels however a frame is cut: bands, scissors, pitches; and nothing outside them.
 */
#include "support/core.h"

enum { WIDTH = 48, HEIGHT = 40, TRIANGLES = 12 };

static uint16_t texels565[16 * 8];
static uint32_t texels8888[32 * 32];
static uint8_t texels8[16 * 32]; /* few values, so that keys are met */
static qtri_rgb palette[256];

static const void *const levels565[3] = {texels565 + 5, texels565 + 9, texels565};
static const void *const levels8888[4] = {texels8888 + 3, texels8888 + 1, texels8888 + 8,
                                          texels8888};

static const qtri_texture textures[8] = {
    {.texels = texels565, .format = &qtri_texel_rgb565, .width_log2 = 4, .height_log2 = 3},
    {.texels = texels8888, .format = &qtri_texel_xrgb8888, .width_log2 = 5, .height_log2 = 5},
    {.format = &qtri_texel_checker,
     .width_log2 = 6,
     .height_log2 = 4,
     .fields = 8,
     .color = {{255, 30, 60}, {10, 200, 90}}},
    {.texels = texels8,
     .format = &qtri_texel_palette8,
     .width_log2 = 4,
     .height_log2 = 5,
     .palette = palette,
     .wrap_u = QTRI_CLAMP,
     .has_key = true,
     .key = 3},
    {.texels = texels565,
     .format = &qtri_texel_rgb565,
     .width_log2 = 3,
     .height_log2 = 4,
     .wrap_v = QTRI_CLAMP,
     .filter = &qtri_bilinear},
    {.texels = texels8,
     .format = &qtri_texel_gray8,
     .width_log2 = 5,
     .height_log2 = 4,
     .filter = &qtri_bilinear,
     .has_key = true,
     .key = 2},
    {.texels = texels8888,
     .format = &qtri_texel_xrgb8888,
     .width_log2 = 5,
     .height_log2 = 5,
     .filter = &qtri_mipmapped_bilinear,
     .wrap_u = QTRI_CLAMP,
     .levels = levels8888,
     .level_count = 4},
    {.texels = texels565,
     .format = &qtri_texel_rgb565,
     .width_log2 = 4,
     .height_log2 = 3,
     .filter = &qtri_mipmapped,
     .levels = levels565,
     .level_count = 3}};

static int fill_textures(void **state)
{
    (void)state;
    uint64_t seed = 60;
    for (size_t i = 0; i < LENGTH_OF(texels565); i++) {
        texels565[i] = (uint16_t)random64(&seed);
    }
    for (size_t i = 0; i < LENGTH_OF(texels8888); i++) {
        texels8888[i] = (uint32_t)random64(&seed);
    }
    for (size_t i = 0; i < LENGTH_OF(texels8); i++) {
        texels8[i] = (uint8_t)random_in(&seed, 0, 6);
        palette[i % 256].r = (uint8_t)random64(&seed);
        palette[i % 256].g = (uint8_t)random64(&seed);
        palette[i % 256].b = (uint8_t)random64(&seed);
    }
    return 0;
}

/* A few triangles and lines with every kind of material. */
typedef struct scene {
    qtri_material material[TRIANGLES];
    qtri_screen_vertex v[TRIANGLES][3];
} scene;

static qtri_screen_vertex random_vertex(uint64_t *seed, bool tame)
{
    static const int32_t reach[] = {2000, 6000, 20000, 1 << 20, 1 << 22};
    int32_t r = reach[random_in(seed, 0, 4)];
    const int32_t x = random_in(seed, WIDTH * 128 - r, WIDTH * 128 + r);
    const int32_t y = random_in(seed, HEIGHT * 128 - r, HEIGHT * 128 + r);
    qtri_screen_vertex v = screen_at(x, y);
    if (!tame) {
        v.x_24p8 = random_in(seed, 0, 3) == 0 ? random_any(seed) : v.x_24p8;
        v.y_24p8 = random_in(seed, 0, 3) == 0 ? random_any(seed) : v.y_24p8;
    }
    v.depth_16p16 = (uint32_t)random64(seed) >> (tame ? 1 : 0);
    v.inv_w_q31 = (uint32_t)random64(seed);
    v.inv_w_q31 >>= random_in(seed, 0, tame ? 6 : 31);
    v.inv_w_exponent = tame ? random_in(seed, 0, 3) : random_any(seed);
    for (int i = 0; i < 3; i++) {
        v.color_8p16[i] = tame ? random_in(seed, 0, 255 << 16) : random_any(seed);
    }
    v.u_q32 = (int64_t)random64(seed);
    v.v_q32 = (int64_t)random64(seed);
    v.u_q32 >>= tame ? 26 : random_in(seed, 0, 63);
    v.v_q32 >>= tame ? 26 : random_in(seed, 0, 63);
    return v;
}

static void random_scene(scene *s, uint64_t *seed, bool tame)
{
    for (int n = 0; n < TRIANGLES; n++) {
        qtri_material m = qtri_material_default();
        m.shading = shading_of((int)random_in(seed, 0, 2));
        m.interpolation = (qtri_interpolation)random_in(seed, 0, 1);
        m.texture = random_flag(seed) ? &textures[random_in(seed, 0, 7)] : NULL;
        m.texture_mode = (qtri_texture_mode)random_in(seed, 0, 1);
        m.cull = (qtri_cull)(random_in(seed, 0, 5) / 2);
        m.depth_compare = (qtri_compare)random_in(seed, 0, 8);
        m.depth_read_only = random_flag(seed);
        if (!tame && random_flag(seed)) {
            m.shading = random_flag(seed) ? NULL : QTRI_SMOOTH;
            m.interpolation = (qtri_interpolation)random_bits32(seed);
            m.texture_mode = (qtri_texture_mode)random_bits32(seed);
            m.cull = (qtri_cull)random_bits32(seed);
            m.fill = random_flag(seed) ? &qtri_wireframe : NULL;
            m.depth_compare = (qtri_compare)random_bits32(seed);
        }
        s->material[n] = m;
        for (int i = 0; i < 3; i++) {
            s->v[n][i] = random_vertex(seed, tame);
        }
    }
}

static void draw_scene(const qtri_surface *surface, const scene *s)
{
    for (int n = 0; n < TRIANGLES; n++) {
        if (n % 4 == 3) {
            qtri_raster_line(surface, &s->material[n], s->v[n]);
        } else {
            qtri_raster_triangle(surface, qtri_pipelines_default, &s->material[n], s->v[n]);
        }
    }
}

static qtri_format own_565;
static const qtri_format *const formats[4] = {&qtri_rgb565, &qtri_xrgb8888, &qtri_gray8, &own_565};

TEST(bands)
{
    uint64_t seed = 61;
    for (int n = 0; n < 1500; n++) {
        static scene s;
        const qtri_format *format = formats[n % 4];
        random_scene(&s, &seed, n % 5 != 0);
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        draw_scene(&whole.surface, &s);
        int32_t first = 0;
        while (first < HEIGHT) { /* the last band may reach past the frame */
            int32_t rows = n < HEIGHT ? n + 1 : random_in(&seed, 1, HEIGHT / 2);
            canvas band = canvas_band(format, WIDTH, HEIGHT, first, rows);
            draw_scene(&band.surface, &s);
            assert_same_picture(&whole.surface, &band.surface);
            canvas_free(&band);
            first += rows;
        }
        canvas_free(&whole);
    }
}

/* Small triangles of a mesh whose vertices are lit: their rows are cut off at both ends. */
TEST(lit_meshes)
{
    enum { MESH_TRIANGLES = 8, MESH_VERTICES = 3 * MESH_TRIANGLES };
    static const uint16_t indices[MESH_TRIANGLES][3] = {{0, 1, 2},    {3, 4, 5},    {6, 7, 8},
                                                        {9, 10, 11},  {12, 13, 14}, {15, 16, 17},
                                                        {18, 19, 20}, {21, 22, 23}};
    static qtri_vertex vertices[MESH_VERTICES];
    const qtri_light light = {
        .towards = {30000, -20000, 50000}, .ambient = Q16(.1), .diffuse = Q16(.9)};
    uint64_t seed = 66;
    for (int n = 0; n < 1000; n++) {
        const qtri_format *format = formats[n % 4];
        qtri_vec3 positions[MESH_VERTICES];
        qtri_normal normals[MESH_VERTICES];
        for (int i = 0; i < MESH_VERTICES; i++) { /* within 32 pixels of a corner */
            const qtri_vec3 *first = &positions[i - i % 3];
            const int32_t reach = Q16(1.3);
            positions[i].x = i % 3 == 0 ? random_in(&seed, -Q16(1), Q16(1))
                                        : first->x + random_in(&seed, -reach, reach);
            positions[i].y = i % 3 == 0 ? random_in(&seed, -Q16(1), Q16(1))
                                        : first->y + random_in(&seed, -reach, reach);
            positions[i].z = random_in(&seed, -Q16(2), -Q16(1));
            normals[i].x = (int16_t)random_in(&seed, -9000, 9000);
            normals[i].y = (int16_t)random_in(&seed, -9000, 9000);
            normals[i].z = (int16_t)random_in(&seed, -9000, 9000);
        }
        const qtri_mesh mesh = {.positions = positions,
                                .normals = normals,
                                .triangles = indices,
                                .vertex_count = MESH_VERTICES,
                                .triangle_count = MESH_TRIANGLES};
        qtri_material material = qtri_material_default();
        material.color.r = (uint8_t)random64(&seed);
        material.color.g = (uint8_t)random64(&seed);
        material.color.b = (uint8_t)random64(&seed);
        material.cull = QTRI_CULL_NONE;
        material.depth_compare = n % 2 != 0 ? QTRI_LESS : QTRI_DEPTH_OFF;
        qtri_transform identity;
        qtri_view view;
        start_view(&view, &identity, WIDTH, HEIGHT);
        qtri_transform_ortho(&view.projection, -Q16(1), Q16(1), -Q16(1), Q16(1), Q16(.5), Q16(4));
        view.light = &light;
        give_vertices(&view, vertices, MESH_VERTICES);
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        qtri_draw_mesh(&whole.surface, &view, &identity, &mesh, &material);
        for (int32_t first = 0; first < HEIGHT;) {
            const int32_t rows = random_in(&seed, 1, 16);
            canvas band = canvas_band(format, WIDTH, HEIGHT, first, rows);
            qtri_draw_mesh(&band.surface, &view, &identity, &mesh, &material);
            assert_same_picture(&whole.surface, &band.surface);
            canvas_free(&band);
            first += rows;
        }
        canvas_free(&whole);
    }
}

TEST(scissors)
{
    uint64_t seed = 62;
    for (int n = 0; n < 1000; n++) {
        static scene s;
        const qtri_format *format = formats[n % 4];
        random_scene(&s, &seed, n % 5 != 0);
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        canvas parts = canvas_new(format, WIDTH, HEIGHT);
        draw_scene(&whole.surface, &s);
        int32_t x = random_in(&seed, 0, WIDTH);
        int32_t y = random_in(&seed, 0, HEIGHT);
        qtri_rect rects[4] = {{INT32_MIN, INT32_MIN, x, y},
                              {x, -5, WIDTH + 9, y},
                              {-3, y, x, INT32_MAX},
                              {x, y, INT32_MAX, HEIGHT}};
        for (int i = 0; i < 4; i++) {
            parts.surface.scissor = rects[i];
            draw_scene(&parts.surface, &s);
        }
        assert_same_picture(&whole.surface, &parts.surface);
        /* One scissor alone: the pixels inside, the background outside. */
        canvas_free(&parts);
        parts = canvas_new(format, WIDTH, HEIGHT);
        parts.surface.scissor = rects[n % 4];
        qtri_rect bounds = qtri_surface_bounds(&parts.surface);
        draw_scene(&parts.surface, &s);
        for (int32_t py = 0; py < HEIGHT; py++) {
            for (int32_t px = 0; px < WIDTH; px++) {
                bool in = px >= bounds.x0 && px < bounds.x1 && py >= bounds.y0 && py < bounds.y1;
                uint32_t expected = in ? stored_pixel(&whole.surface, px, py) : 0;
                uint16_t depth = in ? stored_depth(&whole.surface, px, py) : 65535;
                if (stored_pixel(&parts.surface, px, py) != expected ||
                    stored_depth(&parts.surface, px, py) != depth) {
                    fail_msg("scissor: pixel %d,%d", (int)px, (int)py);
                }
            }
        }
        qtri_rect empty[3] = {{5, 5, 5, 9}, {9, 9, 3, 3}, {INT32_MAX, 0, INT32_MIN, 9}};
        canvas before = canvas_new(format, WIDTH, HEIGHT);
        memcpy(before.surface.pixels, parts.surface.pixels, (size_t)(parts.surface.pitch * HEIGHT));
        memcpy(before.surface.depth, parts.surface.depth, sizeof(uint16_t) * WIDTH * HEIGHT);
        for (int i = 0; i < 3; i++) {
            parts.surface.scissor = empty[i];
            draw_scene(&parts.surface, &s);
            canvas_clear(&parts);
        }
        assert_same_picture(&before.surface, &parts.surface);
        canvas_free(&before);
        canvas_free(&whole);
        canvas_free(&parts);
    }
}

/* Rows apart, bottom up or both, in the middle of memory that must stay as it is. */
TEST(pitches)
{
    enum { ROW = 4 * WIDTH + 24, DEPTH_ROW = WIDTH + 7, SPACE = 3 };
    static uint32_t pixel_memory[(HEIGHT + 2 * SPACE) * ROW / 4];
    static uint16_t depth_memory[(HEIGHT + 2 * SPACE) * DEPTH_ROW];
    uint64_t seed = 63;
    for (int n = 0; n < 600; n++) {
        static scene s;
        const qtri_format *format = formats[n % 4];
        random_scene(&s, &seed, n % 5 != 0);
        canvas whole = canvas_new(format, WIDTH, HEIGHT);
        draw_scene(&whole.surface, &s);

        bool up = n % 2 != 0;
        uint8_t *bytes = (uint8_t *)pixel_memory;
        memset(pixel_memory, 0xA5, sizeof pixel_memory);
        memset(depth_memory, 0xA5, sizeof depth_memory);
        qtri_surface apart = whole.surface;
        apart.pitch = up ? -ROW : ROW;
        apart.pixels = bytes + ROW * (up ? SPACE + HEIGHT - 1 : SPACE);
        apart.depth_pitch = n % 4 < 2 ? -DEPTH_ROW : DEPTH_ROW;
        apart.depth = depth_memory + DEPTH_ROW * (n % 4 < 2 ? SPACE + HEIGHT - 1 : SPACE);
        qtri_rgb black = {0, 0, 0};
        qtri_surface_clear(&apart, black);
        draw_scene(&apart, &s);
        assert_same_picture(&whole.surface, &apart);

        int used = WIDTH * (int)format->pixels->bytes;
        for (int i = 0; i < (int)sizeof pixel_memory; i++) {
            int row = i / ROW - SPACE;
            if ((row < 0 || row >= HEIGHT || i % ROW >= used) && bytes[i] != 0xA5) {
                fail_msg("byte %d of row %d was written", i % ROW, row);
            }
        }
        for (int i = 0; i < (int)LENGTH_OF(depth_memory); i++) {
            int row = i / DEPTH_ROW - SPACE;
            if ((row < 0 || row >= HEIGHT || i % DEPTH_ROW >= WIDTH) && depth_memory[i] != 0xA5A5) {
                fail_msg("depth %d of row %d was written", i % DEPTH_ROW, row);
            }
        }
        canvas_free(&whole);
    }
}

/* Without depth memory nothing is tested. */
TEST(no_depth)
{
    uint64_t seed = 64;
    for (int n = 0; n < 200; n++) {
        static scene s;
        random_scene(&s, &seed, true);
        canvas with = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        canvas without = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        uint16_t *depth = without.surface.depth;
        without.surface.depth = NULL;
        canvas_clear(&without);
        draw_scene(&without.surface, &s);
        for (int i = 0; i < TRIANGLES; i++) {
            s.material[i].depth_compare = QTRI_DEPTH_OFF;
        }
        draw_scene(&with.surface, &s);
        without.surface.depth = depth;
        assert_same_picture(&with.surface, &without.surface);
        canvas_free(&with);
        canvas_free(&without);
    }
}

int main(void)
{
    own_565 = qtri_rgb565;
    own_565.kind = QTRI_OTHER_FORMAT;
    return run_all_tests(fill_textures, NULL);
}
