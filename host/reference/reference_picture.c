/* SPDX-License-Identifier: MIT */
#include "reference_picture.h"

#include <math.h>
#include <string.h>

/* c in 0..255 to the nearest of `greatest` + 1 levels, and back to 8 bits. */
static uint8_t quantise(double c, double greatest)
{
    double level = floor(c * greatest / 255.0 + 0.5);
    double byte = floor(level * 255.0 / greatest + 0.5);

    return (uint8_t)fmax(0.0, fmin(255.0, byte));
}

bool reference_picture(const struct reference_image *image, enum reference_format format,
                       struct picture *picture)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;

    if (!picture_create(picture, image->width, image->height, true))
        return false;
    for (size_t i = 0; i < pixels; i++) {
        const double *c = &image->color[3 * i];
        uint8_t *rgb = &picture->rgb[3 * i];
        double luma = 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
        bool gray = format == REFERENCE_GRAY8;
        bool packed = format == REFERENCE_RGB565;

        for (int k = 0; k < 3; k++)
            rgb[k] = quantise(gray ? luma : c[k], !packed ? 255.0 : k == 1 ? 63.0 : 31.0);
    }
    memcpy(picture->id, image->id, pixels * sizeof *picture->id);
    memcpy(picture->depth, image->depth, pixels * sizeof *picture->depth);
    return true;
}
