/* SPDX-License-Identifier: MIT */
/*
 * Light by pixel, along rows of large triangles. Light is found for samples of a row: its first
 * pixel, every eighth from there (the sixteenth where there are no highlights), and its last.
 * Colours between two are linear where light is: its second difference D tells, from the samples on
 * both sides. What bends smoothly is off by D/8 there, and what has a kink, as where a surface
 * turns away from a source, by D/2 at most. Elsewhere samples are found halfway until that is
 * straight, or there is one for every pixel.
 *
 * Rows count from their span's left end, not from what a scissor or a band leaves, and all samples
 * are pixels that the triangle covers: so pixels do not depend on either, and w is never 0.
 */
#include "pixel_light.h"

#include "../bits/reciprocal.h"
#include "../frame/pixel.h"
#include "../geometry/lit_point.h"
#include "list.h"
#include "mipmap.h"
#include "setup.h"
#include "span.h"
#include "textured_span.h"

enum {
    SHARP_LOG2 = 3, /* of pixels from sample to sample, of which a chunk has a whole number: */
    DULL_LOG2 = 4,  /*   with highlights or edges of light, and without */
    BLOCK_MAX = 1 << DULL_LOG2,
    TOLERANCE_565 = 1 << 16, /* of D: a step of red, two of green */
    TOLERANCE_888 = 2 << 16
};

#define ONE_Q30 ((int32_t)1 << 30)

/* 2^30 / n, rounded down. */
static const int32_t inverse_q30[BLOCK_MAX + 1] = {
    ONE_Q30,      ONE_Q30,      ONE_Q30 / 2,  ONE_Q30 / 3,  ONE_Q30 / 4,  ONE_Q30 / 5,
    ONE_Q30 / 6,  ONE_Q30 / 7,  ONE_Q30 / 8,  ONE_Q30 / 9,  ONE_Q30 / 10, ONE_Q30 / 11,
    ONE_Q30 / 12, ONE_Q30 / 13, ONE_Q30 / 14, ONE_Q30 / 15, ONE_Q30 / 16};

/* ---- A triangle ---- */

/* Places in one scale, that of the farthest, and what corners 1 and 2 differ in from corner 0. */
static void set_corners(qtri_pixel_light *p)
{
    qtri_lit_corner *c = p->corner;
    const int32_t exponent =
        qtri_greatest32(c[0].exponent, qtri_greatest32(c[1].exponent, c[2].exponent));
    uint32_t all = 1;
    uint32_t turns = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t down = qtri_least32(exponent - c[i].exponent, 31);
        c[i].exponent = exponent;
        for (int k = 0; k < 3; k++) {
            c[i].place[k] >>= down;
        }
    }
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 2; i++) { /* places are within 2^29 of 0, directions within 2^14.1 */
            p->across[i][k] = c[i + 1].place[k] - c[0].place[k];
            p->turn_q14[i][k] = c[i + 1].normal_q14[k] - c[0].normal_q14[k];
            all |= qtri_magnitude32(p->across[i][k]);
            turns |= (uint32_t)p->turn_q14[i][k];
        }
    }
    p->up = qtri_greatest32(qtri_clz32(all) - 2, 0);
    for (int k = 0; k < 3; k++) { /* 2^30 itself, at up = 0, is one less */
        p->across[0][k] = qtri_hold32(p->across[0][k], -ONE_Q30, ONE_Q30 - 1) * (1 << p->up);
        p->across[1][k] = qtri_hold32(p->across[1][k], -ONE_Q30, ONE_Q30 - 1) * (1 << p->up);
    }
    p->one_normal = turns == 0;
    p->one_color = c[0].color.r == c[1].color.r && c[0].color.g == c[1].color.g &&
                   c[0].color.b == c[1].color.b && c[0].color.r == c[2].color.r &&
                   c[0].color.g == c[2].color.g && c[0].color.b == c[2].color.b;
}

