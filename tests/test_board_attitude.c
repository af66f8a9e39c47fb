/* SPDX-License-Identifier: MIT */
/*
 * The attitude scene's filter (tests/boards/attitude.h) on its recorded flight: where it is, what
 * it would be without the accelerometer, and how far Q16.16 takes it from double precision.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "boards/attitude.h"

static const double degree = 3.14159265358979323846 / 180.0;

typedef struct real_quat {
    double w, x, y, z;
} real_quat;

typedef struct real_filter {
    real_quat q;
    double correction[3];
} real_filter;

static real_quat real_of(qtri_quat q)
{
    real_quat result = {q.w / 65536.0, q.x / 65536.0, q.y / 65536.0, q.z / 65536.0};
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
    double u[3], v[3];
    up_of(a, u);
    up_of(b, v);
    return acos(fmin(1.0, u[0] * v[0] + u[1] * v[1] + u[2] * v[2])) / degree;
}

/* attitude_step in double precision, from the formulae. */
static void real_step(real_filter *filter, const attitude_sample *sample)
{
    const double dt = 1.0 / ATTITUDE_RATE_HZ;
    double rate[3], force[3], up[3];
    for (int i = 0; i < 3; i++) {
        rate[i] = sample->rate[i] * 500.0 / 32768.0;
        force[i] = sample->force[i] * 2.0 / 32768.0;
    }
    double strength = sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    if (strength > 0.85 && strength < 1.15) {
        up_of(filter->q, up);
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            double error = (force[j] * up[k] - force[k] * up[j]) / strength;
            filter->correction[i] += error * 28.6 * dt;
            rate[i] += error * 57.3;
        }
    }
    double turn[3], angle = 0.0;
    for (int i = 0; i < 3; i++) {
        turn[i] = (rate[i] + filter->correction[i]) * dt * degree;
        angle += turn[i] * turn[i];
    }
    angle = sqrt(angle);
    double scale = angle > 0.0 ? sin(angle / 2.0) / angle : 0.5;
    real_quat step = {cos(angle / 2.0), turn[0] * scale, turn[1] * scale, turn[2] * scale};
    filter->q = multiply(filter->q, step);
}

/* Turns the accelerometer off: no force at all is not gravity. */
static attitude_sample gyroscope_only(attitude_sample sample)
{
    sample.force[0] = sample.force[1] = sample.force[2] = 0;
    return sample;
}

static void flight(void **state)
{
    (void)state;
    attitude_filter filter, gyroscope;
    real_filter real = {{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    double worst_tilt = 0.0, worst_difference = 0.0, tilt = 0.0;
    attitude_init(&filter);
    attitude_init(&gyroscope);
    for (int i = 0; i < ATTITUDE_SAMPLES; i++) {
        attitude_sample sample = gyroscope_only(attitude_samples[i]);
        attitude_step(&gyroscope, &sample);
        attitude_step(&filter, &attitude_samples[i]);
        real_step(&real, &attitude_samples[i]);
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
    assert_true(worst_difference < 0.002);

    /* The gyroscope's offsets of 2, -.4 and -2.5 degrees a second, left to themselves. */
    real_quat end = real_of(attitude_truth[ATTITUDE_TRUTHS - 1]);
    assert_true(tilt_between(real_of(qtri_attitude_quat(&gyroscope.attitude)), end) > 10.0);
}

/* Standing still, tilted: the filter comes to rest there, whatever it believed at first. */
static void settles(void **state)
{
    (void)state;
    const double angles[] = {-170.0, -90.0, -30.0, 45.0, 120.0};
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++) {
        double angle = angles[i] * degree;
        attitude_sample sample = {{0, 0, 0}, {0, 0, 0}};
        sample.force[0] = (int16_t)lround(16384.0 * sin(angle)); /* up, turned about z */
        sample.force[1] = (int16_t)lround(16384.0 * cos(angle));
        attitude_filter filter;
        attitude_init(&filter);
        for (int step = 0; step < 40 * ATTITUDE_RATE_HZ; step++) {
            attitude_step(&filter, &sample);
        }
        double up[3];
        up_of(real_of(qtri_attitude_quat(&filter.attitude)), up);
        assert_true(fabs(up[0] - sin(angle)) < 0.002);
        assert_true(fabs(up[1] - cos(angle)) < 0.002);
        assert_true(fabs(up[2]) < 0.002);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flight),
        cmocka_unit_test(settles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
