/* SPDX-License-Identifier: MIT */
/*
 * The vertex stage and the clipper: from object space to snapped screen coordinates, against exact
 * arithmetic.
 */
#include "support/core.h"

#include "geometry/projector.h"
#include "geometry/projector.h"

static qtri_projector projector_for(const qtri_transform *t, int32_t width, int32_t height)
{
    qtri_projector projector;
    qtri_viewport viewport = qtri_viewport_top(0, 0, width, height);
    qtri_projector_init(&projector, t, &viewport);
    return projector;
}

/* numerator / denominator in 1/256 pixel, halves up, held to the guard band. */
static int32_t snapped(int128 numerator, int128 denominator)
{
    int128 x = floor_div(512 * numerator + denominator, 2 * denominator);
    int128 limit = QTRI_SCREEN_MAX_24P8;
    return (int32_t)(x < -limit ? -limit : (x > limit ? limit : x));
}

/* One point in clip space with identity matrices: everything can be computed exactly. */
static double check_clip_space_point(qtri_vec4 p, int32_t width, int32_t height)
{
    qtri_transform identity;
    qtri_transform_identity(&identity);
    qtri_projector projector = projector_for(&identity, width, height);
    const qtri_vec4 *points[1] = {&p};
    qtri_clip_vertex clip;
    qtri_screen_vertex screen;
    qtri_projector_points(&projector, points, 1, &clip);
    if (qtri_clip_outcode(&clip) != 0) {
        return 0;
    }
    qtri_project(&projector, &clip, &screen);
    int128 w = p.w;
    int32_t x = snapped(((int128)p.x + w) * width, 2 * w);
    int32_t y = snapped((w - p.y) * height, 2 * w);
    if (screen.x_24p8 != x || screen.y_24p8 != y) {
        fail_msg("%d %d %d: %d %d, not %d %d", (int)p.x, (int)p.y, (int)p.w, (int)screen.x_24p8,
                 (int)screen.y_24p8, (int)x, (int)y);
    }
    double depth = 65535 * ((double)p.z / p.w + 1) / 2;
    return fabs(screen.depth_16p16 / 65536. - depth);
}

TEST(snaps)
{
    static const q16 ws[] = {Q16(1), Q16(2), Q16(3), Q16(1.5), Q16(7), Q16(0.75), 3, 65537};
    double worst = 0;
    uint64_t seed = 41;
    for (size_t i = 0; i < LENGTH_OF(ws); i++) {
        for (int32_t n = -1100; n <= 1100; n++) { /* multiples of 1/512: ties at every other */
            q16 step = ws[i] / 512;
            qtri_vec4 p = {n * step, (n * 3 % 1024) * step, n * (ws[i] / 1101), ws[i]};
            worst = fmax(worst, check_clip_space_point(p, 256, 256));
            qtri_vec4 near_tie = {p.x + random_in(&seed, -1, 1), p.y + random_in(&seed, -1, 1), p.z,
                                  p.w};
            worst = fmax(worst, check_clip_space_point(near_tie, 256, 256));
        }
    }
    for (int i = 0; i < 300000; i++) {
        qtri_vec4 p = {random_any(&seed), random_any(&seed), random_any(&seed), random_any(&seed)};
        worst = fmax(
            worst, check_clip_space_point(p, random_in(&seed, 1, 8192), random_in(&seed, 1, 300)));
    }
    print_message("depth: %.5f of 65535\n", worst);
    assert_true(worst <= .01);
}

