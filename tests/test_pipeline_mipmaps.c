/* SPDX-License-Identifier: MIT */
/*
 * Levels of a texture: which one is drawn, against footprints in double precision; and
 * where in it a pixel lies.
 */
#include "support/by_pipeline.h"
#include "support/texture.h"

enum { LEVELS = 10, TEXELS = 1 << 21 };

/* A texel says which level it is of and where in it. */
static uint32_t texels[TEXELS];
static uint16_t texels_565[TEXELS];
static const void *table[LEVELS], *table_565[LEVELS];

static uint32_t texel_of(uint32_t level, uint32_t index)
{
    return level << 20 | (index & 0xFFFFFu);
}

/* A chain down to 2 x 1. */
static qtri_texture chain(int width_log2, int height_log2, bool is_565)
{
    qtri_texture t = {.format = is_565 ? &qtri_texel_rgb565 : &qtri_texel_xrgb8888,
                      .width_log2 = (uint8_t)width_log2,
                      .height_log2 = (uint8_t)height_log2,
                      .filter = &qtri_mipmapped,
                      .level_count = (uint8_t)(width_log2 > 0 ? width_log2 - 1 : 0)};
    size_t at = 0;
    for (int level = 0; level <= t.level_count; level++) {
        const int w = width_log2 - level, h = height_log2 > level ? height_log2 - level : 0;
        const void *first = is_565 ? (const void *)&texels_565[at] : (const void *)&texels[at];
        if (level == 0) {
            t.texels = first;
        } else {
            table[level - 1] = is_565 ? table[level - 1] : first;
            table_565[level - 1] = is_565 ? first : table_565[level - 1];
        }
        for (uint32_t i = 0; i < 1u << (w + h); i++) {
            texels[at + i] = texel_of((uint32_t)level, i);
            texels_565[at + i] = (uint16_t)((uint32_t)level << 12 | ((i * 40503u >> 4) & 0xFFF));
        }
        at += (size_t)1 << (w + h);
    }
    t.levels = is_565 ? table_565 : table;
    return t;
}

static double length_of(double a, double b)
{
    a = fabs(a);
    b = fabs(b);
    return a > b ? a + 0.375 * b : b + 0.375 * a;
}

/* log2 of the footprint, in texels: as texture.h has it. x, y: pixels, also between their centres
   at whole numbers. */
static double log2_footprint(const qtri_screen_vertex v[3], double x, double y, bool perspective,
                             int width, int height)
{
    double sum[2] = {0, 0}, sum_x[2] = {0, 0}, sum_y[2] = {0, 0}, q = 0, q_x = 0, q_y = 0;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *p = &v[(i + 1) % 3], *r = &v[(i + 2) % 3];
        const double w = perspective ? v[i].inv_w_q31 : 1;
        const double b_y = w * (r->x_24p8 - p->x_24p8) * 256;
        const double b_x = -w * (r->y_24p8 - p->y_24p8) * 256;
        const double b = w * (r->x_24p8 - p->x_24p8) * (y * 256 + 128 - p->y_24p8) -
                         w * (r->y_24p8 - p->y_24p8) * (x * 256 + 128 - p->x_24p8);
        const double f[2] = {ldexp((double)v[i].u_q32, -32) * width,
                             ldexp((double)v[i].v_q32, -32) * height};
        for (int k = 0; k < 2; k++) {
            sum[k] += b * f[k];
            sum_x[k] += b_x * f[k];
            sum_y[k] += b_y * f[k];
        }
        q += b;
        q_x += b_x;
        q_y += b_y;
    }
    double right[2], down[2];
    for (int k = 0; k < 2; k++) {
        right[k] = (sum_x[k] * q - sum[k] * q_x) / (q * q);
        down[k] = (sum_y[k] * q - sum[k] * q_y) / (q * q);
    }
    return log2(fmax(length_of(right[0], right[1]), length_of(down[0], down[1])));
}

/* How far the footprint is from what the level is for, in levels; 0: it is right. */
static double off_level(double log2, int level, int last)
{
    const double low = level == 0 ? -HUGE_VAL : level - 0.5;
    const double high = level == last ? HUGE_VAL : level + 0.5;
    return log2 < low ? low - log2 : (log2 > high ? log2 - high : 0);
}

