/* SPDX-License-Identifier: MIT */
/*
 * What the corners of a mesh's triangles bring: place, light, colours, texture coordinates.
 */
#include "lights.h"

bool qtri_mesh_transform(const qtri_mesh_job *draw, uint32_t first, uint32_t count,
                         qtri_vertex *out)
{
    const qtri_projector *projector = &draw->primitive.projector;
    if (qtri_mesh_has_compact(draw->mesh->positions16)) {
        return qtri_projector_vertices16(projector, &draw->mesh->positions16[first], count, out);
    }
    return qtri_projector_vertices(projector, &draw->mesh->positions[first], count, out);
}

/* The triangle's plane. Its number: three times the factor is 1 modulo 2^32. */
static const qtri_face8 *plane_of(const qtri_mesh *mesh, const void *indices)
{
    const uint8_t *at = indices;
    const uint32_t offset = qtri_mesh_has_bytes(mesh)
                                ? (uint32_t)(at - (const uint8_t *)mesh->triangles8)
                                : (uint32_t)(at - (const uint8_t *)mesh->triangles) / 2;
    return &mesh->faces.planes[offset * 0xAAAAAAABu];
}

uint32_t qtri_mesh_light_face(const qtri_mesh_job *draw, const void *indices)
{
    const qtri_mesh *mesh = draw->mesh;
    if (mesh->faces.planes != NULL && draw->lighting.plain) {
        const qtri_face8 *plane = plane_of(mesh, indices);
        if ((plane->x | plane->y | plane->z) != 0) {
            return qtri_lighting_face8(&draw->lighting, plane);
        }
    }
    uint32_t a = qtri_mesh_index(mesh, indices, 0);
    uint32_t b = qtri_mesh_index(mesh, indices, 1);
    uint32_t c = qtri_mesh_index(mesh, indices, 2);
    if (qtri_mesh_has_compact(mesh->positions16)) {
        const qtri_position16 *p = mesh->positions16;
        return qtri_lighting_face16(&draw->lighting, &p[a], &p[b], &p[c]);
    }
    const qtri_vec3 *p = mesh->positions;
    return qtri_lighting_face(&draw->lighting, &p[a], &p[b], &p[c]);
}

static uint32_t light_vertex(const qtri_mesh_job *draw, uint32_t index)
{
    const qtri_mesh *mesh = draw->mesh;
    return qtri_mesh_has_compact(mesh->normals8)
               ? qtri_lighting_vertex8(&draw->lighting, &mesh->normals8[index])
               : qtri_lighting_vertex(&draw->lighting, &mesh->normals[index]);
}

static inline void light_corner(const qtri_mesh_job *draw, const void *indices, int corner,
                                qtri_vertex *vertex)
{
    if (vertex->intensity_q15 == QTRI_VERTEX_UNLIT) {
        vertex->intensity_q15 =
            draw->lit_per_vertex
                ? (uint16_t)light_vertex(draw, qtri_mesh_index(draw->mesh, indices, corner))
                : (uint16_t)QTRI_INTENSITY_ONE;
    }
}

QTRI_NOINLINE void qtri_mesh_light_corners(const qtri_mesh_job *draw, const void *indices,
                                           qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    light_corner(draw, indices, 0, a);
    light_corner(draw, indices, 1, b);
    light_corner(draw, indices, 2, c);
    if (draw->lights != NULL) {
        draw->lights->model->meet(draw, indices);
    }
}

void qtri_mesh_set_uv(int64_t *u_q32, int64_t *v_q32, const qtri_mesh *mesh, uint32_t index)
{
    if (QTRI_WITH_COMPACT_MESHES && mesh->uvs16 != NULL) {
        *u_q32 = mesh->uvs16[index].x * ((int64_t)1 << 18);
        *v_q32 = mesh->uvs16[index].y * ((int64_t)1 << 18);
    } else if (mesh->uvs != NULL) {
        *u_q32 = (int64_t)mesh->uvs[index].x * 65536;
        *v_q32 = (int64_t)mesh->uvs[index].y * 65536;
    } else {
        *u_q32 = 0;
        *v_q32 = 0;
    }
}

void qtri_mesh_set_color(int32_t color_8p16[3], const qtri_mesh_job *draw, uint32_t index,
                         uint32_t intensity_q15)
{
    const qtri_rgb *color =
        draw->mesh->colors != NULL ? &draw->mesh->colors[index] : &draw->material.color;
    int32_t intensity = (int32_t)intensity_q15 * 2;
    color_8p16[0] = color->r * intensity; /* <= 255.0 */
    color_8p16[1] = color->g * intensity;
    color_8p16[2] = color->b * intensity;
}
