/* SPDX-License-Identifier: MIT */
/*
 * Strokes: coverage against exact areas, joints, formats, depth, extremes.
 */
#include "support/core.h"

#include "reference/stroke_cover.h"

enum { WIDTH = 83, HEIGHT = 53, POINTS = 24 };

typedef struct scene {
    qtri_screen_vertex v[POINTS];
    uint32_t count;
    qtri_stroke stroke;
} scene;

static scene random_scene(uint64_t *seed, int32_t most)
{
    scene s;
    const int32_t reach = random_flag(seed) ? 600 : 12000;
    s.count = (uint32_t)random_in(seed, 1, most);
    s.stroke = qtri_stroke_default();
    s.stroke.width = random_in(seed, 0, 3) == 0 ? random_in(seed, 65536, 20 * 65536)
                                                : random_in(seed, 20000, 3 * 65536);
    s.stroke.cap = (qtri_cap)random_in(seed, 0, 2);
    s.stroke.closed = random_in(seed, 0, 3) == 0;
    int32_t x = random_in(seed, -2000, WIDTH * 256 + 2000);
    int32_t y = random_in(seed, -2000, HEIGHT * 256 + 2000);
    for (uint32_t i = 0; i < s.count; i++) {
        s.v[i] = screen_at(x, y);
        if (random_in(seed, 0, 3) != 0) {
            x += random_in(seed, -reach, reach);
        }
        if (random_in(seed, 0, 3) != 0) {
            y += random_in(seed, -reach, reach);
        }
    }
    return s;
}

static size_t parts_of(const scene *s, struct ref_stroke_part part[POINTS])
{
    const bool closed = s->stroke.closed && s->count > 2;
    const size_t count = closed || s->count == 1 ? s->count : s->count - 1;
    for (size_t i = 0; i < count; i++) {
        const qtri_screen_vertex *a = &s->v[i];
        const qtri_screen_vertex *b = &s->v[(i + 1) % s->count];
        const enum ref_cap cap = (enum ref_cap)s->stroke.cap;
        struct ref_stroke_part one = {
            a->x_24p8 / 256.0,
            a->y_24p8 / 256.0,
            b->x_24p8 / 256.0,
            b->y_24p8 / 256.0,
            s->stroke.width / 131072.0,
            {closed || i > 0 ? REF_CAP_ROUND : cap, closed || i + 1 < count ? REF_CAP_ROUND : cap}};
        part[i] = one;
    }
    return count;
}

static void draw(const qtri_surface *surface, const scene *s)
{
    qtri_material material = plain_material();
    qtri_raster_polyline(surface, &material, &s->stroke, s->v, s->count);
}

/* White on black in gray: a pixel is its coverage. */
static double worst_error(canvas *c, const scene *s)
{
    struct ref_stroke_part part[POINTS];
    const size_t count = parts_of(s, part);
    double worst = 0.0;
    canvas_clear(c);
    draw(&c->surface, s);
    for (int y = 0; y < HEIGHT; y++) {
        double share[WIDTH];
        ref_stroke_cover_row(part, count, y, WIDTH, share);
        for (int x = 0; x < WIDTH; x++) {
            worst = fmax(worst, fabs(stored_pixel(&c->surface, x, y) / 255.0 - share[x]));
        }
    }
    return worst;
}

static void coverage_of(uint64_t seed, int32_t most, int runs, double limit)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    double worst = 0.0;
    for (int n = 0; n < runs; n++) {
        const uint64_t from = seed;
        const scene s = random_scene(&seed, most);
        const double error = worst_error(&c, &s);
        if (error > limit) {
            fail_msg("scene %llx, %u points: off by %.4f", (unsigned long long)from,
                     (unsigned)s.count, error);
        }
        worst = fmax(worst, error);
    }
    print_message("coverage of up to %d points: off by %.4f at most\n", (int)most, worst);
    canvas_free(&c);
}

TEST(coverage)
{
    coverage_of(1, 1, 300, 1.0 / 32);
    coverage_of(2, 2, 1000, 1.0 / 32);
    coverage_of(3, 3, 700, 1.0 / 32);
    coverage_of(4, POINTS, 300, 1.0 / 32);
}

/* Points that take the short way, and the first that are too large for it. */
TEST(points_of_all_sizes)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 31;
    double worst = 0.0;
    for (int n = 0; n < random_cases(1500); n++) {
        scene s = {.count = 1, .stroke = qtri_stroke_default()};
        s.v[0] = screen_at(random_in(&seed, 0, WIDTH * 256), random_in(&seed, 0, HEIGHT * 256));
        s.stroke.width = random_in(&seed, 1, n % 2 == 0 ? 33 * 128 : 8 * 128) * 512;
        s.stroke.cap = n % 3 == 0 ? QTRI_CAP_SQUARE : QTRI_CAP_ROUND;
        const double error = worst_error(&c, &s);
        const bool is_short = s.stroke.width <= Q16(32);
        if (error > (is_short ? 1.0 / 64 : 1.0 / 32)) {
            fail_msg("width %d at %d, %d: off by %.4f", (int)s.stroke.width, (int)s.v[0].x_24p8,
                     (int)s.v[0].y_24p8, error);
        }
        worst = is_short ? fmax(worst, error) : worst;
    }
    print_message("coverage of points: off by %.4f at most\n", worst);
    canvas_free(&c);
}