/* The projector's rows as they are, applied exactly: rounding to the grid adds nothing to them. */
TEST(projects_its_rows)
{
    uint64_t seed = 42;
    double worst = 0;
    int drawn = 0;
    int rounded = 0;
    for (int n = 0; n < random_cases(100000); n++) {
        qtri_transform t;
        qtri_vec3 eye = {random_in(&seed, -500000, 500000), random_in(&seed, -500000, 500000),
                         random_in(&seed, -500000, 500000)};
        qtri_vec3 origin = {0, 0, 0};
        qtri_vec3 up = {0, Q16_ONE, 0};
        qtri_transform_identity(&t);
        qtri_transform_perspective(&t, Q16(60), Q16(1.3333333), Q16(0.1), Q16(100));
        qtri_transform_look_at(&t, eye, origin, up);
        qtri_projector projector = projector_for(&t, 320, 240);
        qtri_vec3 p = {random_in(&seed, -300000, 300000), random_in(&seed, -300000, 300000),
                       random_in(&seed, -300000, 300000)};
        qtri_clip_vertex clip;
        qtri_screen_vertex screen;
        qtri_projector_point(&projector, &p, &clip);
        if (qtri_clip_outcode(&clip) != 0) {
            continue;
        }
        drawn++;
        qtri_project(&projector, &clip, &screen);
        long double v[4];
        for (int i = 0; i < 4; i++) {
            const qtri_row *row = &projector.row.wide[i];
            int128 sum = (int128)row->m[0] * p.x + (int128)row->m[1] * p.y +
                         (int128)row->m[2] * p.z + row->t;
            v[i] = ldexpl((long double)sum, -row->exponent);
        }
        long double x = 256 * v[0] / v[3];
        long double y = 256 * v[1] / v[3];
        worst = fmax(worst,
                     fabs((double)(32767.5L * (v[2] / v[3] + 1) - screen.depth_16p16 / 65536.L)));
        rounded += screen.x_24p8 != (int32_t)floorl(x + .5L);
        rounded += screen.y_24p8 != (int32_t)floorl(y + .5L);
        assert_int_equal(screen.x_24p8, snapped(clip.x, clip.w));
        assert_int_equal(screen.y_24p8, snapped(clip.y, clip.w));
        /* 1/w, up to the call's common factor */
        assert_true(screen.inv_w_q31 >= 0x40000000u && screen.inv_w_q31 <= 0x80000000u);
        long double inv_w = ldexpl(screen.inv_w_q31, screen.inv_w_exponent - 31) * clip.w;
        assert_true(fabsl(inv_w / ldexpl(1, 64) * 2 - 1) < ldexpl(1, -29) ||
                    fabsl(inv_w / ldexpl(1, 63) - 1) < ldexpl(1, -29));
    }
    print_message("%d vertices: %d coordinates on the other side of a rounding, depth %.5f\n",
                  drawn, rounded, worst);
    assert_true(drawn > 10000);
    assert_true(rounded <= 1);
    assert_true(worst <= .01);
}

/* A row whose sums are of any size, as log2 goes: by its translation alone, or by all of it. */
static void random_row(qtri_row *row, uint64_t *seed, bool alone)
{
    const int32_t less = random_in(seed, 0, 40);
    for (int i = 0; i < 3; i++) {
        row->m[i] = alone ? 0 : random_bits32(seed) / 2 >> (less > 30 ? 30 : less);
    }
    const int64_t t = (int64_t)(random64(seed) >> 3 >> less); /* < 2^61 */
    row->t = random_flag(seed) ? t : -t;
    row->exponent = 0;
}

