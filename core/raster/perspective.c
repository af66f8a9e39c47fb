/* SPDX-License-Identifier: MIT */
/*
 * Rows with perspective: an attribute a is s / q of two that are linear on the screen, q = 1/w
 * being 1 at the vertex nearest to the eye. One reciprocal serves a block of up to 32 pixels: d
 * pixels from its middle m
 *
 *     a = a_m + L (d - e d^2 + e^2 d^3 - ...),   L = K / q^2,   e = q' / q,   K = s' q - s q'
 *
 * where K does not change along a row, and is linear in y. A block reaches h pixels to both sides;
 * with E = e h, x = d / h the cubic term is L h E^2 x^3, which 3/4 x replaces with an error of 1/4.
 * The term after it, L h E^3 x^4, is x^2 with an error of 1/4, which is never negative. So a curve
 * of second order,
 *
 *     a_m + L (1 + 3/4 E^2) d - L e (1 + E^2) d^2,
 *
 * is off by L h E^2 (1/4 + E/4 + E^2 / (1 - E)). Blocks of 16 and 32 pixels of texels are of third
 * order, with 13/16 x^2 in place of x^4:
 *
 *     a_m + L d - L e (1 + 13/16 E^2) d^2 + L e^2 d^3
 *
 * is off by L h E^3 (3/16 + E / (1 - E)). It is drawn as curves of second order from one eighth
 * pixel to the next, through its values there and halfway: L e^2 n (n - 4) (n - 8) more, up to 24.6
 * L e^2. All that is to be less than 1/256 of a texel, or of what a pixel steps by, up to four,
 * where that is more; perspective_setup.c finds from which q on. Colours have bounds of their own.
 *
 * Blocks begin at a chunk's start, 32 pixels apart from the span's left end, plus multiples of
 * their length, and q at their start decides: pixels do not depend on scissor or band.
 */
#include "perspective.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "../frame/curves.h"

/*
 * (a/w) / (1/w): 1/w is q 2^-31 with q in 1..2^31, give or take an error, normalised to 32 bits
 * for the reciprocal; s 2^32 / q = s r 2^(zeros - 30), s < 2^30, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t zeros;
} divider;

/* With the bits below the unit that are free, of values whose zeros are more than 16 not all. */
static inline uint32_t normalized(uint32_t whole, uint32_t rest, int32_t zeros)
{
    return (whole << zeros) + (qtri_low16(rest) << zeros >> 16);
}

/* For a row's first pixel: one that the triangle covers. */
static divider divider_for(const qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const uint32_t q = qtri_row_inv_w_at(row, row->left);
    const int32_t rest = row->by.perspective.plane[job->end].rest +
                         (int32_t)job->attribute[job->end].projected.dx_rest * row->left;
    const int32_t zeros = qtri_clz32(q);
    const divider d = {qtri_reciprocal_q62(normalized(q, (uint32_t)rest, zeros)), zeros};
    return d;
}

/* (whole + rest 2^-16) r / 2^down. */
static uint32_t divide_step(int32_t whole, uint32_t rest, const divider *d, int32_t up)
{
    const int32_t down = 30 - d->zeros - up; /* -21..42 */
    const uint64_t low = qtri_mul_u32(rest, d->reciprocal) >> 16;
    const uint64_t product = (uint64_t)whole * d->reciprocal + low;
    return (uint32_t)(down >= 0 ? (uint64_t)(qtri_wrap64(product) >> down) : product << -down);
}

/*
 * Where w does not change along rows, as on floors and walls, texture coordinates are linear as
 * they are. Returns the pixels of a span below which a step's last bit adds up to 2^-10 of a texel
 * at most; 0: w changes by a unit or more a pixel.
 */
static int32_t level_pixels(const qtri_job *job)
{
    const qtri_projected *inv_w = &job->attribute[job->end].projected;
    if (inv_w->dx + 1 > 1 || job->first != QTRI_U) {
        return 0;
    }
    int32_t bits = 16;
    for (int i = QTRI_U; i < job->end; i++) {
        const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
        bits = qtri_least32(bits, axis->shift + axis->up - 10);
    }
    return bits < 0 ? 0 : (int32_t)1 << bits;
}

/*
 * Whether it changes so little, as where vertices of a level floor were rounded: with K the slope
 * and e = q'/q, d pixels from where it begins K e d^2 is missed, here 2^-14 of a pixel's step.
 */
