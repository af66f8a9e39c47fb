/* SPDX-License-Identifier: MIT */
/*
 * Meshes of boxes, grids, spheres, tori, cylinders and cones, built of rings and quads.
 */
#include "qtri/error.h"
#include "qtri/mesh.h"
#include "qtri/q16.h"
#include "qtri/shapes.h"

#include <stdbool.h>
#include <stddef.h>

#include "../bits/bits.h"
#include "plain.h"

enum { SHAPE_COUNT_MAX = 1024 };

typedef struct shape_builder {
    const qtri_shape_memory *memory;
    qtri_mesh *mesh;
} shape_builder;

typedef struct shape_ring {
    q16 radius, y;
    q16 out, up; /* the normal: away from the axis, and along it */
    q16 v;
} shape_ring;

static inline bool is_count(int32_t n, int32_t least)
{
    return n >= least && n <= SHAPE_COUNT_MAX;
}

/* Begins an empty mesh; an error if memory has no room for so many vertices and triangles. */
static enum qtri_error builder_begin(shape_builder *builder, qtri_mesh *mesh,
                                     const qtri_shape_memory *memory, int32_t vertices,
                                     int32_t triangles)
{
    static const qtri_mesh nothing;
    QTRI_ASSERT(mesh != NULL && memory != NULL);
    QTRI_ASSERT(memory->positions != NULL || memory->vertices == 0);
    QTRI_ASSERT(memory->triangles != NULL || memory->triangle_count == 0);
    *mesh = nothing;
    builder->memory = memory;
    builder->mesh = mesh;
    if (vertices > 65536) {
        return QTRI_ERROR_SIZE;
    }
    if ((uint32_t)vertices > memory->vertices || (uint32_t)triangles > memory->triangle_count) {
        return QTRI_ERROR_MEMORY;
    }
    mesh->positions = memory->positions;
    mesh->normals = memory->normals;
    mesh->uvs = memory->uvs;
    mesh->triangles = (const uint16_t(*)[3])memory->triangles;
    return QTRI_OK;
}

static enum qtri_error builder_end(const shape_builder *builder)
{
    builder->mesh->bounds = qtri_mesh_box(builder->mesh);
    return QTRI_OK;
}

static int16_t q14(q16 unit)
{
    return (int16_t)((qtri_hold32(unit, -Q16_ONE, Q16_ONE) + 2) >> 2);
}

/* Adds a vertex and returns its index; the normal's components are clamped to -1..1. */
static uint16_t builder_vertex(shape_builder *builder, qtri_vec3 position, qtri_vec3 normal, q16 u,
                               q16 v)
{
    const qtri_shape_memory *memory = builder->memory;
    const uint32_t i = builder->mesh->vertex_count++;
    memory->positions[i] = position;
    if (memory->normals != NULL) {
        const qtri_normal n = {q14(normal.x), q14(normal.y), q14(normal.z)};
        memory->normals[i] = n;
    }
    if (memory->uvs != NULL) {
        const qtri_vec2 uv = {u, v};
        memory->uvs[i] = uv;
    }
    return (uint16_t)i;
}

static void builder_triangle(shape_builder *builder, uint32_t a, uint32_t b, uint32_t c)
{
    uint16_t *triangle = builder->memory->triangles[builder->mesh->triangle_count++];
    triangle[0] = (uint16_t)a;
    triangle[1] = (uint16_t)b;
    triangle[2] = (uint16_t)c;
}

/* i / count, rounded. */
static q16 part_of(int32_t i, int32_t count)
{
    return (q16)(((int64_t)i * 65536 + count / 2) / count);
}

/* i / count of a turn, in degrees; the last is the first. */
static q16 angle_of(int32_t i, int32_t count)
{
    return i == count ? 0 : (q16)(((int64_t)i * 360 * 65536 + count / 2) / count);
}

/*
 * Adds a circle around the y axis of slices + 1 vertices, the first and the last at one position.
 * Seen from outside they go to the right, so that (left above, left below, right below) is
 * counter-clockwise.
 */
static void builder_ring(shape_builder *builder, int32_t slices, const shape_ring *ring)
{
    for (int32_t i = 0; i <= slices; i++) {
        q16 sine;
        q16 cosine;
        q16_sincos_deg(angle_of(i, slices), &sine, &cosine);
        const qtri_vec3 position = {q16_mul(ring->radius, sine), ring->y,
                                    q16_mul(ring->radius, cosine)};
        const qtri_vec3 normal = {q16_mul(ring->out, sine), ring->up, q16_mul(ring->out, cosine)};
        builder_vertex(builder, position, normal, part_of(i, slices), ring->v);
    }
}

