/* SPDX-License-Identifier: MIT */
/*
 * What draw calls of meshes do with the lights of a view: lights->model. Internal.
 *
 * Nothing else names these functions: where no lights are set, nothing of them is linked.
 */
#ifndef QTRI_DRAW_LIGHTS_H
#define QTRI_DRAW_LIGHTS_H

#include "../bits/bits.h"
#include "../geometry/illumination.h"
#include "mesh_job.h"

struct qtri_light_model {
    /* For a job that has memory: its colours come from the lights, and have a place in it. */
    void (*begin)(qtri_mesh_job *draw);
    /*
     * Calls `body` while draw->illumination is there: on the stack. `fresh`: nothing of what was
     * lit before counts.
     */
    void (*mesh)(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose, bool fresh,
                 qtri_lit_body body, void *with);
    /* Whether the colours of fronts have a place, to be found there later; of all that is drawn. */
    bool (*has_place)(const qtri_mesh_job *draw, bool both_sides);
    /* Lights the vertices whose numbers are vertices[0..count-1].index, where they have a place. */
    void (*list)(const qtri_mesh_job *draw, uint32_t count);
    /* Lights the vertices of a triangle, where they have a place. */
    void (*light_triangle)(const qtri_mesh_job *draw, const void *indices);
    /* For pipelines, as qtri_small.light: colours of the vertices into the draw state. */
    uint32_t (*find)(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                     qtri_vertex *c);
    /* That of a large triangle: by pixel its corners, which light falls on. */
    uint32_t (*find_large)(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                           qtri_vertex *c);
    /* A triangle's colours; it is inside all planes. */
    void (*shade)(const qtri_mesh_job *draw, const uint32_t index[3], const qtri_vertex *a,
                  const qtri_vertex *b, const qtri_vertex *c, qtri_rgb color[3]);
    /* Those of a triangle that may cross planes; by pixel its corners as well. */
    void (*shade_clipped)(const qtri_mesh_job *draw, const void *indices,
                          const qtri_clip_vertex v[3], qtri_rgb color[3]);
};

/* Whether a triangle that may cross planes shows its back. */
bool qtri_clipped_is_back(const qtri_clip_vertex v[3]);

/* A third, rounded down; three of them fit. */
static inline int32_t qtri_third(int32_t x)
{
    return (int32_t)(qtri_mul_s32(x, 0x55555554) >> 32);
}

/* The mean of three places. */
static inline qtri_vec3 qtri_mean(const qtri_vec3 p[3])
{
    const qtri_vec3 mean = {qtri_third(p[0].x) + qtri_third(p[1].x) + qtri_third(p[2].x),
                            qtri_third(p[0].y) + qtri_third(p[1].y) + qtri_third(p[2].y),
                            qtri_third(p[0].z) + qtri_third(p[1].z) + qtri_third(p[2].z)};
    return mean;
}

#endif
