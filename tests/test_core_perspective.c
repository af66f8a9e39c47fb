/* SPDX-License-Identifier: MIT */
/*
 * Perspective along rows against double precision from the snapped vertices: texture coordinates
 * within 1/256 of a texel, or of what a pixel steps by; colours within 3/4 of a step.
 */
#include "support/core.h"
#include "support/shares.h"
#include "support/steps.h"

enum { WIDTH = 320, HEIGHT = 240, SIDE_MAX = 1024 };

static uint32_t texels32[SIDE_MAX * SIDE_MAX];
static uint16_t texels16[65536];

static void number_texels(void)
{
    for (uint32_t i = 0; i < SIDE_MAX * SIDE_MAX; i++) {
        texels32[i] = i;
    }
    for (uint32_t i = 0; i < 65536; i++) {
        texels16[i] = (uint16_t)i;
    }
}

static double uniform(uint64_t *seed)
{
    return ldexp((double)(random64(seed) >> 11), -53);
}

/* Screen position in pixels, distance, coordinates in repeats. */
typedef struct corner {
    double x, y, w, u, v, color[3];
} corner;

static qtri_screen_vertex vertex_of(const corner *c)
{
    qtri_screen_vertex v = screen_at((int32_t)lrint(c->x * 256), (int32_t)lrint(c->y * 256));
    int exponent;
    v.inv_w_q31 = (uint32_t)lrint(ldexp(frexp(1 / c->w, &exponent), 31));
    v.inv_w_exponent = exponent;
    v.depth_16p16 = 1000 << 16;
    v.u_q32 = llrint(ldexp(c->u, 32));
    v.v_q32 = llrint(ldexp(c->v, 32));
    for (int i = 0; i < 3; i++) {
        v.color_8p16[i] = (int32_t)lrint(c->color[i] * 65536);
    }
    return v;
}

/* What a pixel should have. */
typedef struct exact {
    double u, v, color[3];
} exact;

static exact exact_at(const qtri_screen_vertex t[3], int32_t x, int32_t y)
{
    exact e = {0, 0, {0, 0, 0}};
    double b[3];
    shares_at(b, t, x, y, true);
    for (int i = 0; i < 3; i++) {
        e.u += b[i] * ldexp((double)t[i].u_q32, -32);
        e.v += b[i] * ldexp((double)t[i].v_q32, -32);
        for (int k = 0; k < 3; k++) {
            e.color[k] += b[i] * t[i].color_8p16[k] / 65536.0;
        }
    }
    return e;
}

/* How far a coordinate, in texels, is outside of texel `index` of a side that repeats. */
static double outside(double coordinate, int index, int side)
{
    double offset = coordinate - index;
    offset -= floor(offset / side) * side; /* 0..side */
    return offset <= 1 ? 0 : fmin(offset - 1, side - offset);
}

typedef struct tally {
    long pixels, other, farther;
    double worst; /* in 1/256 of a texel or a step */
} tally;

/* Leaves the canvas cleared. */
static void judge(tally *sum, canvas *c, const canvas *cleared, const qtri_screen_vertex t[3],
                  const qtri_texture *texture)
{
    const int width = 1 << texture->width_log2;
    const int height = 1 << texture->height_log2;
    const qtri_rect box = pixels_around(&c->surface, t);
    for (screen_pixel p = first_pixel(box); p.y < box.y1; p = next_pixel(p, box)) {
        if (stored_depth(&c->surface, p.x, p.y) == 65535) {
            continue;
        }
        const uint32_t texel = stored_pixel(&c->surface, p.x, p.y);
        const exact at = exact_at(t, p.x, p.y);
        const exact right = exact_at(t, p.x + 1, p.y);
        const exact below = exact_at(t, p.x, p.y + 1);
        double step = fmax(fabs(right.u - at.u), fabs(below.u - at.u)) * width;
        step = fmax(step, fmax(fabs(right.v - at.v), fabs(below.v - at.v)) * height);
        const double u = outside(at.u * width, (int)(texel & (uint32_t)(width - 1)), width);
        const double v = outside(at.v * height, (int)(texel >> texture->width_log2), height);
        sum->pixels++;
        sum->other += u > 0 || v > 0;
        sum->farther += fmax(u, v) > fmax(1, step / 256);
        sum->worst = fmax(sum->worst, 256 * fmax(u, v) / fmax(1, step));
    }
    erase_and_check(c, box, cleared);
}

static qtri_texture texture_of(const qtri_format *format, int width_log2, int height_log2)
{
    const bool narrow = format == &qtri_rgb565 && width_log2 + height_log2 <= 16;
    qtri_texture t = {
        .texels = narrow ? (const void *)texels16 : texels32,
        .format = narrow ? &qtri_texel_rgb565 : &qtri_texel_xrgb8888,
        .width_log2 = (uint8_t)width_log2,
        .height_log2 = (uint8_t)height_log2,
    };
    return t;
}

