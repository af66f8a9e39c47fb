/* SPDX-License-Identifier: MIT */
/*
 * Scenes that every emulated board and the host draw, to compare their pixels bit for bit.
 *
 * Each is a function of the surface alone: called for a whole frame or once for each of its bands.
 * Nothing here but qtri.h and <stdint.h>, so that it compiles wherever the core does.
 */
#ifndef QTRI_BOARD_SCENES_H
#define QTRI_BOARD_SCENES_H

#include <stdint.h>

#include "qtri.h"

#define BOARD_SCENE_COUNT    6
#define BOARD_SCENE_SIDE_MAX 256 /* widest and highest frame, pixels */

#define BOARD_TORUS_RINGS    24
#define BOARD_TORUS_SIDES    12
#define BOARD_TORUS_VERTICES (BOARD_TORUS_RINGS * BOARD_TORUS_SIDES)
#define BOARD_TEXTURE_LOG2   5 /* 32 x 32 texels */

/* What the scenes need besides the surface: 18 KB, the caller's. */
typedef struct board_scene_memory {
    qtri_vec3 positions[BOARD_TORUS_VERTICES];
    qtri_normal normals[BOARD_TORUS_VERTICES];
    uint16_t triangles[2 * BOARD_TORUS_VERTICES][3];
    uint16_t texels[1 << (2 * BOARD_TEXTURE_LOG2)];
    qtri_vertex vertices[BOARD_TORUS_VERTICES];
} board_scene_memory;

typedef struct board_scene {
    const char *name;
    int32_t width, height;
    qtri_rgb background;
    void (*draw)(const qtri_surface *surface, board_scene_memory *memory);
} board_scene;

extern const board_scene board_scenes[BOARD_SCENE_COUNT];

/* Builds the torus and the texture; once, before the first draw. */
void board_scenes_prepare(board_scene_memory *memory);

/* The torus, in memory that has been prepared. */
qtri_mesh board_torus(const board_scene_memory *memory);

#endif
