/* SPDX-License-Identifier: MIT */
/*
 * Motion: orbits, billboards, orthonormalising, keys, hierarchies and morphing, against double
 * precision.
 */
#include "support/transform.h"

#include <qtri/animation.h>

static matrix matrix_of(const qtri_transform *t)
{
    matrix m;
    for (int i = 0; i < 16; i++) {
        m.m[i / 4][i % 4] = element(t, i / 4, i % 4);
    }
    return m;
}

static const double x_axis[3] = {1, 0, 0};
static const double y_axis[3] = {0, 1, 0};

TEST(orbits)
{
    uint64_t seed = 41;
    double worst = 0;
    for (int n = 0; n < 3000; n++) {
        const qtri_vec3 center = random_vec3(&seed, random_in(&seed, 0, 24));
        const qtri_vec3 minus = {-center.x, -center.y, -center.z};
        const q16 distance = random_in(&seed, 0, 1 << 24);
        const qtri_vec3 back = {0, 0, -distance};
        const q16 azimuth = random_angle(&seed);
        const q16 elevation = random_angle(&seed);
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_orbit(&t, center, distance, azimuth, elevation);
        const matrix part[4] = {translation(back), rotation(real(elevation), x_axis),
                                rotation(-real(azimuth), y_axis), translation(minus)};
        matrix exact = part[0];
        for (int i = 1; i < 4; i++) {
            exact = multiply(&exact, &part[i]);
        }
        matrix scale = absolute(&exact);
        for (int i = 0; i < 3; i++) {
            scale.m[i][3] = fmax(fabs(real(center.x)) + fabs(real(center.y)) +
                                     fabs(real(center.z)) + real(distance),
                                 1);
        }
        worst = fmax(worst, error_of(&t, &exact, &scale));
    }
    print_message("orbit: %.1f 2^-30\n", worst);
    assert_true(worst <= 8);
    /* The eye is where it is said to be: above, in front of and to the right of the centre. */
    qtri_transform t;
    qtri_transform_identity(&t);
    qtri_transform_orbit(&t, vec3_of(1, 2, 3), Q16(5), Q16(90), 0);
    long double eye[4];
    apply(eye, &t, vec3_of(6, 2, 3));
    for (int i = 0; i < 3; i++) {
        assert_near((double)eye[i], 0, 1e-7);
    }
    qtri_transform_identity(&t);
    qtri_transform_orbit(&t, vec3_of(1, 2, 3), Q16(5), 0, Q16(90));
    apply(eye, &t, vec3_of(1, 7, 3));
    for (int i = 0; i < 3; i++) {
        assert_near((double)eye[i], 0, 1e-7);
    }
}

/* camera * billboard has no turn left; the upright one keeps y, and its z points at the eye. */
TEST(billboards)
{
    uint64_t seed = 42;
    for (int n = 0; n < 2000; n++) {
        qtri_transform camera;
        qtri_transform t;
        qtri_transform product;
        const double s = n % 3 == 0 ? 2.5 : 1;
        const qtri_vec3 even = {fixed(s), fixed(s), fixed(s)};
        qtri_transform_identity(&camera);
        qtri_transform_look_at(&camera, random_vec3(&seed, 20), random_vec3(&seed, 20),
                               random_vec3(&seed, 20));
        qtri_transform_scale(&camera, even);
        qtri_transform_identity(&t);
        qtri_transform_billboard(&t, &camera);
        qtri_transform_mul(&product, &camera, &t);
        for (int i = 0; i < 9; i++) {
            assert_near(element(&product, i / 3, i % 3), i / 3 == i % 3 ? s : 0, 2e-8);
        }
        qtri_transform_identity(&t);
        qtri_transform_billboard_upright(&t, &camera);
        for (int i = 0; i < 3; i++) {
            assert_near(element(&t, i, 1), i == 1, 1e-9);
        }
        const double level = hypot(element(&camera, 2, 0), element(&camera, 2, 2));
        if (level > 1e-3) {
            assert_near(element(&t, 0, 2), element(&camera, 2, 0) / level, 1e-6);
            assert_near(element(&t, 2, 2), element(&camera, 2, 2) / level, 1e-6);
            assert_near(element(&t, 0, 0) * element(&t, 0, 2) +
                            element(&t, 2, 0) * element(&t, 2, 2),
                        0, 1e-8);
        }
    }
    qtri_transform none = {0};
    qtri_transform t;
    qtri_transform_identity(&t);
    qtri_transform_billboard(&t, &none);
    qtri_transform_billboard_upright(&t, &none);
    assert_near(element(&t, 0, 0), 1, 0);
}

