/* SPDX-License-Identifier: MIT */
/*
 * The attitude filter: an hour of noisy samples against double precision and against the truth, the
 * flight that the boards show, what its gains mean, and extremes.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "support/test.h"
#include "boards/attitude.h"
#include "support/vec.h"

static const double degree = 3.14159265358979323846 / 180.0;

typedef struct real_quat {
    double w, x, y, z;
} real_quat;

typedef struct real_filter {
    real_quat q;
    double offset[3]; /* degrees a second */
    double gain, offset_gain;
} real_filter;

static real_quat real_of(qtri_quat q)
{
    real_quat result = {q.w / 65536.0, q.x / 65536.0, q.y / 65536.0, q.z / 65536.0};
    return result;
}

static real_quat real_attitude(const qtri_attitude *attitude)
{
    const double one = 1073741824.0;
    real_quat result = {attitude->q_q30[0] / one, attitude->q_q30[1] / one,
                        attitude->q_q30[2] / one, attitude->q_q30[3] / one};
    return result;
}

static real_quat multiply(real_quat a, real_quat b)
{
    real_quat product = {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                         a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                         a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                         a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    return product;
}

/* The world's up in axes of the body: the second row of its rotation matrix. */
static void up_of(real_quat q, double up[3])
{
    up[0] = 2.0 * (q.x * q.y + q.w * q.z);
    up[1] = q.w * q.w - q.x * q.x + q.y * q.y - q.z * q.z;
    up[2] = 2.0 * (q.y * q.z - q.w * q.x);
}

/* Degrees between two attitudes, and between their ups. */
static double angle_between(real_quat a, real_quat b)
{
    real_quat conjugate = {a.w, -a.x, -a.y, -a.z};
    real_quat turn = multiply(conjugate, b);
    double sine = sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    return 2.0 * atan2(sine, fabs(turn.w)) / degree;
}

static double tilt_between(real_quat a, real_quat b)
{
    double u[3], v[3], sine = 0.0, cosine = 0.0;
    up_of(a, u);
    up_of(b, v);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double cross = u[j] * v[k] - u[k] * v[j];
        sine += cross * cross;
        cosine += u[i] * v[i];
    }
    return atan2(sqrt(sine), cosine) / degree;
}

/* A turn as a quaternion, of degrees about axes of the body. */
static real_quat turn_by(const double turn[3])
{
    double angle = sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]) * degree;
    double scale = (angle > 0.0 ? sin(angle / 2.0) / angle : 0.5) * degree;
    real_quat result = {cos(angle / 2.0), turn[0] * scale, turn[1] * scale, turn[2] * scale};
    return result;
}

/* The filter in double precision, from the formulae. */
static void real_step(real_filter *filter, qtri_vec3 rate, qtri_vec3 force, double dt)
{
    const double r[3] = {rate.x / 65536.0, rate.y / 65536.0, rate.z / 65536.0};
    const double f[3] = {force.x / 65536.0, force.y / 65536.0, force.z / 65536.0};
    double up[3], turn[3];
    double strength = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    bool is_gravity = fabs(strength - 1.0) <= 0.15;
    up_of(filter->q, up);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double error = is_gravity ? (f[j] * up[k] - f[k] * up[j]) / strength / degree : 0.0;
        filter->offset[i] += error * filter->offset_gain * dt;
        turn[i] = (r[i] + filter->offset[i] + error * filter->gain) * dt;
    }
    filter->q = multiply(filter->q, turn_by(turn));
}

/* ---- An hour ---- */

enum { HOUR_HZ = 100, HOUR_SAMPLES = 3600 * HOUR_HZ };

/* Body to world, on a flight of sines: turned about y, pitched about x, rolled about z. */
static real_quat truth_at(double t)
{
    const double yaw[3] = {0.0, 60.0 * sin(t / 17.0), 0.0};
    const double pitch[3] = {35.0 * sin(t / 3.1), 0.0, 0.0};
    const double roll[3] = {0.0, 0.0, 70.0 * sin(t / 2.3)};
    return multiply(multiply(turn_by(yaw), turn_by(pitch)), turn_by(roll));
}

