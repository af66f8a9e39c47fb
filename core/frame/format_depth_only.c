/* SPDX-License-Identifier: MIT */
/*
 * A format without pixels: what is drawn on it leaves depth alone.
 */
#include "qtri/format.h"

static uint32_t load(const uint8_t *pixel)
{
    (void)pixel;
    return 0;
}

/* The types of qtri_pixels: NOLINTBEGIN(readability-non-const-parameter) */
static void fill(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count)
{
    (void)pixel;
    (void)stored;
    (void)mask;
    (void)count;
}

static void store(uint8_t *pixel, const uint32_t *stored, uint32_t mask, int32_t count)
{
    (void)pixel;
    (void)stored;
    (void)mask;
    (void)count;
}

/* NOLINTEND(readability-non-const-parameter) */

static uint32_t decode(uint32_t stored)
{
    (void)stored;
    return 0;
}

static const qtri_pixels no_pixels = {0, load, fill, store};

const qtri_format qtri_depth_only = {&no_pixels, &qtri_colors_gray, NULL, decode,
                                     NULL,       QTRI_DEPTH_ONLY};
