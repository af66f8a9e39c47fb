/* SPDX-License-Identifier: MIT */
/*
 * A page of panels, one above the other, each with the errors over an axis; as SVG. A panel shows
 * the least and the largest error of every column, the mean, and the limits.
 */
#ifndef QTRI_VERIFY_SVG_H
#define QTRI_VERIFY_SVG_H

#include <stdbool.h>
#include <stdio.h>

enum { SVG_COLUMNS = 900 };

typedef struct svg_column {
    double low, high, sum; /* of the errors in it */
    int count;             /* 0: nothing in this column */
} svg_column;

enum svg_scale {
    SVG_LINEAR,
    SVG_TURNS, /* radians; ticks as multiples of pi */
    SVG_POWERS /* logarithmic; ticks as powers of two */
};

typedef struct svg_axis {
    const char *title;      /* of the panel */
    const char *label;      /* what the axis is, with its unit */
    double low, high, step; /* of the ticks: a sum or, SVG_POWERS, a factor */
    enum svg_scale scale;
    bool magnitude;     /* |error|: its largest only, a limit on one side */
    double bottom, top; /* of the vertical axis, in ULP */
    double limit;       /* drawn where it is within */
} svg_axis;

void svg_begin(FILE *file, const char *title, int panels);
void svg_panel(FILE *file, int index, const svg_axis *axis, const svg_column *column);
void svg_end(FILE *file);

#endif