/*
 * Ends shorter than half a width: the disc of the joint reaches out of a flat end, beside which the
 * corners of the end stick out of the disc.
 */
static scene short_ended_scene(uint64_t *seed)
{
    scene s = random_scene(seed, 2);
    s.count = (uint32_t)random_in(seed, 3, 5);
    s.stroke.width = random_in(seed, 65536, 24 * 65536);
    s.stroke.closed = false;
    int32_t x = random_in(seed, 0, WIDTH * 256);
    int32_t y = random_in(seed, 0, HEIGHT * 256);
    for (uint32_t i = 0; i < s.count; i++) {
        const bool is_short = i == 1 ? random_flag(seed) : i + 1 == s.count;
        const int32_t reach = is_short ? s.stroke.width >> 9 : 8000;
        x += i == 0 ? 0 : random_in(seed, -reach, reach);
        y += i == 0 ? 0 : random_in(seed, -reach, reach);
        s.v[i] = screen_at(x, y);
    }
    return s;
}

TEST(short_ends)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 29;
    double worst = 0.0;
    for (int n = 0; n < random_cases(3000); n++) {
        const uint64_t from = seed;
        const scene s = short_ended_scene(&seed);
        const double error = worst_error(&c, &s);
        if (error > 1.0 / 32) {
            fail_msg("scene %llx: off by %.4f", (unsigned long long)from, error);
        }
        worst = fmax(worst, error);
    }
    print_message("coverage beside short ends: off by %.4f at most\n", worst);
    canvas_free(&c);
}

/* (44, 22) was covered by .851: what lies between the end and the disc counted as well. */
TEST(a_notch_beside_a_butt_end_is_not_filled)
{
    scene s = {.count = 3, .stroke = qtri_stroke_default()};
    s.v[0] = screen_at(28, 2852);
    s.v[1] = screen_at(10870, 4406);
    s.v[2] = screen_at(10424, 4995);
    s.stroke.width = Q16(11.29);
    s.stroke.cap = QTRI_CAP_BUTT;
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    draw(&c.surface, &s);
    assert_near(stored_pixel(&c.surface, 44, 22) / 255.0, .559, 1.0 / 32);
    canvas_free(&c);
}

/* Hard edges: by the pixel's centre. Sides that pass through a centre may go either way. */
TEST(hard)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 5;
    int different = 0;
    int covered = 0;
    for (int n = 0; n < random_cases(400); n++) {
        struct ref_stroke_part part[POINTS];
        scene s = n % 2 != 0 ? short_ended_scene(&seed) : random_scene(&seed, 6);
        s.stroke.edges = NULL;
        const size_t count = parts_of(&s, part);
        canvas_clear(&c);
        draw(&c.surface, &s);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                const bool is = stored_pixel(&c.surface, x, y) != 0;
                const bool expected = ref_stroke_contains(part, count, x + .5, y + .5);
                covered += expected;
                different += is != expected;
                if (is != expected) {
                    struct ref_stroke_part near[2][POINTS];
                    for (size_t i = 0; i < count; i++) {
                        near[0][i] = near[1][i] = part[i];
                        near[0][i].radius += 1.5 / 128;
                        near[1][i].radius -= 1.5 / 128;
                    }
                    /* Butt ends do not move with the radius. */
                    assert_true(s.stroke.cap == QTRI_CAP_BUTT ||
                                ref_stroke_contains(near[0], count, x + .5, y + .5) !=
                                    ref_stroke_contains(near[1], count, x + .5, y + .5));
                }
            }
        }
    }
    print_message("%d of %d pixels differ\n", different, covered);
    assert_true(different * 500 < covered);
    canvas_free(&c);
}

/* Colours and depths along the line, over a picture that is not empty. */
static scene colored_scene(uint64_t *seed, int32_t most)
{
    scene s = random_scene(seed, most);
    for (uint32_t i = 0; i < s.count; i++) {
        s.v[i].depth_16p16 = (uint32_t)random_bits32(seed);
        for (int k = 0; k < 3; k++) {
            s.v[i].color_8p16[k] = random_in(seed, 0, 255 << 16);
        }
    }
    s.stroke.alpha = random_flag(seed) ? 255 : (uint8_t)random_in(seed, 0, 255);
    s.stroke.edges = random_in(seed, 0, 3) == 0 ? NULL : &qtri_stroke_smooth;
    return s;
}

static void paint(const qtri_surface *surface, const scene *s, const qtri_material *material)
{
    const qtri_rgb below = {90, 140, 30};
    clear_to(surface, below, 30000);
    qtri_raster_polyline(surface, material, &s->stroke, s->v, s->count);
}

/* Blends of the material, and a fog that halves twice from depth 0 to 1. */
static void set_effects(qtri_material *material, qtri_fog *fog, uint64_t *seed)
{
    const qtri_blend *const blends[] = {NULL,
                                        &qtri_blend_alpha,
                                        &qtri_blend_add,
                                        &qtri_blend_multiply,
                                        &qtri_blend_none,
                                        &qtri_blend_replace,
                                        &qtri_blend_screen_door,
                                        &qtri_blend_vertex_alpha};
    const qtri_fog_range range = {Q16(1), Q16(3), true};
    const qtri_rgb gray = {200, 120, 60};
    qtri_fog_linear(fog, gray, range, Q16(1), Q16(4));
    material->fog = random_flag(seed) ? fog : NULL;
    material->blend = blends[random_in(seed, 0, 7)];
    material->alpha = random_in(seed, 0, 3) == 0 ? 255 : (uint8_t)random_in(seed, 0, 255);
    material->keep = random_flag(seed) ? 0 : (uint8_t)random_in(seed, 0, 7);
}

