/* SPDX-License-Identifier: MIT */
/*
 * What an emulated display shows: pictures that a board draws in bands and sends to its display,
 * and that the host draws as whole frames, to compare them pixel by pixel.
 *
 * Each display board's firmware and the host's program for it are linked with one show_*.c.
 */
#ifndef QTRI_DISPLAY_SHOW_H
#define QTRI_DISPLAY_SHOW_H

#include <stddef.h>
#include <stdint.h>

#include "qtri.h"

typedef struct display_show {
    const qtri_format *format;
    int32_t width, height;
    int32_t band_rows; /* of the board's bands */
    qtri_rgb background;
    uint32_t frames;
    size_t bytes; /* of memory, for all the functions below */

    void (*prepare)(void *memory); /* once */

    /* Before each frame, in order; gives the scene's name, which several frames may share. */
    const char *(*advance)(void *memory, uint32_t frame);

    /* The frame, or a band of it. */
    void (*draw)(void *memory, const qtri_surface *surface);
} display_show;

extern const display_show display_show_here;

#endif