/* Of mean 0 and deviation 1. */
static double noise(uint64_t *seed)
{
    double sum = -6.0;
    for (int i = 0; i < 12; i++) {
        sum += (uint32_t)random_bits32(seed) / 4294967296.0;
    }
    return sum;
}

static qtri_vec3 fixed_of(const double v[3])
{
    qtri_vec3 result = {(q16)lround(v[0] * 65536.0), (q16)lround(v[1] * 65536.0),
                        (q16)lround(v[2] * 65536.0)};
    return result;
}

/* The sensors between two attitudes: offsets that wander, noise, and a push every 20 seconds. */
static void sense(real_quat before, real_quat after, double t, uint64_t *seed, qtri_vec3 *rate,
                  qtri_vec3 *force)
{
    const double offset[3] = {2.0 + 0.3 * sin(t / 500.0), -0.4, -2.5};
    real_quat conjugate = {before.w, -before.x, -before.y, -before.z};
    real_quat turn = multiply(conjugate, after);
    double sine = sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    double scale = sine > 0.0 ? 2.0 * atan2(sine, turn.w) / sine / degree * HOUR_HZ : 0.0;
    double rates[3] = {turn.x * scale, turn.y * scale, turn.z * scale}, forces[3];
    up_of(before, forces);
    for (int i = 0; i < 3; i++) {
        rates[i] += offset[i] + 0.3 * noise(seed);
        forces[i] += 0.02 * noise(seed) + (i == 1 && fmod(t, 20.0) < 1.0 ? 0.6 : 0.0);
    }
    *rate = fixed_of(rates);
    *force = fixed_of(forces);
}

/* Degrees from double precision and, once the offset is learned, of tilt from the truth. */
static void fly(double gain, double offset_gain, double difference_limit, double tilt_limit)
{
    const int32_t dt_q30 = ((int32_t)1 << 30) / HOUR_HZ;
    uint64_t seed = 1;
    real_filter real = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, gain, offset_gain};
    qtri_attitude_filter filter;
    qtri_attitude_filter_init(&filter, (q16)lround(gain * 65536.0),
                              (q16)lround(offset_gain * 65536.0));
    double difference = 0.0, tilt = 0.0, drift = 0.0;
    real_quat before = truth_at(0.0);
    for (int i = 0; i < HOUR_SAMPLES; i++) {
        double t = (double)i / HOUR_HZ;
        real_quat after = truth_at(t + 1.0 / HOUR_HZ);
        qtri_vec3 rate, force;
        sense(before, after, t, &seed, &rate, &force);
        qtri_attitude_filter_step(&filter, rate, force, dt_q30);
        real_step(&real, rate, force, dt_q30 / 1073741824.0);
        real_quat q = real_attitude(&filter.attitude);
        difference = fmax(difference, angle_between(q, real.q));
        drift = fmax(drift, tilt_between(q, real.q));
        tilt = t > 60.0 ? fmax(tilt, tilt_between(q, after)) : tilt;
        before = after;
    }
    print_message("gains %g, %g: from double precision %.6f degrees, in tilt %.6f; "
                  "tilt from the truth %.3f\n",
                  gain, offset_gain, difference, drift, tilt);
    assert_true(difference < difference_limit);
    assert_true(drift < 0.0001);
    assert_true(tilt < tilt_limit);
}

TEST(hour)
{
    /* Mahony; complementary, to which 3.4 degrees a second leave 6.8 and those of a push of 1 s. */
    fly(0.5, 0.0625, 0.0005, 0.5);
    fly(0.5, 0.0, 0.0005, 11.0);
}

/* ---- The flight of the boards ---- */

