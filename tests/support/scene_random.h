/* SPDX-License-Identifier: MIT */
/*
 * Random scene files: every statement of the language, geometry that hurts.
 */
#ifndef QTRI_TESTS_SCENE_RANDOM_H
#define QTRI_TESTS_SCENE_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/*
 * The scene of `seed` as text, to be freed. Kinds of geometry: free triangles, fans and grids with
 * shared edges, slivers, triangles through every clip plane and around the eye, w <= 0 in clip
 * space. Kinds of view: clip space itself, perspective, frustum, ortho, loaded matrices.
 */
char *scene_random(uint32_t seed, size_t *length);

/* Another scene, textured: wrap modes, filters, texel formats and colour keys. */
char *scene_random_textured(uint32_t seed, size_t *length);

#endif
