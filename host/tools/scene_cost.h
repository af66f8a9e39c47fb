/* SPDX-License-Identifier: MIT */
/*
 * About how many instructions a microcontroller takes to draw a frame: a model fitted to what
 * `make bench` counts on emulated cores.
 */
#ifndef QTRI_HOST_TOOLS_SCENE_COST_H
#define QTRI_HOST_TOOLS_SCENE_COST_H

#include <stdbool.h>
#include <stdint.h>

#include "../io/scene.h"

enum scene_kind { SCENE_KIND_FLAT, SCENE_KIND_SMOOTH, SCENE_KIND_TEXTURED, SCENE_KIND_LINES };
enum scene_pixels { SCENE_RGB565, SCENE_XRGB8888, SCENE_GRAY8 };

/* What is drawn, by the default pipelines. */
struct scene_load {
    enum scene_kind kind;
    enum scene_pixels format;
    enum scene_depth_format depth;
    bool is_blended; /* by alpha; not lines */
    int rows;        /* of a band, in which prepared meshes are drawn; 0: one band, without */
    double triangles, pixels; /* pixels: covered */
    double screen;            /* pixels that are cleared before */
};

struct scene_cost {
    double m0plus, m3; /* instructions */
    int error;         /* percent: nothing that was counted is further off */
};

struct scene_cost scene_cost(const struct scene_load *load);

/*
 * Sets the kind, the depth and the blending of a pass of a scene. False: none that the model knows,
 * as it has lamps, other blends, fog, filters, anti-aliasing, strokes or flat shapes.
 */
bool scene_load_pass(struct scene_load *load, const struct scene *pass);

#endif
