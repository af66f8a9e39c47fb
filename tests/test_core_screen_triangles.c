/* SPDX-License-Identifier: MIT */
/*
 * Small triangles: depths and colours of few steps against double precision, pixels against the
 * fill rule and models of the depth test, whatever they look like.
 */
#include "support/core.h"

#include "support/triangle.h"

enum { WIDTH = 96, HEIGHT = 84 };

static uint32_t colors[1 << 16];

/* kind 0: any; 1: tiny; 2: slivers; 3: with steep depth; 4: level. */
static void random_triangle(qtri_screen_vertex v[3], uint64_t *seed, int kind)
{
    const int32_t reach = kind == 1 ? random_in(seed, 1, 600) : random_in(seed, 256, 9215);
    const int32_t x = random_in(seed, 0, WIDTH * 256);
    const int32_t y = random_in(seed, 0, HEIGHT * 256);
    const int32_t depth_reach = kind == 3 ? 65535 : (int32_t)1 << random_in(seed, 0, 16 - 1);
    const int32_t depth = random_in(seed, 0, 65535 - depth_reach);
    const double w = 1 + random_in(seed, 0, 1000) / 1000.0;
    const int32_t w_reach = kind == 4 ? 0 : random_in(seed, 0, 70);
    const int32_t uv_reach = (int32_t)1 << random_in(seed, 4, 17);
    const int32_t u = random_in(seed, -200000, 200000);
    for (int i = 0; i < 3; i++) {
        const int32_t dx = i == 0 ? 0 : random_in(seed, -reach, reach);
        const int32_t dy = i == 0 ? 0 : random_in(seed, -reach, reach);
        v[i] = screen_at(x + dx, y + dy);
        v[i].depth_16p16 =
            (uint32_t)depth * 65536 + (uint32_t)random_in(seed, 0, depth_reach) * 65536u;
        v[i].inv_w_q31 = (uint32_t)floor(
            ldexp(w * (1 + (i == 0 ? 0 : random_in(seed, -w_reach, w_reach) / 1000.0)), 29));
        v[i].u_q32 = (int64_t)(u + random_in(seed, -uv_reach, uv_reach)) * 65536;
        v[i].v_q32 = (int64_t)(u + random_in(seed, -uv_reach, uv_reach)) * 65536;
        for (int channel = 0; channel < 3; channel++) {
            v[i].color_8p16[channel] = random_in(seed, 0, 255 << 16);
        }
    }
    if (kind == 2) {
        v[2].x_24p8 = v[0].x_24p8 + (v[1].x_24p8 - v[0].x_24p8) / 3 + random_in(seed, -20, 20);
        v[2].y_24p8 = v[0].y_24p8 + (v[1].y_24p8 - v[0].y_24p8) / 3 + random_in(seed, -20, 20);
    }
}

/* Weights at a pixel's centre, as shares of the area; without perspective. False: not covered. */
static bool weights(double b[3], const qtri_screen_vertex v[3], int32_t x, int32_t y)
{
    int64_t edge[3];
    const int64_t area = (int64_t)(v[1].x_24p8 - v[0].x_24p8) * (v[2].y_24p8 - v[0].y_24p8) -
                         (int64_t)(v[2].x_24p8 - v[0].x_24p8) * (v[1].y_24p8 - v[0].y_24p8);
    bool inside = area != 0;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *p = &v[(i + 1) % 3];
        const qtri_screen_vertex *q = &v[(i + 2) % 3];
        int32_t dx = q->x_24p8 - p->x_24p8;
        int32_t dy = q->y_24p8 - p->y_24p8;
        edge[i] =
            (int64_t)dx * (y * 256 + 128 - p->y_24p8) - (int64_t)dy * (x * 256 + 128 - p->x_24p8);
        b[i] = (double)edge[i] / (double)area;
        if (area < 0) {
            dx = -dx;
            dy = -dy;
            edge[i] = -edge[i];
        }
        /* Clockwise as seen: up on the left, to the right on top. */
        inside = inside && (edge[i] > 0 || (edge[i] == 0 && (dy < 0 || (dy == 0 && dx > 0))));
    }
    return inside;
}

static qtri_material drawn_material(void)
{
    qtri_material m = qtri_material_default();
    m.cull = QTRI_CULL_NONE;
    m.depth_compare = QTRI_ALWAYS;
    return m;
}

/*
 * Depths that differ by less than 128 steps, by less than 256 within 32 pixels, keep all of their
 * 1/256 steps: a small triangle's are the nearest, but for what its reciprocal is off by.
 */
