/* SPDX-License-Identifier: MIT */
#include "shapes.h"

#include "qtri/bounds.h"
#include "qtri/error.h"
#include "qtri/q16_trig.h"

#include "../bits/bits.h"

static const qtri_mesh nothing;

enum qtri_error qtri_builder_begin(qtri_builder *builder, qtri_mesh *mesh,
                                   const qtri_shape_memory *memory, int32_t vertices,
                                   int32_t triangles)
{
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

enum qtri_error qtri_builder_end(const qtri_builder *builder)
{
    builder->mesh->bounds = qtri_mesh_box(builder->mesh);
    return QTRI_OK;
}

static int16_t q14(q16 unit)
{
    return (int16_t)((qtri_hold32(unit, -Q16_ONE, Q16_ONE) + 2) >> 2);
}

uint16_t qtri_builder_vertex(qtri_builder *builder, qtri_vec3 position, qtri_vec3 normal, q16 u,
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

void qtri_builder_triangle(qtri_builder *builder, uint32_t a, uint32_t b, uint32_t c)
{
    uint16_t *triangle = builder->memory->triangles[builder->mesh->triangle_count++];
    triangle[0] = (uint16_t)a;
    triangle[1] = (uint16_t)b;
    triangle[2] = (uint16_t)c;
}

q16 qtri_part_of(int32_t i, int32_t count)
{
    return (q16)(((int64_t)i * 65536 + count / 2) / count);
}

/* i / count of a turn, in degrees; the last is the first. */
q16 qtri_angle_of(int32_t i, int32_t count)
{
    return i == count ? 0 : (q16)(((int64_t)i * 360 * 65536 + count / 2) / count);
}

/*
 * A circle around the y axis of slices + 1 vertices, the first and the last in one place. Seen from
 * outside they go to the right, so that (left above, left below, right below) is counter-clockwise.
 */
void qtri_builder_ring(qtri_builder *builder, int32_t slices, const qtri_ring *ring)
{
    for (int32_t i = 0; i <= slices; i++) {
        q16 sine;
        q16 cosine;
        q16_sincos_deg(qtri_angle_of(i, slices), &sine, &cosine);
        const qtri_vec3 position = {q16_mul(ring->radius, sine), ring->y,
                                    q16_mul(ring->radius, cosine)};
        const qtri_vec3 normal = {q16_mul(ring->out, sine), ring->up, q16_mul(ring->out, cosine)};
        qtri_builder_vertex(builder, position, normal, qtri_part_of(i, slices), ring->v);
    }
}

/* Triangles between the last two rings, without those that have no area at a point. */
void qtri_builder_join(qtri_builder *builder, int32_t slices, bool is_point_above,
                       bool is_point_below)
{
    const uint32_t ring = (uint32_t)slices + 1;
    const uint32_t above = builder->mesh->vertex_count - 2 * ring;
    for (uint32_t i = above; i < above + (uint32_t)slices; i++) {
        if (!is_point_below) {
            qtri_builder_triangle(builder, i, i + ring, i + ring + 1);
        }
        if (!is_point_above) {
            qtri_builder_triangle(builder, i, i + ring + 1, i + 1);
        }
    }
}
