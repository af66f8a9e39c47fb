/* SPDX-License-Identifier: MIT */
/*
 * How draw calls feed a pipeline. Internal.
 *
 * Reached through the pipelines of a view, so that a program whose views have none does not link
 * it.
 */
#ifndef QTRI_DRAW_PIPELINE_OPS_H
#define QTRI_DRAW_PIPELINE_OPS_H

#include "../raster/draw_state.h"
#include "mesh_faces.h"

struct qtri_pipeline_ops {
    /* Where the view's pipelines can draw what is asked for, ops become those of the primitive. */
    void (*begin)(qtri_primitive *primitive, const qtri_view *view, int shade);
    void (*begin_mesh)(qtri_mesh_job *draw, const qtri_view *view);
    /* A triangle of the mesh that is not culled, inside all planes. */
    void (*triangle)(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a, qtri_vertex *b,
                     qtri_vertex *c);
    /* All of a mesh whose back faces are culled, all vertices inside; those of a list; of a band.
     */
    void (*whole)(const qtri_mesh_job *draw);
    void (*listed)(const qtri_mesh_faces *faces, const qtri_mesh_job *draw);
    void (*band)(const qtri_mesh_job *draw, const uint16_t *lists, uint32_t place, uint32_t end);
    /* A piece of a clipped triangle; false: its snap residuals are asked for. */
    bool (*piece)(const qtri_primitive *primitive, const qtri_fan_vertex *const vertex[3],
                  int64_t area, bool with_rests, qtri_attribute_source source, const void *from);
    /* The vertices that the next clipped triangle is of, for alpha. */
    void (*note)(qtri_primitive *primitive, const uint32_t index[3]);
};

extern const struct qtri_pipeline_ops qtri_pipeline_ops;

/* The ops of the view's pipelines; NULL: there are none. */
static inline const struct qtri_pipeline_ops *qtri_pipeline_ops_of(const qtri_view *view)
{
    const qtri_pipeline *const *list = view->pipelines;
    return list != NULL && list[0] != NULL ? list[0]->ops : NULL;
}

#endif
