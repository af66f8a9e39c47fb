/* SPDX-License-Identifier: MIT */
/*
 * What the benchmark draws: meshes, quads, texture, light and camera, for scenes and matrix.
 *
 * Camera (0,0,3) looking at the origin, vertical field of view 60 degrees, 4/3, near .1, far 100.
 * Freestanding: nothing but the public headers.
 */
#ifndef BENCH_WORLD_H
#define BENCH_WORLD_H

#include <stdbool.h>
#include <stdint.h>

#include "qtri.h"
#include "qtri/pipeline.h"

/* Of the largest mesh. */
#define BENCH_VERTICES_MAX  4096
#define BENCH_TRIANGLES_MAX 6400

/* Written by bench_meshes.c. A model that is not there has no triangles. spot_uv has texture
   coordinates, and more vertices for it; wall is a grid of 16 x 8 cells with coordinates; a torus
   has the number of triangles in its name, and coordinates. */
extern const qtri_mesh bench_mesh_spot, bench_mesh_spot_uv, bench_mesh_teapot, bench_mesh_knot,
    bench_mesh_knot_uv;
extern const qtri_mesh bench_mesh_spot_compact, bench_mesh_spot_uv_compact,
    bench_mesh_teapot_compact, bench_mesh_knot_compact, bench_mesh_knot_uv_compact,
    bench_mesh_wall_compact;
extern const qtri_mesh bench_mesh_torus96_compact, bench_mesh_torus216_compact,
    bench_mesh_torus384_compact, bench_mesh_torus864_compact;

extern const qtri_mesh bench_cube; /* 12 triangles, half size .15 */
extern const qtri_mesh bench_box;  /* half size .5: 90 pixels */
extern const qtri_rgb bench_box_colors[8];
extern const qtri_mesh bench_turned_away; /* a triangle that faces away */

/* A colour for each vertex. */
extern const qtri_rgb bench_colors_spot[], bench_colors_spot_uv[], bench_colors_wall[],
    bench_colors_knot[];

/* Corners (-,-) (+,-) (+,+) (-,+), texture coordinates (0,n) (n,n) (n,0) (0,0). */
typedef struct bench_quad {
    qtri_vec3 position[4];
    q16 repeats; /* n */
} bench_quad;

extern const bench_quad bench_screen; /* over the whole screen, facing the camera */
extern const bench_quad bench_floor;  /* half size 3.0 x 2.4, turned -60 degrees about x */
extern const bench_quad bench_turned; /* half size 2.2 x 1.5, turned 60 degrees about y */

extern const qtri_light bench_light;
extern const qtri_rgb bench_background;
extern const qtri_rgb bench_lit_color; /* of meshes, before light */

#define BENCH_TEXTURE_LOG2 6
#define BENCH_TEXTURE_SIDE (1 << BENCH_TEXTURE_LOG2)
/* And of its levels, down to 2 x 2. */
#define BENCH_CHAIN_TEXELS ((4 * BENCH_TEXTURE_SIDE * BENCH_TEXTURE_SIDE - 4) / 3)

/* The texture's colour, and the one nearest to a colour that RGB565 has. */
qtri_rgb bench_texel(uint32_t u, uint32_t v);
uint16_t bench_rgb565(qtri_rgb color);

/* Triangles (0,1,2) and (0,2,3) of the quad, a colour for each of its corners. */
void bench_set_quad(qtri_corner corners[6], const bench_quad *quad, const qtri_rgb colors[4]);

/* Of colour and depth as they lie in the memory of a little-endian machine (FNV-1a). */
uint32_t bench_hash(const qtri_surface *surface);

/* The camera, for a frame of this size. */

void bench_set_view(qtri_view *view, int32_t width, int32_t height);

#endif