static bool is_level(const qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const qtri_projected *inv_w = &job->attribute[job->end].projected;
    if ((inv_w->dx | inv_w->dx_rest) == 0) {
        return true;
    }
    const uint32_t step =
        qtri_magnitude32((int32_t)(inv_w->dx * 65536u) + (int32_t)inv_w->dx_rest); /* <= 2^16 */
    const uint32_t length = (uint32_t)(row->right - row->left);                    /* < 2^15 */
    const uint32_t q =
        inv_w->origin + inv_w->dy * (uint32_t)row->y + inv_w->dx * (uint32_t)row->left;
    return qtri_mul_u32(length * length, step) >> 2 <= q;
}

/*
 * The one division of a row along which w does not change. At a pixel that the triangle covers a
 * value below 2^30 times 1/w of 2^31 at most is below 2^29 here, with weights that leave the
 * triangle, see unsnapped.h, and rounding below 2^30. Nothing holds it from above; below 0 it may
 * be.
 */
static void begin_level(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const divider d = divider_for(row);
    row->run_length = (int32_t)1 << 30;
    for (int i = 0; i < 2; i++) {
        const qtri_projected *plane = &job->attribute[QTRI_U + i].projected;
        const qtri_row_plane *at = &row->by.perspective.plane[QTRI_U + i];
        const int32_t rest = at->rest + (int32_t)plane->dx_rest * row->left;
        const int32_t s =
            (int32_t)(at->at + plane->dx * (uint32_t)row->left + (uint32_t)(rest >> 16));
        const uint32_t divided = normalized(s < 0 ? 0 : (uint32_t)s, (uint32_t)rest, d.zeros);
        const int32_t value = qtri_mul_high_s31((int32_t)divided, d.reciprocal); /* a quarter */
        qtri_curve *curve = &row->curve[QTRI_U + i];
        curve->at = qtri_run_scaled((uint32_t)value + plane->bias, plane->up);
        curve->step = divide_step((int32_t)plane->dx, plane->dx_rest, &d, job->axis[i].up);
        curve->bend = 0;
        curve->twist = 0;
    }
}

/*
 * A slope to 15 bits and how many are cut, 0..15: in the row before nearly as many.
 */
static inline int32_t bits_cut(int32_t slope, int32_t cut)
{
#if QTRI_LONG_MULTIPLY
    (void)cut;
    return qtri_greatest32(17 - qtri_clz32(qtri_magnitude32(slope)), 0);
#else
    const uint32_t size = qtri_magnitude32(slope);
    while (size >> cut >= (uint32_t)1 << 15) {
        cut++;
    }
    while (cut > 0 && size >> cut < (uint32_t)1 << 14) {
        cut--;
    }
    return cut;
#endif
}

void qtri_perspective_begin(qtri_scanline *row)
{
    row->by.perspective.zeros = 0;
    for (int i = 0; i < QTRI_ATTRIBUTES; i++) {
        row->by.perspective.plane[i].cut = 0;
    }
}

void qtri_perspective_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const uint32_t y = (uint32_t)row->y;
    const qtri_attribute *from = &job->attribute[job->first];
    qtri_row_plane *to = &row->by.perspective.plane[job->first];
    const bool level = row->right - row->left < level_pixels(job) && is_level(row);
    row->level = level;
    for (int i = job->first; i <= job->end; i++, from++, to++) {
        to->at = from->projected.origin + from->projected.dy * y;
        to->rest = (int32_t)(from->projected.dy_rest * y + from->projected.origin_rest);
        if (!level && i < job->end) {
            const int32_t slope = (int32_t)(from->projected.slope + from->projected.slope_dy * y);
            const int32_t cut = bits_cut(slope, to->cut);
            to->cut = (uint8_t)cut;
            to->slope = slope >> cut;
            to->down = (int8_t)(from->projected.down + 16 - cut);
        }
    }
    if (level) {
        begin_level(row);
    }
}

/*
 * What curves of a block have in common, as shares of L. With A = e (1 + ...), T = e^2 and `half`
 * pixels from the first to the middle, a curve's first value is
 *
 *     a_m - L (1 + A half + T half^2) half,
 *     step L (1 + (2 half - 1) A + (3 half^2 - 3 half - 20) T),
 *     bend L (- 2 A - (6 half - 24) T),   twist L 24 T
 *
 * where - 21 T of the step and 18 T of the bend make a curve of second order pass through the
 * fourth and the eighth pixel from where it begins, and where it does so again after every eighth.
 * Without a third order T is 0 but in A and L.
 */
