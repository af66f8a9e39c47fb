/*
 * Rows with perspective: an attribute a is s / q of two that are linear on the screen, q = 1/w being
 * 1 at the vertex nearest to the eye. One reciprocal serves a block of up to 32 pixels: d pixels
 * from its middle m
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
 * is off by L h E^2 (1/4 + E/4 + E^2 / (1 - E)). That is to be less than 1/256 of a texel, or of
 * what a pixel steps by where that is more. Blocks are halved until q in the middle is great enough
 * for it: E <= 1/4, and h E^2 <= 1/72 or K h^3 q'^2 / q^4 <= 1/72, where K is the greatest of the
 * triangle. Colours have only the second form, in units of their own.
 *
 * Blocks begin at a chunk's start, 32 pixels apart from the span's left end, plus multiples of
 * their length, and q at their start decides: pixels do not depend on scissor or band.
 */
#include "perspective.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "linear.h"

/* Planes at a pixel of the row: |x| <= 2^14, so that products of the rest fit 31 bits. */
static inline uint32_t plane_at(const qtri_scanline *row, const qtri_projected *plane, int i,
                                int32_t x)
{
    return row->by.perspective.at[i] + plane->dx * (uint32_t)x +
           (uint32_t)((row->by.perspective.rest[i] + (int32_t)plane->dx_rest * x) >> 16);
}

/* What rounding leaves below 0 or above 2^31, held there. */
static uint32_t held(uint32_t value)
{
    return value > 0xC0000000u ? 0 : (value > 0x80000000u ? 0x80000000u : value);
}

/*
 * (a/w) / (1/w): 1/w is q 2^-31 with q in 1..2^31, normalised to 32 bits for the reciprocal;
 * s 2^32 / q = s r 2^(zeros - 30), s <= 2^31, r <= 2^31.
 */
typedef struct divider {
    uint32_t reciprocal;
    int32_t shift;
} divider;

static divider divider_for(uint32_t inv_w)
{
    const uint32_t exact = held(inv_w);
    const uint32_t q = exact == 0 ? 1 : exact;
    const int32_t zeros = qtri_clz32(q);
    const divider d = {qtri_reciprocal_q62(q << zeros), 30 - zeros};
    return d;
}

/* (whole + rest 2^-16) r / 2^down. */
static uint32_t divide_step(int32_t whole, uint32_t rest, const divider *d, int32_t up)
{
    const int32_t down = d->shift - up; /* -21..42 */
    const uint64_t low = qtri_mul_u32(rest, d->reciprocal) >> 16;
    const uint64_t product = (uint64_t)whole * d->reciprocal + low;
    return (uint32_t)(down >= 0 ? (uint64_t)(qtri_wrap64(product) >> down) : product << -down);
}

/*
 * Where w does not change along rows, as on floors and walls, texture coordinates are linear as
 * they are. Returns the pixels of a span below which a step's last bit adds up to 2^-10 of a texel
 * at most; 0: w changes.
 */
static int32_t level_pixels(const qtri_job *job)
{
    const qtri_projected *inv_w = &job->attribute[job->end].projected;
    if ((inv_w->dx | inv_w->dx_rest) != 0 || job->first != QTRI_U) {
        return 0;
    }
    int32_t bits = 16;
    for (int i = QTRI_U; i < job->end; i++) {
        const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
        bits = qtri_least32(bits, axis->shift + axis->up - 10);
    }
    return bits < 0 ? 0 : (int32_t)1 << bits;
}

/* The one division of a row along which w does not change. */
static void begin_level(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const divider d = divider_for(row->by.perspective.at[job->end]);
    row->run = row->left;
    for (int i = 0; i < 2; i++) {
        const qtri_projected *plane = &job->attribute[QTRI_U + i].projected;
        const qtri_texel_axis *axis = &job->axis[i];
        const uint32_t s = held(plane_at(row, plane, QTRI_U + i, row->left));
        const uint64_t product = qtri_mul_u32(s, d.reciprocal);
        const int32_t value =
            qtri_saturate32((int64_t)(d.shift >= 0 ? product >> d.shift : product << -d.shift));
        row->uv[i].at = qtri_run_scaled((uint32_t)value + axis->bias, axis->up);
        row->uv[i].step = divide_step((int32_t)plane->dx, plane->dx_rest, &d, axis->up);
    }
}

void qtri_perspective_row(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    const uint32_t y = (uint32_t)row->y;
    for (int i = job->first; i <= job->end; i++) {
        const qtri_projected *plane = &job->attribute[i].projected;
        row->by.perspective.at[i] = plane->origin + plane->dy * y;
        row->by.perspective.rest[i] = (int32_t)(plane->dy_rest * y);
        row->by.perspective.slope[i] = plane->slope + plane->slope_dy * y;
    }
    row->level = row->right - row->left < level_pixels(job);
    if (row->level) {
        begin_level(row);
    }
}

