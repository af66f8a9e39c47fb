/* SPDX-License-Identifier: MIT */
/*
 * What computed meshes are put together with. Internal.
 */
#ifndef QTRI_GEOMETRY_SHAPES_H
#define QTRI_GEOMETRY_SHAPES_H

#include <stdbool.h>
#include <stddef.h>

#include "qtri/shapes.h"

enum { QTRI_SHAPE_MOST = 1024 };

typedef struct qtri_builder {
    const qtri_shape_memory *memory;
    qtri_mesh *mesh;
} qtri_builder;

typedef struct qtri_ring {
    q16 radius, y;
    q16 out, up; /* the normal: away from the axis, and along it */
    q16 v;
} qtri_ring;

/* An empty mesh with room for so many, or an error. */
enum qtri_error qtri_builder_begin(qtri_builder *builder, qtri_mesh *mesh,
                                   const qtri_shape_memory *memory, int32_t vertices,
                                   int32_t triangles);
enum qtri_error qtri_builder_end(const qtri_builder *builder);

/* The new vertex's number; the normal's parts are held to -1..1. */
uint16_t qtri_builder_vertex(qtri_builder *builder, qtri_vec3 position, qtri_vec3 normal, q16 u,
                             q16 v);
void qtri_builder_triangle(qtri_builder *builder, uint32_t a, uint32_t b, uint32_t c);
void qtri_builder_ring(qtri_builder *builder, int32_t slices, const qtri_ring *ring);
void qtri_builder_join(qtri_builder *builder, int32_t slices, bool is_point_above,
                       bool is_point_below);

/* i / count, and of a whole turn in degrees, rounded. */
q16 qtri_part_of(int32_t i, int32_t count);
q16 qtri_angle_of(int32_t i, int32_t count);

static inline bool qtri_is_count(int32_t n, int32_t least)
{
    return n >= least && n <= QTRI_SHAPE_MOST;
}

#endif
