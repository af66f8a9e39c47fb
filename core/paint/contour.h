/* SPDX-License-Identifier: MIT */
/*
 * Filled contours: edges of lines and arcs, scan-converted row by row. Internal.
 *
 * A shape is a contour: edges that go down the picture, straight ones and quarters of circles,
 * each with the direction in which the contour passes it. A row of pixels is painted from the edges
 * that cross it, and knows nothing of other rows: any split into bands paints the same.
 */
#ifndef QTRI_PAINT_CONTOUR_H
#define QTRI_PAINT_CONTOUR_H

#include "painter.h"

/* x = center_x + side sqrt(r r - (y - center_y)^2), 24.8; side: 1 or -1. */
typedef struct qtri_ink_arc {
    int32_t center_x, center_y, side;
} qtri_ink_arc;

/* 2^62 over the edge's height times 2^zeros, below 2^31; 0: it goes straight down. */
typedef struct qtri_ink_line {
    uint32_t reciprocal;
    int32_t zeros;
} qtri_ink_line;

/* An edge from (x0, y0) down to (x1, y1), y0 < y1, half-open in y. */
typedef struct qtri_ink_edge {
    int32_t x0, y0, x1, y1; /* 24.8 */
    int32_t radius;         /* 0: straight */
    int32_t winding;        /* +1: the contour goes down here, -1: up */
    union {
        qtri_ink_arc arc;
        qtri_ink_line line;
    } as;
} qtri_ink_edge;

/* Edges, or the sides of a polygon. */
typedef struct qtri_contour {
    const qtri_ink_edge *edges;
    const qtri_point *points; /* NULL: edges */
    int32_t count;            /* of edges, or of points */
} qtri_contour;

/* Half of the chord, 24.8, of an arc's circle at y, which is within the circle. */
int32_t qtri_ink_half_chord(const qtri_ink_edge *arc, int32_t y_24p8);

/*
 * Whether two edges of a contour that both reach a height there are arcs around centres of one
 * height: those of one radius. Circles and rings have one centre, and of a rounded rectangle the
 * corners above end where those below begin or before. `arc` may be NULL, `edge` a line.
 */
static inline bool qtri_ink_is_mirrored(const qtri_ink_edge *arc, const qtri_ink_edge *edge)
{
    return arc != NULL && arc->radius == edge->radius;
}

/* Paints the pixels of a row whose centres lie inside: edges are not smooth. */
void qtri_hard_row(const qtri_painter *painter, const qtri_contour *contour, int32_t row);

/* Paints a contour. */
void qtri_paint_contour(const qtri_surface *surface, const qtri_contour *contour,
                        const qtri_brush *brush);

/* ---- The edges of a contour that cross a row ---- */

/* The piece of an edge within a row. */
typedef struct qtri_crossing {
    int32_t x0, x1; /* 24.8 at y0 and y1 */
    int32_t y0, y1; /* in 1/256 below the row's upper side, 0 <= y0 < y1 <= 256 */
    int32_t winding;
    const qtri_ink_edge *arc; /* NULL: straight */
} qtri_crossing;

/* Those that are looked at more than once a row are kept, so that most edges are cut only once. */
enum { QTRI_CROSSINGS_KEPT = 12 };

typedef struct qtri_crossings {
    const qtri_contour *contour;
    int32_t row_24p8;     /* the row's upper side */
    int32_t first;        /* no crossing begins left of this column */
    int32_t kept, others; /* crossings that are kept, and the first edge behind them */
    qtri_crossing crossing[QTRI_CROSSINGS_KEPT];
} qtri_crossings;

void qtri_crossings_init(qtri_crossings *crossings, const qtri_contour *contour, int32_t row);

/* The next crossing; NULL after the last. *position begins with 0. `room` is for one not kept. */
const qtri_crossing *qtri_crossings_next(const qtri_crossings *crossings, int32_t *position,
                                         qtri_crossing *room);

/* ---- Contours put together from straight lines and arcs ---- */

/* At most, for an arc of a ring: five quarters or parts of them outside, five inside, two ends. */
enum { QTRI_PATH_EDGES = 12 };

typedef struct qtri_path {
    int32_t count;
    int32_t direction; /* of edges that are added: +1 as given, -1 reversed */
    qtri_ink_edge edge[QTRI_PATH_EDGES];
} qtri_path;

static inline void qtri_path_init(qtri_path *path)
{
    path->count = 0;
    path->direction = 1;
}

/* Adds a line. */
void qtri_path_line(qtri_path *path, const qtri_point *from, const qtri_point *to);

/*
 * Adds the part between y0 <= y1, both inside it, of a quarter of a circle, clockwise on the
 * screen: 0 from the right down, 1 from there to the left, 2 up, 3 to the right.
 */
void qtri_path_quarter(qtri_path *path, const qtri_point *center, int32_t radius_24p8,
                       int32_t quarter, int32_t y0_24p8, int32_t y1_24p8);

/* Adds a circle; a radius of 0 adds nothing. */
void qtri_path_circle(qtri_path *path, const qtri_point *center, int32_t radius_24p8);

void qtri_path_paint(const qtri_path *path, const qtri_surface *surface, const qtri_brush *brush);

#endif