/* Leading zeros of q, not 0: of the block before nearly as many. */
static inline int32_t zeros_of(qtri_scanline *row, uint32_t q)
{
#if QTRI_LONG_MULTIPLY
    (void)row;
    return qtri_clz32(q);
#else
    int32_t zeros = row->by.perspective.zeros;
    while (q >> (31 - zeros) > 1) {
        zeros--;
    }
    while ((int32_t)(q << zeros) >= 0) {
        zeros++;
    }
    row->by.perspective.zeros = zeros;
    return zeros;
#endif
}

/* x 2^-shift, rounded down, modulo 2^32; -31..31. */
static inline uint32_t shifted(int32_t x, int32_t shift)
{
    return shift >= 0 ? (uint32_t)(x >> shift) : (uint32_t)x << -shift;
}

/* The same to nearest, -30..32. */
static inline uint32_t rounded(int32_t x, int32_t shift)
{
    return shift > 0 ? (uint32_t)(((x >> (shift - 1)) + 1) >> 1) : (uint32_t)x << -shift;
}

int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first,
                                     int end, qtri_curve *out)
{
    if (row->level) {
        return qtri_interpolate_linear(row, x, count, first, end, out);
    }
    const qtri_job *job = row->job;
    const qtri_perspective *p = &job->color.perspective;
    const qtri_projected *inv_w = &job->attribute[job->end].projected;
    /* The longest block from here: log2 of its pixels. */
    const int32_t from = (x - row->left) & (QTRI_BATCH - 1);
    const int32_t rest = qtri_least32(row->right - x, QTRI_BATCH - from);
    uint32_t q = plane_at(row, inv_w, job->end, x);
    const uint32_t *limits = first < QTRI_U ? p->colors : p->texels;
    int32_t log2 = QTRI_BLOCK_LOG2;
    while (log2 > 0 && q < limits[log2 - 1]) {
        log2--;
    }
    while (from >> log2 << log2 != from) {
        log2--;
    }
    while ((1 << log2) >> 1 >= rest) {
        log2--;
    }
    const int32_t length = qtri_least32((int32_t)1 << log2, rest);
    const int32_t half = length >> 1;
    x += half;
    /* Its middle. */
    q = plane_at(row, inv_w, job->end, x);
    q = q - 1 < 0xC0000000u ? q : 1;
    const int32_t zeros = zeros_of(row, q);
    const uint32_t reciprocal = qtri_reciprocal_near(q << zeros);
    const uint32_t y_q15 = reciprocal >> 16; /* 2^14..2^15 */
    /* |e| h <= 1/3: the middle may be nearer to the start than where the limit was tested. */
    int32_t down = -(p->slope_exponent + zeros + log2);
    down = down > 31 || log2 == 0 ? 31 : down;
    int32_t curved_q16 = (p->slope * (int32_t)y_q15) >> down;
    const int32_t squared_q16 = log2 == 0 ? 0 : (curved_q16 * curved_q16) >> 16;
    curved_q16 += (curved_q16 * squared_q16) >> 18;
    /* The reciprocal's square: 30 bits, of which 15 count, times 15/16 (1 + 3/4 E^2) <= .99. */
    uint32_t square = y_q15 * y_q15 + ((y_q15 * qtri_low16(reciprocal)) >> 15); /* 2^28..2^30 */
    square += ((square >> 16) * (uint32_t)(3 * squared_q16 >> 2)) - (square >> 4);
    const int32_t odd = square >> 29 == 0;
    square = ((square << odd) + 0x4000u) >> 15;
    square -= square >> 15;
    const int32_t slope_down = odd - 2 * zeros;
    for (int i = first; i < end; i++, out++) {
        const qtri_projected *a = &job->attribute[i].projected;
        const uint32_t s = plane_at(row, a, i, x);
        int32_t value = qtri_mul_high_s31((int32_t)(s << zeros), reciprocal);
        if (i < QTRI_U) {
            value >>= QTRI_COLOR_PERSPECTIVE_SHIFT - 2;
            value = qtri_hold32(value, p->least[i], p->greatest[i]);
        }
        uint32_t at = qtri_run_scaled((uint32_t)value + a->bias, a->up);
        uint32_t slope = 0;
        uint32_t bend = 0; /* of L e */
        if (log2 != 0) {
            const int32_t l =
                qtri_mul_s16((int32_t)row->by.perspective.slope[i], (int32_t)square);
            bend = rounded(qtri_mul_s16(l, curved_q16), a->down + slope_down + log2 - 1);
            slope = shifted(l, a->down + slope_down);
        }
        const uint32_t arc = bend * (uint32_t)half;
        out->at = at - (slope + arc) * (uint32_t)half;
        out->step = slope + 2 * arc - bend;
        out->bend = 0 - 2 * bend;
    }
    return qtri_least32(length, count);
}
