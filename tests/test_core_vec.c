/*
 * Vectors, Q16.16 matrices and quaternions against exact or longer arithmetic.
 */
#include "support_core.h"

static qtri_vec3 random_vec3(uint64_t *seed)
{
    int shift = random_in(seed, 0, 30);
    qtri_vec3 v = {random_bits32(seed) >> shift, random_bits32(seed) >> shift,
                   random_bits32(seed) >> shift};
    if (random_in(seed, 0, 15) == 0) {
        v.x = INT32_MIN;
    }
    if (random_in(seed, 0, 15) == 0) {
        v.y = random_flag(seed) ? INT32_MIN : INT32_MAX;
    }
    return v;
}

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
}

static void vectors(void **state)
{
    (void)state;
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

static double normalize_error(qtri_vec3 a)
{
    long double x = a.x;
    long double y = a.y;
    long double z = a.z;
    long double length = sqrtl(x * x + y * y + z * z);
    qtri_vec3 unit = qtri_vec3_normalize(a);
    if (length == 0) {
        assert_true(unit.x == 0 && unit.y == 0 && unit.z == 0);
        return 0;
    }
    long double error[3] = {fabsl(unit.x - x / length * 65536), fabsl(unit.y - y / length * 65536),
                            fabsl(unit.z - z / length * 65536)};
    long double worst = error[0] > error[1] ? error[0] : error[1];
    return (double)(worst > error[2] ? worst : error[2]);
}

static void normalize(void **state)
{
    (void)state;
    double worst = 0;
    uint64_t seed = 12;
    for (int32_t x = -6; x <= 6; x++) { /* a few ULP long */
        for (int32_t y = -6; y <= 6; y++) {
            for (int32_t z = -6; z <= 6; z++) {
                qtri_vec3 a = {x, y, z};
                worst = fmax(worst, normalize_error(a));
            }
        }
    }
    for (int i = 0; i < 600000; i++) {
        worst = fmax(worst, normalize_error(random_vec3(&seed)));
    }
    static const int32_t extreme[] = {INT32_MIN, INT32_MIN + 1, INT32_MAX, 0, 1, -1};
    for (int i = 0; i < 216; i++) {
        qtri_vec3 a = {extreme[i % 6], extreme[i / 6 % 6], extreme[i / 36]};
        worst = fmax(worst, normalize_error(a));
    }
    print_message("normalize: %.6f ULP\n", worst);
    assert_true(worst <= .501);
}

/* COURSE scene 1. */
static void plane_transforms(void **state)
{
    (void)state;
    qtri_vec2 p = {Q16(2), Q16(1)};
    qtri_vec2 by[2] = {{Q16(1), Q16(2)}, {Q16(2), Q16(1)}};
    static const double expected[2][2] = {{1.70710678, 4.12132034}, {2.70710678, 3.12132034}};
    qtri_mat3 turn = qtri_mat3_rotate_deg(Q16(45));
    for (int i = 0; i < 2; i++) {
        qtri_mat3 move = qtri_mat3_translate(by[i]);
        qtri_mat3 both = qtri_mat3_mul(&move, &turn);
        qtri_vec2 result = qtri_mat3_point(&both, p);
        assert_near(real(result.x), expected[i][0], 2 / 65536.);
        assert_near(real(result.y), expected[i][1], 2 / 65536.);
    }
    qtri_vec2 factor = {Q16(-2), Q16(0.5)};
    qtri_mat3 scale = qtri_mat3_scale(factor);
    qtri_vec2 scaled = qtri_mat3_point(&scale, p);
    assert_int_equal(scaled.x, Q16(-4));
    assert_int_equal(scaled.y, Q16(0.5));
    qtri_mat3 shear = qtri_mat3_shear(Q16(3), Q16(-1));
    qtri_vec2 sheared = qtri_mat3_point(&shear, p);
    assert_int_equal(sheared.x, Q16(5));
    assert_int_equal(sheared.y, Q16(-1));
}

static qtri_mat4 random_mat4(uint64_t *seed)
{
    qtri_mat4 m;
    int shift = random_in(seed, 0, 24);
    for (int i = 0; i < 16; i++) {
        m.m[i / 4][i % 4] = random_in(seed, 0, 20) == 0 ? INT32_MIN : random_bits32(seed) >> shift;
    }
    return m;
}

static void matrices(void **state)
{
    (void)state;
    uint64_t seed = 13;
    for (int n = 0; n < 20000; n++) {
        qtri_mat4 a = random_mat4(&seed);
        qtri_mat4 b = random_mat4(&seed);
        qtri_mat4 product = qtri_mat4_mul(&a, &b);
        qtri_mat4 transposed = qtri_mat4_transpose(&a);
        qtri_vec4 v = {b.m[0][0], b.m[1][0], b.m[2][0], b.m[3][0]};
        qtri_vec4 image = qtri_mat4_vec4(&a, v);
        q16 column[4] = {image.x, image.y, image.z, image.w};
        for (int i = 0; i < 4; i++) {
            assert_int_equal(column[i], product.m[i][0]);
            for (int j = 0; j < 4; j++) {
                int128 sum = 0;
                for (int k = 0; k < 4; k++) {
                    sum += (int128)a.m[i][k] * b.m[k][j];
                }
                assert_int_equal(product.m[i][j], q16_of_products(sum));
                assert_int_equal(transposed.m[i][j], a.m[j][i]);
            }
        }
        qtri_mat3 a3;
        qtri_mat3 b3;
        for (int i = 0; i < 9; i++) {
            a3.m[i / 3][i % 3] = a.m[i / 3][i % 3];
            b3.m[i / 3][i % 3] = b.m[i / 3][i % 3];
        }
        qtri_mat3 product3 = qtri_mat3_mul(&a3, &b3);
        for (int i = 0; i < 9; i++) {
            int128 sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += (int128)a3.m[i / 3][k] * b3.m[k][i % 3];
            }
            assert_int_equal(product3.m[i / 3][i % 3], q16_of_products(sum));
        }
    }
    qtri_mat4 identity = qtri_mat4_identity();
    qtri_mat4 m = random_mat4(&seed);
    qtri_mat4 same = qtri_mat4_mul(&identity, &m);
    assert_memory_equal(&same, &m, sizeof m);
}

