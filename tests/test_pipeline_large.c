/* SPDX-License-Identifier: MIT */
/*
 * Large triangles by pipelines against arithmetic in double precision, and instances against the
 * generic pipeline and against tiles, to the bit.
 */
#include "support/core.h"

#include "qtri/pipeline_make.h"
#include "raster/draw_state.h"
#include "raster/large.h"
#include "raster/triangle.h"

enum { WIDTH = 200, HEIGHT = 150, TEXTURE_LOG2 = 6, TEXTURE = 1 << TEXTURE_LOG2 };

#define LESS_565  .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS
#define LESS_8888 .format = QTRI_XRGB8888, .depth = QTRI_LINEAR16, .compare = QTRI_LESS
QTRI_PIPELINE(large_flat, LESS_565)
QTRI_PIPELINE(large_colors, LESS_565, .shade = QTRI_COLORS)
QTRI_PIPELINE(large_colors_8888, LESS_8888, .shade = QTRI_COLORS)
QTRI_PIPELINE(large_light_8888, LESS_8888, .shade = QTRI_LIGHT)
QTRI_PIPELINE(large_colors_fog, LESS_565, .shade = QTRI_COLORS, .fog = 1)
QTRI_PIPELINE(large_texture, LESS_8888, .texel = QTRI_TEXEL_XRGB8888)
QTRI_PIPELINE(large_texture_linear, LESS_8888, .texel = QTRI_TEXEL_XRGB8888)
QTRI_PIPELINE(large_texture_light, LESS_8888, .texel = QTRI_TEXEL_XRGB8888,
              .shade = QTRI_WHITE_LIGHT)
QTRI_PIPELINE(large_texture_colors, LESS_565, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_COLORS)
QTRI_PIPELINE(large_texture_clamped, LESS_8888, .texel = QTRI_TEXEL_XRGB8888, .wrap_u = QTRI_CLAMP,
              .wrap_v = QTRI_CLAMP)
QTRI_PIPELINE(large_texture_bilinear, LESS_8888, .texel = QTRI_TEXEL_XRGB8888, .bilinear = 1)

#define FLAT_565(compares) .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = (compares)
QTRI_PIPELINE(large_flat_equal_too, FLAT_565(QTRI_LESS_EQUAL))
QTRI_PIPELINE(large_flat_greater, FLAT_565(QTRI_GREATER))
QTRI_PIPELINE(large_flat_not_less, FLAT_565(QTRI_GREATER_EQUAL))
QTRI_PIPELINE(large_flat_equal, FLAT_565(QTRI_EQUAL))
QTRI_PIPELINE(large_flat_over, .format = QTRI_RGB565)

/* Draws the depth that it is given. */
static bool show_depth(qtri_fragment *f)
{
    f->color = f->depth_16p16 >> 8;
    return true;
}

#define SHOWN(format_of) .format = QTRI_XRGB8888, .depth = (format_of), .compare = QTRI_ALWAYS
QTRI_PIPELINE(large_shown, SHOWN(QTRI_LINEAR16), .fragment = show_depth)
QTRI_PIPELINE(large_shown_float, SHOWN(QTRI_FLOAT16), .fragment = show_depth)

static const qtri_pipeline *const instances[] = {
    &large_flat,           &large_colors,          &large_colors_8888,     &large_light_8888,
    &large_colors_fog,     &large_texture,         &large_texture_linear,  &large_texture_light,
    &large_texture_colors, &large_texture_clamped, &large_texture_bilinear};
enum { INSTANCES = sizeof instances / sizeof instances[0] };

/* What triangles look like. */
enum { QUAD, NEEDLE, LEVEL, HUGE_ONE, SMALL, PLAIN, THIN, SHAPES };

typedef struct triangle {
    qtri_point at[3];
    qtri_large_vertex v[3];
} triangle;

static uint64_t seed;
static uint64_t memory[2][WIDTH * HEIGHT + 8];
static uint16_t texels_565[TEXTURE * TEXTURE];
static uint32_t texels_8888[TEXTURE * TEXTURE];
static qtri_fog fog;

static int32_t in(int32_t low, int32_t high)
{
    return random_in(&seed, low, high);
}