TEST(depths_of_small_ranges_are_the_nearest)
{
    uint64_t seed = 41;
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    double worst[2] = {0, 0};
    int pixels[2] = {0, 0}, small[2] = {0, 0};
    qtri_material m = drawn_material();
    m.shading = QTRI_FLAT_FIRST;
    for (int n = 0; n < random_cases(6000); n++) {
        qtri_screen_vertex v[3];
        const int wide = n % 2;
        const int32_t reach = wide != 0 ? 15000 : 8100, range = (wide != 0 ? 128 : 256) * 256 - 1;
        for (int i = 0; i < 3; i++) {
            const int32_t sign = random_flag(&seed) ? 1 : -1;
            v[i] = screen_at(WIDTH * 128, HEIGHT * 128);
            v[i].depth_16p16 = (uint32_t)1 << 30;
            if (i > 0) {
                v[i].x_24p8 += random_in(&seed, -reach, reach);
                v[i].y_24p8 += random_in(&seed, -reach, reach);
                v[i].depth_16p16 += (uint32_t)(sign * random_in(&seed, range / 2, range)) << 8;
            }
        }
        canvas_clear(&c);
        small[wide] += draw_triangle(&c.surface, &m, v, true) == TRIANGLE_SMALL;
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            double b[3];
            if (weights(b, v, i % WIDTH, i / WIDTH)) {
                const double depth =
                    (b[0] * v[0].depth_16p16 + b[1] * v[1].depth_16p16 + b[2] * v[2].depth_16p16) /
                    65536;
                const double error = fabs(stored_depth(&c.surface, i % WIDTH, i / WIDTH) - depth);
                worst[wide] = fmax(worst[wide], error);
                pixels[wide]++;
            }
        }
    }
    print_message(
        "depth off by %.4f in %d pixels of %d triangles, of wide ones by %.4f in %d of %d\n",
        worst[0], pixels[0], small[0], worst[1], pixels[1], small[1]);
    assert_true(small[0] > random_cases(1000) && small[1] > random_cases(1000));
    assert_true(worst[0] < 0.52 && worst[1] < 0.52);
    canvas_free(&c);
}

/* Red of RGB565 whose step, to the right or down, lies on a half of what is kept of it: rounded to
   the other side these would be off by 0.84 and more of a step of red. */
TEST(steps_of_red_are_rounded_to_the_nearest)
{
    static const int32_t corner[3][3][3] = {
        {{10240, 10240, 64}, {17568, 3057, 53}, {13244, 4972, 116}},
        {{10240, 10240, 61}, {18247, 4027, 30}, {18188, 5411, 214}},
        {{10240, 10240, 29}, {7388, 15415, 91}, {3625, 17148, 197}}};
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    qtri_material m = drawn_material();
    m.shading = QTRI_SMOOTH;
    for (int n = 0; n < 3; n++) {
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = screen_at(corner[n][i][0], corner[n][i][1]);
            v[i].color_8p16[0] = corner[n][i][2] << 16;
            v[i].color_8p16[1] = v[i].color_8p16[2] = 0;
        }
        canvas_clear(&c);
        assert_int_equal(draw_triangle(&c.surface, &m, v, true), TRIANGLE_SMALL);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            double b[3], red = 0;
            if (weights(b, v, i % WIDTH, i / WIDTH)) {
                for (int k = 0; k < 3; k++) {
                    red += b[k] * corner[n][k][2] * 31 / 255;
                }
                assert_near(stored_pixel(&c.surface, i % WIDTH, i / WIDTH) >> 11, red, .55);
            }
        }
    }
    canvas_free(&c);
}

static void random_material(qtri_material *m, qtri_texture *t, uint64_t *seed)
{
    static const qtri_texel_format *const formats[3] = {&qtri_texel_rgb565, &qtri_texel_xrgb8888,
                                                        &qtri_texel_gray8};
    *m = drawn_material();
    m->shading = shading_of((int)random_in(seed, 0, 2));
    m->interpolation = (qtri_interpolation)random_in(seed, 0, 1);
    m->texture_mode = (qtri_texture_mode)random_in(seed, 0, 1);
    m->depth_compare = (qtri_compare)random_in(seed, 0, 9);
    m->depth_read_only = random_in(seed, 0, 3) == 0;
    qtri_texture texture = {.texels = colors, .format = formats[random_in(seed, 0, 2)]};
    texture.width_log2 = (uint8_t)random_in(seed, 0, 8);
    texture.height_log2 = (uint8_t)random_in(seed, 0, 8);
    static const qtri_filter *const filters[4] = {&qtri_bilinear, &qtri_mipmapped,
                                                  &qtri_mipmapped_bilinear};
    static const void *const levels[4] = {colors + 1, colors + 7, colors + 3, colors};
    texture.filter = filters[random_in(seed, 0, 3)];
    texture.levels = levels; /* any texels */
    texture.level_count = 4;
    texture.wrap_u = random_in(seed, 0, 3) == 0 ? QTRI_CLAMP : QTRI_REPEAT;
    texture.wrap_v = random_in(seed, 0, 3) == 0 ? QTRI_CLAMP : QTRI_REPEAT;
    texture.has_key = random_in(seed, 0, 2) == 0;
    texture.key = texture.format == &qtri_texel_gray8 ? 3 : colors[0];
    *t = texture;
    m->texture = random_flag(seed) ? t : NULL;
}