/* v turned by the exact unit quaternion along a, or v for a = 0. */
static void rotate_exactly(double out[3], qtri_quat a, qtri_vec3 v)
{
    double w = a.w;
    double u[3] = {a.x, a.y, a.z};
    double p[3] = {v.x, v.y, v.z};
    double n = w * w + u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    if (n == 0) {
        n = w = 1;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        double along = u[0] * p[0] + u[1] * p[1] + u[2] * p[2];
        double across = u[j] * p[k] - u[k] * p[j];
        double square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        out[i] = p[i] + 2 * (w * across + u[i] * along - p[i] * square) / n;
    }
}

static double saturated_double(double x)
{
    return fmin(fmax(x, INT32_MIN), INT32_MAX);
}

/* Largest component error in units of (1 + |v| 2^-16) ULP. */
static double rotate_error(qtri_quat a, qtri_vec3 v)
{
    double exact[3];
    rotate_exactly(exact, a, v);
    qtri_vec3 r = qtri_quat_rotate(a, v);
    double size = sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
    double error = fabs(r.x - saturated_double(exact[0]));
    error = fmax(error, fabs(r.y - saturated_double(exact[1])));
    error = fmax(error, fabs(r.z - saturated_double(exact[2])));
    return error / (1 + size / 65536);
}

static qtri_quat random_quat(uint64_t *seed)
{
    int shift = random_in(seed, 0, 28);
    qtri_quat q = {random_bits32(seed) >> shift, random_bits32(seed) >> shift,
                   random_bits32(seed) >> shift, random_bits32(seed) >> shift};
    switch (random_in(seed, 0, 15)) {
    case 0:
        q.w = 0;
        break;
    case 1:
        q.x = INT32_MIN;
        break;
    case 2:
        q.x = q.y = 0;
        break;
    default:
        break;
    }
    return q;
}

static void quaternion_rotates(void **state)
{
    (void)state;
    double worst = 0;
    uint64_t seed = 14;
    for (int i = 0; i < 200000; i++) {
        worst = fmax(worst, rotate_error(random_quat(&seed), random_vec3(&seed)));
    }
    /* Half a turn moves a far point by more than a q16 holds. */
    qtri_quat half = {0, 0, 0, Q16_ONE};
    qtri_vec3 far_point = {Q16(20000), 0, 0};
    qtri_vec3 turned = qtri_quat_rotate(half, far_point);
    assert_int_equal(turned.x, Q16(-20000));
    assert_int_equal(turned.y, 0);
    /* About x = -y: the corner of the range goes to the opposite one. */
    qtri_quat across = {0, Q16_ONE, -Q16_ONE, 0};
    qtri_vec3 far_corner = {Q16(30000), Q16(30000), Q16(30000)};
    turned = qtri_quat_rotate(across, far_corner);
    assert_near(real(turned.x), -30000, 2);
    assert_near(real(turned.z), -30000, 2);
    print_message("quat rotate: %.3f (1 + |v|) ULP\n", worst);
    assert_true(worst <= 4);
}

