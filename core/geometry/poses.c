/* SPDX-License-Identifier: MIT */
#include "qtri/animation.h"
#include "qtri/error.h"

void qtri_poses_compose(qtri_transform *world, const qtri_transform *local, const int16_t *parent,
                        int32_t count)
{
    QTRI_ASSERT((world != NULL && local != NULL && parent != NULL) || count <= 0);
    for (int32_t i = 0; i < count; i++) {
        if (parent[i] >= 0 && parent[i] < i) {
            qtri_transform_mul(&world[i], &world[parent[i]], &local[i]);
        } else {
            world[i] = local[i];
        }
    }
}
