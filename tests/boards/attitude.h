/* SPDX-License-Identifier: MIT */
/*
 * A recorded flight: what a gyroscope and an accelerometer delivered, and where the body really
 * was. Axes of body and sensors are those of the renderer: x right, y up, z to the rear.
 */
#ifndef QTRI_ATTITUDE_H
#define QTRI_ATTITUDE_H

#include <stdint.h>

#include "qtri/quat.h"

/* As sensors deliver them: full scale, 32768, is 500 degrees a second and 2 g. */
typedef struct attitude_sample {
    int16_t rate[3];
    int16_t force[3]; /* of the body on its support: 1 g upwards at rest */
} attitude_sample;

#define ATTITUDE_RATE_HZ 64

/* Degrees a second: 500 / 32768 are 1000 / 65536. */
static inline qtri_vec3 attitude_rate(const attitude_sample *sample)
{
    qtri_vec3 rate = {sample->rate[0] * 1000, sample->rate[1] * 1000, sample->rate[2] * 1000};
    return rate;
}

/* g: 2 / 32768 are 4 / 65536. */
static inline qtri_vec3 attitude_force(const attitude_sample *sample)
{
    qtri_vec3 force = {sample->force[0] * 4, sample->force[1] * 4, sample->force[2] * 4};
    return force;
}

/* 6 seconds, and the attitude after each ATTITUDE_STRIDE samples. */
#define ATTITUDE_SAMPLES 384
#define ATTITUDE_STRIDE  24
#define ATTITUDE_TRUTHS  (ATTITUDE_SAMPLES / ATTITUDE_STRIDE)
extern const attitude_sample attitude_samples[ATTITUDE_SAMPLES];
extern const qtri_quat attitude_truth[ATTITUDE_TRUTHS];

#endif