/* What a colour's channel, of three, becomes at a depth of 0..1 over what is there. */
static double affected(const qtri_material *m, int channel, double color, double depth,
                       double under)
{
    static const uint8_t keep[3] = {QTRI_KEEP_RED, QTRI_KEEP_GREEN, QTRI_KEEP_BLUE};
    static const double gray[3] = {200, 120, 60};
    const double alpha = m->alpha / 255.0;
    if (m->fog != NULL) { /* z is 1 + 2 depth */
        color = gray[channel] + (color - gray[channel]) * (3 - 2 * depth) / 3;
    }
    if (m->blend != NULL && m->blend != &qtri_blend_screen_door && (m->keep & keep[channel]) != 0) {
        return under;
    }
    if (m->blend == &qtri_blend_alpha || m->blend == &qtri_blend_vertex_alpha) {
        return color * alpha + under * (1 - alpha);
    }
    if (m->blend == &qtri_blend_add) {
        return fmin(255, under + color * alpha);
    }
    if (m->blend == &qtri_blend_multiply) {
        return color * under / 255;
    }
    return m->blend == &qtri_blend_none ? under : color;
}

/* A pixel is that of fog and blend, as far as the stroke covers it; depth is written as ever. */
TEST(effects)
{
    uint64_t seed = 17;
    for (int n = 0; n < random_cases(160); n++) {
        const qtri_format *format = n % 2 != 0 ? &qtri_xrgb8888 : &qtri_rgb565;
        canvas c = canvas_new(format, WIDTH, HEIGHT);
        canvas plain = canvas_new(format, WIDTH, HEIGHT);
        struct ref_stroke_part part[POINTS];
        scene s = colored_scene(&seed, 5);
        qtri_material material = plain_material();
        qtri_fog fog;
        const double depth = s.v[0].depth_16p16 / 65536.0 / 65535;
        s.stroke.edges = &qtri_stroke_smooth;
        for (uint32_t i = 1; i < s.count; i++) {
            memcpy(s.v[i].color_8p16, s.v[0].color_8p16, sizeof s.v[0].color_8p16);
            s.v[i].depth_16p16 = s.v[0].depth_16p16;
        }
        material.depth_compare = QTRI_ALWAYS;
        paint(&plain.surface, &s, &material);
        set_effects(&material, &fog, &seed);
        const bool door = material.blend == &qtri_blend_screen_door;
        for (uint32_t i = 0; door && i < s.count; i++) { /* what is drawn is seen */
            s.stroke.alpha = 255;
            s.v[i].color_8p16[2] = 255 << 16;
            material.fog = NULL;
            material.keep = 0;
        }
        paint(&c.surface, &s, &material);
        const size_t count = parts_of(&s, part);
        canvas below = canvas_new(format, 1, 1);
        const qtri_rgb sky = {90, 140, 30};
        clear_to(&below.surface, sky, 0);
        const qtri_rgb was = qtri_surface_pixel(&below.surface, 0, 0);
        const double from[3] = {was.r, was.g, was.b};
        canvas_free(&below);
        for (int y = 0; y < HEIGHT; y++) {
            double share[WIDTH];
            ref_stroke_cover_row(part, count, y, WIDTH, share);
            for (int x = 0; x < WIDTH; x++) {
                const double weight = share[x] * s.stroke.alpha / 255.0;
                const qtri_rgb is = qtri_surface_pixel(&c.surface, x, y);
                const uint8_t got[3] = {is.r, is.g, is.b};
                const bool rejected = door && fabs(got[2] - from[2]) <= 1;
                if (rejected) {
                    assert_int_equal(stored_depth(&c.surface, x, y), 30000);
                } else {
                    assert_int_equal(stored_depth(&c.surface, x, y),
                                     stored_depth(&plain.surface, x, y));
                }
                for (int k = 0; k < 3; k++) {
                    const double to =
                        affected(&material, k, s.v[0].color_8p16[k] / 65536.0, depth, from[k]);
                    const double step =
                        format == &qtri_rgb565 ? (k == 1 ? 255 / 63.0 : 255 / 31.0) : 1;
                    if (rejected) {
                        continue;
                    }
                    /* 1/32 of the area, and roundings of the blend and of what is stored. */
                    assert_near(got[k], from[k] + weight * (to - from[k]),
                                fabs(to - from[k]) / 32 + 1.5 + .6 * step);
                }
            }
        }
        canvas_free(&c);
        canvas_free(&plain);
    }
}

