/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <stdlib.h>
#include <string.h>

#include "mesh_faces.h"
#include "mesh_neighbours.h"

#define PART_VERTICES 65536u

static int16_t normal_q14(int32_t component)
{
    int32_t rounded = (component + (component < 0 ? -2 : 2)) / 4;
    return (int16_t)(rounded > INT16_MAX ? INT16_MAX : (rounded < INT16_MIN ? INT16_MIN : rounded));
}

static void copy_vertex(struct scene_part *part, uint32_t to, const struct obj_mesh *mesh,
                        uint32_t from)
{
    qtri_vec3 position = {mesh->positions[from][0], mesh->positions[from][1],
                          mesh->positions[from][2]};
    qtri_normal normal = {normal_q14(mesh->normals[from][0]), normal_q14(mesh->normals[from][1]),
                          normal_q14(mesh->normals[from][2])};
    part->positions[to] = position;
    part->normals[to] = normal;
    if (part->uvs != NULL) {
        qtri_vec2 uv = {mesh->uvs[from][0], mesh->uvs[from][1]};
        part->uvs[to] = uv;
    }
    if (part->colors != NULL) {
        const uint8_t *c = mesh->colors[from];
        part->colors[to] = (qtri_rgb){c[0], c[1], c[2]};
    }
}

/*
 * Takes triangles from `first` on until a part is full; returns the first that did not fit.
 * local[v] is 1 + the part's index of vertex v, or 0; it comes and goes all zero.
 */
static size_t part_fill(struct scene_part *part, const struct obj_mesh *mesh, size_t first,
                        uint32_t *local)
{
    size_t triangle = first;
    uint32_t vertices = 0;
    for (; triangle < mesh->triangle_count && vertices + 3 <= PART_VERTICES; triangle++) {
        for (int i = 0; i < 3; i++) {
            uint32_t vertex = mesh->triangles[triangle][i];
            if (local[vertex] == 0) {
                copy_vertex(part, vertices, mesh, vertex);
                local[vertex] = ++vertices;
            }
            part->triangles[triangle - first][i] = (uint16_t)(local[vertex] - 1);
        }
    }
    for (size_t done = first; done < triangle; done++) {
        for (int i = 0; i < 3; i++) {
            local[mesh->triangles[done][i]] = 0;
        }
    }
    qtri_mesh view = {
        .positions = part->positions,
        .normals = part->normals,
        .uvs = part->uvs,
        .colors = part->colors,
        .triangles = (const uint16_t(*)[3])part->triangles,
        .vertex_count = vertices,
        .triangle_count = (uint32_t)(triangle - first),
    };
    part->mesh = view;
    (void)mesh_faces_make(&part->mesh, part->planes);
    (void)mesh_neighbours_make(&part->mesh, part->neighbours); /* without: found by sums */
    return triangle;
}

static bool part_allocate(struct scene_part *part, const struct obj_mesh *mesh, size_t triangles)
{
    size_t vertices = mesh->vertex_count < PART_VERTICES ? mesh->vertex_count : PART_VERTICES;
    memset(part, 0, sizeof *part);
    part->positions = malloc((vertices + 1) * sizeof *part->positions);
    part->normals = malloc((vertices + 1) * sizeof *part->normals);
    part->uvs = mesh->uvs != NULL ? malloc((vertices + 1) * sizeof *part->uvs) : NULL;
    part->colors = mesh->colors != NULL ? malloc((vertices + 1) * sizeof *part->colors) : NULL;
    part->triangles = malloc((triangles + 1) * sizeof *part->triangles);
    part->planes = malloc((triangles + 1) * sizeof *part->planes);
    part->neighbours = malloc((triangles + 1) * sizeof *part->neighbours);
    return part->positions != NULL && part->normals != NULL && part->triangles != NULL &&
           part->planes != NULL && part->neighbours != NULL &&
           (mesh->uvs == NULL || part->uvs != NULL) &&
           (mesh->colors == NULL || part->colors != NULL);
}

static bool parts_create(struct scene_parts *parts, const struct obj_mesh *mesh)
{
    uint32_t *local = calloc(mesh->vertex_count + 1, sizeof *local);
    bool ok = local != NULL;
    for (size_t triangle = 0; ok && triangle < mesh->triangle_count;) {
        struct scene_part *grown = realloc(parts->part, (parts->count + 1) * sizeof *grown);
        ok = grown != NULL;
        if (ok) {
            parts->part = grown;
            struct scene_part *part = &grown[parts->count++];
            ok = part_allocate(part, mesh, mesh->triangle_count - triangle);
            if (ok) {
                triangle = part_fill(part, mesh, triangle, local);
            }
        }
    }
    free(local);
    return ok;
}

static bool create_pass(struct scene_resources *resources, const struct scene *scene)
{
    memset(resources, 0, sizeof *resources);
    resources->scene = scene;
    resources->light.towards.x = scene->light.towards[0];
    resources->light.towards.y = scene->light.towards[1];
    resources->light.towards.z = scene->light.towards[2];
    resources->light.ambient = scene->light.ambient;
    resources->light.diffuse = scene->light.diffuse;
    scene_lights_create(resources, scene);
    resources->meshes = calloc(scene->mesh_count + 1, sizeof *resources->meshes);
    bool ok = resources->meshes != NULL && scene_texture_create(resources, scene) &&
              scene_painting_create(resources, scene);
    for (size_t i = 0; ok && i < scene->mesh_count; i++) {
        struct scene_parts *parts = &resources->meshes[i];
        ok = parts_create(parts, &scene->meshes[i]);
        for (size_t j = 0; ok && j < parts->count; j++) {
            uint32_t count = parts->part[j].mesh.vertex_count;
            resources->vertex_count =
                count > resources->vertex_count ? count : resources->vertex_count;
        }
    }
    for (size_t i = 0; ok && i < scene->model_count; i++) {
        const uint32_t count = scene->models[i].vertices;
        resources->vertex_count = count > resources->vertex_count ? count : resources->vertex_count;
    }
    if (ok) {
        const uint32_t largest = resources->vertex_count;
        resources->vertex_count = QTRI_LIT_VERTICES(largest);
        resources->vertices = malloc((resources->vertex_count + 1) * sizeof *resources->vertices);
        ok = resources->vertices != NULL;
        if (ok && scene->texture_sphere) {
            resources->sphere_uvs = malloc((largest + 1) * sizeof *resources->sphere_uvs);
            ok = resources->sphere_uvs != NULL;
        }
    }
    return ok;
}

bool scene_resources_create(struct scene_resources *resources, const struct scene *scene)
{
    struct scene_resources *last = resources;
    bool ok = create_pass(last, scene);
    while (ok && (scene = scene->next) != NULL) {
        last->next = malloc(sizeof *last->next);
        last = last->next;
        ok = last != NULL && create_pass(last, scene);
    }
    if (!ok) {
        scene_resources_free(resources);
    }
    return ok;
}

static void free_pass(struct scene_resources *resources)
{
    for (size_t i = 0; resources->meshes != NULL && i < resources->scene->mesh_count; i++) {
        for (size_t j = 0; j < resources->meshes[i].count; j++) {
            scene_part_free(&resources->meshes[i].part[j]);
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