/* Adds triangles between the last two rings, but none without area where a ring is a point. */
static void builder_join(shape_builder *builder, int32_t slices, bool is_point_above,
                         bool is_point_below)
{
    const uint32_t ring = (uint32_t)slices + 1;
    const uint32_t above = builder->mesh->vertex_count - 2 * ring;
    for (uint32_t i = above; i < above + (uint32_t)slices; i++) {
        if (!is_point_below) {
            builder_triangle(builder, i, i + ring, i + ring + 1);
        }
        if (!is_point_above) {
            builder_triangle(builder, i, i + ring + 1, i + 1);
        }
    }
}

/* ---- Flat shapes ---- */

static void add_quad(shape_builder *builder, uint32_t above_left, uint32_t below_left,
                     uint32_t below_right, uint32_t above_right)
{
    builder_triangle(builder, above_left, below_left, below_right);
    builder_triangle(builder, above_left, below_right, above_right);
}

static qtri_vec3 scaled(const qtri_vec3 *half, const int8_t sign[3])
{
    const qtri_vec3 v = {sign[0] < 0 ? q16_neg(half->x) : half->x,
                         sign[1] < 0 ? q16_neg(half->y) : half->y,
                         sign[2] < 0 ? q16_neg(half->z) : half->z};
    return v;
}

