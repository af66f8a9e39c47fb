/* SPDX-License-Identifier: MIT */
#include "scene_cost.h"

#include <math.h>

/*
 * Instructions = a pixels + b triangles + c sqrt(pixels triangles), the latter being about how many
 * rows all triangles have. Fitted so that the largest relative error over the benchmark's scenes of
 * the kind (tests/test_tools_view.c has them) is as small as it can be. Large triangles, of more
 * than 1000 pixels, are a kind of their own: what a pixel costs there depends on how perspective
 * runs along the rows, so that textured ones differ by a factor of three.
 */
struct model {
    double pixel, triangle, root;
};

static const struct {
    struct model m0plus, m3;
    int error;
} models[2][4] = {
    {
        [SCENE_KIND_FLAT] = {{8.5, 0, 372}, {8.5, 0, 170}, 25},
        [SCENE_KIND_SMOOTH] = {{48.8, 323, 0}, {31.4, 141, 0}, 30},
        [SCENE_KIND_TEXTURED] = {{117.7, 220, 0}, {68.3, 135, 0}, 45},
        [SCENE_KIND_LINES] = {{100.3, 369, 0}, {49.4, 158, 0}, 10},
    },
    {
        [SCENE_KIND_FLAT] = {{8.6, 0, 0}, {8.4, 0, 0}, 10},
        [SCENE_KIND_SMOOTH] = {{16.7, 0, 0}, {12.4, 0, 0}, 10},
        [SCENE_KIND_TEXTURED] = {{40, 0, 0}, {24, 0, 0}, 60},
        [SCENE_KIND_LINES] = {{100.3, 369, 0}, {49.4, 158, 0}, 10},
    },
};

/* S0 of the benchmark: colour and depth of 76,800 pixels. */
enum { CLEAR = 29280, CLEARED = 76800, LARGE = 1000 };

static double instructions(const struct model *model, double triangles, double pixels)
{
    return model->pixel * pixels + model->triangle * triangles +
           model->root * sqrt(pixels * triangles);
}

struct scene_cost scene_cost(enum scene_kind kind, double triangles, double pixels, double screen)
{
    const int is_large = pixels > LARGE * triangles;
    const double clear = CLEAR * screen / CLEARED;
    const struct scene_cost cost = {
        instructions(&models[is_large][kind].m0plus, triangles, pixels) + clear,
        instructions(&models[is_large][kind].m3, triangles, pixels) + clear,
        models[is_large][kind].error,
    };
    return cost;
}

bool scene_kind(const struct scene *scene, enum scene_kind *kind)
{
    bool is_known = !scene->lamps_on && scene->blend == SCENE_BLEND_OFF &&
                    scene->fog.kind == SCENE_FOG_OFF && !scene->texture_bilinear &&
                    scene->antialias == SCENE_ANTIALIAS_OFF && !scene->hidden_lines &&
                    !scene->smooth_lines && !scene->wide_lines &&
                    scene->depth_format == SCENE_LINEAR16 && scene->triangle_count > 0;
    for (size_t i = 0; i < scene->op_count; i++) {
        is_known =
            is_known && scene->ops[i].kind != SCENE_STROKE && scene->ops[i].kind != SCENE_PAINT;
    }
    *kind = scene->wireframe           ? SCENE_KIND_LINES
            : scene->texture.width > 0 ? SCENE_KIND_TEXTURED
            : scene->flat              ? SCENE_KIND_FLAT
                                       : SCENE_KIND_SMOOTH;
    return is_known;
}