/* 1/w with one exponent, the largest in 2^30..2^31. False when all are equal. */
static bool align(uint32_t q[3], const qtri_attributes v[3])
{
    int32_t most = qtri_greatest32(v[0].inv_w_exponent, v[1].inv_w_exponent);
    most = qtri_greatest32(most, v[2].inv_w_exponent);
    for (int i = 0; i < 3; i++) {
        const uint32_t down = (uint32_t)most - (uint32_t)v[i].inv_w_exponent;
        q[i] = down > 29 ? 1 : v[i].inv_w_q31 >> down;
    }
    return q[0] != q[1] || q[0] != q[2];
}

static void set_planes(qtri_pixel_light *p, const qtri_raster *raster,
                       const qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_gradient gradient;
    uint32_t q[3];
    uint32_t f[3];
    qtri_gradient_place(&gradient, triangle);
    qtri_gradient_init(&gradient, triangle->extent);
    p->divided = QTRI_WITH_PERSPECTIVE && raster->perspective && align(q, v);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++) {
            const uint32_t share_q30 = (uint32_t)v[i].color[k];
            f[i] = p->divided ? (uint32_t)(qtri_mul_u32(q[i], share_q30) >> 30) : share_q30;
        }
        qtri_plane_init(&p->share[k], &gradient, f);
    }
    if (p->divided) {
        qtri_plane_init(&p->q, &gradient, q);
        p->least = q[0] < q[1] ? q[0] : q[1];
        p->least = q[2] < p->least ? q[2] : p->least;
        p->greatest = q[0] > q[1] ? q[0] : q[1];
        p->greatest = q[2] > p->greatest ? q[2] : p->greatest;
    }
    p->sample[0].x = INT32_MIN;
}

/* ---- A pixel ---- */

static uint64_t plane_at(const qtri_plane *plane, int32_t x, int32_t y)
{
    return qtri_plane_column(qtri_plane_row(plane, y), plane->dx, x);
}

/* A plane's value, held to 0..most, in 2^-16 of the unit. */
static uint64_t held(uint64_t value, uint32_t least, uint32_t most)
{
    const int64_t whole = qtri_plane_floor(value);
    return whole < (int64_t)least   ? (uint64_t)least << 16
           : whole >= (int64_t)most ? (uint64_t)most << 16
                                    : value;
}

/* Shares of corners 1 and 2: below 2^30, as is their sum. */
static void find_shares(int32_t b_q30[2], const qtri_pixel_light *p, int32_t x, int32_t y)
{
    const uint64_t one = plane_at(&p->share[0], x, y);
    const uint64_t two = plane_at(&p->share[1], x, y);
    uint32_t b[2];
    if (p->divided) {
        const uint64_t q = held(plane_at(&p->q, x, y), p->least, p->greatest); /* >= 2^16 */
        const int32_t zeros = qtri_clz64(q | 1);
        const uint32_t most = (uint32_t)(q >> 16);
        const uint32_t reciprocal = qtri_reciprocal_near((uint32_t)((q << zeros) >> 32));
        /* s 2^32 / q with s <= q: (s 2^zeros) (2^62 / (q 2^zeros)) / 2^32 is below 2^30 + 2^4. */
        b[0] = qtri_mul_high32((uint32_t)((held(one, 0, most) << zeros) >> 32), reciprocal);
        b[1] = qtri_mul_high32((uint32_t)((held(two, 0, most) << zeros) >> 32), reciprocal);
    } else {
        b[0] = (uint32_t)(held(one, 0, ONE_Q30 - 1) >> 16);
        b[1] = (uint32_t)(held(two, 0, ONE_Q30 - 1) >> 16);
    }
    b_q30[0] = qtri_least32((int32_t)b[0], ONE_Q30 - 1);
    b_q30[1] = qtri_least32((int32_t)b[1], ONE_Q30 - 1 - b_q30[0]);
}