static bool is_small(const qtri_screen_vertex v[3])
{
    for (int i = 1; i < 3; i++) {
        const double ratio = (double)v[i].inv_w_q31 / v[0].inv_w_q31;
        if (abs(v[i].x_24p8 - v[0].x_24p8) >= 120 * 256 ||
            abs(v[i].y_24p8 - v[0].y_24p8) >= 120 * 256 ||
            abs(v[i].y_24p8 - v[3 - i].y_24p8) >= 120 * 256 || fabs(ratio - 1) > 1 / 12.8) {
            return false;
        }
    }
    return true;
}

static bool is_inside(const qtri_screen_vertex v[3], int32_t x, int32_t y)
{
    int sides = 0;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *p = &v[i], *q = &v[(i + 1) % 3];
        const int64_t side = (int64_t)(q->x_24p8 - p->x_24p8) * (y * 256 + 128 - p->y_24p8) -
                             (int64_t)(q->y_24p8 - p->y_24p8) * (x * 256 + 128 - p->x_24p8);
        sides += (side > 0) - (side < 0);
    }
    return abs(sides) == 3;
}

/*
 * A triangle of which not a row is a pixel high, or that steps from edge to edge in one: what its
 * values change by in a row does not fit the numbers that levels are made of.
 */
static bool is_sliver(const qtri_screen_vertex v[3])
{
    const int64_t dx1 = v[1].x_24p8 - v[0].x_24p8, dy1 = v[1].y_24p8 - v[0].y_24p8;
    const int64_t dx2 = v[2].x_24p8 - v[0].x_24p8, dy2 = v[2].y_24p8 - v[0].y_24p8;
    const int64_t area = llabs(dx1 * dy2 - dx2 * dy1);
    return area < 256 * (llabs(dx1) + llabs(dx2) + llabs(dy1) + llabs(dy2));
}

/* The least of a row's pixels near x that a block with x may have in its middle. */
static double off_block(const qtri_screen_vertex v[3], int32_t x, int32_t y, bool perspective,
                        int level, const qtri_texture *t)
{
    const int width = 1 << t->width_log2, height = 1 << t->height_log2;
    double least =
        off_level(log2_footprint(v, x, y, perspective, width, height), level, t->level_count);
    if (least == 0) {
        return 0;
    }
    if (is_small(v)) {
        const double log2 = log2_footprint(v, v[0].x_24p8 / 256.0 - 0.5, v[0].y_24p8 / 256.0 - 0.5,
                                           perspective, width, height);
        least = fmin(least, off_level(log2, level, t->level_count));
    }
    for (int32_t at = x - 64; at <= x + 64; at++) {
        if (at == x || is_inside(v, at, y)) {
            const double log2 = log2_footprint(v, at, y, perspective, width, height);
            least = fmin(least, off_level(log2, level, t->level_count));
        }
    }
    return least;
}

/* How far a coordinate, in texels, is outside of texel `index`. */
static double outside(double coordinate, int index, int side, bool clamped)
{
    if (clamped) {
        const double low = index == 0 ? -HUGE_VAL : index;
        const double high = index == side - 1 ? HUGE_VAL : index + 1;
        return fmax(fmax(low - coordinate, coordinate - high), 0);
    }
    const double from = coordinate - index - 0.5;
    return fmax(fabs(from - side * floor(from / side + 0.5)) - 0.5, 0);
}

typedef struct worst {
    double level, own, place;  /* off: of its block's, of its own pixel's, texels of the unit */
    double small, small_place; /* of its own pixel's, on small triangles; and their place */
    int pixels, levels[LEVELS + 1];
} worst;

static void look_at(worst *w, const canvas *c, const qtri_screen_vertex v[3], const qtri_texture *t,
                    bool perspective)
{
    for (int32_t i = 0; i < c->surface.width * c->surface.height; i++) {
        const int32_t x = i % c->surface.width, y = i / c->surface.width;
        if (stored_depth(&c->surface, x, y) == 65535) {
            continue;
        }
        const uint32_t texel = stored_pixel(&c->surface, x, y);
        const int level = (int)(texel >> 20);
        assert_in_range(level, 0, t->level_count);
        const int w_log2 = t->width_log2 - level;
        const int h_log2 = t->height_log2 > level ? t->height_log2 - level : 0;
        const int index = (int)(texel & 0xFFFFF);
        if (!is_sliver(v)) {
            w->level = fmax(w->level, off_block(v, x, y, perspective, level, t));
            const double own = off_level(
                log2_footprint(v, x, y, perspective, 1 << t->width_log2, 1 << t->height_log2),
                level, t->level_count);
            *(is_small(v) ? &w->small : &w->own) = fmax(is_small(v) ? w->small : w->own, own);
        }
        for (int k = 0; k < 2; k++) {
            const int side = 1 << (k == 0 ? w_log2 : h_log2);
            const double at = perspective_sum(v, x, y, perspective, k == 1) * side;
            const double unit = coordinate_unit(v, x, y, perspective, k == 1, side);
            const bool clamped = (k == 0 ? t->wrap_u : t->wrap_v) == QTRI_CLAMP;
            const double off =
                outside(at, k == 0 ? index & ((1 << w_log2) - 1) : index >> w_log2, side, clamped);
            double *place = is_small(v) ? &w->small_place : &w->place;
            *place = fmax(*place, off / unit);
        }
        w->pixels++;
        w->levels[level]++;
    }
}

