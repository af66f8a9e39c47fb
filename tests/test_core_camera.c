/* SPDX-License-Identifier: MIT */
/*
 * Cameras and projections against double matrices built from the course's formulae.
 */
#include "support/transform.h"

static matrix looking(qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up)
{
    double e[3];
    double f[3];
    double u[3];
    double axis[3][3];
    doubles(e, eye);
    doubles(f, center);
    for (int i = 0; i < 3; i++) {
        f[i] -= e[i];
    }
    if (normalize(f) == 0) {
        f[2] = -1;
    }
    double candidate[3][3] = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    doubles(candidate[0], up);
    for (int i = 0; i < 3; i++) {
        normalize(candidate[i]);
        cross(axis[0], f, candidate[i]);
        if (normalize(axis[0]) > 1e-12) {
            break;
        }
    }
    cross(u, axis[0], f);
    matrix a = identity();
    for (int j = 0; j < 3; j++) {
        axis[1][j] = u[j];
        axis[2][j] = -f[j];
    }
    for (int i = 0; i < 3; i++) {
        a.m[i][3] = 0;
        for (int j = 0; j < 3; j++) {
            a.m[i][j] = axis[i][j];
            a.m[i][3] -= axis[i][j] * e[j];
        }
    }
    return a;
}

TEST(look_at)
{
    double worst = 0;
    uint64_t seed = 24;
    for (int n = 0; n < 5000; n++) {
        qtri_vec3 eye = random_vec3(&seed, random_in(&seed, 10, 30));
        qtri_vec3 center = random_vec3(&seed, random_in(&seed, 10, 30));
        qtri_vec3 up = random_vec3(&seed, random_in(&seed, 8, 30));
        if (n % 4 == 0) {
            up.x = up.z = 0;
        }
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_look_at(&t, eye, center, up);
        matrix exact = looking(eye, center, up);
        matrix scale = exact;
        for (int i = 0; i < 3; i++) {
            scale.m[i][3] = fabs(real(eye.x)) + fabs(real(eye.y)) + fabs(real(eye.z));
        }
        worst = fmax(worst, error_of(&t, &exact, &scale));
    }
    print_message("look_at: %.2f 2^-30\n", worst);
    assert_true(worst <= 4);
}

TEST(look_at_special)
{
    static const double cases[][9] = {
        {0, 0, 3, 0, 0, 0, 0, 1, 0},         {1, 2, 3, 1, 2, 3, 0, 1, 0},  /* eye = center */
        {0, 5, 0, 0, 0, 0, 0, 1, 0},         {0, -5, 0, 0, 0, 0, 0, 1, 0}, /* up parallel */
        {0, 0, 0, 3, 0, 0, -7, 0, 0},        {0, 0, 0, 3, 0, 4, 0, 0, 0},  /* up zero */
        {0, 0, 0, 1, 2, 3, 100, 200, 300},   {0, 0, 0, 0, 7, 0, 0, 0, 0},  /* both fall back */
        {0, 0, 5, 0, 0, 9, 0, 0, -1},        {4, 4, 4, 4, 4, 4, 0, 0, 0},
        {0, 0, 0, 1.5, 2.5, -3.5, -3, -5, 7}};
    for (size_t n = 0; n < LENGTH_OF(cases); n++) {
        const double *c = cases[n];
        qtri_vec3 v[3] = {vec3_of(c[0], c[1], c[2]), vec3_of(c[3], c[4], c[5]),
                          vec3_of(c[6], c[7], c[8])};
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_look_at(&t, v[0], v[1], v[2]);
        matrix exact = looking(v[0], v[1], v[2]);
        double error = error_of(&t, &exact, &exact);
        if (error > 4) {
            fail_msg("look_at case %d: %g", (int)n, error);
        }
    }
    uint64_t seed = 32;
    for (int n = 0; n < 2000; n++) { /* up along the view: as if it were zero */
        qtri_vec3 d = random_vec3(&seed, 20);
        int32_t k = random_in(&seed, 1, 700) * (random_flag(&seed) ? 1 : -1);
        qtri_vec3 up = {d.x * k, d.y * k, d.z * k};
        qtri_vec3 zero = {0, 0, 0};
        qtri_transform t[2];
        qtri_transform_identity(&t[0]);
        qtri_transform_identity(&t[1]);
        qtri_transform_look_at(&t[0], zero, d, up);
        qtri_transform_look_at(&t[1], zero, d, zero);
        assert_memory_equal(&t[0], &t[1], sizeof t[0]);
    }
}