typedef struct middle {
    int32_t x, half, log2; /* pixel; log2 of half of a whole block */
    int32_t zeros;
    uint32_t reciprocal; /* 2^62 / (q 2^zeros) */
    int32_t square;      /* 15 bits of that squared */
    int32_t slope_down;
    int32_t value_q16, step_q16; /* without 1 */
    int32_t bend_q15;            /* times 2^log2 */
    int32_t twist_q12;           /* times 4^log2 */
} middle;

/* log2: of a whole block, 1 or more. */
static inline void set_shares(middle *m, const qtri_perspective *p, int32_t log2, bool twisted)
{
    const uint32_t y_q15 = m->reciprocal >> 16; /* 2^14..2^15 */
    /* E = e h, at most 1/8 of it, so that the shift is not negative. */
    int32_t down = -(p->slope_exponent + m->zeros + log2);
    down = down > 31 ? 31 : down;
    log2--;
    m->log2 = log2;
    const int32_t e_q16 = (p->slope * (int32_t)y_q15) >> down;
    const int32_t e2_q16 = (e_q16 * e_q16) >> 16;
    /* The reciprocal's square: 30 bits, of which 15 count, times 15/16 (1 + 3/4 E^2) <= .99. */
    uint32_t square = y_q15 * y_q15 + ((y_q15 * qtri_low16(m->reciprocal)) >> 15); /* 2^28..2^30 */
    square -= square >> 4;
    const int32_t half = m->half;
    if (twisted) {
        const int32_t a_q16 = e_q16 + ((13 * e_q16 * e2_q16) >> 20);
        const int32_t arc = (a_q16 * half) >> log2;
        const int32_t t1 = (e2_q16 * half) >> log2; /* T half h */
        const int32_t t2 = (t1 * half) >> log2;
        m->value_q16 = arc + t2;
        m->step_q16 = 2 * arc + 3 * t2 - ((a_q16 + 3 * t1 + (20 * e2_q16 >> log2)) >> log2);
        m->bend_q15 = (12 * e2_q16 >> log2) - a_q16 - 3 * t1;
        m->twist_q12 = (24 * e2_q16) >> 4;
    } else {
        const int32_t a_q16 = e_q16 + ((4 * e_q16 * e2_q16) >> 20); /* of 1 + 3/4 E^2 */
        const int32_t arc = (a_q16 * half) >> log2;
        square += (square >> 16) * (uint32_t)(3 * e2_q16 >> 2);
        m->value_q16 = arc;
        m->step_q16 = 2 * arc - (a_q16 >> log2);
        m->bend_q15 = -a_q16;
        m->twist_q12 = 0;
    }
    const int32_t odd = square >> 29 == 0;
    square = ((square << odd) + 0x4000u) >> 15;
    m->square = (int32_t)(square - (square >> 15));
    m->slope_down = odd - 2 * m->zeros;
}

/* Attribute i in the middle, in the unit of curves. */
static inline uint32_t middle_value(const qtri_scanline *row, const middle *m, int i)
{
    const qtri_projected *a = &row->job->attribute[i].projected;
    const uint32_t s = qtri_row_plane_at(&row->by.perspective.plane[i], a, m->x);
    int32_t value = qtri_mul_high_s31((int32_t)(s << m->zeros), m->reciprocal);
    if (i < QTRI_U) {
        const qtri_perspective *p = &row->job->color.perspective;
        value >>= QTRI_COLOR_PERSPECTIVE_SHIFT - 2;
        value = qtri_hold32(value, p->least[i], p->greatest[i]);
        return (uint32_t)value + a->bias;
    }
    return qtri_run_scaled((uint32_t)value + a->bias, a->up);
}