static void make_textures(void)
{
    for (uint32_t i = 0; i < TEXTURE * TEXTURE; i++) {
        texels_8888[i] = i << 8 | (i * 37 & 255); /* its number, above blue */
        texels_565[i] = (uint16_t)(i * 40503u >> 4);
    }
    const qtri_rgb gray = {128, 140, 150};
    const qtri_fog_range range = {Q16(.1), Q16(100), false};
    qtri_fog_exp(&fog, gray, range, Q16(.4));
}

/* Drawn with QTRI_SCREEN_LINEAR. */
static bool is_linear(const qtri_options *o)
{
    return o == &large_texture_linear.options;
}

/* Points, and 1/w and depth that fit each other: depth is linear in 1/w. */
static void make_triangle(triangle *t, int shape)
{
    const int32_t far = shape == THIN ? 0 : in(0, 1) ? 2 : 5; /* 1/w of twice as much at most */
    const bool is_high = shape == THIN && in(0, 1);
    memset(t, 0, sizeof *t);
    for (int i = 0; i < 3; i++) {
        qtri_large_vertex *v = &t->v[i];
        t->at[i].x_24p8 = in(-WIDTH * 128, WIDTH * 384);
        t->at[i].y_24p8 = in(-HEIGHT * 128, HEIGHT * 384);
        if (shape == HUGE_ONE) {
            t->at[i].x_24p8 = in(-(1 << 22), 1 << 22);
            t->at[i].y_24p8 = in(-(1 << 22), 1 << 22);
        } else if (shape == LEVEL) {
            t->at[i].y_24p8 = HEIGHT * 128 + in(-700, 700);
        } else if (shape == SMALL) {
            t->at[i].x_24p8 = WIDTH * 128 + in(-40 * 256, 40 * 256);
            t->at[i].y_24p8 = HEIGHT * 128 + in(-40 * 256, 40 * 256);
        } else if (shape == THIN) {
            t->at[i].x_24p8 = WIDTH * 128 + (is_high ? in(-200, 200) : in(-400 * 256, 400 * 256));
            t->at[i].y_24p8 = HEIGHT * 128 + (is_high ? in(-400 * 256, 400 * 256) : in(-200, 200));
        }
        v->inv_w_exponent = in(0, far);
        v->inv_w_q31 = 0x40000000u + (uint32_t)in(0, 0x3FFFFFFF);
        const double inv_w = ldexp(v->inv_w_q31, v->inv_w_exponent - 31);
        v->depth_16p16 = (uint32_t)(65535. * 65536. * (1 - inv_w / 40));
        v->light_q15 = (uint32_t)in(0, 32768);
        for (int k = 0; k < 3; k++) {
            v->color_8p16[k] = in(0, 255) << 16;
        }
        v->u_q32 = (int64_t)in(-3000, 3000) * (1 << 22);
        v->v_q32 = (int64_t)in(-3000, 3000) * (1 << 22);
        v->alpha_q16 = (uint32_t)in(0, 65536);
    }
    if (shape == PLAIN) { /* parallel to the screen */
        for (int i = 1; i < 3; i++) {
            t->v[i].inv_w_q31 = t->v[0].inv_w_q31;
            t->v[i].inv_w_exponent = t->v[0].inv_w_exponent;
        }
    }
    if (shape == NEEDLE) {
        t->at[2].x_24p8 = (t->at[0].x_24p8 + t->at[1].x_24p8) / 2 + in(-300, 300);
        t->at[2].y_24p8 = (t->at[0].y_24p8 + t->at[1].y_24p8) / 2 + in(-300, 300);
    }
}

static void set_surface(qtri_surface *s, const qtri_format *format, int which)
{
    const qtri_rgb black = {0, 0, 0};
    assert_ok(qtri_surface_init(s, format, WIDTH, HEIGHT, 0, HEIGHT, memory[which],
                                sizeof memory[which]));
    qtri_surface_clear(s, black);
}

