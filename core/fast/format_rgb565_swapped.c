/* SPDX-License-Identifier: MIT */
#include "../frame/barrier.h"
#include "fused.h"
#include "pairs.h"

static void encode(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_reversed(c) >> 16)
}

/* A stored pixel is one as any other of 16 bits. */
#if QTRI_PAIRS
static const qtri_fused lequal = {.flat = qtri_flat_pairs_lequal};
static const qtri_fused loops = {.flat = qtri_flat_pairs, .less_equal = &lequal};
#elif defined(__OPTIMIZE_SIZE__)
static const qtri_fused loops = {.flat = qtri_flat_less};
#else
static const qtri_fused lequal = {.flat = qtri_flat_lequal};
static const qtri_fused loops = {.flat = qtri_flat_less, .less_equal = &lequal};
#endif

const qtri_format qtri_rgb565_swapped = {&qtri_pixels_16, &qtri_colors_565,
                                         encode,          qtri_decode_rgb565_swapped,
                                         &loops,          QTRI_RGB565_SWAPPED};
