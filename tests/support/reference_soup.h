/* SPDX-License-Identifier: MIT */
/*
 * Scenes built by hand for the tests of the double-precision reference: triangles in clip space,
 * with numbers no scene file could hold.
 */
#ifndef QTRI_TESTS_REFERENCE_SOUP_H
#define QTRI_TESTS_REFERENCE_SOUP_H

#include <stdint.h>

#include "io/scene.h"
#include "reference/reference.h"

enum { SOUP_TRIANGLES = 4096 };

struct soup {
    struct scene scene;
    struct scene_op ops[SOUP_TRIANGLES];
};

extern struct soup soup; /* one a program, too large for the stack */

/* An empty scene: depth off, nothing culled. */
void soup_begin(int width, int height);

void soup_add(const struct scene_vertex *a, const struct scene_vertex *b,
              const struct scene_vertex *c);

struct reference_image soup_render(int bits);

/* The white clip-space vertex that lands on window coordinates (x, y). */
struct scene_vertex window_vertex(double x, double y, double z, double w);

struct scene_vertex random_color(struct scene_vertex v, uint32_t *seed);

#endif