/* Many vertices at once, by shifts and a reciprocal, are those of the exact way, bit for bit. */
TEST(vertices_are_exact)
{
    uint64_t seed = 47;
    int inside = 0;
    for (int n = 0; n < random_cases(60000); n++) {
        qtri_transform identity;
        qtri_transform_identity(&identity);
        qtri_projector projector = projector_for(&identity, 320, 240);
        const bool alone = n % 2 == 0;
        const int32_t near_to = random_in(&seed, 0, 12); /* rows of sizes that are alike */
        for (int i = 0; i < 4; i++) {
            random_row(&projector.row.wide[i], &seed, alone);
            projector.shift[i] = 2 + random_in(&seed, 0, n % 8 < 6 ? 3 : 40);
        }
        if (n % 4 < 2) { /* in front, and depths between the planes */
            qtri_row *z = &projector.row.wide[2], *w = &projector.row.wide[3];
            w->t = w->t < 0 ? -w->t : w->t;
            projector.shift[2] = projector.shift[3];
            z->t = n % 3 == 0 ? 0 : w->t - (w->t >> near_to) * random_in(&seed, 0, 2);
            z->t += random_in(&seed, -9, 9);
        }
        qtri_vec3 p[4];
        qtri_vertex vertex[4], listed[4];
        memset(vertex, 0, sizeof vertex);
        memset(listed, 0, sizeof listed);
        bool all = true;
        for (int i = 0; i < 4; i++) {
            p[i].x = random_any(&seed);
            p[i].y = random_any(&seed);
            p[i].z = random_any(&seed);
            listed[i].index = (uint16_t)i;
        }
        const bool all_found = qtri_projector_vertices(&projector, p, 4, vertex, false);
        const bool list_found = qtri_projector_vertices(&projector, p, 4, listed, true);
        for (int i = 0; i < 4; i++) {
            qtri_clip_vertex clip;
            qtri_vertex exact;
            memset(&exact, 0, sizeof exact);
            qtri_projector_point(&projector, &p[i], &clip);
            qtri_vertex_exact(&projector, &clip, &exact);
            const bool seen = (exact.depth_16p8 & QTRI_VERTEX_OUTSIDE) == 0;
            all = all && seen;
            inside += seen;
            assert_memory_equal(&vertex[i], &exact, sizeof exact);
            exact.index = (uint16_t)i;
            assert_memory_equal(&listed[i], &exact, sizeof exact);
        }
        assert_int_equal(all_found, all);
        assert_int_equal(list_found, all);
    }
    print_message("%d of 240000 vertices inside\n", inside);
    assert_true(inside > 20000);
}

/*
 * What snapping moved a vertex by, against exact arithmetic; ties, which are half a step, and what
 * the guard band held, which counts as 0. A w that is 0 or below is 1.
 */
TEST(rests_of_snapping)
{
    uint64_t seed = 48;
    double least = 0, greatest = 0;
    for (int n = 0; n < random_cases(60000); n++) {
        qtri_clip_vertex v;
        memset(&v, 0, sizeof v);
        v.w = 1 + (int64_t)(random64(&seed) >> random_in(&seed, 18, 62));
        if (n % 4 == 0) { /* even, so that there are ties */
            v.w = (int64_t)1 << random_in(&seed, 1, 45);
        }
        const int32_t zeros = __builtin_clzll((uint64_t)v.w);
        const int32_t inv_w = qtri_reciprocal_below((uint32_t)((uint64_t)v.w << zeros >> 32));
        const int128 w = n % 16 == 1 ? 1 : v.w;
        const qtri_point at = {random_in(&seed, -4000000, 4000000),
                               random_in(&seed, -4000000, 4000000)};
        int128 rest[2];
        int64_t x[2];
        for (int i = 0; i < 2; i++) {
            const int128 twice = 2 * w * (i == 0 ? at.x_24p8 : at.y_24p8);
            rest[i] = random_in(&seed, -3, 3) * (w / 2) + random_in(&seed, -1, 1);
            rest[i] = n % 3 == 0 ? (int128)(random64(&seed) % (uint64_t)(2 * w + 1)) - w : rest[i];
            x[i] = (int64_t)floor_div(twice + rest[i], 512);
            rest[i] = 512 * (int128)x[i] - twice;
        }
        v.x = x[0];
        v.y = x[1];
        int32_t of_w = inv_w;
        if (w == 1) {
            v.w = -(int64_t)random_in(&seed, 0, 1) * v.w;
            of_w = qtri_reciprocal_below(0x80000000u);
        }
        int16_t is[2];
        qtri_project_rest(is, &v, &at, (uint32_t)of_w);
        for (int i = 0; i < 2; i++) {
            if (rest[i] < -w || rest[i] > w) {
                assert_int_equal(is[i], 0);
            } else {
                const double wanted = fmin((double)rest[i] / (double)w * 32768, 32767);
                least = fmin(least, is[i] - wanted);
                greatest = fmax(greatest, is[i] - wanted);
            }
        }
    }
    print_message("rests: %.5f..%.5f\n", least, greatest);
    assert_true(least > -1.001 && greatest < .001);
}

