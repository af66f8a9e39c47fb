/* SPDX-License-Identifier: MIT */
/* What is between four texels, with options that are read for every pixel. */
#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#include "qtri/body/texel.h"

#include "descriptions.h"

uint32_t qtri_texel_between(const qtri_pixel_walk *w, bool *drawn)
{
    return qtri_texel_bilinear(&w->state->options, w, drawn);
}