/* A triangle of the reach given, whose texture is seen from near or far. */
static void any_triangle(qtri_screen_vertex v[3], uint64_t *seed, int n, int32_t reach)
{
    static const int32_t repeats[4] = {Q16(0.25), Q16(1), Q16(4), Q16(12)};
    random_triangle(v, seed, reach, repeats[n / 2 % 4]);
    if (n % 3 == 0) { /* w alike */
        for (int i = 0; i < 3; i++) {
            v[i].inv_w_q31 = 0x80000000u - (uint32_t)random_in(seed, 0, 0x08000000);
        }
    }
}

static worst draw_many(uint64_t seed, int count, int32_t reach, int side_log2_max)
{
    worst w = {0};
    canvas c = canvas_new(&qtri_xrgb8888, 4 * WIDTH, HEIGHT);
    for (int n = 0; n < count; n++) {
        const int height_log2 = random_in(&seed, 0, side_log2_max);
        const int width_log2 = random_in(&seed, 2, side_log2_max);
        qtri_texture t = chain(width_log2, height_log2, false);
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        t.wrap_u = random_flag(&seed) ? QTRI_CLAMP : QTRI_REPEAT;
        t.wrap_v = random_flag(&seed) ? QTRI_CLAMP : QTRI_REPEAT;
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        m.interpolation = (qtri_interpolation)(n % 5 == 0);
        m.depth_compare = QTRI_LESS;
        any_triangle(v, &seed, n, reach);
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        look_at(&w, &c, v, &t, n % 5 != 0);
    }
    canvas_free(&c);
    return w;
}

static void print_worst(const char *name, const worst *w)
{
    print_message("%s: %d pixels, level off by %.3f of its block's, %.3f of the pixel's, small "
                  "%.3f; place, of "
                  "the bound: %.3f, small %.3f; of each level",
                  name, w->pixels, w->level, w->own, w->small, w->place, w->small_place);
    for (int i = 0; i <= LEVELS; i++) {
        print_message(" %d", w->levels[i]);
    }
    print_message("\n");
}

TEST(chooses_by_footprint)
{
    const worst small = draw_many(901, 400, 4000, 7);
    const worst large = draw_many(902, 300, 40000, 7);
    const worst sides = draw_many(903, 40, 20000, 10);
    print_worst("small", &small);
    print_worst("large", &large);
    print_worst("any sides", &sides);
    assert_true(small.level < 0.03 && large.level < 0.03 && sides.level < 0.03);
    assert_true(small.small < 0.4 && large.own < 0.4 && sides.own < 0.4);
    /* Polynomials of large triangles stray by 2^-6 of a step, small triangles by 2^-4 texel. */
    assert_true(small.place < 4.1 && large.place < 4.1 && sides.place < 4.1);
    assert_true(small.small_place < 16.1 && sides.small_place < 16.1);
}

/* ---- Where a level begins ---- */

/* Without perspective a level is left behind at the root of two of its texels a pixel, to 2^-13 of
   it: along either axis, of either coordinate. */
TEST(levels_begin_at_the_root_of_two)
{
    enum { LEG = 256, ACROSS = 40, DOWN = 30 };
    const qtri_texture t = chain(7, 7, false);
    canvas c = canvas_new(&qtri_xrgb8888, ACROSS, DOWN);
    for (int n = 0; n < 16; n++) {
        const int level = n / 8;
        const bool is_beyond = n & 1, is_v = n & 2, is_down = n & 4;
        const double step = ldexp(sqrt(2), level) * (is_beyond ? 1 + exp2(-13) : 1 - exp2(-14));
        const int64_t far = (int64_t)ldexp(step * LEG, 32 - 7);
        qtri_screen_vertex v[3] = {screen_at(0, 0), screen_at(LEG << 8, 0), screen_at(0, LEG << 8)};
        qtri_material m = plain_material();
        *(is_v ? &v[is_down ? 2 : 1].v_q32 : &v[is_down ? 2 : 1].u_q32) = far;
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        for (int32_t i = 0; i < ACROSS * DOWN; i++) {
            assert_int_equal(stored_pixel(&c.surface, i % ACROSS, i / ACROSS) >> 20,
                             level + is_beyond);
        }
    }
    canvas_free(&c);
}