/* What is blended is within what a step of the format and the area allow; outside nothing is. */
TEST(blending)
{
    uint64_t seed = 7;
    for (int n = 0; n < random_cases(120); n++) {
        const qtri_format *format = drawn_format(n);
        canvas c = canvas_new(format, WIDTH, HEIGHT);
        struct ref_stroke_part part[POINTS];
        scene s = colored_scene(&seed, 5);
        s.stroke.edges = &qtri_stroke_smooth;
        for (uint32_t i = 1; i < s.count; i++) {
            memcpy(s.v[i].color_8p16, s.v[0].color_8p16, sizeof s.v[0].color_8p16);
        }
        const qtri_material material = plain_material();
        paint(&c.surface, &s, &material);
        const size_t count = parts_of(&s, part);
        const bool is_gray = format == &qtri_gray8;
        const bool is_packed = format->pixels->bytes == 2;
        for (int y = 0; y < HEIGHT; y++) {
            double share[WIDTH];
            ref_stroke_cover_row(part, count, y, WIDTH, share);
            for (int x = 0; x < WIDTH; x++) {
                const double weight = share[x] * s.stroke.alpha / 255.0;
                const double from[3] = {90, 140, 30};
                double color[3];
                for (int k = 0; k < 3; k++) {
                    color[k] = from[k] * (1 - weight) + weight * s.v[0].color_8p16[k] / 65536.0;
                }
                const qtri_rgb is = qtri_surface_pixel(&c.surface, x, y);
                const uint8_t got[3] = {is.r, is.g, is.b};
                const double luma = .299 * color[0] + .587 * color[1] + .114 * color[2];
                for (int k = 0; k < 3; k++) {
                    /* 1/32 of the difference, and the rounding: of what was there, and now. */
                    const double step = is_packed ? (k == 1 ? 255 / 63.0 : 255 / 31.0) : 1;
                    assert_near(got[k], is_gray ? luma : color[k], 255 / 32.0 + 1.1 * step);
                }
            }
        }
        canvas_free(&c);
    }
}

/* A half transparent line is nowhere darker than once over what was there. */
TEST(joints_are_blended_once)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 8;
    for (int n = 0; n < random_cases(300); n++) {
        scene s = random_scene(&seed, POINTS);
        s.stroke.alpha = 100;
        s.stroke.edges = n % 3 == 0 ? NULL : &qtri_stroke_smooth;
        canvas_clear(&c);
        draw(&c.surface, &s);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                assert_in_range(stored_pixel(&c.surface, x, y), 0, 100);
            }
        }
    }
    canvas_free(&c);
}

static bool is_same(const qtri_screen_vertex *a, const qtri_screen_vertex *b)
{
    return a->x_24p8 == b->x_24p8 && a->y_24p8 == b->y_24p8;
}

/* The same points the other way round cover the same; a point amid a part changes nothing. */
TEST(order)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    canvas d = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    uint64_t seed = 9;
    for (int n = 0; n < random_cases(200); n++) {
        scene s = random_scene(&seed, 8);
        scene turned = s;
        for (uint32_t i = 0; i < s.count; i++) {
            turned.v[i] = s.v[s.count - 1 - i];
        }
        if (s.count > 1 && (is_same(&s.v[0], &s.v[1]) || is_same(&turned.v[0], &turned.v[1]))) {
            continue; /* its caps have no direction */
        }
        canvas_clear(&c);
        canvas_clear(&d);
        draw(&c.surface, &s);
        draw(&d.surface, &turned);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                assert_near(stored_pixel(&c.surface, x, y), stored_pixel(&d.surface, x, y), 4);
            }
        }
    }
    canvas_free(&c);
    canvas_free(&d);
}

/* Any 32 bits anywhere: nothing outside of the surface is touched, and nothing takes for ever. */
TEST(extremes)
{
    int32_t value[STRESS_COUNT];
    const int count = stress_values(value);
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    uint64_t seed = 10;
    for (int n = 0; n < random_cases(6000); n++) {
        scene s = colored_scene(&seed, 4);
        for (uint32_t i = 0; i < s.count; i++) {
            if (random_flag(&seed)) {
                s.v[i].x_24p8 = value[random_in(&seed, 0, count - 1)];
            }
            if (random_flag(&seed)) {
                s.v[i].y_24p8 = random_any(&seed);
            }
            s.v[i].color_8p16[0] = random_any(&seed);
        }
        if (random_flag(&seed)) {
            s.stroke.width = value[random_in(&seed, 0, count - 1)];
        }
        s.stroke.cap = (qtri_cap)random_in(&seed, 0, 4);
        qtri_material material = plain_material();
        material.depth_compare = (qtri_compare)random_in(&seed, 0, 8);
        qtri_raster_polyline(&c.surface, &material, &s.stroke, s.v, s.count);
        qtri_raster_point(&c.surface, &material, &s.stroke, s.v);
    }
    canvas_free(&c);
}

TEST(nothing)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    scene s = {{screen_at(5000, 5000), screen_at(9000, 7000)}, 2, qtri_stroke_default()};
    const qtri_stroke whole = s.stroke;
    const scene usual = s;
    draw(&c.surface, &s);
    assert_int_not_equal(stored_pixel(&c.surface, 25, 22), 0);
    canvas_clear(&c);
    s.stroke.width = 0;
    draw(&c.surface, &s);
    s.stroke.width = INT32_MIN;
    draw(&c.surface, &s);
    s.stroke = whole;
    s.stroke.alpha = 0;
    draw(&c.surface, &s);
    s.stroke = whole;
    s.count = 0;
    draw(&c.surface, &s);
    s.count = 1;
    s.stroke.cap = QTRI_CAP_BUTT;
    draw(&c.surface, &s);
    s = usual;
    c.surface.format = NULL;
    draw(&c.surface, &s);
    c.surface.format = &qtri_gray8;
    qtri_material never = plain_material();
    never.depth_compare = QTRI_NEVER;
    qtri_raster_polyline(&c.surface, &never, &s.stroke, s.v, s.count);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            assert_int_equal(stored_pixel(&c.surface, x, y), 0);
        }
    }
    canvas_free(&c);
}