static void draw(const qtri_pipeline *pipeline, const qtri_options *o, const qtri_surface *s,
                 const triangle *t)
{
    static qtri_draw_state state;
    static uint16_t table[QTRI_TABLE];
    qtri_material m = qtri_material_default();
    qtri_texture texture;
    memset(&texture, 0, sizeof texture);
    texture.width_log2 = TEXTURE_LOG2;
    texture.height_log2 = TEXTURE_LOG2;
    texture.format = o->texel == QTRI_TEXEL_RGB565 ? &qtri_texel_rgb565 : &qtri_texel_xrgb8888;
    texture.texels =
        o->texel == QTRI_TEXEL_RGB565 ? (const void *)texels_565 : (const void *)texels_8888;
    texture.wrap_u = (qtri_wrap)o->wrap_u;
    texture.wrap_v = (qtri_wrap)o->wrap_v;
    texture.filter = o->bilinear ? &qtri_bilinear : NULL;
    m.texture = o->texel != QTRI_NO_TEXEL ? &texture : NULL;
    m.texture_mode = o->shade == QTRI_FLAT ? QTRI_REPLACE : QTRI_MODULATE;
    m.interpolation = is_linear(o) ? QTRI_SCREEN_LINEAR : QTRI_PERSPECTIVE;
    m.fog = o->fog ? &fog : NULL;
    m.depth_compare = (qtri_compare)o->compare;
    m.fragment = o->fragment;
    const qtri_rgb white = {255, 255, 255};
    m.color = white;
    const qtri_pipeline *const list[] = {pipeline, NULL};
    qtri_draw_state_init(&state, s, list, &m, m.texture,
                         o->shade == QTRI_WHITE_LIGHT ? QTRI_LIGHT : o->shade);
    state.table = table;
    assert_true(state.pipeline == pipeline);
    const qtri_point *const p[3] = {&t->at[0], &t->at[1], &t->at[2]};
    qtri_large_triangle(&state, p, qtri_triangle_area(p[0], p[1], p[2]), 0xFFB45A, t->v);
}

static const qtri_format *format_of(const qtri_options *o)
{
    return o->format == QTRI_RGB565 ? &qtri_rgb565 : &qtri_xrgb8888;
}

TEST(instances_have_the_bits_of_the_generic_one_and_of_tiles)
{
    make_textures();
    for (int n = 0; n < INSTANCES * SHAPES * 12; n++) {
        const qtri_pipeline *pipeline = instances[n % INSTANCES];
        const qtri_options *o = &pipeline->options;
        qtri_surface a, b;
        triangle t;
        seed = 77u + (uint32_t)n;
        make_triangle(&t, n / INSTANCES % SHAPES);
        set_surface(&a, format_of(o), 0);
        draw(pipeline, o, &a, &t);
        set_surface(&b, format_of(o), 1);
        draw(&qtri_pipeline_any, o, &b, &t);
        if (memcmp(memory[0], memory[1], sizeof memory[0]) != 0) {
            fail_msg("triangle %d of instance %d: the generic pipeline differs", n, n % INSTANCES);
        }
        set_surface(&b, format_of(o), 1);
        for (int y = 0; y < HEIGHT; y += 17) {
            for (int x = 0; x < WIDTH; x += 41) {
                const qtri_rect tile = {x, y, x + 41, y + 17};
                b.scissor = tile;
                draw(pipeline, o, &b, &t);
            }
        }
        if (memcmp(memory[0], memory[1], sizeof memory[0]) != 0) {
            fail_msg("triangle %d of instance %d: tiles differ", n, n % INSTANCES);
        }
    }
}

/* In double precision ----------------------------------------------------------------------------
 */

/* Weights of the vertices at a pixel's centre; false: it is not covered, by the top-left rule. */
static bool weights_at(const triangle *t, int x, int y, double b[3])
{
    const int64_t cx = 256 * x + 128, cy = 256 * y + 128;
    const qtri_point *p = t->at;
    const int64_t area = qtri_triangle_area(&p[0], &p[1], &p[2]);
    for (int i = 0; i < 3; i++) {
        const qtri_point *j = &p[(i + 1) % 3], *k = &p[(i + 2) % 3];
        int64_t edge = (j->x_24p8 - cx) * (k->y_24p8 - cy) - (k->x_24p8 - cx) * (j->y_24p8 - cy);
        int64_t dx = k->x_24p8 - j->x_24p8, dy = k->y_24p8 - j->y_24p8;
        b[i] = (double)edge / (double)area;
        if (area < 0) {
            edge = -edge;
            dx = -dx;
            dy = -dy;
        }
        if (edge < 0 || (edge == 0 && !(dy < 0 || (dy == 0 && dx > 0)))) {
            return false;
        }
    }
    return area != 0;
}

typedef struct errors {
    double depth, color;
    int covered, wrong_texels;
} errors;

