/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <stdlib.h>
#include <string.h>

#include "../io/xalloc.h"

static bool is_see_through(const struct model_material *material)
{
    return material->opacity < 255;
}

/* Whether what moves and shapes the vertex is what the merged material has. */
static bool moves_alike(const struct model_material *material, const struct model_vertex *vertex)
{
    return material->node == vertex->node && material->morph == vertex->morph;
}

static bool looks_alike(const struct model_material *a, const struct model_material *b)
{
    return a->opacity == b->opacity && a->clamp_u == b->clamp_u && a->clamp_v == b->clamp_v &&
           a->has_holes == b->has_holes && a->two_sided == b->two_sided &&
           strcmp(a->texture, b->texture) == 0;
}

/* Holes and edges are those of a picture: without, they are nothing that is seen. */
static void simplify_material(struct model_material *material)
{
    if (material->texture[0] == '\0') {
        material->clamp_u = false;
        material->clamp_v = false;
        material->has_holes = false;
    }
}

/* Materials while they are merged. */
struct merge {
    const struct model *model;
    struct model_material *merged;
    size_t count;
    uint64_t last; /* a material, a node and a morph, and what they have become */
    uint16_t last_merged;
};

/* The merged material of a vertex, a new one where none looks like it. */
static uint16_t merge_one(struct merge *merge, const struct model_vertex *vertex)
{
    const struct model_material *material = &merge->model->materials[vertex->material];
    const uint64_t key =
        (uint64_t)vertex->material << 32 | (uint64_t)vertex->morph << 16 | vertex->node;
    size_t i = 0;
    if (key == merge->last && merge->count > 0) {
        return merge->last_merged;
    }
    while (i < merge->count &&
           (!moves_alike(&merge->merged[i], vertex) || !looks_alike(&merge->merged[i], material))) {
        i++;
    }
    if (i == merge->count) {
        merge->merged[merge->count] = *material;
        merge->merged[merge->count].node = vertex->node;
        merge->merged[merge->count++].morph = vertex->morph;
    }
    merge->merged[i].is_blended = merge->merged[i].is_blended || material->is_blended;
    merge->last = key;
    merge->last_merged = (uint16_t)i;
    return (uint16_t)i;
}

static void paint_vertex(const struct model *model, struct model_vertex *vertex)
{
    const uint8_t *color = model->materials[vertex->material].color;
    for (int i = 0; i < 3; i++) {
        vertex->color[i] = (uint8_t)((vertex->color[i] * color[i] + 127) / 255);
    }
}

/* Merges vertices of materials that are seen through, or of the others. */
static void merge_vertices(struct merge *merge, struct model *model, uint16_t *to, bool see_through)
{
    for (size_t i = 0; i < model->vertex_count; i++) {
        struct model_vertex *vertex = &model->vertices[i];
        if (is_see_through(&model->materials[vertex->material]) == see_through) {
            to[i] = merge_one(merge, vertex);
        }
    }
}

bool model_merge_materials(struct model *model)
{
    /* A morph is of one node. */
    const size_t pairs = model->material_count * (model->node_count + 1 + model->morph_count);
    const size_t most = pairs < model->vertex_count ? pairs : model->vertex_count;
    if (pairs > UINT16_MAX) {
        return false;
    }
    struct merge merge = {.model = model, .merged = xcalloc(most, sizeof *merge.merged)};
    uint16_t *to = xcalloc(model->vertex_count, sizeof *to);
    for (size_t i = 0; i < model->material_count; i++) {
        simplify_material(&model->materials[i]);
    }
    merge_vertices(&merge, model, to, false);
    merge_vertices(&merge, model, to, true);
    for (size_t i = 0; i < model->vertex_count; i++) {
        paint_vertex(model, &model->vertices[i]);
        model->vertices[i].material = to[i];
    }
    for (size_t i = 0; i < merge.count; i++) {
        memset(merge.merged[i].color, 255, sizeof merge.merged[i].color);
    }
    free(model->materials);
    model->materials = merge.merged;
    model->material_count = merge.count;
    free(to);
    return true;
}
