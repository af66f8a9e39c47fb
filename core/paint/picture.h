/* SPDX-License-Identifier: MIT */
/*
 * What both ways to paint an image share, upright and affine. Internal.
 *
 * Where rows are not just copied, up to 32 stored pixels are loaded from the image, with a mask of
 * those that are painted, converted to the surface's format, and stored or blended: stages, so that
 * no pair of formats needs a loop of its own.
 */
#ifndef QTRI_PAINT_PICTURE_H
#define QTRI_PAINT_PICTURE_H

#include "qtri/error.h"
#include "qtri/paint.h"

#include "mix_stored.h"
#include "../frame/pixel.h"

enum { QTRI_PICTURE_BATCH = 32 };

/* Whether it has pixels, a format, and sides of 1..QTRI_SURFACE_MAX. */
bool qtri_picture_is_usable(const qtri_image *image);

/* Whether image and surface store pixels in one format. */
bool qtri_picture_is_alike(const qtri_image *image, const qtri_surface *surface);

/* Whether both are RGB565, in different orders of bytes. */
bool qtri_picture_is_swapped(const qtri_image *image, const qtri_surface *surface);

/* The bits of a stored pixel that are compared with the key. */
uint32_t qtri_picture_key_mask(const qtri_image *image);

/* Paints `count` pixels, 1..QTRI_PICTURE_BATCH, in the image's format; a of 256. They change. */
void qtri_picture_put(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                      uint32_t *stored, int32_t count, uint32_t a);

#endif