/* ---- A step that turns round ---- */

/* A vertex with u and v, in textures, of 1/w and of what they are times that. */
static qtri_screen_vertex divided(double x, double y, double q, double u, double v)
{
    qtri_screen_vertex p = {0};
    p.x_24p8 = (int32_t)(x * 256);
    p.y_24p8 = (int32_t)(y * 256);
    p.inv_w_q31 = (uint32_t)(q * 0x7FFFFFFF);
    p.u_q32 = (int64_t)ldexp(u / q, 32);
    p.v_q32 = (int64_t)ldexp(v / q, 32);
    return p;
}

/*
 * The step down of u, times q^2, is `down` all over. That of v is `share` of it at one
 * end of a row, and a little below 0 at the other, where it is slight: of both ends, not of one,
 * the shorter step has to be so to be left out.
 */
TEST(turns_at_one_end)
{
    enum { ACROSS = 4 * WIDTH, DOWN = HEIGHT };
    worst w = {0};
    canvas c = canvas_new(&qtri_xrgb8888, ACROSS, DOWN);
    canvas tiles = canvas_new(&qtri_xrgb8888, ACROSS, DOWN);
    uint64_t seed = 904;
    const double fall = 0.5 / DOWN; /* of q, a row */
    for (int n = 0; n < 24; n++) {
        const qtri_texture t = chain(7, 7, false);
        const double down = exp2(n / 12.0) / 128;
        const double share = random_in(&seed, 80, 95) / 100.0;
        const double across = share * down / (fall * ACROSS) * (1 + 1.0 / 300);
        const bool falls = n % 2 == 0;
        const double v_x = falls ? -across : across;
        const double v_y = falls ? share * down : -share * down / 300;
        const double x = falls ? 0 : ACROSS;
        qtri_material m = plain_material();
        const qtri_screen_vertex v[3] = {
            divided(0, 0, 1, 0, 0),
            divided(ACROSS, 0, 1, 0, v_x * ACROSS),
            divided(x, DOWN, 0.5, down * DOWN, v_x * x + v_y * DOWN),
        };
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        m.depth_compare = QTRI_LESS;
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        canvas_clear(&tiles);
        for (int32_t at = 0; at < ACROSS; at += 29) { /* pieces before a tile are passed over */
            qtri_surface part = tiles.surface;
            part.scissor.x0 = at;
            part.scissor.x1 = at + 29;
            draw_by_pipeline(&part, &m, v);
        }
        assert_memory_equal(c.memory, tiles.memory, c.bytes);
        look_at(&w, &c, v, &t, true);
    }
    canvas_free(&c);
    canvas_free(&tiles);
    print_worst("turning", &w);
    assert_true(w.pixels > 60000 && w.level < 0.03 && w.own < 0.4);
}

/*
 * Where 1/w hardly changes along rows, short ones are drawn as if it did not, and long ones in
 * pieces: in tiles, from any column of a row on, these are what they are in the whole. Textures
 * with levels and without.
 */
TEST(rows_of_hardly_any_perspective)
{
    enum { ACROSS = 4 * WIDTH, DOWN = HEIGHT, TILE = 37 };
    worst w = {0};
    canvas c[2] = {canvas_new(&qtri_xrgb8888, ACROSS, DOWN),
                   canvas_new(&qtri_xrgb8888, ACROSS, DOWN)};
    for (int n = 0; n < 80; n++) {
        qtri_texture t = chain(6, 6, false);
        qtri_material m = plain_material();
        const double fall = exp2(-4 - n / 2 / 2.0), repeats = 4 + n % 7; /* of q, along the row */
        const qtri_screen_vertex v[3] = {divided(0, 0, 1, 0, 0),
                                         divided(ACROSS, 0, 1 - fall, repeats, 0),
                                         divided(ACROSS / 2, DOWN, .9, repeats / 3, .9)};
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        m.depth_compare = QTRI_LESS;
        t.level_count = n % 2 == 0 ? t.level_count : 0;
        for (int i = 0; i < 2; i++) {
            canvas_clear(&c[i]);
            for (int32_t x = 0; x < (i == 0 ? 1 : ACROSS); x += TILE) {
                qtri_surface part = c[i].surface;
                part.scissor.x0 = x;
                part.scissor.x1 = i == 0 ? ACROSS : x + TILE;
                draw_by_pipeline(&part, &m, v);
            }
        }
        assert_memory_equal(c[0].memory, c[1].memory, c[0].bytes);
        look_at(&w, &c[0], v, &t, true);
    }
    canvas_free(&c[0]);
    canvas_free(&c[1]);
    print_worst("hardly any perspective", &w);
    assert_true(w.pixels > 100000 && w.level < 0.03 && w.own < 0.4 && w.place < 4.1);
}

