/* SPDX-License-Identifier: MIT */
/*
 * Colours in steps of a format's channels: 31, 63 and 31 of RGB565, 255 of others, of gray its
 * luma.
 */
#ifndef QTRI_TESTS_SUPPORT_STEPS_H
#define QTRI_TESTS_SUPPORT_STEPS_H

#include <math.h>

#include <qtri.h>

static inline double most_steps(const qtri_format *format, int channel)
{
    return format->colors == &qtri_colors_565 ? (channel == 1 ? 63 : 31) : 255;
}

/* Of a colour 0..255. */
static inline double steps_of(const qtri_format *format, const double rgb[3], int channel)
{
    return format->colors == &qtri_colors_gray ? .299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2]
                                               : rgb[channel] * most_steps(format, channel) / 255;
}

/* Of a stored pixel. */
static inline double stored_steps(const qtri_format *format, uint32_t stored, int channel)
{
    const uint32_t value = format->decode(stored) >> (16 - 8 * channel) & 255;
    return format->colors == &qtri_colors_565 ? round(value * most_steps(format, channel) / 255)
                                              : value;
}

#endif
