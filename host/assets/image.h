/* SPDX-License-Identifier: MIT */
/*
 * Pictures with transparency, read from PNG, JPEG, PPM and PGM, and pictures written as PNG.
 */
#ifndef QTRI_HOST_ASSETS_IMAGE_H
#define QTRI_HOST_ASSETS_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../io/picture.h"
#include "../io/text_error.h"

/* A few kilobytes can unpack to any number of pixels: what a picture takes has a bound. */
#define IMAGE_MAX_SIDE   16384
#define IMAGE_MAX_PIXELS (1L << 26) /* 8192 x 8192 */

/* What is wrong with a picture of this size, or NULL. */
const char *image_size_problem(long width, long height);

/* Row 0 is the top; 4 bytes a pixel: sRGB, and how opaque it is. */
struct image {
    int width, height;
    uint8_t *rgba;
};

/* The first bytes decide: PNG and JPEG (where libstb was there when this was built), P5, P6. "-" is
   standard input. False with *error set. */
bool image_read(const char *path, struct image *image, struct text_error *error);
bool image_parse(const char *path, const char *bytes, size_t length, struct image *image,
                 struct text_error *error);
bool image_parse_stb(const char *path, const char *format, const char *bytes, size_t length,
                     struct image *image, struct text_error *error);
void image_free(struct image *image);

/* Writes PNG to a path that ends in .png, else PPM. False with *error set. */
bool image_write_picture(const char *path, const struct picture *picture, struct text_error *error);

#endif
