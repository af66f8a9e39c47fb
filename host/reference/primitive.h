/* SPDX-License-Identifier: MIT */
/*
 * What passes between the stages of the reference: clip-space vertices and the triangle they form.
 *
 * Positions are long double behind the vertex stage. On x86 that is 64 bits of mantissa, so that
 * products of two doubles, and the edge functions made of them, keep bits to spare; where long
 * double is double the reference is only less of a ruler, not wrong.
 */
#ifndef QTRI_HOST_REFERENCE_PRIMITIVE_H
#define QTRI_HOST_REFERENCE_PRIMITIVE_H

#include <stdbool.h>
#include <stdint.h>

enum {
    REF_RED,
    REF_GREEN,
    REF_BLUE,
    REF_U,
    REF_V,
    REF_ALPHA,
    REF_NORMAL,
    REF_PLACE = REF_NORMAL + 3,
    REF_ATTRIBUTES = REF_PLACE + 3
};

struct ref_vertex {
    long double x, y, z, w;           /* clip space */
    double attribute[REF_ATTRIBUTES]; /* colour 0..255, texture coordinates, alpha 0..1; of what is
                                         lit by pixel a unit normal and a place, in eye space */
};

struct ref_lighting; /* light.h */

/* The three vertices already have the colours they are to be drawn with: lit, but where pixels
   are, and for flat shading all alike. */
struct ref_triangle {
    struct ref_vertex vertex[3];
    uint32_t id;
    bool textured;
    const struct ref_lighting *by_pixel; /* NULL: colours are lit */
};

/* The part of the picture that clip space fills, in pixels of the picture. */
struct ref_window {
    int x, y, width, height;
};

/* In homogeneous coordinates: window x = X / w. Dividing last keeps exact what is exact,
   (x/w + 1) W/2 would round three times. Row 0 is the top. */
static inline long double ref_window_x(const struct ref_vertex *v, const struct ref_window *window)
{
    return (v->x + v->w) * ((long double)window->width / 2) + window->x * v->w;
}

static inline long double ref_window_y(const struct ref_vertex *v, const struct ref_window *window)
{
    return (v->w - v->y) * ((long double)window->height / 2) + window->y * v->w;
}

#endif
