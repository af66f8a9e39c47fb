/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <stdlib.h>
#include <string.h>

#include "../assets/mesh_arrays.h"
#include "../io/xalloc.h"
#include "mesh_faces.h"
#include "mesh_neighbours.h"

#define PART_VERTICES 65536u

static int16_t normal_q14(int32_t component)
{
    int32_t rounded = (component + (component < 0 ? -2 : 2)) / 4;
    return (int16_t)(rounded > INT16_MAX ? INT16_MAX : (rounded < INT16_MIN ? INT16_MIN : rounded));
}

static void copy_vertex(qtri_mesh *part, uint32_t to, const struct obj_mesh *mesh, uint32_t from)
{
    int32_t normal[3], color[3];
    for (int i = 0; i < 3; i++) {
        normal[i] = normal_q14(mesh->normals[from][i]);
        color[i] = mesh->colors != NULL ? mesh->colors[from][i] : 0;
    }
    mesh_array_put(part, MESH_POSITIONS, to, mesh->positions[from]);
    mesh_array_put(part, MESH_NORMALS, to, normal);
    if (part->uvs != NULL) {
        mesh_array_put(part, MESH_UVS, to, mesh->uvs[from]);
    }
    if (part->colors != NULL) {
        mesh_array_put(part, MESH_COLORS, to, color);
    }
}

/*
 * Takes triangles from `first` on until a part is full; returns the first that did not fit.
 * local[v] is 1 + the part's index of vertex v, or 0; it comes and goes all zero.
 */
static size_t part_fill(qtri_mesh *part, const struct obj_mesh *mesh, size_t first, uint32_t *local)
{
    uint16_t(*triangles)[3] = mesh_array(part, MESH_TRIANGLES);
    size_t triangle = first;
    uint32_t vertices = 0;
    for (; triangle < mesh->triangle_count && vertices + 3 <= PART_VERTICES; triangle++) {
        for (int i = 0; i < 3; i++) {
            uint32_t vertex = mesh->triangles[triangle][i];
            if (local[vertex] == 0) {
                copy_vertex(part, vertices, mesh, vertex);
                local[vertex] = ++vertices;
            }
            triangles[triangle - first][i] = (uint16_t)(local[vertex] - 1);
        }
    }
    for (size_t done = first; done < triangle; done++) {
        for (int i = 0; i < 3; i++) {
            local[mesh->triangles[done][i]] = 0;
        }
    }
    part->vertex_count = vertices;
    part->triangle_count = (uint32_t)(triangle - first);
    mesh_faces_add(part);
    (void)mesh_neighbours_add(part); /* without: found by sums */
    return triangle;
}

/* Room for as many vertices as a part may have. */
static void part_allocate(qtri_mesh *part, const struct obj_mesh *mesh, size_t triangles)
{
    const size_t vertices = mesh->vertex_count < PART_VERTICES ? mesh->vertex_count : PART_VERTICES;
    *part = (qtri_mesh){.vertex_count = (uint32_t)vertices, .triangle_count = (uint32_t)triangles};
    mesh_array_create(part, MESH_POSITIONS);
    mesh_array_create(part, MESH_NORMALS);
    mesh_array_create(part, MESH_TRIANGLES);
    if (mesh->uvs != NULL) {
        mesh_array_create(part, MESH_UVS);
    }
    if (mesh->colors != NULL) {
        mesh_array_create(part, MESH_COLORS);
    }
}

static void parts_create(struct scene_parts *parts, const struct obj_mesh *mesh)
{
    uint32_t *local = xcalloc(mesh->vertex_count, sizeof *local);
    for (size_t triangle = 0; triangle < mesh->triangle_count;) {
        parts->part = xrealloc(parts->part, parts->count + 1, sizeof *parts->part);
        qtri_mesh *part = &parts->part[parts->count++];
        part_allocate(part, mesh, mesh->triangle_count - triangle);
        triangle = part_fill(part, mesh, triangle, local);
    }
    free(local);
}

static void create_pass(struct scene_resources *resources, const struct scene *scene)
{
    memset(resources, 0, sizeof *resources);
    resources->scene = scene;
    resources->light.towards.x = scene->light.towards[0];
    resources->light.towards.y = scene->light.towards[1];
    resources->light.towards.z = scene->light.towards[2];
    resources->light.ambient = scene->light.ambient;
    resources->light.diffuse = scene->light.diffuse;
    scene_lights_create(resources, scene);
    scene_texture_create(resources, scene);
    scene_painting_create(resources, scene);
    resources->meshes = xcalloc(scene->mesh_count, sizeof *resources->meshes);
    uint32_t largest = 0;
    for (size_t i = 0; i < scene->mesh_count; i++) {
        struct scene_parts *parts = &resources->meshes[i];
        parts_create(parts, &scene->meshes[i]);
        for (size_t j = 0; j < parts->count; j++) {
            const uint32_t count = parts->part[j].vertex_count;
            largest = count > largest ? count : largest;
        }
    }
    for (size_t i = 0; i < scene->model_count; i++) {
        const uint32_t count = scene->models[i].vertices;
        largest = count > largest ? count : largest;
    }
    resources->vertex_count = QTRI_LIT_VERTICES(largest);
    resources->vertices = xcalloc(resources->vertex_count, sizeof *resources->vertices);
    if (scene->texture_sphere) {
        resources->sphere_uvs = xcalloc(largest, sizeof *resources->sphere_uvs);
    }
}

void scene_resources_create(struct scene_resources *resources, const struct scene *scene)
{
    create_pass(resources, scene);
    while ((scene = scene->next) != NULL) {
        resources->next = xcalloc(1, sizeof *resources->next);
        resources = resources->next;
        create_pass(resources, scene);
    }
}

static void free_pass(struct scene_resources *resources)
{
    for (size_t i = 0; resources->meshes != NULL && i < resources->scene->mesh_count; i++) {
        for (size_t j = 0; j < resources->meshes[i].count; j++) {
            mesh_arrays_free(&resources->meshes[i].part[j]);
        }
        free(resources->meshes[i].part);
    }
    free(resources->meshes);
    free(resources->texels);
    free(resources->mask_texels);
    free(resources->vertices);
    free(resources->sphere_uvs);
    scene_painting_free(resources);
}

void scene_resources_free(struct scene_resources *resources)
{
    for (struct scene_resources *next = resources->next; next != NULL;) {
        struct scene_resources *after = next->next;
        free_pass(next);
        free(next);
        next = after;
    }
    free_pass(resources);
    memset(resources, 0, sizeof *resources);
}
