/*
 * The benchmark scenes: the same work on boards and on the host, and for every renderer.
 *
 * 320x240, RGB565 and 16-bit depth, whole frame. Camera (0,0,3) looking at the origin, vertical
 * field of view 60 degrees, 4/3, near .1, far 100. Freestanding: nothing but the public headers.
 */
#ifndef BENCH_SCENES_H
#define BENCH_SCENES_H

#include <stdbool.h>
#include <stdint.h>

#include "qtri.h"

#define BENCH_WIDTH         320
#define BENCH_HEIGHT        240
#define BENCH_VERTICES_MAX  4096 /* of the largest mesh */
#define BENCH_TRIANGLES_MAX 6400

/* Written by bench_meshes.c. A model that is not there has no triangles. */
extern const qtri_mesh bench_mesh_spot, bench_mesh_teapot, bench_mesh_knot;
extern const qtri_mesh bench_mesh_spot_compact, bench_mesh_teapot_compact, bench_mesh_knot_compact;

typedef enum bench_work {
    BENCH_CLEAR,  /* colour and depth */
    BENCH_SCREEN, /* a quad over the whole screen */
    BENCH_FLOOR,  /* a textured quad, turned -60 degrees about x */
    BENCH_MESH    /* lit */
} bench_work;

typedef struct bench_scene {
    const char *name;
    bench_work work;
    qtri_shading shading;
    qtri_interpolation interpolation;
    const qtri_fill *fill;
    const qtri_mesh *mesh;
    q16 turn;          /* the mesh, about y */
    int32_t band_rows; /* not 0: prepared, then drawn in bands of so many rows */
} bench_scene;

extern const bench_scene bench_scenes[]; /* a null name ends it */

/* All that drawing a scene needs. */
typedef struct bench_frame {
    const bench_scene *scene;
    qtri_surface surface;
    qtri_view view;
    qtri_light light;
    qtri_transform pose;
    qtri_material material;
    qtri_texture texture;
    qtri_corner corners[6];
    uint32_t
        memory[QTRI_BAND_BYTES(BENCH_WIDTH, BENCH_HEIGHT, QTRI_RGB565_BYTES) / sizeof(uint32_t)];
    qtri_vertex vertices[QTRI_MESH_VERTICES(BENCH_VERTICES_MAX)];
    uint16_t texels[64 * 64];
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

#endif
