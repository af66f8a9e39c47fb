/* SPDX-License-Identifier: MIT */
#include "block.h"

enum { NODES = 7 };

/*
 * The interval is the 1024 inputs about its centre c = first + 511.5, of radius r < 512. The nodes
 * are c + 512 t_k, t_k the Chebyshev points rounded so that every node is a multiple of 1/2: an
 * argument of up to 2^31 then is exact in a long double.
 *
 * Remainder: |f - p| <= max |f^(7)| 512^7 / 7! max |(t - t_0) .. (t - t_6)|, and the last factor is
 * below 2^-5.97 on [-1, 1]. With x = raw / 65536 and h = 512 / 65536 = 2^-7 this is at most
 *     sin, cos     65536 h^7 / 7! 2^-5.97                     < 2^-51 ULP
 *     atan         |atan^(7)| <= 6!, 65536 h^7 / 7 2^-5.97    < 2^-41 ULP
 *     log, x >= 1  |log^(7)| <= 6! / x^7: the same            < 2^-41 ULP
 * and 1.44 times that for log2, 57.3 times for degrees. The nodes come from libm in long double,
 * within 2^-62 of their size. The coefficients and Horner's rule are double: below 2^-50 of
 * |value| + the largest slope times 512. All together stays far inside the 2^-48 (|value| + scale)
 * that the callers declare, scale >= 65536 being at least 128 times 512 times the slope.
 */
static const int node_at[NODES] = {0, 222, -222, 400, -400, 499, -499};

void verify_interpolate(long double (*f)(long double raw), q16 first, double *value)
{
    long double centre = (long double)first + 511.5L;
    long double t[NODES];
    long double c[NODES];
    for (int k = 0; k < NODES; k++) {
        t[k] = (long double)node_at[k] / 512;
        c[k] = f(centre + (long double)node_at[k]);
    }
    /* Newton's divided differences, then the same polynomial in powers of t. */
    for (int order = 1; order < NODES; order++) {
        for (int k = NODES - 1; k >= order; k--) {
            c[k] = (c[k] - c[k - 1]) / (t[k] - t[k - order]);
        }
    }
    for (int k = NODES - 2; k >= 0; k--) {
        for (int j = k; j < NODES - 1; j++) {
            c[j] -= t[k] * c[j + 1];
        }
    }
    double p[NODES];
    for (int k = 0; k < NODES; k++) {
        p[k] = (double)c[k];
    }
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        double u = ((double)i - 511.5) / 512;
        value[i] = p[0] + u * (p[1] + u * (p[2] + u * (p[3] + u * (p[4] + u * (p[5] + u * p[6])))));
    }
}
