/* SPDX-License-Identifier: MIT */
#include "projector.h"

/* What all corners of a box lie outside of: the near and far plane and the sides of a rectangle. */
enum { SIDES = 6 };

/*
 * Below zero outside, in units of 2^18: |x| < 2^43 and |edge| <= 2^15, so that 64 bits have room.
 * Cutting the low bits off moves a side by less than |edge| + 2 units.
 */
static int64_t beyond(int64_t x, int64_t w, int32_t edge)
{
    int32_t slack = (edge < 0 ? -edge : edge) + 2;
    return edge * w - x + slack;
}

/*
 * A half space of homogeneous coordinates that holds the corners holds the box; what is seen of it
 * has w > 0, and x / w beyond the edge. Edges are moved out by a pixel, for lines on them.
 */
bool qtri_projector_misses(const qtri_projector *projector, const qtri_box *box,
                           const int32_t low[2], const int32_t high[2])
{
    unsigned outside = (1u << SIDES) - 1;
    for (int i = 0; i < 8 && outside != 0; i++) {
        const qtri_vec3 *center = &box->center;
        const qtri_vec3 *half = &box->half;
        const qtri_vec3 corner = {
            (i & 1) != 0 ? q16_add(center->x, half->x) : q16_sub(center->x, half->x),
            (i & 2) != 0 ? q16_add(center->y, half->y) : q16_sub(center->y, half->y),
            (i & 4) != 0 ? q16_add(center->z, half->z) : q16_sub(center->z, half->z)};
        qtri_clip_vertex v;
        qtri_projector_point(projector, &corner, &v);
        int64_t x = v.x >> 18;
        int64_t y = v.y >> 18;
        int64_t z = v.z >> 18;
        int64_t w = v.w >> 18;
        const int64_t side[SIDES] = {beyond(-z, w, 1),          beyond(z, w, 1),
                                     beyond(-x, w, 1 - low[0]), beyond(x, w, high[0] + 1),
                                     beyond(-y, w, 1 - low[1]), beyond(y, w, high[1] + 1)};
        for (int k = 0; k < SIDES; k++) {
            outside &= side[k] < 0 ? ~0u : ~(1u << k);
        }
    }
    return outside != 0;
}
