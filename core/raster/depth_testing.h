/* SPDX-License-Identifier: MIT */
/*
 * Depths of another format than linear16. Internal.
 *
 * They are tested as an effect is applied (effect.h): after the colours of a batch, which holds
 * fragments of one triangle or of a piece of one line, before fog and blend, and written after
 * those. To all stages before it the surface is one without depth. So nothing but this file knows
 * of such formats, no loop for linear16 asks for them, and triangles of all sizes, textures and
 * blends have them alike. The price is that colours are made of fragments that are hidden.
 */
#ifndef QTRI_RASTER_DEPTH_TESTING_H
#define QTRI_RASTER_DEPTH_TESTING_H

#include "../frame/depth_format.h"
#include "effect.h"

#endif
