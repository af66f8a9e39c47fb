/* SPDX-License-Identifier: MIT */
#include "fused.h"
#include "pairs.h"

#if QTRI_PAIRS
static const qtri_fused lequal = {.flat = qtri_flat_pairs_lequal,
                                  .smooth = qtri_smooth_pairs_lequal,
                                  .copy = qtri_copy_pairs_lequal,
                                  .copy_bent = qtri_copy_bent_lequal,
                                  .lit = qtri_lit_list};
static const qtri_fused loops = {.flat = qtri_flat_pairs,
                                 .smooth = qtri_smooth_pairs,
                                 .copy = qtri_copy_pairs,
                                 .copy_bent = qtri_copy_bent_less,
                                 .lit = qtri_lit_list,
                                 .less_equal = &lequal};
#elif defined(__OPTIMIZE_SIZE__)
/* Rolled, a loop for smooth colours would be slower than the stages. */
static const qtri_fused loops = {.flat = qtri_flat_less,
                                 .copy = qtri_copy_less,
                                 .copy_bent = qtri_copy_bent_less,
                                 .lit = qtri_lit_list};
#else
static const qtri_fused lequal = {.flat = qtri_flat_lequal,
                                  .smooth = qtri_smooth_lequal,
                                  .copy = qtri_copy_lequal,
                                  .copy_bent = qtri_copy_bent_lequal,
                                  .lit = qtri_lit_list};
static const qtri_fused loops = {.flat = qtri_flat_less,
                                 .smooth = qtri_smooth_less,
                                 .copy = qtri_copy_less,
                                 .copy_bent = qtri_copy_bent_less,
                                 .lit = qtri_lit_list,
                                 .less_equal = &lequal};
#endif

const qtri_format qtri_rgb565 = {&qtri_pixels_16,    &qtri_colors_565, NULL,
                                 qtri_decode_rgb565, &loops,           QTRI_RGB565};