static void check_fact(const qtri_projector *projector, qtri_vec3 p, double x, double y, double z)
{
    qtri_clip_vertex clip;
    qtri_screen_vertex screen;
    qtri_projector_point(projector, &p, &clip);
    assert_int_equal(qtri_clip_outcode(&clip), 0);
    qtri_project(projector, &clip, &screen);
    assert_near(screen.x_24p8 / 256., x, 1 / 512. + 1e-6);
    assert_near(screen.y_24p8 / 256., y, 1 / 512. + 1e-6);
    assert_near(screen.depth_16p16 / 65536., z * 65535, .01);
}

/* Window depth at a distance of w. */
static double depth_at(double w, double near_z, double far_z)
{
    return far_z * (1 - near_z / w) / (far_z - near_z);
}

/* The course's depth is that of near = .1; in Q16.16 the plane is at 6554 / 65536. */
static void check_scene(const qtri_projector *projector, qtri_vec3 p, const double xy[2], double w,
                        double far_z, double z)
{
    assert_near(depth_at(w, .1, far_z), z, 1e-9);
    check_fact(projector, p, xy[0], xy[1], depth_at(w, real(Q16(0.1)), far_z));
}

/* COURSE scenes 2 and 3. */
TEST(course_scenes)
{
    static const double xy[6][2] = {{591.421356, 350}, {350, 108.578644}, {108.578644, 350},
                                    {128, 54.0991655}, {17.1487483, 128}, {238.8512517, 128}};
    qtri_transform t;
    qtri_vec3 origin = {0, 0, 0};
    qtri_vec3 up = {0, Q16_ONE, 0};
    qtri_transform_identity(&t);
    qtri_transform_perspective(&t, Q16(45), Q16(1), Q16(0.1), Q16(50));
    qtri_transform_look_at(&t, vec3_of(0, 0, 5), vec3_of(0, 0, 4), up);
    qtri_projector projector = projector_for(&t, 700, 700);
    check_scene(&projector, vec3_of(2, 0, -2), xy[0], 7, 50, .987689665);
    check_scene(&projector, vec3_of(0, 2, -2), xy[1], 7, 50, .987689665);
    check_scene(&projector, vec3_of(-2, 0, -2), xy[2], 7, 50, .987689665);

    qtri_transform_identity(&t);
    qtri_transform_perspective(&t, Q16(60), Q16(1), Q16(0.1), Q16(10));
    qtri_transform_look_at(&t, vec3_of(0, 0, 3), origin, up);
    projector = projector_for(&t, 256, 256);
    check_scene(&projector, vec3_of(0, 1, 0), xy[3], 3, 10, .976430976);
    check_scene(&projector, vec3_of(-1, 0, 1), xy[4], 2, 10, .959595960);
    check_scene(&projector, vec3_of(1, 0, 1), xy[5], 2, 10, .959595960);
}

