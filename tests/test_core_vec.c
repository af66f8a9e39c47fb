/* SPDX-License-Identifier: MIT */
/*
 * Vectors against exact or longer arithmetic.
 */
#include "support/vec.h"

static void check_length(q16 length, int128 square)
{
    int128 r = length;
    bool high = r > 0 && (2 * r - 1) * (2 * r - 1) > 4 * square;
    bool low = r < INT32_MAX && 4 * square >= (2 * r + 1) * (2 * r + 1);
    if (high || low) {
        fail_msg("length %d", (int)length);
    }
}

static void check_vectors(qtri_vec3 a, qtri_vec3 b, q16 t)
{
    int128 x = (int128)a.x * b.x;
    int128 y = (int128)a.y * b.y;
    int128 z = (int128)a.z * b.z;
    qtri_vec2 a2 = {a.x, a.y};
    qtri_vec2 b2 = {b.x, b.y};
    qtri_vec4 a4 = {a.x, a.y, a.z, t};
    qtri_vec4 b4 = {b.x, b.y, b.z, a.x};
    assert_int_equal(qtri_vec2_dot(a2, b2), q16_of_products(x + y));
    assert_int_equal(qtri_vec3_dot(a, b), q16_of_products(x + y + z));
    assert_int_equal(narrow_vec3_dot(a, b), q16_of_products(x + y + z));
    assert_int_equal(qtri_vec4_dot(a4, b4), q16_of_products(x + y + z + (int128)t * a.x));

    qtri_vec3 cross = qtri_vec3_cross(a, b);
    assert_int_equal(cross.x, q16_of_products((int128)a.y * b.z - (int128)a.z * b.y));
    assert_int_equal(cross.y, q16_of_products((int128)a.z * b.x - (int128)a.x * b.z));
    assert_int_equal(cross.z, q16_of_products((int128)a.x * b.y - (int128)a.y * b.x));

    int128 flat = (int128)a.x * a.x + (int128)a.y * a.y;
    check_length(qtri_vec2_length(a2), flat);
    check_length(qtri_vec3_length(a), flat + (int128)a.z * a.z);

    qtri_vec3 sum = qtri_vec3_add(a, b);
    qtri_vec3 difference = qtri_vec3_sub(a, b);
    qtri_vec3 scaled = qtri_vec3_scale(a, t);
    qtri_vec3 between = qtri_vec3_lerp(a, b, t);
    assert_int_equal(sum.y, saturated((int128)a.y + b.y));
    assert_int_equal(difference.z, saturated((int128)a.z - b.z));
    assert_int_equal(scaled.x, q16_of_products((int128)a.x * t));
    assert_int_equal(between.z, q16_of_products((int128)a.z * 65536 + ((int128)b.z - a.z) * t));

    assert_int_equal(qtri_vec2_cross(a2, b2), cross.z);
    check_length(qtri_vec4_length(a4), flat + (int128)a.z * a.z + (int128)t * t);
    int128 dx = (int128)a.x - b.x;
    int128 dy = (int128)a.y - b.y;
    int128 dz = (int128)a.z - b.z;
    int128 dw = (int128)t - a.x;
    check_length(qtri_vec2_distance(a2, b2), dx * dx + dy * dy);
    check_length(qtri_vec3_distance(a, b), dx * dx + dy * dy + dz * dz);
    check_length(qtri_vec4_distance(a4, b4), dx * dx + dy * dy + dz * dz + dw * dw);
    assert_int_equal(qtri_vec3_neg(a).z, saturated(-(int128)a.z));

    qtri_vec4 sum4 = qtri_vec4_add(a4, b4);
    qtri_vec4 difference4 = qtri_vec4_sub(a4, b4);
    qtri_vec4 scaled4 = qtri_vec4_scale(a4, b.x);
    qtri_vec4 between4 = qtri_vec4_lerp(a4, b4, b.y);
    qtri_vec2 between2 = qtri_vec2_lerp(a2, b2, t);
    assert_int_equal(sum4.w, saturated((int128)t + a.x));
    assert_int_equal(difference4.w, saturated(dw));
    assert_int_equal(scaled4.w, q16_of_products((int128)t * b.x));
    assert_int_equal(between4.w, q16_of_products((int128)t * 65536 - dw * b.y));
    assert_int_equal(between2.x, q16_of_products((int128)a.x * 65536 - dx * t));
    assert_int_equal(qtri_vec4_neg(a4).w, q16_neg(t));
    assert_int_equal(qtri_vec2_neg(a2).y, q16_neg(a.y));
    assert_int_equal(qtri_vec2_add(a2, b2).y, sum.y);
    assert_int_equal(qtri_vec2_sub(a2, b2).y, q16_sub(a.y, b.y));
    assert_int_equal(qtri_vec2_scale(a2, t).x, scaled.x);
}

