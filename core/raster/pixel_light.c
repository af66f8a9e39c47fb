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

#define ONE_Q30 QTRI_LIT_ONE_Q30

/* 2^30 / n, rounded down. */
static const int32_t inverse_q30[BLOCK_MAX + 1] = {
    ONE_Q30,      ONE_Q30,      ONE_Q30 / 2,  ONE_Q30 / 3,  ONE_Q30 / 4,  ONE_Q30 / 5,
    ONE_Q30 / 6,  ONE_Q30 / 7,  ONE_Q30 / 8,  ONE_Q30 / 9,  ONE_Q30 / 10, ONE_Q30 / 11,
    ONE_Q30 / 12, ONE_Q30 / 13, ONE_Q30 / 14, ONE_Q30 / 15, ONE_Q30 / 16};

static void set_planes(qtri_pixel_light *p, const qtri_raster *raster,
                       const qtri_triangle *triangle, const qtri_attributes v[3])
{
    qtri_gradient gradient;
    uint32_t q[3];
    uint32_t f[3];
    qtri_gradient_place(&gradient, triangle);
    qtri_gradient_init(&gradient, triangle->extent);
    p->divided = QTRI_WITH_PERSPECTIVE && raster->perspective && qtri_align_inv_w(q, v);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++) {
            const uint32_t share_q30 = (uint32_t)v[i].color[k];
            f[i] = p->divided ? (uint32_t)(qtri_mul_u32(q[i], share_q30) >> 30) : share_q30;
        }
        qtri_plane_init(&p->share[k], &gradient, f);
    }
    if (p->divided) {
        qtri_plane_init(&p->q, &gradient, q);
        qtri_find_range(&p->least, &p->greatest, q);
    }
    p->sample[0].x = INT32_MIN;
}

/* ---- A sample ---- */

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
        // NOLINTNEXTLINE(clang-analyzer-core.*): q | 1 is not 0, so zeros are at most 63
        b[0] = qtri_mul_high32((uint32_t)((held(one, 0, most) << zeros) >> 32), reciprocal);
        b[1] = qtri_mul_high32((uint32_t)((held(two, 0, most) << zeros) >> 32), reciprocal);
    } else {
        b[0] = (uint32_t)(held(one, 0, ONE_Q30 - 1) >> 16);
        b[1] = (uint32_t)(held(two, 0, ONE_Q30 - 1) >> 16);
    }
    b_q30[0] = qtri_least32((int32_t)b[0], ONE_Q30 - 1);
    b_q30[1] = qtri_least32((int32_t)b[1], ONE_Q30 - 1 - b_q30[0]);
}

static void find_channels(int32_t channel[3], const qtri_pixel_light *p, const qtri_raster *raster,
                          const int32_t b_q30[2])
{
    const qtri_colors *units = raster->units;
    uint32_t color_8p16[3];
    qtri_lit_color(color_8p16, &p->lit, b_q30);
    for (int i = 0; i < 3; i++) {
        channel[i] = (int32_t)qtri_channel_scaled(color_8p16[i], units->ratio_q30[i]);
    }
    if (units->single) {
        channel[2] += channel[0] + channel[1];
        channel[0] = 0;
        channel[1] = 0;
    }
}

static void find_sample_at(qtri_lit_sample *out, const qtri_pixel_light *p,
                           const qtri_raster *raster, int32_t x, int32_t y)
{
    int32_t b_q30[2];
    find_shares(b_q30, p, x, y);
    find_channels(out->c, p, raster, b_q30);
    out->x = x;
    out->y = y;
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
    find_sample_at(out, w->light, w->row->job->raster, x, w->row->y);
}

/*
 * Pixels from sample a to before b, and b itself where it is the last of its span: one at least, as
 * stages ask for. Samples are of one span, so a is b only at its last pixel.
 */
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
    bool bends; /* at `from` */
    if (from->x != x || from->y != row->y || p->left != row->left || p->right != row->right) {
        /* The chunk does not go on where the last one ended. */
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
    p->left = row->left;
    p->right = row->right;
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
        find_channels(lit[i].color, raster->lit, raster, b_q30);
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
    qtri_lit_set_corners(&raster->lit->lit);
    if (raster->lit->lit.everywhere && raster->lit->lit.one_normal) {
        draw_even(raster, triangle, v);
    } else {
        draw_uneven(raster, triangle, v);
    }
}

void qtri_pixel_light_set(const qtri_raster *raster, int i, const qtri_lit_point *point,
                          const qtri_rgb *color)
{
    qtri_lit_set_corner(&raster->lit->lit, i, point, color);
}

void qtri_pixel_light_run(qtri_raster *raster, const qtri_illumination *by, qtri_lit_body body,
                          void *with)
{
    qtri_pixel_light light;
    light.shade = shade;
    light.lit.by = by;
    light.next = raster->route;
    light.lit.everywhere = true;
    light.block_log2 = by->shininess != NULL ? SHARP_LOG2 : DULL_LOG2;
    for (int32_t i = 0; i < by->count; i++) {
        light.lit.everywhere &= by->run[i].kind->everywhere;
        light.block_log2 = by->run[i].kind->has_edges ? SHARP_LOG2 : light.block_log2;
    }
    raster->route = draw;
    raster->lit = &light;
    body(with);
    raster->route = light.next;
    raster->lit = NULL;
}
