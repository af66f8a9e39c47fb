/* SPDX-License-Identifier: MIT */
/*
 * Stages between interpolated values and stored pixels. Internal.
 *
 * Each is a loop over words of a batch, `count` of 1..32. They work on four at a time and may write
 * up to three words past the end. Bounds are in steps of the channel's own unit and include the
 * rounding to it.
 */
#ifndef QTRI_RASTER_STAGE_COLOR_H
#define QTRI_RASTER_STAGE_COLOR_H

#include "batch.h"

/* What textured pixels are multiplied by, 10 bits a channel: 1020 is 1. */
#define QTRI_SHADE_RED   20
#define QTRI_SHADE_GREEN 10

/* What channels n.16, 1/2 of 2^-16 added, have too much for their highest 10 bits to be rounded. */
#define QTRI_SHADE_LESS (0x8000u - ((uint32_t)1 << 13))

/* Luma, .299 .587 .114, of 2^14: white in light of 1, and a half, is 255.5 2^24 < 2^32. */
enum { QTRI_LUMA_RED = 4899, QTRI_LUMA_GREEN = 9617, QTRI_LUMA_BLUE = 1868 };

/* Interpolation to shades ---------------------------------------------------------------------- */

/* Light of 0..1024, from shares: Q22 of 1, 1/2 of 2^-16 added as ramps have it. */
void qtri_shade_light(uint32_t *shade, const qtri_curve *share, int32_t count);

/* Red, green and blue, from channels n.16 of 0..255. */
void qtri_shade_rgb(uint32_t *shade, const qtri_curve channel[3], int32_t count);

/* The channels of a colour, n.16 of 0..255.0, as a shade. */
static inline uint32_t qtri_shade_of(const int32_t c[3])
{
    const int32_t half = (int32_t)1 << 13;
    return (uint32_t)(c[0] + half) >> 14 << QTRI_SHADE_RED |
           (uint32_t)(c[1] + half) >> 14 << QTRI_SHADE_GREEN | (uint32_t)(c[2] + half) >> 14;
}

/* Modulation ----------------------------------------------------------------------------------- */

/* color times light, or times red green blue: RGB565 within .54 and .66, 8 bits .63 and .69. */
void qtri_light_565(uint32_t *color, const uint32_t *shade, int32_t count);
void qtri_light_888(uint32_t *color, const uint32_t *shade, int32_t count);
void qtri_times_565(uint32_t *color, const uint32_t *shade, int32_t count);
void qtri_times_888(uint32_t *color, const uint32_t *shade, int32_t count);

/* What qtri_shade_rgb and then times_ make: also of up to three words past the end. */
void qtri_times_curves_565(uint32_t *color, const qtri_curve channel[3], int32_t count);
void qtri_times_curves_888(uint32_t *color, const qtri_curve channel[3], int32_t count);
void qtri_times_curves_gray(uint32_t *color, const qtri_curve channel[3], int32_t count);

/* color times light times a tint, 1024 being 1 of both: RGB565 within .54, 8 bits .63. */
void qtri_tint_565(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                   int32_t count);
void qtri_tint_888(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                   int32_t count);

/* The same of 8 bits, to gray: one rounding, so no farther off than 8 bits are. */
void qtri_light_gray(uint32_t *color, const uint32_t *shade, int32_t count);
void qtri_times_gray(uint32_t *color, const uint32_t *shade, int32_t count);
void qtri_tint_gray(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                    int32_t count);

/* Conversion ----------------------------------------------------------------------------------- */

/* 31 and 63 become 255, correctly rounded between; back: within .51; luma: .51. */
void qtri_565_to_888(uint32_t *color, int32_t count);
void qtri_888_to_565(uint32_t *color, int32_t count);
void qtri_888_to_gray(uint32_t *color, int32_t count);
void qtri_565_to_gray(uint32_t *color, int32_t count);

#endif
