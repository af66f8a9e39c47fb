/* SPDX-License-Identifier: MIT */
/*
 * Edges of outlines, noted on the pixels that they pass through. Internal.
 */
#ifndef QTRI_DRAW_EDGE_PASS_H
#define QTRI_DRAW_EDGE_PASS_H

#include "qtri/antialias.h"

/* The pixels that edges of one major axis are walked along. */
typedef struct qtri_edge_axis {
    int32_t low, high;  /* pixels low .. high - 1 on the major axis */
    int32_t first;      /* the first pixel's centre on the minor axis, plus 2^-16; 16.16 */
    uint32_t pairs;     /* pixels on the minor axis, less one */
    int32_t along;      /* from a note to the next on the major axis, */
    int32_t across;     /*   and on the minor one */
    int32_t origin;     /* index of the note at 0 of the major axis, the first pixel of the minor */
    uint32_t direction; /* of notes: 0, neighbours in a column, or NOTE_IN_ROW */
    uint32_t *marks;
    uint16_t *notes;
    uint32_t flip; /* depths are compared after this is exclusive-ored: 0, or all of their bits */
    uint32_t weak; /* 0, or all bits: a pixel that has a note keeps it */
    bool hides;    /* nearer depths hide the edge */
} qtri_edge_axis;

/* For a pass whose bounds are not empty: axis[0] is for edges longer in x, axis[1] in y. Stored
   depths hide edges as `compare`, of what was drawn, says. */
void qtri_edge_axes_init(qtri_edge_axis axis[2], const qtri_edges *edges, qtri_compare compare);

/*
 * Notes the edge from a to b of the face a b c. All three are inside all planes: coordinates are
 * within +-QTRI_SCREEN_MAX_24P8.
 */
void qtri_edge_note(const qtri_edge_axis axis[2], const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_vertex *c);

#endif