static void draw(const canvas *c, const qtri_texture *texture, const qtri_screen_vertex t[3])
{
    qtri_material m = plain_material();
    m.texture = texture;
    m.texture_mode = QTRI_REPLACE;
    m.shading = QTRI_SMOOTH;
    m.depth_compare = QTRI_LESS;
    qtri_raster_triangle(&c->surface, qtri_pipelines_default, &m, t);
}

static corner random_corner(uint64_t *seed, double reach, double ratio, double repeats)
{
    corner c = {.x = WIDTH / 2 + (2 * uniform(seed) - 1) * reach,
                .y = HEIGHT / 2 + (2 * uniform(seed) - 1) * reach,
                .w = pow(ratio, uniform(seed)),
                .u = uniform(seed) * repeats,
                .v = uniform(seed) * repeats};
    for (int i = 0; i < 3; i++) {
        c.color[i] =
            random_in(seed, 0, 4) == 0 ? 255.0 * random_in(seed, 0, 1) : uniform(seed) * 255;
    }
    return c;
}

/* Random triangles: how far they reach from the middle, and up to which ratio of w. */
static tally random_triangles(uint64_t seed, int count, const qtri_format *format, double reach,
                              double ratio, double repeats, int side_log2)
{
    tally sum = {0, 0, 0, 0};
    canvas c = canvas_new(format, WIDTH, HEIGHT);
    const canvas cleared = canvas_new(format, WIDTH, HEIGHT);
    for (int n = 0; n < random_cases(count); n++) {
        const int width_log2 = side_log2 != 0 ? side_log2 : random_in(&seed, 1, 10);
        int height_log2 = side_log2 != 0 ? side_log2 : random_in(&seed, 1, 10);
        if (format == &qtri_rgb565 && width_log2 + height_log2 > 16) {
            height_log2 = 16 - width_log2;
        }
        const qtri_texture texture = texture_of(format, width_log2, height_log2);
        const double limit = pow(ratio, uniform(&seed));
        qtri_screen_vertex t[3];
        for (int i = 0; i < 3; i++) {
            corner at = random_corner(&seed, reach, limit, repeats);
            t[i] = vertex_of(&at);
        }
        draw(&c, &texture, t);
        judge(&sum, &c, &cleared, t, &texture);
    }
    canvas_free(&c);
    free(cleared.memory);
    return sum;
}

/* Rectangles turned about y and rolled: degrees, repeats, distance of the nearer side, ratio of w.
 */
static tally walls(uint64_t seed, int count, const qtri_format *format, double degrees,
                   double repeats, double near_w, double ratio, int side_log2)
{
    tally sum = {0, 0, 0, 0};
    canvas c = canvas_new(format, WIDTH, HEIGHT);
    const canvas cleared = canvas_new(format, WIDTH, HEIGHT);
    const qtri_texture texture = texture_of(format, side_log2, side_log2);
    const double turn = degrees * acos(-1) / 180;
    for (int n = 0; n < count; n++) {
        const double left = -2.2 + uniform(&seed) * .3;
        const double distance = near_w - left * sin(turn);
        const double right = (near_w * ratio - distance) / sin(turn);
        const double roll = n % 4 == 0 ? 0 : (uniform(&seed) - .5) * .5;
        const double half = 1.5 + uniform(&seed) * .3;
        const int mirror = n % 2 == 0 ? 1 : -1;
        corner q[4];
        for (int i = 0; i < 4; i++) {
            const double along = i == 1 || i == 2 ? right : left;
            const double w = distance + along * sin(turn);
            const double x = mirror * along * cos(turn) / w * 207.8;
            const double y = (i >= 2 ? half : -half) / w * 207.8;
            q[i] = (corner){.x = WIDTH / 2 + x * cos(roll) - y * sin(roll),
                            .y = HEIGHT / 2 + x * sin(roll) + y * cos(roll),
                            .w = w,
                            .u = i == 1 || i == 2 ? repeats : 0,
                            .v = i >= 2 ? repeats : 0};
        }
        for (int half_quad = 0; half_quad < 2; half_quad++) {
            qtri_screen_vertex t[3] = {vertex_of(&q[0]), vertex_of(&q[1 + half_quad]),
                                       vertex_of(&q[2 + half_quad])};
            draw(&c, &texture, t);
            judge(&sum, &c, &cleared, t, &texture);
        }
    }
    canvas_free(&c);
    free(cleared.memory);
    return sum;
}

/*
 * Floors whose far side is level but for some units of 1/w, 2^-31 of the near corner's, and small
 * beside that: rows that may take one division, and begin anywhere in the frame.
 */
