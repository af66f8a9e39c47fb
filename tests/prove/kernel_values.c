/* SPDX-License-Identifier: MIT */
/*
 * What Frama-C's Eva proves of kernels of the pipeline, as math_values.c does of the mathematics:
 * within the ranges that their headers promise nothing that C does not define.
 *
 * What depends on how arguments are related, as planes through three vertices do on their area, is
 * no interval: the fuzzers and the sanitizers of the tests stand for those.
 */
#include <stdint.h>

#include "__fc_builtin.h"

#include "frame/pixel.h"
#include "qtri/draw.h"
#include "qtri/format.h"
#include "qtri/view.h"
#include "raster/dda.h"

#include "products.h"

/*@ requires x < 0x80000000000000 && 0 < divisor <= 0x800000;
    assigns \result, *remainder \from x, divisor;
    ensures \result == x / divisor && \initialized(remainder) && *remainder < divisor; */
uint32_t qtri_divide_long(uint64_t x, uint32_t divisor, uint32_t *remainder);

static int32_t between(int32_t low, int32_t high)
{
    return (int32_t)Frama_C_long_interval(low, high);
}

static int64_t between64(int64_t low, int64_t high)
{
    return Frama_C_long_long_interval(low, high);
}

/* Edges: by the bits of their length, from anywhere in the guard band. */
// specified: qtri_divide_long
void prove_dda(void)
{
    //@ loop unroll 23;
    for (int bits = 0; bits < 23; bits++) {
        int32_t least = (int32_t)1 << bits;
        int32_t length = between(least, bits == 22 ? 2 * least : 2 * least - 1);
        int32_t delta = between(-((int32_t)1 << 23), (int32_t)1 << 23);
        int32_t start = between(-QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
        qtri_dda dda;
        qtri_dda_init(&dda, start, delta, length, between(0, 2 * least), between(0, 256 * least));
        /*@ assert dda.denominator <= 0x80000000; */
    }
}

/* Clip space of 62 bits. */
// specified: qtri_divide_long
void prove_outcode(void)
{
    const int64_t most = ((int64_t)1 << 61) - 1;
    qtri_clip_vertex v;
    v.x = between64(-most, most);
    v.y = between64(-most, most);
    v.z = between64(-most, most);
    v.w = between64(-most, most);
    unsigned outcode = qtri_clip_outcode(&v);
    /*@ assert outcode <= 63; */
}

/* Colours of any kind, as channels and packed. */
// specified: qtri_divide_long
void prove_colors(void)
{
    static const qtri_colors *const kinds[3] = {&qtri_colors_565, &qtri_colors_888,
                                                &qtri_colors_gray};
    const qtri_rgb color = {(uint8_t)between(0, 255), (uint8_t)between(0, 255),
                            (uint8_t)between(0, 255)};
    //@ loop unroll 3;
    for (int i = 0; i < 3; i++) {
        qtri_channels channels = qtri_channels_from_rgb(kinds[i], color);
        /*@ assert 0 <= channels.c[0] <= 0xFF0000; */
        /*@ assert 0 <= channels.c[1] <= 0xFF0000; */
        /*@ assert 0 <= channels.c[2] <= 0xFF0000; */
        uint32_t packed = kinds[i]->pack(channels.c);
        /*@ assert packed <= 0xFFFFFF; */
    }
}

/* What formats of depth store, by the leading zeros from the farthest on, and read of anything. */
// specified: qtri_divide_long
void prove_depths(void)
{
    static const qtri_depth_format *const formats[3] = {&qtri_depth_float16, &qtri_depth_linear24,
                                                        &qtri_depth_linear32};
    //@ loop unroll 3;
    for (int i = 0; i < 3; i++) {
        uint32_t depth[1] = {0xFFFF0000u};
        formats[i]->encode(depth, 1);
        //@ loop unroll 32;
        for (int bits = 0; bits < 32; bits++) {
            uint32_t one = (uint32_t)1 << bits;
            uint32_t last = bits == 31 ? 0xFFFF0000u : 2 * one - 1;
            depth[0] = 0xFFFF0000u - (uint32_t)Frama_C_unsigned_long_interval(one, last);
            formats[i]->encode(depth, 1);
        }
        uint32_t most = i == 0 ? 65535 : (i == 1 ? 0xFFFFFF : UINT32_MAX);
        depth[0] = (uint32_t)Frama_C_unsigned_long_interval(0, most);
        formats[i]->decode(depth, 1);
    }
}
