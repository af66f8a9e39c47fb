/* SPDX-License-Identifier: MIT */
#include "seed.h"

uint32_t qtri_rsqrt_seed(uint32_t t)
{
    return qtri_rsqrt_seed_in_place(t);
}
