/* SPDX-License-Identifier: MIT */
/*
 * A sensor that is not there: the flight is synthetic, a slow weave of 35 degrees of bank and 12 of
 * pitch, with what a cheap gyroscope adds to it: an offset, and noise.
 */
#include "imu.h"

static uint32_t noise_state;
static uint32_t samples;

/* -amplitude..amplitude: the high bits of a linear congruence (Numerical Recipes' constants). */
static q16 noise(q16 amplitude)
{
    noise_state = noise_state * 1664525u + 1013904223u;
    return q16_mul(amplitude, (q16)(noise_state >> 15) - Q16(1));
}

imu_sample imu_read(void)
{
    /* Degrees of a turn of 10 seconds; its derivative is 36 degrees a second, .628 radians. */
    q16 turn = q16_from_ratio((int32_t)(samples % (10 * IMU_RATE_HZ)) * 36, IMU_RATE_HZ);
    q16 bank = q16_mul(Q16(35), q16_sin_deg(turn));
    q16 pitch = q16_mul(Q16(12), q16_sin_deg(2 * turn));
    q16 bank_rate = q16_mul(Q16(35 * .6283185), q16_cos_deg(turn));
    q16 pitch_rate = q16_mul(Q16(24 * .6283185), q16_cos_deg(2 * turn));
    imu_sample sample;
    samples++;
    /* Pitched, then banked, right wing down: rates of pitch are seen from the banked body. */
    sample.rate.x = q16_mul(pitch_rate, q16_cos_deg(bank)) + noise(Q16(1)) + Q16(.5);
    sample.rate.y = q16_mul(pitch_rate, q16_sin_deg(bank)) + noise(Q16(1));
    sample.rate.z = -bank_rate + noise(Q16(1)) - Q16(.8);
    sample.force.x = -q16_mul(q16_cos_deg(pitch), q16_sin_deg(bank)) + noise(Q16(.05));
    sample.force.y = q16_mul(q16_cos_deg(pitch), q16_cos_deg(bank)) + noise(Q16(.05));
    sample.force.z = -q16_sin_deg(pitch) + noise(Q16(.05));
    return sample;
}
