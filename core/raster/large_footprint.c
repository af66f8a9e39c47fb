/* SPDX-License-Identifier: MIT */
/*
 * The footprint of a large triangle with perspective.
 *
 * A texture coordinate u is S / Q of two that are linear on the screen: with weights b_i of the
 * vertices, Q = sum b_i q_i, S = sum b_i q_i u_i. Its steps to the right and down are K / Q^2 and
 * M / Q^2 with
 *
 *     K = S_x Q - S Q_x = sum over i j of (b_i,x b_j - b_j,x b_i) q_i q_j (u_i - u_j)
 *
 * over the three sides, in their order. Weights i and j are both 0 at the third vertex k, and a is
 * twice the area: b_i,x b_j - b_j,x b_i = (y - y_k) / a, and for M it is -(x - x_k) / a. So with
 * P_k = q_i q_j (u_i - u_j), all exact from the vertices,
 *
 *     K = (y sum P_k - sum P_k y_k) / a          M = -(x sum P_k - sum P_k x_k) / a
 *
 * K does not change along a row nor M along a column; and what K grows by in a row M loses in a
 * column. So the footprint of a piece of a row is one sum for each coordinate, a length, and q in
 * its middle.
 */
#include "large_setup.h"

/* K and M of a coordinate in the triangle's first and last row in the frame, and column. */
typedef struct ends {
    int64_t right[2], down[2]; /* times the area, 2^exponent */
    int64_t slope;             /* of `right`, a row */
    int32_t exponent;
} ends;

typedef struct frame {
    int32_t row[2], column[2];
    uint32_t qq[3]; /* q_i q_j 2^-32 < 2^30 */
} frame;

/* First row whose centre is at or below y, or column whose centre is at or right of x. */
static int32_t first_center(int32_t at_24p8)
{
    return (at_24p8 + 127) >> 8;
}

static void set_range(int32_t range[2], int32_t least_24p8, int32_t size_24p8, int32_t count)
{
    range[0] = qtri_hold32(first_center(least_24p8), 0, count - 1);
    range[1] = qtri_hold32(first_center(least_24p8 + size_24p8) - 1, range[0], count - 1);
}

static void set_frame(frame *f, const qtri_large_job *job)
{
    const uint32_t *q = job->q_at;
    const qtri_surface *surface = job->t.state->surface;
    set_range(f->row, job->t.y_least, job->t.height,
              qtri_least32(surface->height, QTRI_SURFACE_MAX));
    set_range(f->column, job->t.x_least, job->t.width, job->t.frame_width);
    for (int k = 0; k < 3; k++) {
        f->qq[k] = qtri_mul_high32(q[k == 2 ? 0 : k + 1], q[k == 0 ? 2 : k - 1]);
    }
}

/*
 * |u_i - u_j| < 2^30, so P < 2^60, which is brought below 2^36; places are at most 2^22 1/256
 * pixels away from the frame's corner: sums are below 2^36 2^22 3 and twice that.
 */
static void set_ends(ends *e, const frame *f, const qtri_large_job *job,
                     const qtri_large_attribute *a, int32_t texel_shift)
{
    const int32_t *x = job->t.corner_x, *y = job->t.corner_y;
    int64_t p[3];
    uint64_t all = 1;
    for (int k = 0; k < 3; k++) {
        const uint32_t from = a->f[k == 2 ? 0 : k + 1], to = a->f[k == 0 ? 2 : k - 1];
        p[k] = qtri_mul_s32((int32_t)f->qq[k], (int32_t)(from - to));
        all |= qtri_magnitude64(p[k]);
    }
    const int32_t down = qtri_greatest32(28 - qtri_clz64(all), 0);
    int64_t sum = 0, along_x = 0, along_y = 0;
    for (int k = 0; k < 3; k++) {
        const int64_t part = p[k] >> down;
        sum += part;
        along_x += part * x[k];
        along_y += part * y[k];
    }
    for (int k = 0; k < 2; k++) {
        e->right[k] = sum * (f->row[k] * 256 + 128) - along_y;
        e->down[k] = along_x - sum * (f->column[k] * 256 + 128);
    }
    e->slope = sum * 256;
    e->exponent = down - texel_shift;
}

/* 2^-down x, which is below 2^30, times `factor` 2^-31. */
static int32_t scaled(int64_t x, int32_t down, int32_t factor)
{
    const int64_t part =
        down >= 0 ? x >> down : x * ((int64_t)1 << (down < -30 ? 30 : -down)); /* |.| < 2^30 */
    return (int32_t)(qtri_mul_s32((int32_t)part, factor) >> 31);
}

