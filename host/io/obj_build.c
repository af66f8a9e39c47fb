/* SPDX-License-Identifier: MIT */
#include "obj_source.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "polygon.h"

#define ONE 65536

static void free_names(struct obj_names *names)
{
    for (size_t i = 0; i < names->count; i++) {
        free(names->items[i].text);
    }
    free(names->items);
}

void obj_source_free(struct obj_source *source)
{
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        free(source->lists[i].items);
    }
    free(source->colors.items);
    free_names(&source->materials);
    free_names(&source->libraries);
    free(source->vertices);
    free(source->triangles);
    free(source->polygons);
    free(source->table.slots);
    memset(source, 0, sizeof *source);
}

/* ---- Distinct corners ---- */

/* Multiply and shift after each index (the finaliser of SplitMix64): neighbours spread well. */
static size_t hash_corner(const struct obj_corner *corner)
{
    uint64_t h = corner->material;
    for (int i = 0; i < OBJ_ATTRIBUTES; i++) {
        h = (h ^ corner->index[i]) + UINT64_C(0x9E3779B97F4A7C15);
        h = (h ^ (h >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
        h = (h ^ (h >> 27)) * UINT64_C(0x94D049BB133111EB);
        h ^= h >> 31;
    }
    return (size_t)h;
}

static bool same_corner(const struct obj_corner *a, const struct obj_corner *b)
{
    return memcmp(a->index, b->index, sizeof a->index) == 0 && a->material == b->material;
}

/* The slot that holds the corner, or the free one where it belongs. The table is never full. */
static uint32_t *find_slot(const struct obj_source *source, const struct obj_corner *corner)
{
    size_t mask = source->table.size - 1;
    size_t at = hash_corner(corner) & mask;
    while (source->table.slots[at] != 0 &&
           !same_corner(&source->vertices[source->table.slots[at] - 1], corner)) {
        at = (at + 1) & mask;
    }
    return &source->table.slots[at];
}

static bool grow_table(struct obj_source *source)
{
    size_t size = source->table.size == 0 ? 64 : source->table.size * 2;
    uint32_t *slots = calloc(size, sizeof *slots);
    if (slots == NULL) {
        return false;
    }
    free(source->table.slots);
    source->table.slots = slots;
    source->table.size = size;
    for (size_t i = 0; i < source->vertex_count; i++) {
        *find_slot(source, &source->vertices[i]) = (uint32_t)(i + 1);
    }
    return true;
}

bool obj_add_corner(struct obj_source *source, const struct obj_corner *corner, uint32_t *vertex)
{
    if (2 * (source->vertex_count + 1) > source->table.size && !grow_table(source)) {
        return false;
    }
    uint32_t *slot = find_slot(source, corner);
    if (*slot == 0) {
        struct obj_corner *grown = array_grow(source->vertices, source->vertex_count,
                                              &source->vertex_capacity, sizeof *grown);
        if (grown == NULL || source->vertex_count >= OBJ_MAX_COUNT) {
            return false;
        }
        source->vertices = grown;
        grown[source->vertex_count++] = *corner;
        *slot = (uint32_t)source->vertex_count;
    }
    *vertex = *slot - 1;
    return true;
}

/* ---- Polygons ---- */

/* Of a fan, whose triangles have the corners 0, n, n + 1. */
static bool triangulate(struct obj_source *source, const struct obj_polygon *polygon)
{
    const size_t count = polygon->count + (size_t)2;
    uint32_t(*triangles)[3] = &source->triangles[polygon->first];
    uint32_t *vertices = malloc(count * sizeof *vertices);
    double(*corners)[3] = malloc(count * sizeof *corners);
    bool ok = vertices != NULL && corners != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        vertices[i] = i < 2 ? triangles[0][i] : triangles[i - 2][2];
        const uint32_t position = source->vertices[vertices[i]].index[OBJ_POSITION];
        memcpy(corners[i], source->lists[OBJ_POSITION].items[position], sizeof corners[i]);
    }
    ok = ok && polygon_triangulate((const double(*)[3])corners, count, triangles);
    for (size_t i = 0; ok && i < polygon->count; i++) {
        for (int j = 0; j < 3; j++) {
            triangles[i][j] = vertices[triangles[i][j]];
        }
    }
    free(corners);
    free(vertices);
    return ok;
}

bool obj_triangulate(struct obj_source *source)
{
    bool ok = true;
    for (size_t i = 0; ok && i < source->polygon_count; i++) {
        ok = triangulate(source, &source->polygons[i]);
    }
    return ok;
}

/* ---- Scaling ---- */

/* The largest side of the box around the positions that faces name. */
static double largest_side(const struct obj_source *source)
{
    double(*const items)[3] = source->lists[OBJ_POSITION].items;
    double largest = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        for (size_t i = 0; i < source->vertex_count; i++) {
            const double at = items[source->vertices[i].index[OBJ_POSITION]][axis];
            low = fmin(low, at);
            high = fmax(high, at);
        }
        largest = fmax(largest, high - low);
    }
    return largest;
}

