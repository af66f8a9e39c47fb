/* SPDX-License-Identifier: MIT */
#include "mix.h"

/*
 * Decoded channels are full at 255. Of 5 and 6 bits that were widened to 8, rounded, the upper
 * ones are what they were: (255 x + 15) / 31 lies in 8 x .. 8 x + 7.
 */
uint32_t qtri_color_of(const qtri_format *format, uint32_t stored)
{
    const uint32_t color = format->decode(stored);
    const qtri_colors *kind = format->colors;
    if (kind->single) {
        return color & 0xFF;
    }
    if (kind->red == 11) {
        return (color >> 19 & 31) << 11 | (color >> 10 & 63) << 5 | (color >> 3 & 31);
    }
    return color & 0xFFFFFF;
}

uint32_t qtri_stored_of(const qtri_format *format, uint32_t color)
{
    uint32_t pixel[4] = {color};
    if (format->encode != NULL) {
        format->encode(pixel, 1);
    }
    return pixel[0];
}

const qtri_masks *qtri_masks_of(const qtri_colors *kind)
{
    static const qtri_masks gray = {{0, 0, 0xFF}, {0, 0, 0}};
    static const qtri_masks bits_565 = {{31, 63, 31}, {11, 5, 0}};
    static const qtri_masks bits_888 = {{0xFF, 0xFF, 0xFF}, {16, 8, 0}};
    return kind->single ? &gray : kind->red == 11 ? &bits_565 : &bits_888;
}

uint32_t qtri_mix_colors(const qtri_colors *kind, uint32_t a, uint32_t b, uint32_t share)
{
    const qtri_masks *masks = qtri_masks_of(kind);
    uint32_t mixed = 0;
    for (int i = 0; i < 3; i++) {
        const uint32_t p = a >> masks->shift[i] & masks->mask[i];
        const uint32_t q = b >> masks->shift[i] & masks->mask[i];
        mixed |= (p * (32 - share) + q * share + 16) >> 5 << masks->shift[i];
    }
    return mixed;
}

uint32_t qtri_mean_of(const qtri_format *format, const uint32_t stored[4])
{
    const qtri_masks *masks = qtri_masks_of(format->colors);
    uint32_t mean = 0;
    for (int i = 0; i < 3; i++) {
        uint32_t sum = 2;
        for (int k = 0; k < 4; k++) {
            sum += qtri_color_of(format, stored[k]) >> masks->shift[i] & masks->mask[i];
        }
        mean |= sum >> 2 << masks->shift[i];
    }
    return qtri_stored_of(format, mean);
}
