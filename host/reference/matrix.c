/* SPDX-License-Identifier: MIT */
#include "matrix.h"

#include <math.h>
#include <stddef.h>

/* M_PI is POSIX, not C99. */
static const double PI = 3.14159265358979323846;

void ref_from_q16(const int32_t *in, int count, double *out)
{
    for (int i = 0; i < count; i++)
        out[i] = (double)in[i] / 65536.0;
}

double ref_unit_from_q16(int32_t v)
{
    return fmax(0.0, fmin(1.0, (double)v / 65536.0));
}

double ref_dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void ref_cross3(const double a[3], const double b[3], double out[3])
{
    double x = a[1] * b[2] - a[2] * b[1];
    double y = a[2] * b[0] - a[0] * b[2];
    double z = a[0] * b[1] - a[1] * b[0];
    out[0] = x;
    out[1] = y;
    out[2] = z;
}

void ref_normalise3(double v[3])
{
    double length = sqrt(ref_dot3(v, v));
    if (!(length > 0.0))
        return;
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

void ref_sincos_degrees(double degrees, double *sine, double *cosine)
{
    /* fmod and the subtraction of a multiple of 90 are exact: 90 degrees is 0 of quadrant 1 */
    double turned = fmod(degrees, 360.0);
    double quadrants = floor(turned / 90.0 + 0.5);
    double rest = turned - 90.0 * quadrants;
    double s = sin(rest * (PI / 180.0));
    double c = cos(rest * (PI / 180.0));
    if (fabs(rest) == 45.0) {
        c = sqrt(0.5);
        s = rest > 0.0 ? c : -c;
    }
    switch ((int)fmod(quadrants + 8.0, 4.0)) {
    case 0:
        *sine = s;
        *cosine = c;
        break;
    case 1:
        *sine = c;
        *cosine = -s;
        break;
    case 2:
        *sine = -s;
        *cosine = -c;
        break;
    default:
        *sine = -c;
        *cosine = s;
        break;
    }
}

struct ref_matrix ref_matrix_identity(void)
{
    struct ref_matrix r = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    return r;
}

struct ref_matrix ref_matrix_multiply(const struct ref_matrix *a, const struct ref_matrix *b)
{
    struct ref_matrix r;
    for (int row = 0; row < 4; row++) {
        for (int col = 0; col < 4; col++) {
            double sum = 0.0;
            for (int k = 0; k < 4; k++)
                sum += a->m[row][k] * b->m[k][col];
            r.m[row][col] = sum;
        }
    }
    return r;
}

void ref_matrix_transform(const struct ref_matrix *matrix, const double v[4], double out[4])
{
    double r[4];
    for (int row = 0; row < 4; row++) {
        const double *m = matrix->m[row];
        r[row] = m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3] * v[3];
    }
    for (int row = 0; row < 4; row++)
        out[row] = r[row];
}

struct ref_matrix ref_matrix_load(const int32_t number[16])
{
    struct ref_matrix r;
    for (int row = 0; row < 4; row++)
        for (int col = 0; col < 4; col++)
            r.m[row][col] = (double)number[4 * col + row] / 65536.0;
    return r;
}

struct ref_matrix ref_matrix_translate(const double v[3])
{
    struct ref_matrix r = ref_matrix_identity();
    for (int i = 0; i < 3; i++)
        r.m[i][3] = v[i];
    return r;
}

struct ref_matrix ref_matrix_scale(const double v[3])
{
    struct ref_matrix r = ref_matrix_identity();
    for (int i = 0; i < 3; i++)
        r.m[i][i] = v[i];
    return r;
}

struct ref_matrix ref_matrix_rotate(double degrees, const double axis[3])
{
    struct ref_matrix r = ref_matrix_identity();
    double n[3] = {axis[0], axis[1], axis[2]};
    double s;
    double c;

    ref_normalise3(n);
    if (n[0] == 0.0 && n[1] == 0.0 && n[2] == 0.0)
        return r;
    ref_sincos_degrees(degrees, &s, &c);
    double k = 1.0 - c;
    r.m[0][0] = c + n[0] * n[0] * k;
    r.m[0][1] = n[0] * n[1] * k - n[2] * s;
    r.m[0][2] = n[0] * n[2] * k + n[1] * s;
    r.m[1][0] = n[0] * n[1] * k + n[2] * s;
    r.m[1][1] = c + n[1] * n[1] * k;
    r.m[1][2] = n[1] * n[2] * k - n[0] * s;
    r.m[2][0] = n[0] * n[2] * k - n[1] * s;
    r.m[2][1] = n[1] * n[2] * k + n[0] * s;
    r.m[2][2] = c + n[2] * n[2] * k;
    return r;
}