/* Positions that no face names may lie anywhere: nothing takes them. No zero is negative. */
bool obj_scale_positions(struct obj_source *source, const struct obj_scale *scale)
{
    struct obj_list *list = &source->lists[OBJ_POSITION];
    const double side = scale->fit > 0.0 ? largest_side(source) : 0.0;
    const double given = scale->factor > 0.0 ? scale->factor : 1.0;
    const double factor = side > 0.0 ? scale->fit / side : given;
    for (size_t i = 0; i < list->count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            list->items[i][axis] = round(list->items[i][axis] * factor * ONE) / ONE + 0.0;
        }
    }
    for (size_t i = 0; i < source->vertex_count; i++) {
        const double *at = list->items[source->vertices[i].index[OBJ_POSITION]];
        for (int axis = 0; axis < 3; axis++) {
            if (at[axis] < (double)INT32_MIN / ONE || at[axis] > (double)INT32_MAX / ONE) {
                return false;
            }
        }
    }
    return true;
}

/* ---- Normals ---- */

/* A position and its number in the file. */
struct place {
    double at[3];
    uint32_t number;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *x = (const struct place *)a;
    const struct place *y = (const struct place *)b;
    for (int axis = 0; axis < 3; axis++) {
        if (x->at[axis] != y->at[axis]) {
            return x->at[axis] < y->at[axis] ? -1 : 1;
        }
    }
    return (x->number > y->number) - (x->number < y->number);
}

/*
 * For each position the first of the file that is equal: seams, along which files repeat positions,
 * are smoothed over. NULL when memory runs out.
 */
static uint32_t *equal_positions(const struct obj_source *source)
{
    const size_t count = source->lists[OBJ_POSITION].count;
    struct place *places = malloc((count + 1) * sizeof *places);
    uint32_t *first = malloc((count + 1) * sizeof *first);
    bool ok = places != NULL && first != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        memcpy(places[i].at, source->lists[OBJ_POSITION].items[i], sizeof places[i].at);
        places[i].number = (uint32_t)i;
    }
    if (ok) {
        qsort(places, count, sizeof *places, compare_places);
    }
    for (size_t i = 0, group = 0; ok && i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            group = places[i].at[axis] != places[group].at[axis] ? i : group;
        }
        first[places[i].number] = places[group].number;
    }
    free(places);
    if (!ok) {
        free(first);
        return NULL;
    }
    return first;
}

