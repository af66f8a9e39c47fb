/* SPDX-License-Identifier: MIT */
/*
 * Light sources of a view in draw calls of meshes: the functions of light->model. Internal.
 *
 * Nothing else refers to them, so that the linker drops them where no sources are set.
 */
#ifndef QTRI_DRAW_LIGHTS_H
#define QTRI_DRAW_LIGHTS_H

#include "../bits/bits.h"
#include "../geometry/illumination.h"
#include "mesh_job.h"

struct qtri_light_model {
    /* Sets shaded_per_vertex of a job that has its memory, and lit_colors if there is room. */
    void (*begin)(qtri_mesh_job *draw);
    /*
     * Sets draw->illumination up, on the stack, and calls `body`. `fresh`: colours that were lit
     * before are discarded.
     */
    void (*mesh)(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose, bool fresh,
                 qtri_lit_body body, void *with);
    /* Whether lit_colors has all that front sides need; with `both_sides`, all that is drawn. */
    bool (*keeps_colors)(const qtri_mesh_job *draw, bool both_sides);
    /* Lights the vertices with indices vertices[0..count-1].index, if there are lit_colors. */
    void (*list)(const qtri_mesh_job *draw, uint32_t count);
    /* Lights the vertices of a triangle, if there are lit_colors. */
    void (*light_triangle)(const qtri_mesh_job *draw, const uint32_t index[3]);
    /* As qtri_small.light: sets the vertices' colours in the draw state. */
    uint32_t (*find)(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                     qtri_vertex *c);
    /* For a large triangle: as `find`, or by pixel sets the light up at its corners. */
    uint32_t (*find_large)(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                           qtri_vertex *c);
    /* Colours, as qtri_lit_rgb() takes them, of a triangle's vertices, all inside all planes. */
    void (*shade)(const qtri_mesh_job *draw, const uint32_t index[3], const qtri_vertex *a,
                  const qtri_vertex *b, const qtri_vertex *c, uint32_t lit[3]);
    /* Colours of a triangle that may cross planes; by pixel the light at its corners, too. */
    void (*shade_clipped)(const qtri_mesh_job *draw, const void *indices,
                          const qtri_clip_vertex v[3], uint32_t lit[3]);
};

/* Whether a triangle that may cross planes shows its back. */
bool qtri_clipped_is_back(const qtri_clip_vertex v[3]);

/* A third, rounded down: three of them sum up to an int32_t. */
static inline int32_t qtri_third(int32_t x)
{
    return (int32_t)(qtri_mul_s32(x, 0x55555554) >> 32);
}

/* The mean of three positions. */
static inline qtri_vec3 qtri_mean(const qtri_vec3 p[3])
{
    const qtri_vec3 mean = {qtri_third(p[0].x) + qtri_third(p[1].x) + qtri_third(p[2].x),
                            qtri_third(p[0].y) + qtri_third(p[1].y) + qtri_third(p[2].y),
                            qtri_third(p[0].z) + qtri_third(p[1].z) + qtri_third(p[2].z)};
    return mean;
}

#endif