static bool passes(int compare, uint32_t z, uint32_t stored)
{
    switch (compare) {
    case QTRI_LESS:
        return z < stored;
    case QTRI_LESS_EQUAL:
        return z <= stored;
    case QTRI_GREATER:
        return z > stored;
    case QTRI_GREATER_EQUAL:
        return z >= stored;
    case QTRI_EQUAL:
        return z == stored;
    default:
        return true;
    }
}

/* Four flat pixels may be drawn at once (quads.h): each is tested by itself, on either side of
 * equal.
 */
TEST(flat_pixels_are_tested_one_by_one)
{
    static const qtri_pipeline *const flat[] = {&large_flat,         &large_flat_equal_too,
                                                &large_flat_greater, &large_flat_not_less,
                                                &large_flat_equal,   &large_flat_over};
    static uint16_t stored[WIDTH * HEIGHT];
    static const uint32_t part[4] = {0, 1, 0x8000,
                                     0xFFFF}; /* of a step, the half that rounds in it */
    for (int n = 0; n < 6 * 4 * 4; n++) {
        const int compare = flat[n % 6]->options.compare;
        const uint32_t z = n % 7 == 0 ? 1 : n % 7 == 1 ? 65534 : (uint32_t)in(1, 65534);
        const int32_t left = in(0, 9);
        qtri_surface s;
        triangle t;
        memset(&t, 0, sizeof t);
        for (int i = 0; i < 3; i++) {
            t.v[i].inv_w_q31 = 0x40000000u;
            t.v[i].depth_16p16 = z * 65536 + part[n / 6 % 4] - 0x8000u;
        }
        t.at[0].x_24p8 = t.at[1].x_24p8 = left * 256;
        t.at[1].y_24p8 = 2 * HEIGHT * 256;
        t.at[2].x_24p8 = 2 * WIDTH * 256;
        set_surface(&s, &qtri_rgb565, 0);
        s.depth += n / 24 % 2; /* words begin elsewhere than those of pixels */
        uint16_t *const pixels = (uint16_t *)s.pixels, *const depths = (uint16_t *)s.depth;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            stored[i] = depths[i] = (uint16_t)(z - 1 + (uint32_t)in(0, 2));
        }
        draw(flat[n % 6], &flat[n % 6]->options, &s, &t);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double b[3];
            const bool drawn =
                weights_at(&t, i % WIDTH, i / WIDTH, b) && passes(compare, z, stored[i]);
            assert_int_equal(pixels[i] != 0, drawn);
            assert_int_equal(depths[i], drawn && compare != QTRI_DEPTH_OFF ? z : stored[i]);
        }
    }
}

/* However it is stored: of float16 an octave's depths are counted from where it begins. */
TEST(fragments_are_given_the_same_depth)
{
    int many = 0;
    for (int n = 0; n < random_cases(200); n++) {
        qtri_surface linear, stored_as_float;
        triangle t;
        set_surface(&linear, &qtri_xrgb8888, 0);
        set_surface(&stored_as_float, &qtri_xrgb8888, 1);
        stored_as_float.depth_format = &qtri_depth_float16;
        make_triangle(&t, n % SHAPES);
        draw(&large_shown, &large_shown.options, &linear, &t);
        draw(&large_shown_float, &large_shown_float.options, &stored_as_float, &t);
        assert_memory_equal(linear.pixels, stored_as_float.pixels, WIDTH * HEIGHT * 4);
        const uint32_t *pixels = (const uint32_t *)(const void *)linear.pixels;
        for (int i = 1; i < WIDTH * HEIGHT; i++) {
            many += pixels[i] != pixels[i - 1];
        }
    }
    assert_true(many > random_cases(200) * 1000);
}

static double difference(double a, double b)
{
    return fabs(a - b);
}

static double number_at(const triangle *t, const double b[3], bool linear, int i)
{
    double value = 0, q = 0;
    for (int k = 0; k < 3; k++) {
        const qtri_large_vertex *v = &t->v[k];
        const double w = linear ? 1 : ldexp(v->inv_w_q31, v->inv_w_exponent - 31);
        const double f = i < 3    ? v->color_8p16[i] / 65536.
                         : i == 3 ? v->light_q15 / 32768.
                         : i == 4 ? (double)v->u_q32 / 4294967296.
                                  : (double)v->v_q32 / 4294967296.;
        value += b[k] * w * f;
        q += b[k] * w;
    }
    return value / q;
}