/*
 * A few pixels, across which a texture repeats up to 40 times and 1/w changes up to eightfold: what
 * a coordinate's step changes by from pixel to pixel is half a repeat or more. All are of the last
 * level; every eighth is of a texture of more than 2^16 texels.
 */
TEST(steps_that_change_by_half_a_repeat)
{
    worst w = {0};
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    uint64_t seed = 905;
    for (int n = 0; n < 160; n++) {
        const int side_log2 = n % 8 == 0 ? 9 : 5;
        const qtri_texture t = chain(side_log2, side_log2, false);
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        random_triangle(v, &seed, 1500, Q16(20));
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        m.depth_compare = QTRI_LESS;
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        look_at(&w, &c, v, &t, true);
    }
    canvas_free(&c);
    print_worst("half a repeat", &w);
    assert_true(w.pixels > 1500 && w.level < 0.03 && w.place < 1 && w.small_place < 16.1);
}

/*
 * Down a floor 1/w falls to 1/256, and along its rows by 2^-31 of itself a pixel or not at all:
 * rows are drawn as if it did not where it is large, and in pieces where that counts. Texels a
 * pixel go down grow to the right, so that runs of one row are of other levels. In tiles, too.
 */
TEST(floors_that_hardly_lean)
{
    enum { ACROSS = 4 * WIDTH, DOWN = HEIGHT, TILE = 37 };
    worst w = {0};
    canvas c[2] = {canvas_new(&qtri_xrgb8888, ACROSS, DOWN),
                   canvas_new(&qtri_xrgb8888, ACROSS, DOWN)};
    for (int n = 0; n < 40; n++) {
        qtri_texture t = chain(6, 6, false);
        qtri_material m = plain_material();
        const double lean = n % 4 == 0 ? 0 : ldexp(n * 3.5, -31); /* less than a pixel's 2^-31 */
        const double repeats = 20 * exp2(n % 5);
        const qtri_screen_vertex v[3] = {divided(0, 0, 1, 0, 0), divided(0, DOWN, 1 / 256., 0, 0),
                                         divided(ACROSS, DOWN, 1 / 256. + lean, repeats / 256, 0)};
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        m.depth_compare = QTRI_LESS;
        t.level_count = n % 3 != 0 ? t.level_count : 0;
        for (int i = 0; i < 2; i++) {
            canvas_clear(&c[i]);
            for (int32_t x = 0; x < (i == 0 ? 1 : ACROSS); x += TILE) {
                qtri_surface part = c[i].surface;
                part.scissor.x0 = x;
                part.scissor.x1 = i == 0 ? ACROSS : x + TILE;
                draw_by_pipeline(&part, &m, v);
            }
        }
        assert_memory_equal(c[0].memory, c[1].memory, c[0].bytes);
        look_at(&w, &c[0], v, &t, true);
    }
    canvas_free(&c[0]);
    canvas_free(&c[1]);
    print_worst("floors", &w);
    assert_true(w.pixels > 80000 && w.level < 0.03 && w.place < 4.1);
}

/* Colours along a row that has one level are stepped no further than they are exact: a white
   texture of levels leaves them as they are. */