/* Nearer ones are kept, and depth is written where half a pixel is covered. */
TEST(depth)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    qtri_material material = plain_material();
    material.depth_compare = QTRI_LESS;
    scene s = {{screen_at(10 * 256, 20 * 256 + 128), screen_at(70 * 256, 20 * 256 + 128)},
               2,
               qtri_stroke_default()};
    s.stroke.cap = QTRI_CAP_BUTT;
    s.stroke.width = Q16(1.5);
    s.v[0].depth_16p16 = 0;
    s.v[1].depth_16p16 = (uint32_t)60000 << 16;
    for (int x = 0; x < WIDTH; x++) {
        c.surface.depth[20 * WIDTH + x] = 30000;
    }
    qtri_raster_polyline(&c.surface, &material, &s.stroke, s.v, s.count);
    for (int x = 0; x < WIDTH; x++) {
        const bool inside = x >= 10 && x < 70;
        const bool nearer = inside && (x - 10 + .5) * 1000 < 30000;
        assert_int_equal(stored_pixel(&c.surface, x, 20), nearer ? 255 : 0);
        assert_near(stored_depth(&c.surface, x, 20), nearer ? (x - 10 + .5) * 1000 : 30000, 1);
        assert_near(stored_pixel(&c.surface, x, 21), inside ? 64 : 0, 1);
        assert_int_equal(stored_depth(&c.surface, x, 21), 65535);
    }
    canvas_free(&c);
}

/* A view of WIDTH x HEIGHT pixels in which a unit is a pixel, y downwards, z towards the eye. */
static qtri_view flat_view(void)
{
    qtri_view view;
    qtri_view_init(&view, WIDTH, HEIGHT);
    qtri_transform_ortho(&view.projection, 0, WIDTH * Q16_ONE, HEIGHT * Q16_ONE, 0, -Q16_ONE,
                         Q16_ONE);
    return view;
}

static qtri_corner corner_at(int32_t x_24p8, int32_t y_24p8)
{
    const qtri_corner corner = {{x_24p8 * 256, y_24p8 * 256, 0, Q16_ONE}, {255, 255, 255}, {0, 0}};
    return corner;
}

/* Corners in space are the same line as vertices on the screen, however many are kept. */
TEST(corners_in_space)
{
    canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    canvas d = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    qtri_view view = flat_view();
    qtri_transform pose;
    qtri_vertex kept[POINTS];
    uint64_t seed = 11;
    qtri_transform_identity(&pose);
    for (int n = 0; n < random_cases(100); n++) {
        scene s = random_scene(&seed, POINTS);
        qtri_corner corner[POINTS];
        const qtri_material material = plain_material();
        for (uint32_t i = 0; i < s.count; i++) {
            s.v[i].depth_16p16 = (uint32_t)32768 << 16;
            corner[i] = corner_at(s.v[i].x_24p8, s.v[i].y_24p8);
        }
        give_vertices(&view, n % 3 == 0 ? NULL : kept,
                      n % 3 == 0 ? 0 : (uint32_t)random_in(&seed, 0, POINTS));
        canvas_clear(&c);
        canvas_clear(&d);
        draw(&c.surface, &s);
        qtri_draw_polyline(&d.surface, &view, &pose, corner, s.count, &s.stroke, &material);
        assert_same_picture(&c.surface, &d.surface);
        if (s.count == 2) {
            canvas_clear(&d);
            qtri_draw_wide_lines(&d.surface, &view, &pose, corner, 3, &s.stroke, &material);
            assert_same_picture(&c.surface, &d.surface);
        }
        canvas_clear(&c);
        canvas_clear(&d);
        for (uint32_t i = 0; i < s.count; i++) {
            qtri_raster_point(&c.surface, &material, &s.stroke, &s.v[i]);
        }
        qtri_draw_points(&d.surface, &view, &pose, corner, s.count, &s.stroke, &material);
        assert_same_picture(&c.surface, &d.surface);
        /* A unit is a pixel: splats are as large. */
        canvas_clear(&d);
        s.stroke.in_space = true;
        qtri_draw_points(&d.surface, &view, &pose, corner, s.count, &s.stroke, &material);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                assert_near(stored_pixel(&c.surface, x, y), stored_pixel(&d.surface, x, y), 8);
            }
        }
    }
    canvas_free(&c);
    canvas_free(&d);
}

