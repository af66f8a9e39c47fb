/* SPDX-License-Identifier: MIT */
/*
 * Pictures as both renderers deliver them, and PPM files.
 */
#ifndef QTRI_HOST_IO_PICTURE_H
#define QTRI_HOST_IO_PICTURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "text_error.h"

/* Row 0 is the top. `id` and `depth` are NULL where nobody asked for them. */
struct picture {
    int width, height;
    uint8_t *rgb;  /* 3 bytes a pixel */
    uint32_t *id;  /* id of the visible triangle, 0 = background */
    double *depth; /* window depth 0..1 */
};

/* Allocates (zeroed) what is asked for; false when memory runs out or a side is < 1. */
bool picture_create(struct picture *picture, int width, int height, bool with_dump);
void picture_free(struct picture *picture);

/*
 * Reads a binary PPM (P6, maxval 1..255 scaled to 255, comments allowed, sides up to 10^6, bytes
 * behind the first picture ignored) / writes one.
 * Writing goes to a temporary file beside the target that is renamed at the end, so that a failed
 * write leaves no partial picture behind. False with *error set on failure.
 */
bool picture_read_ppm(const char *path, struct picture *picture, struct text_error *error);
bool picture_write_ppm(const char *path, const struct picture *picture, struct text_error *error);

/* The header of a binary PPM or PGM, whose samples follow. Returns what is wrong, or NULL. */
struct pnm {
    int width, height, maximum, channels;
    size_t length; /* bytes before the samples */
};
const char *pnm_header(const char *bytes, size_t length, struct pnm *pnm);

/* A channel of a pixel, of 255. */
uint8_t pnm_sample(const struct pnm *pnm, const char *bytes, size_t pixel, int channel);

/*
 * PREFIX.id (uint32 little-endian) and PREFIX.depth (float64 little-endian), top row first.
 * Writing passes over a member that is NULL; as above, each file is complete or not there. Reading
 * expects the picture's size and allocates id and depth; a file that does not exist leaves the
 * member NULL and is no error, one of another size is.
 */
bool picture_write_dump(const char *prefix, const struct picture *picture,
                        struct text_error *error);
bool picture_read_dump(const char *prefix, struct picture *picture, struct text_error *error);

#endif
