/* SPDX-License-Identifier: MIT */
#include "perspective.h"

#include "rows.h"
#include "setup.h"

/* What all attributes of a triangle share. */
typedef struct shared {
    const qtri_gradient *gradient;
    const qtri_unsnapped *unsnapped;
    uint32_t q[3];       /* of the vertices, */
    uint32_t q_low[3];   /*   and 2^-8 of its unit more */
    uint32_t q_there[3]; /* where they are snapped to */
    bool fine;           /* planes are fine, and all of them times 2^up: */
    int32_t up;
    qtri_divisor area;
    int top, bottom;     /* of the vertices: the highest and the lowest */
    uint32_t reciprocal; /* 2^(62 - zeros) / height */
    int32_t zeros;
    int32_t row;        /* one that the triangle has */
    uint32_t along_q31; /* how far down it is, of the height */
    int32_t q_dx;       /* of inv_w, Q31 */
    uint32_t q_steep;   /* its magnitude, rounded up; 2^31 where it is more */
} shared;

/* log2 x in 1/256, at most 22 too little: the mantissa in place of its logarithm. */
static int32_t log2_below(uint32_t x)
{
    const int32_t zeros = qtri_clz32(x | 1);
    return ((31 - zeros) * 256) + (int32_t)((x << zeros & 0x7FFFFFFFu) >> 23);
}

/*
 * 2^(x / 256) 2^31 for x < 0, at most 2^(22 / 256) times that; else 2^31. x >= -31 * 256, and
 * set_limits() asks for -27 * 256 at least: there q' is a unit or more, its logarithm -31 * 256 or
 * more, and K has 14 bits and those of its unit, up to 30, below 2^0 at most: see set_slope(). With
 * k >= -44 * 256 its sums are (k - 62 * 256) / 4 and (k - 93 * 256) / 5 and more, and texels may
 * take half of 2^0 off.
 */
static uint32_t exp2_above_q31(int32_t x)
{
    return x >= 0 ? 0x80000000u : (uint32_t)(256 + (x & 255)) << 23 >> -(x >> 8);
}

static void set_plane(qtri_projected *p, const qtri_plane *plane)
{
    p->origin = (uint32_t)(plane->origin >> 16);
    p->dx = (uint32_t)(plane->dx >> 16);
    p->dy = (uint32_t)(plane->dy >> 16);
    p->origin_rest = (uint16_t)(plane->origin & 0xFFFFu);
    p->dx_rest = (uint16_t)(plane->dx & 0xFFFFu);
    p->dy_rest = (uint16_t)(plane->dy & 0xFFFFu);
}

/* In 2^-16, times 2^up. */
static void coarse(qtri_plane *plane, const qtri_fine_plane *fine, int32_t up)
{
    const int32_t down = 14 - up; /* >= 0 */
    plane->origin = (uint64_t)(qtri_wrap64(fine->origin) >> down);
    plane->dx = (uint64_t)(qtri_wrap64(fine->dx) >> down);
    plane->dy = (uint64_t)(qtri_wrap64(fine->dy) >> down);
}

/* f in 2^-8 at the snapped vertices. */
static void fine_plane(qtri_fine_plane *plane, const shared *s, int64_t there_q8[3],
                       const uint32_t f[3], const uint32_t low[3])
{
    for (int k = 0; k < 3; k++) {
        there_q8[k] = (int64_t)f[k] * 256 + low[k];
        if (s->unsnapped->is_on) {
            there_q8[k] -= qtri_unsnapped_less(s->unsnapped, f, k, 8);
        }
    }
    qtri_fine_plane_init(plane, s->gradient, &s->area, there_q8);
}

/* The vertices' a q / 2^32, rounded: below 2^29. */
static void attribute_plane(qtri_plane *plane, const uint32_t a[3], const shared *s)
{
    uint32_t f[3];
    uint32_t low[3];
    for (int k = 0; k < 3; k++) {
        uint64_t product = qtri_mul_u32(a[k], s->q[k]) + (qtri_mul_u32(a[k], s->q_low[k]) >> 8);
        product += s->fine ? 0x800000u : 0x80000000u;
        f[k] = (uint32_t)(product >> 32);
        low[k] = (uint32_t)product >> 24;
    }
    if (s->fine) {
        qtri_fine_plane fine;
        int64_t there_q8[3];
        fine_plane(&fine, s, there_q8, f, low);
        coarse(plane, &fine, s->up);
    } else {
        qtri_unsnapped_plane(plane, s->gradient, s->unsnapped, f);
    }
}

