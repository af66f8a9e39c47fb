/*
 * Pairs of pixels as on cores with the DSP extension.
 */
#define QTRI_SELECT 1

#define qtri_fill_flat_pairs   selected_fill_flat_pairs
#define qtri_fill_packed_pairs selected_fill_packed_pairs
#define qtri_run_copy_pairs    selected_run_copy_pairs

#include "raster/fill_pairs.c"
