/* SPDX-License-Identifier: MIT */
/*
 * Prints attitude_samples.c: what sensors with offsets and noise deliver on a flight that is known.
 * The body rolls, pitches and turns as three sines; double precision, a random generator of its
 * own.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

enum { RATE_HZ = 64, SAMPLES = 384, STRIDE = 24 };

static const double pi = 3.14159265358979323846;

/* Of the sensors: degrees a second, g. */
static const double rate_offset[3] = {2.0, -0.4, -2.5};
static const double rate_noise = 0.3;
static const double force_noise = 0.02;

typedef struct quat {
    double w, x, y, z;
} quat;

static quat multiply(quat a, quat b)
{
    quat product = {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                    a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                    a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                    a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    return product;
}

static quat conjugate(quat a)
{
    quat result = {a.w, -a.x, -a.y, -a.z};
    return result;
}

/* Body to world: turned about y, then pitched about x, then rolled about z, each of the body. */
static quat attitude_at(double t)
{
    double yaw = 35.0 * sin(2.0 * pi * t / 6.0) * pi / 360.0;
    double pitch = 22.0 * sin(2.0 * pi * t / 2.7) * pi / 360.0;
    double roll = 50.0 * sin(2.0 * pi * t / 3.0) * pi / 360.0;
    quat about_y = {cos(yaw), 0.0, sin(yaw), 0.0};
    quat about_x = {cos(pitch), sin(pitch), 0.0, 0.0};
    quat about_z = {cos(roll), 0.0, 0.0, sin(roll)};
    return multiply(multiply(about_y, about_x), about_z);
}

/* Of mean 0 and deviation 1: twelve uniform numbers. */
static double noise(void)
{
    static uint32_t state = 1;
    double sum = -6.0;
    for (int i = 0; i < 12; i++) {
        state = state * 1664525u + 1013904223u; /* Numerical Recipes */
        sum += (double)(state >> 8) / 16777216.0;
    }
    return sum;
}

static int to_int16(double value, double full_scale)
{
    double scaled = floor(value * 32768.0 / full_scale + 0.5);
    return (int)fmin(fmax(scaled, -32768.0), 32767.0);
}

static void print_sample(int i)
{
    quat before = attitude_at((double)i / RATE_HZ);
    quat after = attitude_at((double)(i + 1) / RATE_HZ);
    quat turn = multiply(conjugate(before), after);
    double sine = sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    double scale = sine > 0.0 ? 2.0 * atan2(sine, turn.w) / sine * 180.0 / pi * RATE_HZ : 0.0;
    const double rate[3] = {turn.x * scale, turn.y * scale, turn.z * scale};
    const quat up = {0.0, 0.0, 1.0, 0.0};
    quat force = multiply(multiply(conjugate(before), up), before);
    const double forces[3] = {force.x, force.y, force.z};

    printf("    {{");
    for (int axis = 0; axis < 3; axis++) {
        double value = rate[axis] + rate_offset[axis] + rate_noise * noise();
        printf("%s%d", axis == 0 ? "" : ", ", to_int16(value, 500.0));
    }
    printf("}, {");
    for (int axis = 0; axis < 3; axis++) {
        printf("%s%d", axis == 0 ? "" : ", ", to_int16(forces[axis] + force_noise * noise(), 2.0));
    }
    printf("}},\n");
}

static int q16_of(double value)
{
    return (int)floor(value * 65536.0 + 0.5);
}

int main(void)
{
    printf("/* SPDX-License-Identifier: MIT */\n/* Printed by attitude_generate.c: make "
           "attitude-samples. */\n#include \"attitude.h\"\n\n"
           "/* clang-format off */\n"
           "const attitude_sample attitude_samples[ATTITUDE_SAMPLES] = {\n");
    for (int i = 0; i < SAMPLES; i++) {
        print_sample(i);
    }
    printf("};\n\nconst qtri_quat attitude_truth[ATTITUDE_TRUTHS] = {\n");
    for (int i = STRIDE; i <= SAMPLES; i += STRIDE) {
        quat q = attitude_at((double)i / RATE_HZ);
        printf("    {%d, %d, %d, %d},\n", q16_of(q.w), q16_of(q.x), q16_of(q.y), q16_of(q.z));
    }
    printf("};\n");
    return 0;
}