/* Products are of an element within 2^30 and shares whose sum is less than 1. */
static void set_place(qtri_lit_point *point, const qtri_pixel_light *p, const int32_t b_q30[2])
{
    point->exponent = p->corner[0].exponent;
    for (int k = 0; k < 3; k++) {
        const int32_t way = qtri_mul_high_s30(p->across[0][k], b_q30[0]) +
                            qtri_mul_high_s30(p->across[1][k], b_q30[1]); /* <= 2^28 */
        point->place[k] =
            p->corner[0].place[k] + (p->up >= 2 ? way >> (p->up - 2) : way * (4 >> p->up));
    }
}

/*
 * The normals' mean is shorter than they are. Near 1 a step of Newton is enough, as in lit_point.h.
 */
static void set_normal(qtri_lit_point *point, const qtri_pixel_light *p, const int32_t b_q30[2])
{
    const uint32_t one_q28 = (uint32_t)1 << 28;
    const int32_t b1 = b_q30[0] >> 15;
    const int32_t b2 = b_q30[1] >> 15;
    int32_t *n = point->normal_q14;
    for (int k = 0; k < 3; k++) {
        n[k] = p->corner[0].normal_q14[k];
        if (!p->one_normal) { /* two unit vectors differ by 2^15.01, so that sums fit */
            n[k] += (p->turn_q14[0][k] * b1 + p->turn_q14[1][k] * b2) >> 15;
        }
    }
    if (p->one_normal) {
        return;
    }
    const uint32_t square =
        (uint32_t)(n[0] * n[0]) + (uint32_t)(n[1] * n[1]) + (uint32_t)(n[2] * n[2]);
    if (square - (one_q28 - one_q28 / 32) < one_q28 / 16) {
        const int32_t factor_q15 = (int32_t)((3 * one_q28 - square) >> 14);
        for (int k = 0; k < 3; k++) {
            n[k] = (n[k] * factor_q15 + 0x4000) >> 15;
        }
    } else if (square != 0) {
        const int32_t v[3] = {n[0], n[1], n[2]};
        qtri_normalize_q14(n, v, square);
    }
}

/* A channel of a colour, 8.8, in the light, n.16: sums are as in qtri_reflect(). */
static uint32_t reflected_8p16(uint32_t base_q15, uint32_t diffuse_q24, uint32_t specular_q24,
                               uint32_t color_8p8, uint32_t highlight)
{
    const uint32_t diffuse_q15 = diffuse_q24 >> 9;
    const uint32_t sum_q15 = base_q15 - 0x4000 + diffuse_q15 * (color_8p8 >> 8) +
                             (diffuse_q15 * (color_8p8 & 255) >> 8) +
                             (specular_q24 >> 9) * highlight;
    const uint32_t most_q15 = (uint32_t)255 << 15;
    return (sum_q15 < most_q15 ? sum_q15 : most_q15) << 1;
}

/* A channel of the corners' colours, 8.8. */
static uint32_t color_8p8(const qtri_pixel_light *p, uint8_t c0, uint8_t c1, uint8_t c2,
                          const int32_t b_q30[2])
{
    if (p->one_color) {
        return (uint32_t)c0 << 8;
    }
    const int32_t more = (c1 - c0) * (b_q30[0] >> 14) + (c2 - c0) * (b_q30[1] >> 14);
    return (uint32_t)((c0 << 8) + (more >> 8));
}