/*
 * The product of an attribute's slope and q^2 along rows,
 *
 *     K = s' q - s q' = q (s' - a q'),   s = a q,   q = inv_w / 2^31,
 *
 * does not change along a row and is linear in y: from two vertices. s' - a q' is in 2^-15 of a's
 * unit, cut to 30 bits, and times inv_w 2^-32: so K is below 2^29, times 2^(cut - 15 + 32 - 31),
 * and a curve, which makes 2^-15 of K 15/16 and 2^-1 of it, see set_curve, has slopes times
 * 2^-down. 1/15 is added for the 15/16. Returns the greater of the two.
 */
static uint32_t set_slope(qtri_projected *p, const qtri_plane *plane, const uint32_t a[3],
                          const shared *s)
{
    const int vertex[2] = {s->top, s->bottom};
    int64_t m[2];
    int32_t k[2];
    uint64_t all = 0;
    for (int i = 0; i < 2; i++) {
        const int64_t part = qtri_mul_s32(s->q_dx, (int32_t)a[vertex[i]]) >> 16;
        m[i] = qtri_wrap64(plane->dx - (uint64_t)part);
        all |= qtri_magnitude64(m[i]);
    }
    const int32_t cut = qtri_greatest32(34 - qtri_clz64(all), 0);
    for (int i = 0; i < 2; i++) {
        const int32_t half_q = (int32_t)(s->q_there[vertex[i]] >> 1);
        const int32_t whole = (int32_t)(qtri_mul_s32((int32_t)(m[i] >> cut), half_q) >> 31);
        k[i] = whole + (whole >> 4) + (whole >> 8) + (whole >> 12) + (whole >> 16);
    }
    p->down = (int8_t) - (cut - 14 + p->up + 1 + s->up);
    const int32_t rise = k[1] - k[0];
    const int64_t per_row = qtri_mul_s32(rise, (int32_t)s->reciprocal) >> (54 - s->zeros);
    const int32_t along = (int32_t)(qtri_mul_s32(rise, (int32_t)s->along_q31) >> 31);
    p->slope_dy = (uint32_t)(uint64_t)per_row;
    p->slope = (uint32_t)(k[0] + along) - (uint32_t)s->row * p->slope_dy;
    const uint32_t first = qtri_magnitude32(k[0]);
    const uint32_t last = qtri_magnitude32(k[1]);
    return first > last ? first : last;
}

/* Errors of blocks grow with the texels that a pixel steps over up to 2^this. */
enum { TEXELS_LOG2 = 2 };

/*
 * The least q at the start of a block of 2 h pixels, h = 2^l. For the bounds of perspective.c, all
 * with E = h |q'| / q <= 1/8, and K the triangle's greatest, in texels or in 256 times what a
 * colour may stray by:
 *
 *     second order   q >= (80 h^3)^(1/2) |q'|  or  q >= (80 h^3 K q'^2)^(1/4)
 *     16 pixels      q >= 100 |q'|             or  (9000 K q'^2)^(1/4), (430 h^4 K |q'|^3)^(1/5)
 *     32 pixels      q >= 186 |q'|             or  (31488 K q'^2)^(1/4), (120 h^4 K |q'|^3)^(1/5)
 *
 * The left column, which bounds errors by shares of a pixel's step, is for texels, of
 * which a pixel steps over up to 2^TEXELS_LOG2: where it steps over more, the right one counts with
 * that many in place of one. It is q in the
 * middle that counts, and where q grows that at the start too, as a span's last block has its
 * middle sooner. Logarithms are in 1/256; each may be 22 too little.
 */
