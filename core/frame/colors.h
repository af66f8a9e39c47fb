/* SPDX-License-Identifier: MIT */
/*
 * Kinds of colour, from inside. Internal.
 *
 * A channel is interpolated in units of the kind: 0..31 for red of 565, 0..255 for 888, the
 * luma-weighted share of 0..255 for gray, each with 16 fraction bits. So a colour is rounded
 * exactly once, when it is packed, and flat, smooth and textured pixels share one rule.
 */
#ifndef QTRI_FRAME_COLORS_H
#define QTRI_FRAME_COLORS_H

#include <stdbool.h>

#include "qtri/format.h"

/* White in gray's units: .299 .587 .114 of 255, n.16; the sum is 255 << 16 exactly. */
#define QTRI_GRAY_RED   4996792
#define QTRI_GRAY_GREEN 9809756
#define QTRI_GRAY_BLUE  1905132

struct qtri_colors {
    uint32_t ratio_q30[3];                      /* units of 1/255, rounded */
    bool single;                                /* only the sum of the channels counts */
    uint8_t red, green;                         /* where they begin in a colour; blue: at bit 0 */
    uint32_t (*pack)(const int32_t channel[3]); /* rounded, from n.16 */
};

static inline uint32_t qtri_channel_round(int32_t c)
{
    return (uint32_t)(c + 0x8000) >> 16;
}

static inline uint32_t qtri_pack_565(const int32_t c[3])
{
    return qtri_channel_round(c[0]) << 11 | qtri_channel_round(c[1]) << 5 |
           qtri_channel_round(c[2]);
}

static inline uint32_t qtri_pack_888(const int32_t c[3])
{
    return qtri_channel_round(c[0]) << 16 | qtri_channel_round(c[1]) << 8 |
           qtri_channel_round(c[2]);
}

static inline uint32_t qtri_pack_gray(const int32_t c[3])
{
    return qtri_channel_round(c[0] + c[1] + c[2]);
}

#endif