enum qtri_error qtri_shape_box(qtri_mesh *mesh, const qtri_shape_memory *memory, qtri_vec3 half)
{
    QTRI_ASSERT(qtri_is_length(half.x) && qtri_is_length(half.y) && qtri_is_length(half.z));
    /* For each side: its normal, and what is right and up as seen from outside. */
    static const int8_t sides[6][3][3] = {
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},   {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
        {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},  {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
    static const int8_t corner[4][2] = {{-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
    shape_builder builder;
    enum qtri_error error =
        builder_begin(&builder, mesh, memory, QTRI_BOX_VERTICES, QTRI_BOX_TRIANGLES);
    if (error != QTRI_OK) {
        return error;
    }
    for (int i = 0; i < 6; i++) {
        const int8_t(*side)[3] = sides[i];
        const qtri_vec3 normal = {side[0][0] * Q16_ONE, side[0][1] * Q16_ONE, side[0][2] * Q16_ONE};
        const uint32_t first = mesh->vertex_count;
        for (int k = 0; k < 4; k++) {
            int8_t sign[3];
            for (int axis = 0; axis < 3; axis++) {
                sign[axis] = (int8_t)(side[0][axis] + corner[k][0] * side[1][axis] +
                                      corner[k][1] * side[2][axis]);
            }
            builder_vertex(&builder, scaled(&half, sign), normal, corner[k][0] > 0 ? Q16_ONE : 0,
                           corner[k][1] > 0 ? 0 : Q16_ONE);
        }
        add_quad(&builder, first, first + 1, first + 2, first + 3);
    }
    return builder_end(&builder);
}

/* half (2 i / count - 1), rounded; |.| <= half. */
static q16 along(q16 half, int32_t i, int32_t count)
{
    return q16_muldiv(half, 2 * i - count, count);
}

enum qtri_error qtri_shape_grid(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 half_x,
                                q16 half_z, int32_t columns, int32_t rows)
{
    QTRI_ASSERT(qtri_is_length(half_x) && qtri_is_length(half_z));
    static const qtri_vec3 up = {0, Q16_ONE, 0};
    shape_builder builder;
    const bool is_valid = is_count(columns, 1) && is_count(rows, 1);
    enum qtri_error error = builder_begin(&builder, mesh, memory,
                                          is_valid ? QTRI_GRID_VERTICES(columns, rows) : INT32_MAX,
                                          is_valid ? QTRI_GRID_TRIANGLES(columns, rows) : 0);
    if (error != QTRI_OK) {
        return error;
    }
    for (int32_t z = 0; z <= rows; z++) {
        for (int32_t x = 0; x <= columns; x++) {
            const qtri_vec3 position = {along(half_x, x, columns), 0, along(half_z, z, rows)};
            const uint32_t i =
                builder_vertex(&builder, position, up, part_of(x, columns), part_of(z, rows));
            if (z > 0 && x > 0) {
                const uint32_t above = i - (uint32_t)columns - 1;
                add_quad(&builder, above - 1, i - 1, i, above);
            }
        }
    }
    return builder_end(&builder);
}

/* ---- Round shapes ---- */

/*
 * Rings of a tube around the y axis, from the top outwards and down: all around its middle, or half
 * of that, from point to point, for a sphere.
 */
static enum qtri_error make_rings(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                  q16 tube, int32_t slices, int32_t rings, bool is_half)
{
    shape_builder builder;
    const bool is_valid = is_count(slices, 3) && is_count(rings, is_half ? 2 : 3);
    enum qtri_error error = builder_begin(&builder, mesh, memory,
                                          is_valid ? QTRI_TORUS_VERTICES(slices, rings) : INT32_MAX,
                                          !is_valid ? 0
                                          : is_half ? QTRI_SPHERE_TRIANGLES(slices, rings)
                                                    : QTRI_TORUS_TRIANGLES(slices, rings));
    if (error != QTRI_OK) {
        return error;
    }
    for (int32_t i = 0; i <= rings; i++) {
        shape_ring ring;
        q16_sincos_deg(angle_of(i, is_half ? 2 * rings : rings), &ring.out, &ring.up);
        ring.radius = q16_add(radius, q16_mul(tube, ring.out));
        ring.y = q16_mul(tube, ring.up);
        ring.v = part_of(i, rings);
        builder_ring(&builder, slices, &ring);
        if (i > 0) {
            builder_join(&builder, slices, is_half && i == 1, is_half && i == rings);
        }
    }
    return builder_end(&builder);
}

enum qtri_error qtri_shape_sphere(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                  int32_t slices, int32_t rows)
{
    QTRI_ASSERT(qtri_is_length(radius));
    return make_rings(mesh, memory, 0, radius, slices, rows, true);
}

enum qtri_error qtri_shape_torus(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                 q16 tube, int32_t slices, int32_t rings)
{
    QTRI_ASSERT(qtri_is_length(radius) && qtri_is_length(tube));
    return make_rings(mesh, memory, radius, tube, slices, rings, false);
}

/* A radius of 0 has the triangles of any other, though none has an area. */
static void add_disc(shape_builder *builder, int32_t slices, q16 radius, q16 y, q16 up)
{
    const shape_ring center = {0, y, 0, up, up > 0 ? 0 : Q16_ONE};
    const shape_ring edge = {radius, y, 0, up, up > 0 ? 0 : Q16_ONE};
    builder_ring(builder, slices, up > 0 ? &center : &edge);
    builder_ring(builder, slices, up > 0 ? &edge : &center);
    builder_join(builder, slices, up > 0, up < 0);
}

/* A cylinder, or a cone with its tip above: a side of this normal, away from the axis and up, and
   discs. */
static enum qtri_error make_side(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                 q16 half_height, int32_t slices, qtri_vec2 normal, bool is_cone)
{
    shape_builder builder;
    const bool is_valid = is_count(slices, 3);
    enum qtri_error error = builder_begin(&builder, mesh, memory,
                                          !is_valid ? INT32_MAX
                                          : is_cone ? QTRI_CONE_VERTICES(slices)
                                                    : QTRI_CYLINDER_VERTICES(slices),
                                          !is_valid ? 0
                                          : is_cone ? QTRI_CONE_TRIANGLES(slices)
                                                    : QTRI_CYLINDER_TRIANGLES(slices));
    if (error != QTRI_OK) {
        return error;
    }
    const q16 low = q16_neg(half_height);
    const shape_ring above = {is_cone ? 0 : radius, half_height, normal.x, normal.y, 0};
    const shape_ring below = {radius, low, normal.x, normal.y, Q16_ONE};
    if (!is_cone) {
        add_disc(&builder, slices, radius, half_height, Q16_ONE);
    }
    builder_ring(&builder, slices, &above);
    builder_ring(&builder, slices, &below);
    builder_join(&builder, slices, is_cone, false);
    add_disc(&builder, slices, radius, low, -Q16_ONE);
    return builder_end(&builder);
}

enum qtri_error qtri_shape_cylinder(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                    q16 half_height, int32_t slices)
{
    QTRI_ASSERT(qtri_is_length(radius) && qtri_is_length(half_height));
    const qtri_vec2 normal = {Q16_ONE, 0};
    return make_side(mesh, memory, radius, half_height, slices, normal, false);
}

/* The side's normal is (2 half_height, radius), made 1 long: perpendicular to (radius, -2 h). */
enum qtri_error qtri_shape_cone(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                q16 half_height, int32_t slices)
{
    QTRI_ASSERT(qtri_is_length(radius) && qtri_is_length(half_height));
    const qtri_vec2 side = {half_height, radius / 2};
    return make_side(mesh, memory, radius, half_height, slices, qtri_vec2_normalize(side), true);
}
