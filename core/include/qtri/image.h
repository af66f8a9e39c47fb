/* SPDX-License-Identifier: MIT */
/*
 * Pictures on a surface: copied, with a colour key, blended, scaled and turned.
 *
 * A picture is memory in any format of surfaces: one drawn by the library itself, or constant data.
 * What has the surface's own format is copied as it is stored; anything else is converted through 8
 * bits a channel, 20 to 80 instructions a pixel on a Cortex-M0+. Everything is clipped, and a frame
 * in bands has the pixels of the whole frame. Depth is neither tested nor written.
 */
#ifndef QTRI_IMAGE_H
#define QTRI_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "paint.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct qtri_image {
    const void *pixels;        /* of row 0, aligned for the format; NULL: nothing is painted */
    ptrdiff_t pitch;           /* bytes from a row to the next; negative for bottom-up memory */
    const qtri_format *format; /* NULL: nothing is painted */
    int32_t width, height;     /* any of 1..QTRI_SURFACE_MAX; otherwise nothing is painted */
    bool has_key;
    uint32_t key; /* the stored pixel that is not painted, if has_key */
} qtri_image;

/* The picture that a surface holds: all rows of it, without a key. */
qtri_image qtri_image_of(const qtri_surface *surface);

/*
 * The picture with its left upper corner at column x, row y. Of RGB565 on RGB565: 4 instructions a
 * pixel at most, 9 with a key.
 */
void qtri_image_paint(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y);

/* The same, mixed with what is there: alpha of 255 is the picture alone, 0 paints nothing. */
void qtri_image_blend(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y,
                      uint8_t alpha);

/*
 * Where the pixels of a picture come to lie, Q16.16, x right and y down:
 *
 *     x' = xx x + xy y + x0        y' = yx x + yy y + y0
 */
typedef struct qtri_affine {
    q16 xx, xy, x0, yx, yy, y0;
} qtri_affine;

/*
 * Scales a picture by (scale_x, scale_y), turns it by degrees, clockwise as seen in the picture,
 * around its point `pivot`, and puts that to `place`: all Q16.16, pixels. Saturates.
 */
void qtri_affine_place(qtri_affine *affine, q16 pivot_x, q16 pivot_y, q16 place_x, q16 place_y,
                       q16 scale_x, q16 scale_y, q16 degrees);

/*
 * The picture as `affine` says: each pixel whose centre it covers takes the picture's pixel there,
 * nearest. One that does not turn and scales by 1 paints what qtri_image_blend does. A matrix
 * without an inverse, or with one beyond 16384, paints nothing. The inverse is rounded to Q16.16:
 * across n pixels the picture's coordinate is off by n / 131072 at most.
 *
 * Cheapest without a turn, where rows are rows of the picture; where it is opaque and has no key,
 * what is drawn twice as high or more is copied row by row. The picture may not lie in the surface.
 */
void qtri_image_paint_affine(const qtri_surface *surface, const qtri_image *image,
                             const qtri_affine *affine, uint8_t alpha);

#ifdef __cplusplus
}
#endif

#endif
