/* SPDX-License-Identifier: MIT */
#include "obj_source.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "polygon.h"
#include "xalloc.h"

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
    unique_free(&source->vertices);
    free(source->triangles);
    free(source->polygons);
    memset(source, 0, sizeof *source);
}

/* ---- Polygons ---- */

/* Of a fan, whose triangles have the corners 0, n, n + 1. */
static void triangulate(struct obj_source *source, const struct obj_polygon *polygon)
{
    const size_t count = polygon->count + (size_t)2;
    uint32_t(*triangles)[3] = &source->triangles[polygon->first];
    uint32_t *vertices = xcalloc(count, sizeof *vertices);
    double(*corners)[3] = xcalloc(count, sizeof *corners);
    for (size_t i = 0; i < count; i++) {
        vertices[i] = i < 2 ? triangles[0][i] : triangles[i - 2][2];
        const uint32_t position = obj_vertex(source, vertices[i])->index[OBJ_POSITION];
        memcpy(corners[i], source->lists[OBJ_POSITION].items[position], sizeof corners[i]);
    }
    polygon_triangulate((const double(*)[3])corners, count, triangles);
    for (size_t i = 0; i < polygon->count; i++) {
        for (int j = 0; j < 3; j++) {
            triangles[i][j] = vertices[triangles[i][j]];
        }
    }
    free(corners);
    free(vertices);
}

void obj_triangulate(struct obj_source *source)
{
    for (size_t i = 0; i < source->polygon_count; i++) {
        triangulate(source, &source->polygons[i]);
    }
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
        for (size_t i = 0; i < source->vertices.count; i++) {
            const double at = items[obj_vertex(source, i)->index[OBJ_POSITION]][axis];
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
    for (size_t i = 0; i < source->vertices.count; i++) {
        const double *at = list->items[obj_vertex(source, i)->index[OBJ_POSITION]];
        for (int axis = 0; axis < 3; axis++) {
            if (at[axis] < (double)INT32_MIN / ONE || at[axis] > (double)INT32_MAX / ONE) {
                return false;
            }
        }
    }
    return true;
}

/* ---- Normals ---- */

/* Adds twice the triangle's area vector to the normal of each of its positions. */
static void add_area(const struct obj_source *source, const uint32_t *places,
                     const uint32_t triangle[3], double (*sums)[3])
{
    uint32_t position[3];
    double edge[2][3];
    for (int i = 0; i < 3; i++) {
        position[i] = places[obj_vertex(source, triangle[i])->index[OBJ_POSITION]];
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

static void vertex_normal(const struct obj_source *source, const uint32_t *places,
                          const struct obj_corner *corner, const double (*sums)[3], int32_t out[3])
{
    if (corner->index[OBJ_NORMAL] != OBJ_ABSENT) {
        if (normalise(source->lists[OBJ_NORMAL].items[corner->index[OBJ_NORMAL]], out)) {
            return;
        }
    }
    if (!normalise(sums[places[corner->index[OBJ_POSITION]]], out)) {
        out[0] = 0;
        out[1] = 0;
        out[2] = ONE;
    }
}

/* Equal positions have one normal: seams, along which files repeat positions, are smoothed over. */
static void build_normals(const struct obj_source *source, struct obj_mesh *mesh)
{
    const struct obj_list *positions = &source->lists[OBJ_POSITION];
    double(*sums)[3] = xcalloc(positions->count, sizeof *sums);
    uint32_t *places = xcalloc(positions->count, sizeof *places);
    const size_t size = sizeof *positions->items;
    (void)unique_numbers(positions->items, positions->count, size, size, places);
    for (size_t i = 0; i < source->triangle_count; i++) {
        add_area(source, places, source->triangles[i], sums);
    }
    for (size_t i = 0; i < source->vertices.count; i++) {
        vertex_normal(source, places, obj_vertex(source, i), (const double(*)[3])sums,
                      mesh->normals[i]);
    }
    free(places);
    free(sums);
}

/* ---- The mesh ---- */

static bool any_uv(const struct obj_source *source)
{
    for (size_t i = 0; i < source->vertices.count; i++) {
        if (obj_vertex(source, i)->index[OBJ_UV] != OBJ_ABSENT) {
            return true;
        }
    }
    return false;
}

/* Numbers that were read as Q16.16: exact. */
static void to_q16(const double *numbers, int count, int32_t *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = (int32_t)lround(numbers[i] * ONE);
    }
}

void obj_build(struct obj_source *source, struct obj_mesh *mesh)
{
    const size_t count = source->vertices.count;
    mesh->positions = xcalloc(count, sizeof *mesh->positions);
    mesh->normals = xcalloc(count, sizeof *mesh->normals);
    mesh->uvs = any_uv(source) ? xcalloc(count, sizeof *mesh->uvs) : NULL;
    mesh->colors = source->has_colors ? xcalloc(count, sizeof *mesh->colors) : NULL;
    build_normals(source, mesh);
    for (size_t i = 0; i < source->vertices.count; i++) {
        const uint32_t *index = obj_vertex(source, i)->index;
        to_q16(source->lists[OBJ_POSITION].items[index[OBJ_POSITION]], 3, mesh->positions[i]);
        if (index[OBJ_UV] != OBJ_ABSENT) {
            to_q16(source->lists[OBJ_UV].items[index[OBJ_UV]], 2, mesh->uvs[i]);
        }
        for (int c = 0; source->has_colors && c < 3; c++) {
            mesh->colors[i][c] =
                (uint8_t)lround(255.0 * source->colors.items[index[OBJ_POSITION]][c]);
        }
    }
    mesh->vertex_count = source->vertices.count;
    mesh->triangle_count = source->triangle_count;
    mesh->triangles = source->triangles;
    source->triangles = NULL;
    source->triangle_count = 0;
}
