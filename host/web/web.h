/* SPDX-License-Identifier: MIT */
/*
 * The functions of the page's WebAssembly module, besides those of web_files.h. What goes wrong is
 * one line on standard error, which the page shows.
 */
#ifndef QTRI_HOST_WEB_WEB_H
#define QTRI_HOST_WEB_WEB_H

#include <stdint.h>

enum web_picture { WEB_CORE, WEB_DOUBLE, WEB_DIFFERENCE };

/* Doubles alone: the page reads them as an array, in this order. */
struct web_figures {
    double triangles, pixels;        /* asked for; covered */
    double band_bytes;               /* RAM for colour and depth */
    double m0plus, m3;               /* instructions, scene_cost.h; 0: unknown */
    double cost_error;               /* of these, percent */
    double differing, largest_error; /* pixels; of 255: of the last WEB_DIFFERENCE */
};

/* `qtri model` with files of web_files.h; the exit status. */
int web_model(int argc, char **argv);

/* What such a command's header holds, as it stands at first: each part as shown_N.obj, each texture
   as shown_N.ppm, and a line on standard output for each part, as web_show.c says. 0, or 1: out of
   memory. */
int web_show(int argc, char **argv);

/* Reads the scene that is drawn from now on; 0, or 1: then it is empty. */
int web_scene(const char *path);

/*
 * Rows of 3 bytes a pixel, of the scene as seen by cameras of `orbit` at an azimuth of so many
 * degrees; NULL: out of memory. format: 0 RGB565, 1 XRGB8888, 2 GRAY8; rows: of a band, 0: one
 * band. A difference is that of the other two as they were drawn last.
 */
const uint8_t *web_draw(enum web_picture what, int format, int rows, int degrees);

/* What such a frame takes; NULL: out of memory. */
const struct web_figures *web_count(int format, int rows, int degrees);

#endif
