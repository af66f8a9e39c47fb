/* SPDX-License-Identifier: MIT */
#include "depth_clamp.h"

#include "../bits/bits.h"

#define FARTHEST ((uint32_t)65535 << 16)
#define HALF     0x8000u /* rounds, see qtri_ramp */
#define ABOVE    ((uint32_t)1 << 30)

/* Of a plane of halves, 2^-16 of them: whole units. */
static int64_t whole(uint64_t value)
{
    return (qtri_wrap64(value) + ((int64_t)1 << 14)) >> 15;
}

/*
 * Halves of depths, since with what is below and above the range they take 33 bits: |less| is at
 * most 2^-5 of the range, so with 2^30 they are positive and below 2^32.
 *
 * Of a step that fits a half has 2^46 of the plane's units, and from vertex 0 to the anchor it is
 * less than 2^15 pixels in x and in y: 2^62.
 */
bool qtri_depth_clamp_init(qtri_job *job, const qtri_attributes v[3], const qtri_gradient *gradient,
                           const qtri_unsnapped *unsnapped)
{
    qtri_plane plane;
    uint32_t half[3];
    for (int i = 0; i < 3; i++) {
        half[i] = (v[i].depth_16p16 >> 1) + ABOVE;
    }
    (void)qtri_unsnapped_move(half, unsnapped, 0, UINT32_MAX);
    qtri_plane_init(&plane, gradient, half);
    const int64_t dx = whole(plane.dx);
    const int64_t dy = whole(plane.dy);
    if (dx != (int32_t)dx || dy != (int32_t)dy) {
        return false;
    }
    plane.origin -= (uint64_t)ABOVE << 16;
    const int64_t origin =
        whole(qtri_plane_column(qtri_plane_row(&plane, job->anchor_y), plane.dx, job->anchor_x)) +
        HALF;
    job->depth.origin = (uint32_t)((uint64_t)origin & UINT32_MAX);
    job->depth.dx = (uint32_t)((uint64_t)dx & UINT32_MAX);
    job->depth.dy = (uint32_t)((uint64_t)dy & UINT32_MAX);
    job->true_depth = job->depth;
    job->depth_above = (int32_t)(origin >> 32); /* 2^62 2^-15 2^-32: it fits */
    return true;
}

/* All bits of what the loops have modulo 2^32: |sum| < 2^47 + 2 2^31 2^15. */
static int64_t depth_at(const qtri_job *job, int32_t x, int32_t y)
{
    const qtri_ramp *depth = &job->true_depth;
    return (int64_t)job->depth_above * ((int64_t)1 << 32) + (int64_t)depth->origin +
           qtri_mul_s32((int32_t)depth->dx, x - job->anchor_x) +
           qtri_mul_s32((int32_t)depth->dy, y - job->anchor_y);
}

/* -1, 0, 1: below, inside and above the range. */
static int side_of(int64_t depth)
{
    return depth < 0 ? -1 : depth >> 32 != 0;
}

/*
 * Depth goes one way along a row, so each side has one run of pixels. Few are outside the range,
 * and are counted.
 */
bool qtri_depth_clamp_next(qtri_job *job, qtri_span *part, int32_t *i, const qtri_span *spans,
                           int32_t first, int32_t count)
{
    part->left = part->right;
    while (*i < 0 || part->left >= spans[*i].right) {
        if (++*i == count) {
            return false;
        }
        part->left = spans[*i].left;
    }
    const int32_t y = first + *i;
    const int side = side_of(depth_at(job, part->left, y));
    if (side == 0) {
        part->right = spans[*i].right;
        while (side_of(depth_at(job, part->right - 1, y)) != 0) {
            part->right--;
        }
        job->depth = job->true_depth;
        return true;
    }
    part->right = (int16_t)(part->left + 1);
    while (part->right < spans[*i].right && side_of(depth_at(job, part->right, y)) == side) {
        part->right++;
    }
    const qtri_ramp outside = {(side < 0 ? 0 : FARTHEST) + HALF, 0, 0};
    job->depth = outside;
    return true;
}

/* Whether no pixel of the row is outside the range. */
static bool is_inside(const qtri_job *job, const qtri_span *span, int32_t y)
{
    return span->left >= span->right || (side_of(depth_at(job, span->left, y)) == 0 &&
                                         side_of(depth_at(job, span->right - 1, y)) == 0);
}

/* By the corners of a box about them. */
bool qtri_depth_clamp_is_inside(qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    qtri_span box = spans[0];
    for (int32_t i = 1; i < count; i++) {
        box.left = spans[i].left < box.left ? spans[i].left : box.left;
        box.right = spans[i].right > box.right ? spans[i].right : box.right;
    }
    job->depth = job->true_depth;
    return is_inside(job, &box, row) && is_inside(job, &box, row + count - 1);
}
