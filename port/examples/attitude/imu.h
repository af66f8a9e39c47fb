/* SPDX-License-Identifier: MIT */
/* What the attitude indicator reads: one sample of a gyroscope and an accelerometer. */
#ifndef QTRI_EXAMPLE_IMU_H
#define QTRI_EXAMPLE_IMU_H

#include <qtri.h>

/* Axes of the aircraft: x to the right, y up, z to the rear. */
typedef struct imu_sample {
    qtri_vec3 rate;  /* degrees a second */
    qtri_vec3 force; /* g: of the body on its support, 0, 1, 0 when it lies level */
} imu_sample;

#define IMU_RATE_HZ 64 /* samples a second */

/* The next one, when it is there. imu_synthetic.c makes them up; put your sensor's in its place. */
imu_sample imu_read(void);

#endif