/* The point with these shares, as the raster's channels. */
QTRI_NOINLINE static void find_light(int32_t channel[3], const qtri_pixel_light *p,
                                     const qtri_raster *raster, const int32_t b_q30[2])
{
    const qtri_illumination *by = p->by;
    const qtri_colors *units = raster->units;
    const qtri_lit_corner *c = p->corner;
    qtri_lit_point point;
    set_place(&point, p, b_q30);
    set_normal(&point, p, b_q30);
    qtri_gather_light(by, &point);
    const uint32_t red = reflected_8p16(
        by->base_q15[0], point.diffuse_q24[0], point.specular_q24[0],
        color_8p8(p, c[0].color.r, c[1].color.r, c[2].color.r, b_q30), by->specular.r);
    const uint32_t green = reflected_8p16(
        by->base_q15[1], point.diffuse_q24[1], point.specular_q24[1],
        color_8p8(p, c[0].color.g, c[1].color.g, c[2].color.g, b_q30), by->specular.g);
    const uint32_t blue = reflected_8p16(
        by->base_q15[2], point.diffuse_q24[2], point.specular_q24[2],
        color_8p8(p, c[0].color.b, c[1].color.b, c[2].color.b, b_q30), by->specular.b);
    channel[0] = (int32_t)qtri_channel_scaled(red, units->ratio_q30[0]);
    channel[1] = (int32_t)qtri_channel_scaled(green, units->ratio_q30[1]);
    channel[2] = (int32_t)qtri_channel_scaled(blue, units->ratio_q30[2]);
    if (units->single) {
        channel[2] += channel[0] + channel[1];
        channel[0] = 0;
        channel[1] = 0;
    }
}

/* ---- A row ---- */

/* A row on its way: blocks of it from sample to sample. */
typedef struct walk {
    const qtri_scanline *row;
    qtri_pixel_light *light;
    int32_t x, end;    /* of the batch's pixels, the first and after the last */
    int32_t last;      /* the span's last pixel */
    int32_t block;     /* pixels from sample to sample */
    int32_t tolerance; /* of a second difference */
} walk;

static void find_sample(qtri_lit_sample *out, const walk *w, int32_t x)
{
    int32_t b_q30[2];
    find_shares(b_q30, w->light, x, w->row->y);
    find_light(out->c, w->light, w->row->job->raster, b_q30);
    out->x = x;
    out->y = w->row->y;
}

/* Pixels from sample a to before b, and b itself where it is the last of its span. */
static void emit(const walk *w, const qtri_lit_sample *a, const qtri_lit_sample *b)
{
    const qtri_raster *raster = w->row->job->raster;
    const int32_t length = b->x - a->x;
    const int32_t count = b->x == w->last && b->x < w->end ? length + 1 : length;
    const int32_t inverse = inverse_q30[length];
    uint32_t *color = raster->batch->color + (a->x - w->x);
    qtri_curve curve[3];
    for (int i = 0; i < 3; i++) { /* within 2^24, so that products are within 2^54 */
        curve[i].at = (uint32_t)a->c[i] + 0x8000u;
        const int32_t change = b->c[i] - a->c[i];
        curve[i].step =
            (uint32_t)(length == w->block ? change >> w->light->block_log2
                                          : (int32_t)(qtri_mul_s32(change, inverse) >> 30));
        curve[i].bend = 0;
        curve[i].twist = 0;
    }
    if (raster->texture != NULL) {
        qtri_multiply_some(raster, color, curve, count);
    } else {
        raster->format->colors->smooth(color, raster->units->single ? &curve[2] : curve, count);
    }
}

/* Whether what lies halfway between a and b is off the line between them by `most` at most. */
static bool is_straight(const qtri_lit_sample *a, const qtri_lit_sample *middle,
                        const qtri_lit_sample *b, int32_t most)
{
    const int32_t share = inverse_q30[b->x - a->x] >> 15; /* Q15 of 1 / length */
    uint32_t off = 0;
    for (int i = 0; i < 3; i++) {
        const int32_t way = (((b->c[i] - a->c[i]) >> 9) * (share * (middle->x - a->x))) >> 6;
        const uint32_t differ = qtri_magnitude32(middle->c[i] - a->c[i] - way);
        off = differ > off ? differ : off;
    }
    return off <= (uint32_t)most;
}

/*
 * Halves of what is not straight, from left to right. Part n is at most 2^(DULL_LOG2 - n) long, so
 * the last that there is room for is a pixel.
 */
