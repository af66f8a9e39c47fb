/* SPDX-License-Identifier: MIT */
/*
 * One pixel, depth or texel of a format that is the application's own: these work on several words.
 */
#include "qtri/body/state.h"

uint32_t qtri_encode_other(const qtri_format *format, uint32_t color_888)
{
    uint32_t words[4] = {color_888, 0, 0, 0}; /* formats may work on three more */
    if (format->colors == &qtri_colors_565) {
        words[0] = qtri_pixel_888_to_565(color_888);
    } else if (format->colors == &qtri_colors_gray) {
        words[0] = qtri_pixel_888_to_luma(color_888);
    }
    if (format->encode != NULL) {
        format->encode(words, 1);
    }
    return words[0];
}

uint32_t qtri_depth_encode_other(const qtri_depth_format *format, uint32_t z_16p16)
{
    uint32_t words[4] = {z_16p16, 0, 0, 0};
    format->encode(words, 1);
    return words[0];
}

uint32_t qtri_fetch_other(const qtri_texture *texture, uint32_t number)
{
    uint32_t words[4] = {number, number, number, number};
    texture->format->fetch(words, texture, 1);
    return words[0];
}

uint32_t qtri_texel_other(const qtri_texture *texture, uint32_t stored)
{
    const qtri_texel_format *format = texture->format;
    uint32_t words[4] = {stored, stored, stored, stored};
    if (format->decode != NULL) {
        format->decode(words, texture, 1);
    }
    return format->colors == &qtri_colors_565 ? qtri_pixel_565_to_888(words[0])
                                              : words[0] & 0xFFFFFFu;
}
