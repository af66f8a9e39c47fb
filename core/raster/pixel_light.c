/* SPDX-License-Identifier: MIT */
/*
 * Light is found for samples of a row: its first pixel, every eighth from there (the sixteenth
 * where there are no highlights), and its last. Colours between two are linear where light is: its
 * second difference D tells, from the samples on both sides. What bends smoothly is off by D/8
 * there, and what has a kink, as where a surface turns away from a source, by D/2 at most.
 * Elsewhere samples are found halfway until that is straight, or there is one for every pixel.
 *
 * Rows count from their span's left end, not from what a scissor or a band leaves, and all samples
 * are pixels that the triangle covers: so pixels do not depend on either, and w is never 0.
 */
#include "pixel_light.h"

#include "../bits/bits.h"

/* Light on a triangle of a mesh -----------------------------------------------------------------
 */

#define ONE_Q30 QTRI_LIT_ONE_Q30

/* What a line may be off by beyond the tolerance where a polynomial replaces it, 2^-7 of a step of
   255: a kink near a corner leaves three halves of the line's error. */
enum { QUADRATIC_MORE = 4 << 7 };

void qtri_lit_set_corner(qtri_lit_triangle *p, int i, const qtri_lit_point *point,
                         const qtri_rgb *color)
{
    qtri_lit_corner *corner = &p->corner[i];
    corner->color = *color;
    p->is_quadratic = false;
    corner->exponent = point->exponent;
    for (int k = 0; k < 3; k++) {
        corner->place[k] = point->place[k];
        corner->normal_q14[k] = point->normal_q14[k];
    }
}

/* Brings positions to one exponent, that of the farthest; sets one_color. */
static void align_corners(qtri_lit_triangle *p)
{
    qtri_lit_corner *c = p->corner;
    const int32_t exponent =
        qtri_greatest32(c[0].exponent, qtri_greatest32(c[1].exponent, c[2].exponent));
    for (int i = 0; i < 3; i++) {
        const int32_t down = qtri_least32(exponent - c[i].exponent, 31);
        c[i].exponent = exponent;
        for (int k = 0; k < 3; k++) {
            c[i].place[k] >>= down;
        }
    }
    p->one_color = c[0].color.r == c[1].color.r && c[0].color.g == c[1].color.g &&
                   c[0].color.b == c[1].color.b && c[0].color.r == c[2].color.r &&
                   c[0].color.g == c[2].color.g && c[0].color.b == c[2].color.b;
}

/* Brings positions to one exponent, and sets corners 1 and 2 less corner 0. */
static void set_corners(qtri_lit_triangle *p)
{
    const qtri_lit_corner *c = p->corner;
    uint32_t all = 1, turns = 0;
    align_corners(p);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 2; i++) { /* places are within 2^29 of 0, directions within 2^14.1 */
            p->across[i][k] = c[i + 1].place[k] - c[0].place[k];
            p->normal_delta_q14[i][k] = c[i + 1].normal_q14[k] - c[0].normal_q14[k];
            all |= qtri_magnitude32(p->across[i][k]);
            turns |= (uint32_t)p->normal_delta_q14[i][k];
        }
    }
    p->up = qtri_greatest32(qtri_clz32(all) - 2, 0);
    for (int k = 0; k < 3; k++) { /* 2^30 itself, at up = 0, is one less */
        p->across[0][k] = qtri_hold32(p->across[0][k], -ONE_Q30, ONE_Q30 - 1) * (1 << p->up);
        p->across[1][k] = qtri_hold32(p->across[1][k], -ONE_Q30, ONE_Q30 - 1) * (1 << p->up);
    }
    p->one_normal = turns == 0;
}

/* The position with these shares of corners 1 and 2. Products are of an element within 2^30 and
   shares whose sum is less than 1. */
static void set_place(qtri_lit_point *point, const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    point->exponent = p->corner[0].exponent;
    for (int k = 0; k < 3; k++) {
        const int32_t way = qtri_mul_high_s30(p->across[0][k], b_q30[0]) +
                            qtri_mul_high_s30(p->across[1][k], b_q30[1]); /* <= 2^28 */
        point->place[k] =
            p->corner[0].place[k] + (p->up >= 2 ? way >> (p->up - 2) : way * (4 >> p->up));
    }
}

