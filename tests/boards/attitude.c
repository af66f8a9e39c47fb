/* SPDX-License-Identifier: MIT */
#include "attitude.h"

#include "qtri/vec.h"

/* Degrees a second for one radian between the two ups: it closes with a time constant of 1 s. */
#define GAIN Q16(57.3)
/* The offset is learned from half a second's steady difference on. */
#define OFFSET_GAIN Q16(28.6)

/* Within these, the force is gravity, nearly; else the body is being pushed. */
#define FORCE_LEAST Q16(0.85)
#define FORCE_MOST  Q16(1.15)

void attitude_init(attitude_filter *filter)
{
    const qtri_vec3 none = {0, 0, 0};
    filter->attitude = qtri_attitude_from_quat(qtri_quat_identity());
    filter->correction = none;
}

void attitude_step(attitude_filter *filter, const attitude_sample *sample)
{
    const qtri_vec3 world_up = {0, Q16_ONE, 0};
    const q16 dt = Q16(1.0 / ATTITUDE_RATE_HZ);
    /* 500 / 32768 degrees a second are 1000 / 65536, 2 / 32768 g are 4 / 65536. */
    qtri_vec3 rate = {sample->rate[0] * 1000, sample->rate[1] * 1000, sample->rate[2] * 1000};
    qtri_vec3 force = {sample->force[0] * 4, sample->force[1] * 4, sample->force[2] * 4};

    q16 strength = qtri_vec3_length(force);
    if (strength > FORCE_LEAST && strength < FORCE_MOST) {
        qtri_quat to_body = qtri_quat_conjugate(qtri_attitude_quat(&filter->attitude));
        qtri_vec3 up = qtri_quat_rotate(to_body, world_up);
        /* Along the axis that turns the attitude's up to the measured one; its sine. */
        qtri_vec3 error = qtri_vec3_cross(qtri_vec3_normalize(force), up);
        filter->correction =
            qtri_vec3_add(filter->correction, qtri_vec3_scale(error, q16_mul(OFFSET_GAIN, dt)));
        rate = qtri_vec3_add(rate, qtri_vec3_scale(error, GAIN));
    }
    qtri_attitude_integrate_deg(&filter->attitude, qtri_vec3_add(rate, filter->correction), dt);
}