TEST(viewports)
{
    qtri_viewport top = qtri_viewport_top(10, 20, 100, 50);
    qtri_viewport bottom = qtri_viewport_bottom(10, 30, 100, 50, 100);
    assert_memory_equal(&top, &bottom, sizeof top);
    qtri_viewport extreme = qtri_viewport_bottom(0, INT32_MIN, 1, INT32_MIN, INT32_MAX);
    assert_true(extreme.y <= QTRI_VIEWPORT_MAX);
    qtri_transform identity;
    qtri_transform_identity(&identity);
    qtri_projector projector;
    qtri_vec3 corner[3] = {vec3_of(-1, 1, -1), vec3_of(1, -1, 1), vec3_of(0, 0, 0)};
    static const double expected[3][3] = {{10, 20, .25}, {110, 70, .75}, {60, 45, .5}};
    top.depth_near = Q16(0.25);
    top.depth_far = Q16(0.75);
    qtri_projector_init(&projector, &identity, &top);
    for (int i = 0; i < 3; i++) {
        check_fact(&projector, corner[i], expected[i][0], expected[i][1], expected[i][2]);
    }
    top.depth_near = Q16(1);
    top.depth_far = 0; /* reversed */
    qtri_projector_init(&projector, &identity, &top);
    check_fact(&projector, corner[0], 10, 20, 1);
    check_fact(&projector, corner[1], 110, 70, 0);
    qtri_viewport odd = qtri_viewport_top(-8192, 8192, 8191, 1);
    qtri_projector_init(&projector, &identity, &odd);
    check_fact(&projector, corner[1], -1, 8193, 1);
    check_fact(&projector, corner[2], -4096.5, 8192.5, .5);
}

TEST(outcodes)
{
    const int64_t w = (int64_t)1 << 40;
    const int64_t far_x = w << QTRI_GUARD_LOG2;
    struct {
        qtri_clip_vertex v;
        unsigned outcode;
    } cases[] = {
        {{0, 0, 0, w, 0, 0}, 0},
        {{far_x, far_x, w, w, 0, 0}, 0},
        {{-far_x, -far_x, -w, w, 0, 0}, 0},
        {{0, 0, -w - 1, w, 0, 0}, QTRI_OUT_NEAR},
        {{0, 0, w + 1, w, 0, 0}, QTRI_OUT_FAR},
        {{-2 * far_x, 0, 0, w, 0, 0}, QTRI_OUT_LEFT},
        {{2 * far_x, 0, 0, w, 0, 0}, QTRI_OUT_RIGHT},
        {{0, -2 * far_x, 0, w, 0, 0}, QTRI_OUT_TOP},
        {{0, 2 * far_x, 0, w, 0, 0}, QTRI_OUT_BOTTOM},
        {{0, 0, 0, 0, 0, 0}, QTRI_OUT_NEAR},
        {{0, 0, 0, -w, 0, 0},
         QTRI_OUT_NEAR | QTRI_OUT_FAR | QTRI_OUT_LEFT | QTRI_OUT_RIGHT | QTRI_OUT_TOP |
             QTRI_OUT_BOTTOM},
    };
    for (size_t i = 0; i < LENGTH_OF(cases); i++) {
        assert_int_equal(qtri_clip_outcode(&cases[i].v), cases[i].outcode);
    }
}

TEST(no_w)
{
    qtri_transform identity;
    qtri_transform_identity(&identity);
    qtri_projector projector = projector_for(&identity, 256, 256);
    static const q16 ws[] = {0, -1, INT32_MIN, 1, 2};
    static const q16 xs[] = {0, 1, -1, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 125; i++) {
        qtri_vec4 p = {xs[i % 5], xs[i / 5 % 5], xs[i / 25], ws[i % 3]};
        const qtri_vec4 *points[1] = {&p};
        qtri_clip_vertex clip;
        qtri_screen_vertex screen;
        qtri_projector_points(&projector, points, 1, &clip);
        assert_true(qtri_clip_outcode(&clip) != 0);
        qtri_project(&projector, &clip, &screen); /* defined all the same */
        qtri_vec4 tiny = {xs[i % 5] / 65536, xs[i / 5 % 5], 0, ws[3 + i % 2]};
        (void)check_clip_space_point(tiny, 256, 256);
    }
}