/* Adds twice the triangle's area vector to the normal of each of its positions. */
static void add_area(const struct obj_source *source, const uint32_t *equal,
                     const uint32_t triangle[3], double (*sums)[3])
{
    uint32_t position[3];
    double edge[2][3];
    for (int i = 0; i < 3; i++) {
        position[i] = equal[source->vertices[triangle[i]].index[OBJ_POSITION]];
    }
    const double(*p)[3] = (const double(*)[3])source->lists[OBJ_POSITION].items;
    for (int i = 0; i < 3; i++) {
        edge[0][i] = p[position[1]][i] - p[position[0]][i];
        edge[1][i] = p[position[2]][i] - p[position[0]][i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double area = edge[0][j] * edge[1][k] - edge[0][k] * edge[1][j];
        for (int corner = 0; corner < 3; corner++) {
            sums[position[corner]][i] += area;
        }
    }
}

/* Scales to length 1, in Q16.16; false when the vector is zero. */
static bool normalise(const double vector[3], int32_t out[3])
{
    double length = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    if (!(length > 0.0)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        out[i] = (int32_t)lround(vector[i] / length * ONE);
    }
    return true;
}

static void vertex_normal(const struct obj_source *source, const uint32_t *equal,
                          const struct obj_corner *corner, const double (*sums)[3], int32_t out[3])
{
    if (corner->index[OBJ_NORMAL] != OBJ_ABSENT) {
        if (normalise(source->lists[OBJ_NORMAL].items[corner->index[OBJ_NORMAL]], out)) {
            return;
        }
    }
    if (!normalise(sums[equal[corner->index[OBJ_POSITION]]], out)) {
        out[0] = 0;
        out[1] = 0;
        out[2] = ONE;
    }
}

static bool build_normals(const struct obj_source *source, struct obj_mesh *mesh)
{
    double(*sums)[3] = calloc(source->lists[OBJ_POSITION].count, sizeof *sums);
    uint32_t *equal = equal_positions(source);
    const bool ok = sums != NULL && equal != NULL;
    for (size_t i = 0; ok && i < source->triangle_count; i++) {
        add_area(source, equal, source->triangles[i], sums);
    }
    for (size_t i = 0; ok && i < source->vertex_count; i++) {
        vertex_normal(source, equal, &source->vertices[i], (const double(*)[3])sums,
                      mesh->normals[i]);
    }
    free(equal);
    free(sums);
    return ok;
}

/* ---- The mesh ---- */

static bool any_uv(const struct obj_source *source)
{
    for (size_t i = 0; i < source->vertex_count; i++) {
        if (source->vertices[i].index[OBJ_UV] != OBJ_ABSENT) {
            return true;
        }
    }
    return false;
}

static bool allocate(const struct obj_source *source, struct obj_mesh *mesh)
{
    mesh->positions = calloc(source->vertex_count, sizeof *mesh->positions);
    mesh->normals = calloc(source->vertex_count, sizeof *mesh->normals);
    if (mesh->positions == NULL || mesh->normals == NULL) {
        return false;
    }
    if (any_uv(source)) {
        mesh->uvs = calloc(source->vertex_count, sizeof *mesh->uvs);
    }
    if (source->has_colors) {
        mesh->colors = calloc(source->vertex_count, sizeof *mesh->colors);
    }
    return (mesh->uvs != NULL || !any_uv(source)) && (mesh->colors != NULL || !source->has_colors);
}

/* Numbers that were read as Q16.16: exact. */
static void to_q16(const double *numbers, int count, int32_t *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = (int32_t)lround(numbers[i] * ONE);
    }
}

bool obj_build(struct obj_source *source, struct obj_mesh *mesh)
{
    if (!allocate(source, mesh) || !build_normals(source, mesh)) {
        return false;
    }
    for (size_t i = 0; i < source->vertex_count; i++) {
        const uint32_t *index = source->vertices[i].index;
        to_q16(source->lists[OBJ_POSITION].items[index[OBJ_POSITION]], 3, mesh->positions[i]);
        if (index[OBJ_UV] != OBJ_ABSENT) {
            to_q16(source->lists[OBJ_UV].items[index[OBJ_UV]], 2, mesh->uvs[i]);
        }
        for (int c = 0; source->has_colors && c < 3; c++) {
            mesh->colors[i][c] =
                (uint8_t)lround(255.0 * source->colors.items[index[OBJ_POSITION]][c]);
        }
    }
    mesh->vertex_count = source->vertex_count;
    mesh->triangle_count = source->triangle_count;
    mesh->triangles = source->triangles;
    source->triangles = NULL;
    source->triangle_count = 0;
    return true;
}