TEST(vectors)
{
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    uint64_t seed = 11;
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) {
            qtri_vec3 a = {value[i], value[j], value[(i + 7 * j) % count]};
            qtri_vec3 b = {value[j], value[(3 * i + j) % count], value[i]};
            check_vectors(a, b, value[(5 * i + 11 * j) % count]);
        }
    }
    for (int i = 0; i < 200000; i++) {
        check_vectors(random_vec3(&seed), random_vec3(&seed), random_any(&seed));
    }
    qtri_vec3 lowest = {INT32_MIN, INT32_MIN, INT32_MIN};
    check_vectors(lowest, lowest, INT32_MIN);
}

/* Largest errors seen, in ULP. */
static double worst_component;
static double worst_length;

static void check_unit(const q16 *unit, const q16 *a, int count)
{
    long double square = 0;
    long double unit_square = 0;
    for (int i = 0; i < count; i++) {
        square += (long double)a[i] * a[i];
        unit_square += (long double)unit[i] * unit[i];
    }
    if (square == 0) {
        assert_true(unit_square == 0);
        return;
    }
    for (int i = 0; i < count; i++) {
        long double error = fabsl(unit[i] - a[i] / sqrtl(square) * 65536);
        worst_component = fmax(worst_component, (double)error);
    }
    worst_length = fmax(worst_length, (double)fabsl(sqrtl(unit_square) - 65536));
}

static void check_units(int32_t x, int32_t y, int32_t z, int32_t w)
{
    qtri_vec2 a2 = {x, y};
    qtri_vec3 a3 = {x, y, z};
    qtri_vec4 a4 = {x, y, z, w};
    qtri_vec2 unit2 = qtri_vec2_normalize(a2);
    qtri_vec3 unit3 = qtri_vec3_normalize(a3);
    qtri_vec4 unit4 = qtri_vec4_normalize(a4);
    qtri_vec4 narrow4;
    narrow_vec_normalize(&narrow4.x, &a4.x, 4);
    assert_memory_equal(&narrow4, &unit4, sizeof unit4);
    check_unit(&unit2.x, &a2.x, 2);
    check_unit(&unit3.x, &a3.x, 3);
    check_unit(&unit4.x, &a4.x, 4);
}

TEST(normalize)
{
    uint64_t seed = 12;
    for (int i = 0; i < 13 * 13 * 13 * 13; i++) { /* a few ULP long */
        check_units(i % 13 - 6, i / 13 % 13 - 6, i / 169 % 13 - 6, i / 2197 - 6);
    }
    for (int i = 0; i < 600000; i++) {
        qtri_vec3 a = random_vec3(&seed);
        check_units(a.x, a.y, a.z, random_any(&seed));
    }
    static int32_t value[STRESS_COUNT];
    int count = stress_values(value);
    for (int i = 0; i < count; i++) {
        qtri_vec3 axis = {0, value[i], 0};
        qtri_vec3 unit = qtri_vec3_normalize(axis);
        assert_true(unit.x == 0 && unit.z == 0);
        assert_int_equal(unit.y, value[i] == 0 ? 0 : (value[i] < 0 ? -Q16_ONE : Q16_ONE));
        for (int j = 0; j < count; j++) {
            check_units(value[i], value[j], value[(i + 7 * j) % count], value[(3 * i + j) % count]);
        }
    }
    print_message("normalize: %.5f ULP, length %.3f ULP\n", worst_component, worst_length);
    assert_true(worst_component <= .5002 && worst_length <= 1);
}

/* Like qtri_vec_along, but what it asks is (result - keep a) n = -times b (a.b), exactly. */
static void check_along(const q16 *result, const q16 *a, const q16 *b, int count, int keep,
                        int times)
{
    int128 dot = 0;
    int128 square = 0;
    for (int i = 0; i < count; i++) {
        dot += (int128)a[i] * b[i];
        square += (int128)b[i] * b[i];
    }
    for (int i = 0; i < count; i++) {
        if (square == 0) {
            assert_int_equal(result[i], keep != 0 ? a[i] : 0);
            continue;
        }
        int128 exact = (int128)a[i] * keep * square - (int128)b[i] * times * dot; /* times square */
        if (exact > INT32_MAX * square) {
            assert_int_equal(result[i], INT32_MAX);
        } else if (exact < INT32_MIN * square) {
            assert_int_equal(result[i], INT32_MIN);
        } else {
            double error = fabs((double)(result[i] * square - exact) / (double)square);
            worst_component = fmax(worst_component, error);
        }
    }
}

