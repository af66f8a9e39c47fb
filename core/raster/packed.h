/* SPDX-License-Identifier: MIT */
/*
 * A colour of RGB565 with fractions in one word. Internal.
 *
 *     31  27 26    21 20  16 15    11 10   5 4      0
 *     red   fraction blue  fraction green  fraction
 *
 * One addition steps all three channels, one mask and one or-with-shift make a pixel: green is
 * where a pixel has it, red and blue are 16 bits above. Steps may be negative: the word is the sum
 * of its fields, each times its unit, modulo 2^32, so it is right wherever all fields are in range,
 * however it got there.
 *
 * The fractions are short: a step is rounded to 2^-5 (red 2^-6), and so off by 2^-6 at most; a
 * start is cut off to 2^-5. Long rows therefore begin anew from exact ramps every QTRI_PACKED_RUN
 * pixels, and step in groups of eight, whose sum is off by 2^-6 too: within a group two steps in
 * turn, whose sum is rounded, and a last one that makes the whole. That is 1/8 of a step of colour
 * for eight groups, 1/16 within a group and 1/32 from the cut, which with the half that rounds
 * stays inside the fields: 31.5 + 7/32 < 32.
 */
#ifndef QTRI_RASTER_PACKED_H
#define QTRI_RASTER_PACKED_H

#include "job.h"

#define QTRI_PACKED_RUN 64

/* From channels n.16 that fit 31 bits with their sign, cut off. */
static inline uint32_t qtri_pack_floor(uint32_t r, uint32_t g, uint32_t b)
{
    return ((r >> 10) << 21) + (b & ~(uint32_t)0x7FF) + (uint32_t)((int32_t)g >> 11);
}

static inline uint32_t qtri_pack_round(uint32_t r, uint32_t g, uint32_t b)
{
    return qtri_pack_floor(r + 0x200, g + 0x400, b + 0x400);
}

/* In the low half; what is above is not the pixel's. */
static inline uint32_t qtri_packed_pixel(uint32_t packed)
{
    packed &= 0xF81F07E0u;
    return packed | packed >> 16;
}

/* The exact start of a run, dx and dy from the anchor. */
static inline uint32_t qtri_packed_start(const qtri_job *job, int32_t dx, int32_t dy)
{
    const qtri_attribute *color = job->attribute;
    return qtri_pack_floor(qtri_ramp_at(&color[0].ramp, dx, dy),
                           qtri_ramp_at(&color[1].ramp, dx, dy),
                           qtri_ramp_at(&color[2].ramp, dx, dy));
}

/* `count` steps from there. */
static inline uint32_t qtri_packed_skip(const qtri_job *job, int32_t count)
{
    const qtri_packed_steps *step = &job->color.step;
    uint32_t rest = (uint32_t)count & 7;
    return ((uint32_t)count >> 3) * step->eight + ((rest + 1) >> 1) * step->even +
           (rest >> 1) * step->odd;
}

/*
 * Colours of `count` pixels from x, y on, the first of which is pixel `phase` of a run: for the
 * stages. A multiple of four is written.
 */
void qtri_packed_colors(uint32_t *color, const qtri_job *job, int32_t x, int32_t y, int32_t phase,
                        int32_t count);

#endif
