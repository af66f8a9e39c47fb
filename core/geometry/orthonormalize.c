/* SPDX-License-Identifier: MIT */
#include "qtri/transform.h"
#include "qtri/error.h"

#include <stdbool.h>

#include "row.h"

static qtri_wide dot(const qtri_wide a[3], const qtri_wide b[3])
{
    qtri_wide sum = qtri_wide_mul(a[0], b[0]);
    qtri_wide_add_product(&sum, &a[1], &b[1]);
    qtri_wide_add_product(&sum, &a[2], &b[2]);
    return sum;
}

/*
 * Gram and Schmidt, once over: what is taken from y along x is short, and wide scalars have 60
 * bits. A pair that is parallel to 2^-50 has no plane.
 */
void qtri_transform_orthonormalize(qtri_transform *t)
{
    QTRI_ASSERT(t != NULL);
    qtri_wide axis[3][4];
    qtri_wide z[3];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            axis[i][k] = qtri_row_element(&t->row[i], k);
        }
    }
    if (!qtri_wide_normalize(axis[0]) || !qtri_wide_normalize(axis[1])) {
        return;
    }
    const qtri_wide along = dot(axis[0], axis[1]);
    for (int i = 0; i < 3; i++) {
        qtri_wide_sub_product(&axis[1][i], &along, &axis[0][i]);
        if (axis[1][i].e > 112) { /* the noise of unit vectors, as in camera.c */
            qtri_wide_set(&axis[1][i], 0, 0);
        }
    }
    if (!qtri_wide_normalize(axis[1])) {
        return;
    }
    qtri_wide_cross(z, axis[0], axis[1]);
    const qtri_wide side = dot(z, axis[2]);
    if (side.m == 0) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        axis[2][i] = side.m < 0 ? qtri_wide_neg(z[i]) : z[i];
    }
    for (int i = 0; i < 3; i++) {
        qtri_row_from_wide(&t->row[i], axis[i]);
    }
}
