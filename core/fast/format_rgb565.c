/* SPDX-License-Identifier: MIT */
#include "fused.h"
#include "pairs.h"

#if QTRI_PAIRS
static const qtri_fused lequal = {qtri_flat_pairs_lequal, qtri_smooth_pairs_lequal,
                                  qtri_copy_pairs_lequal, qtri_copy_bent_lequal, NULL};
static const qtri_fused loops = {qtri_flat_pairs, qtri_smooth_pairs, qtri_copy_pairs,
                                 qtri_copy_bent_less, &lequal};
#elif defined(__OPTIMIZE_SIZE__)
/* Rolled, the loop for smooth colours is slower than the stages. */
static const qtri_fused loops = {qtri_flat_less, NULL, qtri_copy_less, qtri_copy_bent_less, NULL};
#else
static const qtri_fused lequal = {qtri_flat_lequal, qtri_smooth_lequal, qtri_copy_lequal,
                                  qtri_copy_bent_lequal, NULL};
static const qtri_fused loops = {qtri_flat_less, qtri_smooth_less, qtri_copy_less,
                                 qtri_copy_bent_less, &lequal};
#endif

const qtri_format qtri_rgb565 = {&qtri_pixels_16, &qtri_colors_565, NULL, qtri_decode_rgb565,
                                 &loops};
