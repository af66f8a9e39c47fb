/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <stdlib.h>
#include <string.h>

#ifndef QTRI_HAVE_MESHOPTIMIZER

bool model_can_simplify(void)
{
    return false;
}

void model_simplify(struct model *model, size_t triangles, double *distance)
{
    (void)model;
    (void)triangles;
    *distance = 0.0;
}

#else

#include <float.h>
#include <meshoptimizer.h>

#include "../io/xalloc.h"

bool model_can_simplify(void)
{
    return true;
}

/* Positions as the library wants them, within +-1 so that no product leaves a float's range. */
static void copy_positions(const struct model *model, float *positions)
{
    struct model_box box = model_bounds(model);
    double size = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        double side = box.high[axis] - box.low[axis];
        size = side > size ? side : size;
    }
    for (size_t i = 0; i < model->vertex_count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            double at = model->vertices[i].position[axis] - box.low[axis];
            positions[3 * i + (size_t)axis] = (float)(size > 0.0 ? at / size : 0.0);
        }
    }
}

void model_simplify(struct model *model, size_t triangles, double *distance)
{
    size_t count = 3 * model->triangle_count;
    *distance = 0.0;
    if (triangles >= model->triangle_count) {
        return;
    }
    float *positions = xcalloc(3 * model->vertex_count, sizeof *positions);
    unsigned int *indices = xcalloc(count, sizeof *indices);
    float error = 0.0F;
    copy_positions(model, positions);
    for (size_t i = 0; i < count; i++) {
        indices[i] = model->triangles[i / 3][i % 3];
    }
    size_t left = meshopt_simplify(indices, indices, count, positions, model->vertex_count,
                                   3 * sizeof *positions, 3 * triangles, FLT_MAX, 0, &error);
    for (size_t i = 0; i < left; i++) {
        model->triangles[i / 3][i % 3] = indices[i];
    }
    model->triangle_count = left / 3;
    *distance = (double)error;
    free(positions);
    free(indices);
    model_weld(model);
}

#endif
