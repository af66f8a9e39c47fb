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

struct scene_cost {
    double m0plus, m3; /* instructions, the clear included */
    int error;         /* percent: no benchmark of the kind is further off */
};

/* pixels: covered; screen: of the whole frame. */
struct scene_cost scene_cost(enum scene_kind kind, double triangles, double pixels, double screen);

/*
 * Which kind a scene is. False: none that the model knows, as it has lamps, blends, fog, filters,
 * anti-aliasing, strokes or flat shapes, whose costs differ.
 */
bool scene_kind(const struct scene *scene, enum scene_kind *kind);

#endif
