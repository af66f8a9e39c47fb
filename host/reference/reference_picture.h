/* SPDX-License-Identifier: MIT */
/*
 * The reference's picture in the format of a display.
 */
#ifndef QTRI_HOST_REFERENCE_REFERENCE_PICTURE_H
#define QTRI_HOST_REFERENCE_REFERENCE_PICTURE_H

#include "../io/picture.h"
#include "reference.h"

enum reference_format {
    REFERENCE_RGB888,
    REFERENCE_RGB565, /* each channel to the nearest of 32 or 64 levels, expanded to 8 bits again */
    REFERENCE_GRAY8   /* luma .299 .587 .114, the same in all three channels */
};

/* Quantises the colours, to nearest, half up; copies id and depth. False when memory runs out. */
bool reference_picture(const struct reference_image *image, enum reference_format format,
                       struct picture *picture);

#endif