/* How far rows are from lengths of 1 and right angles. */
static double skew(const qtri_transform *t)
{
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += element(t, i, k) * element(t, j, k);
            }
            worst = fmax(worst, fabs(sum - (i == j)));
        }
    }
    return worst;
}

static double determinant(const qtri_transform *t)
{
    double row[3][3];
    double c[3];
    for (int i = 0; i < 9; i++) {
        row[i / 3][i % 3] = element(t, i / 3, i % 3);
    }
    cross(c, row[0], row[1]);
    return c[0] * row[2][0] + c[1] * row[2][1] + c[2] * row[2][2];
}

TEST(ten_thousand_products)
{
    uint64_t seed = 43;
    for (int n = 0; n < 6; n++) {
        qtri_transform t;
        qtri_transform_identity(&t);
        if (n % 2) {
            qtri_transform_scale(&t, vec3_of(1, -1, 1));
        }
        qtri_transform_translate(&t, vec3_of(3, 4, 5));
        const qtri_vec3 axis = random_vec3(&seed, 16);
        matrix exact = matrix_of(&t);
        const double a[3] = {real(axis.x), real(axis.y), real(axis.z)};
        const q16 degrees = random_in(&seed, 1, 100000);
        const matrix step = rotation(real(degrees), a);
        for (int i = 0; i < 10000; i++) {
            qtri_transform_rotate(&t, degrees, axis);
            exact = multiply(&exact, &step);
        }
        const double before = skew(&t);
        const double place = element(&t, 1, 3);
        qtri_transform_orthonormalize(&t);
        check_form(&t);
        print_message("skew %.2g, then %.2g\n", before, skew(&t));
        assert_true(before < ldexp(1, -15));
        assert_true(skew(&t) <= ldexp(1, -29) * 1.5);
        assert_near(determinant(&t), n % 2 ? -1 : 1, 1e-8);
        assert_near(element(&t, 1, 3), place, 1e-7);
        for (int i = 0; i < 9; i++) {
            assert_near(element(&t, i / 3, i % 3), exact.m[i / 3][i % 3], 3e-5);
        }
    }
}

TEST(orthonormal_edges)
{
    uint64_t seed = 44;
    for (int n = 0; n < 2000; n++) { /* far from a rotation: it becomes one, or stays */
        qtri_mat4 m;
        for (int i = 0; i < 16; i++) {
            m.m[i / 4][i % 4] = n % 5 ? random_any(&seed) : random_in(&seed, -1, 1);
        }
        qtri_transform t;
        qtri_transform before;
        qtri_transform_from_mat4(&t, &m);
        before = t;
        qtri_transform_orthonormalize(&t);
        check_form(&t);
        if (memcmp(&before, &t, sizeof t) != 0) {
            assert_true(skew(&t) <= ldexp(1, -27)); /* twice 2^-28, of a square */
        } else {                                    /* there was no direction for one of the axes */
            double size = 1;
            for (int i = 0; i < 3; i++) {
                size *= fabs(element(&t, i, 0)) + fabs(element(&t, i, 1)) + fabs(element(&t, i, 2));
            }
            assert_true(skew(&t) <= ldexp(1, -27) || fabs(determinant(&t)) <= 1e-9 * size);
        }
        assert_memory_equal(&before.row[3], &t.row[3], sizeof t.row[3]);
    }
}