/* A curve whose slope is shifted left, or far right: few are. |l| < 2^30 */
QTRI_NOINLINE static void set_steep_curve(qtri_curve *out, const middle *m, uint32_t value,
                                          int32_t l, int32_t down)
{
    if (down > 22) {
        l >>= qtri_least32(down - 22, 31);
        down = 22;
    }
    const int32_t up = down < 0 ? -down : 0;
    down = down < 0 ? 0 : down;
    const int32_t l_15 = l >> 15;
    const int32_t to_start = (l + ((l_15 * m->value_q16) >> 1)) >> down;
    const int32_t step = (l + ((l_15 * m->step_q16) >> 1)) >> down;
    out->at = value - ((uint32_t)to_start << up) * (uint32_t)m->half;
    out->step = (uint32_t)step << up;
    out->bend = (uint32_t)((l_15 * m->bend_q15) >> (down + m->log2)) << up;
    out->twist = 0;
    if (m->twist_q12 != 0) { /* down + 2 log2 - 3 <= 27 */
        out->twist = (uint32_t)((l_15 * m->twist_q12) >> (down + 2 * m->log2 - 3)) << up;
    }
}

QTRI_IN_PLACE void set_curve(qtri_curve *out, const middle *m, uint32_t value,
                             const qtri_row_plane *plane, bool twisted)
{
    const int32_t l = plane->slope * m->square;
    const int32_t down = plane->down + m->slope_down;
    if ((uint32_t)down > 22) {
        const middle copy = *m; /* or all of it would be in memory */
        set_steep_curve(out, QTRI_SMALL_CODE ? m : &copy, value, l, down);
        return;
    }
    const int32_t l_15 = l >> 15;
    const int32_t to_start = (l + ((l_15 * m->value_q16) >> 1)) >> down;
    out->at = value - (uint32_t)to_start * (uint32_t)m->half;
    out->step = (uint32_t)((l + ((l_15 * m->step_q16) >> 1)) >> down);
    out->bend = (uint32_t)((l_15 * m->bend_q15) >> (down + m->log2));
    out->twist =
        twisted ? (uint32_t)((l_15 * m->twist_q12) >> (down + 2 * m->log2 - 3)) : (uint32_t)0;
}

QTRI_IN_PLACE void set_curves(qtri_scanline *row, middle *m, int32_t log2, int first, int end,
                              bool twisted)
{
    set_shares(m, &row->job->color.perspective, log2, twisted);
    for (int i = first; i < end; i++) {
        set_curve(&row->curve[i], m, middle_value(row, m, i), &row->by.perspective.plane[i],
                  twisted);
    }
}

/* log2 of the pixels of the longest block from pixel x of the row on, `from` pixels into a chunk.
 */
static inline int32_t longest_block(const qtri_scanline *row, const uint32_t *limits, int32_t x,
                                    int32_t from, int32_t rest)
{
    const uint32_t q = qtri_row_inv_w_at(row, x);
    int32_t log2 = QTRI_BLOCK_LOG2;
    while (log2 > 0 && q < limits[log2 - 1]) {
        log2--;
    }
    while (log2 > 0 && (from & (((int32_t)1 << log2) - 1)) != 0) {
        log2--;
    }
    while (log2 > 0 && (int32_t)1 << (log2 - 1) >= rest) {
        log2--;
    }
    return log2;
}

int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first,
                                     int end)
{
    const qtri_perspective *p = &row->job->color.perspective;
    const int32_t from = (x - row->left) & (QTRI_BATCH - 1);
    const int32_t rest = qtri_least32(row->right - x, QTRI_BATCH - from);
    const int32_t log2 = longest_block(row, first < QTRI_U ? p->colors : p->texels, x, from, rest);
    const int32_t length = qtri_least32((int32_t)1 << log2, rest);
    middle m;
    m.half = length >> 1;
    m.x = x + m.half;
    const uint32_t q = qtri_row_inv_w_at(row, m.x);
    m.zeros = qtri_row_zeros(row, q);
    m.reciprocal = qtri_reciprocal_near(q << m.zeros);
    if (log2 == 0) {
        for (int i = first; i < end; i++) {
            const qtri_curve one = {middle_value(row, &m, i), 0, 0, 0};
            row->curve[i] = one;
        }
    } else { /* two copies of what follows, or one where code is to be small */
        const bool twisted = first == QTRI_U && log2 >= p->texels_twisted;
        if (!QTRI_SMALL_CODE && twisted) {
            set_curves(row, &m, log2, first, end, true);
        } else {
            set_curves(row, &m, log2, first, end, QTRI_SMALL_CODE && twisted);
        }
    }
    return qtri_least32(length, count);
}