static void quaternion_normalizes(void **state)
{
    (void)state;
    double worst = 0;
    uint64_t seed = 15;
    for (int i = 0; i < 200000; i++) {
        qtri_quat a = random_quat(&seed);
        if (i < 256) {
            static const int32_t extreme[4] = {INT32_MIN, INT32_MAX, 0, 1};
            qtri_quat e = {extreme[i & 3], extreme[i >> 2 & 3], extreme[i >> 4 & 3],
                           extreme[i >> 6]};
            a = e;
        }
        long double c[4] = {a.w, a.x, a.y, a.z};
        long double length = sqrtl(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
        qtri_quat n = qtri_quat_normalize(a);
        if (length == 0) {
            assert_true(n.w == Q16_ONE && n.x == 0 && n.y == 0 && n.z == 0);
            continue;
        }
        q16 is[4] = {n.w, n.x, n.y, n.z};
        for (int k = 0; k < 4; k++) {
            worst = fmax(worst, (double)fabsl(is[k] - c[k] / length * 65536));
        }
    }
    print_message("quat normalize: %.4f ULP\n", worst);
    assert_true(worst <= .501);
}

static void quaternion_algebra(void **state)
{
    (void)state;
    uint64_t seed = 16;
    for (int i = 0; i < 50000; i++) {
        qtri_quat a = random_quat(&seed);
        qtri_quat b = random_quat(&seed);
        qtri_quat p = qtri_quat_mul(a, b);
        assert_int_equal(p.w, q16_of_products((int128)a.w * b.w - (int128)a.x * b.x -
                                              (int128)a.y * b.y - (int128)a.z * b.z));
        assert_int_equal(p.x, q16_of_products((int128)a.w * b.x + (int128)a.x * b.w +
                                              (int128)a.y * b.z - (int128)a.z * b.y));
        assert_int_equal(p.y, q16_of_products((int128)a.w * b.y - (int128)a.x * b.z +
                                              (int128)a.y * b.w + (int128)a.z * b.x));
        assert_int_equal(p.z, q16_of_products((int128)a.w * b.z + (int128)a.x * b.y -
                                              (int128)a.y * b.x + (int128)a.z * b.w));
        qtri_quat c = qtri_quat_conjugate(a);
        assert_int_equal(c.w, a.w);
        assert_int_equal(c.x, q16_neg(a.x));
    }
    qtri_vec3 z_axis = {0, 0, 1};
    qtri_vec3 x = {Q16_ONE, 0, 0};
    qtri_vec3 zero = {0, 0, 0};
    qtri_vec3 y = qtri_quat_rotate(qtri_quat_from_axis_deg(z_axis, Q16(90)), x);
    assert_near(real(y.x), 0, 2 / 65536.);
    assert_near(real(y.y), 1, 2 / 65536.);
    qtri_quat none = qtri_quat_from_axis_deg(zero, Q16(90));
    assert_true(none.w == Q16_ONE && none.x == 0 && none.y == 0 && none.z == 0);
    /* First b, then a. */
    qtri_vec3 x_axis = {Q16(5), 0, 0};
    qtri_quat turn_z = qtri_quat_from_axis_deg(z_axis, Q16(90));
    qtri_quat turn_x = qtri_quat_from_axis_deg(x_axis, Q16(90));
    qtri_vec3 r = qtri_quat_rotate(qtri_quat_mul(turn_x, turn_z), x);
    assert_near(real(r.z), 1, 4 / 65536.);
    for (int i = 0; i < 2000; i++) {
        qtri_vec3 axis = random_vec3(&seed);
        q16 degrees = random_any(&seed);
        qtri_quat q = qtri_quat_from_axis_deg(axis, degrees);
        double length =
            sqrt((double)axis.x * axis.x + (double)axis.y * axis.y + (double)axis.z * axis.z);
        if (length > 0) {
            double half = real(degrees) * (3.14159265358979323846 / 360);
            assert_near(real(q.w), cos(half), 1.2 / 65536);
            assert_near(real(q.y), axis.y / length * sin(half), 2 / 65536.);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors),
        cmocka_unit_test(normalize),
        cmocka_unit_test(plane_transforms),
        cmocka_unit_test(matrices),
        cmocka_unit_test(quaternion_rotates),
        cmocka_unit_test(quaternion_normalizes),
        cmocka_unit_test(quaternion_algebra),
    };
    return cmocka_run_group_tests_name("core vec", tests, NULL, NULL);
}
