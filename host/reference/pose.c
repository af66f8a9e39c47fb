/* SPDX-License-Identifier: MIT */
#include "pose.h"

#include <math.h>

struct ref_matrix ref_matrix_rotate_about(double degrees, const double axis[3],
                                          const double point[3])
{
    const double back[3] = {-point[0], -point[1], -point[2]};
    struct ref_matrix to = ref_matrix_translate(point);
    struct ref_matrix turn = ref_matrix_rotate(degrees, axis);
    struct ref_matrix from = ref_matrix_translate(back);
    struct ref_matrix there = ref_matrix_multiply(&to, &turn);

    return ref_matrix_multiply(&there, &from);
}

struct ref_matrix ref_matrix_rotate_triangle(double degrees, const double v[9])
{
    double along[3], across[3], normal[3], middle[3];

    for (int i = 0; i < 3; i++) {
        along[i] = v[3 + i] - v[i];
        across[i] = v[6 + i] - v[i];
        middle[i] = (v[i] + v[3 + i] + v[6 + i]) / 3.0;
    }
    ref_cross3(along, across, normal);
    return ref_matrix_rotate_about(degrees, normal, middle);
}

struct ref_matrix ref_matrix_quaternion(const double q[4])
{
    struct ref_matrix r = ref_matrix_identity();
    double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];

    if (square == 0.0)
        return r;
    /* v' = v + 2 (w u x v + u x (u x v)) / |q|^2, for the vector part u, of each axis v */
    for (int column = 0; column < 3; column++) {
        double v[3] = {column == 0, column == 1, column == 2};
        double once[3], twice[3];

        ref_cross3(&q[1], v, once);
        ref_cross3(&q[1], once, twice);
        for (int i = 0; i < 3; i++)
            r.m[i][column] = v[i] + 2.0 * (q[0] * once[i] + twice[i]) / square;
    }
    return r;
}

static void set_rows(struct ref_matrix *matrix, const double axis[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            matrix->m[i][k] = axis[i][k];
}

/* What turns these directions to x, y and z, and moves the point to the origin. */
static struct ref_matrix camera_of(const double axis[3][3], const double point[3])
{
    struct ref_matrix r = ref_matrix_identity();

    set_rows(&r, axis);
    for (int i = 0; i < 3; i++)
        r.m[i][3] = -ref_dot3(axis[i], point);
    return r;
}

struct ref_matrix ref_matrix_orbit(const double center[3], double distance, double azimuth,
                                   double elevation)
{
    double sin_a, cos_a, sin_e, cos_e;

    ref_sincos_degrees(azimuth, &sin_a, &cos_a);
    ref_sincos_degrees(elevation, &sin_e, &cos_e);
    /* right, up and towards the eye, as seen from outside */
    const double axis[3][3] = {{cos_a, 0.0, -sin_a},
                               {-sin_a * sin_e, cos_e, -cos_a * sin_e},
                               {sin_a * cos_e, sin_e, cos_a * cos_e}};
    struct ref_matrix r = camera_of(axis, center);

    r.m[2][3] -= distance;
    return r;
}

/* ---- Direct3D ---- */

/* Where up gives no side, y does, and where that is the line of sight, z. */
struct ref_matrix ref_matrix_look_at_d3d(const double eye[3], const double center[3],
                                         const double up[3])
{
    static const double other[2][3] = {{0, 1, 0}, {0, 0, 1}};
    double axis[3][3];
    double *x = axis[0], *y = axis[1], *z = axis[2];

    for (int i = 0; i < 3; i++)
        z[i] = center[i] - eye[i];
    if (ref_dot3(z, z) == 0.0)
        z[2] = -1.0;
    ref_cross3(up, z, x);
    for (int i = 0; i < 2 && ref_dot3(x, x) == 0.0; i++)
        ref_cross3(other[i], z, x);
    ref_normalise3(z);
    ref_normalise3(x);
    ref_cross3(z, x, y);
    return camera_of((const double(*)[3])axis, eye);
}

/* What looks along +z, its depths of 0..w widened to -w..w. */
static struct ref_matrix along_z(struct ref_matrix r)
{
    for (int row = 0; row < 4; row++)
        r.m[row][2] = -r.m[row][2];
    return r;
}

struct ref_matrix ref_matrix_perspective_d3d(double fovy_degrees, double aspect, double near,
                                             double far)
{
    return along_z(ref_matrix_perspective(fovy_degrees, aspect, near, far));
}

struct ref_matrix ref_matrix_frustum_d3d(const double bounds[6])
{
    return along_z(ref_matrix_frustum(bounds));
}

struct ref_matrix ref_matrix_ortho_d3d(const double bounds[6])
{
    return along_z(ref_matrix_ortho(bounds));
}

/* ---- Directions ---- */

struct ref_matrix ref_matrix_orthonormalized(const struct ref_matrix *matrix)
{
    struct ref_matrix r = *matrix;
    double axis[3][3], across[3];

    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 3; k++)
            axis[i][k] = matrix->m[i][k];
        ref_normalise3(axis[i]);
    }
    ref_cross3(axis[0], axis[1], across);
    if (ref_dot3(across, across) < 1e-28)
        return r;
    ref_normalise3(across);
    ref_cross3(across, axis[0], axis[1]);
    double side = ref_dot3(across, matrix->m[2]);
    if (side == 0.0)
        return r;
    for (int k = 0; k < 3; k++)
        axis[2][k] = side < 0.0 ? -across[k] : across[k];
    set_rows(&r, (const double(*)[3])axis);
    return r;
}

