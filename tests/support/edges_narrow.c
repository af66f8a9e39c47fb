/* SPDX-License-Identifier: MIT */
/*
 * The walk along edges compiled for a core without a divide.
 */
#define QTRI_DIVIDE 0

#define qtri_edge_note        narrow_edge_note
#define qtri_edge_walker_init narrow_edge_walker_init

#include "draw/edge_walk.c"
