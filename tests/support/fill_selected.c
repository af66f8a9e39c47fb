/* SPDX-License-Identifier: MIT */
/*
 * Pairs of pixels as on cores with the DSP extension.
 */
#define QTRI_SELECT 1

#define qtri_flat_pairs   selected_flat_pairs
#define qtri_smooth_pairs selected_smooth_pairs
#define qtri_copy_pairs   selected_copy_pairs

#define qtri_flat_pairs_lequal   selected_flat_pairs_lequal
#define qtri_smooth_pairs_lequal selected_smooth_pairs_lequal
#define qtri_copy_pairs_lequal   selected_copy_pairs_lequal

#include "fast/pairs.c"