/* Parts on both sides of one that cannot be seen have their own colours, and depths. */
TEST(parts_apart_have_their_own_looks)
{
    const qtri_view view = flat_view();
    const qtri_material material = qtri_material_default();
    qtri_stroke stroke = qtri_stroke_default();
    qtri_transform pose;
    qtri_transform_identity(&pose);
    stroke.width = Q16(3);
    for (int n = 0; n < 10; n++) { /* one channel is another, or depth, or nothing */
        const int differs = n % 5;
        canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        const int32_t beyond = -20000 * 256; /* the guard band */
        qtri_corner corner[4] = {corner_at(4000, 3000), corner_at(beyond, 3000),
                                 corner_at(beyond, 9000), corner_at(4000, 9000)};
        for (int i = 0; i < 4; i++) {
            uint8_t *channel[3] = {&corner[i].color.r, &corner[i].color.g, &corner[i].color.b};
            for (int k = 0; k < 3; k++) {
                *channel[k] = i >= 2 && k == differs ? 20 : 200;
            }
            corner[i].position.z = i >= 2 && differs == 3 ? Q16(.5) : 0;
        }
        stroke.edges = n < 5 ? NULL : &qtri_stroke_smooth;
        canvas_clear(&c);
        canvas_clear(&d);
        qtri_draw_polyline(&c.surface, &view, &pose, corner, 4, &stroke, &material);
        qtri_draw_wide_lines(&d.surface, &view, &pose, corner, 4, &stroke, &material);
        assert_int_not_equal(stored_pixel(&c.surface, 5, 11), 0);
        assert_int_not_equal(stored_pixel(&c.surface, 5, 35), 0);
        assert_int_equal(stored_depth(&c.surface, 5, 11) != stored_depth(&c.surface, 5, 35),
                         differs == 3);
        assert_memory_equal(c.surface.pixels, d.surface.pixels, 4 * WIDTH * HEIGHT);
        assert_memory_equal(c.surface.depth, d.surface.depth, 2 * WIDTH * HEIGHT);
        canvas_free(&c);
        canvas_free(&d);
    }
}

/* On samples without depth a stroke is that which asks for none. */
TEST(samples_without_depth)
{
    uint64_t seed = 21;
    for (int n = 0; n < random_cases(40); n++) {
        scene s = random_scene(&seed, POINTS);
        canvas c[2];
        qtri_material material = plain_material();
        s.stroke.edges = n % 2 == 0 ? NULL : s.stroke.edges;
        for (int i = 0; i < 2; i++) {
            c[i] = canvas_new(&qtri_rgb565_x4, WIDTH, HEIGHT);
            qtri_samples_clear(&c[i].surface, (qtri_rgb){10, 90, 40});
            c[i].surface.depth = i == 0 ? c[i].surface.depth : NULL;
            material.depth_compare = i == 0 ? QTRI_DEPTH_OFF : QTRI_LESS;
            paint(&c[i].surface, &s, &material);
        }
        assert_memory_equal(c[0].surface.pixels, c[1].surface.pixels,
                            (size_t)c[0].surface.pitch * HEIGHT);
        canvas_free(&c[0]);
        canvas_free(&c[1]);
    }
}

/* A pixel of four equal samples is as one: it becomes what a plain surface's does, and its first
   depth, too. Over depths that differ from column to column. */
TEST(equal_samples_are_as_one_pixel)
{
    uint64_t seed = 23;
    int passed = 0, failed = 0;
    for (int n = 0; n < random_cases(60); n++) {
        const scene s = colored_scene(&seed, POINTS);
        qtri_material material = plain_material();
        canvas plain = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        canvas four = canvas_new(&qtri_xrgb8888_x4, WIDTH, HEIGHT);
        const qtri_rgb ground = {10, 90, 40};
        material.depth_compare = QTRI_LESS;
        qtri_surface_clear(&plain.surface, ground);
        qtri_samples_clear(&four.surface, ground);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const uint16_t depth = (uint16_t)random_in(&seed, 0, 65535);
            plain.surface.depth[i / WIDTH * plain.surface.depth_pitch + i % WIDTH] = depth;
            four.surface.depth[i / WIDTH * four.surface.depth_pitch + i % WIDTH] = depth;
        }
        const canvas before = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
        memcpy(before.memory, plain.memory, plain.bytes);
        qtri_raster_polyline(&plain.surface, &material, &s.stroke, s.v, s.count);
        qtri_raster_polyline(&four.surface, &material, &s.stroke, s.v, s.count);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const int32_t x = i % WIDTH, y = i / WIDTH;
            const bool drawn =
                stored_pixel(&before.surface, x, y) != stored_pixel(&plain.surface, x, y);
            const qtri_pixels *pixels = four.surface.format->pixels;
            const uint8_t *record =
                four.surface.pixels + y * four.surface.pitch + (ptrdiff_t)x * pixels->bytes;
            assert_int_equal(pixels->load(record), stored_pixel(&plain.surface, x, y));
            assert_int_equal(stored_depth(&four.surface, x, y), stored_depth(&plain.surface, x, y));
            passed += drawn;
            failed += !drawn;
        }
        free(before.memory);
        canvas_free(&plain);
        canvas_free(&four);
    }
    assert_true(passed > 50 * random_cases(60) && failed > 50 * random_cases(60));
}

