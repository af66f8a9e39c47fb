/* SPDX-License-Identifier: MIT */
#include "qtri/transform.h"
#include "qtri/error.h"

#include <stdbool.h>
#include <stddef.h>

#include "row.h"

/* The direction in which a row of the camera looks at the world, of length 1. */
static bool axis_of(qtri_wide axis[3], const qtri_row *row)
{
    for (int i = 0; i < 3; i++) {
        axis[i] = qtri_row_element(row, i);
    }
    return qtri_wide_normalize(axis) != 0;
}

/* t = t builder, whose columns are three directions. */
static void turn(qtri_transform *t, qtri_wide axis[3][3])
{
    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        const qtri_wide none = qtri_wide_make(0, 0);
        const qtri_wide element[4] = {axis[0][i], axis[1][i], axis[2][i], none};
        qtri_row_from_wide(&builder.row[i], element);
    }
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_billboard(qtri_transform *t, const qtri_transform *camera)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(camera != NULL);
    qtri_wide axis[3][3];
    if (axis_of(axis[0], &camera->row[0]) && axis_of(axis[1], &camera->row[1]) &&
        axis_of(axis[2], &camera->row[2])) {
        turn(t, axis);
    }
}

/* z is what is level of the camera's, x = y cross z. */
void qtri_transform_billboard_upright(qtri_transform *t, const qtri_transform *camera)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(camera != NULL);
    qtri_wide axis[3][3];
    if (!axis_of(axis[2], &camera->row[2])) {
        return;
    }
    axis[2][1] = qtri_wide_make(0, 0);
    if (!qtri_wide_normalize(axis[2])) {
        return; /* it looks straight down or up: there is no side to turn */
    }
    for (int i = 0; i < 3; i++) {
        axis[1][i] = qtri_wide_make(i == 1, 0);
    }
    qtri_wide_cross(axis[0], axis[1], axis[2]);
    turn(t, axis);
}