static int64_t distance(const qtri_clip_vertex *v, int plane)
{
    const int64_t along[6] = {v->z,          -v->z,        v->x / 16384,
                              -v->x / 16384, v->y / 16384, -v->y / 16384};
    return v->w + along[plane];
}

static qtri_clip_vertex random_clip_vertex(uint64_t *seed, int bits)
{
    qtri_clip_vertex v = {0};
    int64_t *c[4] = {&v.x, &v.y, &v.z, &v.w};
    for (int i = 0; i < 4; i++) {
        int shift = i < 2 ? 3 + random_in(seed, 0, 12) : 3 + random_in(seed, 10, 20);
        *c[i] = (int64_t)random64(seed) >> (shift + 61 - bits);
    }
    if (random_in(seed, 0, 3) != 0) {
        v.w = v.w < 0 ? -v.w : v.w;
    }
    if (random_in(seed, 0, 20) == 0) {
        v.x = v.y = 0;
        v.z = -v.w;
    }
    return v;
}

static unsigned union_of(const qtri_clip_vertex v[3])
{
    return qtri_clip_outcode(&v[0]) | qtri_clip_outcode(&v[1]) | qtri_clip_outcode(&v[2]);
}

static void with_weights(qtri_clip_vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        v[i].b1_q30 = i == 1 ? 1 << 30 : 0;
        v[i].b2_q30 = i == 2 ? 1 << 30 : 0;
    }
}

TEST(clipped_polygons)
{
    uint64_t seed = 43;
    int longest = 0;
    int64_t outside = 0;
    double weights = 0;
    for (int n = 0; n < 300000; n++) { /* one in 100,000 has 8 */
        qtri_clip_vertex v[QTRI_CLIP_MAX];
        qtri_clip_vertex from[3];
        int bits = random_in(&seed, 50, 61);
        for (int i = 0; i < 3; i++) {
            v[i] = random_clip_vertex(&seed, bits);
        }
        with_weights(v);
        memcpy(from, v, sizeof from);
        unsigned planes = union_of(v);
        int count = qtri_clip_polygon(v, 3, planes);
        assert_true(count == 0 || (count >= 3 && count <= QTRI_CLIP_MAX));
        longest = count > longest ? count : longest;
        if (planes == 0) {
            assert_int_equal(count, 3);
            assert_memory_equal(v, from, sizeof from);
        }
        for (int i = 0; i < count; i++) {
            assert_true(v[i].w > 0);
            for (int plane = 0; plane < 6; plane++) {
                int64_t d = distance(&v[i], plane);
                outside = d < outside ? d : outside;
            }
            long double b1 = ldexpl(v[i].b1_q30, -30);
            long double b2 = ldexpl(v[i].b2_q30, -30);
            assert_true(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1);
            /* The weights give the point, within 2^-30 of the corners. */
            long double x[4] = {v[i].x, v[i].y, v[i].z, v[i].w};
            for (int k = 0; k < 4; k++) {
                long double c[3];
                for (int j = 0; j < 3; j++) {
                    const int64_t all[4] = {from[j].x, from[j].y, from[j].z, from[j].w};
                    c[j] = all[k];
                }
                long double size = fabsl(c[0]) + fabsl(c[1]) + fabsl(c[2]) + 1;
                long double error = x[k] - (c[0] + (c[1] - c[0]) * b1 + (c[2] - c[0]) * b2);
                weights = fmax(weights, (double)(fabsl(error) / size));
            }
        }
    }
    print_message("clipped: up to %d vertices, %lld units outside, weights %.2f 2^-30\n", longest,
                  (long long)outside, ldexp(weights, 30));
    assert_true(longest >= 8);
    assert_true(outside >= -6);
    assert_true(weights <= ldexp(16, -30));
}