TEST(colors_of_long_rows_are_exact)
{
    enum { ACROSS = 4 * WIDTH, DOWN = HEIGHT };
    static uint32_t white[1 << 12];
    static const void *const levels[5] = {white, white, white, white, white};
    canvas c = canvas_new(&qtri_xrgb8888, ACROSS, DOWN);
    uint64_t seed = 905;
    double most = 0;
    for (size_t i = 0; i < LENGTH_OF(white); i++) {
        white[i] = 0xFFFFFF;
    }
    for (int n = 0; n < 40; n++) {
        const qtri_texture t = {.texels = white,
                                .format = &qtri_texel_xrgb8888,
                                .filter = &qtri_mipmapped,
                                .width_log2 = 6,
                                .height_log2 = 6,
                                .levels = levels,
                                .level_count = 5};
        qtri_material m = plain_material();
        qtri_screen_vertex v[3] = {divided(0, 0, 1, 0, 0), divided(ACROSS, 0, 1, 1 + n % 7, 0),
                                   divided(0, DOWN, 0.5, 0, 3)};
        for (int i = 0; i < 9; i++) {
            v[i / 3].color_8p16[i % 3] = random_in(&seed, 0, 255) << 16;
        }
        m.texture = &t;
        m.texture_mode = QTRI_MODULATE;
        m.shading = QTRI_SMOOTH;
        m.depth_compare = QTRI_LESS;
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        for (int32_t i = 0; i < ACROSS * DOWN; i++) {
            const int32_t x = i % ACROSS, y = i / ACROSS;
            if (stored_depth(&c.surface, x, y) == 65535) {
                continue;
            }
            const double down = (y + .5) / DOWN, right = (x + .5) / ACROSS;
            const double share[3] = {(1 - down - right) / (1 - down / 2), right / (1 - down / 2),
                                     down / 2 / (1 - down / 2)};
            for (int k = 0; k < 3; k++) {
                double is = 0;
                for (int j = 0; j < 3; j++) {
                    is += share[j] * (v[j].color_8p16[k] >> 16);
                }
                most =
                    fmax(most, fabs((stored_pixel(&c.surface, x, y) >> (16 - 8 * k) & 255) - is));
            }
        }
    }
    print_message("colours off by %.3f\n", most);
    assert_true(most < 1.25);
    canvas_free(&c);
}

/* ---- Bilinear ---- */

static double texel_gray(const qtri_texture *t, int level, int column, int row)
{
    const int w_log2 = t->width_log2 - level;
    const int h_log2 = t->height_log2 > level ? t->height_log2 - level : 0;
    const uint8_t *texels8 = level == 0 ? t->texels : t->levels[level - 1];
    column &= (1 << w_log2) - 1;
    row &= (1 << h_log2) - 1;
    return texels8[(row << w_log2) + column];
}

static double bilinear(const qtri_texture *t, int level, double u, double v)
{
    const double column = u * ldexp(1, t->width_log2 - level) - 0.5;
    const double row = v * ldexp(1, t->height_log2 > level ? t->height_log2 - level : 0) - 0.5;
    const int left = (int)floor(column), above = (int)floor(row);
    const double along = column - left, across = row - above;
    return (texel_gray(t, level, left, above) * (1 - along) +
            texel_gray(t, level, left + 1, above) * along) *
               (1 - across) +
           (texel_gray(t, level, left, above + 1) * (1 - along) +
            texel_gray(t, level, left + 1, above + 1) * along) *
               across;
}

/* Smooth noise, the same in all levels but for a shift: so that a level's place counts. */
TEST(filters_in_levels)
{
    static uint8_t gray[2 * 64 * 64];
    static const void *gray_table[LEVELS];
    uint64_t seed = 910;
    double greatest = 0, small = 0;
    int pixels = 0;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (size_t i = 0; i < LENGTH_OF(gray); i++) {
        gray[i] = (uint8_t)random_in(&seed, 0, 255);
    }
    for (int n = 0; n < 200; n++) {
        const int width_log2 = random_in(&seed, 3, 6);
        const int height_log2 = random_in(&seed, 1, 6);
        qtri_texture t = {.texels = gray,
                          .format = &qtri_texel_gray8,
                          .width_log2 = (uint8_t)width_log2,
                          .height_log2 = (uint8_t)height_log2,
                          .filter = &qtri_mipmapped_bilinear,
                          .levels = gray_table};
        size_t at = (size_t)1 << (t.width_log2 + t.height_log2);
        for (int i = 1; i < t.width_log2; i++) {
            gray_table[i - 1] = gray + at;
            at += (size_t)1 << (t.width_log2 - i + (t.height_log2 > i ? t.height_log2 - i : 0));
            t.level_count++;
        }
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        m.texture = &t;
        m.texture_mode = QTRI_REPLACE;
        m.depth_compare = QTRI_LESS;
        any_triangle(v, &seed, n, n % 2 == 0 ? 3000 : 20000);
        canvas_clear(&c);
        draw_by_pipeline(&c.surface, &m, v);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            if (stored_depth(&c.surface, x, y) == 65535 || is_sliver(v)) {
                continue;
            }
            const double u = perspective_sum(v, x, y, true, false);
            const double w = perspective_sum(v, x, y, true, true);
            const double is = stored_pixel(&c.surface, x, y) & 255;
            double least = HUGE_VAL;
            for (int level = 0; level <= t.level_count; level++) {
                if (off_block(v, x, y, true, level, &t) < 0.03) {
                    const double unit = /* 1/256 of a texel, or of a pixel's step */
                        coordinate_unit(v, x, y, true, false, 1 << (t.width_log2 - level)) +
                        coordinate_unit(v, x, y, true, true,
                                        t.height_log2 > level ? 1 << (t.height_log2 - level) : 1);
                    least = fmin(least, fmax(fabs(is - bilinear(&t, level, u, w)) - 0.52, 0) /
                                            (255 * unit));
                }
            }
            double *most = is_small(v) ? &small : &greatest;
            *most = fmax(*most, least);
            pixels++;
        }
    }
    print_message("%d pixels, off, of the bound: %.3f, small %.3f\n", pixels, greatest, small);
    assert_true(pixels > 5000);
    assert_true(greatest < 4.1 && small < 16.1);
    canvas_free(&c);
}