static void set_limits(qtri_block_limits limits, const shared *s, bool texels, bool twisted,
                       int32_t k_log2, uint32_t q_floor)
{
    static const struct {
        int16_t share, fourth, fifth;
    } third_order[2] = {{1701, 3363, 5312}, {1930, 3826, 5864}};
    const int32_t q_log2 = log2_below(s->q_steep) + 22 - 31 * 256;
    k_log2 += 22;
    for (int32_t l = 0; l < QTRI_BLOCK_LOG2; l++) {
        int32_t share = (1618 + 768 * l) >> 1;
        int32_t least_log2 = (1618 + 768 * l + k_log2 + 2 * q_log2) >> 2;
        if (twisted && l + 1 >= QTRI_TWISTED_LOG2) {
            const int n = l + 1 > QTRI_TWISTED_LOG2;
            const int32_t fifth = third_order[n].fifth + k_log2 + 3 * q_log2;
            share = third_order[n].share;
            least_log2 = qtri_greatest32((third_order[n].fourth + k_log2 + 2 * q_log2) >> 2,
                                         (fifth * 205) >> 10); /* / 5 */
        }
        if (texels) {
            least_log2 = qtri_least32(
                least_log2, qtri_greatest32(share + q_log2, least_log2 - (TEXELS_LOG2 * 256 >> 2)));
        }
        uint32_t least = exp2_above_q31(least_log2 + 1);
        const uint32_t eighth = s->q_steep >> (28 - l) != 0 ? UINT32_MAX : s->q_steep << (l + 3);
        least = least > eighth ? least : eighth;
        least = least > q_floor ? least : q_floor;
        limits[l] = least >= 0x80000000u ? UINT32_MAX : least + (s->q_dx < 0 ? s->q_steep << l : 0);
    }
}

/*
 * Colours may stray by 2^-8 of 2^this, times 2^6 as their planes are: 1/8 of a step where they are
 * drawn, 1/16 of a step of what is drawn where texels are multiplied by them.
 */
static int32_t color_unit_log2(const qtri_raster *raster, bool light)
{
    int32_t log2 = 16 + 5 + raster->units->finer;
    if (raster->texture != NULL) {
        log2 = (light ? 18 : 20) + (raster->working == &qtri_colors_565 ? 2 : 0);
    }
    return log2 + QTRI_COLOR_PERSPECTIVE_SHIFT;
}

/*
 * What is added to colours: the half of 2^-16 that is a ramp's. Shades may be 1/8 of a step of 8
 * bits below 0 and some above 1, see stage_color.h: enough for the 1/16 by which those for 8 bits
 * stray, while those for RGB565 may be 1/4 off, and are lifted.
 */
static uint32_t color_bias(const qtri_raster *raster, bool light)
{
    if (raster->texture == NULL || raster->working != &qtri_colors_565) {
        return 0x8000u;
    }
    return 0x8000u + (light ? 4096u : 12288u);
}

/*
 * Where vertices are moved by weights of 2^-6 at most, 1/w grows by 2^-5 of itself: less 1/32 it
 * stays below 2^31, as its ratios are all that counts.
 */
static void set_q(shared *s, const qtri_attributes v[3], const uint32_t q[3])
{
    const uint32_t moves = s->unsnapped->is_on ? 1 : 0;
    const int32_t most = qtri_greatest32(v[0].inv_w_exponent,
                                         qtri_greatest32(v[1].inv_w_exponent, v[2].inv_w_exponent));
    for (int i = 0; i < 3; i++) {
        const uint32_t down = (uint32_t)most - (uint32_t)v[i].inv_w_exponent;
        uint64_t q_q8 = (uint64_t)q[i] << 8;
        if (s->fine && down <= 29) {
            q_q8 = (uint64_t)v[i].inv_w_q31 << 8 >> down;
        }
        q_q8 -= (q_q8 >> 5) * moves;
        s->q[i] = (uint32_t)(q_q8 >> 8);
        s->q_low[i] = (uint32_t)(q_q8 & 0xFFu);
        s->q_there[i] = s->q[i];
    }
    if (!s->fine) {
        qtri_unsnapped_move(s->q_there, s->unsnapped, 1, 0x80000000u);
    }
}