/* Two triangles on either side of an edge agree about every point where the planes cut it. */
TEST(shared_edges)
{
    uint64_t seed = 44;
    int cuts = 0;
    for (int n = 0; n < random_cases(300000); n++) {
        qtri_clip_vertex corner[4];
        for (int i = 0; i < 4; i++) {
            corner[i] = random_clip_vertex(&seed, 58);
        }
        qtri_clip_vertex v[2][QTRI_CLIP_MAX] = {{corner[0], corner[1], corner[2]},
                                                {corner[1], corner[0], corner[3]}};
        int count[2];
        for (int i = 0; i < 2; i++) {
            with_weights(v[i]);
            count[i] = qtri_clip_polygon(v[i], 3, union_of(v[i]));
        }
        /* Points on the shared edge: the third corner's weight is 0. */
        int on_edge[2] = {0, 0};
        for (int side = 0; side < 2; side++) {
            const qtri_clip_vertex *mine = v[side];
            const qtri_clip_vertex *other = v[1 - side];
            for (int i = 0; i < count[side] && count[1 - side] > 0; i++) {
                /* At the apex of the view cone weights cannot tell who lies on the edge. */
                bool found = mine[i].b2_q30 != 0 || mine[i].w < 4096;
                on_edge[side] += !found;
                for (int k = 0; k < count[1 - side] && !found; k++) {
                    found = mine[i].x == other[k].x && mine[i].y == other[k].y &&
                            mine[i].z == other[k].z && mine[i].w == other[k].w;
                }
                if (!found) {
                    fail_msg("case %d: a point of the shared edge is missing on the other side", n);
                }
            }
        }
        cuts += on_edge[0] == 2 && on_edge[1] == 2;
    }
    print_message("%d shared edges\n", cuts);
    assert_true(cuts > 10000);
}

TEST(around_the_eye)
{
    qtri_transform t;
    qtri_transform_identity(&t);
    qtri_transform_perspective(&t, Q16(60), Q16(1), Q16(0.1), Q16(100));
    qtri_projector projector = projector_for(&t, 256, 256);
    /* A floor that the eye stands on, and a triangle through the eye itself. */
    qtri_vec3 triangle[2][3] = {
        {vec3_of(-1000, -1, 1000), vec3_of(1000, -1, 1000), vec3_of(0, -1, -1000)},
        {vec3_of(-10, 0, 10), vec3_of(10, 0, 10), vec3_of(0, 0, -10)}};
    for (int n = 0; n < 2; n++) {
        qtri_clip_vertex v[QTRI_CLIP_MAX];
        for (int i = 0; i < 3; i++) {
            qtri_projector_point(&projector, &triangle[n][i], &v[i]);
        }
        int count = qtri_clip_polygon(v, 3, union_of(v));
        assert_true(count >= 3);
        for (int i = 0; i < count; i++) {
            qtri_screen_vertex screen;
            qtri_project(&projector, &v[i], &screen);
            if (n == 0) {
                assert_true(screen.y_24p8 > 128 * 256); /* below the horizon */
            } else {
                assert_int_equal(screen.y_24p8, 128 * 256);
            }
        }
    }
}

TEST(clipped_lines)
{
    uint64_t seed = 45;
    for (int n = 0; n < random_cases(200000); n++) {
        qtri_clip_vertex v[2] = {random_clip_vertex(&seed, 58), random_clip_vertex(&seed, 58)};
        v[0].b1_q30 = v[0].b2_q30 = v[1].b2_q30 = 0;
        v[1].b1_q30 = 1 << 30;
        qtri_clip_vertex back[2] = {v[1], v[0]};
        unsigned planes = qtri_clip_outcode(&v[0]) | qtri_clip_outcode(&v[1]);
        bool kept = qtri_clip_line(v, planes) != 0;
        assert_int_equal(qtri_clip_line(back, planes) != 0, kept);
        for (int i = 0; i < 2 && kept; i++) {
            assert_memory_equal(&v[i], &back[1 - i], sizeof v[0]);
            for (int plane = 0; plane < 6; plane++) {
                assert_true(distance(&v[i], plane) >= -6);
            }
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