static tally level_rows(uint64_t seed, int count, int ratio_log2, double width, int32_t units,
                        double repeats)
{
    tally sum = {0, 0, 0, 0};
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    const canvas cleared = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    const qtri_texture texture = texture_of(&qtri_xrgb8888, 8, 8);
    for (int n = 0; n < count; n++) {
        qtri_screen_vertex t[3];
        corner at[3];
        for (int i = 0; i < 3; i++) {
            const double far = ldexp(1, -random_in(&seed, 0, ratio_log2));
            const double more = ldexp(random_in(&seed, 0, units), -31);
            at[i] = (corner){.x = i == 0 ? uniform(&seed) * WIDTH
                                         : at[0].x + (uniform(&seed) - .5) * width,
                             .y = HEIGHT / 4 + uniform(&seed) * (n % 2 == 0 ? .2 : 60),
                             .w = 1 / (i == 0 ? far : 1 / at[0].w + more),
                             .u = uniform(&seed) * repeats,
                             .v = uniform(&seed) * repeats};
        }
        at[2].y = HEIGHT + uniform(&seed) * 9000;
        at[2].w = 1;
        for (int i = 0; i < 3; i++) {
            t[i] = vertex_of(&at[i]);
        }
        draw(&c, &texture, t);
        judge(&sum, &c, &cleared, t, &texture);
    }
    canvas_free(&c);
    free(cleared.memory);
    return sum;
}

static void report(const char *what, tally sum)
{
    print_message("%-36s %8ld pixels, other texel %.3f %%, worst %.3f / 256\n", what, sum.pixels,
                  100.0 * (double)sum.other / (double)sum.pixels, sum.worst);
    assert_true(sum.pixels > 10000);
    assert_int_equal(sum.farther, 0);
    assert_true((double)sum.other <= .005 * (double)sum.pixels);
    assert_true(sum.worst <= 8); /* 2^-5 of a texel, or of a step where that is more */
}

TEST(texels)
{
    number_texels();
    for (int n = 0; n < 2; n++) {
        const qtri_format *format = n == 0 ? &qtri_rgb565 : &qtri_xrgb8888;
        report("64 x 64, w to 1:32", random_triangles(1, 400, format, 200, 32, 8, 6));
        report("any side, w to 1:100", random_triangles(2, 400, format, 200, 100, 4, 0));
        report("few repeats, w to 1:4", random_triangles(3, 400, format, 200, 4, 1, 0));
        report("small", random_triangles(4, 3000, format, 24, 8, 1, 6));
        report("large", random_triangles(5, 200, format, 1600, 16, 16, 6));
        report("wall 20 degrees, 64", walls(6, 12, format, 20, 1, 2, 1.6, 6));
        report("wall 50, 64", walls(7, 12, format, 50, 2, 1.7, 2.5, 6));
        report("wall 50, 256", walls(8, 12, format, 50, 2, 1.7, 2.5, 8));
        report("wall 80, 64, 1:30", walls(9, 12, format, 80, 8, .3, 30, 6));
        report("wall 85, 256, 1:100", walls(10, 12, format, 85, 4, .1, 100, 8));
    }
}

TEST(nearly_level)
{
    number_texels();
    report("level but for a unit, w to 1:4096", level_rows(12, 60, 12, 600, 400, 4));
    report("narrow, w to 1:60000", level_rows(14, 200, 16, 30, 30, 4));
}

/* Colours of random triangles, alone or times a texture: the channel farthest off, in steps. */
static double random_colors(uint64_t seed, int count, const qtri_format *format, double reach,
                            double ratio, const qtri_texture *texture, bool equal)
{
    double worst = 0;
    long pixels = 0;
    canvas c = canvas_new(format, WIDTH, HEIGHT);
    const canvas cleared = canvas_new(format, WIDTH, HEIGHT);
    for (int n = 0; n < random_cases(count); n++) {
        const double limit = pow(ratio, uniform(&seed));
        qtri_screen_vertex t[3];
        for (int i = 0; i < 3; i++) {
            corner at = random_corner(&seed, reach, limit, 1);
            if (equal) {
                at.color[1] = at.color[2] = at.color[0];
            }
            t[i] = vertex_of(&at);
        }
        qtri_material m = plain_material();
        m.texture = texture;
        m.shading = QTRI_SMOOTH;
        m.depth_compare = QTRI_LESS;
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, t);
        const qtri_rect box = pixels_around(&c.surface, t);
        for (screen_pixel p = first_pixel(box); p.y < box.y1; p = next_pixel(p, box)) {
            if (stored_depth(&c.surface, p.x, p.y) == 65535) {
                continue;
            }
            const exact at = exact_at(t, p.x, p.y);
            const uint32_t stored = stored_pixel(&c.surface, p.x, p.y);
            for (int k = 0; k < 3; k++) {
                worst = fmax(worst,
                             fabs(stored_steps(format, stored, k) - steps_of(format, at.color, k)));
            }
            pixels++;
        }
        erase_and_check(&c, box, &cleared);
    }
    canvas_free(&c);
    free(cleared.memory);
    assert_true(pixels > 10000);
    return worst;
}

