/* SPDX-License-Identifier: MIT */
#include "rotation.h"

qtri_mat4 qtri_mat4_rotate_x_deg(q16 degrees)
{
    return qtri_rotation_plane(degrees, 1, 2);
}

qtri_mat4 qtri_mat4_rotate_y_deg(q16 degrees)
{
    return qtri_rotation_plane(degrees, 2, 0);
}

qtri_mat4 qtri_mat4_rotate_z_deg(q16 degrees)
{
    return qtri_rotation_plane(degrees, 0, 1);
}
