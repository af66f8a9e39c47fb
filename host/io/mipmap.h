/* SPDX-License-Identifier: MIT */
/*
 * Smaller levels of a picture: each pixel the mean of those it stands for, in linear light.
 */
#ifndef QTRI_HOST_IO_MIPMAP_H
#define QTRI_HOST_IO_MIPMAP_H

#include <stdbool.h>
#include <stdint.h>

/* sRGB of IEC 61966-2-1 as linear light, and back: 0..1 both ways. */
double mipmap_to_linear(double value);
double mipmap_from_linear(double value);

/* Of a side that is a power of two. */
uint8_t mipmap_log2(int side);

/* A side after `level` times its half, 1 at least. */
int mipmap_side(int side, int level);

/* How many levels the core uses besides the first: widths end at 2. */
int mipmap_count(int width);

/*
 * A level of a picture of sRGB and how opaque, 4 bytes a pixel, whose sides are powers of two: a
 * box filter in linear light, weighted by how opaque pixels are. out: 4 bytes a pixel of
 * mipmap_side(width, level) by mipmap_side(height, level), black where all is transparent.
 */
void mipmap_level(const uint8_t *rgba, int width, int height, int level, uint8_t *out);

#endif