/* A mean of normals is shorter than they are. Near 1 a step of Newton is enough, as in
   illumination.h. */
static void normalize(int32_t n[3])
{
    const uint32_t one_q28 = (uint32_t)1 << 28;
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

static void set_normal(qtri_lit_point *point, const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    const int32_t b1 = b_q30[0] >> 15, b2 = b_q30[1] >> 15;
    int32_t *n = point->normal_q14;
    for (int k = 0; k < 3; k++) {
        n[k] = p->corner[0].normal_q14[k];
        if (!p->one_normal) { /* two unit vectors differ by 2^15.01, so that sums fit */
            n[k] += (p->normal_delta_q14[0][k] * b1 + p->normal_delta_q14[1][k] * b2) >> 15;
        }
    }
    if (!p->one_normal) {
        normalize(n);
    }
}

/* A lit channel, 8.16, of a color in 8.8; sums are bounded as in qtri_lit_channel(). */
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
static uint32_t color_8p8(const qtri_lit_triangle *p, uint8_t c0, uint8_t c1, uint8_t c2,
                          const int32_t b_q30[2])
{
    if (p->one_color) {
        return (uint32_t)c0 << 8;
    }
    const int32_t more = (c1 - c0) * (b_q30[0] >> 14) + (c2 - c0) * (b_q30[1] >> 14);
    return (uint32_t)((c0 << 8) + (more >> 8));
}

/* The lit colour of a point, whose own colour is that of these shares of corners 1 and 2. */
static void light_point(uint32_t color_8p16[3], qtri_lit_point *point, const qtri_lit_triangle *p,
                        const int32_t b_q30[2])
{
    const qtri_illumination *by = p->by;
    const qtri_lit_corner *c = p->corner;
    qtri_gather_light(by, point);
    color_8p16[0] = reflected_8p16(by->base_q15[0], point->diffuse_q24[0], point->specular_q24[0],
                                   color_8p8(p, c[0].color.r, c[1].color.r, c[2].color.r, b_q30),
                                   by->specular.r);
    color_8p16[1] = reflected_8p16(by->base_q15[1], point->diffuse_q24[1], point->specular_q24[1],
                                   color_8p8(p, c[0].color.g, c[1].color.g, c[2].color.g, b_q30),
                                   by->specular.g);
    color_8p16[2] = reflected_8p16(by->base_q15[2], point->diffuse_q24[2], point->specular_q24[2],
                                   color_8p8(p, c[0].color.b, c[1].color.b, c[2].color.b, b_q30),
                                   by->specular.b);
}

/* The lit colour halfway between corners i and j, i < j. */
static void light_middle(uint32_t color_8p16[3], const qtri_lit_triangle *p, int i, int j)
{
    const int32_t half = QTRI_LIT_ONE_Q30 / 2;
    const qtri_lit_corner *a = &p->corner[i], *b = &p->corner[j];
    const int32_t b_q30[2] = {i == 1 || j == 1 ? half : 0, j == 2 ? half : 0};
    qtri_lit_point point;
    point.exponent = a->exponent;
    for (int k = 0; k < 3; k++) {
        point.place[k] = (a->place[k] + b->place[k]) >> 1;
        point.normal_q14[k] = (a->normal_q14[k] + b->normal_q14[k]) >> 1;
    }
    normalize(point.normal_q14);
    light_point(color_8p16, &point, p, b_q30);
}

/* A channel by its polynomial. |k| < 2^17, so that products fit. */
static uint32_t quadratic_8p16(const int32_t k[6], int32_t b1_q13, int32_t b2_q13,
                               const int32_t square_q13[3])
{
    const int32_t sum = ((k[1] * b1_q13) >> 13) + ((k[2] * b2_q13) >> 13) +
                        ((k[3] * square_q13[0]) >> 13) + ((k[4] * square_q13[1]) >> 13) +
                        ((k[5] * square_q13[2]) >> 13);
    return (uint32_t)qtri_hold32(k[0] + sum, 0, 255 << 7) << 9;
}

static void set_quadratic(uint32_t color_8p16[3], const qtri_lit_triangle *p,
                          const int32_t b_q30[2])
{
    const int32_t b1 = b_q30[0] >> 17, b2 = b_q30[1] >> 17;
    const int32_t square_q13[3] = {(b1 * b1) >> 13, (b2 * b2) >> 13, (b1 * b2) >> 13};
    for (int i = 0; i < 3; i++) {
        color_8p16[i] = quadratic_8p16(p->k[i], b1, b2, square_q13);
    }
}

/* The colour of the point with these shares, 2^30 being 1, whose sum is less: 255.0 at most. */
static void color_at(uint32_t color_8p16[3], const qtri_lit_triangle *p, const int32_t b_q30[2])
{
    if (p->is_quadratic) {
        set_quadratic(color_8p16, p, b_q30);
        return;
    }
    qtri_lit_point point;
    set_place(&point, p, b_q30);
    set_normal(&point, p, b_q30);
    light_point(color_8p16, &point, p, b_q30);
}

/* Sets the channel's polynomial; returns its second differences along the edges, or-ed. */
static uint32_t set_channel(int32_t k[6], const int32_t c[3], int32_t m01, int32_t m02, int32_t m12)
{
    k[0] = c[0];
    k[1] = 4 * m01 - c[1] - 3 * c[0];
    k[2] = 4 * m02 - c[2] - 3 * c[0];
    k[3] = 2 * (c[0] + c[1] - 2 * m01);
    k[4] = 2 * (c[0] + c[2] - 2 * m02);
    k[5] = 4 * (c[0] + m12 - m01 - m02);
    return qtri_magnitude32(k[3]) / 2 | qtri_magnitude32(k[4]) / 2 |
           qtri_magnitude32(c[1] + c[2] - 2 * m12);
}

static bool is_quadratic_at_centroid(const qtri_lit_triangle *p, int32_t tolerance)
{
    const int32_t third[2] = {QTRI_LIT_ONE_Q30 / 3, QTRI_LIT_ONE_Q30 / 3};
    uint32_t exact[3], quadratic[3];
    color_at(exact, p, third);
    set_quadratic(quadratic, p, third);
    for (int i = 0; i < 3; i++) {
        if (qtri_magnitude32((int32_t)(exact[i] - quadratic[i])) > (uint32_t)tolerance << 9) {
            return false;
        }
    }
    return true;
}

/*
 * Whether colours are linear between the corners, which show these, 0x00RRGGBB, and if not whether
 * they are quadratic: within `tolerance`, in 2^-7 of a step of 255. Sets the corners.
 *
 * A second difference D along an edge, ends and middle, is twice what the line is off in the
 * middle; inside the triangle that may be 4/3 of the most at an edge, and where light has a kink
 * near a corner twice of it.
 */
static bool is_linear(qtri_lit_triangle *p, const uint32_t corner[3], int32_t tolerance)
{
    uint32_t m[3][3];
    uint32_t second = 0;
    align_corners(p);
    light_middle(m[0], p, 0, 1);
    light_middle(m[1], p, 0, 2);
    light_middle(m[2], p, 1, 2);
    for (int i = 0; i < 3; i++) {
        int32_t c[3];
        for (int j = 0; j < 3; j++) {
            c[j] = (int32_t)(corner[j] >> (16 - 8 * i) & 255) << 7;
        }
        second |= set_channel(p->k[i], c, (int32_t)(m[0][i] >> 9), (int32_t)(m[1][i] >> 9),
                              (int32_t)(m[2][i] >> 9));
    }
    if (second < 2 * (uint32_t)tolerance) {
        return true;
    }
    set_corners(p);
    p->is_quadratic = second < 2 * (uint32_t)(tolerance + QUADRATIC_MORE) &&
                      is_quadratic_at_centroid(p, tolerance);
    return false;
}

/* Along rows ------------------------------------------------------------------------------------
 */

enum {
    SHARP_LOG2 = 3, /* pixels from sample to sample: with highlights or edges of light, */
    DULL_LOG2 = QTRI_LIGHT_BLOCK_LOG2, /* and without */
    BLOCK_MAX = 1 << DULL_LOG2,
    TOLERANCE_565 = 1 << 16, /* of D: a step of red, two of green; of weights, 8 of 256 */
    TOLERANCE_888 = 2 << 16,
    SMALL_565 = 4 << 7, /* of small triangles, of 255: half a step of red */
    SMALL_888 = 1 << 7
};

/* 2^15 / n, rounded down. */
static const int16_t inverse_q15[BLOCK_MAX + 1] = {0,    32767, 16384, 10922, 8192, 6553,
                                                   5461, 4681,  4096,  3640,  3276, 2978,
                                                   2730, 2520,  2340,  2184,  2048};

/* c / n, |c| < 2^25. */
static inline int32_t part_of(int32_t c, int32_t n)
{
    return ((c >> 9) * inverse_q15[n]) >> 6;
}

static inline qtri_large_light *light_of(const qtri_large *t)
{
    return (qtri_large_light *)(void *)t->state->light_walk;
}

/* The triangle --------------------------------------------------------------------------------- */

static void set_tolerance(qtri_large_light *l, const qtri_options *o)
{
    const bool coarse = qtri_kind_of(o) == QTRI_IN_565;
    const int32_t most = !coarse               ? TOLERANCE_888
                         : qtri_is_textured(o) ? 8 * TOLERANCE_565
                                               : TOLERANCE_565;
    l->tolerance[0] = most;
    l->tolerance[1] = coarse && !qtri_is_textured(o) ? 2 * most : most;
    l->tolerance[2] = most;
}

static void begin(qtri_large *t)
{
    qtri_large_light *l = light_of(t);
    const qtri_large_vertex *v = t->in->v;
    int64_t q_q8[3];
    uint32_t q[3];
    set_corners(&l->lit);
    qtri_large_align_q(q_q8, v);
    for (int k = 0; k < 3; k++) {
        q[k] = (uint32_t)(q_q8[k] >> 8);
    }
    qtri_find_range(&l->least, &l->greatest, q);
    l->plane_y = t->plane_y;
    l->divided = !t->state->is_linear && l->least != l->greatest;
    l->y = INT32_MIN;
    l->is_alone = qtri_has_samples(t->options) && t->samples->place != QTRI_CENTER;
    set_tolerance(l, t->options);
    for (int k = 0; k < 2; k++) {
        uint32_t f[3];
        for (int i = 0; i < 3; i++) {
            const uint32_t share_q30 = (uint32_t)v[i].color_8p16[k];
            f[i] = l->divided ? (uint32_t)(qtri_mul_u32(q[i], share_q30) >> 30) : share_q30;
        }
        qtri_large_plane_of(&l->share[k], t, f);
    }
    if (l->divided) {
        qtri_large_plane_of(&l->q, t, q);
    }
}

/* A sample ------------------------------------------------------------------------------------- */

/* Shares of corners 1 and 2: below 2^30, as is their sum. */
static void find_shares(int32_t b_q30[2], const qtri_large_light *l, int32_t x)
{
    const int32_t one = QTRI_LIT_ONE_Q30;
    int32_t b[2] = {(int32_t)qtri_large_plane_at(&l->share[0], x),
                    (int32_t)qtri_large_plane_at(&l->share[1], x)};
    if (l->divided) {
        /* q <= 2^31, of what a pixel of the triangle may have. */
        uint32_t q = qtri_large_plane_at(&l->q, x);
        q = q < l->least ? l->least : q > l->greatest ? l->greatest : q;
        const int32_t zeros = qtri_clz32(q);
        const uint32_t reciprocal =
            qtri_reciprocal_near(q << (zeros & 31)); /* 2^62 / (q 2^zeros) */
        const int32_t most = (int32_t)(q - 1);
        b[0] = (int32_t)qtri_mul_high32((uint32_t)qtri_hold32(b[0], 0, most) << (zeros & 31),
                                        reciprocal);
        b[1] = (int32_t)qtri_mul_high32((uint32_t)qtri_hold32(b[1], 0, most) << (zeros & 31),
                                        reciprocal);
    }
    b_q30[0] = qtri_hold32(b[0], 0, one - 1);
    b_q30[1] = qtri_hold32(b[1], 0, one - 1 - b_q30[0]);
}

static void find_sample(qtri_light_sample *out, const qtri_large_light *l, int32_t x)
{
    int32_t b_q30[2];
    uint32_t color_8p16[3];
    find_shares(b_q30, l, x);
    color_at(color_8p16, &l->lit, b_q30);
    l->walk.packing->channels(out->c, color_8p16);
    out->x = x;
}

/* Whether the sample `middle` is on the line from a to b, within half of D. */
static bool is_straight(const qtri_large_light *l, const qtri_light_sample *a,
                        const qtri_light_sample *middle, const qtri_light_sample *b)
{
    const int32_t share = inverse_q15[b->x - a->x] * (middle->x - a->x);
    for (int i = 0; i < 3; i++) {
        const int32_t way = (((int32_t)(b->c[i] - a->c[i]) >> 9) * share) >> 6;
        if (qtri_magnitude32((int32_t)(middle->c[i] - a->c[i]) - way) >
            (uint32_t)l->tolerance[i] / 2) {
            return false;
        }
    }
    return true;
}

/*
 * Whether the line bends at b, where a whole block from a ends and the next begins, which may be
 * the last one and shorter.
 */
static bool is_bent(const qtri_large_light *l, const qtri_light_sample *a,
                    const qtri_light_sample *b, const qtri_light_sample *c)
{
    const int32_t length = c->x - b->x;
    const bool whole = length == (int32_t)1 << l->block_log2;
    for (int i = 0; i < 3; i++) {
        int32_t after = (int32_t)(c->c[i] - b->c[i]);
        if (!whole) {
            after = part_of(after, length) * ((int32_t)1 << l->block_log2);
        }
        if (qtri_magnitude32(after - (int32_t)(b->c[i] - a->c[i])) > (uint32_t)l->tolerance[i]) {
            return true;
        }
    }
    return false;
}

/*
 * At an end of its span a block has no neighbour to tell: it may bend where it changes by more than
 * a little. What few pixels change by is rather a slope.
 */
static bool may_bend(const qtri_large_light *l, const qtri_light_sample *a,
                     const qtri_light_sample *b)
{
    const int32_t times = b->x - a->x <= BLOCK_MAX / 2 ? 4 : 2;
    for (int i = 0; i < 3; i++) {
        if (qtri_magnitude32((int32_t)(b->c[i] - a->c[i])) > (uint32_t)(l->tolerance[i] * times)) {
            return true;
        }
    }
    return false;
}

/* The row -------------------------------------------------------------------------------------- */

/* The sample of the span after `at`; after its last one, that again. */
static void next_sample(qtri_light_sample *out, const qtri_large_light *l,
                        const qtri_light_sample *at)
{
    if (at->x == l->last) {
        *out = *at;
    } else {
        find_sample(out, l, qtri_least32(at->x + ((int32_t)1 << l->block_log2), l->last));
    }
}

static void move_planes(qtri_large_light *l, int32_t y)
{
    for (; l->plane_y < y; l->plane_y++) { /* one row, mostly */
        l->share[0].row += l->share[0].dy;
        l->share[1].row += l->share[1].dy;
        if (l->divided) {
            l->q.row += l->q.dy;
        }
    }
}

/* Finds the block of the first pixel that is drawn, not one that begins at the span's last. */
static void begin_row(const qtri_large *t, qtri_large_light *l)
{
    const int32_t left = t->row_left;
    l->y = t->y;
    l->left = left;
    l->last = t->row_right - 1;
    l->x0 = t->x0;
    l->x = l->x0;
    l->from = 0;
    l->count = 0;
    l->piece_end = INT32_MIN;
    l->bends = false;
    move_planes(l, l->y);
    if (l->is_alone) {
        return;
    }
    const int32_t block = qtri_least32(l->x - left, qtri_greatest32(l->last - left - 1, 0)) >>
                          l->block_log2 << l->block_log2;
    find_sample(&l->sample[0], l, left + block);
    next_sample(&l->sample[1], l, &l->sample[0]);
    if (block != 0) {
        find_sample(&l->sample[2], l, left + block - ((int32_t)1 << l->block_log2));
        l->bends = is_bent(l, &l->sample[2], &l->sample[0], &l->sample[1]);
    }
}

static inline uint8_t after(uint8_t sample)
{
    return sample == 2 ? 0 : (uint8_t)(sample + 1);
}

/* Sets walk.piece: colours from a to before b, or to b where it ends the span. */
static void set_piece(qtri_large_light *l, const qtri_light_sample *a, const qtri_light_sample *b)
{
    const int32_t length = b->x - a->x;
    uint32_t c[3], step[3];
    for (int i = 0; i < 3; i++) {
        const int32_t change = (int32_t)(b->c[i] - a->c[i]);
        c[i] = a->c[i] + l->walk.half;
        step[i] = (uint32_t)(length == (int32_t)1 << l->block_log2 ? change >> l->block_log2
                                                                   : part_of(change, length));
    }
    l->piece_x = a->x;
    l->piece_end = b->x + (b->x == l->last ? 1 : 0);
    l->walk.packing->pack(&l->walk.piece, c, step, l->piece_end - a->x);
}

/* The next block: a piece if it is straight, or the first of the parts to be halved. */
static void next_block(qtri_large_light *l)
{
    const qtri_light_sample *from = &l->sample[l->from];
    const uint8_t second = after(l->from);
    const qtri_light_sample *to = &l->sample[second];
    qtri_light_sample *next = &l->sample[after(second)];
    const bool is_first = from->x == l->left, is_last = to->x == l->last;
    const bool bent_before = l->bends;
    next_sample(next, l, to);
    l->bends = !is_last && is_bent(l, from, to, next);
    const bool bent =
        bent_before || l->bends ||
        ((is_first || is_last) &&
         (may_bend(l, from, to) ||
          (is_first && is_last && (to->x - from->x) * 4 > (int32_t)1 << l->block_log2)));
    l->from = second;
    if (!bent) {
        set_piece(l, from, to);
        return;
    }
    l->bent[0] = true;
    l->at = *from;
    l->end[0] = *to;
    l->count = 1;
}

/*
 * Sets the piece that has pixel l->x: halves what is not straight, from left to right. Part n is at
 * most 2^(DULL_LOG2 - n) long, so the last that there is room for is a pixel.
 */
static void next_piece(qtri_large_light *l)
{
    do {
        if (l->count == 0) {
            next_block(l);
            if (l->count == 0) {
                continue;
            }
        }
        int i = l->count - 1;
        while (l->bent[i] && l->end[i].x - l->at.x >= 2) {
            find_sample(&l->end[i + 1], l, (l->at.x + l->end[i].x) >> 1);
            l->bent[i + 1] = !is_straight(l, &l->at, &l->end[i + 1], &l->end[i]);
            l->bent[i] = l->bent[i + 1];
            i++;
        }
        l->count = (uint8_t)i;
        const qtri_light_sample to = l->end[i];
        l->piece_end = to.x + (to.x == l->last ? 1 : 0);
        if (l->piece_end > l->x) {
            set_piece(l, &l->at, &to);
        }
        l->at = to;
    } while (l->piece_end <= l->x);
}

/* Sets a piece of one pixel. */
static void set_pixel(qtri_large_light *l)
{
    qtri_light_sample *at = &l->sample[0];
    find_sample(at, l, l->x);
    l->last = l->x;
    set_piece(l, at, at);
}

static int32_t next(qtri_large *t, int32_t count)
{
    qtri_large_light *l = light_of(t);
    if (l->y != t->y || l->x0 != t->x0) {
        begin_row(t, l);
    }
    if (l->is_alone) {
        set_pixel(l);
    } else if (l->x >= l->piece_end) {
        next_piece(l);
    }
    if (l->x != l->piece_x) {
        qtri_large_skip_colors(&l->walk.piece, (uint32_t)(l->x - l->piece_x));
        l->piece_x = l->x;
    }
    const int32_t n = qtri_least32(count, l->piece_end - l->x);
    l->x += n;
    return n;
}

bool qtri_large_light_is_linear(qtri_draw_state *state)
{
    return is_linear(qtri_large_light_triangle(state), state->lit,
                     qtri_stores_565(&state->options) ? SMALL_565 : SMALL_888);
}

void qtri_large_light_run(qtri_draw_state *state, const qtri_illumination *by,
                          void (*body)(void *with), void *with)
{
    qtri_large_light light;
    light.walk.begin = begin;
    light.walk.next = next;
    light.lit.by = by;
    light.lit.indices = NULL;
    light.block_log2 = by->shininess != NULL ? SHARP_LOG2 : DULL_LOG2;
    for (int32_t i = 0; i < by->count; i++) {
        light.block_log2 = by->run[i].kind->has_edges ? SHARP_LOG2 : light.block_log2;
    }
    state->light_walk = &light.walk;
    body(with);
    state->light_walk = NULL;
}
