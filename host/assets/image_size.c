/* SPDX-License-Identifier: MIT */
#include "image.h"

const char *image_size_problem(long width, long height)
{
    if (width < 1 || height < 1 || width > IMAGE_MAX_SIDE || height > IMAGE_MAX_SIDE) {
        return "has a side that is not in 1..16384";
    }
    return width > IMAGE_MAX_PIXELS / height ? "has more than 8192 x 8192 pixels" : NULL;
}
