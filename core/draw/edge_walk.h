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

/*
 * Notes the edge from a to b of the face a b c. `weak`: only on pixels without a note. All three
 * are inside all planes: coordinates within +-QTRI_SCREEN_MAX_24P8.
 */
void qtri_edge_note(const qtri_edges *edges, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_vertex *c, qtri_edge_test test, bool weak);

#endif