static void set_shared(shared *s, const qtri_triangle *t, const qtri_attributes v[3],
                       const uint32_t q[3], const qtri_gradient *gradient,
                       const qtri_unsnapped *unsnapped)
{
    s->gradient = gradient;
    s->unsnapped = unsnapped;
    s->up = 0;
    s->fine = qtri_divisor_init(&s->area, gradient, t->extent);
    set_q(s, v, q);
    for (int i = 0; i < 3; i++) {
        s->top = t->p[i] == t->top ? i : (i == 0 ? 0 : s->top);
        s->bottom = t->p[i] == t->bottom ? i : (i == 0 ? 0 : s->bottom);
    }
    const uint32_t height = (uint32_t)(t->bottom->y_24p8 - t->top->y_24p8); /* > 0 */
    s->zeros = qtri_clz32(height | 1);
    s->reciprocal = (uint32_t)qtri_reciprocal_below(height << s->zeros);
    s->row = qtri_hold32(gradient->anchor_y, qtri_first_center(t->top->y_24p8),
                         qtri_first_center(t->bottom->y_24p8) - 1);
    const uint32_t along = (uint32_t)(s->row * 256 + 128 - t->top->y_24p8); /* < height */
    s->along_q31 = (uint32_t)(qtri_mul_u32(along << s->zeros, s->reciprocal) >> 31);
}

/* Returns log2 of the attribute's greatest K, in 1/256 of 2^unit_log2. */
static int32_t set_attribute(qtri_projected *p, const uint32_t a[3], const shared *s,
                             int32_t unit_log2)
{
    qtri_plane plane;
    attribute_plane(&plane, a, s);
    set_plane(p, &plane);
    const uint32_t k = set_slope(p, &plane, a, s);
    return log2_below(k) - (p->down + p->up + 1 + unit_log2) * 256;
}

static int32_t set_color(qtri_job *job, int i, const qtri_attributes v[3], const shared *s)
{
    const bool light = job->first == QTRI_U - 1;
    qtri_perspective *p = &job->color.perspective;
    qtri_projected *a = &job->attribute[i].projected;
    uint32_t f[3];
    qtri_job_color(f, job, v, i);
    p->least[i] = INT32_MAX;
    p->greatest[i] = 0;
    for (int k = 0; k < 3; k++) {
        p->least[i] = qtri_least32(p->least[i], (int32_t)f[k]);
        p->greatest[i] = qtri_greatest32(p->greatest[i], (int32_t)f[k]);
        f[k] <<= QTRI_COLOR_PERSPECTIVE_SHIFT;
    }
    a->up = -QTRI_COLOR_PERSPECTIVE_SHIFT;
    const int32_t k_log2 = set_attribute(a, f, s, color_unit_log2(job->raster, light));
    a->up = 0; /* once they are held to the vertices' */
    a->bias = color_bias(job->raster, light);
    return k_log2;
}

static int32_t set_texels(qtri_job *job, int i, const uint32_t value[3], const shared *s)
{
    const qtri_texel_axis *axis = &job->axis[i];
    qtri_projected *a = &job->attribute[QTRI_U + i].projected;
    a->up = axis->up;
    const int32_t k_log2 = set_attribute(a, value, s, axis->shift);
    const uint32_t bias =
        (uint32_t)((int32_t)axis->bias >> 2); /* blocks have a quarter of values */
    a->up = (int8_t)(axis->up + 2);
    a->bias = bias + (bias == 0);
    return k_log2;
}

/*
 * By how many bits 1/w may grow and still be 2^31 or less wherever the triangle meets the frame:
 * the plane is greatest in a corner of the rectangle where their bounds do, to which chunks add
 * pixels at both sides that are computed and not drawn. Slopes must grow as well. Neither scissor
 * nor band is asked.
 */
static int32_t room_above(const qtri_fine_plane *q, const qtri_job *job, const qtri_triangle *t)
{
    const qtri_surface *surface = job->raster->surface;
    const int64_t dx = qtri_wrap64(q->dx);
    const int64_t dy = qtri_wrap64(q->dy);
    const int32_t end = surface->width - 1 + QTRI_BATCH;
    const int32_t x = qtri_hold32((dx < 0 ? t->x_least : t->x_greatest) >> 8, -QTRI_BATCH, end);
    const int32_t y = dy < 0 ? qtri_hold32(t->top->y_24p8 >> 8, 0, surface->height - 1)
                             : qtri_hold32(t->bottom->y_24p8 >> 8, 0, surface->height - 1);
    const uint64_t columns = (uint64_t)(uint32_t)(t->x_greatest - t->x_least) / 256 + 1;
    const uint64_t rows = (uint64_t)(uint32_t)(t->bottom->y_24p8 - t->top->y_24p8) / 256 + 1;
    if ((qtri_magnitude64(dx) >> 30) * columns + (qtri_magnitude64(dy) >> 30) * rows >= (uint64_t)1
                                                                                            << 32) {
        return 0; /* of steep ones that corner may be out of reach */
    }
    const int64_t most = qtri_wrap64(qtri_fine_plane_at(q, x, y));
    if (most <= 0) {
        return 0;
    }
    const uint64_t all = (uint64_t)most | qtri_magnitude64(dx) | qtri_magnitude64(dy);
    return qtri_hold32(qtri_clz64(all) - 3, 0, 14);
}