/* ---- Many triangles in one draw call ---- */

/* Fragments of small triangles wait for each other, whatever levels they are of. */
TEST(draws_batches)
{
    enum { TRIANGLES = 40 };
    uint64_t seed = 920;
    canvas together = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas apart = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < 120; n++) {
        qtri_texture t = chain(6, random_in(&seed, 3, 6), true);
        qtri_material m = qtri_material_default();
        qtri_corner corners[3 * TRIANGLES];
        qtri_view view;
        qtri_transform pose;
        start_view(&view, &pose, WIDTH, HEIGHT);
        m.cull = QTRI_CULL_NONE;
        m.texture = &t;
        m.texture_mode = n % 2 == 0 ? QTRI_REPLACE : QTRI_MODULATE;
        t.has_key = n % 3 == 0;
        t.key = texels_565[1];
        t.filter = n % 4 == 0 ? &qtri_mipmapped_bilinear : &qtri_mipmapped;
        for (int i = 0; i < TRIANGLES; i++) {
            const int32_t x = random_in(&seed, -Q16_ONE, Q16_ONE);
            const int32_t y = random_in(&seed, -Q16_ONE, Q16_ONE);
            const int32_t z = random_in(&seed, -Q16_ONE, Q16_ONE);
            const int32_t repeats = Q16_ONE >> random_in(&seed, 0, 6);
            for (int k = 0; k < 3; k++) {
                const int32_t corner_x = x + random_in(&seed, -16000, 16000);
                const int32_t corner_y = y + random_in(&seed, -16000, 16000);
                const uint8_t green = (uint8_t)random_in(&seed, 0, 255);
                const int32_t u = random_in(&seed, 0, repeats);
                const int32_t w = random_in(&seed, 0, repeats);
                const qtri_corner corner = {
                    {corner_x, corner_y, z, Q16_ONE}, {255, green, 128}, {u, w}};
                corners[3 * i + k] = corner;
            }
        }
        canvas_clear(&together);
        canvas_clear(&apart);
        qtri_draw_triangles(&together.surface, &view, &pose, corners, 3 * TRIANGLES, &m);
        for (int i = 0; i < TRIANGLES; i++) {
            qtri_draw_triangles(&apart.surface, &view, &pose, &corners[3 * i], 3, &m);
        }
        assert_memory_equal(together.memory, apart.memory, together.bytes);
    }
    canvas_free(&together);
    canvas_free(&apart);
}

/* ---- What there need not be ---- */

/* Without levels, and with a null pointer among them, it is the filter without levels, but at edges
   of texels: that one's spans are longer. */
TEST(does_without)
{
    uint64_t seed = 930;
    int others = 0, drawn = 0;
    canvas with = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    canvas without = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    for (int n = 0; n < 200; n++) {
        static const void *const hole[4] = {NULL, texels_565, texels_565, texels_565};
        static const void *const all[4] = {texels_565, texels_565, texels_565, texels_565};
        const int height_log2 = random_in(&seed, 0, 6), width_log2 = random_in(&seed, 0, 6);
        qtri_texture t = chain(width_log2, height_log2, true);
        qtri_texture plain = t;
        qtri_material m = plain_material();
        qtri_screen_vertex v[3];
        plain.filter = n % 2 == 0 ? NULL : &qtri_bilinear;
        t.filter = n % 2 == 0 ? &qtri_mipmapped : &qtri_mipmapped_bilinear;
        t.levels = n % 3 == 0 ? NULL : (n % 3 == 1 ? hole : all);
        t.level_count = n % 3 == 2 ? 0 : 255;
        m.depth_compare = QTRI_LESS;
        m.texture_mode = QTRI_REPLACE;
        any_triangle(v, &seed, n, 6000);
        canvas_clear(&with);
        canvas_clear(&without);
        m.texture = &t;
        draw_by_pipeline(&with.surface, &m, v);
        m.texture = &plain;
        draw_by_pipeline(&without.surface, &m, v);
        others += count_different(&with.surface, &without.surface);
        drawn += count_painted(&with.surface);
    }
    print_message("%d of %d pixels differ\n", others, drawn);
    assert_true(drawn > 20000 && others < drawn / 500); /* borders of texels */
    canvas_free(&with);
    canvas_free(&without);
}

