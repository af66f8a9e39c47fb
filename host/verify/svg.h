/*
 * A page of panels, one above the other, each with an envelope over an axis; as SVG.
 */
#ifndef QTRI_VERIFY_SVG_H
#define QTRI_VERIFY_SVG_H

#include <stdbool.h>
#include <stdio.h>

enum { SVG_COLUMNS = 900 };

typedef struct svg_interval {
    double low, high; /* low > high: nothing in this column */
} svg_interval;

extern const svg_interval svg_empty;

typedef struct svg_axis {
    const char *label;
    double low, high, step; /* of the ticks: a sum or, logarithmic, a factor */
    bool logarithmic;
    double bottom, top; /* of the vertical axis, in ULP */
    double limit;       /* drawn where it is within */
} svg_axis;

void svg_begin(FILE *file, const char *title, int panels);
void svg_panel(FILE *file, int index, const svg_axis *axis, const svg_interval *column);
void svg_end(FILE *file);

#endif