TEST(flight)
{
    const int32_t dt_q30 = ((int32_t)1 << 30) / ATTITUDE_RATE_HZ;
    const qtri_vec3 none = {0, 0, 0};
    qtri_attitude_filter filter, gyroscope;
    real_filter real = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1.0, 0.5};
    double worst_tilt = 0.0, worst_difference = 0.0, tilt = 0.0;
    qtri_attitude_filter_init(&filter, Q16(1), Q16(.5));
    qtri_attitude_filter_init(&gyroscope, Q16(1), Q16(.5));
    for (int i = 0; i < ATTITUDE_SAMPLES; i++) {
        qtri_vec3 rate = attitude_rate(&attitude_samples[i]);
        qtri_vec3 force = attitude_force(&attitude_samples[i]);
        qtri_attitude_filter_step(&gyroscope, rate, none, dt_q30); /* no force is not gravity */
        qtri_attitude_filter_step(&filter, rate, force, dt_q30);
        real_step(&real, rate, force, 1.0 / ATTITUDE_RATE_HZ);
        real_quat q = real_of(qtri_attitude_quat(&filter.attitude));
        worst_difference = fmax(worst_difference, angle_between(q, real.q));
        if ((i + 1) % ATTITUDE_STRIDE == 0) {
            tilt = tilt_between(q, real_of(attitude_truth[i / ATTITUDE_STRIDE]));
            worst_tilt = fmax(worst_tilt, tilt);
        }
    }
    print_message("tilt %.2f, at the end %.2f degrees; from double precision %.4f\n", worst_tilt,
                  tilt, worst_difference);
    assert_true(worst_tilt < 2.0); /* while the offset of the gyroscope is being learned */
    assert_true(tilt < 0.6);
    assert_true(worst_difference < 0.002); /* a Q16.16 quaternion's rounding */

    /* The gyroscope's offsets of 2, -.4 and -2.5 degrees a second, left to themselves. */
    real_quat end = real_of(attitude_truth[ATTITUDE_TRUTHS - 1]);
    assert_true(tilt_between(real_of(qtri_attitude_quat(&gyroscope.attitude)), end) > 10.0);
}

/* ---- Gains ---- */

static void stand(qtri_attitude_filter *filter, qtri_vec3 rate, qtri_vec3 force, int32_t seconds)
{
    for (int32_t i = 0; i < 64 * seconds; i++) {
        qtri_attitude_filter_step(filter, rate, force, ((int32_t)1 << 30) / 64);
    }
}

/* Standing still, tilted: the filter comes to rest there, whatever it believed at first. */
TEST(settles)
{
    const double angles[] = {-170.0, -90.0, -30.0, 45.0, 120.0};
    const qtri_vec3 still = {0, 0, 0};
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++) {
        double angle = angles[i] * degree;
        const double force[3] = {sin(angle), cos(angle), 0.0}; /* up, turned about z */
        qtri_attitude_filter filter;
        qtri_attitude_filter_init(&filter, Q16(1), Q16(.5));
        stand(&filter, still, fixed_of(force), 60);
        double up[3];
        up_of(real_attitude(&filter.attitude), up);
        assert_true(fabs(up[0] - sin(angle)) < 0.00005);
        assert_true(fabs(up[1] - cos(angle)) < 0.00005);
        assert_true(fabs(up[2]) < 0.00005);
    }
}

/*
 * After a time constant 1 / e of a small error is left. An offset leaves an angle whose sine is
 * offset / gain to the complementary filter, nothing to Mahony's, which knows the offset then.
 */