struct ref_matrix ref_matrix_billboard(const struct ref_matrix *camera, bool upright)
{
    struct ref_matrix r = ref_matrix_identity();
    double axis[3][3];

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            axis[i][k] = camera->m[i][k];
    if (upright) {
        for (int k = 0; k < 3; k++)
            axis[1][k] = k == 1;
        axis[2][1] = 0.0;
        ref_cross3(axis[1], axis[2], axis[0]);
    }
    for (int i = 0; i < 3; i++) {
        if (ref_dot3(axis[i], axis[i]) == 0.0)
            return r;
        ref_normalise3(axis[i]);
        for (int k = 0; k < 3; k++)
            r.m[k][i] = axis[i][k];
    }
    return r;
}

/* ---- Keys ---- */

static void quaternion_of(const struct scene_key *key, double q[4])
{
    double axis[3] = {key->axis[0], key->axis[1], key->axis[2]};
    double s, c;

    ref_normalise3(axis);
    ref_sincos_degrees(key->degrees / 65536.0 / 2.0, &s, &c);
    q[0] = c;
    for (int i = 0; i < 3; i++)
        q[1 + i] = s * axis[i];
}

/* Spherical interpolation; 2 atan2 of the lengths of difference and sum is the angle between two
   unit quaternions, accurate for small ones too. */
static void between_quaternions(const double a[4], const double b[4], double t, double q[4])
{
    double apart = 0.0, together = 0.0, dot = 0.0;

    for (int i = 0; i < 4; i++)
        dot += a[i] * b[i];
    double sign = dot < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 4; i++) {
        apart += (sign * b[i] - a[i]) * (sign * b[i] - a[i]);
        together += (sign * b[i] + a[i]) * (sign * b[i] + a[i]);
    }
    double angle = 2.0 * atan2(sqrt(apart), sqrt(together));
    double first = 1.0 - t, second = t;
    if (angle > 1e-9) {
        first = sin((1.0 - t) * angle) / sin(angle);
        second = sin(t * angle) / sin(angle);
    }
    for (int i = 0; i < 4; i++)
        q[i] = first * a[i] + second * sign * b[i];
}

struct ref_matrix ref_matrix_keys(const struct scene_key *keys, size_t count, int32_t time)
{
    size_t next = 0;
    double a[4], b[4], q[4], position[3], scale[3], t = 0.0;

    while (next < count && keys[next].time <= time)
        next++;
    const struct scene_key *from = &keys[next > 0 ? next - 1 : 0];
    const struct scene_key *to = &keys[next < count ? next : count - 1];
    if (to->time > from->time)
        t = ((double)time - from->time) / ((double)to->time - from->time);
    quaternion_of(from, a);
    quaternion_of(to, b);
    between_quaternions(a, b, t, q);
    for (int i = 0; i < 3; i++) {
        double p0 = from->position[i] / 65536.0, p1 = to->position[i] / 65536.0;
        double s0 = from->scale[i] / 65536.0, s1 = to->scale[i] / 65536.0;
        position[i] = p0 + t * (p1 - p0);
        scale[i] = s0 + t * (s1 - s0);
    }
    struct ref_matrix move = ref_matrix_translate(position);
    struct ref_matrix turn = ref_matrix_quaternion(q);
    struct ref_matrix size = ref_matrix_scale(scale);
    struct ref_matrix turned = ref_matrix_multiply(&move, &turn);
    return ref_matrix_multiply(&turned, &size);
}
