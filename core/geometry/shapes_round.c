/* SPDX-License-Identifier: MIT */
#include "shapes.h"
#include "plain.h"

#include "qtri/q16_trig.h"

enum qtri_error qtri_shape_sphere(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                  int32_t slices, int32_t rows)
{
    QTRI_ASSERT(qtri_is_length(radius));
    qtri_builder builder;
    const bool is_valid = qtri_is_count(slices, 3) && qtri_is_count(rows, 2);
    enum qtri_error error = qtri_builder_begin(
        &builder, mesh, memory, is_valid ? QTRI_SPHERE_VERTICES(slices, rows) : INT32_MAX,
        is_valid ? QTRI_SPHERE_TRIANGLES(slices, rows) : 0);
    if (error != QTRI_OK) {
        return error;
    }
    for (int32_t i = 0; i <= rows; i++) {
        qtri_ring ring;
        q16_sincos_deg(qtri_angle_of(i, 2 * rows), &ring.out, &ring.up);
        ring.radius = q16_mul(radius, ring.out);
        ring.y = q16_mul(radius, ring.up);
        ring.v = qtri_part_of(i, rows);
        qtri_builder_ring(&builder, slices, &ring);
        if (i > 0) {
            qtri_builder_join(&builder, slices, i == 1, i == rows);
        }
    }
    return qtri_builder_end(&builder);
}

enum qtri_error qtri_shape_torus(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                 q16 tube, int32_t slices, int32_t rings)
{
    QTRI_ASSERT(qtri_is_length(radius) && qtri_is_length(tube));
    qtri_builder builder;
    const bool is_valid = qtri_is_count(slices, 3) && qtri_is_count(rings, 3);
    enum qtri_error error = qtri_builder_begin(
        &builder, mesh, memory, is_valid ? QTRI_TORUS_VERTICES(slices, rings) : INT32_MAX,
        is_valid ? QTRI_TORUS_TRIANGLES(slices, rings) : 0);
    if (error != QTRI_OK) {
        return error;
    }
    for (int32_t i = 0; i <= rings; i++) { /* from the top outwards and down */
        qtri_ring ring;
        q16_sincos_deg(qtri_angle_of(i, rings), &ring.out, &ring.up);
        ring.radius = q16_add(radius, q16_mul(tube, ring.out));
        ring.y = q16_mul(tube, ring.up);
        ring.v = qtri_part_of(i, rings);
        qtri_builder_ring(&builder, slices, &ring);
        if (i > 0) {
            qtri_builder_join(&builder, slices, false, false);
        }
    }
    return qtri_builder_end(&builder);
}

/* A radius of 0 has the triangles of any other, though none has an area. */
static void add_disc(qtri_builder *builder, int32_t slices, q16 radius, q16 y, q16 up)
{
    const qtri_ring center = {0, y, 0, up, up > 0 ? 0 : Q16_ONE};
    const qtri_ring edge = {radius, y, 0, up, up > 0 ? 0 : Q16_ONE};
    qtri_builder_ring(builder, slices, up > 0 ? &center : &edge);
    qtri_builder_ring(builder, slices, up > 0 ? &edge : &center);
    qtri_builder_join(builder, slices, up > 0, up < 0);
}

enum qtri_error qtri_shape_cylinder(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                    q16 half_height, int32_t slices)
{
    QTRI_ASSERT(qtri_is_length(radius) && qtri_is_length(half_height));
    qtri_builder builder;
    const bool is_valid = qtri_is_count(slices, 3);
    enum qtri_error error = qtri_builder_begin(
        &builder, mesh, memory, is_valid ? QTRI_CYLINDER_VERTICES(slices) : INT32_MAX,
        is_valid ? QTRI_CYLINDER_TRIANGLES(slices) : 0);
    if (error != QTRI_OK) {
        return error;
    }
    const q16 low = q16_neg(half_height);
    const qtri_ring above = {radius, half_height, Q16_ONE, 0, 0};
    const qtri_ring below = {radius, low, Q16_ONE, 0, Q16_ONE};
    add_disc(&builder, slices, radius, half_height, Q16_ONE);
    qtri_builder_ring(&builder, slices, &above);
    qtri_builder_ring(&builder, slices, &below);
    qtri_builder_join(&builder, slices, false, false);
    add_disc(&builder, slices, radius, low, -Q16_ONE);
    return qtri_builder_end(&builder);
}

/* The side's normal is (2 half_height, radius), made 1 long: perpendicular to (radius, -2 h). */
enum qtri_error qtri_shape_cone(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                q16 half_height, int32_t slices)
{
    QTRI_ASSERT(qtri_is_length(radius) && qtri_is_length(half_height));
    qtri_builder builder;
    const bool is_valid = qtri_is_count(slices, 3);
    enum qtri_error error = qtri_builder_begin(&builder, mesh, memory,
                                               is_valid ? QTRI_CONE_VERTICES(slices) : INT32_MAX,
                                               is_valid ? QTRI_CONE_TRIANGLES(slices) : 0);
    if (error != QTRI_OK) {
        return error;
    }
    const q16 low = q16_neg(half_height);
    const qtri_vec2 side = {half_height, radius / 2};
    const qtri_vec2 normal = qtri_vec2_normalize(side);
    const qtri_ring above = {0, half_height, normal.x, normal.y, 0};
    const qtri_ring below = {radius, low, normal.x, normal.y, Q16_ONE};
    qtri_builder_ring(&builder, slices, &above);
    qtri_builder_ring(&builder, slices, &below);
    qtri_builder_join(&builder, slices, true, false);
    add_disc(&builder, slices, radius, low, -Q16_ONE);
    return qtri_builder_end(&builder);
}
