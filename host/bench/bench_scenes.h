/* SPDX-License-Identifier: MIT */
/*
 * The benchmark scenes: the same work on boards and on the host, and for every renderer.
 *
 * 320x240, RGB565 and 16-bit depth, whole frame. Freestanding.
 */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include <stdbool.h>
#include <stdint.h>

#include "bench_world.h"
#include "qtri.h"

#define BENCH_WIDTH       320
#define BENCH_HEIGHT      240
#define BENCH_CORNERS_MAX (3 * BENCH_TRIANGLES_MAX)

typedef enum bench_work {
    BENCH_CLEAR,  /* colour and depth */
    BENCH_QUAD,   /* two triangles */
    BENCH_MESH,   /* lit */
    BENCH_CORNERS /* the triangles of a wide mesh without indices or light, each with corners of its
                     own */
} bench_work;

typedef struct bench_scene {
    const char *name;
    bench_work work;
    qtri_shading shading;
    qtri_interpolation interpolation;
    bool wireframe, without_depth;
    bool textured; /* REPLACE on quads, MODULATE on meshes */
    const bench_quad *quad;
    const qtri_mesh *mesh;
    const qtri_rgb *colors; /* of the quad's corners; of the mesh's vertices, or NULL: one colour */
    q16 turn;               /* the mesh, about y */
    int32_t band_rows;      /* not 0: prepared, then drawn in bands of so many rows */
} bench_scene;

extern const bench_scene bench_scenes[]; /* a null name ends it */

/* All that drawing a scene needs. */
typedef struct bench_frame {
    const bench_scene *scene;
    qtri_surface surface;
    qtri_view view;
    qtri_transform pose;
    qtri_material material;
    qtri_texture texture;
    qtri_mesh mesh; /* with the scene's colours */
    qtri_corner corners[BENCH_CORNERS_MAX];
    uint32_t
        memory[QTRI_BAND_BYTES(BENCH_WIDTH, BENCH_HEIGHT, QTRI_RGB565_BYTES) / sizeof(uint32_t)];
    qtri_vertex vertices[QTRI_MESH_VERTICES(BENCH_VERTICES_MAX)];
    uint16_t texels[BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE];
#ifndef BENCH_PLAIN
    qtri_frame bands;
    qtri_prepared prepared;
    uint16_t lists[QTRI_PREPARED_LISTS(BENCH_TRIANGLES_MAX, BENCH_HEIGHT, 16)];
#endif
} bench_frame;

/* Camera, pose, material, and a frame of the background's colour. False: the model is not there. */
bool bench_prepare(bench_frame *frame, const bench_scene *scene);

/* What is measured: the draw calls, without the clear; the clear for BENCH_CLEAR. */
void bench_draw(bench_frame *frame);

/* Triangles that the draw call is given. */
uint32_t bench_triangles(const bench_scene *scene);

/* Whether the pixel is not of the background's colour and depth. */
bool bench_is_drawn(const bench_frame *frame, int32_t x, int32_t y);

#endif
