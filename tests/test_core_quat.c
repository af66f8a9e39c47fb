/* SPDX-License-Identifier: MIT */
/*
 * Quaternions against exact or longer arithmetic.
 */
#include "support/vec.h"

#define PI_L 3.14159265358979323846264338L

/* w, x, y, z */
typedef struct real_quat {
    long double q[4];
} real_quat;

static real_quat real_unit(const q16 *q)
{
    real_quat r = {{1, 0, 0, 0}};
    long double square = 0;
    for (int i = 0; i < 4; i++) {
        square += (long double)q[i] * q[i];
    }
    for (int i = 0; i < 4 && square != 0; i++) {
        r.q[i] = q[i] / sqrtl(square);
    }
    return r;
}

static real_quat real_mul(real_quat a, real_quat b)
{
    const long double *p = a.q;
    const long double *q = b.q;
    real_quat r = {{p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                    p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                    p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                    p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]}};
    return r;
}

static real_quat real_turn(long double x, long double y, long double z, long double degrees)
{
    real_quat r = {{1, 0, 0, 0}};
    long double length = sqrtl(x * x + y * y + z * z);
    long double half = degrees * (PI_L / 360);
    if (length != 0) {
        r.q[0] = cosl(half);
        r.q[1] = x / length * sinl(half);
        r.q[2] = y / length * sinl(half);
        r.q[3] = z / length * sinl(half);
    }
    return r;
}

static double error_of(qtri_quat a, real_quat exact)
{
    const q16 q[4] = {a.w, a.x, a.y, a.z};
    long double worst = 0;
    for (int i = 0; i < 4; i++) {
        long double error = fabsl(q[i] - exact.q[i] * 65536);
        worst = error > worst ? error : worst;
    }
    return (double)worst;
}

static double either_sign(qtri_quat a, real_quat exact)
{
    real_quat minus = {{-exact.q[0], -exact.q[1], -exact.q[2], -exact.q[3]}};
    return fmin(error_of(a, exact), error_of(a, minus));
}