TEST(gains)
{
    const qtri_vec3 still = {0, 0, 0}, offset = {Q16(2), 0, Q16(-1)}, level = {0, Q16(1), 0};
    const double axis[3] = {1.0, 0.0, 0.0};
    const real_quat identity = {1.0, 0.0, 0.0, 0.0};
    qtri_attitude_filter filter;
    qtri_attitude_filter_init(&filter, Q16(.25), 0);
    filter.attitude = qtri_attitude_from_quat(qtri_quat_from_axis_deg(fixed_of(axis), Q16(1)));
    assert_true(fabs(tilt_between(real_attitude(&filter.attitude), identity) - 1.0) < 0.001);
    stand(&filter, still, level, 4);
    double left = tilt_between(real_attitude(&filter.attitude), identity);
    assert_true(fabs(left - exp(-1.0)) < 0.003);

    stand(&filter, offset, level, 120);
    left = tilt_between(real_attitude(&filter.attitude), identity);
    assert_true(fabs(sin(left * degree) - sqrt(5.0) * degree / 0.25) < 0.0005);
    filter.offset_gain = Q16(.25 * .25 / 4);
    stand(&filter, offset, level, 300);
    assert_true(tilt_between(real_attitude(&filter.attitude), identity) < 0.0005);
    assert_true(fabs(filter.offset_q24[0] / 16777216.0 + 2.0) < 0.0001);
    assert_true(fabs(filter.offset_q24[1] / 16777216.0) < 0.0001);
    assert_true(fabs(filter.offset_q24[2] / 16777216.0 - 1.0) < 0.0001);
}

/* ---- Extremes ---- */

static void assert_unit(const qtri_attitude_filter *filter)
{
    real_quat q = real_attitude(&filter->attitude);
    assert_true(fabs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1.0) < 1e-8);
}

/* Without gravity the filter integrates, as qtri_attitude_integrate_deg does. */
TEST(only_integrates)
{
    const qtri_vec3 rate = {Q16(100), Q16(-70), Q16(3000)};
    const qtri_vec3 forces[] = {{0, 0, 0},
                                {0, Q16(.84), 0},
                                {0, 0, Q16(-1.16)},
                                {INT32_MIN, INT32_MIN, INT32_MIN},
                                {1, 0, 0}};
    for (size_t i = 0; i < sizeof forces / sizeof forces[0]; i++) {
        qtri_attitude_filter filter;
        qtri_attitude_filter_init(&filter, Q16(1), Q16(1));
        qtri_attitude expected = filter.attitude;
        for (int step = 0; step < 100; step++) {
            qtri_attitude_filter_step(&filter, rate, forces[i], ((int32_t)1 << 30) / 64);
            qtri_attitude_integrate_deg(&expected, rate, Q16(1.0 / 64));
        }
        assert_memory_equal(&filter.attitude, &expected, sizeof expected);
    }
}

/* The offset stops at 128 degrees a second and comes back from there. */
TEST(saturates)
{
    const qtri_vec3 still = {0, 0, 0}, aside = {Q16(1), 0, 0};
    qtri_attitude_filter filter;
    qtri_attitude_filter_init(&filter, 0, Q16(32767));
    filter.tolerance = Q16(32767);
    for (int i = 0; i < 3; i++) {
        qtri_attitude_filter_step(&filter, still, aside, INT32_MAX);
        filter.attitude = qtri_attitude_from_quat(qtri_quat_identity());
    }
    assert_int_equal(filter.offset_q24[2], INT32_MAX);
    qtri_attitude_filter_step(&filter, still, aside, INT32_MIN);
    assert_true(filter.offset_q24[2] < 0);
}

TEST(extremes)
{
    static const q16 ends[] = {0, 1, -1, Q16_ONE, INT32_MAX, INT32_MIN};
    uint64_t seed = 7;
    for (int i = 0; i < 100000; i++) {
        qtri_attitude_filter filter;
        for (size_t k = 0; k < sizeof filter / sizeof(q16); k++) {
            q16 word = random_flag(&seed) ? ends[random_in(&seed, 0, 5)] : random_any(&seed);
            memcpy((char *)&filter + k * sizeof word, &word, sizeof word);
        }
        q16 n = ends[random_in(&seed, 0, 5)];
        qtri_vec3 end = {n, ends[random_in(&seed, 0, 5)], ends[random_in(&seed, 0, 5)]};
        qtri_attitude_filter_step(&filter, i % 2 ? end : random_vec3(&seed),
                                  i % 4 > 1 ? end : random_vec3(&seed),
                                  i % 8 > 3 ? n : random_any(&seed));
        assert_unit(&filter);
    }
}

int main(void)
{
    return run_all_tests(NULL, NULL);
}