QTRI_NOINLINE static void emit_bent(const walk *w, const qtri_lit_sample *a,
                                    const qtri_lit_sample *b)
{
    qtri_lit_sample at = *a;
    qtri_lit_sample end[DULL_LOG2 + 1]; /* of parts, the nearest last */
    bool bent[DULL_LOG2 + 1];
    int count = 1;
    end[0] = *b;
    bent[0] = true;
    while (count != 0) {
        const qtri_lit_sample *to = &end[count - 1];
        if (!bent[count - 1] || to->x - at.x < 2) {
            emit(w, &at, to);
            at = *to;
            count--;
            continue;
        }
        find_sample(&end[count], w, (at.x + to->x) >> 1);
        bent[count] = !is_straight(&at, &end[count], to, w->tolerance / 2);
        bent[count - 1] = bent[count];
        count++;
    }
}

/*
 * Whether the line bends at b, where a whole block from a ends and the next begins, which may be
 * the last one and shorter.
 */
static bool is_bent(const walk *w, const qtri_lit_sample *a, const qtri_lit_sample *b,
                    const qtri_lit_sample *c)
{
    const uint32_t tolerance = (uint32_t)w->tolerance;
    const int32_t length = c->x - b->x;
    if (length == w->block) {
        uint32_t far = 0;
        for (int i = 0; i < 3; i++) {
            const int32_t differ = c->c[i] - 2 * b->c[i] + a->c[i];
            far |= (uint32_t)(differ + (int32_t)tolerance) > 2 * tolerance;
        }
        return far != 0;
    }
    for (int i = 0; i < 3; i++) { /* changes below 2^25 */
        const int32_t after =
            (int32_t)(qtri_mul_s32(c->c[i] - b->c[i], inverse_q30[length]) >> 30) * w->block;
        if (qtri_magnitude32(after - (b->c[i] - a->c[i])) > tolerance) {
            return true;
        }
    }
    return false;
}

/*
 * At an end of its span a block has no neighbour to tell: it may bend where it changes by more than
 * a little. What few pixels change by is rather a slope.
 */
static bool may_bend(const walk *w, const qtri_lit_sample *a, const qtri_lit_sample *b)
{
    const int32_t length = b->x - a->x;
    const uint32_t little = (uint32_t)w->tolerance * (length <= BLOCK_MAX / 2 ? 4 : 2);
    uint32_t most = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t change = qtri_magnitude32(b->c[i] - a->c[i]);
        most = change > most ? change : most;
    }
    return most > little;
}

/* The span's next sample; that at x, its last one, again. */
static void next_sample(qtri_lit_sample *out, const walk *w, const qtri_lit_sample *at)
{
    if (at->x == w->last) {
        *out = *at;
    } else {
        find_sample(out, w, qtri_least32(at->x + w->block, w->last));
    }
}

/* Colours of a chunk, whose samples begin with its first pixel: block by block. */
static void shade(qtri_scanline *row, int32_t x, int32_t count)
{
    const qtri_raster *raster = row->job->raster;
    qtri_pixel_light *p = raster->lit;
    const walk w = {row,
                    p,
                    x,
                    x + count,
                    row->right - 1,
                    (int32_t)1 << p->block_log2,
                    raster->units == &qtri_colors_565 ? TOLERANCE_565 : TOLERANCE_888};
    qtri_lit_sample *from = &p->sample[0];
    qtri_lit_sample *to = &p->sample[1];
    qtri_lit_sample *after = &p->sample[2];
    bool bends;                              /* at `from` */
    if (from->x != x || from->y != row->y) { /* it does not go on where the last chunk ended */
        find_sample(from, &w, x);
        next_sample(to, &w, from);
        p->bends = false;
        if (x > row->left && from->x != to->x) {
            find_sample(after, &w, x - w.block);
            p->bends = is_bent(&w, after, from, to);
        }
    }
    bends = p->bends;
    do {
        const bool is_first = from->x == row->left;
        const bool is_last = to->x == w.last;
        const bool bent_before = bends;
        next_sample(after, &w, to);
        bends = !is_last && is_bent(&w, from, to, after);
        if (bent_before || bends ||
            ((is_first || is_last) &&
             (may_bend(&w, from, to) || (is_first && is_last && to->x - from->x > w.block / 4)))) {
            emit_bent(&w, from, to);
        } else {
            emit(&w, from, to);
        }
        qtri_lit_sample *const used = from;
        from = to;
        to = after;
        after = used;
    } while (from->x < w.end && from->x < w.last);
    const qtri_lit_sample next[2] = {*from, *to};
    p->sample[0] = next[0];
    p->sample[1] = next[1];
    p->bends = bends;
}

