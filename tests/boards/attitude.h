/* SPDX-License-Identifier: MIT */
/*
 * The attitude of a body from its gyroscope and its accelerometer, in Q16.16: Mahony's
 * complementary filter (Mahony, Hamel, Pflimlin, "Nonlinear complementary filters on the special
 * orthogonal group", IEEE Transactions on Automatic Control 53, 2008).
 *
 * The gyroscope's rates are integrated as a quaternion. Where the accelerometer's up and the
 * attitude's differ, the attitude is turned towards the accelerometer's, and the gyroscope's offset
 * is learned from what keeps coming back. Turns about the vertical show in the gyroscope only.
 *
 * Axes of body and sensors are those of the renderer: x right, y up, z to the rear.
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

typedef struct attitude_filter {
    qtri_attitude attitude; /* body to world */
    qtri_vec3 correction;   /* of the gyroscope's offset, degrees a second */
} attitude_filter;

#define ATTITUDE_RATE_HZ 64 /* samples a second; a power of two, so that Q16.16 holds 1/64 */

/* Starts level, heading along -z. */
void attitude_init(attitude_filter *filter);

/* One sample further. */
void attitude_step(attitude_filter *filter, const attitude_sample *sample);

/* A recorded flight of 6 seconds, and where the body really was after each ATTITUDE_STRIDE. */
#define ATTITUDE_SAMPLES 384
#define ATTITUDE_STRIDE  24
#define ATTITUDE_TRUTHS  (ATTITUDE_SAMPLES / ATTITUDE_STRIDE)
extern const attitude_sample attitude_samples[ATTITUDE_SAMPLES];
extern const qtri_quat attitude_truth[ATTITUDE_TRUTHS];

#endif