/* Samples of pixels that a stroke does not change stay as they are, each by itself. */
TEST(samples_beside_a_stroke_stay)
{
    uint64_t seed = 25;
    for (int n = 0; n < random_cases(20); n++) {
        const scene s = colored_scene(&seed, POINTS);
        const qtri_material material = plain_material();
        canvas c = canvas_new(&qtri_rgb565_x4, WIDTH, HEIGHT);
        canvas before = canvas_new(&qtri_rgb565_x4, WIDTH, HEIGHT);
        const qtri_pixels *pixels = c.surface.format->pixels;
        for (ptrdiff_t i = 0; i < c.surface.pitch * HEIGHT; i++) {
            c.surface.pixels[i] = (uint8_t)random_in(&seed, 0, 255);
        }
        memcpy(before.memory, c.memory, c.bytes);
        qtri_raster_polyline(&c.surface, &material, &s.stroke, s.v, s.count);
        for (int32_t i = 0; i < WIDTH * HEIGHT; i++) {
            const ptrdiff_t at =
                i / WIDTH * c.surface.pitch + (ptrdiff_t)(i % WIDTH) * pixels->bytes;
            const uint8_t *is = c.surface.pixels + at, *was = before.surface.pixels + at;
            if (pixels->load(is) == pixels->load(was)) {
                assert_memory_equal(is, was, pixels->bytes);
            }
        }
        canvas_free(&c);
        canvas_free(&before);
    }
}

/*
 * More thin parts in a few columns than are kept apart: nothing is drawn outside of them, nor is
 * anything missed; what lies between two is covered at most.
 */
TEST(many_parts_in_a_few_columns)
{
    for (int n = 0; n < 6; n++) {
        enum { PARTS = 23, LEFT = 20 * 256 };
        canvas c = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
        scene s = {.count = PARTS + 1, .stroke = qtri_stroke_default()};
        const int32_t apart = 60 + 20 * n;
        s.stroke.width = Q16(.05);
        for (int32_t i = 0; i <= PARTS; i++) { /* up and down, from beyond the rows to beyond */
            s.v[i] = screen_at(LEFT + i * apart, i % 2 == 0 ? -20000 : 33000);
        }
        canvas_clear(&c);
        draw(&c.surface, &s);
        const int32_t end = (LEFT + PARTS * apart + 255) >> 8;
        for (int32_t y = 0; y < HEIGHT; y++) {
            uint32_t sum = 0;
            for (int32_t x = 0; x < WIDTH; x++) {
                const uint32_t is = stored_pixel(&c.surface, x, y);
                assert_true(is == 0 || (x >= LEFT / 256 - 1 && x <= end));
                sum += is;
            }
            /* Parts of 13/256 pixel each, and a pixel of 255 where they are taken together. */
            assert_in_range(sum, PARTS * 255 * 12 / 256 * 3 / 4, 255 * (end - LEFT / 256 + 1));
        }
        canvas_free(&c);
    }
}

static const qtri_vec3 cube_positions[8] = {
    {-Q16_ONE, -Q16_ONE, -Q16_ONE}, {Q16_ONE, -Q16_ONE, -Q16_ONE}, {Q16_ONE, Q16_ONE, -Q16_ONE},
    {-Q16_ONE, Q16_ONE, -Q16_ONE},  {-Q16_ONE, -Q16_ONE, Q16_ONE}, {Q16_ONE, -Q16_ONE, Q16_ONE},
    {Q16_ONE, Q16_ONE, Q16_ONE},    {-Q16_ONE, Q16_ONE, Q16_ONE}};
static const uint16_t cube_triangles[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                               {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6},
                                               {1, 2, 6}, {1, 6, 5}, {0, 4, 7}, {0, 7, 3}};

typedef struct space {
    qtri_view view;
    qtri_transform pose;
    qtri_mesh mesh;
    qtri_light light;
    qtri_vertex vertices[8];
} space;

static void set_space(space *s, uint64_t *seed, bool kept)
{
    const qtri_vec3 eye = {0, 0, random_in(seed, 60000, 600000)}, center = {0, 0, 0};
    const qtri_vec3 up = {0, Q16_ONE, 0};
    const qtri_light light = {
        .towards = {Q16(.4), Q16(.6), Q16(.7)}, .ambient = Q16(.3), .diffuse = Q16(.7)};
    memset(s, 0, sizeof *s);
    qtri_view_init(&s->view, WIDTH, HEIGHT);
    qtri_transform_look_at(&s->view.camera, eye, center, up);
    qtri_transform_perspective(&s->view.projection, Q16(60), Q16(1.5), Q16(.5), Q16(30));
    qtri_transform_identity(&s->pose);
    qtri_transform_rotate_x(&s->pose, random_any(seed));
    qtri_transform_rotate_y(&s->pose, random_any(seed));
    s->light = light;
    s->view.light = &s->light;
    give_vertices(&s->view, kept ? s->vertices : NULL, kept ? 8 : 0);
    s->mesh.positions = cube_positions;
    s->mesh.triangles = cube_triangles;
    s->mesh.vertex_count = 8;
    s->mesh.triangle_count = 12;
}

enum { MANY = 330 };

static qtri_corner many[MANY];

/* A spiral around the centre: from point to point about a pixel, some twice. */
static void set_spiral(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const double turn = .04 * (double)(i - i % 7 / 6);
        many[i] = corner_at((int32_t)(256 * (41.3 + (3 + 1.3 * turn) * cos(turn))),
                            (int32_t)(256 * (26.7 + (3 + .7 * turn) * sin(turn))));
    }
}