/* inv_w: its plane, and how it changes along rows. */
static void set_inv_w(qtri_job *job, const qtri_triangle *t, shared *s)
{
    qtri_perspective *p = &job->color.perspective;
    qtri_plane plane;
    if (s->fine) {
        qtri_fine_plane fine;
        int64_t there_q8[3];
        fine_plane(&fine, s, there_q8, s->q, s->q_low);
        for (int i = 0; i < 3; i++) {
            s->q_there[i] = there_q8[i] < 256 ? 1 : (uint32_t)(there_q8[i] >> 8);
        }
        s->up = room_above(&fine, job, t);
        coarse(&plane, &fine, s->up);
    } else {
        qtri_plane_init(&plane, s->gradient, s->q_there);
    }
    set_plane(&job->attribute[job->end].projected, &plane);
    const int64_t dx = qtri_wrap64(plane.dx);
    const uint64_t steep = qtri_magnitude64(dx);
    const int32_t cut = qtri_greatest32(49 - qtri_clz64(steep), 0); /* to 15 bits */
    s->q_dx = (int32_t)(uint32_t)((plane.dx + 0x8000u) >> 16);
    s->q_steep = steep >> 47 != 0 ? 0x80000000u : (uint32_t)(steep >> 16) + 1;
    p->slope = (int32_t)(dx >> cut);
    p->slope_exponent = cut - 47;
}

/*
 * Below this blocks are single pixels: 2^16, and where slopes would be shifted left by more than
 * 30. Those of slivers may be anywhere. least_down: of the slopes.
 */
static uint32_t floor_of(int32_t least_down)
{
    const int32_t zeros = qtri_least32(15, (30 + least_down) >> 1);
    return zeros < 0 ? UINT32_MAX : (uint32_t)1 << (31 - zeros);
}

void qtri_perspective_init(qtri_job *job, const qtri_triangle *triangle, const qtri_attributes v[3],
                           const uint32_t value[2][3], const uint32_t q[3],
                           const qtri_gradient *gradient, const qtri_unsnapped *unsnapped)
{
    qtri_perspective *p = &job->color.perspective;
    shared s;
    int32_t colors_log2 = INT32_MIN / 2;
    int32_t texels_log2 = INT32_MIN / 2;
    int32_t least_down = INT8_MAX;
    set_shared(&s, triangle, v, q, gradient, unsnapped);
    set_inv_w(job, triangle, &s);
    p->up = (uint8_t)s.up;
    p->moved = unsnapped->is_on ? 1 : 0;
    for (int i = job->first; i < job->end; i++) {
        if (i < QTRI_U) {
            colors_log2 = qtri_greatest32(colors_log2, set_color(job, i, v, &s));
        } else {
            texels_log2 =
                qtri_greatest32(texels_log2, set_texels(job, i - QTRI_U, value[i - QTRI_U], &s));
        }
        least_down = qtri_least32(least_down, job->attribute[i].projected.down);
    }
    const uint32_t q_floor = floor_of(least_down);
    if (job->first < QTRI_U) {
        set_limits(p->colors, &s, false, false, colors_log2, q_floor);
    }
    if (job->end > QTRI_U) {
        /* A bend that is cut off adds up to 2^(2 l + 1) of a unit, a twist to more. */
        const int32_t bits = qtri_least32(job->axis[0].shift + job->axis[0].up,
                                          job->axis[1].shift + job->axis[1].up);
        const bool twisted = bits >= 20;
        p->texels_twisted = twisted ? QTRI_TWISTED_LOG2 : QTRI_BLOCK_LOG2 + 1;
        set_limits(p->texels, &s, true, twisted, texels_log2, q_floor);
        for (int32_t l = 0; l < QTRI_BLOCK_LOG2; l++) {
            p->texels[l] = 2 * l + 12 > bits ? UINT32_MAX : p->texels[l];
        }
    }
}
