/* SPDX-License-Identifier: MIT */
/*
 * qtri: a fixed-point 3D renderer for microcontroller displays.
 *
 *   mesh -> vertex stage -> cull and clip -> triangle setup -> pixels -> surface (a band of rows)
 *
 * Conventions, everywhere:
 *   - Column vectors; right-handed world; the camera looks down -z, +y is up;
 *     counter-clockwise, as seen in the picture, is front.
 *   - Clip space is OpenGL's: -w..w inside on all axes.
 *   - Angles are degrees in Q16.16: right angles are exact.
 *   - Image row 0 is the top, pixel centres are at +0.5, top-left fill rule in image coordinates.
 *   - Vertices snap to 8 sub-pixel bits, to nearest.
 *   - Depth is window z, 0 near and 1 far: 16 bits, 65535 farthest, unless format.h has another.
 *   - A variable that is not plain Q16.16 says so: x_24p8, inv_w_q31.
 *   - Rounding is to nearest unless the name says otherwise.
 *
 * Promises: no malloc, libm, float or writable statics; every function is defined for every
 * argument; the same inputs give the same pixels on every machine and for every split into bands.
 *
 *   q16.h        scalars: arithmetic, trigonometry, exponentials, text
 *   vec.h mat.h quat.h   vectors, matrices, quaternions
 *   transform.h  poses, cameras, projections at full precision
 *   view.h       how the world is seen: viewport, one light, vertex scratch, clipping
 *   light.h      several coloured lights, highlights
 *   surface.h    pixels and depths in memory          format.h     what a pixel and a depth are
 *   frame.h      a frame's bands, what has changed    texture.h    textures, what a texel is
 *   material.h   colour, shading, depth, blends, fog  mesh.h       indexed triangles, bounds
 *   draw.h       draw calls, the rasterizer alone     prepared.h   meshes for many bands
 *   pipeline.h   what draws pixels, pipelines and pixel functions of one's own
 *   stroke.h     lines of any width, smooth edges, points
 *   antialias.h  the edge pass, filters, sums of frames, 4 samples a pixel
 *   paint.h      flat shapes, pictures, text          shapes.h     spheres, boxes and others
 *   animation.h  keys, hierarchies, morphing
 *   config.h     what the library is built with       version.h    which one it is
 */
#ifndef QTRI_H
#define QTRI_H

#include "qtri/animation.h"
#include "qtri/antialias.h"
#include "qtri/config.h"
#include "qtri/draw.h"
#include "qtri/error.h"
#include "qtri/format.h"
#include "qtri/frame.h"
#include "qtri/light.h"
#include "qtri/mat.h"
#include "qtri/material.h"
#include "qtri/mesh.h"
#include "qtri/paint.h"
#include "qtri/prepared.h"
#include "qtri/q16.h"
#include "qtri/quat.h"
#include "qtri/shapes.h"
#include "qtri/stroke.h"
#include "qtri/surface.h"
#include "qtri/texture.h"
#include "qtri/transform.h"
#include "qtri/vec.h"
#include "qtri/version.h"
#include "qtri/view.h"

#endif
