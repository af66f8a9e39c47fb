/* SPDX-License-Identifier: MIT */
#include "../raster/loop.h"
#include "fused.h"

#define NAME   qtri_flat_less
#define PASSES <
#include "flat.inc"

#ifndef __OPTIMIZE_SIZE__
#define NAME   qtri_flat_lequal
#define PASSES <=
#include "flat.inc"
#endif