TEST(keys)
{
    uint64_t seed = 45;
    enum { COUNT = 6 };
    for (int n = 0; n < 3000; n++) {
        qtri_key key[COUNT];
        q16 time = random_any(&seed) / 4;
        for (int i = 0; i < COUNT; i++) {
            const qtri_key k = {
                time, random_vec3(&seed, 24),
                qtri_quat_from_axis_deg(random_vec3(&seed, 16), random_angle(&seed)),
                random_vec3(&seed, 18)};
            key[i] = k;
            time += random_in(&seed, 1, n % 2 ? 100 : 1 << 26);
        }
        const int i = random_in(&seed, 0, COUNT - 2);
        const q16 at = random_in(&seed, key[i].time, key[i + 1].time - 1);
        const qtri_key is = qtri_keys_at(key, COUNT, at);
        const double t = (double)(at - key[i].time) / (double)(key[i + 1].time - key[i].time);
        assert_near(real(is.position.x),
                    real(key[i].position.x) +
                        t * (real(key[i + 1].position.x) - real(key[i].position.x)),
                    (.5 + ldexp(1, -7)) / 65536);
        const qtri_quat q = qtri_quat_slerp(key[i].orientation, key[i + 1].orientation, fixed(t));
        assert_true(abs(q.w - is.orientation.w) <= 3 && abs(q.x - is.orientation.x) <= 3);
        const qtri_key first = qtri_keys_at(key, COUNT, key[0].time - 5);
        const qtri_key last = qtri_keys_at(key, COUNT, key[COUNT - 1].time);
        assert_int_equal(first.position.y, key[0].position.y);
        assert_int_equal(last.scale.z, key[COUNT - 1].scale.z);
        qtri_transform a;
        qtri_transform b;
        qtri_transform_identity(&a);
        qtri_transform_identity(&b);
        qtri_transform_key(&a, &is);
        qtri_transform_translate(&b, is.position);
        qtri_transform_rotate_quat(&b, is.orientation);
        qtri_transform_scale(&b, is.scale);
        assert_memory_equal(&a, &b, sizeof a);
    }
    const qtri_key none = qtri_keys_at(NULL, 0, 7);
    assert_int_equal(none.scale.x, Q16_ONE);
    const qtri_key extreme[2] = {{INT32_MIN, {INT32_MIN, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}},
                                 {INT32_MAX, {INT32_MAX, 0, 0}, {0, 0, 0, 0}, {0, 0, 0}}};
    assert_true(abs(qtri_keys_at(extreme, 2, 0).position.x) <= 32768);
}

/* What a coordinate of `keys` at `time` is off, in ULP, beyond what animation.h promises. */
static double off_promise(q16 is, q16 from, q16 to, double t)
{
    const double whole = (double)to - from;
    return fabs(is - (from + t * whole)) - (.5 + ldexp(fabs(whole), -32));
}

/* Positions and scales of any reach against double precision; 61 units in 100 seconds among them.
 */
TEST(straight_lines)
{
    uint64_t seed = 48;
    double worst = -1;
    double worst_61 = 0;
    for (int n = 0; n < random_cases(20000); n++) {
        qtri_key key[2] = {{0, {0, 0, 0}, {Q16_ONE, 0, 0, 0}, {0, 0, 0}}};
        key[1] = key[0];
        if (n % 4 == 0) {
            key[1].position.x = Q16(61);
            key[1].time = Q16(100);
        } else {
            for (int i = 0; i < 2; i++) {
                key[i].time = n % 4 == 1 ? random_any(&seed) : random_in(&seed, 0, 1 << 24);
                key[i].position = random_vec3(&seed, random_in(&seed, 1, 30));
                key[i].scale.z = random_any(&seed);
            }
        }
        if (n == 1) { /* as far as it goes */
            key[0].time = key[0].position.x = key[0].scale.z = INT32_MIN;
            key[1].time = key[1].position.x = key[1].scale.z = INT32_MAX;
        }
        if (key[0].time >= key[1].time) {
            continue;
        }
        const uint64_t span = (uint64_t)((int64_t)key[1].time - key[0].time);
        const int64_t after = n == 1 ? (int64_t)span - 1 : (int64_t)(random64(&seed) % span);
        const qtri_key is = qtri_keys_at(key, 2, (q16)(key[0].time + after));
        const double t = (double)after / (double)span;
        worst = fmax(worst, off_promise(is.position.x, key[0].position.x, key[1].position.x, t));
        worst = fmax(worst, off_promise(is.position.y, key[0].position.y, key[1].position.y, t));
        worst = fmax(worst, off_promise(is.scale.z, key[0].scale.z, key[1].scale.z, t));
        if (n % 4 == 0) {
            worst_61 = fmax(worst_61, fabs(is.position.x - t * Q16(61)));
        }
    }
    print_message("keys: %.3g ULP beyond the promise, %.4f over 61 units\n", worst, worst_61);
    assert_true(worst <= 1e-6); /* double precision's own */
    assert_true(worst_61 <= .501);
}