/* How far the length is from 1. */
static double length_error(qtri_quat a)
{
    double square = (double)a.w * a.w + (double)a.x * a.x + (double)a.y * a.y + (double)a.z * a.z;
    return fabs(sqrt(square) - 65536);
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

static bool is_zero(qtri_quat a)
{
    return (a.w | a.x | a.y | a.z) == 0;
}

static bool is_identity(qtri_quat a)
{
    return a.w == Q16_ONE && a.x == 0 && a.y == 0 && a.z == 0;
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

TEST(rotates)
{
    double worst = 0;
    double worst_length = 0;
    uint64_t seed = 14;
    for (int i = 0; i < 300000; i++) {
        qtri_quat a = random_quat(&seed);
        qtri_vec3 v = random_vec3(&seed);
        double exact[3];
        rotate_exactly(exact, a, v);
        qtri_vec3 r = qtri_quat_rotate(a, v);
        double size = sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
        double error = fabs(r.x - saturated_double(exact[0]));
        error = fmax(error, fabs(r.y - saturated_double(exact[1])));
        error = fmax(error, fabs(r.z - saturated_double(exact[2])));
        worst = fmax(worst, (error - .5) / ldexp(size + 1, -27));
        if (size < Q16(100)) { /* the length stays */
            double turned = sqrt((double)r.x * r.x + (double)r.y * r.y + (double)r.z * r.z);
            worst_length = fmax(worst_length, fabs(turned - size));
        }
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
    assert_near(real(turned.x), -30000, .001);
    assert_near(real(turned.z), -30000, .001);
    print_message("rotate: .5 ULP + %.2f |v| 2^-27; length %.3f ULP\n", worst, worst_length);
    assert_true(worst <= 1.1 && worst_length <= 1.3); /* the contract: 2 */
}

TEST(normalizes)
{
    double worst = 0;
    double worst_length = 0;
    uint64_t seed = 15;
    for (int i = 0; i < 300000; i++) {
        qtri_quat a = random_quat(&seed);
        if (i < 256) {
            static const int32_t extreme[4] = {INT32_MIN, INT32_MAX, 0, 1};
            qtri_quat e = {extreme[i & 3], extreme[i >> 2 & 3], extreme[i >> 4 & 3],
                           extreme[i >> 6]};
            a = e;
        }
        qtri_quat n = qtri_quat_normalize(a);
        worst = fmax(worst, error_of(n, real_unit(&a.w)));
        worst_length = fmax(worst_length, length_error(n));
        assert_true(!is_zero(a) || is_identity(n));
    }
    print_message("normalize: %.4f ULP, length %.3f ULP\n", worst, worst_length);
    assert_true(worst <= .501 && worst_length <= 1);
}

/* inverse |a|^2 = conjugate, exactly. */
static double inverse_error(q16 inverse, int64_t component, int128 square)
{
    int128 exact = (int128)component * ((int64_t)1 << 32);
    if (exact > INT32_MAX * square || exact < INT32_MIN * square) {
        assert_int_equal(inverse, component < 0 ? INT32_MIN : INT32_MAX);
        return 0;
    }
    return fabs((double)(inverse * square - exact) / (double)square);
}

TEST(algebra)
{
    uint64_t seed = 16;
    double worst = 0;
    for (int i = 0; i < 100000; i++) {
        qtri_quat a = random_quat(&seed);
        qtri_quat b = random_quat(&seed);
        if (i < 256) {
            static const int32_t extreme[4] = {INT32_MIN, INT32_MAX, -1, 0x20000000};
            qtri_quat e = {extreme[i & 3], extreme[i >> 2 & 3], extreme[i >> 4 & 3],
                           extreme[i >> 6]};
            a = e;
            b = i % 2 == 0 ? e : b;
        }
        qtri_quat p = qtri_quat_mul(a, b);
        assert_int_equal(p.w, q16_of_products((int128)a.w * b.w - (int128)a.x * b.x -
                                              (int128)a.y * b.y - (int128)a.z * b.z));
        assert_int_equal(p.x, q16_of_products((int128)a.w * b.x + (int128)a.x * b.w +
                                              (int128)a.y * b.z - (int128)a.z * b.y));
        assert_int_equal(p.y, q16_of_products((int128)a.w * b.y - (int128)a.x * b.z +
                                              (int128)a.y * b.w + (int128)a.z * b.x));
        assert_int_equal(p.z, q16_of_products((int128)a.w * b.z + (int128)a.x * b.y -
                                              (int128)a.y * b.x + (int128)a.z * b.w));
        assert_int_equal(qtri_quat_dot(a, b),
                         q16_of_products((int128)a.w * b.w + (int128)a.x * b.x + (int128)a.y * b.y +
                                         (int128)a.z * b.z));
        qtri_quat narrow = narrow_quat_mul(a, b);
        assert_memory_equal(&narrow, &p, sizeof p);
        qtri_quat c = qtri_quat_conjugate(a);
        assert_int_equal(c.w, a.w);
        assert_int_equal(c.x, q16_neg(a.x));
        assert_int_equal(c.z, q16_neg(a.z));
        int128 square =
            (int128)a.w * a.w + (int128)a.x * a.x + (int128)a.y * a.y + (int128)a.z * a.z;
        qtri_quat inverse = qtri_quat_inverse(a);
        if (square == 0) {
            assert_true(is_identity(inverse));
            continue;
        }
        worst = fmax(worst, inverse_error(inverse.w, a.w, square));
        worst = fmax(worst, inverse_error(inverse.x, -(int64_t)a.x, square));
        worst = fmax(worst, inverse_error(inverse.y, -(int64_t)a.y, square));
        worst = fmax(worst, inverse_error(inverse.z, -(int64_t)a.z, square));
    }
    print_message("inverse: %.6f ULP\n", worst);
    assert_true(worst <= .5001);
    assert_true(is_identity(qtri_quat_identity()));
    /* First b, then a. */
    qtri_vec3 z_axis = {0, 0, 1};
    qtri_vec3 x_axis = {Q16(5), 0, 0};
    qtri_vec3 x = {Q16_ONE, 0, 0};
    qtri_quat turn_z = qtri_quat_from_axis_deg(z_axis, Q16(90));
    qtri_quat turn_x = qtri_quat_from_axis_deg(x_axis, Q16(90));
    qtri_vec3 r = qtri_quat_rotate(qtri_quat_mul(turn_x, turn_z), x);
    assert_near(real(r.z), 1, 1 / 65536.);
}

TEST(from_angles)
{
    static const int axes[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                   {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    uint64_t seed = 19;
    double worst = 0;
    for (int i = 0; i < 30000; i++) {
        qtri_vec3 axis = random_vec3(&seed);
        q16 degrees = i % 64 == 0 ? INT32_MIN : random_any(&seed);
        qtri_quat q = qtri_quat_from_axis_deg(axis, degrees);
        real_quat exact = real_turn(axis.x, axis.y, axis.z, degrees / 65536.L);
        worst = fmax(worst, error_of(q, exact));

        qtri_vec3 angles = random_vec3(&seed);
        const q16 angle[3] = {angles.x, angles.y, angles.z};
        const qtri_quat named[6] = {qtri_quat_from_euler_deg(angles, QTRI_EULER_XYZ),
                                    qtri_quat_from_euler_deg(angles, QTRI_EULER_XZY),
                                    qtri_quat_from_euler_deg(angles, QTRI_EULER_YXZ),
                                    qtri_quat_from_euler_deg(angles, QTRI_EULER_YZX),
                                    qtri_quat_from_euler_deg(angles, QTRI_EULER_ZXY),
                                    qtri_quat_from_euler_deg(angles, QTRI_EULER_ZYX)};
        for (int k = 0; k < 6; k++) {
            exact = real_turn(0, 0, 0, 0);
            for (int step = 0; step < 3; step++) {
                int about = axes[k][step];
                real_quat turn =
                    real_turn(about == 0, about == 1, about == 2, angle[about] / 65536.L);
                exact = real_mul(turn, exact);
            }
            worst = fmax(worst, error_of(named[k], exact));
        }
    }
    qtri_vec3 zero = {0, 0, 0};
    assert_true(is_identity(qtri_quat_from_axis_deg(zero, Q16(90))));
    print_message("from axis and Euler angles: %.4f ULP\n", worst);
    assert_true(worst <= .51);
}

TEST(matrices)
{
    uint64_t seed = 20;
    double worst_to = 0;
    double worst_from = 0;
    for (int i = 0; i < 100000; i++) {
        qtri_quat a = random_quat(&seed);
        if (i % 8 == 0) { /* half a turn, where w = 0 */
            a.w = random_in(&seed, -2, 2);
        }
        real_quat u = real_unit(&a.w);
        const long double *q = u.q;
        const long double exact[9] = {
            1 - 2 * (q[2] * q[2] + q[3] * q[3]), 2 * (q[1] * q[2] - q[0] * q[3]),
            2 * (q[1] * q[3] + q[0] * q[2]),     2 * (q[1] * q[2] + q[0] * q[3]),
            1 - 2 * (q[1] * q[1] + q[3] * q[3]), 2 * (q[2] * q[3] - q[0] * q[1]),
            2 * (q[1] * q[3] - q[0] * q[2]),     2 * (q[2] * q[3] + q[0] * q[1]),
            1 - 2 * (q[1] * q[1] + q[2] * q[2])};
        qtri_mat3 m = qtri_quat_to_mat3(a);
        qtri_mat4 m4 = qtri_quat_to_mat4(a);
        qtri_mat3 linear = qtri_mat4_linear(&m4);
        assert_memory_equal(&linear, &m, sizeof m);
        for (int k = 0; k < 9; k++) {
            worst_to = fmax(worst_to, (double)fabsl(m.m[k / 3][k % 3] - exact[k] * 65536));
        }
        qtri_quat back = qtri_quat_from_mat3(&m);
        qtri_quat back4 = qtri_quat_from_mat4(&m4);
        assert_memory_equal(&back, &back4, sizeof back);
        assert_true(back.w >= 0);
        worst_from = fmax(worst_from, either_sign(back, u));
    }
    print_message("to a matrix: %.4f ULP; and back: %.3f ULP\n", worst_to, worst_from);
    assert_true(worst_to <= .51 && worst_from <= 1.5);
    for (int i = 0; i < 50000; i++) { /* no rotation at all: a unit quaternion all the same */
        qtri_mat3 any;
        for (int k = 0; k < 9; k++) {
            any.m[k / 3][k % 3] =
                i < 512 ? (i >> k & 1 ? INT32_MIN : INT32_MAX) : random_any(&seed);
        }
        assert_true(length_error(qtri_quat_from_mat3(&any)) <= 1);
    }
    /* Half turns about each axis, exactly. */
    for (int axis = 0; axis < 3; axis++) {
        qtri_vec3 n = {axis == 0, axis == 1, axis == 2};
        qtri_mat4 half = qtri_mat4_rotate_axis_deg(n, Q16(180));
        qtri_quat q = qtri_quat_from_mat4(&half);
        assert_true(q.w == 0 && q.x == n.x * 65536 && q.y == n.y * 65536 && q.z == n.z * 65536);
    }
}

/* The textbook's formula, in longer arithmetic. */
static real_quat slerp_exactly(real_quat a, real_quat b, long double t)
{
    long double apart = 0;
    long double together = 0;
    for (int i = 0; i < 4; i++) {
        apart += (a.q[i] - b.q[i]) * (a.q[i] - b.q[i]);
        together += (a.q[i] + b.q[i]) * (a.q[i] + b.q[i]);
    }
    bool opposite = together < apart;
    long double angle =
        2 * atan2l(sqrtl(opposite ? together : apart), sqrtl(opposite ? apart : together));
    real_quat r;
    for (int i = 0; i < 4; i++) {
        long double end = opposite ? -b.q[i] : b.q[i];
        long double s = sinl(angle);
        r.q[i] = s < 1e-12L ? a.q[i] : (a.q[i] * sinl((1 - t) * angle) + end * sinl(t * angle)) / s;
    }
    return r;
}

static real_quat nlerp_exactly(real_quat a, real_quat b, long double t)
{
    long double dot = 0;
    long double square = 0;
    for (int i = 0; i < 4; i++) {
        dot += a.q[i] * b.q[i];
    }
    real_quat r;
    for (int i = 0; i < 4; i++) {
        r.q[i] = a.q[i] * (1 - t) + (dot < 0 ? -b.q[i] : b.q[i]) * t;
        square += r.q[i] * r.q[i];
    }
    for (int i = 0; i < 4; i++) {
        r.q[i] /= sqrtl(square);
    }
    return r;
}

TEST(interpolates)
{
    uint64_t seed = 21;
    double worst[2] = {0, 0};
    double worst_length = 0;
    double worst_end = 0;
    for (int i = 0; i < 200000; i++) {
        qtri_quat a = random_quat(&seed);
        qtri_quat b = random_quat(&seed);
        q16 t = random_in(&seed, 0, Q16_ONE);
        if (i % 4 == 1) { /* nearly parallel or opposite */
            a = qtri_quat_normalize(a);
            b = a;
            int32_t most = 1 << random_in(&seed, 0, 12);
            b.x += random_in(&seed, -most, most);
            b.w += random_in(&seed, -most, most);
            if (i % 8 == 1) {
                qtri_quat minus = {-b.w, -b.x, -b.y, -b.z};
                b = minus;
            }
        }
        real_quat u = real_unit(&a.w);
        real_quat v = real_unit(&b.w);
        long double dot = 0;
        for (int k = 0; k < 4; k++) {
            dot += u.q[k] * v.q[k];
        }
        if (fabsl(dot) < 1e-8L) {
            continue; /* both arcs are shortest */
        }
        qtri_quat s = qtri_quat_slerp(a, b, t);
        qtri_quat n = qtri_quat_nlerp(a, b, t);
        worst[0] = fmax(worst[0], error_of(s, slerp_exactly(u, v, t / 65536.L)));
        worst[1] = fmax(worst[1], error_of(n, nlerp_exactly(u, v, t / 65536.L)));
        worst_length = fmax(worst_length, fmax(length_error(s), length_error(n)));

        qtri_quat first = qtri_quat_slerp(a, b, -t);
        qtri_quat last = qtri_quat_slerp(a, b, Q16_ONE + t);
        worst_end = fmax(worst_end, fmax(error_of(first, u), either_sign(last, v)));
        first = qtri_quat_nlerp(a, b, INT32_MIN);
        last = qtri_quat_nlerp(a, b, INT32_MAX);
        worst_end = fmax(worst_end, fmax(error_of(first, u), either_sign(last, v)));
    }
    print_message("slerp: %.4f ULP, nlerp: %.4f ULP, length %.3f ULP, ends %.4f ULP\n", worst[0],
                  worst[1], worst_length, worst_end);
    assert_true(worst[0] <= .55 && worst[1] <= .51 && worst_length <= 1.1 && worst_end <= .55);

    qtri_quat a = {Q16(0.5), Q16(-0.5), Q16(0.5), Q16(0.5)};
    qtri_quat minus_a = {Q16(-0.5), Q16(0.5), Q16(-0.5), Q16(-0.5)};
    qtri_quat zero = {0, 0, 0, 0};
    qtri_quat same = qtri_quat_slerp(a, minus_a, Q16(0.5));
    assert_true(same.w == a.w && same.x == a.x && same.y == a.y && same.z == a.z);
    same = qtri_quat_nlerp(a, minus_a, Q16(0.25));
    assert_true(same.w == a.w && same.x == a.x && same.y == a.y && same.z == a.z);
    assert_true(is_identity(qtri_quat_slerp(zero, zero, Q16(0.5))));
    /* Half of a half turn: both arcs are as short, and the result is on one of them. */
    qtri_quat x = {0, Q16_ONE, 0, 0};
    qtri_quat y = {0, 0, Q16_ONE, 0};
    same = qtri_quat_slerp(x, y, Q16(0.5));
    assert_true(same.w == 0 && same.x == fixed(sqrt(.5)) && labs(same.y) == same.x);
}

TEST(integrates)
{
    uint64_t seed = 22;
    double worst = 0;
    for (int i = 0; i < 200000; i++) {
        qtri_quat a = random_quat(&seed);
        qtri_vec3 rate = random_vec3(&seed);
        q16 dt = random_any(&seed);
        long double x = rate.x / 65536.L;
        long double y = rate.y / 65536.L;
        long double z = rate.z / 65536.L;
        long double arc = sqrtl(x * x + y * y + z * z) * dt / 65536.L;
        qtri_quat q = qtri_quat_integrate_deg(a, rate, dt);
        assert_true(length_error(q) <= 1);
        if (fabsl(arc) < 65530) {
            worst = fmax(worst, error_of(q, real_mul(real_unit(&a.w), real_turn(x, y, z, arc))));
        }
    }
    print_message("integrate: %.4f ULP\n", worst);
    assert_true(worst <= .52);
    qtri_quat identity = qtri_quat_identity();
    qtri_vec3 zero = {0, 0, 0};
    assert_true(is_identity(qtri_quat_integrate_deg(identity, zero, Q16(1))));
    qtri_vec3 about_z = {0, 0, Q16(90)};
    qtri_quat quarter = qtri_quat_integrate_deg(identity, about_z, Q16(1));
    assert_near(real(quarter.w), sqrt(.5), 1 / 65536.);
    assert_near(real(quarter.z), sqrt(.5), 1 / 65536.);
    /* About the body's own axes: first the quarter about z, then what was x is y. */
    qtri_vec3 about_x = {Q16(90), 0, 0};
    qtri_quat both = qtri_quat_integrate_deg(quarter, about_x, Q16(1));
    qtri_vec3 r = qtri_quat_rotate(both, vec3_of(0, 0, 1));
    assert_near(real(r.x), 1, 2 / 65536.);
}

/* A minute of slow turning at a kilohertz: a Q16.16 quaternion would not move at all. */
TEST(attitudes)
{
    qtri_vec3 rate = vec3_of(.05, -.02, .01);
    q16 dt = fixed(.001);
    qtri_attitude attitude = qtri_attitude_from_quat(qtri_quat_identity());
    qtri_quat stuck = qtri_quat_identity();
    for (int i = 0; i < 60000; i++) {
        qtri_attitude_integrate_deg(&attitude, rate, dt);
        stuck = qtri_quat_integrate_deg(stuck, rate, dt);
    }
    assert_true(is_identity(stuck));
    qtri_quat q = qtri_attitude_quat(&attitude);
    long double x = real(rate.x);
    long double y = real(rate.y);
    long double z = real(rate.z);
    real_quat exact = real_turn(x, y, z, sqrtl(x * x + y * y + z * z) * real(dt) * 60000);
    double error = error_of(q, exact);
    print_message("a minute of samples: %.2f ULP\n", error);
    assert_true(error <= 2);

    qtri_attitude garbage = {{0, 0, 0, 0}};
    assert_true(is_identity(qtri_attitude_quat(&garbage)));
    qtri_attitude_integrate_deg(&garbage, rate, INT32_MIN);
    assert_true(length_error(qtri_attitude_quat(&garbage)) <= 1);
    uint64_t seed = 23;
    for (int i = 0; i < 1000; i++) { /* zero is no attitude: it is integrated as the identity */
        const qtri_vec3 turn = random_vec3(&seed);
        const q16 span = random_in(&seed, -Q16_ONE, Q16_ONE);
        qtri_attitude zero = {{0, 0, 0, 0}};
        qtri_attitude one = qtri_attitude_from_quat(qtri_quat_identity());
        qtri_attitude_integrate_deg(&zero, turn, span);
        qtri_attitude_integrate_deg(&one, turn, span);
        assert_memory_equal(&zero, &one, sizeof zero);
    }
    for (int i = 0; i < 20000; i++) {
        for (int k = 0; k < 4; k++) {
            garbage.q_q30[k] = random_any(&seed);
        }
        qtri_attitude_integrate_deg(&garbage, random_vec3(&seed), random_any(&seed));
        assert_true(length_error(qtri_attitude_quat(&garbage)) <= 1);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
