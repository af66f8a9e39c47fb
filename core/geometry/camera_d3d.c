/* SPDX-License-Identifier: MIT */
#include "qtri/transform.h"

/*
 * What looks down -z looks along +z when it is turned half about y: from the rows right, up and
 * backward of OpenGL's camera come left, up and forward, where left is right of a left-handed
 * world.
 */
void qtri_transform_look_at_d3d(qtri_transform *t, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up)
{
    const qtri_vec3 turn = {-Q16_ONE, Q16_ONE, -Q16_ONE};
    qtri_transform_scale(t, turn);
    qtri_transform_look_at(t, eye, center, up);
}

/* From eye space along +z to eye space along -z. */
static void mirror(qtri_transform *t)
{
    const qtri_vec3 factor = {Q16_ONE, Q16_ONE, -Q16_ONE};
    qtri_transform_scale(t, factor);
}

void qtri_transform_frustum_d3d(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top,
                                q16 near_z, q16 far_z)
{
    qtri_transform_frustum(t, left, right, bottom, top, near_z, far_z);
    mirror(t);
}

void qtri_transform_ortho_d3d(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top,
                              q16 near_z, q16 far_z)
{
    qtri_transform_ortho(t, left, right, bottom, top, near_z, far_z);
    mirror(t);
}