/*
 * The length of a step, of parts that are linear in x, is linear where the same of them is the
 * longer one and neither changes its sign, which is so if it is at both ends; a shorter one that
 * does, as by rounding, is left out if it is below 2^-7: .005 of a level.
 */
static void set_along(qtri_footprint_plane *f, const int32_t column[2])
{
    int32_t end[2][2];
    uint32_t size[2][2];
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++) {
            end[i][k] = (int32_t)(f->down[i] + (uint32_t)column[k] * f->down_dx[i]);
            size[i][k] = qtri_magnitude32(end[i][k]);
        }
    }
    const int longer = size[0][0] > size[1][0] ? 0 : 1;
    const uint32_t *most = size[longer], *least = size[1 - longer];
    const bool alike = (end[1 - longer][0] ^ end[1 - longer][1]) >= 0;
    const bool slight = least[0] <= most[0] >> 7 && least[1] <= most[1] >> 7;
    f->straight =
        most[1] >= least[1] && (end[longer][0] ^ end[longer][1]) >= 0 && (alike || slight);
    const uint32_t dx = end[longer][0] < 0 ? 0u - f->down_dx[longer] : f->down_dx[longer];
    f->along = most[0];
    f->along_dx = column[0] == column[1] ? 0 : dx; /* the slope of one column may be any */
    if (alike && column[0] != column[1]) {         /* |.| < 2^29 */
        const int32_t less = (int32_t)f->down_dx[1 - longer];
        const int32_t share = 3 * (end[1 - longer][0] < 0 ? -less : less);
        f->along_dx += (uint32_t)(share >> 3);
    }
    f->along += (alike ? 3 * (least[0] >> 3) : 0) - (uint32_t)column[0] * f->along_dx;
}

/*
 * In texels a pixel, of a coordinate that has 2^texel_shift a texel, x of `ends` is
 *
 *     x 2^(exponent + 32 + 8) / area / q^2 = x r 2^(exponent + 40 - 94 + zeros) / q^2
 *
 * with r = 2^62 / (area 2^(zeros - 32)). In 30 bits of x, of the greatest of both ends, and r /
 * 2^(1/2) 2^-31, the product is below 2^30, and two bits more go; q has q_up bits that q_at has
 * not. The level is left behind where that is 2^(level + 2 zeros of q) times q's square or more,
 * which has 22 of 64 bits: see is_left() in large_levels.c.
 */
void qtri_large_set_footprint(qtri_footprint_plane *out, const qtri_large_job *job)
{
    frame f;
    ends e[2];
    int32_t bits[2], exponent[2];
    const uint64_t size = qtri_magnitude64(job->t.area);
    const int32_t zeros = qtri_clz64(size);
    const uint32_t r = qtri_reciprocal_near((uint32_t)(size << (zeros & 63) >> 32));
    const int32_t factor = (int32_t)qtri_mul_high32(r, 3037000500u); /* 2^31.5 */
    set_frame(&f, job);
    for (int i = 0; i < 2; i++) {
        set_ends(&e[i], &f, job, &job->a[i], job->levels->axis[i].shift);
        const uint64_t all = qtri_magnitude64(e[i].right[0]) | qtri_magnitude64(e[i].right[1]) |
                             qtri_magnitude64(e[i].down[0]) | qtri_magnitude64(e[i].down[1]);
        bits[i] = 64 - qtri_clz64(all | 1);
        exponent[i] = e[i].exponent + bits[i] - 30 + 31 - 54 + zeros;
    }
    const int32_t most = qtri_greatest32(exponent[0], exponent[1]) + 2;
    const bool varies = f.row[0] != f.row[1] || f.column[0] != f.column[1];
    for (int i = 0; i < 2; i++) {
        const int32_t by = qtri_least32(most - exponent[i], 31);
        const int32_t down = bits[i] - 30;
        const int32_t slope = varies ? scaled(e[i].slope, down, factor) >> by : 0;
        out->right_dy[i] = (uint32_t)slope;
        out->down_dx[i] = 0u - (uint32_t)slope;
        out->right[i] = (uint32_t)(scaled(e[i].right[0], down, factor) >> by) -
                        (uint32_t)f.row[0] * out->right_dy[i];
        out->down[i] = (uint32_t)(scaled(e[i].down[0], down, factor) >> by) -
                       (uint32_t)f.column[0] * out->down_dx[i];
    }
    out->before = -most + 41 - 2 * job->q_up;
    set_along(out, f.column);
}
