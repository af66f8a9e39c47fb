/* SPDX-License-Identifier: MIT */
/*
 * Outlines from inside: who looks for edges in what faces the eye. Internal.
 *
 * A drawing, or a prepared mesh, notes what faces the eye: outline_draw.c, front_bits.h. From that
 * outline_find.c finds edges, of which outline.c makes lists, or walks along them.
 */
#ifndef QTRI_DRAW_OUTLINE_H
#define QTRI_DRAW_OUTLINE_H

#include "qtri/edges.h"

#include "front_bits.h"

/* Nothing of it is seen. */
void qtri_outline_clear(qtri_outline *outline);

/* After facing is known: what the edges' search needs of a drawing in this memory of vertices. */
void qtri_outline_set(qtri_outline *outline, qtri_vertex *vertices, const qtri_view *view,
                      const qtri_transform *pose, const qtri_material *material, int32_t width,
                      int32_t height);

#endif
