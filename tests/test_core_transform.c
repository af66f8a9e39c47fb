/* SPDX-License-Identifier: MIT */
/*
 * Poses: builders, products and round trips against double matrices.
 */
#include "support/transform.h"

TEST(simple_builders)
{
    double worst = 0;
    uint64_t seed = 21;
    for (int n = 0; n < 3000; n++) {
        qtri_transform t;
        qtri_vec3 v = random_vec3(&seed, random_in(&seed, 0, 30));
        q16 degrees = random_angle(&seed);
        static const double axis[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        void (*const rotate[3])(qtri_transform *, q16) = {
            qtri_transform_rotate_x, qtri_transform_rotate_y, qtri_transform_rotate_z};

        qtri_transform_identity(&t);
        qtri_transform_translate(&t, v);
        matrix exact = translation(v);
        assert_true(error_of(&t, &exact, &exact) == 0);
        qtri_transform_identity(&t);
        qtri_transform_scale(&t, v);
        exact = scaling(v);
        assert_true(error_of(&t, &exact, &exact) <= 1);
        for (int i = 0; i < 3; i++) {
            qtri_transform_identity(&t);
            rotate[i](&t, degrees);
            exact = rotation(real(degrees), axis[i]);
            worst = fmax(worst, error_of(&t, &exact, &exact));
        }
    }
    print_message("rotate x y z: %.2f 2^-30\n", worst);
    assert_true(worst <= 3);
}

TEST(axis_builders)
{
    double worst_axis = 0;
    double worst_about = 0;
    double worst_quat = 0;
    uint64_t seed = 22;
    for (int n = 0; n < 5000; n++) {
        qtri_transform t;
        qtri_vec3 axis = random_vec3(&seed, random_in(&seed, 0, 30));
        qtri_vec3 point = random_vec3(&seed, random_in(&seed, 0, 30));
        q16 degrees = random_angle(&seed);
        double a[3];
        double p[3];
        doubles(a, axis);
        doubles(p, point);

        qtri_transform_identity(&t);
        qtri_transform_rotate(&t, degrees, axis);
        matrix exact = rotation(real(degrees), a);
        worst_axis = fmax(worst_axis, error_of(&t, &exact, &exact));
        qtri_transform_identity(&t);
        qtri_transform_rotate_about(&t, degrees, axis, point);
        exact = rotation_about(real(degrees), a, p);
        matrix scale = exact; /* the translation's terms, before they cancel */
        for (int i = 0; i < 3; i++) {
            scale.m[i][3] = fabs(p[0]) + fabs(p[1]) + fabs(p[2]);
        }
        worst_about = fmax(worst_about, error_of(&t, &exact, &scale));

        qtri_quat q = {degrees, axis.x, axis.y, axis.z};
        double w = real(degrees);
        double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
        qtri_transform_identity(&t);
        qtri_transform_rotate_quat(&t, q);
        exact = rotation(length + fabs(w) == 0 ? 0 : 2 * atan2(length, w) / radians, a);
        worst_quat = fmax(worst_quat, error_of(&t, &exact, &exact));
    }
    print_message("rotate axis %.2f, about %.2f, quat %.2f 2^-30\n", worst_axis, worst_about,
                  worst_quat);
    assert_true(worst_axis <= 4);
    assert_true(worst_about <= 5);
    assert_true(worst_quat <= 2);
}

TEST(nothing_to_turn_about)
{
    qtri_vec3 zero = {0, 0, 0};
    qtri_vec3 point = vec3_of(1, 2, 3);
    qtri_vec3 line[3] = {vec3_of(1, 1, 1), vec3_of(2, 2, 2), vec3_of(-5, -5, -5)};
    qtri_quat none = {0, 0, 0, 0};
    qtri_transform t;
    qtri_transform same;
    qtri_transform_identity(&same);
    qtri_transform_identity(&t);
    qtri_transform_rotate(&t, Q16(33), zero);
    qtri_transform_rotate_about(&t, Q16(33), zero, point);
    qtri_transform_rotate_triangle(&t, Q16(33), line);
    qtri_transform_rotate_quat(&t, none);
    assert_memory_equal(&t, &same, sizeof t);
    /* Triangles without area, however large: edges a d and b d. */
    uint64_t seed = 23;
    int failures = 0;
    for (int n = 0; n < 20000; n++) {
        qtri_vec3 d = random_vec3(&seed, 16 + n % 5);
        qtri_vec3 origin = random_vec3(&seed, 29);
        int32_t a = random_in(&seed, -500, 500);
        int32_t b = random_in(&seed, -500, 500);
        qtri_vec3 v[3] = {origin,
                          {origin.x + a * d.x, origin.y + a * d.y, origin.z + a * d.z},
                          {origin.x + b * d.x, origin.y + b * d.y, origin.z + b * d.z}};
        qtri_transform_identity(&t);
        qtri_transform_rotate_triangle(&t, Q16(33), v);
        failures += memcmp(&t, &same, sizeof t) != 0;
    }
    assert_int_equal(failures, 0);
}

TEST(chains)
{
    double worst = 0;
    uint64_t seed = 28;
    for (int n = 0; n < 3000; n++) {
        qtri_transform t;
        matrix exact = identity();
        matrix scale = identity();
        int length = random_in(&seed, 2, 12);
        qtri_transform_identity(&t);
        for (int k = 0; k < length; k++) {
            matrix step = identity();
            qtri_vec3 v = random_vec3(&seed, 20);
            q16 degrees = random_angle(&seed);
            double a[3];
            doubles(a, v);
            switch (random_in(&seed, 0, 2)) {
            case 0:
                qtri_transform_translate(&t, v);
                step = translation(v);
                break;
            case 1:
                /* Even: a row keeps 30 bits of its largest element, not of each. */
                v.x = random_in(&seed, 16384, 4 * 65536);
                v.y = random_flag(&seed) ? v.x : -v.x;
                v.z = random_flag(&seed) ? v.x : -v.x;
                qtri_transform_scale(&t, v);
                step = scaling(v);
                break;
            default:
                qtri_transform_rotate(&t, degrees, v);
                step = rotation(real(degrees), a);
                break;
            }
            matrix size = absolute(&step);
            exact = multiply(&exact, &step);
            scale = multiply(&scale, &size);
        }
        worst = fmax(worst, error_of(&t, &exact, &scale) / length);
    }
    print_message("chains: %.2f 2^-30 a step\n", worst);
    assert_true(worst <= 3);
}

TEST(round_trips)
{
    uint64_t seed = 29;
    for (int n = 0; n < 20000; n++) {
        qtri_mat4 m;
        qtri_mat4 back;
        qtri_transform t;
        bool small = n % 2 != 0;
        for (int i = 0; i < 16; i++) {
            m.m[i / 4][i % 4] =
                small || i % 4 == 3 ? random_in(&seed, -(1 << 30), 1 << 30) : random_any(&seed);
        }
        if (n == 0) {
            for (int i = 0; i < 16; i++) {
                m.m[i / 4][i % 4] = i % 3 ? INT32_MIN : INT32_MAX;
            }
        }
        qtri_transform_from_mat4(&t, &m);
        check_form(&t);
        qtri_transform_to_mat4(&t, &back);
        for (int i = 0; i < 16; i++) {
            int64_t difference = (int64_t)back.m[i / 4][i % 4] - m.m[i / 4][i % 4];
            if (llabs(difference) > (small ? 0 : 2)) {
                fail_msg("element %d: %d comes back as %d", i, (int)m.m[i / 4][i % 4],
                         (int)back.m[i / 4][i % 4]);
            }
        }
    }
    qtri_transform t;
    qtri_mat4 m;
    qtri_vec3 large = vec3_of(30000, -30000, 30000);
    qtri_transform_identity(&t);
    qtri_transform_scale(&t, large);
    qtri_transform_scale(&t, large);
    qtri_transform_to_mat4(&t, &m);
    assert_int_equal(m.m[0][0], Q16_MAX);
    qtri_vec3 negative = vec3_of(-30000, 30000, 30000);
    qtri_transform_scale(&t, negative);
    qtri_transform_to_mat4(&t, &m);
    assert_int_equal(m.m[0][0], Q16_MIN);
}

/* COURSE scene 4, and any other triangle: plane and centroid stay, corners keep their distances. */
TEST(turned_triangle)
{
    double worst = 0;
    uint64_t seed = 30;
    for (int n = 0; n < 3000; n++) {
        qtri_vec3 v[3] = {vec3_of(0, 1, 0), vec3_of(-1, 0, 1), vec3_of(1, 0, 1)};
        q16 degrees = q16_from_int(45 * n);
        for (int i = 0; i < 3 && n > 8; i++) {
            v[i] = random_vec3(&seed, 18);
            degrees = random_angle(&seed);
        }
        double p[3][3];
        double centroid[3];
        double edge[2][3];
        double normal[3];
        for (int i = 0; i < 3; i++) {
            doubles(p[i], v[i]);
        }
        for (int k = 0; k < 3; k++) {
            centroid[k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
            edge[0][k] = p[1][k] - p[0][k];
            edge[1][k] = p[2][k] - p[0][k];
        }
        cross(normal, edge[0], edge[1]);
        normalize(normal);
        qtri_transform t;
        qtri_transform_identity(&t);
        qtri_transform_rotate_triangle(&t, degrees, v);
        matrix exact = rotation_about(real(degrees), normal, centroid);
        worst = fmax(worst, error_of(&t, &exact, &exact));
        long double sum[3] = {0, 0, 0};
        for (int i = 0; i < 3; i++) {
            long double q[4];
            long double off = 0;
            apply(q, &t, v[i]);
            for (int k = 0; k < 3; k++) {
                sum[k] += q[k] / 3;
                off += (q[k] - centroid[k]) * normal[k];
            }
            assert_true(fabsl(off) < 2e-8); /* its plane */
        }
        for (int k = 0; k < 3; k++) {
            assert_true(fabsl(sum[k] - centroid[k]) < 2e-8);
        }
    }
    print_message("turned triangle: %.2f 2^-30\n", worst);
    assert_true(worst <= 8);
}

/* Any bits in any argument: defined, and in the promised form. */
TEST(anything)
{
    uint64_t seed = 31;
    for (int n = 0; n < 20000; n++) {
        qtri_transform t;
        qtri_mat4 m;
        q16 a[9];
        for (int i = 0; i < 9; i++) {
            a[i] = random_in(&seed, 0, 9) == 0 ? INT32_MIN : random_any(&seed);
        }
        qtri_vec3 v[3] = {{a[0], a[1], a[2]}, {a[3], a[4], a[5]}, {a[6], a[7], a[8]}};
        qtri_quat q = {a[0], a[3], a[6], a[8]};
        for (size_t i = 0; i < sizeof t; i++) {
            ((uint8_t *)&t)[i] = (uint8_t)random64(&seed);
        }
        if (n % 2 != 0) {
            qtri_transform_identity(&t);
        } else if (n % 4 == 0) {
            t.row[n / 4 % 4].exponent = n % 8 ? INT32_MAX : INT32_MIN;
            t.row[n / 4 % 4].t = INT64_MIN;
        }
        qtri_transform_to_mat4(&t, &m);
        qtri_transform_look_at(&t, v[0], v[1], v[2]);
        check_form(&t);
        qtri_transform_perspective(&t, a[0], a[1], a[2], a[3]);
        qtri_transform_frustum(&t, a[0], a[1], a[2], a[3], a[4], a[5]);
        qtri_transform_ortho(&t, a[3], a[4], a[5], a[6], a[7], a[7]);
        qtri_transform_perspective_d3d(&t, 0, 0, a[2], a[2]);
        check_form(&t);
        qtri_transform_translate(&t, v[0]);
        qtri_transform_scale(&t, v[1]);
        qtri_transform_rotate_x(&t, a[0]);
        qtri_transform_rotate_about(&t, a[1], v[1], v[2]);
        qtri_transform_rotate_triangle(&t, a[2], v);
        qtri_transform_rotate_quat(&t, q);
        check_form(&t);
        qtri_transform_to_mat4(&t, &m);
    }
}

/* Whichever row has an exponent that no builder makes: what is 2^-INT32_MAX of the others adds
   nothing to a product with them. */
TEST(exponents_of_any_row)
{
    qtri_transform sum;
    qtri_transform_identity(&sum);
    for (int i = 0; i < 9; i++) {
        sum.row[i / 3].m[i % 3] = (int32_t)1 << 29;
    }
    for (int i = 0; i < 3; i++) {
        qtri_transform wild;
        qtri_transform none;
        qtri_transform_identity(&wild);
        for (int j = 0; j < 3; j++) {
            wild.row[j].exponent = -961; /* 2^31 - 1 less this is a multiple of 64 */
        }
        none = wild;
        memset(none.row[i].m, 0, sizeof none.row[i].m);
        wild.row[i].exponent = INT32_MAX;
        qtri_transform_mul(&wild, &sum, &wild);
        qtri_transform_mul(&none, &sum, &none);
        assert_memory_equal(&wild, &none, sizeof wild);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