/* ---- Draw calls ---- */

static void pass_on(const qtri_raster *raster, qtri_triangle *triangle, const qtri_attributes v[3])
{
    const qtri_route next = raster->lit->next;
    if (next != NULL) {
        next(raster, triangle, v);
    } else {
        qtri_triangle_draw_plain(raster, triangle, v);
    }
}

/* Where light is the same all over the triangle: colours of the vertices alone. */
QTRI_NOINLINE static void draw_even(const qtri_raster *raster, qtri_triangle *triangle,
                                    const qtri_attributes v[3])
{
    qtri_attributes lit[3] = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++) {
        const int32_t b_q30[2] = {qtri_least32(v[i].color[0], ONE_Q30 - 1),
                                  qtri_least32(v[i].color[1], ONE_Q30 - 1)};
        find_light(lit[i].color, raster->lit, raster, b_q30);
    }
    pass_on(raster, triangle, lit);
}

/* Jobs of the raster's copy have one colour. */
QTRI_NOINLINE static void draw_uneven(const qtri_raster *raster, qtri_triangle *triangle,
                                      const qtri_attributes v[3])
{
    qtri_raster lit = *raster;
    lit.by_pixel = true;
    lit.smooth = false;
    lit.fill_flat = qtri_span_fill;
    lit.copied = false;
    set_planes(raster->lit, raster, triangle, v);
    qtri_raster *owner = qtri_levels_lend(&lit);
    pass_on(&lit, triangle, v);
    qtri_levels_return(owner, &lit);
}

static void draw(const qtri_raster *raster, qtri_triangle *triangle, const qtri_attributes v[3])
{
    triangle->tinted = false;
    qtri_list_flush(raster); /* what waits is of this raster */
    set_corners(raster->lit);
    if (raster->lit->everywhere && raster->lit->one_normal) {
        draw_even(raster, triangle, v);
    } else {
        draw_uneven(raster, triangle, v);
    }
}

void qtri_pixel_light_set(const qtri_raster *raster, int i, const qtri_lit_point *point,
                          const qtri_rgb *color)
{
    qtri_lit_corner *corner = &raster->lit->corner[i];
    corner->color = *color;
    corner->exponent = point->exponent;
    for (int k = 0; k < 3; k++) {
        corner->place[k] = point->place[k];
        corner->normal_q14[k] = point->normal_q14[k];
    }
}

void qtri_pixel_light_run(qtri_raster *raster, const qtri_illumination *by, qtri_lit_body body,
                          void *with)
{
    qtri_pixel_light light;
    light.shade = shade;
    light.by = by;
    light.next = raster->route;
    light.everywhere = true;
    light.block_log2 = by->shininess != NULL ? SHARP_LOG2 : DULL_LOG2;
    for (int32_t i = 0; i < by->count; i++) {
        light.everywhere &= by->run[i].kind->everywhere;
        light.block_log2 = by->run[i].kind->has_edges ? SHARP_LOG2 : light.block_log2;
    }
    raster->route = draw;
    raster->lit = &light;
    body(with);
    raster->route = light.next;
    raster->lit = NULL;
}
