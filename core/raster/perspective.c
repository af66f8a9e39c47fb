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
#include "perspective_block.h"

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