TEST(along)
{
    uint64_t seed = 17;
    worst_component = 0;
    for (int i = 0; i < 300000; i++) {
        qtri_vec3 r = random_vec3(&seed);
        qtri_vec3 s = random_vec3(&seed);
        if (i % 8 == 0) { /* nearly parallel, nearly perpendicular, or one component */
            s = i % 16 == 0 ? r : qtri_vec3_cross(r, s);
            s.x ^= random_in(&seed, 0, 3);
        }
        qtri_vec4 a = {r.x, r.y, r.z, random_any(&seed)};
        qtri_vec4 b = {s.x, s.y, s.z, i % 8 == 1 ? INT32_MIN : random_any(&seed)};
        qtri_vec2 a2 = {a.x, a.y};
        qtri_vec2 b2 = {b.x, b.y};
        qtri_vec2 v2[3] = {qtri_vec2_project(a2, b2), qtri_vec2_reject(a2, b2),
                           qtri_vec2_reflect(a2, b2)};
        qtri_vec3 v3[3] = {qtri_vec3_project(r, s), qtri_vec3_reject(r, s),
                           qtri_vec3_reflect(r, s)};
        qtri_vec4 v4[3] = {qtri_vec4_project(a, b), qtri_vec4_reject(a, b),
                           qtri_vec4_reflect(a, b)};
        for (int k = 0; k < 3; k++) {
            static const int keep[3] = {0, 1, 1};
            static const int times[3] = {-1, 1, 2};
            check_along(&v2[k].x, &a2.x, &b2.x, 2, keep[k], times[k]);
            check_along(&v3[k].x, &r.x, &s.x, 3, keep[k], times[k]);
            check_along(&v4[k].x, &a.x, &b.x, 4, keep[k], times[k]);
        }
    }
    qtri_vec4 lowest = {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
    qtri_vec4 zero = {0, 0, 0, 0};
    assert_int_equal(qtri_vec4_project(lowest, lowest).w, INT32_MIN);
    assert_int_equal(qtri_vec4_reject(lowest, lowest).w, 0);
    assert_int_equal(qtri_vec4_reflect(lowest, lowest).w, INT32_MAX);
    assert_int_equal(qtri_vec4_project(lowest, zero).w, 0);
    assert_int_equal(qtri_vec4_reflect(lowest, zero).w, INT32_MIN);
    print_message("project, reject, reflect: %.6f ULP\n", worst_component);
    assert_true(worst_component <= .5001);
}

/* Kahan's formula in longer arithmetic. */
static long double angle_between(const q16 *a, const q16 *b, int count)
{
    long double length[2] = {0, 0};
    for (int i = 0; i < count; i++) {
        length[0] += (long double)a[i] * a[i];
        length[1] += (long double)b[i] * b[i];
    }
    long double apart = 0;
    long double along_both = 0;
    for (int i = 0; i < count; i++) {
        long double u = a[i] * sqrtl(length[1]);
        long double v = b[i] * sqrtl(length[0]);
        apart += (u - v) * (u - v);
        along_both += (u + v) * (u + v);
    }
    return 2 * atan2l(sqrtl(apart), sqrtl(along_both)) * (180 / 3.14159265358979323846264338L);
}

TEST(angles)
{
    uint64_t seed = 18;
    long double worst = 0;
    for (int i = 0; i < 200000; i++) {
        qtri_vec3 r = random_vec3(&seed);
        qtri_vec3 s = random_vec3(&seed);
        if (i % 4 == 0) { /* nearly parallel or opposite */
            s = i % 8 == 0 ? r : qtri_vec3_neg(r);
            s.x ^= random_in(&seed, 0, 255);
        }
        qtri_vec4 a = {r.x, r.y, r.z, random_any(&seed)};
        qtri_vec4 b = {s.x, s.y, s.z, random_any(&seed)};
        qtri_vec2 a2 = {a.x, a.y};
        qtri_vec2 b2 = {b.x, b.y};
        bool zero2 = (a.x | a.y) == 0 || (b.x | b.y) == 0;
        bool zero3 = (a.x | a.y | a.z) == 0 || (b.x | b.y | b.z) == 0;
        if (zero2) {
            assert_int_equal(qtri_vec2_angle_deg(a2, b2), 0);
        }
        if (zero2 || zero3) {
            continue;
        }
        long double error[3] = {qtri_vec2_angle_deg(a2, b2) - 65536 * angle_between(&a.x, &b.x, 2),
                                qtri_vec3_angle_deg(r, s) - 65536 * angle_between(&a.x, &b.x, 3),
                                qtri_vec4_angle_deg(a, b) - 65536 * angle_between(&a.x, &b.x, 4)};
        for (int k = 0; k < 3; k++) {
            worst = fabsl(error[k]) > worst ? fabsl(error[k]) : worst;
        }
    }
    qtri_vec2 x = {7, 0};
    qtri_vec2 y = {0, INT32_MIN};
    qtri_vec2 minus_x = {INT32_MIN, 0};
    assert_int_equal(qtri_vec2_angle_deg(x, y), Q16(90));
    assert_int_equal(qtri_vec2_angle_deg(x, minus_x), Q16(180));
    assert_int_equal(qtri_vec2_angle_deg(x, x), 0);
    print_message("angle: %.4Lf ULP\n", worst);
    assert_true(worst <= .55L);
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
