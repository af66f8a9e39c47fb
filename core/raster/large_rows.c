/* SPDX-License-Identifier: MIT */
/* Rows of large triangles: edges, and depth where it leaves its range. */
#include "large_setup.h"

/* All bits of what the loop over pixels has modulo 2^32: |sum| < 2^47 + 2 2^31 2^15. */
static int64_t depth_at(const qtri_large_job *job, int32_t x)
{
    const qtri_ramp *depth = &job->depth;
    return (int64_t)job->depth_above * ((int64_t)1 << 32) + (int64_t)depth->origin +
           qtri_mul_s32((int32_t)depth->dx, x - job->gradient.anchor_x) +
           qtri_mul_s32((int32_t)depth->dy, job->t.y - job->gradient.anchor_y);
}

/* -1, 0, 1: below, inside and above the range. */
static int side_of(int64_t depth)
{
    return depth < 0 ? -1 : depth >> 32 != 0;
}

/*
 * The next part of a row, from next_left to next_right, whose depth is inside the range, or all
 * below or above it. Depth goes one way along a row, so each side has one run of pixels; few are
 * outside, and are counted. False: there is none.
 */
static bool next_part(qtri_large_job *job)
{
    const int32_t left = job->next_left, end = job->next_right;
    if (left >= end) {
        return false;
    }
    const int side = side_of(depth_at(job, left));
    int32_t right = left + 1;
    job->is_clamped = side != 0;
    if (side == 0) {
        right = end;
        while (side_of(depth_at(job, right - 1)) != 0) {
            right--;
        }
        job->t.z_step = job->depth.dx;
    } else {
        while (right < end && side_of(depth_at(job, right)) == side) {
            right++;
        }
        job->t.z_step = 0;
        job->t.z = (side < 0 ? 0 : (uint32_t)65535 << 16) + QTRI_DEPTH_HALF;
    }
    job->row_left = left;
    job->row_right = right;
    job->next_left = right;
    return true;
}

/* What is drawn from `left` to `right`; false: nothing. */
static inline bool set_row(qtri_large_job *job, int32_t left, int32_t right)
{
    qtri_large *t = &job->t;
    const int32_t x0 = qtri_greatest32(left, job->x_first);
    const int32_t x1 = qtri_least32(right, job->x_end);
    if (x0 >= x1) {
        return false;
    }
    t->x0 = x0;
    t->x1 = x1;
    t->x = x0;
    t->fog_x = x0;
    job->is_new = true;
    /* NOLINTBEGIN(performance-no-int-to-ptr): column 0 may lie before the surface's first row */
    t->pixel = (uint8_t *)(job->row_pixel + (uint32_t)x0 * job->pixel_bytes);
    t->depth = (uint8_t *)(job->row_depth + (uint32_t)x0 * job->depth_bytes);
    /* NOLINTEND(performance-no-int-to-ptr) */
    if (!job->is_clamped) {
        t->z = job->row_z + (uint32_t)x0 * job->depth.dx;
    }
    return true;
}

bool qtri_large_set_row(qtri_large_job *job, int32_t left, int32_t right)
{
    return set_row(job, left, right);
}

/* The next row's ends; false: there is none. */
static inline bool step_row(qtri_large_job *job)
{
    int32_t left, right;
    qtri_large_step_row(job);
    if (job->t.y >= job->edges.end) {
        return false;
    }
    qtri_large_edges_next(&job->edges, job->t.y, &left, &right);
    job->row_left = qtri_greatest32(left, 0);
    job->row_right = qtri_least32(right, job->frame_width);
    return true;
}

/* Rows whose depth may leave its range, part by part. */
QTRI_NOINLINE static bool next_clamped(qtri_large_job *job)
{
    for (;;) {
        while (next_part(job)) {
            if (set_row(job, job->row_left, job->row_right)) {
                return true;
            }
        }
        if (!step_row(job)) {
            return false;
        }
        job->next_left = job->row_left;
        job->next_right = job->row_right;
    }
}

bool qtri_large_next_row(qtri_large *t)
{
    qtri_large_job *job = qtri_large_job_of(t);
    if (job->clamps_depth) {
        return next_clamped(job);
    }
    do {
        if (!step_row(job)) {
            return false;
        }
    } while (!set_row(job, job->row_left, job->row_right));
    return true;
}