/* A camera far from the origin, an object near the camera: translations must cancel. */
TEST(translations_cancel)
{
    double worst = 0;
    uint64_t seed = 25;
    for (int n = 0; n < 2000; n++) {
        qtri_vec3 eye = random_vec3(&seed, 30);
        qtri_vec3 offset = random_vec3(&seed, random_in(&seed, 14, 19));
        qtri_vec3 position = qtri_vec3_add(eye, offset);
        qtri_vec3 up = {0, Q16_ONE, 0};
        qtri_vec3 origin = {0, 0, 0};
        qtri_transform camera;
        qtri_transform pose;
        qtri_transform_identity(&camera);
        qtri_transform_identity(&pose);
        qtri_transform_look_at(&camera, eye, n % 2 ? origin : position, up);
        qtri_transform_translate(&pose, position);
        qtri_transform_mul(&pose, &camera, &pose);
        long double at[4];
        matrix exact = looking(eye, n % 2 ? origin : position, up);
        double o[3];
        doubles(o, offset);
        double size = sqrt(o[0] * o[0] + o[1] * o[1] + o[2] * o[2]);
        apply(at, &pose, origin);
        for (int i = 0; i < 3; i++) {
            double sum = exact.m[i][0] * o[0] + exact.m[i][1] * o[1] + exact.m[i][2] * o[2];
            worst = fmax(worst, fabs((double)at[i] - sum) / size);
        }
        apply(at, &camera, eye);
        for (int i = 0; i < 3; i++) {
            assert_true(fabsl(at[i]) <= ldexpl(1, -40));
        }
    }
    print_message("object near a far camera: %.2f 2^-30 of its distance\n", ldexp(worst, 30));
    assert_true(worst <= ldexp(3, -30));
}

static matrix projecting(double l, double r, double b, double t, double n, double f, bool ortho)
{
    matrix p = {{{0}}};
    if (ortho) {
        p.m[0][0] = 2 / (r - l);
        p.m[1][1] = 2 / (t - b);
        p.m[2][2] = -2 / (f - n);
        p.m[0][3] = -(r + l) / (r - l);
        p.m[1][3] = -(t + b) / (t - b);
        p.m[2][3] = -(f + n) / (f - n);
        p.m[3][3] = 1;
    } else {
        p.m[0][0] = 2 * n / (r - l);
        p.m[1][1] = 2 * n / (t - b);
        p.m[0][2] = (r + l) / (r - l);
        p.m[1][2] = (t + b) / (t - b);
        p.m[2][2] = (f + n) / (n - f);
        p.m[2][3] = 2 * f * n / (n - f);
        p.m[3][2] = -1;
    }
    return p;
}

TEST(boxes)
{
    double worst = 0;
    uint64_t seed = 26;
    for (int n = 0; n < 5000; n++) {
        q16 v[6];
        for (int i = 0; i < 6; i++) {
            v[i] = random_in(&seed, -(1 << 30), 1 << 30) >> random_in(&seed, 0, 20);
        }
        if (v[0] == v[1] || v[2] == v[3] || v[4] == v[5]) {
            continue;
        }
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_frustum(&t, v[0], v[1], v[2], v[3], v[4], v[5]);
        matrix exact = projecting(real(v[0]), real(v[1]), real(v[2]), real(v[3]), real(v[4]),
                                  real(v[5]), false);
        worst = fmax(worst, error_of(&t, &exact, &exact));
        qtri_transform_identity(&t);
        qtri_transform_ortho(&t, v[0], v[1], v[2], v[3], v[4], v[5]);
        exact = projecting(real(v[0]), real(v[1]), real(v[2]), real(v[3]), real(v[4]), real(v[5]),
                           true);
        worst = fmax(worst, error_of(&t, &exact, &exact));
    }
    print_message("frustum, ortho: %.2f 2^-30\n", worst);
    assert_true(worst <= 1.01);
}

