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

/*
 * An attribute along pixels of a row: its value at the first, the step to the next, and what the
 * step grows by. Texture coordinates may be twisted: after every eighth pixel the step grows by
 * that as well, and what it grows by by twice as much. All wrap.
 */
typedef struct qtri_curve {
    uint32_t at, step, bend, twist;
} qtri_curve;

struct qtri_colors {
    int32_t white[3];      /* of a full channel, n.16 */
    uint32_t ratio_q30[3]; /* white / 255.0, rounded */
    bool single;           /* only the sum of the channels counts */
    uint8_t red, green;    /* where they begin in a colour; blue: at bit 0 */
    uint8_t light_bits;    /* of 0..1 that are enough for a share of a colour */
    uint8_t finer;         /* 2^this of red's and blue's units are a step of what is stored */
    uint32_t (*pack)(const int32_t channel[3]); /* rounded, from n.16 */
    /*
     * Colours of `count` (1..32) pixels along a row, and up to seven more: from curves of the three
     * channels, or of their sum; n.16 with the half added that rounds.
     */
    void (*smooth)(uint32_t *color, const qtri_curve *channel, int32_t count);
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
