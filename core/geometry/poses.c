/* SPDX-License-Identifier: MIT */
#include "qtri/animation.h"

void qtri_poses_compose(qtri_transform *world, const qtri_transform *local, const int16_t *parent,
                        int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        if (parent[i] >= 0 && parent[i] < i) {
            qtri_transform_mul(&world[i], &world[parent[i]], &local[i]);
        } else {
            world[i] = local[i];
        }
    }
}
