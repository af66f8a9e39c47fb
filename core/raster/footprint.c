/* SPDX-License-Identifier: MIT */
/*
 * The footprint of a large triangle with perspective.
 *
 * A texture coordinate u is s / q of two that are linear on the screen, q = 1/w. Its steps to the
 * right and down are
 *
 *     u_x = K / q^2,  K = s_x q - s q_x        u_y = M / q^2,  M = s_y q - s q_y
 *
 * where K is linear in y and does not change along a row, see perspective_setup.c, M is linear in x
 * and does not change along a column, and what K grows by in a row M loses in a column. So the
 * footprint of a block of pixels is one sum for each coordinate, a length, and q in its middle.
 */
#include "mipmap.h"
#include "rows.h"

/* An attribute's K and M in the triangle's first and last row in the frame, and column, to which
   chunks add pixels at both sides that are computed and not drawn. */
typedef struct ends {
    int64_t right[2], down[2]; /* 15/16 2^exponent texels */
    int32_t exponent;
} ends;

/* What the attributes have in common. */
typedef struct frame {
    int32_t row[2], column[2];
    int32_t nearest; /* the vertex whose q is the greatest */
    int32_t q;
    int32_t up;     /* of planes, which q has not */
    int32_t x_24p8; /* of it */
    int32_t q_dy;
} frame;

static void set_frame(frame *f, const qtri_job *job, const qtri_triangle *t, const uint32_t q[3])
{
    const qtri_projected *inv_w = &job->attribute[job->end].projected;
    const qtri_surface *surface = job->raster->surface;
    const int32_t last_row = surface->height - 1;
    const int32_t last_column = surface->width - 1;
    f->nearest = q[0] >= q[1] ? 0 : 1;
    f->nearest = q[f->nearest] >= q[2] ? f->nearest : 2;
    const uint32_t moved = (q[f->nearest] >> 5) * job->color.perspective.moved;
    f->q = (int32_t)((q[f->nearest] - moved) >> 1);
    f->up = job->color.perspective.up;
    f->x_24p8 = t->p[f->nearest]->x_24p8;
    f->q_dy = (int32_t)(inv_w->dy + (inv_w->dy_rest >> 15));
    f->row[0] = qtri_hold32(qtri_first_center(t->top->y_24p8), 0, last_row);
    f->row[1] = qtri_hold32(qtri_first_center(t->bottom->y_24p8) - 1, 0, last_row);
    f->column[0] = qtri_hold32(qtri_first_center(t->x_least), -QTRI_BATCH, last_column);
    f->column[1] = qtri_hold32(qtri_first_center(t->x_greatest) - 1, 0, last_column + QTRI_BATCH);
}

/*
 * M at the nearest vertex is q (s_y - a q_y), a being the coordinate there: as set_slope() of
 * perspective_setup.c has K, with 30 bits of the difference and of q. The difference is in 2^-16 of
 * half of s, so the product without 2^cut is in 2^(cut - 14) of u and, as K, is to be in
 * 15/16 2^-(down + up + 1).
 */
static int64_t down_at(const frame *f, const qtri_projected *a, uint32_t value)
{
    const uint64_t dy = ((uint64_t)a->dy << 16) + a->dy_rest;
    const int64_t slope = (int64_t)(int32_t)a->dy * 65536 + (int64_t)(dy & 0xFFFF);
    const int64_t difference = slope - (qtri_mul_s32(f->q_dy, (int32_t)value) >> 16);
    const int32_t cut = qtri_greatest32(34 - qtri_clz64(qtri_magnitude64(difference)), 0);
    int64_t product = qtri_mul_s32((int32_t)(difference >> cut), f->q) >> 31;
    product += (product >> 4) + (product >> 8) + (product >> 12) + (product >> 16);
    /* a->up: two more than the axis has */
    const int32_t up = cut - 14 + f->up + a->down + a->up - 1;
    return up >= 0 ? product * ((int64_t)1 << qtri_least32(up, 31))
                   : product >> qtri_least32(-up, 63);
}

static void set_ends(ends *e, const frame *f, const qtri_job *job, int i, uint32_t value)
{
    const qtri_projected *a = &job->attribute[QTRI_U + i].projected;
    const int32_t slope_dy = (int32_t)a->slope_dy;
    const int64_t down = down_at(f, a, value);
    for (int k = 0; k < 2; k++) {
        const int32_t x_24p8 = f->column[k] * 256 + 128 - f->x_24p8; /* < 2^23 */
        e->right[k] = (int32_t)(a->slope + a->slope_dy * (uint32_t)f->row[k]);
        e->down[k] = down - (qtri_mul_s32(slope_dy, x_24p8) >> 8);
    }
    e->exponent = -(a->down + 1 + job->axis[i].texel_shift);
}

/* 2^up x, which is below 2^29, times 15/32 / 2^(1/2), which is 21722 / 2^16: rounded down. */
static uint32_t scaled_end(int64_t x, int32_t up)
{
    const int64_t scaled =
        up >= 0 ? x * ((int64_t)1 << qtri_least32(up, 31)) : x >> qtri_least32(-up, 63);
    return (uint32_t)qtri_mul_s16((int32_t)scaled, 21722);
}

/*
 * The length of a step, of parts that are linear in x, is linear where the same of them is the
 * longer one and neither changes its sign, which is so if it is at both ends; a shorter one that
 * does, as by rounding, is left out if it is below 2^-7: .005 of a level.
 */
static void set_along(qtri_footprint *f, const int32_t column[2])
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

void qtri_footprint_init(qtri_footprint *out, const qtri_job *job, const qtri_triangle *t,
                         const uint32_t value[2][3], const uint32_t q[3])
{
    frame f;
    ends e[2];
    int32_t bits = INT32_MIN;
    set_frame(&f, job, t, q);
    for (int i = 0; i < 2; i++) {
        set_ends(&e[i], &f, job, i, value[i][f.nearest]);
        const uint64_t all = qtri_magnitude64(e[i].right[0]) | qtri_magnitude64(e[i].right[1]) |
                             qtri_magnitude64(e[i].down[0]) | qtri_magnitude64(e[i].down[1]);
        bits = qtri_greatest32(bits, 64 - qtri_clz64(all | 1) + e[i].exponent);
    }
    const int32_t exponent = 29 - bits;
    out->before = (int16_t)(exponent - 22);
    out->row = -1;
    for (int i = 0; i < 2; i++) {
        const qtri_projected *a = &job->attribute[QTRI_U + i].projected;
        const int32_t up = exponent + e[i].exponent;
        out->right_dy[i] = scaled_end((int32_t)a->slope_dy, up);
        out->down_dx[i] = 0u - out->right_dy[i];
        out->right[i] = scaled_end(e[i].right[0], up) - (uint32_t)f.row[0] * out->right_dy[i];
        out->down[i] = scaled_end(e[i].down[0], up) - (uint32_t)f.column[0] * out->down_dx[i];
    }
    set_along(out, f.column);
}