/* Of parts only the first few hundred are marked where they may touch the rows. */
TEST(polylines_of_many_points)
{
    canvas whole = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    canvas other = canvas_new(&qtri_gray8, WIDTH, HEIGHT);
    qtri_view view = flat_view();
    qtri_transform pose;
    qtri_material material = plain_material();
    qtri_stroke stroke = qtri_stroke_default();
    qtri_transform_identity(&pose);
    material.blend = &qtri_blend_alpha;
    material.alpha = 200;
    for (int n = 0; n < 3; n++) {
        stroke.width = Q16(.6) + n * Q16(.8);
        stroke.cap = QTRI_CAP_ROUND;
        stroke.closed = n == 2;
        set_spiral(MANY);
        canvas_clear(&whole);
        qtri_draw_polyline(&whole.surface, &view, &pose, many, MANY, &stroke, &material);
        /* Bands and scissors show the same. */
        canvas_clear(&other);
        for (int32_t row = 0; row < HEIGHT; row += 20) {
            for (int32_t x = 0; x < WIDTH; x += 42) {
                qtri_surface piece = other.surface;
                piece.scissor = (qtri_rect){x, row, x + 42, row + 20};
                qtri_draw_polyline(&piece, &view, &pose, many, MANY, &stroke, &material);
            }
        }
        assert_same_picture(&whole.surface, &other.surface);
        /* Parts before it that are behind the eye take its own to other places. */
        stroke.closed = false;
        const uint32_t first = 270;
        canvas_clear(&whole);
        qtri_draw_polyline(&whole.surface, &view, &pose, many + first, MANY - first, &stroke,
                           &material);
        for (uint32_t i = 0; i < first; i++) {
            many[i] = many[first];
            many[i].position.z = Q16(3);
        }
        canvas_clear(&other);
        qtri_draw_polyline(&other.surface, &view, &pose, many, MANY, &stroke, &material);
        for (int32_t i = 0; i < WIDTH * HEIGHT;
             i++) { /* the first part begins flat, beside a disc */
            assert_near(stored_pixel(&whole.surface, i % WIDTH, i / WIDTH),
                        stored_pixel(&other.surface, i % WIDTH, i / WIDTH), 1);
        }
    }
    canvas_free(&whole);
    canvas_free(&other);
}

/* Faces hide the edges behind them: a cube without culling looks as one with its back culled. */
TEST(hidden_lines)
{
    uint64_t seed = 13;
    int different = 0;
    int drawn = 0;
    canvas c = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    canvas d = canvas_new(&qtri_xrgb8888, WIDTH, HEIGHT);
    for (int n = 0; n < 40; n++) {
        space s;
        qtri_material material = qtri_material_default();
        set_space(&s, &seed, true);
        const qtri_vec3 eye = {0, 0, Q16(5)}, center = {0, 0, 0}, up = {0, Q16_ONE, 0};
        qtri_transform_look_at(&s.view.camera, eye, center, up);
        s.view.light = NULL;
        canvas_clear(&c);
        canvas_clear(&d);
        qtri_draw_hidden_lines(&c.surface, &s.view, &s.pose, &s.mesh, NULL, &material, Q16(.002));
        material.cull = QTRI_CULL_NONE;
        qtri_draw_hidden_lines(&d.surface, &s.view, &s.pose, &s.mesh, NULL, &material, Q16(.002));
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                drawn += stored_pixel(&c.surface, x, y) != 0;
                different +=
                    (stored_pixel(&c.surface, x, y) != 0) != (stored_pixel(&d.surface, x, y) != 0);
            }
        }
    }
    print_message("hidden lines: %d of %d pixels differ\n", different, drawn);
    assert_true(different * 20 < drawn);
    canvas_free(&c);
    canvas_free(&d);
}

/* Lines through the near plane and any corner and size. */
TEST(extreme_corners)
{
    canvas c = canvas_new(&qtri_rgb565, WIDTH, HEIGHT);
    uint64_t seed = 14;
    for (int n = 0; n < random_cases(1500); n++) {
        space s;
        qtri_corner corner[4];
        qtri_stroke stroke = qtri_stroke_default();
        const qtri_material material = qtri_material_default();
        set_space(&s, &seed, n % 2 == 0);
        for (int i = 0; i < 4; i++) {
            const int32_t w = random_flag(&seed) ? Q16_ONE : random_any(&seed);
            corner[i] = corner_at(0, 0);
            corner[i].position.x = random_any(&seed);
            corner[i].position.y = random_any(&seed);
            corner[i].position.z = random_any(&seed);
            corner[i].position.w = w;
        }
        stroke.width = random_flag(&seed) ? random_any(&seed) : Q16(2);
        stroke.closed = random_flag(&seed);
        stroke.in_space = random_flag(&seed);
        stroke.cap = (qtri_cap)random_in(&seed, 0, 2);
        qtri_draw_polyline(&c.surface, &s.view, &s.pose, corner, 4, &stroke, &material);
        qtri_draw_wide_lines(&c.surface, &s.view, &s.pose, corner, 4, &stroke, &material);
        qtri_draw_points(&c.surface, &s.view, &s.pose, corner, 4, &stroke, &material);
    }
    canvas_free(&c);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