TEST(perspectives)
{
    double worst = 0;        /* fields of view of 20 to 160 degrees */
    double worst_narrow = 0; /* times the half angle's tangent or cotangent */
    uint64_t seed = 27;
    for (int n = 0; n < 5000; n++) {
        bool narrow = n % 2 != 0;
        q16 fovy = narrow ? random_in(&seed, 65536, 179 * 65536)
                          : random_in(&seed, 20 * 65536, 160 * 65536);
        q16 aspect = random_in(&seed, 16384, 4 * 65536);
        q16 near_z = random_in(&seed, 655, 655360);
        q16 far_z = near_z + random_in(&seed, 65536, 1 << 30);
        double g = 1 / tan(real(fovy) / 2 * radians);
        matrix exact = projecting(-real(aspect), real(aspect), -1, 1, 1, 2, false);
        exact.m[0][0] = g / real(aspect);
        exact.m[1][1] = g;
        exact.m[2][2] = ((double)far_z + near_z) / ((double)near_z - far_z);
        exact.m[2][3] = 2 * real(far_z) * real(near_z) / (real(near_z) - real(far_z));
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_perspective(&t, fovy, aspect, near_z, far_z);
        double error = error_of(&t, &exact, &exact);
        qtri_transform d3d;
        qtri_transform_identity(&d3d);
        qtri_transform_perspective_d3d(&d3d, fovy, aspect, near_z, far_z);
        exact.m[2][2] = -exact.m[2][2];
        exact.m[3][2] = 1;
        error = fmax(error, error_of(&d3d, &exact, &exact));
        if (narrow) {
            worst_narrow = fmax(worst_narrow, error * fmin(g, 1 / g));
        } else {
            worst = fmax(worst, error);
        }
    }
    print_message("perspective: %.2f 2^-30; narrow or wide: %.2f max(g, 1/g) 2^-30\n", worst,
                  worst_narrow);
    assert_true(worst <= 6);
    assert_true(worst_narrow <= 3);
}

static matrix perspective_matrix(double fovy, double aspect, double near_z, double far_z, bool d3d)
{
    const double g = 1 / tan(fovy / 2 * radians);
    matrix p = projecting(-aspect, aspect, -1, 1, near_z, far_z, false);
    p.m[0][0] = g / aspect;
    p.m[1][1] = g;
    if (d3d) {
        p.m[2][2] = -p.m[2][2];
        p.m[3][2] = 1;
    }
    return p;
}

static qtri_transform perspective_of(q16 fovy, q16 aspect, q16 near_z, q16 far_z, bool d3d)
{
    qtri_transform t;
    qtri_transform_identity(&t);
    if (d3d) {
        qtri_transform_perspective_d3d(&t, fovy, aspect, near_z, far_z);
    } else {
        qtri_transform_perspective(&t, fovy, aspect, near_z, far_z);
    }
    return t;
}

/* Fields of view down to 1/65536 degree, and as near to 180: the half angle's sine alone would keep
   13 digits of it. The tangent of what lacks to 180 is what double precision still has. */
TEST(narrowest_and_widest)
{
    double worst[2] = {0, 0};
    for (q16 rest = 1; rest < Q16(30); rest += rest < 700 ? 1 : 4001) {
        for (int i = 0; i < 4; i++) {
            const bool wide = i >= 2;
            const qtri_transform t =
                perspective_of(wide ? Q16(180) - rest : rest, Q16(1.5), Q16(.5), Q16(20), i % 2);
            const double half = tan(real(rest) / 2 * radians);
            const double g = wide ? half : 1 / half;
            worst[wide] = fmax(worst[wide], fabs(element(&t, 1, 1) / g - 1));
            worst[wide] = fmax(worst[wide], fabs(element(&t, 0, 0) / g * 1.5 - 1));
        }
    }
    print_message("narrow: 2^%.2f of itself, wide: 2^%.2f\n", log2(worst[0]), log2(worst[1]));
    assert_true(worst[0] <= ldexp(1, -27) && worst[1] <= ldexp(1, -27));
}

