/* SPDX-License-Identifier: MIT */
#ifndef QTRI_TESTS_SUPPORT_EDGES_NARROW_H
#define QTRI_TESTS_SUPPORT_EDGES_NARROW_H

#include "draw/edge_walk.h"

/* draw/edge_walk.c without a divide: the same notes. */
void narrow_edge_note(const qtri_edge_walker *walker, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_vertex *c);

#endif
