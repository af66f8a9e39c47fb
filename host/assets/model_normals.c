/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../io/unique.h"
#include "../io/xalloc.h"

#define PI 3.14159265358979323846

/* Where more corners meet, all faces are smoothed together: the time would grow with its square. */
#define MOST_COMPARED 1024

/* Corners (3 triangle + 0..2) by their position. */
struct corners {
    uint32_t *position; /* of each corner: the number of its place */
    uint32_t *first;    /* of each place: where its corners begin in `list`; one more at the end */
    uint32_t *list;
    double (*area)[3]; /* of each triangle: twice its area, along its normal */
    size_t places;
};

static void corners_free(struct corners *corners)
{
    free(corners->position);
    free(corners->first);
    free(corners->list);
    free(corners->area);
}

static const double *position_of(const struct model *model, uint32_t corner)
{
    return model->vertices[model->triangles[corner / 3][corner % 3]].position;
}

static void triangle_area(const struct model *model, uint32_t triangle, double area[3])
{
    double edge[2][3];
    const double *a = position_of(model, 3 * triangle);
    const double *b = position_of(model, 3 * triangle + 1);
    const double *c = position_of(model, 3 * triangle + 2);
    for (int i = 0; i < 3; i++) {
        edge[0][i] = b[i] - a[i];
        edge[1][i] = c[i] - a[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        area[i] = edge[0][j] * edge[1][k] - edge[0][k] * edge[1][j];
    }
}

static void corners_make(struct corners *corners, const struct model *model)
{
    size_t count = 3 * model->triangle_count;
    uint32_t *place_of = xcalloc(model->vertex_count, sizeof *place_of);
    memset(corners, 0, sizeof *corners);
    corners->position = xcalloc(count, sizeof *corners->position);
    corners->first = xcalloc(model->vertex_count + 2, sizeof *corners->first);
    corners->list = xcalloc(count, sizeof *corners->list);
    corners->area = xcalloc(model->triangle_count, sizeof *corners->area);
    if (model->vertex_count > 0) {
        corners->places =
            unique_numbers(model->vertices[0].position, model->vertex_count,
                           sizeof *model->vertices, sizeof model->vertices->position, place_of);
    }
    for (uint32_t i = 0; i < count; i++) {
        corners->position[i] = place_of[model->triangles[i / 3][i % 3]];
        corners->first[corners->position[i] + 1]++;
    }
    for (size_t i = 0; i < corners->places; i++) {
        corners->first[i + 1] += corners->first[i];
    }
    /* Backwards, so that first[] ends up where each place begins. */
    for (uint32_t i = (uint32_t)count; i-- > 0;) {
        corners->list[--corners->first[corners->position[i] + 1]] = i;
    }
    memmove(corners->first, corners->first + 1, corners->places * sizeof *corners->first);
    corners->first[corners->places] = (uint32_t)count;
    for (uint32_t i = 0; i < model->triangle_count; i++) {
        triangle_area(model, i, corners->area[i]);
    }
    free(place_of);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Scales to length 1; a zero vector stays. */
static void normalise(double vector[3])
{
    double length = sqrt(dot(vector, vector));
    for (int axis = 0; axis < 3 && length > 0.0; axis++) {
        vector[axis] = vector[axis] / length + 0.0;
    }
}

/* The sum of areas of the faces at a corner that are within the angle of its own. */
static void smooth_corner(const struct corners *corners, uint32_t corner, double least_cosine,
                          double normal[3])
{
    const double *own = corners->area[corner / 3];
    uint32_t place = corners->position[corner];
    uint32_t begin = corners->first[place], end = corners->first[place + 1];
    bool all = end - begin > MOST_COMPARED;
    memset(normal, 0, 3 * sizeof *normal);
    for (uint32_t i = begin; i < end; i++) {
        const double *area = corners->area[corners->list[i] / 3];
        double lengths = sqrt(dot(own, own) * dot(area, area));
        if (all || dot(own, area) >= least_cosine * lengths) {
            for (int axis = 0; axis < 3; axis++) {
                normal[axis] += area[axis];
            }
        }
    }
    normalise(normal);
    if (dot(normal, normal) == 0.0) { /* faces that cancel */
        memcpy(normal, own, 3 * sizeof *normal);
        normalise(normal);
    }
}

/* Where very many corners meet, they have one sum: the time stays that of a list. */
static void smooth_place(const struct corners *corners, uint32_t place, double least_cosine,
                         struct model_vertex *split)
{
    uint32_t begin = corners->first[place], end = corners->first[place + 1];
    double shared[3];
    bool all = end - begin > MOST_COMPARED;
    if (all) {
        smooth_corner(corners, corners->list[begin], least_cosine, shared);
    }
    for (uint32_t i = begin; i < end; i++) {
        uint32_t corner = corners->list[i];
        if (all) {
            memcpy(split[corner].normal, shared, sizeof shared);
        } else {
            smooth_corner(corners, corner, least_cosine, split[corner].normal);
        }
    }
}

static bool has_normal(const struct model_vertex *vertex)
{
    return dot(vertex->normal, vertex->normal) > 0.0;
}

static void fill(const struct model *model, const struct corners *corners, double least_cosine,
                 bool keep, struct model_vertex *split)
{
    for (uint32_t place = 0; place < corners->places; place++) {
        smooth_place(corners, place, least_cosine, split);
    }
    for (uint32_t i = 0; keep && i < 3 * model->triangle_count; i++) {
        const struct model_vertex *own = &model->vertices[model->triangles[i / 3][i % 3]];
        if (has_normal(own)) {
            memcpy(split[i].normal, own->normal, sizeof own->normal);
        }
    }
}

void model_make_normals(struct model *model, enum model_normals normals, double degrees)
{
    struct corners corners;
    size_t count = 3 * model->triangle_count;
    struct model_vertex *split = xcalloc(count, sizeof *split);
    corners_make(&corners, model);
    for (uint32_t i = 0; i < count; i++) {
        split[i] = model->vertices[model->triangles[i / 3][i % 3]];
        memset(split[i].normal, 0, sizeof split[i].normal);
        if (normals == MODEL_NORMALS_FLAT) {
            memcpy(split[i].normal, corners.area[i / 3], sizeof split[i].normal);
            normalise(split[i].normal);
        }
    }
    if (normals == MODEL_NORMALS_KEEP || normals == MODEL_NORMALS_SMOOTH) {
        bool keep = normals == MODEL_NORMALS_KEEP;
        const double most = keep ? MODEL_CREASE_DEGREES : degrees;
        fill(model, &corners, cos(most * PI / 180.0) - 1e-9, keep, split);
    }
    for (uint32_t i = 0; i < count; i++) {
        model->triangles[i / 3][i % 3] = i;
    }
    free(model->vertices);
    model->vertices = split;
    model->vertex_count = count;
    corners_free(&corners);
}
