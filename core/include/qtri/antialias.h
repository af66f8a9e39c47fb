/*
 * Anti-aliasing: four ways, each with the same pixels for every band and scissor.
 *
 *   edges.h   the edge pass: outlines of meshes. What to use first.
 */
#ifndef QTRI_ANTIALIAS_H
#define QTRI_ANTIALIAS_H

#include "edges.h"
#include "halo.h"

#endif