TEST(hierarchies)
{
    uint64_t seed = 46;
    enum { COUNT = 12 };
    for (int n = 0; n < 300; n++) {
        qtri_transform local[COUNT];
        qtri_transform world[COUNT];
        int16_t parent[COUNT];
        for (int i = 0; i < COUNT; i++) {
            qtri_transform_identity(&local[i]);
            qtri_transform_translate(&local[i], random_vec3(&seed, 18));
            qtri_transform_rotate_y(&local[i], random_angle(&seed));
            parent[i] = (int16_t)random_in(&seed, -3, COUNT + 2);
        }
        qtri_poses_compose(world, local, parent, COUNT);
        for (int i = 0; i < COUNT; i++) {
            qtri_transform expected = local[i];
            for (int p = parent[i], child = i; p >= 0 && p < child; child = p, p = parent[p]) {
                qtri_transform_mul(&expected, &local[p], &expected);
            }
            for (int k = 0; k < 12; k++) {
                assert_near(element(&world[i], k / 4, k % 4), element(&expected, k / 4, k % 4),
                            1e-6);
            }
        }
        qtri_poses_compose(local, local, parent, COUNT);
        assert_memory_equal(local, world, sizeof local);
    }
}

TEST(morphs)
{
    uint64_t seed = 47;
    enum { COUNT = 5, FRAMES = 4 };
    for (int n = 0; n < 5000; n++) {
        qtri_position16 set[FRAMES][COUNT];
        qtri_position16 out[COUNT];
        for (int i = 0; i < FRAMES * COUNT; i++) {
            const qtri_position16 p = {(int16_t)random_in(&seed, INT16_MIN, INT16_MAX),
                                       (int16_t)random_in(&seed, INT16_MIN, INT16_MAX),
                                       (int16_t)(random_flag(&seed) ? INT16_MIN : INT16_MAX)};
            set[i / COUNT][i % COUNT] = p;
        }
        const q16 t = n % 4 ? random_in(&seed, 0, Q16_ONE) : random_any(&seed);
        const double held = fmax(0, fmin(1, real(t)));
        qtri_morph_positions(out, set[0], set[1], COUNT, t);
        for (int i = 0; i < COUNT; i++) {
            const double wanted = set[0][i].z + held * (set[1][i].z - set[0][i].z);
            assert_near(out[i].z, wanted, .5001);
        }
        const q16 at = random_any(&seed);
        qtri_frames_positions(out, set[0], FRAMES, COUNT, at);
        double place = fmod(real(at), FRAMES);
        place += place < 0 ? FRAMES : 0;
        const int from = (int)floor(place) % FRAMES;
        for (int i = 0; i < COUNT; i++) {
            const int a = set[from][i].x;
            const int b = set[(from + 1) % FRAMES][i].x;
            assert_near(out[i].x, a + (place - floor(place)) * (b - a), .5001);
        }
        const qtri_position16 *const target[3] = {set[1], set[2], set[3]};
        const q16 weight[3] = {random_any(&seed), random_in(&seed, -Q16_ONE, Q16_ONE),
                               random_in(&seed, 0, Q16_ONE)};
        qtri_morph_targets(out, set[0], target, weight, 3, COUNT);
        for (int i = 0; i < COUNT; i++) {
            double wanted = set[0][i].y;
            for (int k = 0; k < 3; k++) {
                wanted += real(weight[k]) * (target[k][i].y - set[0][i].y);
            }
            assert_near(out[i].y, fmax(-32767, fmin(32767, wanted)), .5001);
        }
        qtri_normal8 a[1] = {{(int8_t)random_in(&seed, -128, 127),
                              (int8_t)random_in(&seed, -128, 127),
                              (int8_t)random_in(&seed, -128, 127)}};
        qtri_normal8 b[1] = {{(int8_t)random_in(&seed, -128, 127),
                              (int8_t)random_in(&seed, -128, 127),
                              (int8_t)random_in(&seed, -128, 127)}};
        qtri_normal8 normal[1];
        qtri_morph_normals(normal, a, b, 1, t);
        double m[3] = {a->x + held * (b->x - a->x), a->y + held * (b->y - a->y),
                       a->z + held * (b->z - a->z)};
        if (normalize(m) > 0) {
            assert_near(normal->x, 127 * m[0], .501);
            assert_near(normal->y, 127 * m[1], .501);
            assert_near(normal->z, 127 * m[2], .501);
        }
    }
    const qtri_normal8 up = {0, 127, 0};
    const qtri_normal8 down = {0, -127, 0};
    qtri_normal8 out;
    qtri_morph_normals(&out, &up, &down, 1, Q16(.5));
    assert_int_equal(out.y, 127);
    qtri_frames_positions(NULL, NULL, 0, 5, 0);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
