/* SPDX-License-Identifier: MIT */
/*
 * Anti-aliasing: five ways, each with the same pixels for every band and scissor.
 *
 *   edges.h   the edge pass: outlines of meshes. What to use first: the best edges for 10 to 20 %
 *             more instructions and a bit a pixel.
 *   filters.h   2x2 samples: all edges and what is in them, for three times the work;
 *             FXAA: pictures whose geometry is not at hand;
 *             sums of frames: what rests, as smooth as there is time for.
 *   samples.h   4 samples a pixel: triangles that cut through each other; shaded once a pixel.
 *
 * Wireframes have lines of their own, &qtri_smooth_wireframe (stroke.h).
 *
 * frame.h has bands that overlap, which the first and FXAA need; jitter.h the views of which sums
 * are made. `make antialias` prints how good each is, what it costs and what memory it takes.
 */
#ifndef QTRI_ANTIALIAS_H
#define QTRI_ANTIALIAS_H

#include "edges.h"
#include "filters.h"
#include "jitter.h"
#include "samples.h"

#endif
