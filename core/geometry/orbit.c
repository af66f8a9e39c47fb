/* SPDX-License-Identifier: MIT */
#include "qtri/transform.h"

#include "plain.h"

void qtri_transform_orbit(qtri_transform *t, qtri_vec3 center, q16 distance, q16 azimuth,
                          q16 elevation)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(qtri_is_length(distance));
    const qtri_vec3 back = {0, 0, q16_neg(distance)};
    const qtri_vec3 to_origin = {q16_neg(center.x), q16_neg(center.y), q16_neg(center.z)};
    qtri_transform_translate(t, back);
    qtri_transform_rotate_x(t, elevation);
    qtri_transform_rotate_y(t, q16_neg(azimuth));
    qtri_transform_translate(t, to_origin);
}
