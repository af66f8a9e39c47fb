/* SPDX-License-Identifier: MIT */
/*
 * What fog makes RGB565 of: colours that are rounded once, when they have their share of fog.
 * Internal.
 *
 * Stages leave eighths of a step of red and blue and quarters of one of green, 8 bits a channel:
 * 0x00RRGGBB where 248 252 248 is white. Half of that, what a share of 256 is off, 1/8 of green's
 * 63 steps at most, and the half that rounds a pixel are 3/4 of a step; of colours that are RGB565
 * already it is up to 1.25.
 */
#ifndef QTRI_RASTER_FOG_565_H
#define QTRI_RASTER_FOG_565_H

#include "raster.h"

/*
 * Loops of fog, here and in fog.c, over ONE(i), which PUTs color[i] in share[i]. QTRI_FOG_ROW: to
 * pixel[i], four at a time. QTRI_FOG_PLACES: what a loop over what waits in the batch has before
 * it.
 */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_FOG_FOUR
#else
#define QTRI_FOG_FOUR                                                                              \
    for (; count >= 4; count -= 4, color += 4, share += 4, pixel += 4) {                           \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
    }
#endif
#define QTRI_FOG_ROW                                                                               \
    QTRI_FOG_FOUR                                                                                  \
    for (; count > 0; count--, color++, share++, pixel++) {                                        \
        ONE(0)                                                                                     \
    }
#define QTRI_FOG_PLACES                                                                            \
    const uint32_t *color = raster->batch->color;                                                  \
    const uint32_t *place = raster->batch->place;                                                  \
    const uint32_t *const end = place + count;                                                     \
    uint8_t *const pixels = raster->surface->pixels;                                               \
    const ptrdiff_t pitch = raster->surface->pitch;

extern const qtri_colors qtri_colors_565_finer;

/* From 0x00RRGGBB, within .51. */
void qtri_888_to_565_finer(uint32_t *color, int32_t count);

/*
 * Has the stages of a raster whose colours are RGB565 give finer ones. Not of texels of RGB565:
 * those that are not lit are exact, and the loops for others are as fast as they are for being so.
 */
void qtri_fog_begin_565(qtri_raster *raster);

/* `color` in shares of 1024, the rest is fog, as 565: to pixels, of what waits in the batch too,
 * and in place. */
void qtri_fog_row_565(uint16_t *pixel, const uint32_t *color, uint32_t fog, const uint32_t *share,
                      int32_t count);
void qtri_fog_list_565(const qtri_raster *raster, const uint32_t *share, int32_t count);
void qtri_fog_words_565(uint32_t *color, uint32_t fog, const uint32_t *share, int32_t count);

/* The same as finer colours; and those in a share of alpha over pixels, as 565. */
void qtri_fog_words_finer(uint32_t *color, uint32_t fog, const uint32_t *share, int32_t count);
void qtri_fog_over_565(uint32_t *color, const uint16_t *under, int32_t count, uint32_t alpha);

#endif