/* Negative angles and ratios, near beyond far: the formulae hold on, as the header says. */
TEST(outside_of_ranges)
{
    uint64_t seed = 31;
    for (int n = 0; n < 2000; n++) {
        const bool d3d = n % 2 != 0;
        const q16 fovy = random_in(&seed, 40, Q16(140)) * (n & 2 ? -1 : 1);
        const q16 aspect = random_in(&seed, 16384, Q16(4)) * (n & 4 ? -1 : 1);
        const q16 low = random_in(&seed, 655, Q16(10));
        const q16 high = low + random_in(&seed, 655, Q16(1000));
        const q16 near_z = n & 8 ? high : low;
        const q16 far_z = n & 8 ? low : high;
        const qtri_transform t = perspective_of(fovy, aspect, near_z, far_z, d3d);
        const matrix exact =
            perspective_matrix(real(fovy), real(aspect), real(near_z), real(far_z), d3d);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                const double e = exact.m[i][j];
                const double most = fmax(fabs(e), i == 2 ? fabs(exact.m[2][2]) : 0);
                assert_true(fabs(element(&t, i, j) - e) <= ldexp(most, -26));
            }
        }
        /* A negative angle is half a turn of the picture. */
        const qtri_transform turned = perspective_of(-fovy, aspect, near_z, far_z, d3d);
        assert_true(element(&turned, 0, 0) == -element(&t, 0, 0));
        assert_true(element(&turned, 1, 1) == -element(&t, 1, 1));
        assert_memory_equal(&turned.row[2], &t.row[2], 2 * sizeof t.row[2]);
    }
}

/* Where the two ways to a cotangent meet, they differ in the last bits: 16 degrees take the one of
   wide angles, and what is next below does not. */
TEST(where_ways_meet)
{
    const qtri_transform at = perspective_of(Q16(16), Q16(1), Q16(1), Q16(10), false);
    const qtri_transform back = perspective_of(-Q16(16), Q16(1), Q16(1), Q16(10), false);
    const qtri_transform other = perspective_of(Q16(164), Q16(1), Q16(1), Q16(10), false);
    assert_int_equal(at.row[1].m[1], 955008756);
    assert_int_equal(at.row[1].exponent, 27);
    assert_int_equal(back.row[1].m[1], -955008756);
    assert_int_equal(other.row[1].m[1], 603618290);
    assert_int_equal(other.row[1].exponent, 32);
}

/* A view's camera and projection are set anew, whatever they were, in the viewport's aspect. */
TEST(views_are_set_anew)
{
    static const int32_t sizes[4][2] = {{320, 240}, {128, 64}, {9, 9}, {40, 0}};
    const qtri_vec3 eye = {Q16(3), Q16(2), Q16(-5)};
    const qtri_vec3 up = {0, Q16(1), 0};
    qtri_transform camera;
    qtri_transform_identity(&camera);
    qtri_transform_look_at(&camera, eye, vec3_of(0, 1, 0), up);
    for (int i = 0; i < 4; i++) {
        qtri_view view;
        const q16 aspect = i == 3 ? Q16(1) : q16_from_ratio(sizes[i][0], sizes[i][1]);
        const qtri_transform projection = perspective_of(Q16(50), aspect, Q16(.5), Q16(90), false);
        qtri_view_init(&view, sizes[i][0], sizes[i][1]);
        for (int turn = 0; turn < 2; turn++) {
            qtri_view_look_at(&view, eye, vec3_of(0, 1, 0), up);
            qtri_view_perspective(&view, Q16(50), Q16(.5), Q16(90));
            assert_memory_equal(&view.camera, &camera, sizeof camera);
            assert_memory_equal(&view.projection, &projection, sizeof projection);
        }
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
