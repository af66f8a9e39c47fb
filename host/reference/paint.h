/* SPDX-License-Identifier: MIT */
/*
 * Flat shapes, text and pictures in double precision: the inside of a shape is a test of a point,
 * and what it covers of a pixel the share of 32 x 32 points in it.
 */
#ifndef QTRI_HOST_REFERENCE_PAINT_H
#define QTRI_HOST_REFERENCE_PAINT_H

#include "target.h"

void ref_paint(struct ref_target *target, const struct scene_paint *paint);

#endif