static void judge_color(errors *e, const qtri_options *o, uint32_t pixel, const triangle *t,
                        const double b[3])
{
    for (int i = 0; i < 3; i++) {
        double drawn, full = 255;
        if (o->format == QTRI_RGB565) {
            drawn = i == 0 ? pixel >> 11 : i == 1 ? pixel >> 5 & 63 : pixel & 31;
            full = i == 1 ? 63 : 31;
        } else {
            drawn = pixel >> (16 - 8 * i) & 255;
        }
        const double wanted =
            o->shade == QTRI_LIGHT ? number_at(t, b, false, 3) : number_at(t, b, false, i) / 255;
        e->color = fmax(e->color, difference(drawn, wanted * full));
    }
}

static void judge_texel(errors *e, const qtri_options *o, uint32_t pixel, const triangle *t,
                        const double b[3])
{
    const double side = TEXTURE;
    int64_t u = (int64_t)floor(number_at(t, b, is_linear(o), 4) * side);
    int64_t v = (int64_t)floor(number_at(t, b, is_linear(o), 5) * side);
    if (o->wrap_u == QTRI_CLAMP) {
        u = u < 0 ? 0 : (u >= TEXTURE ? TEXTURE - 1 : u);
        v = v < 0 ? 0 : (v >= TEXTURE ? TEXTURE - 1 : v);
    }
    const uint32_t number = (uint32_t)((v & (TEXTURE - 1)) * TEXTURE + (u & (TEXTURE - 1)));
    e->wrong_texels += pixel != texels_8888[number];
}

static void judge(errors *e, const qtri_pipeline *pipeline, const triangle *t)
{
    const qtri_options *o = &pipeline->options;
    qtri_surface s;
    set_surface(&s, format_of(o), 0);
    draw(pipeline, o, &s, t);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            double b[3];
            const uint16_t z = s.depth[y * s.depth_pitch + x];
            const bool covered = weights_at(t, x, y, b);
            if (covered != (z != 65535)) {
                fail_msg("pixel %d, %d is %scovered", x, y, covered ? "" : "not ");
            }
            if (!covered) {
                continue;
            }
            const uint8_t *at = s.pixels + y * s.pitch;
            const uint32_t pixel = o->format == QTRI_RGB565
                                       ? ((const uint16_t *)(const void *)at)[x]
                                       : ((const uint32_t *)(const void *)at)[x];
            double depth = 0;
            for (int k = 0; k < 3; k++) {
                depth += b[k] * t->v[k].depth_16p16 / 65536.;
            }
            e->covered++;
            e->depth = fmax(e->depth, difference(depth, z));
            if (o->texel != QTRI_NO_TEXEL) {
                judge_texel(e, o, pixel, t, b);
            } else if (o->shade != QTRI_FLAT) {
                judge_color(e, o, pixel, t, b);
            }
        }
    }
}

TEST(pixels_are_those_of_double_precision)
{
    static const struct {
        const qtri_pipeline *pipeline;
        double color, wrong_texels; /* at most; of 100,000 */
    } bound[] = {{&large_flat, 0, 0},
                 {&large_colors, .8, 0},
                 {&large_colors_8888, 1, 0},
                 {&large_light_8888, 1.15, 0}, /* a weight of 8 bits, a product rounded */
                 {&large_texture, 0, 300},
                 {&large_texture_linear, 0, 10},
                 {&large_texture_clamped, 0, 100}};
    make_textures();
    for (size_t i = 0; i < sizeof bound / sizeof bound[0]; i++) {
        for (int shape = 0; shape < SHAPES; shape++) {
            errors e = {0, 0, 0, 0};
            for (uint32_t n = 0; n < 40; n++) {
                triangle t;
                seed = 1000u * (uint32_t)shape + n;
                make_triangle(&t, shape);
                judge(&e, bound[i].pipeline, &t);
            }
            const double wrong = 1e5 * e.wrong_texels / e.covered;
            printf("    %d.%d: %d pixels, depth off by %.2f, colour by %.2f, wrong texels %.1f\n",
                   (int)i, shape, e.covered, e.depth, e.color, wrong);
            assert_true(e.covered > 500);
            assert_true(e.depth < 1);
            assert_true(e.color <= bound[i].color);
            assert_true(wrong <= bound[i].wrong_texels);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