/* right = forward x up, with a substitute for an `up` that gives none. The inputs are multiples
   of 2^-16 below 2^15, so the cross product of the unnormalised vectors, 2 x 33 bits and a
   subtraction, may round in double; parallel vectors still give 0 exactly, because both products
   of a difference round alike. */
static void camera_right(const double forward[3], const double up[3], double right[3])
{
    const double y[3] = {0, 1, 0};
    const double z[3] = {0, 0, 1};

    ref_cross3(forward, up, right);
    if (ref_dot3(right, right) > 0.0)
        return;
    ref_cross3(forward, y, right);
    if (ref_dot3(right, right) > 0.0)
        return;
    ref_cross3(forward, z, right);
}

struct ref_matrix ref_matrix_look_at(const double eye[3], const double center[3],
                                     const double up[3])
{
    double forward[3];
    double right[3];
    double true_up[3];

    for (int i = 0; i < 3; i++)
        forward[i] = center[i] - eye[i];
    if (ref_dot3(forward, forward) == 0.0)
        forward[2] = -1.0;
    camera_right(forward, up, right);
    ref_normalise3(forward);
    ref_normalise3(right);
    ref_cross3(right, forward, true_up);

    struct ref_matrix r = ref_matrix_identity();
    for (int i = 0; i < 3; i++) {
        r.m[0][i] = right[i];
        r.m[1][i] = true_up[i];
        r.m[2][i] = -forward[i];
    }
    r.m[0][3] = -ref_dot3(right, eye);
    r.m[1][3] = -ref_dot3(true_up, eye);
    r.m[2][3] = ref_dot3(forward, eye);
    return r;
}

struct ref_matrix ref_matrix_perspective(double fovy_degrees, double aspect, double near,
                                         double far)
{
    struct ref_matrix r = {{{0}}};
    double s;
    double c;

    ref_sincos_degrees(fovy_degrees / 2.0, &s, &c);
    double g = c / s;
    r.m[0][0] = g / aspect;
    r.m[1][1] = g;
    r.m[2][2] = (far + near) / (near - far);
    r.m[2][3] = 2.0 * far * near / (near - far);
    r.m[3][2] = -1.0;
    return r;
}

struct ref_matrix ref_matrix_frustum(const double bounds[6])
{
    double l = bounds[0], r = bounds[1], b = bounds[2], t = bounds[3];
    double n = bounds[4], f = bounds[5];
    struct ref_matrix out = {{{0}}};

    out.m[0][0] = 2.0 * n / (r - l);
    out.m[0][2] = (r + l) / (r - l);
    out.m[1][1] = 2.0 * n / (t - b);
    out.m[1][2] = (t + b) / (t - b);
    out.m[2][2] = (f + n) / (n - f);
    out.m[2][3] = 2.0 * f * n / (n - f);
    out.m[3][2] = -1.0;
    return out;
}

struct ref_matrix ref_matrix_ortho(const double bounds[6])
{
    double l = bounds[0], r = bounds[1], b = bounds[2], t = bounds[3];
    double n = bounds[4], f = bounds[5];
    struct ref_matrix out = ref_matrix_identity();

    out.m[0][0] = 2.0 / (r - l);
    out.m[0][3] = -(r + l) / (r - l);
    out.m[1][1] = 2.0 / (t - b);
    out.m[1][3] = -(t + b) / (t - b);
    out.m[2][2] = -2.0 / (f - n);
    out.m[2][3] = -(f + n) / (f - n);
    return out;
}

void ref_matrix_normal(const struct ref_matrix *matrix, double out[3][3])
{
    double column[3][3];

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            column[j][i] = matrix->m[i][j];

    /* column j of the cofactor matrix is the cross product of the other two columns */
    for (int j = 0; j < 3; j++) {
        double cofactor[3];
        ref_cross3(column[(j + 1) % 3], column[(j + 2) % 3], cofactor);
        for (int i = 0; i < 3; i++)
            out[i][j] = cofactor[i];
    }
    double cofactor0[3] = {out[0][0], out[1][0], out[2][0]};
    double determinant = ref_dot3(column[0], cofactor0);
    double sign = determinant > 0.0 ? 1.0 : determinant < 0.0 ? -1.0 : 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[i][j] *= sign;
}