TEST(colors)
{
    static const struct {
        const char *name;
        const qtri_format *format;
    } formats[] = {{"rgb565", &qtri_rgb565}, {"xrgb8888", &qtri_xrgb8888}, {"gray8", &qtri_gray8}};
    static const uint32_t white32 = 0xFFFFFF;
    static const uint16_t white16 = 0xFFFF;
    for (size_t n = 0; n < LENGTH_OF(formats); n++) {
        const qtri_format *format = formats[n].format;
        const bool narrow = format == &qtri_rgb565;
        const qtri_texture white = {
            .texels = narrow ? (const void *)&white16 : &white32,
            .format = narrow ? &qtri_texel_rgb565 : &qtri_texel_xrgb8888,
        };
        const double smooth = random_colors(20, 300, format, 200, 32, NULL, false);
        const double slivers = random_colors(21, 2000, format, 30, 100, NULL, false);
        const double large = random_colors(22, 100, format, 4000, 16, NULL, false);
        const double textured = random_colors(23, 300, format, 200, 32, &white, false);
        const double textured_small = random_colors(24, 2000, format, 30, 100, &white, false);
        print_message("%-9s smooth %.3f small %.3f large %.3f, times white %.3f small %.3f\n",
                      formats[n].name, smooth, slivers, large, textured, textured_small);
        const double packed = narrow ? .85 : 1; /* short fractions; weights of 8 bits */
        assert_true(smooth <= packed);
        assert_true(slivers <= packed);
        assert_true(large <= packed);
        const double most = 1.5; /* rounded twice */
        assert_true(textured <= most);
        assert_true(textured_small <= most);
    }
}

/* Anything may be drawn, and colours stay between those of the vertices. */
TEST(extremes)
{
    number_texels();
    uint64_t seed = 40;
    const qtri_texture texture = texture_of(&qtri_rgb565, 7, 9);
    const qtri_texture clamped = {.texels = texels32,
                                  .format = &qtri_texel_xrgb8888,
                                  .width_log2 = 4,
                                  .height_log2 = 4,
                                  .wrap_u = QTRI_CLAMP,
                                  .wrap_v = QTRI_CLAMP};
    const qtri_texture *const textures[] = {NULL, &texture, &clamped};
    for (int n = 0; n < random_cases(6000); n++) {
        const qtri_format *format = drawn_format(n % 3);
        const int32_t kind = random_in(&seed, 0, 3);
        const int32_t reach = kind == 0   ? 1 << 22
                              : kind == 1 ? 300
                              : kind == 2 ? 20000
                                          : 1 << (random_in(&seed, 6, 22));
        qtri_screen_vertex t[3];
        const int32_t exponents = random_in(&seed, 0, 40);
        const int32_t least = random_in(&seed, 0, 255);
        const int32_t greatest = random_in(&seed, least, 255);
        for (int i = 0; i < 3; i++) {
            t[i] = screen_at(random_in(&seed, -reach, reach) + WIDTH * 128,
                             random_in(&seed, -reach, reach) + HEIGHT * 128);
            t[i].inv_w_q31 = (uint32_t)random64(&seed);
            t[i].inv_w_exponent = random_in(&seed, -exponents, exponents);
            t[i].u_q32 = (int64_t)(random64(&seed)) >> random_in(&seed, 0, 60);
            t[i].v_q32 = (int64_t)(random64(&seed)) >> random_in(&seed, 0, 60);
            for (int k = 0; k < 3; k++) {
                t[i].color_8p16[k] = random_in(&seed, least, greatest) << 16;
            }
        }
        qtri_material m = plain_material();
        m.texture = textures[random_in(&seed, 0, 2)];
        m.shading = QTRI_SMOOTH;
        canvas c = canvas_new(format, WIDTH, HEIGHT);
        qtri_raster_triangle(&c.surface, qtri_pipelines_default, &m, t);
        for (int32_t i = 0; m.texture == NULL && i < WIDTH * HEIGHT; i++) {
            const uint32_t pixel = stored_pixel(&c.surface, i % WIDTH, i / WIDTH);
            const double ends[2][3] = {{least, least, least}, {greatest, greatest, greatest}};
            for (int k = 0; k < 3 && pixel != 0; k++) {
                const double stored = stored_steps(format, pixel, k);
                const double low = steps_of(format, ends[0], k);
                const double high = steps_of(format, ends[1], k);
                if (stored < low - .75 || stored > high + .75) {
                    fail_msg("triangle %d: %f is not in %f..%f", n, stored, low, high);
                }
            }
        }
        canvas_free(&c);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
