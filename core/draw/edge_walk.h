/* SPDX-License-Identifier: MIT */
/*
 * An edge of a mesh's outline, noted on the pixels that it passes through. Internal.
 */
#ifndef QTRI_DRAW_EDGE_WALK_H
#define QTRI_DRAW_EDGE_WALK_H

#include "qtri/edges.h"

/*
 * A note: share << 2 | direction. The share of the neighbour in 1/32, 1..16; the neighbour is the
 * pixel before (0) or after it (1) in the column, or in the row (2 and 3).
 */
enum { QTRI_NOTE_AFTER = 1, QTRI_NOTE_IN_ROW = 2, QTRI_NOTE_SHARE_SHIFT = 2 };

/* How stored depths are compared with those of edges. */
typedef enum qtri_edge_test {
    QTRI_EDGE_NEARER,  /* an edge is hidden by smaller ones */
    QTRI_EDGE_FARTHER, /* by greater ones */
    QTRI_EDGE_ALWAYS   /* never */
} qtri_edge_test;

/* One of the two axes that edges are walked along. */
typedef struct qtri_edge_axis {
    int32_t low, high;             /* pixels on it that count */
    int32_t first;                 /* on the other axis: the second pixel's border, and 2^-16 */
    uint32_t wide;                 /* pixels on it */
    uint32_t inner;                /* of these, those with two neighbours */
    int32_t along, across, origin; /* steps of a note's place, and that of (0, second pixel) */
    uint32_t direction;            /* of notes: in a row or not */
    uint32_t *marks;               /* as the walker's: loops need only the axis */
    uint16_t *notes;
    uint32_t flip;
} qtri_edge_axis;

/* What the edges of an outline share. */
typedef struct qtri_edge_walker {
    uint32_t *marks;
    uint16_t *notes;
    uint32_t flip; /* depths are compared after this is exclusive-ored: 0, or all of their bits */
    uint32_t weak; /* 0, or all bits: a pixel that has a note keeps it */
    bool hides;    /* depths are compared */
    qtri_edge_axis axis[2]; /* of edges that are longer in x, and in y */
} qtri_edge_walker;

/* For edges with bounds that are not empty; not weak at first. */
void qtri_edge_walker_init(qtri_edge_walker *walker, const qtri_edges *edges, qtri_edge_test test);

/*
 * Notes the edge from a to b of the face a b c. All three are inside all planes: coordinates within
 * +-QTRI_SCREEN_MAX_24P8.
 */
void qtri_edge_note(const qtri_edge_walker *walker, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_vertex *c);

#endif
