/* SPDX-License-Identifier: MIT */
/*
 * What the ways to paint a picture share. Internal.
 *
 * Where rows are not just copied, up to 32 pixels are taken out of the picture as they are stored
 * there, with a mask of those that are painted, become pixels as the surface stores them, and are
 * stored or mixed: stages, so that formats need no loops of their own for each other.
 */
#ifndef QTRI_PAINT_PICTURE_H
#define QTRI_PAINT_PICTURE_H

#include "qtri/error.h"
#include "qtri/paint.h"

#include "mix_stored.h"
#include "../frame/pixel.h"

enum { QTRI_PICTURE_BATCH = 32 };

bool qtri_picture_is_usable(const qtri_image *image);

/* Whether a pixel means the same as a pixel of the surface. */
bool qtri_picture_is_alike(const qtri_image *image, const qtri_surface *surface);

/* The bits of a stored pixel that are compared with the key. */
uint32_t qtri_picture_key_mask(const qtri_image *image);

/* Paints `count` pixels, 1..QTRI_PICTURE_BATCH, as the picture stores them, a of 256. They change.
 */
void qtri_picture_put(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                      uint32_t *stored, int32_t count, uint32_t a);

#endif
