/* SPDX-License-Identifier: MIT */
/*
 * Palettes: a picture of few colours as their list and a number for every pixel.
 */
#ifndef QTRI_HOST_IO_PALETTE_H
#define QTRI_HOST_IO_PALETTE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PALETTE_MAX 256

struct palette {
    uint8_t color[PALETTE_MAX][3]; /* in order of their first pixel; black beyond `count` */
    int count;
};

/*
 * Lists the colours of `count` pixels of 3 bytes. numbers: each pixel's place in the list, or NULL
 * when nobody asks. False if there are more than PALETTE_MAX.
 */
bool palette_make(struct palette *palette, const uint8_t *rgb, size_t count, uint8_t *numbers);

/* A colour's place in the list, -1 if it is not there. */
int palette_find(const struct palette *palette, const uint8_t rgb[3]);

#endif