/*
 * Alpha of vertices and light by pixel draw large triangles with a copy of what the others are
 * drawn with: opaque, and in full light, they have the same texels, whatever was drawn before in
 * the call.
 */
TEST(drawn_with_copies)
{
    enum { COLUMNS = 96, ROWS = 72, CORNERS = 12 };
    const double turn = 2 * acos(-1);
    const qtri_texture texture = chain(6, 5, false);
    const qtri_light_color full = {Q16_ONE, Q16_ONE, Q16_ONE};
    const qtri_light_source off = {.kind = NULL};
    uint64_t seed = 71;
    int levels[LEVELS] = {0}, others[2] = {0, 0};
    for (int n = 0; n < 80; n++) {
        qtri_corner corners[CORNERS];
        qtri_normal normals[CORNERS];
        qtri_light lights;
        qtri_view view;
        qtri_transform pose;
        qtri_material m = qtri_material_default();
        assert_ok(qtri_light_init(&lights, &off, 0, full));
        start_view(&view, &pose, COLUMNS, ROWS);
        for (int i = 0; i < CORNERS; i++) { /* around the middle, so that all are large */
            const double angle = turn * (i + random_in(&seed, 0, 500) / 1000.0) / 3;
            const double w = random_in(&seed, 0, n % 4 == 0 ? 0 : 2) == 0
                                 ? 1
                                 : random_in(&seed, 1000, 9000) / 1000.0;
            const qtri_rgb white = {255, 255, 255};
            const int32_t u = random_in(&seed, -400000, 400000);
            const int32_t v = random_in(&seed, -400000, 400000);
            const qtri_corner corner = {
                {fixed(1.3 * cos(angle) * w), fixed(1.3 * sin(angle) * w), 0, fixed(w)},
                white,
                {u, v}};
            const qtri_normal normal = {(int16_t)random_in(&seed, -9000, 9000), 9000, 9000};
            corners[i] = corner;
            normals[i] = normal;
        }
        m.cull = QTRI_CULL_NONE;
        m.texture = &texture;
        m.depth_compare = QTRI_DEPTH_OFF;
        canvas plain = canvas_new(&qtri_xrgb8888, COLUMNS, ROWS);
        canvas other = canvas_new(&qtri_xrgb8888, COLUMNS, ROWS);
        qtri_draw_triangles(&plain.surface, &view, &pose, corners, CORNERS, &m);
        m.blend = n % 2 == 0 ? NULL : &qtri_blend_vertex_alpha;
        m.shading = n % 3 == 0 || n % 2 == 0 ? QTRI_PER_PIXEL : QTRI_SMOOTH;
        view.light = m.shading == QTRI_PER_PIXEL ? &lights : NULL;
        qtri_draw_lit_triangles(&other.surface, &view, &pose, corners, normals, CORNERS, &m);
        for (int32_t i = 0; i < COLUMNS * ROWS; i++) {
            const uint32_t a = stored_pixel(&plain.surface, i % COLUMNS, i / COLUMNS);
            const uint32_t b = stored_pixel(&other.surface, i % COLUMNS, i / COLUMNS);
            bool differs = false;
            for (int k = 0; k < 24; k += 8) {
                differs |= abs((int)(a >> k & 255) - (int)(b >> k & 255)) > 1;
            }
            others[n % 2] += differs;
            levels[a >> 20 & 15]++;
        }
        canvas_free(&plain);
        canvas_free(&other);
    }
    print_message("%d, %d pixels differ\n", others[0], others[1]);
    assert_true(others[0] + others[1] <
                80 * COLUMNS * ROWS / 50); /* borders of texels and levels */
    for (int level = 0; level < 5; level++) {
        assert_true(levels[level] > 1000);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
