/* SPDX-License-Identifier: MIT */
/*
 * Polygons cut into triangles.
 */
#ifndef QTRI_HOST_IO_POLYGON_H
#define QTRI_HOST_IO_POLYGON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/*
 * Cuts a polygon of `count` corners, 3 or more, all finite, into count - 2 triangles of corner
 * indices, which go round as it does. It is a fan about corner 0 wherever that fan is right, as of
 * every convex polygon; otherwise ears are clipped. What has no area as seen along its normal is a
 * fan; what crosses itself is cut somehow.
 */
void polygon_triangulate(const double (*corners)[3], size_t count, uint32_t (*triangles)[3]);

#endif