static void random_background(canvas *c, uint64_t *seed)
{
    uint8_t *bytes = c->memory;
    for (size_t i = 0; i < c->bytes; i++) {
        bytes[i] = (uint8_t)random64(seed);
    }
}

static void copy_pixel(const qtri_surface *to, const qtri_surface *from, int32_t x, int32_t y)
{
    const size_t bytes = to->format->pixels->bytes;
    memcpy(to->pixels + y * to->pitch + x * (ptrdiff_t)bytes,
           from->pixels + y * from->pitch + x * (ptrdiff_t)bytes, bytes);
    to->depth[y * to->depth_pitch + x] = from->depth[y * from->depth_pitch + x];
}

static bool passes(qtri_compare compare, uint32_t z, uint32_t stored)
{
    switch (compare) {
    case QTRI_NEVER:
        return false;
    case QTRI_LESS:
        return z < stored;
    case QTRI_EQUAL:
        return z == stored;
    case QTRI_LESS_EQUAL:
        return z <= stored;
    case QTRI_GREATER:
        return z > stored;
    case QTRI_NOT_EQUAL:
        return z != stored;
    case QTRI_GREATER_EQUAL:
        return z >= stored;
    default:
        return true;
    }
}

/* Every comparison, by what the triangle is without one. */
TEST(comparisons)
{
    uint64_t seed = 5;
    canvas drawn = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas always = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < random_cases(6000); n++) {
        qtri_screen_vertex v[3];
        qtri_material m;
        qtri_texture texture;
        random_triangle(v, &seed, n % 5);
        random_material(&m, &texture, &seed);
        texture.has_key = false;
        random_background(&drawn, &seed);
        if (n % 2 == 0) { /* many equal ones */
            for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
                drawn.surface.depth[i] = (uint16_t)(v[i % 3].depth_16p16 >> 16);
            }
        }
        memcpy(always.memory, drawn.memory, drawn.bytes);
        canvas before = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
        memcpy(before.memory, drawn.memory, drawn.bytes);
        qtri_raster_triangle(&drawn.surface, qtri_pipelines_default, &m, v);
        const qtri_compare compare = m.depth_compare;
        const bool read_only = m.depth_read_only;
        m.depth_compare = QTRI_ALWAYS;
        m.depth_read_only = false;
        qtri_raster_triangle(&always.surface, qtri_pipelines_default, &m, v);
        const qtri_rect box = pixels_around(&drawn.surface, v);
        for (screen_pixel at = first_pixel(box); at.y < box.y1; at = next_pixel(at, box)) {
            double b[3];
            const int32_t x = at.x;
            const int32_t y = at.y;
            const uint16_t stored = stored_depth(&before.surface, x, y);
            const uint16_t z = stored_depth(&always.surface, x, y);
            const bool passed = weights(b, v, x, y) && passes(compare, z, stored);
            const bool written = passed && !read_only && compare != QTRI_DEPTH_OFF;
            assert_int_equal(stored_depth(&drawn.surface, x, y), written ? z : stored);
            assert_int_equal(stored_pixel(&drawn.surface, x, y),
                             stored_pixel(passed ? &always.surface : &before.surface, x, y));
            copy_pixel(&drawn.surface, &before.surface, x, y);
        }
        assert_memory_equal(drawn.memory, before.memory, drawn.bytes); /* nothing outside */
        canvas_free(&before);
    }
    canvas_free(&drawn);
    canvas_free(&always);
}

int main(void)
{
    uint64_t seed = 6;
    for (size_t i = 0; i < LENGTH_OF(colors); i++) {
        colors[i] = (uint32_t)random64(&seed) & (i % 3 == 0 ? 0x0F0F0F : 0xFFFFFF);
    }
    return run_all_tests(NULL, NULL);
}
